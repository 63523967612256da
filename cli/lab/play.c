/* play.c -- the process that runs other people's code, job by job, and the judge's end of it; see lab.h.
 *
 * It is told inputs and tells results, and knows nothing else: no expected value is ever in it.  A job is
 *     {"entry": "lab_entry_3", "numbers": "rational|field|rounding", "seconds": 5,
 *      "inputs": [{"name": "p", "count": 2, "value": ["1", "2/3"], "like": [0, 1]}]}
 * and its outcome
 *     {"end": "finished", "message": "", "line": 0, "results": [{"name", "got", "field", "ulps", "lost"}], "conditions": [...],
 *      "denominators": ["t-1"], "operations": 12, "path": "1f...", "printed": 0, "kept": "", "kept_line": 0}
 * of rounding: "ulps" where the exact value is not 0, and "lost": true where binary64 has no number.
 * With "note": true in the job also "computed": [["3/4", 12, 7], ...], what each operation of the code came to, in line 12, with a number
 * for that operation.  Here kept is a variable of static storage that the code puts something into; "turned", where rounding turned a comparison, its line;
 * "whole", where a whole number is made of what varies, its line. */
#include "cli/lab/lab.h"
#include "exact/code/run.h"

#include <errno.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <math.h>
#include <poll.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_INPUTS = 64, MOST_ELEMENTS = 256, MOST_RESULTS = 4096, MOST_PRINTED = 1 << 16, MOST_ANSWER = 1 << 26 };
enum { MOST_MEGABYTES = 1024, MOST_WAIT = 120 };

/* ---- what the code may ask of the system ------------------------------------------------------------------- */

#define ALLOW(name)  BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_##name, 0, 1), BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)
#define LOAD(member) BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, member))
enum { WRITES = 03 | 0100 | 01000 | 02000 }; /* O_ACCMODE, O_CREAT, O_TRUNC, O_APPEND */

/* Memory, its own end, and reading files, as loading the object needs it; everything else has no permission.  It writes to the
 * standard descriptors alone, and signals none but itself. */
static void bound(void)
{
    struct sock_filter rule[] = {
#ifdef __x86_64__ /* elsewhere there is one table of numbers */
        LOAD(arch),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, AUDIT_ARCH_X86_64, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
#endif
        LOAD(nr),
        ALLOW(read),
        ALLOW(pread64),
        ALLOW(close),
        ALLOW(fstat),
        ALLOW(newfstatat),
        ALLOW(lseek),
        ALLOW(mmap),
        ALLOW(mprotect),
        ALLOW(munmap),
        ALLOW(mremap),
        ALLOW(madvise),
        ALLOW(brk),
        ALLOW(futex),
        ALLOW(exit),
        ALLOW(exit_group),
        ALLOW(rt_sigaction),
        ALLOW(rt_sigprocmask),
        ALLOW(rt_sigreturn),
        ALLOW(sigaltstack), /* of which a sanitizer asks at the end */
        ALLOW(getpid),
        ALLOW(gettid),
        ALLOW(getrandom),
        ALLOW(clock_gettime),
        /* openat(folder, path, flags): to read */
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_openat, 0, 4),
        LOAD(args[2]),
        BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, WRITES, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
        /* write(descriptor, ...): up to 2 */
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_write, 0, 4),
        LOAD(args[0]),
        BPF_JUMP(BPF_JMP | BPF_JGT | BPF_K, 2, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
        /* tgkill(process, ...): itself, for abort() */
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_tgkill, 0, 3),
        LOAD(args[0]),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)getpid(), 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
    };
    struct sock_fprog program = {sizeof rule / sizeof *rule, rule};
    for (int k = 3; k < 64; k++) /* the pipes of the judge among them; the object is opened by its number */
        if (k != cagd_code_descriptor())
            close(k);
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

/* ---- jobs and outcomes ------------------------------------------------------------------------------------ */

struct arrays {
    const char *value[MOST_INPUTS][MOST_ELEMENTS];
    int like[MOST_INPUTS][MOST_ELEMENTS];
    struct cagd_code_input input[MOST_INPUTS];
};

