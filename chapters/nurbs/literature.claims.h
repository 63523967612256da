/*
# Labels and references (公式编号与文献)

A text can be checked against itself: whether a number that is cited is printed somewhere, whether the key of a
reference has the year of the reference, whether the volumes of a journal go up by one a year.  The data of the claims
are what the source prints, in the digital copy at hand: a label that stands twice, or a letter $l$ for the digit 1,
may be a fault of this copy and not of the book.
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
enum { LABELS = 23 }; /* of section 4.4 */

/*
:::{claim} labels_run_from_one_to_twenty_three
:title: With the label 14 put right the labels of section 4.4 are 1 to 23, each once
:zh: 改正后公式编号各出现一次
:kind: decision
:given: the labels of section 4.4 as printed, in their order, but for the second label 13, which is 14
:data: labels = 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23
:instead: labels = 1 2 3 4 5 6 7 8 9 10 11 12 13 13 15 16 17 18 19 20 21 22 23
:then: label number $n$ is $n$
:method: The labels are compared one by one.
:scope: section 4.4 of the source
:control: the labels as printed
:::
*/
CLAIM(labels_run_from_one_to_twenty_three)
{
    num labels[LABELS];
    given_points(T, "labels", LABELS, 1, labels);
    for (int n = 1; n <= LABELS; n++)
        same(T, labels[n - 1], from_int(n));
}

/*
:::{claim} cited_label_is_not_printed
:title: No formula has the label that is cited
:zh: 所引编号 (4.4.14) 未印出
:kind: counterexample
:given: the labels of the section as printed; the label that theorem 4.4.3 and subsection 4.4.3 cite
:data: labels = 1 2 3 4 5 6 7 8 9 10 11 12 13 13 15 16 17 18 19 20 21 22 23; cited label = 14
:instead: cited label = 13
:then: 14 is not among them, another label is there twice
:result: label that stands twice = 13; formulas with the label that is cited = 0
:method: The label that is cited is looked up.
:control: the label that stands twice
:::
*/
CLAIM(cited_label_is_not_printed)
{
    num labels[LABELS];
    given_points(T, "labels", LABELS, 1, labels);
    int cited = given_whole(T, "cited label"), formulas = 0, twice = 0;
    for (int n = 0; n < LABELS; n++) {
        formulas += equal_q(labels[n], from_int(cited));
        if (n > 0 && equal_q(labels[n], labels[n - 1]))
            twice = (int)to_double_q(labels[n]);
    }
    found_whole(T, "formulas with the label that is cited", formulas);
    found_whole(T, "label that stands twice", twice);
    about(T, "a formula has the label that is cited");
    agree(T, formulas > 0);
}

/*
:::{statement} wang-ch4:notation-4.4
:title: Indices of section 4.4
:zh: 4.4 节若干记号的下标
:printed: $\omega_{i\,\iota}(x)$ in the proof of theorem 4.4.2; the cofactors $g^*_\mu$ of $g_\mu$ in theorem 4.4.3; $\alpha_{ii}(T)$ in
  lemma 4.4.1; $l_a(T_i)>0$, $q=1,2,\dots,d(T_i)$, in theorem 4.4.1; $\mathbf A_{r,t,T}$ for equidistant knots
:class: misprint
:refuted-by: five_names_have_other_indices
:corrected: $\omega_{i,k}(x)$, $g^*_{\mu i}$ of $g_{\mu i}$, $\alpha_{ij}(T)$, $l_q(T_i)$, $\mathbf A_{r,k,T}$
:corrected-by: five_names_have_their_indices
:::
*/

enum { NAMES = 5 };

/* How many of the five names have the indices that they have elsewhere in the section. */
static int names_with_their_indices(trial *T)
{
    static const char *const name[NAMES] = {"ω", "g*", "α", "l", "A"};
    static const char *const indices[NAMES] = {"i,k", "μi", "ij", "q", "r,k,T"};
    int count = 0;
    for (int m = 0; m < NAMES; m++)
        count += strcmp(given_text(T, name[m]), indices[m]) == 0;
    return count;
}

