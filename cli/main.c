#include "cli/command.h"

#include <locale.h>
#include <stdlib.h>
#include <string.h>

static const struct command commands[] = {
    {"verify", "decide claims and print a table of the verdicts", run_verify},
    {"list", "the claims, one a line", run_list},
    {"show", "one claim or ledger entry in full, with its counterexample", run_show},
    {"ledger", "every statement of the sources with its verdict", run_ledger},
    {"figures", "write the SVG figures", run_figures},
    {"curve", "a Bézier, B-spline or NURBS curve in exact arithmetic: points, knots, degree", run_curve},
    {"fit", "a rational curve fitted to measured points, with statistics and a picture", run_fit},
};
enum { COMMANDS = sizeof commands / sizeof *commands };

static void print_help(FILE *out)
{
    fputs("cagd decides the statements of textbooks on geometric design, exactly as printed.\n\n"
          "Examples:\n"
          "  cagd verify                      decide every claim\n"
          "  cagd verify 'rational-bezier.*'  decide the claims of one chapter\n"
          "  cagd show wang-ch3:thm-3.3.2     a statement, its verdict and why\n"
          "  cagd ledger 'wang-ch3:*'         the statements of one source\n"
          "  cagd figures --out pictures      draw\n"
          "  cagd curve circle.json --at 1/3  a point of a curve, exactly\n"
          "  cagd fit points.csv --degree 3   the rational cubic closest to measured points\n\n"
          "Commands:\n",
          out);
    for (int k = 0; k < COMMANDS; k++)
        fprintf(out, "  %-10s %s\n", commands[k].name, commands[k].summary);
    fputs("\n'cagd COMMAND --help' explains a command.  Exit status: 0 as expected, 1 a verdict is not as\n"
          "expected, 2 bad usage or input, 3 internal error.\n",
          out);
}

int main(int argc, char **argv)
{
    setlocale(LC_CTYPE, "");
    if (argc < 2) {
        print_help(stderr);
        return EXIT_USAGE;
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 || strcmp(argv[1], "help") == 0) {
        print_help(stdout);
        return EXIT_AS_EXPECTED;
    }
    if (strcmp(argv[1], "--version") == 0) {
        puts("cagd " CAGD_VERSION);
        return EXIT_AS_EXPECTED;
    }
    for (int k = 0; k < COMMANDS; k++)
        if (strcmp(argv[1], commands[k].name) == 0) {
            char name[32];
            snprintf(name, sizeof name, "cagd %s", commands[k].name);
            argv[1] = name;
            int code = commands[k].run(argc - 1, argv + 1);
            if (fflush(stdout) != 0 || ferror(stdout)) {
                fputs("cagd: standard output cannot be written\n", stderr);
                return EXIT_INTERNAL;
            }
            return code;
        }
    fprintf(stderr, "cagd: there is no command '%s'; expected", argv[1]);
    for (int k = 0; k < COMMANDS; k++)
        fprintf(stderr, "%s %s", k == 0 ? "" : k == COMMANDS - 1 ? " or" : ",", commands[k].name);
    fputs("\n", stderr);
    return EXIT_USAGE;
}