/* Whether the job is understood. */
static int read_job(const json_t *j, struct arrays *a, struct cagd_code_job *job)
{
    const char *numbers = json_string_value(json_object_get(j, "numbers"));
    const json_t *in, *inputs = json_object_get(j, "inputs");
    size_t k, e, count = json_array_size(inputs);
    job->note_results = json_is_true(json_object_get(j, "note"));
    job->entry = json_string_value(json_object_get(j, "entry"));
    job->most_seconds = (long)json_integer_value(json_object_get(j, "seconds"));
    if (job->entry == NULL || numbers == NULL || count > MOST_INPUTS)
        return 0;
    job->numbers = strcmp(numbers, "field") == 0      ? CAGD_CODE_FIELD
                   : strcmp(numbers, "rounding") == 0 ? CAGD_CODE_ROUNDING
                                                      : CAGD_CODE_RATIONAL;
    json_array_foreach(inputs, k, in)
    {
        const json_t *value = json_object_get(in, "value"), *like = json_object_get(in, "like");
        if (json_array_size(value) > MOST_ELEMENTS)
            return 0;
        for (e = 0; e < json_array_size(value); e++) {
            a->value[k][e] = json_string_value(json_array_get(value, e));
            a->like[k][e] = (int)json_integer_value(json_array_get(like, e));
        }
        a->input[k] = (struct cagd_code_input){json_string_value(json_object_get(in, "name")),
                                               (int)json_integer_value(json_object_get(in, "count")), a->value[k],
                                               a->like[k], json_is_true(json_object_get(in, "variable"))};
    }
    job->inputs = (int)count;
    job->input = a->input;
    return 1;
}

static json_t *results_of(const struct cagd_code_outcome *o, int rounds)
{
    json_t *list = json_array();
    int count = 0;
    for (const struct cagd_code_result *r = o->results; r != NULL && count < MOST_RESULTS; r = r->next, count++) {
        json_t *row = json_pack("{s:s, s:s}", "name", r->name, "got", r->got);
        if (row == NULL)
            continue;
        if (r->got_field != NULL)
            json_object_set_new(row, "field", json_string(r->got_field));
        if (isfinite(r->ulps))
            json_object_set_new(row, "ulps", json_real(r->ulps));
        if (rounds && !isfinite(r->computed)) /* no number in binary64 */
            json_object_set_new(row, "lost", json_true());
        json_array_append_new(list, row);
    }
    return list;
}

static json_t *conditions_of(const struct cagd_code_outcome *o)
{
    json_t *list = json_array();
    int count = 0;
    for (const struct cagd_code_condition *c = o->conditions; c != NULL && count < MOST_RESULTS; c = c->next, count++) {
        json_t *row = json_pack("{s:s, s:s, s:s, s:s, s:s, s:i, s:b, s:i}", "left", c->left, "relation", c->relation,
                                "right", c->right, "difference", c->difference, "polynomial", c->polynomial, "holding",
                                c->holding, "given", c->given, "line", (int)c->place.line);
        if (row != NULL)
            json_array_append_new(list, row);
    }
    return list;
}

static json_t *denominators_of(const struct cagd_code_outcome *o)
{
    json_t *list = json_array();
    int count = 0;
    for (const char *at = o->denominators; at != NULL && *at != 0 && count < MOST_RESULTS; count++) {
        size_t length = strcspn(at, "\n");
        json_array_append_new(list, json_stringn(at, length));
        at += length + (at[length] == '\n');
    }
    return list;
}

/* The results of operations in the answer. */
static json_t *computed_of(const struct cagd_code_outcome *o)
{
    json_t *list = json_array();
    for (const struct cagd_code_computed *c = o->computed; c != NULL; c = c->next)
        if (strcmp(c->file, LAB_DRIVER) != 0)
            json_array_append_new(list, json_pack("[s, i, I]", c->value, c->line, (json_int_t)c->operation));
    return list;
}

static json_t *outcome_json(const struct cagd_code_outcome *o, int rounds, long printed)
{
    static const char *const ends[] = {"finished", "outside", "undefined", "refused", "bound", "crashed"};
    char path[32];
    snprintf(path, sizeof path, "%llx", o->path);
    const int of_the_call = strcmp(o->file, LAB_DRIVER) == 0; /* its lines are none of the answer */
    json_t *row =
        json_pack("{s:s, s:s, s:i, s:o, s:o, s:o, s:I, s:s, s:I, s:s, s:i}", "end",
                  (unsigned)o->end <= CAGD_CODE_CRASHED ? ends[o->end] : "crashed", "message", o->message, "line",
                  of_the_call ? 0 : o->line, "results", results_of(o, rounds), "conditions", conditions_of(o),
                  "denominators", denominators_of(o), "operations", (json_int_t)o->operations, "path", path, "printed",
                  (json_int_t)printed, "kept", o->kept, "kept_line", o->kept_line);
    if (row != NULL && o->whole_line > 0)
        json_object_set_new(row, "whole", json_integer(o->whole_line));
    if (row != NULL && o->computed != NULL)
        json_object_set_new(row, "computed", computed_of(o));
    if (row != NULL && o->decided_otherwise > 0)
        json_object_set_new(row, "turned", json_integer(o->turned.line));
    return row != NULL ? row : json_pack("{s:s, s:s}", "end", "crashed", "message", "what came back is no text");
}

