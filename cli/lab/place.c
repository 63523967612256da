/* place.c -- processes in which other people's code is compiled and run; see lab.h. */
#include "cli/lab/lab.h"
#include "core/clock.h"
#include "exact/code/scratch.h"

#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_WORDS = 128, LEAST_SAID = 1 << 12, MOST_SAID = 1 << 23, MOST_FILE = 1 << 25, MOST_OPEN = 64 };
enum { LEAST_WAIT = 20, WAIT_PER_SECOND = 8 };
#ifdef __SANITIZE_ADDRESS__
static const rlim_t MOST_ADDRESSES = RLIM_INFINITY; /* the programs that run here take terabytes, too */
#else
static const rlim_t MOST_ADDRESSES = (rlim_t)2 << 30;
#endif
static const char BUBBLEWRAP[] = "/usr/bin/bwrap";

int lab_place_open(struct lab_place *p, int shut)
{
    char folder[SCRATCH];
    p->shut = shut;
    p->store[0] = 0;
    if (make_scratch(folder, "cagd-lab") != 0)
        return -1;
    snprintf(p->folder, sizeof p->folder, "%s", folder);
    return 0;
}

static int forget(const char *path, const struct stat *is, int kind, struct FTW *walk)
{
    (void)is, (void)kind, (void)walk;
    return remove(path);
}

void lab_place_close(const struct lab_place *p) { nftw(p->folder, forget, 8, FTW_DEPTH | FTW_PHYS); }

const char *lab_cannot_shut(void)
{
    static char said[200];
    static int known = -1;
    char *const word[] = {(char *)(uintptr_t) "/bin/true", NULL};
    struct lab_place place;
    if (known >= 0)
        return known ? said : NULL;
    known = 1;
    if (access(BUBBLEWRAP, X_OK) != 0) {
        snprintf(said, sizeof said, "there is no bubblewrap (Debian: bubblewrap)");
    } else if (lab_place_open(&place, 1) != 0) {
        snprintf(said, sizeof said, "no temporary folder: %s", strerror(errno));
    } else {
        char *text = NULL;
        known = lab_run(&place, word, 10, &text) != 0;
        snprintf(said, sizeof said, "bubblewrap has no rights here: %.100s", text != NULL ? text : "");
        said[strcspn(said, "\n")] = 0;
        free(text);
        lab_place_close(&place);
    }
    return known ? said : NULL;
}

/* What is put before a command: a system whose programs can be read, the place alone written, no network, no other process,
 * and nothing of the environment. */
static int shut_in(const struct lab_place *p, char *word[])
{
    static char self[LAB_MOST_PATH], here[LAB_MOST_PATH], sanitized[LAB_MOST_PATH], initialised[LAB_MOST_PATH],
        labs[LAB_MOST_PATH], real[PATH_MAX];
    static const char *const always[] = {BUBBLEWRAP,
                                         "--unshare-all",
                                         "--die-with-parent",
                                         "--new-session",
                                         "--clearenv",
                                         "--setenv",
                                         "PATH",
                                         "/usr/bin:/bin",
                                         "--setenv",
                                         "LC_ALL",
                                         "C.UTF-8",
                                         "--ro-bind",
                                         "/usr",
                                         "/usr",
                                         "--ro-bind-try",
                                         "/lib",
                                         "/lib",
                                         "--ro-bind-try",
                                         "/lib64",
                                         "/lib64",
                                         "--ro-bind-try",
                                         "/bin",
                                         "/bin",
                                         "--ro-bind-try",
                                         "/etc/ld.so.cache",
                                         "/etc/ld.so.cache",
                                         "--ro-bind-try",
                                         "/etc/alternatives",
                                         "/etc/alternatives",
                                         "--proc",
                                         "/proc",
                                         "--dev",
                                         "/dev",
                                         "--tmpfs",
                                         "/tmp"};
    int words = 0;
    ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    if (length < 0)
        return -1;
    self[length] = 0;
    char *slash = strrchr(self, '/');
    snprintf(here, sizeof here, "%.*s/cagd-compile-exactly", (int)(slash - self), self);
    snprintf(sanitized, sizeof sanitized, "%.*s/cagd-run-sanitized", (int)(slash - self), self);
    snprintf(initialised, sizeof initialised, "%.*s/cagd-run-initialised", (int)(slash - self), self);
    for (size_t k = 0; k < sizeof always / sizeof *always; k++)
        word[words++] = (char *)(uintptr_t)always[k];
    /* The labs, which have the right answers, where they lie among what is seen. */
    if (lab_folder(labs) == 0 && realpath(labs, real) != NULL && strncmp(real, "/usr/", 5) == 0) {
        word[words++] = (char *)(uintptr_t) "--tmpfs";
        word[words++] = real;
    }
    char *const binds[] = {(char *)(uintptr_t) "--ro-bind",
                           self,
                           self,
                           (char *)(uintptr_t) "--ro-bind-try",
                           here,
                           here,
                           (char *)(uintptr_t) "--ro-bind-try",
                           sanitized,
                           sanitized,
                           (char *)(uintptr_t) "--ro-bind-try",
                           initialised,
                           initialised,
                           (char *)(uintptr_t) "--bind",
                           (char *)(uintptr_t)p->folder,
                           (char *)(uintptr_t)p->folder,
                           (char *)(uintptr_t) "--chdir",
                           (char *)(uintptr_t)p->folder,
                           (char *)(uintptr_t) "--"};
    for (size_t k = 0; k < sizeof binds / sizeof *binds; k++)
        word[words++] = binds[k];
    return words;
}

