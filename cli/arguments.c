/* arguments.c -- how the arguments of a command are parsed: its own options, and those that commands share. */
#include "cli/command.h"

#include <stdlib.h>
#include <unistd.h>

static const struct argp_option json_row[] = {
    {"json", 'J', 0, 0, "Print JSON, with a field \"schema\" that names its format", -2}, {0}};
static const struct argp_option jobs_row[] = {{"jobs", 'j', "N", 0, "Threads (default: one for each processor)", -2},
                                              {0}};

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
    default:
        return ARGP_ERR_UNKNOWN;
    }
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
            argp_error(state, "one file at a time: '%s' or '%s'?", a->path, arg);
        a->path = arg;
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "expected the file of %s", a->command->file);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

enum { PARTS = 4 };

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

void parse_arguments(const struct call *call, struct asked *a)
{
    static const struct argp json = {.options = json_row, .parser = parse_shared};
    static const struct argp jobs = {.options = jobs_row, .parser = parse_shared};
    static const struct argp none = {0}, names = {.parser = parse_patterns}, file = {.parser = parse_file};
    static const struct argp *const arguments[] = {
        [NO_ARGUMENTS] = &none, [CLAIM_NAMES] = &names, [FIGURE_NAMES] = &names, [FILE_NAME] = &file};
    const struct command *c = call->command;
    const struct argp own = {.options = c->options, .parser = c->parse};
    const struct argp_child parts[PARTS + 1] = {{.argp = &own},
                                                {.argp = c->shared & TAKES_JSON ? &json : &none},
                                                {.argp = c->shared & TAKES_JOBS ? &jobs : &none},
                                                {.argp = arguments[c->arguments]}};
    const struct argp whole = {.parser = give_input, .args_doc = c->usage, .doc = c->text, .children = parts};
    a->command = c;
    a->jobs = processors();
    argp_err_exit_status = EXIT_USAGE;
    if (argp_parse(&whole, call->argc, call->argv, 0, NULL, a) != 0)
        exit(EXIT_USAGE);
}

int whole_number(struct argp_state *state, const char *option, const char *text, int low, int high)
{
    char *end;
    long value = strtol(text, &end, 10);
    if (*text == '\0' || *end != '\0' || value < low || value > high)
        argp_error(state, "%s takes a whole number from %d to %d, not '%s'", option, low, high, text);
    return (int)value;
}

void visit_options(const struct command *c, void (*visit)(void *context, const struct argp_option *row), void *context)
{
    for (const struct argp_option *row = c->options; row != NULL && row->name != NULL; row++)
        visit(context, row);
    if (c->shared & TAKES_JSON)
        visit(context, json_row);
    if (c->shared & TAKES_JOBS)
        visit(context, jobs_row);
}
