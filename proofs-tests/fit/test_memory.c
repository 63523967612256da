/* test_memory.c -- a fit, a choice and what cures a fit, without memory: the k-th allocation fails, for k = 1, 2, 3, ... until the fit does without
 * so many; alone, and with all later ones.
 *
 * The linker puts the functions below in the place of malloc, aligned_alloc, calloc, realloc and free wherever the fit calls them,
 * in C++ and in Ceres too; and test_memory_new.cpp is the operator new of all that is C++, which throws std::bad_alloc.  Asked is:
 * the status CAGD_NO_MEMORY without a result, every block given back, and afterwards the same fit as before.
 *
 * Ceres keeps its times in destructors that take memory, where C++ lets no exception out: a failure there ends the program, whoever
 * may have called.  So every trial is a process of its own, and such ends are counted; an exception that leaves the library ends a
 * program in another way, and is an error. */
#include "core/fit/cagd_fit.h"
#include "proofs-tests/fit/options.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---- memory ----------------------------------------------------------------------------------------- */

/* What the linker makes of calls of malloc, ..., and of their own names. */
void *__wrap_malloc(size_t size);
void *__wrap_aligned_alloc(size_t alignment, size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *block, size_t size);
void __wrap_free(void *block);
void *__real_malloc(size_t size);
void *__real_aligned_alloc(size_t alignment, size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *block, size_t size);
void __real_free(void *block);

/* The blocks that are held, by address, in a list; there are few at a time. */
enum { ROOM = 1 << 16 };
static const void *held[ROOM];
static long asked, fail_at, fail_until, refused; /* fail_at 0: none */
static int blocks;

static void *keep(void *block)
{
    if (block != NULL && blocks == ROOM)
        abort();
    if (block != NULL)
        held[blocks++] = block;
    return block;
}

static void forget(const void *block)
{
    int i = blocks - 1;
    while (i >= 0 && held[i] != block)
        i--;
    if (i >= 0)
        held[i] = held[--blocks];
}

/* Whether the next allocation is to fail. */
int refuses(void);
int refuses(void)
{
    asked++;
    int now = fail_at > 0 && asked >= fail_at && asked < fail_until;
    refused += now;
    return now;
}

void *__wrap_malloc(size_t size) { return refuses() ? NULL : keep(__real_malloc(size)); }
void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    return refuses() ? NULL : keep(__real_aligned_alloc(alignment, size));
}
void *__wrap_calloc(size_t count, size_t size) { return refuses() ? NULL : keep(__real_calloc(count, size)); }
void *__wrap_realloc(void *block, size_t size)
{
    if (refuses())
        return NULL;
    forget(block);
    void *moved = __real_realloc(block, size);
    if (moved == NULL)
        abort();
    return keep(moved);
}
void __wrap_free(void *block)
{
    forget(block);
    __real_free(block);
}

/* ---- fits ------------------------------------------------------------------------------------------- */

enum { POINTS = 14, MOST_DIM = 3 };
static double points[POINTS * MOST_DIM], sigma[POINTS];

/* Points of an arc, off it by a little that no random numbers are needed for. */
static cagd_fit_data arc(int dim, int with_sigma)
{
    for (int i = 0; i < POINTS; i++) {
        double a = 2.4 * i / (POINTS - 1), off = 0.01 * sin(7.0 * i * i);
        double at[MOST_DIM] = {(2 + off) * cos(a), (1 + off) * sin(a), a / 3 - off};
        memcpy(points + i * dim, at, (size_t)dim * sizeof(double));
        sigma[i] = 0.01 + 0.001 * (i % 3);
    }
    return (cagd_fit_data){POINTS, dim, points, with_sigma ? sigma : NULL};
}

static const double start_knots[] = {0, 0, 0, 1, 1, 1}, start_points[] = {2, 0, 1, 1, -1.5, 0.7},
                    start_weights[] = {1, 0.7, 1};
static const cagd_spline start = {2, 3, 2, start_knots, start_points, start_weights};

/* What is asked: a fit, a choice, or what cures a fit that was made before. */
enum asked { FIT, CHOICE, CURES };

