/* run.c -- see run.h.  The child shares the outcome with its parent, and nothing else. */
#include "exact/code/objects.h"
#include "exact/code/orders.h"
#include "exact/code/process.h"
#include "exact/code/stores.h"
#include "exact/code/value.h"
#include "exact/number/recorder.h"
#include "exact/record/trace.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { ROOM = 1 << 26, USUAL_VALUES = 1 << 23, USUAL_BITS = 1 << 20, USUAL_SECONDS = 60, USUAL_MEGABYTES = 4096 };
enum { SIGNAL_STACK = 1 << 16, FIELD_BITS = 192, MOST_NODES = 200000 };

/* The object, open: it is loaded in the child, where what its constructors compute is ours already. */
struct cagd_code_program {
    int file;
};
static int loaded_from = -1;

int cagd_code_descriptor(void) { return loaded_from; }

struct cagd_code_program *cagd_code_load(const char *path, size_t room, char message[])
{
    struct cagd_code_program *p = malloc(sizeof *p);
    int file = p != NULL ? open(path, O_RDONLY | O_CLOEXEC) : -1;
    if (file < 0) {
        snprintf(message, room, "%s: %s", path, p != NULL ? strerror(errno) : "no memory");
        free(p);
        return NULL;
    }
    p->file = file;
    return p;
}

void cagd_code_unload(struct cagd_code_program *p)
{
    if (p != NULL)
        close(p->file);
    free(p);
}

/* ---- the driver's side -------------------------------------------------------------------------------- */

void cagd_code_input(const char *name, long count, double *x)
{
    const struct cagd_code_job *job = cagd_code_machine.job;
    for (int k = 0; k < job->inputs; k++) {
        const struct cagd_code_input *in = &job->input[k];
        if (strcmp(in->name, name) != 0 || (in->count > 0 ? in->count : 1) != count)
            continue;
        for (int j = 0; j < count; j++) {
            cagd_num_q value = cagd_from_string_q(in->value[j]);
            if (cagd_region_faults != 0)
                cagd_code_stop(CAGD_CODE_REFUSED, "\"%s\" is no number", in->value[j]);
            cagd_code_value v = cagd_code_constant(value);
            if (job->numbers == CAGD_CODE_FIELD && in->variable) {
                char full[64];
                if (in->count > 0)
                    snprintf(full, sizeof full, "%s[%d]", name, in->like != NULL ? in->like[j] : j);
                else
                    snprintf(full, sizeof full, "%s", name);
                v = cagd_code_variable(full, value);
            } else if (job->numbers == CAGD_CODE_ROUNDING) {
                v = cagd_code_constant(cagd_from_double_q(v.d)); /* what the code is given is a binary64 */
            }
            x[j] = cagd_code_number(v);
        }
        return;
    }
    cagd_code_stop(CAGD_CODE_REFUSED, "the harness has no input %s of %ld", name, count);
}

void cagd_code_given(int on) { cagd_code_machine.given = on; }

void cagd_code_where(int truth)
{
    if (!truth)
        cagd_code_stop(CAGD_CODE_OUTSIDE, "a precondition is not true");
}

/* By how many ulps of the exact value v the binary64 d is wrong. */
static double ulps_of(cagd_code_value v, double d)
{
    double exact = cagd_code_real(v), error;
    int exponent;
    if (v.q.at != NULL && isfinite(d))
        error = cagd_to_double_q(cagd_sub_q(cagd_from_double_q(d), v.q));
    else if (isfinite(d)) /* the middle of an interval of at least 128 bits */
        error = cagd_code_real(cagd_code_enclosed(cagd_sub_i(cagd_from_double_i(d), v.i)));
    else
        error = d;
    frexp(exact, &exponent);
    return exact == 0 ? (error == 0 ? 0 : HUGE_VAL) : fabs(error) / ldexp(1, exponent - 53);
}

