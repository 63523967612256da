/* test_latex.c -- what the commands of an author stand for, byte by byte, and the formulas of a source. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/expression/latex.h"

#include <stdio.h>
#include <string.h>

static void sources_are_expanded(void **state)
{
    (void)state;
    static const struct {
        const char *source, *expanded;
    } list[] = {
        {"a b", "a b"},
        /* a comment ends with its line, and takes the blanks of the next one; the last line need not end */
        {"a% b\nc", "ac"},
        {"a% b\n \t c", "ac"},
        {"a% b\n\nc", "a\nc"},
        {"a% b", "a"},
        {"a%", "a"},
        {"a\\% b\nc", "a\\% b\nc"},
        {"a % cagd: for n = 1\nc", "a % cagd: for n = 1\nc"},
        {"\\newcommand{\\f}[1]{<#1>}\\f{a% }\nb}", "<ab>"},
        /* an argument without braces is one token: a character, of however many bytes, or a command */
        {"\\newcommand{\\f}[1]{<#1>}\\f ab", "<a>b"},
        {"\\newcommand{\\f}[1]{<#1>}\\f \xC3\xA9x", "<\xC3\xA9>x"},
        {"\\newcommand{\\f}[1]{<#1>}\\f \xE6\x9B\xB2\xE7\xBA\xBF", "<\xE6\x9B\xB2>\xE7\xBA\xBF"},
        {"\\newcommand{\\f}[1]{<#1>}\\f \xF0\x9D\x91\xA5y", "<\xF0\x9D\x91\xA5>y"},
        {"\\newcommand{\\f}[1]{<#1>}\\f\\alpha b", "<\\alpha> b"},
        {"\\newcommand{\\f}[1]{<#1>}\\f\\{b", "<\\{>b"},
        {"\\newcommand{\\f}[2][z]{#1-#2}\\f{a}\\f[b]{c}", "z-ab-c"},
        {"\\def\\h{x}1\\h 2\\h", "1x 2x"},
        /* where a macro of TeX awaits an argument, a command is a whole one; to ^ and \sqrt it is what it stands for */
        {"\\def\\h{xy}\\frac\\h2", "\\frac{xy}2"},
        {"\\def\\h{xy}\\frac2\\h\\h", "\\frac2{xy}xy"},
        {"\\def\\h{xy}\\frac{2}\\h\\h", "\\frac{2}{xy}xy"},
        {"\\def\\h{xy}\\frac{\\h{\\h}\\h}\\h\\h", "\\frac{xy{xy}xy}{xy}xy"},
        {"\\def\\h{xy}\\frac\\mathbf\\h\\h", "\\frac\\mathbf{xy}xy"},
        {"\\def\\h{xy}\\sqrt\\h^\\h\\hat\\h", "\\sqrt xy^xy\\hat xy"},
        {"\\def\\h{xy}\\sqrt[\\h]\\h\\h", "\\sqrt[xy]{xy}xy"},
        {"\\def\\h{xy}\\sqrt[{]}\\h]\\h\\h", "\\sqrt[{]}xy]{xy}xy"},
        {"\\def\\h{xy}\\cfrac[l]\\h\\h\\h", "\\cfrac[l]{xy}{xy}xy"},
        {"\\def\\h{xy}\\def\\f{\\frac}\\def\\g{\\f\\h}\\g\\h\\h", "\\frac{xy}{xy}xy"},
        {"\\def\\h{\\frac1}\\frac\\h2", "\\frac{\\frac1}2"},
        {"\\iffalse a\\else b\\fi c", " b c"},
        {"\\iffalse a\\ifx\\else\\fi\\else b\\iffalse d\\else\\ifx e\\else\\fi\\fi\\fi\\fi", " b\\ifx e\\else\\fi\\fi"},
    };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        cagd_latex_text out = {0};
        cagd_latex troubles = {0};
        cagd_expand_latex(list[k].source, (int)strlen(list[k].source), &out, &troubles);
        if (out.size != (int)strlen(list[k].expanded) || memcmp(out.bytes, list[k].expanded, (size_t)out.size) != 0)
            print_message("case %d: %s became %.*s\n", (int)k, list[k].source, out.size, out.bytes);
        else
            continue;
        fail();
    }
}

