/* figures.c -- cagd figures: draws. */
#include "cli/commands.h"
#include "cli/output.h"
#include "cli/refuse.h"
#include "exact/number/parallel.h"
#include "exact/number/region.h"
#include "exact/words.h"
#include "figures/svg.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct arguments {
    struct asked asked;
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
    case ARGP_KEY_END:
        if (a->list && a->out != NULL)
            refuse_call(state->name, "--list writes nothing: --out does not go with it");
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

struct work {
    const char *folder;
    const figure **list;
    atomic_int failed;
    int unwritten;
};

/* Figure k, unless another one failed. */
static void draw(void *context, int k)
{
    struct work *w = context;
    if (w->failed > 0)
        return;
    region_mark mark = region_open();
    struct svg *s = w->list[k]->draw();
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.svg", w->folder, w->list[k]->name);
    const char *text = svg_text(s);
    if (text == NULL)
        refuse_line("figure '%s' cannot be drawn: %s", w->list[k]->name, svg_failed(s));
    w->failed += text == NULL || write_text_in_turn(path, text, &w->unwritten) != 0;
    svg_free(s);
    region_drop(mark);
}

static int run(const struct call *call)
{
    struct arguments a = {0};
    parse_arguments(call, &a.asked);
    if (!all_match(call->reg, &a.asked.patterns, FIGURES))
        return EXIT_USAGE;
    if (a.out == NULL) {
        a.out = ".";
        if (!a.list && output_promise_folder("out", a.out) != EXIT_AS_EXPECTED)
            return EXIT_USAGE;
    }
    int count;
    const figure **list = matching_figures(call->reg, &a.asked.patterns, &count);
    struct work w = {.folder = a.out, .list = list};
    if (a.list)
        for (int k = 0; k < count; k++)
            puts(list[k]->name);
    else
        cagd_in_parallel(a.asked.jobs, count, draw, &w);
    free(list);
    if (w.failed > 0)
        return EXIT_INTERNAL;
    if (!a.list)
        printf("%d figures in %s\n", count, a.out);
    return EXIT_AS_EXPECTED;
}

static const struct argp_option options[] = {{"out", 'o', "DIR", 0, "Folder to write to (default: the current one)", 0},
                                             {"list", 'l', 0, 0, "Only print the names", 0},
                                             {0}};

const struct command command_figures = {
    .name = "figures",
    .summary = "write the SVG figures",
    .example = "  cagd figures --out pictures      draw\n",
    .usage = "[PATTERN...]",
    .text = "Draws the figures as SVG, from exact values: the same bytes on every machine.\n\n"
            "Examples:\n"
            "  cagd figures --out pictures\n"
            "  cagd figures --list\n"
            "  cagd figures 'envelope*'\n",
    .arguments = FIGURE_NAMES,
    .shared = TAKES_JOBS,
    .options = options,
    .parse = parse,
    .run = run,
};
