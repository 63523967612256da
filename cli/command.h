/* command.h -- what a command is, how it is called, and what commands are asked alike. */
#ifndef CAGD_COMMAND_H
#define CAGD_COMMAND_H

#include "cli/refuse.h"
#include "cli/select.h"

#include <argp.h>

enum exit_code { EXIT_AS_EXPECTED = 0, EXIT_NOT_AS_EXPECTED = 1, EXIT_USAGE = 2, EXIT_INTERNAL = 3 };

/* The options that commands have in common, to be added up; their values are in struct asked. */
enum shared_option { TAKES_JSON = 1, TAKES_JOBS = 2 };

/* What the arguments of a command are, those that are no options. */
enum argument_kind {
    NO_ARGUMENTS, /* none is taken                                                  */
    CLAIM_NAMES,  /* ids, or patterns of claims and statements, into asked.patterns */
    FIGURE_NAMES, /* patterns of figures, into asked.patterns                       */
    FILE_NAME,    /* one file, into asked.path                                       */
    WORDS         /* what the command itself understands, into asked.patterns         */
};

/* The words that an option takes, separated by blanks, for the completion. */
struct option_words {
    const char *option, *words;
};

/* A section of the manual, on a format say.  Blank lines separate the paragraphs. */
struct topic {
    const char *title, *text;
};

/* What the argument of an option says of it: FILE is written, DIR is a folder to write to, and a name with an ending, such
 * as CURVE.json, is read.  A file that is read is not written over, and whether the others can be written is seen before
 * anything is computed. */
int is_written_file(const struct argp_option *row);
int is_written_folder(const struct argp_option *row);
int is_read_file(const struct argp_option *row);

/* One command.  Its file defines it as `const struct command command_NAME`, cli/commands.h lists it; help, manual and
 * completion are made from this. */
struct call;
struct command {
    const char *name;
    const char *summary; /* one line: neither a capital nor a full stop                            */
    const char *example; /* lines for the help of the program, or NULL                             */
    const char *usage;   /* the arguments as the help names them: "[PATTERN...]"                   */
    const char *text;    /* what it does; "Examples:"; and after a \v what stands below the options */
    enum argument_kind arguments;
    const char *file;                  /* what it holds, where one is taken: "a curve"                           */
    int shared;                        /* a sum of TAKES_...                                                     */
    const struct argp_option *options; /* its own; or NULL                                                       */
    argp_parser_t parse;               /* of its own options, into what parse_arguments was given; or NULL       */
    const struct option_words *words;  /* ends with {0}; or NULL                                                 */
    const struct topic *topics;        /* ends with {0}; or NULL                                                 */
    int (*run)(const struct call *c);  /* returns an exit code                                                   */
};

/* A command as it is called, about what the register holds; argv[0] is "cagd NAME". */
struct call {
    const struct command *command;
    const cagd_register *reg;
    int argc;
    char **argv;
};

/* What is asked by shared options and arguments.  The arguments of a command are a structure of its own that begins with
 * a struct asked. */
struct asked {
    const struct command *command;
    int json, jobs; /* jobs: one for each processor unless given */
    struct patterns patterns;
    const char *path;
};

/* Parses the call into the arguments of the command, which begin at `a`, or refuses it. */
void parse_arguments(const struct call *c, struct asked *a);
/* A whole number in [low, high], or one line that says what was expected, and EXIT_USAGE. */
int whole_number(struct argp_state *state, const char *option, const char *text, int low, int high);

/* Calls visit(context, row) for every option of the command, its own and then the shared ones. */
void visit_options(const struct command *c, void (*visit)(void *context, const struct argp_option *row), void *context);
#endif