/* A byte of an expansion comes from where the command was called; every other one, also of an argument, from where it stands. */
static void bytes_know_their_places(void **state)
{
    (void)state;
    static const char source[] = "\\newcommand{\\f}[1]{<#1>}a % b\n  \\f{c}d";
    cagd_latex_text out = {0};
    cagd_latex troubles = {0};
    cagd_expand_latex(source, (int)strlen(source), &out, &troubles);
    assert_int_equal(troubles.troubles, 0);
    assert_int_equal(out.size, 6);
    assert_memory_equal(out.bytes, "a <c>d", 6);
    const char *const from[] = {strstr(source, "a % b"), strstr(source, " % b"),   strstr(source, "\\f{c}"),
                                strstr(source, "c}d"),   strstr(source, "\\f{c}"), strstr(source, "c}d") + 2};
    for (int k = 0; k < 6; k++)
        assert_int_equal(out.from[k], from[k] - source);
}

/* ---- formulas of a source ---------------------------------------------------------------------------------- */

/* The source with the word in the place of each @. */
static const char *with_word(const char *source, const char *word)
{
    char *text = region_bytes(strlen(source) + 10 * (strlen(word) + 1) + 1);
    assert_non_null(text);
    *text = '\0';
    for (; *source != '\0'; source++)
        if (*source == '@')
            strcat(text, word);
        else
            strncat(text, source, 1);
    return text;
}

static cagd_latex formulas_of(const char *source)
{
    cagd_latex out;
    cagd_read_latex(source, (int)strlen(source), &out);
    return out;
}

/* Formula k without its blanks. */
static const char *formula(const cagd_latex *of, int k)
{
    char *text = region_bytes((size_t)of->text.size + 1);
    int n = 0;
    assert_non_null(text);
    assert_true(k < of->items);
    for (int m = of->item[k].from; m < of->item[k].to; m++)
        if (of->text.bytes[m] != ' ' && of->text.bytes[m] != '\n')
            text[n++] = of->text.bytes[m];
    text[n] = '\0';
    return text;
}

/* In every environment, with a star and without one, rows are formulas of their own, or lines of one formula; what stands behind its name is none of it. */
static void environments_have_their_rows(void **state)
{
    (void)state;
    static const struct {
        const char *name, *head;
        int formulas;
    } list[] = {{"equation", "", 1},
                {"displaymath", "", 1},
                {"multline", "", 1},
                {"dmath", "", 1},
                {"align", "", 2},
                {"gather", "", 2},
                {"eqnarray", "", 2},
                {"flalign", "", 2},
                {"alignat", "{2}", 2},
                {"dgroup", "", 2},
                {"IEEEeqnarray", "{rCl}", 2},
                {"IEEEeqnarray", "[\\small]{c}", 2},
                {"xalignat", "{2}", 2},
                {"xxalignat", "{2}", 2}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int star = 0; star < 2; star++) {
            char name[40], source[200];
            snprintf(name, sizeof name, "%s%s", list[k].name, star ? "*" : "");
            snprintf(source, sizeof source, "\\begin{%s}%s x = x \\\\ y = y \\label{b} \\end{%s} z", name, list[k].head,
                     name);
            cagd_latex found = formulas_of(source);
            if (found.troubles != 0 || found.items != list[k].formulas ||
                strcmp(formula(&found, 0), list[k].formulas == 1 ? "x=xy=y" : "x=x") != 0 ||
                strcmp(formula(&found, found.items - 1), list[k].formulas == 1 ? "x=xy=y" : "y=y") != 0)
                fail_msg("%s: %d formulas, %s", source, found.items, found.items > 0 ? formula(&found, 0) : "");
            assert_string_equal(found.item[found.items - 1].name, "b");
        }
    static const char *const cases[] = {"numcases", "subnumcases"}, *const unread[] = {"empheq", "darray", "mathpar"};
    for (int k = 0; k < 2; k++) {
        cagd_latex found =
            formulas_of(with_word("\\begin{@}{f =} 1 & if $x > 0$ \\\\ 2 & otherwise \\end{@}", cases[k]));
        assert_int_equal(found.items, 1);
        assert_string_equal(formula(&found, 0), "f=\\begin{cases}1&\\text{if}x>0\\\\2&\\text{otherwise}\\end{cases}");
    }
    for (int k = 0; k < 3; k++) {
        cagd_latex found = formulas_of(with_word("\\begin{@} x = x \\end{@}", unread[k]));
        assert_int_equal(found.items, 0);
        assert_int_equal(found.troubles, 1);
        assert_true(found.trouble[0].is_remark);
        assert_string_equal(found.trouble[0].message, "formulas in this environment are not read");
    }
}