/*
:::{claim} five_names_have_other_indices
:title: Five names have other indices than everywhere else
:zh: 五处记号的下标有误
:kind: counterexample
:given: the indices of five names, each in one place of section 4.4
:data: ω = "i,ι"; g* = "μ"; α = "ii"; l = "a"; A = "r,t,T"
:instead: ω = "i,k"; g* = "μi"; α = "ij"; l = "q"; A = "r,k,T"
:then: none of them are those of the definitions
:result: names with the indices of their definitions = 0
:method: Name by name.
:control: the five indices corrected
:::
*/
CLAIM(five_names_have_other_indices)
{
    int count = names_with_their_indices(T);
    found_whole(T, "names with the indices of their definitions", count);
    about(T, "some name has the indices of the other formulas");
    agree(T, count > 0);
}

/*
:::{claim} five_names_have_their_indices
:title: With the indices corrected the names are those of the definitions
:zh: 更正后记号一致
:kind: decision
:given: the indices of the five names, corrected
:data: ω = "i,k"; g* = "μi"; α = "ij"; l = "q"; A = "r,k,T"
:instead: ω = "i,ι"; g* = "μ"; α = "ii"; l = "a"; A = "r,t,T"
:then: each has the indices of its definition
:method: Name by name.
:scope: the five names
:control: the indices as printed
:::
*/
CLAIM(five_names_have_their_indices)
{
    about(T, "the indices are those of the other formulas");
    agree(T, names_with_their_indices(T) == NAMES);
}

/*
The keys of the main references contain a year.  One key is cited that the list does not have; with another year it
does.

:::{statement} wang-ch4:literature-lw-lyd
:title: The source of the first two sections
:zh: 第 1、2 节取材文献的年份
:printed: sections 1 and 2 are taken from [WGJ, WGZ, 99] and [LW, LYD, 95], section 3 from [WGJ, 92], section 4 from [LLG, WGJ, 2000]
:class: misprint
:refuted-by: cited_key_is_not_listed
:corrected: [LW, LYD, 90]: the list has a paper of Lü and Liang of 1990, and none of 1995
:corrected-by: cited_keys_are_listed
:::
*/

/* 1 if the key, which ends with the first bracket that closes, is among those of the list. */
static int is_listed(const char *key, const char *list)
{
    size_t length = strcspn(key, "]") + 1;
    for (const char *at = strchr(list, '['); at != NULL; at = strchr(at + 1, '['))
        if (strncmp(at, key, length) == 0)
            return 1;
    return 0;
}

/*
:::{claim} cited_keys_are_listed
:title: With the year 90 every key that is cited is listed
:zh: 改正后所引文献均在列
:kind: decision
:given: the four keys that the introduction cites, the year 95 replaced by 90, and the four keys of the list
:data: cited = "[WGJ, WGZ, 99]; [LW, LYD, 90]; [WGJ, 92]; [LLG, WGJ, 2000]"; listed = "[WGJ, WGZ, 99]; [LW, LYD, 90];
  [WGJ, 92]; [LLG, WGJ, 2000]"
:instead: cited = "[WGJ, WGZ, 99]; [LW, LYD, 95]; [WGJ, 92]; [LLG, WGJ, 2000]"
:then: every cited key is a key of the list
:method: The keys are looked up one by one.
:scope: the four keys
:control: the year 95
:::
*/
CLAIM(cited_keys_are_listed)
{
    const char *cited = given_text(T, "cited"), *listed = given_text(T, "listed");
    for (const char *key = strchr(cited, '['); key != NULL; key = strchr(key + 1, '['))
        agree(T, is_listed(key, listed));
}

