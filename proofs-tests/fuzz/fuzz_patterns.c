/* fuzz_patterns.c -- patterns and ids against a small register: the lists are in its order, and hold what a star holds at most. */
#include "proofs-tests/fuzz/file.h"

#include "cli/select.h"

#include <string.h>

static const claim claims[] = {{.name = "elevation_keeps_curve", .chapter = "bezier"},
                               {.name = "points_are_on_a_circle", .chapter = "rational-bezier"},
                               {.name = "knots", .chapter = "nurbs"},
                               {0}};
static const statement_link first[] = {{.role = HOLDS_BY, .claim = "knots"}, {.role = NEEDS, .text = "t > 0"}, {0}};
static const statement_link second[] = {{.role = REFUTED_BY, .claim = "elevation_keeps_curve"}, {0}};
static const statement statements[] = {{.id = "wang-ch3:3.2.8", .title = "One", .links = first},
                                       {.id = "slides-ch4:table [x]", .title = "Two", .links = second},
                                       {0}};
static const figure figures[] = {{.name = "circle"}, {0}};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > 512)
        return -1;
    char text[513], *words[8];
    memcpy(text, data, size);
    text[size] = '\0';
    struct patterns p = {words, 0};
    for (char *word = strtok(text, "\n"); word != NULL && p.count < 8; word = strtok(NULL, "\n"))
        words[p.count++] = word;
    const cagd_register r = {.claims = claims, .statements = statements, .figures = figures};
    int count, of_statements, figures_found, named;
    const claim **list = matching_claims(&r, &p, &count);
    for (int k = 1; k < count; k++)
        if (list[k] <= list[k - 1])
            abort();
    const statement **found = matching_statements(&r, &p, &of_statements);
    const figure **drawn = matching_figures(&r, &p, &figures_found);
    const claim **of_them = claims_of(&r, found, of_statements, &named);
    if (count > 3 || of_statements > 2 || figures_found > 1 || named > 3)
        abort();
    for (int kind = CLAIMS; kind <= FIGURES; kind++)
        all_match(&r, &p, (enum kind_of_name)kind);
    free(list), free(found), free(drawn), free(of_them);
    return 0;
}
