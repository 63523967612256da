/* main.c -- finds the command that is called, and runs it. */
#include "chapters/chapters.h"
#include "cli/commands.h"

#include <locale.h>
#include <stdio.h>
#include <string.h>

#define ADDRESS_OF_COMMAND(name) &command_##name,
const struct command *const commands[] = {COMMANDS(ADDRESS_OF_COMMAND) NULL};

void print_help(FILE *out)
{
    fputs("cagd decides the statements of textbooks on geometric design, exactly as printed.\n\nExamples:\n", out);
    for (int k = 0; commands[k] != NULL; k++)
        if (commands[k]->example != NULL)
            fputs(commands[k]->example, out);
    fputs("\nCommands:\n", out);
    for (int k = 0; commands[k] != NULL; k++)
        fprintf(out, "  %-10s %s\n", commands[k]->name, commands[k]->summary);
    fputs("\n'cagd COMMAND --help' explains a command.  Exit status: 0 as expected, 1 a verdict is not as\n"
          "expected, 2 bad usage or input, 3 internal error.\n",
          out);
}

static int unknown_command(const char *name)
{
    fprintf(stderr, "cagd: there is no command '%s'; expected", name);
    for (int k = 0; commands[k] != NULL; k++)
        fprintf(stderr, "%s %s", k == 0 ? "" : commands[k + 1] == NULL ? " or" : ",", commands[k]->name);
    fputs("\n", stderr);
    return EXIT_USAGE;
}

static int run(const struct command *command, int argc, char **argv)
{
    char name[32];
    snprintf(name, sizeof name, "cagd %s", command->name);
    argv[0] = name;
    const struct call call = {command, &compiled_chapters, argc, argv};
    int code = command->run(&call);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fputs("cagd: standard output cannot be written\n", stderr);
        return EXIT_INTERNAL;
    }
    return code;
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
    /* For the build alone, and so not in the help: --write-documents DIR. */
    if (strcmp(argv[1], "--write-documents") == 0 && argc == 3)
        return write_manual(argv[2]) == 0 && write_completions(argv[2]) == 0 ? EXIT_AS_EXPECTED : EXIT_INTERNAL;
    for (int k = 0; commands[k] != NULL; k++)
        if (strcmp(argv[1], commands[k]->name) == 0)
            return run(commands[k], argc - 1, argv + 1);
    return unknown_command(argv[1]);
}
