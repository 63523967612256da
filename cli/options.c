/* options.c -- the options that a command has; see options.h and command.h. */
#include "cli/options.h"
#include "cli/nearest.h"

#include <stdlib.h>
#include <string.h>

const struct argp_option json_row[] = {
    {"json", 'J', 0, 0, "Print JSON, with a field \"schema\" that names its format", -2}, {0}};
const struct argp_option jobs_row[] = {{"jobs", 'j', "N", 0, "Threads (default: one for each processor)", -2}, {0}};
const struct argp_option help_rows[] = {
    {"help", '?', 0, 0, "Give this help list", -1}, {"usage", KEY_USAGE, 0, 0, "Give a short usage message", -1}, {0}};

int is_written_file(const struct argp_option *row) { return row->arg != NULL && strcmp(row->arg, "FILE") == 0; }
int is_written_folder(const struct argp_option *row) { return row->arg != NULL && strcmp(row->arg, "DIR") == 0; }
int is_read_file(const struct argp_option *row)
{
    return row->arg != NULL && strchr(row->arg, '.') != NULL && strstr(row->arg, "...") == NULL;
}

/* The k-th option of the command: its own, then the shared ones, then those of every command; NULL behind the last. */
static const struct argp_option *option_at(const struct command *c, int k)
{
    const struct argp_option *const parts[] = {c->options, c->shared & TAKES_JSON ? json_row : NULL,
                                               c->shared & TAKES_JOBS ? jobs_row : NULL, help_rows};
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++)
        for (const struct argp_option *row = parts[p]; row != NULL && row->name != NULL; row++)
            if (k-- == 0)
                return row;
    return NULL;
}

static int is_help(const struct argp_option *row) { return row >= help_rows && row < help_rows + 2; }

void visit_options(const struct command *c, void (*visit)(void *context, const struct argp_option *row), void *context)
{
    const struct argp_option *row;
    for (int k = 0; (row = option_at(c, k)) != NULL; k++)
        if (!(row->flags & OPTION_HIDDEN) && !is_help(row))
            visit(context, row);
}

/* ---- what is typed ------------------------------------------------------------------------------------- */

static _Noreturn void refuse_unknown(const struct call *call, const char *name, size_t length)
{
    const struct argp_option *row;
    char *typed = strndup(name, length), *near = NULL;
    size_t size;
    FILE *out = open_memstream(&near, &size);
    if (typed == NULL || out == NULL)
        abort();
    struct nearest n = {.text = typed};
    for (int k = 0; (row = option_at(call->command, k)) != NULL; k++)
        if (!(row->flags & OPTION_HIDDEN))
            consider_name(&n, row->name);
    put_nearest(out, &n, "--");
    if (n.name[0] == NULL)
        fputs("the help names all", out);
    if (fclose(out) != 0)
        abort();
    refuse_call(call->argv[0], "there is no option --%s; %s", typed, near);
}

static _Noreturn void refuse_ambiguous(const struct call *call, const char *name, size_t length)
{
    const struct argp_option *row;
    char *several = NULL;
    size_t size;
    FILE *out = open_memstream(&several, &size);
    if (out == NULL)
        abort();
    for (int k = 0, before = 0; (row = option_at(call->command, k)) != NULL; k++)
        if (strncmp(row->name, name, length) == 0)
            fprintf(out, "%s--%s", before++ ? " or " : "", row->name);
    if (fclose(out) != 0)
        abort();
    refuse_call(call->argv[0], "--%.*s may be %s; which is meant?", (int)length, name, several);
}

/* The option with that name, or the only one that begins so. */
static const struct argp_option *long_option(const struct call *call, const char *name, size_t length)
{
    const struct argp_option *row, *found = NULL;
    int several = 0;
    for (int k = 0; (row = option_at(call->command, k)) != NULL; k++) {
        if (strncmp(row->name, name, length) != 0)
            continue;
        if (row->name[length] == '\0')
            return row;
        several = found != NULL;
        found = row;
    }
    if (several && length > 0)
        refuse_ambiguous(call, name, length);
    if (found == NULL || several)
        refuse_unknown(call, name, length);
    return found;
}

static const struct argp_option *short_option(const struct call *call, char letter)
{
    const struct argp_option *row;
    for (int k = 0; (row = option_at(call->command, k)) != NULL; k++)
        if (row->key == letter)
            return row;
    refuse_call(call->argv[0], "there is no option -%c; the help names all", letter);
}

void check_options(const struct call *call)
{
    for (int k = 1; k < call->argc && strcmp(call->argv[k], "--") != 0; k++) {
        const char *word = call->argv[k], *value = NULL;
        const struct argp_option *row = NULL;
        int is_long = strncmp(word, "--", 2) == 0;
        if (word[0] != '-' || word[1] == '\0')
            continue;
        if (is_long) {
            size_t length = strcspn(word + 2, "=");
            row = long_option(call, word + 2, length);
            value = word[2 + length] == '=' ? word + 3 + length : NULL;
        }
        for (word++; !is_long && *word != '\0' && value == NULL; word++) {
            row = short_option(call, *word);
            if (is_help(row))
                return;
            if (row->arg != NULL && word[1] != '\0')
                value = word + 1;
        }
        if (is_help(row) && value == NULL)
            return; /* and nothing behind it is looked at */
        if (row->arg == NULL && value != NULL)
            refuse_call(call->argv[0], "--%s takes no value; leave out '=%s'", row->name, value);
        if (row->arg != NULL && value == NULL && ++k == call->argc)
            refuse_call(call->argv[0], "--%s takes a value: --%s %s", row->name, row->name, row->arg);
    }
}
