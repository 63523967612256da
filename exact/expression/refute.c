#include "exact/expression/refute.h"

#include "exact/expression/enclosed.h"
#include "exact/expression/example.h"
#include "exact/expression/irrational.h"
#include "exact/words.h"

#include <stdlib.h>
#include <string.h>

/* Whether both are names of one letter with an index, and how far the first index is behind the second: u_10 and u_2, 8. */
static int is_one_letter(const char *a, const char *b, long *distance)
{
    size_t n = strcspn(a, "_");
    if (a[n] == '\0' || strncmp(a, b, n + 1) != 0)
        return 0;
    a += n + 1, b += n + 1;
    *distance = strtol(a + (*a == '{'), NULL, 10) - strtol(b + (*b == '{'), NULL, 10);
    return 1;
}

/* One more name with its value; those of one letter stand together, by their indices. */
static void give(cagd_finding *f, cagd_given one)
{
    int place = f->given, is_placed = 0;
    long distance;
    for (int k = 0; k < f->given; k++)
        if (is_one_letter(f->example[k].name, one.name, &distance) && (distance < 0 || !is_placed))
            place = distance < 0 ? k + 1 : k, is_placed = 1;
    for (int k = f->given++; k > place; k--)
        f->example[k] = f->example[k - 1];
    f->example[place] = one;
}

/* All names of the page with their values; a name with root[m] has that root instead, with no `root` none has. */
void cagd_give_all(cagd_finding *f, const cagd_context *c, const num_q value[], const struct cagd_root *const root[])
{
    f->has_example = 1;
    for (int m = 0; m < c->count; m++) {
        const cagd_binding *b = &c->binding[m];
        const struct cagd_root *r = root != NULL && root[m] != NULL ? root[m]
                                    : b->has_root && b->unknown     ? &b->root
                                                                    : NULL;
        if (b->key[0] != '\0' && !b->hidden)
            give(f, (cagd_given){b->key, b->unknown || b->solved ? value[m] : b->value.q,
                                 r != NULL ? cagd_told_root(*r) : NULL});
    }
}

/* Refuted by a number that is no rational one. */
static int refuted_at_root(cagd_finding *f, const cagd_context *c, const cagd_tree *t, int k)
{
    cagd_irrational_example *e = region_bytes(sizeof *e);
    if (e == NULL || !cagd_find_irrational_example(c, t, k, e))
        return 0;
    const struct cagd_root *root[CAGD_MOST_UNKNOWNS] = {NULL};
    if (e->of >= 0)
        root[e->of] = &e->root;
    f->has_root = 1, f->order = e->order;
    cagd_give_all(f, c, e->value, root);
    return 1;
}

/* Refuted by numbers that are angles, too. */
static int refuted_by_enclosure(cagd_finding *f, const cagd_context *c, const cagd_tree *t, int k)
{
    cagd_enclosed_example *e = region_bytes(sizeof *e);
    cagd_context *told = region_bytes(sizeof *told);
    if (e == NULL || told == NULL || !cagd_find_enclosed_example(c, t, k, e))
        return 0;
    *told = *c;
    for (int m = 0; m < told->count; m++)
        told->binding[m].hidden |= e->is_enclosed[m];
    f->has_root = f->is_enclosed = 1, f->order = e->order, f->near_left = e->left, f->near_right = e->right;
    cagd_give_all(f, told, e->value, NULL);
    return 1;
}

/* a relation b is refuted: by small numbers that are looked for, or by those that are given. */
cagd_answer cagd_refuted_at(cagd_run *r, cagd_context *c, const cagd_tree *t, int k, const num_q at[])
{
    cagd_finding *f = r->out;
    if (f->has_example)
        return CAGD_FAILS;
    if (k >= 0)
        f->relation = t->relation[k], f->of_left = t->at[k], f->of_right = t->at[k + 1];
    num_q value[CAGD_MOST_UNKNOWNS];
    int found = cagd_find_example(c, t, k, value, &f->left, &f->right);
    if (!found && at != NULL) {
        memcpy(value, at, sizeof value);
        found = cagd_is_example(c, t, k, value, &f->left, &f->right);
    }
    if (!found && (refuted_at_root(f, c, t, k) || refuted_by_enclosure(f, c, t, k)))
        return CAGD_FAILS;
    if (!found)
        return cagd_note_undecided(r, c, "no numbers were found for which it is false, though it is no identity");
    cagd_give_all(f, c, value, NULL);
    return CAGD_FAILS;
}

/* The same, the point having coordinates of some names. */
cagd_answer cagd_refuted(cagd_run *r, cagd_context *c, const cagd_tree *t, int k, const num_q point[], const int of[],
                         int count)
{
    num_q at[CAGD_MOST_UNKNOWNS] = {0};
    for (int m = 0; point != NULL && m < count; m++)
        at[of[m]] = point[m];
    return cagd_refuted_at(r, c, t, k, point != NULL ? at : NULL);
}
