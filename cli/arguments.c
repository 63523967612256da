/* arguments.c -- how the arguments of a command are parsed: its own options, and those that commands share. */
#include "cli/options.h"
#include "cli/output.h"
#include "cli/terminal.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static error_t parse_shared(int key, char *arg, struct argp_state *state)
{
    struct asked *a = state->input;
    switch (key) {
    case 'J':
        a->json = 1;
        return 0;
    case 'j':
        a->jobs = whole_number(state, "--jobs", arg, 1, 64);
        return 0;
    case '?':
        argp_state_help(state, state->out_stream, ARGP_HELP_STD_HELP);
        return 0;
    case KEY_USAGE:
        argp_state_help(state, state->out_stream, ARGP_HELP_USAGE | ARGP_HELP_EXIT_OK);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* ---- files that options name ------------------------------------------------------------------------- */

/* An option that was given with a file; cli/command.h says which options take one. */
struct given {
    const struct argp_option *row;
    const char *path;
};
enum { MOST_GIVEN = 16 };
static struct given given[MOST_GIVEN];
static int files_given;

/* Notes the file that the option names, if it names one; one file an option. */
static void note_file(const struct argp_option *row, const char *path, struct argp_state *state)
{
    if (!is_written_file(row) && !is_written_folder(row) && !is_read_file(row))
        return;
    for (int k = 0; k < files_given; k++)
        if (given[k].row == row)
            refuse_call(state->name, "--%s is given twice: '%s' or '%s'?", row->name, given[k].path, path);
    if (files_given < MOST_GIVEN)
        given[files_given++] = (struct given){row, path};
}

/* The options of the command itself. */
static error_t parse_own(int key, char *arg, struct argp_state *state)
{
    const struct command *c = ((const struct asked *)state->input)->command;
    for (const struct argp_option *row = c->options; row != NULL && row->name != NULL; row++)
        if (row->key == key && arg != NULL)
            note_file(row, arg, state);
    return c->parse != NULL ? c->parse(key, arg, state) : ARGP_ERR_UNKNOWN;
}

static void end_unless_well(int code)
{
    if (code != EXIT_AS_EXPECTED)
        exit(code);
}

/* Ends the program when what is to be written cannot be, before anything is computed: folders are made when nothing is left
 * to be refused. */
static void promise_files(const struct asked *a)
{
    if (a->path != NULL)
        end_unless_well(output_spare(a->path));
    for (int k = 0; k < files_given; k++)
        if (is_read_file(given[k].row))
            end_unless_well(output_spare(given[k].path));
    for (int k = 0; k < files_given; k++)
        if (is_written_file(given[k].row))
            end_unless_well(output_promise(given[k].row->name, given[k].path));
    for (int k = 0; k < files_given; k++)
        if (is_written_folder(given[k].row))
            end_unless_well(output_promise_folder(given[k].row->name, given[k].path));
    for (int k = 0; k < files_given; k++)
        if (is_written_folder(given[k].row) && make_folder(given[k].path) != 0)
            exit(EXIT_USAGE);
}

/* ---- arguments --------------------------------------------------------------------------------------- */

static error_t parse_none(int key, char *arg, struct argp_state *state)
{
    if (key == ARGP_KEY_ARG)
        refuse_call(state->name, "takes options only, not '%s'; leave it out", arg);
    return ARGP_ERR_UNKNOWN;
}

static error_t parse_patterns(int key, char *arg, struct argp_state *state)
{
    (void)arg;
    struct asked *a = state->input;
    if (key != ARGP_KEY_ARGS)
        return ARGP_ERR_UNKNOWN;
    a->patterns = (struct patterns){state->argv + state->next, state->argc - state->next};
    return 0;
}

static error_t parse_file(int key, char *arg, struct argp_state *state)
{
    struct asked *a = state->input;
    switch (key) {
    case ARGP_KEY_ARG:
        if (a->path != NULL)
            refuse_call(state->name, "one file at a time: '%s' or '%s'?", a->path, arg);
        a->path = arg;
        return 0;
    case ARGP_KEY_NO_ARGS:
        refuse_call(state->name, "expected the file of %s", a->command->file);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

enum { PARTS = 5 };

/* Every part is given the same input, the arguments of the command. */
static error_t give_input(int key, char *arg, struct argp_state *state)
{
    (void)arg;
    if (key != ARGP_KEY_INIT)
        return ARGP_ERR_UNKNOWN;
    for (int k = 0; k < PARTS; k++)
        state->child_inputs[k] = state->input;
    return 0;
}

static int processors(void)
{
    long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > 64 ? 64 : (int)n;
}

/* The help that argp prints has 79 columns unless its variable says otherwise. */
static void fit_help_to_screen(void)
{
    enum { USUAL = 79 };
    char format[32];
    snprintf(format, sizeof format, "rmargin=%d", page_width(USUAL));
    setenv("ARGP_HELP_FMT", format, 0);
}

void parse_arguments(const struct call *call, struct asked *a)
{
    static const struct argp json = {.options = json_row, .parser = parse_shared};
    static const struct argp jobs = {.options = jobs_row, .parser = parse_shared};
    static const struct argp help = {.options = help_rows, .parser = parse_shared};
    static const struct argp none = {0}, alone = {.parser = parse_none}, names = {.parser = parse_patterns},
                             file = {.parser = parse_file};
    static const struct argp *const arguments[] = {[NO_ARGUMENTS] = &alone,
                                                   [CLAIM_NAMES] = &names,
                                                   [FIGURE_NAMES] = &names,
                                                   [FILE_NAME] = &file,
                                                   [WORDS] = &names};
    const struct command *c = call->command;
    const struct argp own = {.options = c->options, .parser = parse_own};
    const struct argp_child parts[PARTS + 1] = {{.argp = &own},
                                                {.argp = c->shared & TAKES_JSON ? &json : &none},
                                                {.argp = c->shared & TAKES_JOBS ? &jobs : &none},
                                                {.argp = &help},
                                                {.argp = arguments[c->arguments]}};
    const struct argp whole = {.parser = give_input, .args_doc = c->usage, .doc = c->text, .children = parts};
    files_given = 0;
    a->command = c;
    a->jobs = processors();
    fit_help_to_screen();
    check_options(call);
    argp_err_exit_status = EXIT_USAGE;
    int refused = argp_parse(&whole, call->argc, call->argv, ARGP_NO_HELP, NULL, a);
    if (refused == ENOMEM)
        abort();
    if (refused != 0)
        exit(EXIT_USAGE);
    promise_files(a);
}

int whole_number(struct argp_state *state, const char *option, const char *text, int low, int high)
{
    char *end;
    long value = strtol(text, &end, 10);
    if (*text == '\0' || *end != '\0' || value < low || value > high)
        refuse_call(state->name, "%s takes a whole number from %d to %d, not '%s'", option, low, high, text);
    return (int)value;
}
