#include "cli/command.h"
#include "exact/region.h"
#include "figures/svg.h"

#include <fnmatch.h>
#include <stdlib.h>
#include <string.h>

struct arguments {
    struct patterns patterns;
    const char *out;
    int list;
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    switch (key) {
    case 'o':
        a->out = arg;
        break;
    case 'l':
        a->list = 1;
        break;
    case ARGP_KEY_ARGS:
        a->patterns = (struct patterns){state->argv + state->next, state->argc - state->next};
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

static int wanted(const char *name, const struct patterns *p)
{
    for (int k = 0; k < p->count; k++)
        if (fnmatch(p->at[k], name, 0) == 0)
            return 1;
    return p->count == 0;
}

int run_figures(int argc, char **argv)
{
    static const struct argp_option options[] = {
        {"out", 'o', "DIR", 0, "Folder to write to (default: the current one)", 0},
        {"list", 'l', 0, 0, "Only print the names", 0},
        {0}};
    static const struct argp argp = {options,
                                     parse,
                                     "[PATTERN...]",
                                     "Draws the figures as SVG, from exact values: the same bytes on every machine.\n\n"
                                     "Examples:\n"
                                     "  cagd figures --out pictures\n"
                                     "  cagd figures --list\n"
                                     "  cagd figures 'envelope*'\n",
                                     NULL,
                                     NULL,
                                     NULL};
    struct arguments a = {.out = "."};
    parse_arguments(&argp, argc, argv, &a);
    for (int k = 0; k < a.patterns.count; k++) {
        int found = 0;
        for (const figure *f = all_figures; f->name != NULL; f++)
            found |= fnmatch(a.patterns.at[k], f->name, 0) == 0;
        if (!found) {
            complain_about(a.patterns.at[k], FIGURES);
            return EXIT_USAGE;
        }
    }
    if (!a.list && make_folder(a.out) != 0)
        return EXIT_INTERNAL;
    int code = EXIT_AS_EXPECTED, drawn = 0;
    for (const figure *f = all_figures; f->name != NULL && code == EXIT_AS_EXPECTED; f++) {
        if (!wanted(f->name, &a.patterns))
            continue;
        if (a.list) {
            puts(f->name);
            continue;
        }
        region_mark mark = region_open();
        struct svg *s = f->draw();
        char path[4096];
        snprintf(path, sizeof path, "%s/%s.svg", a.out, f->name);
        if (svg_text(s) == NULL) {
            fprintf(stderr, "cagd: figure '%s' cannot be drawn: %s\n", f->name, svg_failed(s));
            code = EXIT_INTERNAL;
        } else if (write_text_file(path, svg_text(s)) != 0) {
            code = EXIT_INTERNAL;
        }
        svg_free(s);
        region_drop(mark);
        drawn++;
    }
    if (!a.list && code == EXIT_AS_EXPECTED)
        printf("%d figures in %s\n", drawn, a.out);
    exact_thread_end();
    return code;
}
