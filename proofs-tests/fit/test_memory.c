/* test_memory.c -- a fit without memory: the k-th allocation fails, for k = 1, 2, 3, ... until the fit does without
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

struct kind {
    const char *name;
    int dim, sigma;
    void (*change)(cagd_fit_options *o);
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
static const struct kind kinds[] = {{"usual", 2, 0, as_usual},
                                    {"all free", 2, 1, all_free},
                                    {"spline", 2, 0, spline},
                                    {"two starts", 2, 1, two_starts},
                                    {"space", 3, 1, cubic_in_space},
                                    {"robust", 2, 0, robust},
                                    {"unordered", 2, 0, unordered},
                                    {"feet alone", 2, 1, feet_alone},
                                    {"measured ends", 2, 1, measured_ends},
                                    {"in order", 2, 1, in_order},
                                    {"ends in any order", 2, 0, ends_in_any_order}};

static cagd_status fit(const struct kind *kind, cagd_fit_result **result)
{
    cagd_fit_data data = arc(kind->dim, kind->sigma);
    cagd_fit_options options = options_with_exact_ends();
    kind->change(&options);
    for (int c = 0; c < kind->dim && options.monotone; c++) { /* two points change places, and share a foot */
        const double at = points[5 * kind->dim + c];
        points[5 * kind->dim + c] = points[6 * kind->dim + c];
        points[6 * kind->dim + c] = at;
    }
    return cagd_fit(&data, &options, result, NULL);
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
    if (fit(kind, &result) != CAGD_OK) /* what libraries allocate once is there afterwards */
        return complain(kind, 0, "no fit");
    long k = 1, count[LOST + 1] = {0};
    while (count[NOT_REACHED] == 0) { /* all of the first ones, then fewer and fewer */
        count[trial(kind, k, k + 1)]++;
        count[trial(kind, k, LONG_MAX)]++;
        k += 1 + k / MANY;
    }
    int wrong = count[WRONG] > 0;
    if (fit(kind, &again) != CAGD_OK)
        return complain(kind, 0, "no fit any more");
    if (memcmp(result->value, again->value, (size_t)result->unknowns * sizeof(double)) != 0)
        wrong |= complain(kind, 0, "not the same fit afterwards");
    cagd_fit_free(result);
    cagd_fit_free(again);
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
