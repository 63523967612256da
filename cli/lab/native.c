/* native.c -- the programs cagd-run-sanitized and cagd-run-initialised: an answer in binary64 under sanitizers, called by the driver of its
 * lab.
 *
 *     cagd-run-sanitized OBJECT JOBS END
 *
 * OBJECT has the driver and the answer, compiled for the sanitizers of clang, of whose runtime this program is made once for all. Each line of
 * JOBS is a case and its inputs, "3 2 p 2 0x1p+0 0x1.8p+1 t 1 0x1p-1"; results go nowhere.  END is printed when all of them came to their end. */
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_INPUTS = 64, MOST_ELEMENTS = 256 };

static struct {
    char name[32];
    long count;
    double x[MOST_ELEMENTS];
} in[MOST_INPUTS];
static int inputs;

/* What the driver calls, as in exact/code/machine.h; there is nothing to decide here. */
void cagd_code_given(int on);
void cagd_code_where(int truth);
void cagd_code_side(int which);
void cagd_code_expect(const char *name, long count, const double *got, const double *wanted);
void cagd_code_output(const char *name, long count, const double *x);
void cagd_code_input(const char *name, long count, double *x);
const char *__asan_default_options(void);
const char *__msan_default_options(void);

void cagd_code_given(int on) { (void)on; }
void cagd_code_where(int truth) { (void)truth; }
void cagd_code_side(int which) { (void)which; }
void cagd_code_expect(const char *name, long count, const double *got, const double *wanted)
{
    (void)name, (void)count, (void)got, (void)wanted;
}

/* It is read, so that what was never written is noticed. */
void cagd_code_output(const char *name, long count, const double *x)
{
    volatile double sum = 0;
    for (long k = 0; k < count; k++)
        sum += x[k];
    (void)name;
}

void cagd_code_input(const char *name, long count, double *x)
{
    for (int k = 0; k < inputs; k++)
        if (strcmp(in[k].name, name) == 0 && in[k].count == count)
            memcpy(x, in[k].x, (size_t)count * sizeof *x);
}

const char *__asan_default_options(void)
{
    return "detect_leaks=0:hard_rss_limit_mb=1024:external_symbolizer_path=" SYMBOLIZER;
}

const char *__msan_default_options(void) { return "external_symbolizer_path=" SYMBOLIZER; }

static int read_inputs(FILE *jobs)
{
    for (int k = 0; k < inputs; k++) {
        if (fscanf(jobs, "%31s %ld", in[k].name, &in[k].count) != 2 || in[k].count > MOST_ELEMENTS)
            return 0;
        for (long j = 0; j < in[k].count; j++)
            if (fscanf(jobs, "%la", &in[k].x[j]) != 1)
                return 0;
    }
    return 1;
}

int main(int argc, char **argv)
{
    enum { NOT_RUN = 9 };
    FILE *jobs = argc == 4 ? fopen(argv[2], "r") : NULL;
    void *object = jobs != NULL ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
    void (*const *table)(void) = object != NULL ? (void (*const *)(void))dlsym(object, "lab_table") : NULL;
    if (jobs != NULL && object == NULL)
        fprintf(stderr, "%s\n", dlerror()); /* a function that the answer does not have */
    if (table == NULL)
        return NOT_RUN;
    for (int which; fscanf(jobs, "%d %d", &which, &inputs) == 2;) {
        if (inputs > MOST_INPUTS || !read_inputs(jobs))
            return NOT_RUN;
        table[which]();
    }
    fflush(NULL);
    printf("\n%s\n", argv[3]);
    fflush(stdout);
    _Exit(0);
}
