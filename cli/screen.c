/* screen.c -- what is printed on a terminal. */
#include "cli/screen.h"
#include "chapters/judge/memory_text.h"
#include "cli/command.h"
#include "cli/output.h"
#include "cli/terminal.h"

#include <errno.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

static int terminal = -1; /* while output is kept: the terminal that it is for */
static int as_it_is;

int screen_descriptor(void) { return terminal >= 0 ? terminal : STDOUT_FILENO; }

void screen_leaves_lines(void) { as_it_is = 1; }

/* ---- lines ------------------------------------------------------------------------------------------- */

/* Behind the escape sequence at s, which takes no column; s where there is none. */
static const char *behind_escape(const char *s)
{
    if (s[0] != '\x1b' || s[1] != '[')
        return s;
    return s + strcspn(s, "m") + (strchr(s, 'm') != NULL);
}

/* Where a line that begins at s is broken to have at most `width` columns: behind its last blank that fits, unless only
 * blanks stand before it, or else in a word.  NULL: it is not too long. */
static const char *break_of(const char *s, const char *end, int width)
{
    const char *blank = NULL;
    int columns = 0, words = 0;
    for (const char *at = s, *next; at < end; at = next) {
        if ((next = behind_escape(at)) != at)
            continue;
        next = end_of_character(at);
        columns += columns_between(at, next);
        if (columns > width)
            return blank != NULL ? blank : at > s ? at : next;
        if (*at == ' ' && words)
            blank = next;
        words |= *at != ' ';
    }
    return NULL;
}

/* The lines of the text into `out`; what is broken off goes on a little further to the right.  How many lines. */
static int put_lines(FILE *out, const char *text, int width)
{
    enum { FURTHER = 4 };
    int lines = 0;
    while (*text != '\0') {
        const char *end = text + strcspn(text, "\n"), *from = text, *to;
        int indent = (int)strspn(text, " ") + FURTHER, left = width;
        if (indent > width / 2)
            indent = FURTHER;
        while (!as_it_is && (to = break_of(from, end, left)) != NULL) {
            int length = (int)(to - from);
            while (length > 0 && from[length - 1] == ' ')
                length--;
            fprintf(out, "%.*s\n%*s", length, from, indent, "");
            lines++;
            from = to + strspn(to, " ");
            left = width - indent;
        }
        fprintf(out, "%.*s\n", (int)(end - from), from);
        lines++;
        text = *end == '\n' ? end + 1 : end;
    }
    return lines;
}

/* ---- the end ------------------------------------------------------------------------------------------ */

/* One line: what, why where that is known, and what to do. */
static void fail(int cause)
{
    refuse_line("standard output: cannot be written%s%s; %ssend it elsewhere", cause != 0 ? ": " : "",
                cause != 0 ? strerror(cause) : "", output_advice(cause));
    _exit(EXIT_INTERNAL);
}

/* Whether a pager took the text. */
static int is_paged(const char *text)
{
    const char *pager = getenv("PAGER");
    if (pager != NULL && *pager == '\0')
        return 0;
    setenv("LESS", "FRX", 0); /* ends by itself on one screen, leaves colours and the page on the terminal */
    signal(SIGPIPE, SIG_IGN); /* the pager may be left before the end */
    FILE *to = popen(pager != NULL ? pager : "less", "w");
    if (to == NULL)
        return 0;
    fputs(text, to);
    int status = pclose(to);
    return WIFEXITED(status) && WEXITSTATUS(status) < 126; /* otherwise there is no such program */
}

/* What was kept, as a text. */
static char *kept_text(void)
{
    off_t size = lseek(STDOUT_FILENO, 0, SEEK_END), had = 0;
    char *text = size >= 0 ? malloc((size_t)size + 1) : NULL;
    for (ssize_t more = 1; text != NULL && had < size && more > 0; had += more)
        more = pread(STDOUT_FILENO, text + had, (size_t)(size - had), had);
    if (text == NULL || had != size)
        fail(errno);
    text[size] = '\0';
    return text;
}

static void end(void)
{
    errno = 0;
    if (fflush(stdout) != 0 || ferror(stdout))
        fail(errno);
    if (terminal < 0)
        return;
    char *text = kept_text(), *page = NULL;
    size_t room;
    struct winsize size = {0};
    if (dup2(terminal, STDOUT_FILENO) < 0)
        fail(errno);
    ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
    FILE *out = text_open(&page, &room);
    int lines = put_lines(out, text, page_width(size.ws_col > 0 ? size.ws_col : INT_MAX));
    text_close(out, &page);
    if ((size.ws_row == 0 || lines < size.ws_row || !is_paged(page)) &&
        (fputs(page, stdout) < 0 || fflush(stdout) != 0))
        fail(errno);
    free(text), free(page);
}

void screen_begin(void)
{
    if (isatty(STDOUT_FILENO)) {
        FILE *kept = tmpfile();
        terminal = kept != NULL ? dup(STDOUT_FILENO) : -1;
        if (terminal >= 0 && dup2(fileno(kept), STDOUT_FILENO) < 0)
            terminal = -1;
        if (kept != NULL)
            fclose(kept);
    }
    atexit(end);
}
