/* list.c -- cagd list: the claims by their names. */
#include "cli/commands.h"
#include "cli/names.h"
#include "cli/report.h"
#include "cli/terminal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct arguments {
    struct asked asked;
    int names;
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    (void)arg;
    struct arguments *a = state->input;
    if (key == ARGP_KEY_END && a->names && a->asked.json)
        refuse_call(state->name, "one form at a time: --json or --names?");
    if (key != 'n')
        return ARGP_ERR_UNKNOWN;
    a->names = 1;
    return 0;
}

static int run(const struct call *call)
{
    struct arguments arguments = {0};
    parse_arguments(call, &arguments.asked);
    const struct asked a = arguments.asked;
    if (!all_match(call->reg, &a.patterns, arguments.names ? STATEMENTS : CLAIMS))
        return EXIT_USAGE;
    if (arguments.names) {
        print_names(call->reg, &a.patterns);
        return EXIT_AS_EXPECTED;
    }
    int count;
    const claim **list = matching_claims(call->reg, &a.patterns, &count);
    json_t *claims = json_array();
    int width = 0;
    for (int k = 0; k < count; k++)
        if ((int)(strlen(list[k]->name) + strlen(list[k]->chapter)) > width)
            width = (int)(strlen(list[k]->name) + strlen(list[k]->chapter));
    for (int k = 0; k < count; k++) {
        if (a.json) {
            json_array_append_new(claims,
                                  json_pack("{s:s, s:s, s:s, s:s}", "name", list[k]->name, "chapter", list[k]->chapter,
                                            "title", list[k]->title, "title_zh", list[k]->title_zh));
        } else {
            char full[256];
            snprintf(full, sizeof full, "%s.%s", list[k]->chapter, list[k]->name);
            put_padded(stdout, full, width + 3);
            printf("%s\n", list[k]->title);
        }
    }
    if (a.json)
        print_json(json_pack("{s:s, s:O}", "schema", "cagd-list-1", "claims", claims));
    json_decref(claims);
    free(list);
    return EXIT_AS_EXPECTED;
}

static const struct argp_option options[] = {
    {"names", 'n', 0, 0, "Only names, all that 'cagd show' takes: of statements, of tables, and of claims", 0}, {0}};

const struct command command_list = {
    .name = "list",
    .summary = "the claims, one a line",
    .usage = "[PATTERN...]",
    .text = "Lists the claims, one a line.\n\n"
            "Examples:\n"
            "  cagd list\n"
            "  cagd list '*curvature*'\n"
            "  cagd list 'wang-ch3:3.2.*'\n"
            "  cagd list --names               also of the statements, for 'cagd show'\n"
            "  cagd list 包络                  whose titles have the word\n",
    .arguments = CLAIM_NAMES,
    .shared = TAKES_JSON,
    .options = options,
    .parse = parse,
    .run = run,
};