struct kind {
    const char *name;
    int dim, sigma;
    void (*change)(cagd_fit_options *o);
    enum asked asked;
    int coarse; /* of the first allocations fewer by this factor: these take long */
};
static void as_usual(cagd_fit_options *o) { (void)o; }
static void all_free(cagd_fit_options *o)
{
    o->free = CAGD_FIT_WEIGHTS | CAGD_FIT_INNER_POINTS | CAGD_FIT_END_POINTS;
    o->initial = &start;
}
static void spline(cagd_fit_options *o)
{
    o->count = 4;
    o->free = CAGD_FIT_INNER_POINTS;
}
static void two_starts(cagd_fit_options *o) { o->starts = 2; }
static void cubic_in_space(cagd_fit_options *o) { o->degree = 3; }
static void robust(cagd_fit_options *o)
{
    o->loss = CAGD_FIT_CAUCHY;
    o->loss_scale = 0.02;
    o->weight_low = 0.5;
    o->weight_high = 2;
}
static void unordered(cagd_fit_options *o) { o->unordered = 1; }
static void measured_ends(cagd_fit_options *o)
{
    o->free |= CAGD_FIT_END_POINTS;
    o->ends = CAGD_FIT_ENDS_MEASURED;
}
static void ends_in_any_order(cagd_fit_options *o)
{
    measured_ends(o);
    o->unordered = 1;
}
static void in_order(cagd_fit_options *o) { o->monotone = 1; }
static void feet_alone(cagd_fit_options *o)
{
    o->free = 0;
    o->initial = &start;
}
static void too_simple(cagd_fit_options *o)
{
    measured_ends(o);
    o->free &= ~CAGD_FIT_WEIGHTS;
}
static void goes_back(cagd_fit_options *o)
{
    measured_ends(o);
    o->free &= ~CAGD_FIT_WEIGHTS;
}
static const struct kind kinds[] = {{"usual", 2, 0, as_usual, FIT, 1},
                                    {"all free", 2, 1, all_free, FIT, 1},
                                    {"spline", 2, 0, spline, FIT, 1},
                                    {"two starts", 2, 1, two_starts, FIT, 1},
                                    {"space", 3, 1, cubic_in_space, FIT, 1},
                                    {"robust", 2, 0, robust, FIT, 1},
                                    {"unordered", 2, 0, unordered, FIT, 1},
                                    {"feet alone", 2, 1, feet_alone, FIT, 1},
                                    {"measured ends", 2, 1, measured_ends, FIT, 1},
                                    {"in order", 2, 1, in_order, FIT, 1},
                                    {"ends in any order", 2, 0, ends_in_any_order, FIT, 1},
                                    {"choice", 2, 0, measured_ends, CHOICE, 8},
                                    {"cures", 2, 0, too_simple, CURES, 8},
                                    {"cures of points that go back", 2, 0, goes_back, CURES, 8}};

/* Two points change places. */
static void swap(int dim, int i, int j)
{
    for (int c = 0; c < dim; c++) {
        const double at = points[i * dim + c];
        points[i * dim + c] = points[j * dim + c];
        points[j * dim + c] = at;
    }
}

static cagd_fit_options options_of(const struct kind *kind)
{
    cagd_fit_options options = options_with_exact_ends();
    kind->change(&options);
    return options;
}

static cagd_fit_data data_of(const struct kind *kind, const cagd_fit_options *options)
{
    cagd_fit_data data = arc(kind->dim, kind->sigma);
    if (options->monotone) /* the two share a foot */
        swap(kind->dim, 5, 6);
    for (int i = 0; i < POINTS && kind->change == too_simple; i++) /* a wave */
        points[i * kind->dim + 1] += 0.5 * sin(1.3 * i);
    if (kind->change == goes_back)
        swap(kind->dim, 3, 9), swap(kind->dim, 4, 10);
    return data;
}

static const cagd_fit_choices as_asked = {.closed = 0, .smooth = 0};
static cagd_fit_result *poor; /* the fit that is to be cured, and what is not good about it */
static cagd_fit_quality poor_quality;
static cagd_fit_cures cures;

/* What the kind asks; *result is NULL of cures. */
static cagd_status fit(const struct kind *kind, cagd_fit_result **result)
{
    const cagd_fit_options options = options_of(kind);
    const cagd_fit_data data = data_of(kind, &options);
    if (kind->asked == FIT)
        return cagd_fit(&data, &options, result, NULL);
    if (kind->asked == CHOICE) {
        const cagd_fit_choices all = cagd_fit_choices_all();
        return cagd_fit_choose(&data, &options, &all, result, NULL);
    }
    *result = NULL;
    return cagd_fit_cures_of(&data, &options, &as_asked, poor, &poor_quality, &cures);
}