/* The error, what it is in other orders, and the line with its largest share. */
static void tell_rounding(struct cagd_code_result *r, cagd_code_value v)
{
    r->computed = v.d;
    r->ulps = ulps_of(v, v.d);
    for (int k = 0; k < CAGD_CODE_ORDERS; k++)
        r->in_order[k] = ulps_of(v, cagd_code_in_order(v, (enum cagd_code_order)k));
    double sum = 0, most = 0;
    const struct cagd_code_place *worst = NULL;
    for (int k = 0; k < v.shares; k++) {
        sum += fabs(v.share[k].amount);
        if (fabs(v.share[k].amount) > most)
            most = fabs(v.share[k].amount), worst = v.share[k].place;
    }
    if (worst != NULL && isfinite(sum)) {
        char line[400];
        snprintf(line, sizeof line, "%s:%d", worst->file, (int)worst->line);
        r->worst_line = cagd_code_keep(line);
        r->worst_part = most / sum;
    }
}

/* What nobody reads is not told. */
static const char *told_function(cagd_code_value v)
{
    enum { MOST_WORDS = 20000 };
    if (v.f.at != NULL && cagd_words_f(v.f) > MOST_WORDS)
        return "(a long expression)";
    return cagd_code_keep(cagd_code_field_text(v));
}

/* A result, "left[2]" or "R"; that nothing was put into it has no line of the code. */
static struct cagd_code_result *tell(const char *name, long count, long index, double x)
{
    struct cagd_code_result **last = &cagd_code_machine.outcome->results;
    char full[200];
    while (*last != NULL)
        last = &(*last)->next;
    if (count > 1)
        snprintf(full, sizeof full, "%s[%ld]", name, index);
    else
        snprintf(full, sizeof full, "%s", name);
    if (!cagd_code_was_computed(x)) {
        cagd_code_at = NULL;
        cagd_code_stop(CAGD_CODE_REFUSED, "%s was never computed", full);
    }
    cagd_code_value got = cagd_code_value_of(x);
    struct cagd_code_result *r = cagd_code_room(sizeof *r);
    *r = (struct cagd_code_result){.name = cagd_code_keep(full), .got = cagd_code_keep(cagd_code_text(got))};
    if (cagd_code_machine.job->numbers == CAGD_CODE_FIELD)
        r->got_field = told_function(got);
    if (cagd_code_machine.job->numbers == CAGD_CODE_ROUNDING && !got.special)
        tell_rounding(r, got);
    *last = r;
    return r;
}

void cagd_code_output(const char *name, long count, const double *x)
{
    for (long k = 0; k < count; k++)
        tell(name, count, k, x[k]);
}

static enum cagd_code_answer same(cagd_code_value a, cagd_code_value b)
{
    if (a.special || b.special)
        return a.special && b.special && (a.d == b.d || (isnan(a.d) && isnan(b.d))) ? CAGD_CODE_EQUAL
                                                                                    : CAGD_CODE_DIFFERENT;
    if (cagd_code_machine.job->numbers == CAGD_CODE_FIELD) {
        cagd_num_f difference = cagd_sub_f(cagd_code_function(a), cagd_code_function(b));
        cagd_code_check_faults();
        cagd_trace_pause();
        int vanishes = cagd_code_vanishes_here(difference);
        cagd_trace_resume();
        if (vanishes)
            return CAGD_CODE_EQUAL;
    }
    if (a.q.at != NULL && b.q.at != NULL && cagd_code_machine.job->numbers != CAGD_CODE_INTERVAL) {
        if (!cagd_equal_q(a.q, b.q))
            return CAGD_CODE_DIFFERENT;
        return a.f.at != NULL || b.f.at != NULL ? CAGD_CODE_UNKNOWN : CAGD_CODE_EQUAL;
    }
    int sign = cagd_sign_i(cagd_sub_i(cagd_code_interval(a), cagd_code_interval(b)));
    return sign != 0 ? CAGD_CODE_DIFFERENT : CAGD_CODE_UNKNOWN;
}

