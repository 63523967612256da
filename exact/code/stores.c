/* stores.c -- see stores.h. */
#include "exact/code/stores.h"

#include "exact/code/value.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_STORES = 1 << 16 };

/* The number, as the code has it; name: of the variable, or of that which points to it, "" where there is none. */
struct store {
    double x;
    const char *name;
    const struct cagd_code_place *place;
    int side; /* 1: of the calls; 2: of what is expected */
};
static struct store *stores;
static long count;
static int side;

void cagd_code_side(int which) { side = which; }

void cagd_code_stored(double x, const char *name)
{
    if (side == 0 || count == MOST_STORES ||
        !cagd_code_was_computed(x)) /* clang fills a variable before its first value */
        return;
    if (stores == NULL && (stores = malloc(MOST_STORES * sizeof *stores)) == NULL)
        cagd_code_stop(CAGD_CODE_BOUND, "no memory to note what is stored");
    stores[count++] = (struct store){x, name, cagd_code_at, side};
}

/* "curves.c:12", also where the path is longer. */
static int is_at(const struct cagd_code_place *place, const char *asked)
{
    char here[500];
    snprintf(here, sizeof here, "%s:%d", place->file, (int)place->line);
    size_t n = strlen(here), m = strlen(asked);
    return n >= m && strcmp(here + n - m, asked) == 0 && (n == m || here[n - m - 1] == '/');
}

void cagd_code_known(const char *place, long wanted_count, const double *wanted)
{
    long met = 0;
    side = 0;
    for (long k = 0; k < count && met < wanted_count; k++) {
        if (stores[k].side != 1 || !is_at(stores[k].place, place))
            continue;
        struct cagd_code_result *r = cagd_code_expect_one(place, wanted_count, met, stores[k].x, wanted[met]);
        r->stored = k + 1;
        r->variable = cagd_code_keep(stores[k].name);
        met++;
    }
    if (count == MOST_STORES && met < wanted_count)
        cagd_code_stop(CAGD_CODE_BOUND, "more than %d numbers are put into variables before %s has its %ld",
                       MOST_STORES, place, wanted_count);
    if (met < wanted_count)
        cagd_code_stop(CAGD_CODE_REFUSED, "%s puts %ld numbers into variables on this way; %ld are known", place, met,
                       wanted_count);
}

static int differ(double a, double b)
{
    cagd_code_value x = cagd_code_value_of(a), y = cagd_code_value_of(b);
    if (x.special || y.special)
        return memcmp(&x.d, &y.d, sizeof x.d) != 0;
    return x.q.at != NULL && y.q.at != NULL && !cagd_equal_q(x.q, y.q);
}

static const char *told_place(const struct store *s)
{
    char text[500];
    const char *slash = strrchr(s->place->file, '/');
    snprintf(text, sizeof text, "%s:%d", slash != NULL ? slash + 1 : s->place->file, (int)s->place->line);
    return cagd_code_keep(text);
}

void cagd_code_tell_apart(void)
{
    for (long k = 0; k < count; k++) {
        const struct store *here = &stores[k];
        long time = 0, j = 0;
        if (here->side != 1 || here->name[0] == 0)
            continue;
        for (long i = 0; i <= k; i++)
            time += stores[i].side == 1 && strcmp(stores[i].name, here->name) == 0;
        for (long met = 0; j < count; j++)
            if (stores[j].side == 2 && strcmp(stores[j].name, here->name) == 0 && ++met == time)
                break;
        if (j == count || !differ(here->x, stores[j].x))
            continue;
        struct cagd_code_apart *a = cagd_code_room(sizeof *a);
        *a = (struct cagd_code_apart){cagd_code_keep(here->name),
                                      time,
                                      told_place(here),
                                      told_place(&stores[j]),
                                      cagd_code_keep(cagd_code_text(cagd_code_value_of(here->x))),
                                      cagd_code_keep(cagd_code_text(cagd_code_value_of(stores[j].x)))};
        cagd_code_machine.outcome->apart = a;
        return;
    }
}