/*
:::{claim} cited_key_is_not_listed
:title: The key of the first two sections is not in the list
:zh: 文献表中无 [LW, LYD, 95]
:kind: counterexample
:given: the key that the introduction cites, and the keys of the list
:data: cited = "[LW, LYD, 95]"; listed = "[WGJ, WGZ, 99]; [LW, LYD, 90]; [WGJ, 92]; [LLG, WGJ, 2000]"
:instead: cited = "[LW, LYD, 90]"
:then: the list has no such key
:result: the key is in the list = 0
:method: The key is looked up.
:control: the key with the year 90
:::
*/
CLAIM(cited_key_is_not_listed)
{
    const char *cited = given_text(T, "cited"), *listed = given_text(T, "listed");
    int found = is_listed(cited, listed);
    found_whole(T, "the key is in the list", found);
    about(T, "the key is in the list");
    agree(T, found);
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
:given: the years in the keys, the years of the entries, and a year $Y$
:data: keys = 99 90 92; entries = 1999 1990 1992; Y = 1900
:instead: keys = 99 95 92
:then: the year in the key is the year of the entry less $Y$
:method: The three differences.
:scope: the three entries that have a year
:control: the key of the misprint
:::
*/
CLAIM(keys_have_the_years_of_their_entries)
{
    enum { KEYS = 3 };
    num keys[KEYS], entries[KEYS];
    given_points(T, "keys", KEYS, 1, keys);
    given_points(T, "entries", KEYS, 1, entries);
    num year = given(T, "Y");
    for (int k = 0; k < KEYS; k++)
        same(T, keys[k], sub(entries[k], year));
}

/*
:::{statement} wang-ch4:references-cited
:title: The numbered references
:zh: 参考文献的引用
:printed: the references have the numbers 1 to 19 in the list, and the text cites them by these numbers
:holds-by: numbered_references_are_all_cited
:meant: the text, which cites Versprille as [2] | Versprille's thesis, which stands between 1 and 3 and whose number the text at hand has lost, is reference 2.

Every number that is cited is in the list, and every entry of the list is cited.  Reference 9 has SIGGRAH for SIGGRAPH, and the references 4, 7 and 8 have "its Application" in
the name of IEEE Computer Graphics and Applications.
:::

:::{claim} numbered_references_are_all_cited
:title: The numbers cited are 1 to 19
:zh: 参考文献 1 至 19 均被引用
:kind: decision
:given: the numbers of the list as printed, and the one that is lost between 1 and 3; the citations of the chapter in their order, from one number to another; the last ones
  are those of section 4.4
:data: citations = (1,1) (2,2) (3,7) (8,10) (11,11) (12,12) (13,13) (12,12) (14,14) (15,15) (16,16) (17,17) (12,12)
  (13,13) (18,18) (18,18) (14,14) (14,14) (19,19) (15,15) (19,19); last ones = 5; list = 1 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19; lost = 2
:then: the numbers of the list are $1,\dots,19$, each of them is cited, and no other number
:method: The numbers are ticked off.
:scope: the numbered references
:control: the citations of section 4.4 only
:::
*/
CLAIM(numbered_references_are_all_cited)
{
    enum { CITATIONS = 21, PRINTED = 18, MOST = 32 };
    num from_to[2 * CITATIONS], list[PRINTED];
    int seen[MOST] = {0};
    given_points(T, "citations", CITATIONS, 2, from_to);
    given_points(T, "list", PRINTED, 1, list);
    int last = given_whole(T, "last ones"), lost = given_whole(T, "lost");
    about(T, "the numbers of the list"); /* the lost one is put in behind the first */
    for (int n = 1; n <= PRINTED + 1; n++)
        same(T, n == 2 ? from_int(lost) : list[n == 1 ? 0 : n - 2], from_int(n));
    for (int k = fault(T, 0, CITATIONS - last); k < CITATIONS; k++)
        for (int n = 0; n < MOST; n++)
            seen[n] |= compare_q(from_to[2 * k], from_int(n)) <= 0 && compare_q(from_int(n), from_to[2 * k + 1]) <= 0;
    about(T, "the numbers that are cited");
    for (int n = 0; n < MOST; n++)
        same(T, from_int(seen[n]), from_int(n >= 1 && n <= PRINTED + 1));
}

/*
Journals number their volumes year by year, so year and volume differ by a constant.  One entry of the list breaks the
rule of its journal, and is wrong.

:::{statement} wang-ch4:references-volumes
:title: Years and volumes of Computer Aided Design
:zh: 期刊 CAD 的年份与卷号
:printed: in Computer Aided Design: 1991, 23; 1987, 19; 1989, 21; 1989, 21; 1992, 24; 1990, 22; 1992, 24
:holds-by: volumes_of_one_journal_follow_the_years

These are year and volume of the references 1, 3, 5, 6, 10, 12 and 13.  The journal has one volume a year, and so they agree with one another.
:::

:::{claim} volumes_of_one_journal_follow_the_years
:title: The volumes of Computer Aided Design are the year less a constant
:zh: 期刊 CAD 的卷号等于年份减常数
:kind: decision
:given: the years and volumes of the references in Computer Aided Design, as printed
:data: Computer Aided Design = (1991,23) (1987,19) (1989,21) (1989,21) (1992,24) (1990,22) (1992,24)
:instead: Computer Aided Design = (1991,23) (1987,19) (1989,21) (1989,21) (1992,24) (1990,22) (1992,23)
:then: the year less the volume is the same for all
:result: year less volume = 1968
:method: The seven differences.
:scope: the seven references in this journal
:control: another volume of the last
:::
*/
CLAIM(volumes_of_one_journal_follow_the_years)
{
    enum { REFERENCES = 7 };
    num issue[2 * REFERENCES];
    given_points(T, "Computer Aided Design", REFERENCES, 2, issue);
    num constant = sub(issue[0], issue[1]);
    for (int k = 0; k < REFERENCES; k++)
        same(T, sub(issue[2 * k], issue[2 * k + 1]), constant);
    found(T, "year less volume", constant);
}

/*
:::{claim} volumes_follow_the_years
:title: The volume is the year less a constant of the journal
:zh: 卷号等于年份减常数
:kind: decision
:given: the years and volumes of the references in Computer Aided Design and in IEEE Computer Graphics and
  Applications, with the volume 11 put right for the survey, which is the second of the latter
:data: Computer Aided Design = (1991,23) (1987,19) (1989,21) (1989,21) (1992,24) (1990,22) (1992,24); IEEE Computer
  Graphics and Applications = (1989,9) (1991,11) (1983,3)
:instead: IEEE Computer Graphics and Applications = (1989,9) (1991,10) (1983,3)
:then: the year less the volume is the same for all references of one journal
:result: year less volume = 1968 1980
:method: The ten differences.
:scope: the ten references
:control: the volume of the survey as printed
:::
*/
CLAIM(volumes_follow_the_years)
{
    enum { FIRST = 7, SECOND = 3 };
    num issue[2][2 * FIRST];
    given_points(T, "Computer Aided Design", FIRST, 2, issue[0]);
    given_points(T, "IEEE Computer Graphics and Applications", SECOND, 2, issue[1]);
    num constant[2];
    for (int j = 0; j < 2; j++) {
        constant[j] = sub(issue[j][0], issue[j][1]);
        for (int k = 0; k < (j == 0 ? FIRST : SECOND); k++)
            same(T, sub(issue[j][2 * k], issue[j][2 * k + 1]), constant[j]);
    }
    found_points(T, "year less volume", 2, 1, constant);
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

The journal is IEEE Computer Graphics and Applications, see `references-cited`.
:::

:::{claim} volume_of_the_survey_breaks_the_rule
:title: Volume 10 is not the volume of 1991
:zh: 1991 年非第 10 卷
:kind: counterexample
:given: year and volume of three references of one journal; the second is the survey
:data: reference 4 = (1989,9); reference 7 = (1991,10); reference 8 = (1983,3)
:instead: reference 7 = (1991,11)
:then: the year less the volume is another for the survey than for the two others
:result: year less volume = 1980 1981 1980
:method: The differences are compared.
:control: the next volume
:::
*/
CLAIM(volume_of_the_survey_breaks_the_rule)
{
    static const char *const names[] = {"reference 4", "reference 7", "reference 8"};
    num constant[3];
    for (int k = 0; k < 3; k++) {
        num issue[2];
        given_points(T, names[k], 1, 2, issue);
        constant[k] = sub(issue[0], issue[1]);
    }
    found_points(T, "year less volume", 3, 1, constant);
    about(T, "the year less the volume is the same for all three");
    agree(T, equal_q(constant[1], constant[0]) && equal_q(constant[2], constant[0]));
}
#endif

#include "chapters/judge/claims_off.h"
