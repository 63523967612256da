/* commands.h -- the commands, in the order in which help and manual list them.
 *
 * ROW(name) stands for `const struct command command_name`, which cli/name.c (or cli/name/) defines. */
#ifndef CAGD_COMMANDS_H
#define CAGD_COMMANDS_H

#include "cli/command.h"

#define COMMANDS(ROW)                                                                                                  \
    ROW(verify)                                                                                                        \
    ROW(list)                                                                                                          \
    ROW(show)                                                                                                          \
    ROW(ledger)                                                                                                        \
    ROW(figures)                                                                                                       \
    ROW(check)                                                                                                         \
    ROW(curve)                                                                                                         \
    ROW(fit)                                                                                                           \
    ROW(exactly)                                                                                                       \
    ROW(lab)

#define DECLARE_COMMAND(name) extern const struct command command_##name;
COMMANDS(DECLARE_COMMAND)

/* All of them; ends with NULL. */
extern const struct command *const commands[];

/* The help of the program, on `out`. */
void print_help(FILE *out);

/* Writes what is installed beside the program, made from the commands: DIR/cagd.1 (manual.c) and, for completion
 * (completion.c), DIR/cagd.bash, DIR/_cagd (zsh) and DIR/cagd.fish.  0, or -1 and a line on stderr. */
int write_manual(const char *folder);
int write_completions(const char *folder);
#endif
