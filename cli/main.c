/* main.c -- finds the command that is called, and runs it. */
#include "chapters/chapters.h"
#include "cli/commands.h"
#include "cli/memory.h"
#include "cli/nearest.h"
#include "cli/screen.h"

#include <locale.h>
#include <signal.h>
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
    fputs("\n'cagd help COMMAND' explains a command.  Exit status: 0 as expected; 1 a verdict is not as\n"
          "expected; 2 the call, a file that is read or the name of one to write to has to be mended, and nothing\n"
          "was written; 3 something failed on the way: a full disk, too little memory, an error inside.\n",
          out);
}

static int unknown_command(const char *name)
{
    struct nearest n = {.text = name};
    for (int k = 0; commands[k] != NULL; k++)
        consider_name(&n, commands[k]->name);
    struct refusal r;
    refusal_begin(&r);
    fprintf(r.to, "there is no command '%s'; %s", name, n.name[0] == NULL ? "expected" : "");
    put_nearest(r.to, &n, "");
    for (int k = 0; n.name[0] == NULL && commands[k] != NULL; k++)
        fprintf(r.to, "%s %s", k == 0 ? "" : commands[k + 1] == NULL ? " or" : ",", commands[k]->name);
    refusal_put(&r);
    return EXIT_USAGE;
}

static int run(const struct command *command, int argc, char **argv)
{
    char name[32];
    snprintf(name, sizeof name, "cagd %s", command->name);
    argv[0] = name;
    const struct call call = {command, &compiled_chapters, argc, argv};
    return command->run(&call);
}

static const struct command *command_called(const char *name)
{
    for (int k = 0; commands[k] != NULL; k++)
        if (strcmp(name, commands[k]->name) == 0)
            return commands[k];
    return NULL;
}

/* cagd help, or cagd help COMMAND. */
static int help(int argc, char **argv)
{
    if (argc < 2) {
        print_help(stdout);
        return EXIT_AS_EXPECTED;
    }
    const struct command *command = command_called(argv[1]);
    char name[] = "help", option[] = "--help", *asked[] = {name, option, NULL};
    return command != NULL ? run(command, 2, asked) : unknown_command(argv[1]);
}

int main(int argc, char **argv)
{
    memory_begin();
    setlocale(LC_CTYPE, "");
    signal(SIGXFSZ, SIG_IGN); /* a file beyond the limit is an error of writing, told as others are */
    screen_begin();
    if (argc < 2) {
        print_help(stderr);
        return EXIT_USAGE;
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
        print_help(stdout);
        return EXIT_AS_EXPECTED;
    }
    if (strcmp(argv[1], "help") == 0)
        return help(argc - 1, argv + 1);
    if (strcmp(argv[1], "--version") == 0) {
        puts("cagd " CAGD_VERSION);
        return EXIT_AS_EXPECTED;
    }
    /* For the build alone, and so not in the help: --write-documents DIR. */
    if (strcmp(argv[1], "--write-documents") == 0 && argc == 3)
        return write_manual(argv[2]) == 0 && write_completions(argv[2]) == 0 ? EXIT_AS_EXPECTED : EXIT_INTERNAL;
    const struct command *command = command_called(argv[1]);
    return command != NULL ? run(command, argc - 1, argv + 1) : unknown_command(argv[1]);
}
