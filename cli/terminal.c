/* terminal.c -- widths and colours. */
#include "cli/terminal.h"
#include "cli/screen.h"

#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

int is_terminal(FILE *stream) { return isatty(stream == stdout ? screen_descriptor() : fileno(stream)); }

const char *style(FILE *stream, enum style s)
{
    static const char *const sequence[] = {"\x1b[0m", "\x1b[1m", "\x1b[2m", "\x1b[32m", "\x1b[31m", "\x1b[33m"};
    const char *off = getenv("NO_COLOR");
    return is_terminal(stream) && (off == NULL || *off == '\0') ? sequence[s] : "";
}

/* The columns of the terminal at the descriptor (-1: there is none), or what COLUMNS says, within the limits. */
static int columns_at(int descriptor, int most)
{
    enum { LEAST = 40 };
    struct winsize size;
    const char *said = getenv("COLUMNS");
    int columns = said != NULL ? atoi(said) : 0;
    if (columns <= 0 && descriptor >= 0 && ioctl(descriptor, TIOCGWINSZ, &size) == 0)
        columns = size.ws_col;
    return columns <= 0 || columns > most ? most : columns < LEAST ? LEAST : columns;
}

int page_width(int most) { return columns_at(is_terminal(stdout) ? screen_descriptor() : -1, most); }
int message_width(int most) { return columns_at(is_terminal(stderr) ? STDERR_FILENO : -1, most); }

/* Width of the character at s in columns, by the ranges that occur here: combining marks 0, CJK 2. */
static int width_of(unsigned long c)
{
    if ((c >= 0x300 && c <= 0x36F) || (c >= 0x20D0 && c <= 0x20FF))
        return 0;
    return (c >= 0x2E80 && c <= 0x9FFF) || (c >= 0xF900 && c <= 0xFAFF) || (c >= 0xFF00 && c <= 0xFF60) ? 2 : 1;
}

static const char *next_character(const char *s, unsigned long *c)
{
    unsigned char first = (unsigned char)*s++;
    *c = first < 0x80 ? first : first < 0xE0 ? first & 0x1F : first < 0xF0 ? first & 0x0F : first & 0x07;
    while (((unsigned char)*s & 0xC0) == 0x80)
        *c = *c << 6 | ((unsigned char)*s++ & 0x3F);
    return s;
}

const char *end_of_character(const char *s)
{
    unsigned long c;
    return next_character(s, &c);
}

int columns_between(const char *s, const char *end)
{
    int columns = 0;
    for (unsigned long c; s < end; columns += width_of(c))
        s = next_character(s, &c);
    return columns;
}

int columns_of(const char *s) { return columns_between(s, s + strlen(s)); }

void put_padded(FILE *out, const char *s, int width)
{
    fputs(s, out);
    for (int k = columns_of(s); k < width; k++)
        fputc(' ', out);
}

void put_clipped(FILE *out, const char *s, int width)
{
    unsigned long c;
    const char *end = s, *next;
    for (int columns = 0; *end != '\0'; end = next) {
        next = next_character(end, &c);
        if ((columns += width_of(c)) > width)
            break;
    }
    fprintf(out, "%.*s%s", (int)(end - s), s, *end != '\0' ? " ..." : "");
}