struct cagd_code_result *cagd_code_expect_one(const char *name, long count, long index, double got, double wanted)
{
    struct cagd_code_result *r = tell(name, count, index, got);
    cagd_code_value a = cagd_code_value_of(got), b = cagd_code_value_of(wanted);
    r->wanted = cagd_code_keep(cagd_code_text(b));
    if (r->got_field != NULL)
        r->wanted_field = told_function(b);
    r->same = same(a, b);
    if (r->same == CAGD_CODE_EQUAL && cagd_trace_noting() && !a.special)
        cagd_trace_same(cagd_node_of_f(cagd_code_function(a)), cagd_node_of_f(cagd_code_function(b)), 1);
    return r;
}

void cagd_code_expect(const char *name, long count, const double *got, const double *wanted)
{
    for (long k = 0; k < count; k++)
        cagd_code_expect_one(name, count, k, got[k], wanted[k]);
}

/* ---- the process ------------------------------------------------------------------------------------- */

/* Who waits uses no processor, and is ended after a time; who works is waited for, however busy the machine is. */
static long waited_seconds;
static double worked_before;

static int works(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    double worked = (double)t.tv_sec + 1e-9 * (double)t.tv_nsec, since = worked - worked_before;
    worked_before = worked;
    return since > 0.01 * (double)waited_seconds;
}

/* What can be done in a handler: the message and the place, copied. */
static void on_signal(int number)
{
    if (number == SIGALRM && works()) {
        alarm((unsigned)waited_seconds);
        return;
    }
    struct cagd_code_outcome *o = cagd_code_machine.outcome;
    const char *what = number == SIGXCPU || number == SIGALRM ? "more time than is allowed"
                       : number == SIGABRT                    ? "the program was aborted; no memory, or abort()"
                       : number == SIGFPE                     ? "an integer was divided by zero"
                                          : "memory was used that is not there, or not the program's";
    o->end = number == SIGXCPU || number == SIGALRM ? CAGD_CODE_BOUND : CAGD_CODE_CRASHED;
    strncpy(o->message, what, sizeof o->message - 1);
    if (cagd_code_at != NULL) {
        strncpy(o->file, cagd_code_at->file, sizeof o->file - 1);
        strncpy(o->function, cagd_code_at->function, sizeof o->function - 1);
        o->line = cagd_code_at->line;
    }
    _exit(0);
}

void cagd_code_bound_waiting(const struct cagd_code_job *job)
{
    waited_seconds = job->most_seconds * 4;
    works();
    alarm((unsigned)waited_seconds);
}

static void bound_process(const struct cagd_code_job *job)
{
    static char stack[SIGNAL_STACK];
    static const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGILL, SIGXCPU, SIGALRM};
    stack_t alternate = {.ss_sp = stack, .ss_size = sizeof stack};
    struct sigaction action = {.sa_handler = on_signal, .sa_flags = SA_ONSTACK};
    struct rlimit limit = {(rlim_t)job->most_seconds, (rlim_t)job->most_seconds + 5};
    sigaltstack(&alternate, NULL);
    for (size_t k = 0; k < sizeof signals / sizeof *signals; k++)
        sigaction(signals[k], &action, NULL);
    setrlimit(RLIMIT_CPU, &limit);
    cagd_code_bound_waiting(job);
    limit.rlim_cur = limit.rlim_max = 0;
    setrlimit(RLIMIT_CORE, &limit);
#ifndef __SANITIZE_ADDRESS__ /* which takes terabytes of addresses for itself */
    limit.rlim_cur = limit.rlim_max = (rlim_t)job->most_megabytes << 20;
    setrlimit(RLIMIT_DATA, &limit);
#endif
}

/* Of roots and angles nothing is certified: what they are is not among the operations. */
static void keep_trace(void)
{
    const char *text[3] = {cagd_trace_inputs(), cagd_trace_nodes(), cagd_trace_steps()};
    for (int k = 0; k < 3 && text[0] != NULL && text[1] != NULL && text[2] != NULL && !cagd_code_has_roots(); k++)
        cagd_code_machine.outcome->trace[k] = cagd_code_keep(text[k]);
}

