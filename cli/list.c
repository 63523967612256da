#include "cli/command.h"

#include <stdlib.h>
#include <string.h>

struct arguments {
    struct patterns patterns;
    int json;
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    (void)arg;
    struct arguments *a = state->input;
    switch (key) {
    case 'J':
        a->json = 1;
        break;
    case ARGP_KEY_ARGS:
        a->patterns = (struct patterns){state->argv + state->next, state->argc - state->next};
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

int run_list(int argc, char **argv)
{
    static const struct argp_option options[] = {{"json", 'J', 0, 0, "Print the list as JSON", 0}, {0}};
    static const struct argp argp = {options,
                                     parse,
                                     "[PATTERN...]",
                                     "Lists the claims, one a line.\n\nExamples:\n"
                                     "  cagd list\n"
                                     "  cagd list '*curvature*'\n"
                                     "  cagd list 'wang-ch3:3.2.*'\n",
                                     NULL,
                                     NULL,
                                     NULL};
    struct arguments a = {0};
    parse_arguments(&argp, argc, argv, &a);
    if (!all_match_claims(&a.patterns))
        return EXIT_USAGE;
    int count;
    const claim **list = matching_claims(&a.patterns, &count);
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