static void limit(unsigned what, rlim_t value)
{
    struct rlimit l = {value, value};
    setrlimit(what, &l);
}

/* In the child: pipes in their places, bounds, and no other descriptor. */
static void prepare(int in, int out, int errors, int seconds, rlim_t addresses)
{
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(errors >= 0 ? errors : out, STDERR_FILENO);
    for (int k = 3; k < MOST_OPEN; k++)
        close(k);
    limit(RLIMIT_FSIZE, MOST_FILE);
    limit(RLIMIT_NOFILE, MOST_OPEN);
    limit(RLIMIT_CORE, 0);
    if (addresses != RLIM_INFINITY)
        limit(RLIMIT_AS, addresses);
    if (seconds > 0)
        limit(RLIMIT_CPU, (rlim_t)seconds);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setsid();
}

static pid_t start(const struct lab_place *p, char *const command[], int in, int out, int errors, int seconds,
                   rlim_t addresses)
{
    char *word[MOST_WORDS];
    int words = p->shut ? shut_in(p, word) : 0;
    for (int k = 0; words >= 0 && words < MOST_WORDS - 1 && command[k] != NULL; k++)
        word[words++] = command[k];
    if (words < 0 || words >= MOST_WORDS - 1)
        return -1;
    word[words] = NULL;
    pid_t child = fork();
    if (child == 0) {
        prepare(in, out, errors, seconds, addresses);
        if (chdir(p->folder) == 0)
            execvp(word[0], word);
        _exit(127);
    }
    return child;
}

pid_t lab_start(const struct lab_place *p, char *const word[], int *to, int *from, int errors)
{
    int in[2], out[2], null = open("/dev/null", O_RDWR | O_CLOEXEC);
    if (null < 0 || pipe2(in, O_CLOEXEC) != 0)
        return -1;
    if (pipe2(out, O_CLOEXEC) != 0) {
        close(in[0]), close(in[1]), close(null);
        return -1;
    }
    pid_t child = start(p, word, in[0], out[1], errors >= 0 ? errors : null, 0, RLIM_INFINITY);
    close(in[0]), close(out[1]), close(null);
    *to = in[1], *from = out[0];
    return child;
}

/* What was said, as a text: there is room for one byte more than its size. */
struct said {
    char *text;
    size_t size, room;
    int is_cut; /* there was no memory for more */
};

/* Some bytes more, of which those beyond MOST_SAID are dropped.  0 at the end, or where there is no memory. */
static int hear_more(int from, struct said *s)
{
    char drop[4096];
    if (s->size == s->room && s->room < MOST_SAID) {
        size_t room = 2 * s->room < MOST_SAID ? 2 * s->room : MOST_SAID;
        char *longer = realloc(s->text, room + 1);
        s->is_cut = longer == NULL;
        if (s->is_cut)
            return 0;
        s->text = longer, s->room = room;
    }
    int is_full = s->size == s->room;
    ssize_t got = is_full ? read(from, drop, sizeof drop) : read(from, s->text + s->size, s->room - s->size);
    s->size += got > 0 && !is_full ? (size_t)got : 0;
    return got > 0;
}

/* What comes from the descriptor, until it ends or the time is over: then 0. */
static int hear(int from, struct said *s, int seconds)
{
    double end = cagd_seconds() + LEAST_WAIT + WAIT_PER_SECOND * seconds;
    for (;;) {
        struct pollfd one = {from, POLLIN, 0};
        double left = end - cagd_seconds();
        int ready = left > 0 ? poll(&one, 1, (int)(left * 1000) + 1) : 0;
        if (ready < 0 && errno == EINTR)
            continue;
        if (ready <= 0)
            return 0;
        if (!hear_more(from, s))
            return 1;
    }
}

static int run(const struct lab_place *p, char *const word[], int seconds, rlim_t addresses, char **said, int *whole)
{
    int out[2], null = open("/dev/null", O_RDWR | O_CLOEXEC), status = -1;
    struct said s = {.text = malloc(LEAST_SAID + 1), .room = LEAST_SAID};
    *said = s.text;
    if (s.text == NULL)
        return -1;
    s.text[0] = 0;
    if (null < 0 || pipe2(out, O_CLOEXEC) != 0)
        return -1;
    pid_t child = start(p, word, null, out[1], -1, seconds, addresses);
    close(out[1]), close(null);
    if (child > 0 && !hear(out[0], &s, seconds))
        kill(-child, SIGKILL), kill(child, SIGKILL);
    *whole = s.size < MOST_SAID && !s.is_cut;
    close(out[0]);
    for (size_t k = 0; k < s.size; k++) /* a text, whatever it was */
        if (s.text[k] == 0)
            s.text[k] = '?';
    s.text[s.size] = 0;
    *said = s.text;
    while (child > 0 && waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return -1;
    return child < 0 ? -1 : WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int lab_run(const struct lab_place *p, char *const word[], int seconds, char **said)
{
    int whole = 0, code = run(p, word, seconds, MOST_ADDRESSES, said, &whole);
    return whole ? code : -1;
}

int lab_run_sanitized(const struct lab_place *p, char *const word[], int seconds, char **said)
{
    int whole;
    return run(p, word, seconds, RLIM_INFINITY, said, &whole);
}