struct cagd_code_job cagd_code_bounded(const struct cagd_code_job *job)
{
    struct cagd_code_job bounded = *job;
    bounded.most_values = job->most_values > 0 ? job->most_values : USUAL_VALUES;
    bounded.most_bits = job->most_bits > 0 ? job->most_bits : USUAL_BITS;
    bounded.most_seconds = job->most_seconds > 0 ? job->most_seconds : USUAL_SECONDS;
    bounded.most_megabytes = job->most_megabytes > 0 ? job->most_megabytes : USUAL_MEGABYTES;
    return bounded;
}

void cagd_code_outcome_begin(struct cagd_code_outcome *o)
{
    *o = (struct cagd_code_outcome){.end = CAGD_CODE_CRASHED, .message = "the program ended its process"};
}

struct cagd_code_outcome *cagd_code_shared_room(size_t *bytes)
{
    *bytes = ROOM;
    void *room = mmap(NULL, ROOM, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED)
        return NULL;
    cagd_code_outcome_begin(room);
    return room;
}

void cagd_code_tell_into(struct cagd_code_outcome *o, size_t bytes, const struct cagd_code_job *job)
{
    cagd_code_machine = (struct cagd_code_machine){
        .job = job, .outcome = o, .free_room = (char *)(o + 1), .end_of_room = (char *)o + bytes};
    cagd_code_machine.free_room += 16 - (uintptr_t)cagd_code_machine.free_room % 16;
}

void (*cagd_code_begin(const struct cagd_code_program *p, const struct cagd_code_job *job))(void)
{
    void (*entry)(void);
    char path[40];
    if (!job->print)
        dup2(STDERR_FILENO, STDOUT_FILENO);
    bound_process(job);
    cagd_without_memory(abort);
    cagd_region_set_precision(FIELD_BITS);
    if (job->numbers == CAGD_CODE_FIELD) {
        int variables = 0;
        for (int k = 0; k < job->inputs; k++)
            if (job->input[k].variable)
                variables += job->input[k].count > 0 ? job->input[k].count : 1;
        enum { FOR_ROOTS = 8 };
        variables += FOR_ROOTS;
        cagd_field_open(variables < CAGD_FIELD_MAX_VARIABLES ? variables : CAGD_FIELD_MAX_VARIABLES);
    }
    cagd_code_values_open();
    loaded_from = p->file;
    if (job->before != NULL)
        job->before();
    if (job->certify && job->numbers == CAGD_CODE_FIELD) {
        cagd_trace_open(MOST_NODES);
        cagd_trace_values(cagd_code_value_at_point);
    }
    snprintf(path, sizeof path, "/proc/self/fd/%d", p->file);
    cagd_code_machine.object = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (cagd_code_machine.object == NULL)
        cagd_code_stop(CAGD_CODE_REFUSED, "%s", dlerror());
    void *symbol = dlsym(cagd_code_machine.object, job->entry);
    if (symbol == NULL)
        cagd_code_stop(CAGD_CODE_REFUSED, "there is no function %s", job->entry);
    memcpy(&entry, &symbol, sizeof entry);
    cagd_code_watch_globals();
    return entry;
}

void cagd_code_finish(const struct cagd_code_job *job)
{
    cagd_code_compare_globals();
    keep_trace();
    if (job->numbers == CAGD_CODE_RATIONAL)
        cagd_code_tell_apart();
    fflush(NULL);
    cagd_code_machine.outcome->end = CAGD_CODE_FINISHED;
}

struct cagd_code_outcome *cagd_code_run(const struct cagd_code_program *p, const struct cagd_code_job *job)
{
    struct cagd_code_job bounded = cagd_code_bounded(job);
    size_t bytes;
    struct cagd_code_outcome *o = cagd_code_shared_room(&bytes);
    if (o == NULL)
        return NULL;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        cagd_code_tell_into(o, bytes, &bounded);
        void (*entry)(void) = cagd_code_begin(p, &bounded);
        entry();
        cagd_code_finish(&bounded);
        _exit(0);
    }
    int status;
    if (child < 0) {
        strcpy(o->message, "no process for it");
        return o;
    }
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            break;
    return o;
}

void cagd_code_outcome_free(struct cagd_code_outcome *o)
{
    if (o != NULL)
        munmap(o, ROOM);
}