/* The fit that is to be cured, where cures are asked for; whether it is there and was not good. */
static int prepare(const struct kind *kind)
{
    const cagd_fit_options options = options_of(kind);
    const cagd_fit_data data = data_of(kind, &options);
    return kind->asked != CURES || (cagd_fit_choose(&data, &options, &as_asked, &poor, NULL) == CAGD_OK &&
                                    cagd_fit_quality_of(&data, &options, poor, &poor_quality) == CAGD_OK &&
                                    (poor_quality.problems != 0 || !cagd_fit_is_minimum(poor)));
}

/* Whether two answers are the same. */
static int are_same(const cagd_fit_result *a, const cagd_fit_result *b)
{
    return a == NULL ? b == NULL : a->unknowns == b->unknowns && memcmp(a->value, b->value, (size_t)a->unknowns * sizeof(double)) == 0;
}

/* 1 and a line where something is wrong. */
static int complain(const struct kind *kind, long k, const char *what)
{
    printf("%s, allocation %ld: %s\n", kind->name, k, what);
    return 1;
}

/* How a trial ends, as the exit code of its process. */
enum ending { GOOD, NOT_REACHED, WRONG, LOST };

/* The allocations from the k-th to the one before `until` fail. */
static enum ending fit_without(const struct kind *kind, long k, long until)
{
    cagd_fit_result *result = (cagd_fit_result *)points; /* which must be changed */
    int before = blocks, wrong = 0;
    asked = refused = 0;
    fail_at = k;
    fail_until = until;
    cagd_status status = fit(kind, &result);
    fail_at = 0;
    if (refused > 0 && (status != CAGD_NO_MEMORY || result != NULL))
        wrong |= complain(kind, k, result != NULL ? "a result" : cagd_status_text(status));
    if (refused == 0 && status != CAGD_OK)
        wrong |= complain(kind, k, cagd_status_text(status));
    if (status == CAGD_OK)
        cagd_fit_free(result);
    if (blocks != before)
        wrong |= complain(kind, k, "blocks are not given back");
    return wrong ? WRONG : refused > 0 ? GOOD : NOT_REACHED;
}

/* The same in a process of its own. */
static enum ending trial(const struct kind *kind, long k, long until)
{
    int status = 0;
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        enum ending ending = fit_without(kind, k, until);
        fflush(stdout);
        _exit((int)ending);
    }
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status)) {
        complain(kind, k, "the program has crashed, or an exception has left the library");
        return WRONG;
    }
    return (enum ending)WEXITSTATUS(status);
}

static int try_kind(const struct kind *kind)
{
    cagd_fit_result *result, *again;
    fail_at = 0;
    if (!prepare(kind))
        return complain(kind, 0, "nothing is to be cured");
    if (fit(kind, &result) != CAGD_OK) /* what libraries allocate once is there afterwards */
        return complain(kind, 0, "no fit");
    if (kind->asked == CURES && cures.count < 2)
        return complain(kind, cures.count, "hardly anything was tried");
    long k = 1, count[LOST + 1] = {0};
    while (count[NOT_REACHED] == 0) { /* all of the first ones, then fewer and fewer */
        count[trial(kind, k, k + 1)]++;
        count[trial(kind, k, LONG_MAX)]++;
        k += 1 + k * kind->coarse / MANY;
    }
    int wrong = count[WRONG] > 0;
    if (fit(kind, &again) != CAGD_OK)
        return complain(kind, 0, "no fit any more");
    if (!are_same(result, again))
        wrong |= complain(kind, 0, "not the same fit afterwards");
    cagd_fit_free(result);
    cagd_fit_free(again);
    cagd_fit_free(poor);
    poor = NULL;
    printf("%-10s %5ld times without memory, of some %ld allocations; %ld times lost by Ceres\n", kind->name,
           count[GOOD], k, count[LOST]);
    if (count[GOOD] < 10 || count[LOST] > count[GOOD])
        wrong |= complain(kind, k, "hardly any allocation was seen");
    return wrong;
}

int main(void)
{
    int wrong = 0;
    cagd_fit_free(NULL);
    for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++)
        wrong += try_kind(&kinds[k]);
    if (blocks != 0)
        wrong += printf("%d blocks are held at the end\n", blocks) > 0;
    return wrong != 0;
}