/* Every word that is there for the page alone is left out, with its group if it has one; others are what they stand for. */
static void words_of_the_page(void **state)
{
    (void)state;
    static const char *const with_a_group[] = {"\\hspace", "\\vspace", "\\phantom",   "\\vphantom",       "\\hphantom",
                                               "\\mspace", "\\color",  "\\intertext", "\\shortintertext", "\\raisetag"},
                             *const alone[] = {"\\allowdisplaybreaks",
                                               "\\displaybreak",
                                               "\\hfill",
                                               "\\strut",
                                               "\\mathstrut",
                                               "\\notag",
                                               "\\nonumber",
                                               "\\centering",
                                               "\\small",
                                               "\\ensuremath",
                                               "\\relax",
                                               "\\protect",
                                               "\\/",
                                               "\\bigskip",
                                               "\\medskip",
                                               "\\noindent",
                                               "\\scriptstyle",
                                               "\\IEEEnonumber",
                                               "\\IEEEyesnumber",
                                               "\\IEEEyessubnumber",
                                               "\\IEEEeqnarraynumspace"};
    static const struct {
        const char *written, *means;
        int defines;
    } others[] = {{"\\hbox{a}", "\\text{a}", 0},
                  {"\\textnormal{a}", "\\text{a}", 0},
                  {"\\textit{a}", "\\text{a}", 0},
                  {"\\coloneqq ", "=", 1},
                  {"\\coloneq ", "=", 1},
                  {"\\triangleq ", "=", 1},
                  {":=", "=", 1},
                  {"\\overset{\\text{def}}{=}", "=", 1},
                  {"\\stackrel{def}{=}", "=", 1},
                  {"\\overset{!}{=}", "=", 0},
                  {"\\lVert ", "\\|", 0},
                  {"\\rVert ", "\\|", 0},
                  {"\\Vert ", "\\|", 0},
                  {"\\mid ", "|", 0},
                  {"{}", "", 0},
                  {"{=}", "=", 0},
                  {"{<}", "<", 0},
                  {"{>}", ">", 0},
                  {"{+}", "+", 0},
                  {"{-}", "-", 0},
                  {"\\label{a}", "", 0},
                  {"\\tag{a}", "", 0},
                  {"\\tag*{a}", "", 0}};
    for (size_t k = 0; k < sizeof with_a_group / sizeof *with_a_group; k++)
        for (int star = 0; star < 2; star++) {
            cagd_latex found =
                formulas_of(with_word(star ? "\\[ x @*{2} = y \\]" : "\\[ x @{2} = y \\]", with_a_group[k]));
            if (found.items != 1 || strcmp(formula(&found, 0), "x=y") != 0)
                fail_msg("%s: %s", with_a_group[k], found.items > 0 ? formula(&found, 0) : "");
        }
    for (size_t k = 0; k < sizeof alone / sizeof *alone; k++) {
        cagd_latex found = formulas_of(with_word("\\[ x @ = y \\]", alone[k]));
        if (found.items != 1 || strcmp(formula(&found, 0), "x=y") != 0)
            fail_msg("%s: %s", alone[k], found.items > 0 ? formula(&found, 0) : "");
    }
    for (size_t k = 0; k < sizeof others / sizeof *others; k++) {
        cagd_latex found = formulas_of(with_word("\\[ x @ y \\]", others[k].written));
        if (found.items != 1 || strcmp(formula(&found, 0), with_word("x@y", others[k].means)) != 0 ||
            found.item[0].is_definition != others[k].defines)
            fail_msg("%s: %s", others[k].written, found.items > 0 ? formula(&found, 0) : "");
    }
    static const char *const ends[] = {".", ",", ";", " .", ", ", "\\quad;"};
    for (size_t k = 0; k < sizeof ends / sizeof *ends; k++) {
        cagd_latex found = formulas_of(with_word("\\[ x = y@ \\]", ends[k]));
        assert_string_equal(formula(&found, 0), k == 5 ? "x=y\\quad" : "x=y");
    }
    cagd_latex found = formulas_of("\\[ x = y\\, \\]"); /* a thin space is no comma */
    assert_string_equal(formula(&found, 0), "x=y\\,");
}

