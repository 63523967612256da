/* resident.c -- see resident.h.  Parent and child share the outcome and, at the end of its memory, the letter: the values of all inputs, as
 * texts one behind the other.  A byte through a socket says that the letter is written, or that the outcome is; the end of the
 * other side is seen as the end of the stream. */
#include "exact/code/resident.h"

#include "exact/code/objects.h"
#include "exact/code/process.h"
#include "exact/code/value.h"

#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

/* After so many seconds of the processor, or with so many pieces of memory that were not given back, the process is another one. */
enum { LETTER = 1 << 22, MOST_USED_SECONDS = 4, MOST_LEFT = 4096 };

struct cagd_code_resident {
    struct cagd_code_outcome *outcome;
    size_t bytes; /* of the shared memory, with the letter */
    pid_t child;  /* 0: there is none                      */
    int line;
};

static char *letter_of(const struct cagd_code_resident *r) { return (char *)r->outcome + r->bytes - LETTER; }
static int count_of(const struct cagd_code_input *in) { return in->count > 0 ? in->count : 1; }

/* Whether a byte came. */
static int heard(int line)
{
    char byte;
    ssize_t got;
    do
        got = recv(line, &byte, 1, 0);
    while (got < 0 && errno == EINTR);
    return got == 1;
}

static int said(int line) { return send(line, "", 1, MSG_NOSIGNAL) == 1; }

/* ---- the child ----------------------------------------------------------------------------------------------- */

/* The inputs of the job become those of the letter. */
static void read_letter(const char *at, const struct cagd_code_job *job, const char **value)
{
    for (int k = 0; k < job->inputs; k++)
        for (int j = 0; j < count_of(&job->input[k]); j++, at += strlen(at) + 1)
            *value++ = at;
}

/* The runs after this one would know nothing of it. */
static int leaves_nothing(void)
{
    struct rusage used;
    return cagd_code_machine.outcome->kept[0] == 0 && dlsym(cagd_code_machine.object, "cagd_code_is_alone") != NULL &&
           getrusage(RUSAGE_SELF, &used) == 0 && used.ru_utime.tv_sec + used.ru_stime.tv_sec < MOST_USED_SECONDS &&
           cagd_code_memory_count() < MOST_LEFT;
}

/* The bounds on time count from now on. */
static void bound_time(const struct cagd_code_job *job)
{
    struct rusage used;
    struct rlimit limit;
    getrusage(RUSAGE_SELF, &used);
    getrlimit(RLIMIT_CPU, &limit);
    limit.rlim_cur = (rlim_t)(used.ru_utime.tv_sec + used.ru_stime.tv_sec + job->most_seconds);
    setrlimit(RLIMIT_CPU, &limit);
    cagd_code_bound_waiting(job);
}

_Noreturn static void live(const struct cagd_code_resident *r, const struct cagd_code_program *p,
                           struct cagd_code_job job)
{
    int values = 0, at = 0;
    for (int k = 0; k < job.inputs; k++)
        values += count_of(&job.input[k]);
    const char **value = calloc((size_t)values + 1, sizeof *value);
    struct cagd_code_input *input = calloc((size_t)job.inputs + 1, sizeof *input);
    if (value == NULL || input == NULL)
        _exit(0);
    for (int k = 0; k < job.inputs; at += count_of(&input[k++])) {
        input[k] = job.input[k];
        input[k].value = value + at;
    }
    job.input = input;
    cagd_code_tell_into(r->outcome, r->bytes - LETTER, &job);
    void (*entry)(void) = cagd_code_begin(p, &job);
    int stays = cagd_code_memory_count() == 0;
    struct cagd_code_mark mark = cagd_code_values_mark();
    for (;;) {
        read_letter(letter_of(r), &job, value);
        entry();
        alarm(0);
        cagd_code_finish(&job);
        if (!stays || !leaves_nothing() || !said(r->line) || !heard(r->line))
            _exit(0);
        void *object = cagd_code_machine.object;
        cagd_code_tell_into(r->outcome, r->bytes - LETTER, &job);
        cagd_code_machine.object = object;
        cagd_code_machine.entered = 1;
        cagd_code_values_back(&mark);
        bound_time(&job);
    }
}

/* ---- the parent ----------------------------------------------------------------------------------------------- */

static int write_letter(char *at, const struct cagd_code_job *job)
{
    size_t room = LETTER;
    for (int k = 0; k < job->inputs; k++)
        for (int j = 0; j < count_of(&job->input[k]); j++) {
            size_t size = strlen(job->input[k].value[j]) + 1;
            if (size > room)
                return -1;
            memcpy(at, job->input[k].value[j], size);
            at += size;
            room -= size;
        }
    return 0;
}

static void bury(struct cagd_code_resident *r)
{
    int status;
    close(r->line);
    while (r->child > 0 && waitpid(r->child, &status, 0) < 0 && errno == EINTR)
        ;
    r->child = 0;
}

static int bear(struct cagd_code_resident *r, const struct cagd_code_program *p, const struct cagd_code_job *job)
{
    int line[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, line) != 0)
        return -1;
    struct cagd_code_job bounded = cagd_code_bounded(job);
    fflush(NULL);
    r->child = fork();
    r->line = line[r->child == 0];
    close(line[r->child != 0]);
    if (r->child == 0)
        live(r, p, bounded);
    if (r->child < 0) {
        r->child = 0;
        close(r->line);
        return -1;
    }
    return 0;
}

struct cagd_code_outcome *cagd_code_run_again(struct cagd_code_resident **resident, const struct cagd_code_program *p,
                                              const struct cagd_code_job *job)
{
    struct cagd_code_resident *r = *resident;
    if (r == NULL) {
        r = calloc(1, sizeof *r);
        if (r == NULL || (r->outcome = cagd_code_shared_room(&r->bytes)) == NULL) {
            free(r);
            return NULL;
        }
        *resident = r;
    }
    cagd_code_outcome_begin(r->outcome);
    if (write_letter(letter_of(r), job) != 0) {
        r->outcome->end = CAGD_CODE_BOUND;
        strcpy(r->outcome->message, "the inputs are longer than there is room for");
        return r->outcome;
    }
    if (r->child > 0 && !said(r->line)) /* it was ended from outside while it waited */
        bury(r);
    if (r->child == 0 && bear(r, p, job) != 0) {
        strcpy(r->outcome->message, "no process for it");
        return r->outcome;
    }
    if (!heard(r->line))
        bury(r);
    return r->outcome;
}

void cagd_code_dismiss(struct cagd_code_resident *r)
{
    if (r == NULL)
        return;
    if (r->child > 0)
        bury(r);
    munmap(r->outcome, r->bytes);
    free(r);
}
