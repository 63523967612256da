/*
# Labels and references (公式编号与文献)

A text can be checked against itself: whether a number that is cited is printed somewhere, whether the key of a reference
has the year of the reference, whether the volumes of a journal go up by one a year.  The tables below are what the source
prints, in the digital copy at hand: a label that stands twice, or a letter $l$ for the digit 1, may be a fault of this
copy and not of the book.
*/
#include <string.h>

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:formula-4.4.14-label
:title: The label of the coefficients of Marsden's identity
:zh: 公式编号 (4.4.14)
:printed: the label (4.4.13) stands at the identity and again at the definition of $\omega_{i,k}$, which is cited as (4.4.14)
:class: misprint
:refuted-by: cited_label_is_not_printed
:corrected: the definition of $\omega_{i,k}$ is (4.4.14)
:corrected-by: labels_run_from_one_to_twenty_three

The identity itself is printed twice.
:::
*/

#if RATIONAL
static const int labels[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 13, 15, 16, 17, 18, 19, 20, 21, 22, 23};
enum { LABELS = sizeof labels / sizeof labels[0] };

/*
:::{claim} labels_run_from_one_to_twenty_three
:title: With the label 14 put right the labels of 4.4 are 1 to 23, each once
:zh: 改正后公式编号各出现一次
:kind: decision
:given: the labels (4.4.1) to (4.4.23) as printed, in their order, the second 13 replaced by 14
:then: label number $n$ is $n$
:method: The labels are compared one by one.
:scope: section 4.4 of the source
:control: the labels as printed
:::
*/
CLAIM(labels_run_from_one_to_twenty_three)
{
    for (int n = 1; n <= LABELS; n++)
        same(T, from_int(fault(T, n == 14 ? 14 : labels[n - 1], labels[n - 1])), from_int(n));
}

/*
:::{claim} cited_label_is_not_printed
:title: No formula has the label that is cited
:zh: 所引编号 (4.4.14) 未印出
:kind: counterexample
:given: the labels of section 4.4 as printed; theorem 4.4.3 and 4.4.3 cite (4.4.14)
:then: 14 is not among them, 13 is there twice
:method: The label that is cited is looked up.
:control: the label 13
:::
*/
CLAIM(cited_label_is_not_printed)
{
    int wanted = fault(T, 13, 14), found = 0, thirteen = 0;
    for (int n = 0; n < LABELS; n++) {
        found |= equal_q(from_int(labels[n]), from_int(wanted));
        thirteen += labels[n] == 13;
    }
    show_text(T, "label looked up", "(4.4.%d)", wanted);
    show_text(T, "formulas with the label (4.4.13)", "%d", thirteen);
    about(T, "a formula has the label");
    agree(T, found);
}

/*
:::{statement} wang-ch4:literature-lw-lyd
:title: The source of the first two sections
:zh: 第 1、2 节取材文献的年份
:printed: sections 1 and 2 are taken from [WGJ, WGZ, 99] and [LW, LYD, 95]
:class: misprint
:refuted-by: cited_key_is_not_listed
:corrected: [LW, LYD, 90]: the list has a paper of Lü and Liang of 1990, and none of 1995
:corrected-by: cited_keys_are_listed
:::
*/

static const struct {
    const char *authors;
    int year;
} cited[] = {{"WGJ, WGZ", 99}, {"LW, LYD", 95}, {"WGJ", 92}, {"LLG, WGJ", 2000}},
  listed[] = {{"WGJ, WGZ", 99}, {"LW, LYD", 90}, {"WGJ", 92}, {"LLG, WGJ", 2000}};

/* 1 if the key is among the four of the list. */
static int is_listed(const char *authors, int year)
{
    for (int k = 0; k < 4; k++)
        if (strcmp(listed[k].authors, authors) == 0 && listed[k].year == year)
            return 1;
    return 0;
}

