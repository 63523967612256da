/* waiting.c -- that a long computation goes on, on a terminal.
 *
 * The line is written when a signal of the clock comes, by what may be called then: write, and no stdio. */
#include "cli/waiting.h"
#include "cli/terminal.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

enum { FIRST = 2 }; /* seconds without a word */

static const char *volatile what, *volatile things;
static volatile sig_atomic_t seconds, done, total;

/* A text, or a number that is not negative, behind what is in the line. */
static void add_text(char line[], int room, int *length, const char *text)
{
    while (*text != '\0' && *length < room)
        line[(*length)++] = *text++;
}
static void add_number(char line[], int room, int *length, int n)
{
    if (n > 9)
        add_number(line, room, length, n / 10);
    add_text(line, room, length, (const char[]){(char)('0' + n % 10), '\0'});
}

static void tell(int signal)
{
    (void)signal;
    int cause = errno, length = 0;
    enum { ROOM = 160 };
    char line[ROOM];
    if (++seconds < FIRST)
        return;
    add_text(line, ROOM, &length, "\r\x1b[K");
    add_text(line, ROOM, &length, what);
    add_text(line, ROOM, &length, ": ");
    add_number(line, ROOM, &length, seconds);
    add_text(line, ROOM, &length, " s");
    if (total > 0) {
        add_text(line, ROOM, &length, ", ");
        add_number(line, ROOM, &length, done);
        if (total > done) {
            add_text(line, ROOM, &length, " of ");
            add_number(line, ROOM, &length, total);
        }
        add_text(line, ROOM, &length, " ");
        add_text(line, ROOM, &length, things);
    }
    if (write(STDERR_FILENO, line, (size_t)length) < 0)
        what = "";
    errno = cause;
}

static void set_clock(int every)
{
    const struct itimerval time = {.it_interval = {.tv_sec = every}, .it_value = {.tv_sec = every}};
    setitimer(ITIMER_REAL, &time, NULL);
}

void waiting_begin(const char *text)
{
    if (!is_terminal(stderr))
        return;
    struct sigaction action = {.sa_handler = tell, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    seconds = done = total = 0;
    what = text;
    if (sigaction(SIGALRM, &action, NULL) == 0)
        set_clock(1);
}

void waiting_end(void)
{
    if (what == NULL)
        return;
    set_clock(0);
    if (seconds >= FIRST)
        fputs("\r\x1b[K", stderr);
    what = NULL;
}

void waiting_at(int now, int of, const char *name)
{
    things = name;
    done = now;
    total = of;
}