/* A row that begins with a sign or a relation goes on with the one before it, with its label, tag, sign of definition and comments; one that begins with a letter does not. */
static void rows_that_go_on(void **state)
{
    (void)state;
    static const char *const signs[] = {"=",          "<",          ">",       "+",      "-",       "\\le", "\\leq",
                                        "\\ge",       "\\geq",      "\\equiv", "\\cdot", "\\times", "\\ne", "\\neq",
                                        "\\leqslant", "\\geqslant", "\\qquad", "\\quad", "/",       "≤",    "≥"};
    for (size_t k = 0; k < sizeof signs / sizeof *signs; k++) {
        cagd_latex found = formulas_of(with_word("\\begin{align} x &= y \\\\ @ z \\end{align}", signs[k]));
        if (found.items != 1 || strcmp(formula(&found, 0), with_word("x=y@z", signs[k])) != 0)
            fail_msg("a row that begins with %s: %d formulas", signs[k], found.items);
    }
    cagd_latex found = formulas_of("\\begin{align} x &= y \\\\ z &= x \\end{align}");
    assert_int_equal(found.items, 2);
    found = formulas_of("\\begin{align} x \\\\ &= y \\label{b} \\end{align}");
    assert_int_equal(found.items, 1);
    assert_string_equal(found.item[0].name, "b");
    found = formulas_of("\\begin{align} x \\\\ &= y \\tag{c} \\end{align}");
    assert_string_equal(found.item[0].name, "c");
    found = formulas_of("\\begin{align} x \\tag{a} \\\\ &= y \\tag{c} \\end{align}");
    assert_string_equal(found.item[0].name, "a");
    found = formulas_of("\\begin{align} x \\tag{a} \\\\ &= y \\label{b} \\end{align}"); /* a label before a tag */
    assert_string_equal(found.item[0].name, "b");
    found = formulas_of("\\begin{align} x \\\\ &:= y % cagd: for n = 1\n \\end{align}");
    assert_true(found.items == 1 && found.item[0].is_definition && found.item[0].notes == 1);
}