/*
:::{claim} cited_keys_are_listed
:title: With the year 90 every key that is cited is listed
:zh: 改正后所引文献均在列
:kind: decision
:given: the four keys that the introduction cites, the year 95 replaced by 90, and the four keys of the list
:then: every cited key is a key of the list
:method: All pairs are compared.
:scope: the four keys
:control: the year 95
:::
*/
CLAIM(cited_keys_are_listed)
{
    for (int k = 0; k < 4; k++)
        agree(T, is_listed(cited[k].authors, fault(T, k == 1 ? 90 : cited[k].year, cited[k].year)));
}

/*
:::{claim} cited_key_is_not_listed
:title: The key of the first two sections is not in the list
:zh: 文献表中无 [LW, LYD, 95]
:kind: counterexample
:given: the key [LW, LYD, 95] of the introduction
:then: the list has [WGJ, WGZ, 99], [LW, LYD, 90], [WGJ, 92] and [LLG, WGJ, 2000]
:method: The key is looked up.
:control: the key [LW, LYD, 90]
:::
*/
CLAIM(cited_key_is_not_listed)
{
    int year = fault(T, 90, cited[1].year);
    show_text(T, "key", "[%s, %d]", cited[1].authors, year);
    about(T, "the key is in the list");
    agree(T, is_listed(cited[1].authors, year));
}

/*
:::{statement} wang-ch4:literature-keys
:title: The keys of the main references
:zh: 主要文献的标号与年份
:printed: [WGJ, WGZ, 99] of 1999, [LW, LYD, 90] of 1990, [WGJ, 92] of 1992
:holds-by: keys_have_the_years_of_their_entries

[LLG, WGJ, 2000] has no year in its entry; it was submitted.
:::

:::{claim} keys_have_the_years_of_their_entries
:title: The years in the keys are those of the entries
:zh: 标号年份与条目年份一致
:kind: decision
:given: the keys 99, 90, 92 and the years 1999, 1990, 1992 of the entries
:then: the key is the year less 1900
:method: The three differences.
:scope: the three entries that have a year
:control: the key 95
:::
*/
CLAIM(keys_have_the_years_of_their_entries)
{
    static const int years[] = {1999, 1990, 1992};
    for (int k = 0; k < 3; k++)
        same(T, from_int(fault(T, listed[k].year, cited[k].year)), sub(from_int(years[k]), from_int(1900)));
}

/*
:::{statement} wang-ch4:references-cited
:title: The numbered references
:zh: 参考文献的引用
:printed: the references 1 to 19
:holds-by: numbered_references_are_all_cited

Every number that is cited is in the list, and every entry of the list is cited.  Reference 9 spells SIGGRAPH without its
P, and the journal of references 4, 7 and 8 calls itself IEEE Computer Graphics and Applications.
:::

:::{claim} numbered_references_are_all_cited
:title: The numbers cited are 1 to 19
:zh: 参考文献 1 至 19 均被引用
:kind: decision
:given: the citations of the chapter in their order: 1, 2, 3-7, 8-10, 11, 12, 13, 12, 14, 15, 16, 17, 12, 13, 18, 18, 14, 14,
  19, 15, 19
:then: each of 1, ..., 19 occurs, and no other number
:method: The numbers are ticked off.
:scope: the numbered references
:control: the citations of section 4.4 only
:::
*/
CLAIM(numbered_references_are_all_cited)
{
    static const int first[] = {1, 2, 3, 8, 11, 12, 13, 12, 14, 15, 16, 17, 12, 13, 18, 18, 14, 14, 19, 15, 19};
    static const int last[] = {1, 2, 7, 10, 11, 12, 13, 12, 14, 15, 16, 17, 12, 13, 18, 18, 14, 14, 19, 15, 19};
    int seen[32] = {0}, count = sizeof first / sizeof first[0];
    for (int k = fault(T, 0, count - 5); k < count; k++)
        for (int n = first[k]; n <= last[k]; n++)
            seen[n] = 1;
    for (int n = 0; n < 32; n++)
        same(T, from_int(seen[n]), from_int(n >= 1 && n <= 19));
}