int lab_play(const char *object)
{
    static struct arrays a;
    char message[400];
    struct cagd_code_program *p = cagd_code_load(object, sizeof message, message);
    /* What the code prints goes here, and only its length is looked at. */
    int printed = memfd_create("printed", MFD_CLOEXEC);
    struct rlimit bytes = {MOST_PRINTED, MOST_PRINTED};
    if (p == NULL || printed < 0)
        return 1;
    prctl(PR_SET_DUMPABLE, 0);
    setrlimit(RLIMIT_FSIZE, &bytes);
    signal(SIGXFSZ, SIG_IGN);
    dup2(printed, STDERR_FILENO);
    for (json_t *j; (j = json_loadf(stdin, JSON_DISABLE_EOF_CHECK, NULL)) != NULL; json_decref(j)) {
        struct cagd_code_job job = {.before = bound, .one_object = 1, .most_megabytes = MOST_MEGABYTES};
        json_t *row;
        if (ftruncate(printed, 0) != 0 || lseek(printed, 0, SEEK_SET) != 0)
            return 1;
        if (read_job(j, &a, &job)) {
            struct cagd_code_outcome *o = cagd_code_run(p, &job);
            if (o == NULL)
                return 1;
            row = outcome_json(o, job.numbers == CAGD_CODE_ROUNDING, lseek(printed, 0, SEEK_END));
            cagd_code_outcome_free(o);
        } else {
            row = json_pack("{s:s, s:s}", "end", "refused", "message", "the job is not understood");
        }
        json_dumpf(row, stdout, JSON_COMPACT);
        putchar('\n');
        fflush(stdout);
        json_decref(row);
    }
    cagd_code_unload(p);
    return 0;
}

/* ---- the judge's end --------------------------------------------------------------------------------------- */

int lab_player_open(struct lab_player *p, const struct lab_place *place, const struct lab *lab, const char *object)
{
    char self[LAB_MOST_PATH], path[LAB_MOST_PATH + 64], script[LAB_MOST_PATH + 64], cases[LAB_MOST_PATH + 64];
    int to, from;
    ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    if (length < 0)
        return -1;
    self[length] = 0;
    snprintf(path, sizeof path, "%s/%s", place->folder, object);
    snprintf(script, sizeof script, "%s/cagd_lab.py", place->folder);
    snprintf(cases, sizeof cases, "%s/cases.json", place->folder);
    char *const c[] = {self, (char *)(uintptr_t) "lab", (char *)(uintptr_t) "--play", path, NULL};
    char *const python[] = {
        (char *)(uintptr_t) "/usr/bin/python3", (char *)(uintptr_t) "-I", script, path, cases, NULL};
    p->pid = lab_start(place, lab_is_python(lab, object) ? python : c, &to, &from, -1);
    p->to = p->pid > 0 ? fdopen(to, "w") : NULL;
    p->from = p->pid > 0 ? fdopen(from, "r") : NULL;
    return p->to != NULL && p->from != NULL ? 0 : -1;
}

void lab_player_close(struct lab_player *p)
{
    if (p->pid <= 0)
        return;
    fclose(p->to);
    fclose(p->from);
    kill(p->pid, SIGKILL);
    while (waitpid(p->pid, NULL, 0) < 0 && errno == EINTR)
        ;
    p->pid = 0;
}

void lab_ask(struct lab_player *p, const json_t *job)
{
    json_dumpf(job, p->to, JSON_COMPACT);
    fputc('\n', p->to);
    fflush(p->to);
}

json_t *lab_answer(struct lab_player *p)
{
    char *line = NULL;
    size_t room = 0;
    struct pollfd one = {fileno(p->from), POLLIN, 0};
    int ready;
    while ((ready = poll(&one, 1, MOST_WAIT * 1000)) < 0 && errno == EINTR)
        ;
    ssize_t size = ready > 0 ? getline(&line, &room, p->from) : -1;
    json_t *answer = size > 0 && size < MOST_ANSWER ? json_loadb(line, (size_t)size, 0, NULL) : NULL;
    free(line);
    if (json_is_object(answer) && json_is_string(json_object_get(answer, "end")))
        return answer;
    json_decref(answer);
    return NULL;
}
