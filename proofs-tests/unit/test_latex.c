/* test_latex.c -- what the commands of an author stand for, byte by byte. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/expression/latex.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {unit(sources_are_expanded), unit(bytes_know_their_places)};
    return run_unit_tests(tests);
}