/*
:::{statement} wang-ch4:references-volumes
:title: Years and volumes of Computer Aided Design
:zh: 期刊 CAD 的年份与卷号
:printed: 1991, 23; 1987, 19; 1989, 21; 1989, 21; 1992, 24; 1990, 22; 1992, 24
:holds-by: volumes_follow_the_years
:::
*/

/* Reference, journal (0: Computer Aided Design, 1: IEEE Computer Graphics and Applications), year, volume. */
static const int volumes[][4] = {{1, 0, 1991, 23},  {3, 0, 1987, 19},  {5, 0, 1989, 21},  {6, 0, 1989, 21},
                                 {10, 0, 1992, 24}, {12, 0, 1990, 22}, {13, 0, 1992, 24}, {4, 1, 1989, 9},
                                 {7, 1, 1991, 10},  {8, 1, 1983, 3}};
enum { VOLUMES = sizeof volumes / sizeof volumes[0], SURVEY = 8 };

/*
:::{claim} volumes_follow_the_years
:title: The volume is the year less a constant of the journal
:zh: 卷号等于年份减常数
:kind: decision
:given: the years and volumes of the ten references in Computer Aided Design and in IEEE Computer Graphics and
  Applications, with the volume 11 for reference 7
:then: the year less the volume is 1968 for the one, 1980 for the other journal
:method: The ten differences.
:scope: the ten references
:control: the volume 10 for reference 7
:::
*/
CLAIM(volumes_follow_the_years)
{
    for (int k = 0; k < VOLUMES; k++) {
        int volume = fault(T, k == SURVEY ? 11 : volumes[k][3], volumes[k][3]);
        same(T, sub(from_int(volumes[k][2]), from_int(volume)), from_int(volumes[k][1] == 0 ? 1968 : 1980));
    }
}

/*
:::{statement} wang-ch4:reference-7
:title: The volume of the survey on NURBS
:zh: 参考文献 7 的卷号
:printed: IEEE Computer Graphics and its Application, 1991, 10(1): 55-71
:class: misprint
:refuted-by: volume_of_the_survey_breaks_the_rule
:corrected: volume 11: the volume of this journal is the year less 1980, as for references 4 and 8
:corrected-by: volumes_follow_the_years
:::

:::{claim} volume_of_the_survey_breaks_the_rule
:title: Volume 10 is not the volume of 1991
:zh: 1991 年非第 10 卷
:kind: counterexample
:given: references 4, 7 and 8, of one journal: 1989, 9; 1991, 10; 1983, 3
:then: the year less the volume is 1980, 1981, 1980
:method: The differences are compared.
:control: the volume 11 for reference 7
:::
*/
CLAIM(volume_of_the_survey_breaks_the_rule)
{
    int volume = fault(T, 11, volumes[SURVEY][3]);
    num rule = sub(from_int(volumes[SURVEY - 1][2]), from_int(volumes[SURVEY - 1][3]));
    num here = sub(from_int(volumes[SURVEY][2]), from_int(volume));
    num after = sub(from_int(volumes[SURVEY + 1][2]), from_int(volumes[SURVEY + 1][3]));
    show_text(T, "year, volume of reference 4", "%d, %d", volumes[SURVEY - 1][2], volumes[SURVEY - 1][3]);
    show_text(T, "year, volume of reference 7", "%d, %d", volumes[SURVEY][2], volume);
    show_text(T, "year, volume of reference 8", "%d, %d", volumes[SURVEY + 1][2], volumes[SURVEY + 1][3]);
    about(T, "the year less the volume is the same");
    agree(T, equal_q(here, rule) && equal_q(after, rule));
}
#endif

#include "chapters/judge/claims_off.h"