/* What sets a formula on several lines means nothing within it; at its beginning it is kept. */
static void settings_within_formulas(void **state)
{
    (void)state;
    static const char *const names[][2] = {
        {"split", ""}, {"aligned", ""}, {"gathered", ""}, {"alignedat", "{2}"}, {"multlined", ""}};
    for (int k = 0; k < 5; k++)
        for (int option = 0; option < 2; option++) {
            char source[200], kept[200];
            const char *name = names[k][0], *above = option ? "[t]" : "";
            snprintf(source, sizeof source, "\\[ z = \\begin{%s}%s%s x \\\\ + y \\end{%s} \\]", name, above,
                     names[k][1], name);
            cagd_latex found = formulas_of(source);
            if (found.items != 1 || strcmp(formula(&found, 0), "z=x+y") != 0)
                fail_msg("%s: %s", source, found.items > 0 ? formula(&found, 0) : "");
            snprintf(source, sizeof source, "\\[ \\begin{%s}%s%s x \\\\ + y \\end{%s} \\]", name, above, names[k][1],
                     name);
            snprintf(kept, sizeof kept, "\\begin{%s}%sx\\\\+y\\end{%s}", name, names[k][1], name);
            found = formulas_of(source);
            if (found.items != 1 || strcmp(formula(&found, 0), strcmp(name, "multlined") == 0 ? "x+y" : kept) != 0)
                fail_msg("%s: %s", source, found.items > 0 ? formula(&found, 0) : "");
        }
}

/* What is no LaTeX is passed over, whatever stands in it. */
static void what_is_verbatim(void **state)
{
    (void)state;
    static const char *const names[] = {"verbatim", "verbatim*", "Verbatim",     "lstlisting",
                                        "minted",   "comment",   "filecontents", "filecontents*"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        cagd_latex found = formulas_of(with_word("\\begin{@} \\[ x = 1 \\] \\end{@} \\[ y = 2 \\]", names[k]));
        if (found.items != 1 || strcmp(formula(&found, 0), "y=2") != 0)
            fail_msg("%s: %d formulas", names[k], found.items);
    }
    static const char *const passed[] = {"\\verb|\\[ x = 1 \\]|",
                                         "\\verb*+\\[ x = 1 \\]+",
                                         "\\iffalse \\[ x = 1 \\] \\fi",
                                         "\\iffalse \\ifx a b \\fi \\[ x = 1 \\] \\fi",
                                         "% \\[ x = 1 \\]\n",
                                         "$x = 1$"};
    for (size_t k = 0; k < sizeof passed / sizeof *passed; k++) {
        cagd_latex found = formulas_of(with_word("@ \\[ y = 2 \\]", passed[k]));
        if (found.items != 1 || strcmp(formula(&found, 0), "y=2") != 0)
            fail_msg("%s: %d formulas", passed[k], found.items);
    }
}

/* The lists of formulas, of troubles and of bytes grow: the last of many is what it would be alone. */
static void lists_grow(void **state)
{
    (void)state;
    enum { FORMULAS = 130 };
    char *source = region_bytes(40 * FORMULAS), *at = source;
    assert_non_null(source);
    for (int k = 0; k < FORMULAS; k++)
        at += sprintf(at, "\\[ x = %d \\label{l%d}\\]\\input{f%d}\n", k, k, k);
    cagd_latex found = formulas_of(source);
    assert_int_equal(found.items, FORMULAS);
    assert_int_equal(found.troubles, FORMULAS);
    for (int k = 0; k < FORMULAS; k++) {
        char text[40];
        snprintf(text, sizeof text, "x=%d", k);
        assert_string_equal(formula(&found, k), text);
        snprintf(text, sizeof text, "l%d", k);
        assert_string_equal(found.item[k].name, text);
        snprintf(text, sizeof text, "\\input{f%d}", k);
        assert_true(found.trouble[k].is_remark);
        assert_ptr_equal(source + found.trouble[k].from, strstr(source, text));
        snprintf(text, sizeof text, "= %d ", k);
        assert_int_equal(found.text.from[found.item[k].from + 2], strstr(source, text) - source);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(sources_are_expanded),
                                       unit(bytes_know_their_places),
                                       unit(environments_have_their_rows),
                                       unit(words_of_the_page),
                                       unit(rows_that_go_on),
                                       unit(settings_within_formulas),
                                       unit(what_is_verbatim),
                                       unit(lists_grow)};
    return run_unit_tests(tests);
}
