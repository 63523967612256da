/* manual.c -- the man page, made from the commands and their options. */
#include "cli/commands.h"
#include "cli/output.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- text in roff ------------------------------------------------------------------------------------ */

static int is_option_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-'; }

/* The text, with what roff would take for its own written so that it is printed; options such as --json are bold. */
static void put_roff(FILE *out, const char *text, size_t length)
{
    int bold = 0;
    for (size_t k = 0; k < length; k++) {
        int starts_line = k == 0 || text[k - 1] == '\n', starts_word = k == 0 || !is_option_letter(text[k - 1]);
        if (bold && !is_option_letter(text[k]))
            fputs("\\fR", out), bold = 0;
        if (starts_word && k + 2 < length && strncmp(text + k, "--", 2) == 0 && is_option_letter(text[k + 2]))
            fputs("\\fB", out), bold = 1;
        if (starts_line && text[k] == '.')
            fputs("\\&", out);
        if (text[k] == '-')
            fputs("\\-", out);
        else if (text[k] == '\'')
            fputs("\\(aq", out);
        else if (text[k] == '\\')
            fputs("\\e", out);
        else
            fputc(text[k], out);
    }
    fputs(bold ? "\\fR" : "", out);
}

/* Paragraphs that blank lines separate; one whose second line is indented, such as the examples, keeps its lines. */
static void put_paragraphs(FILE *out, const char *text)
{
    while (*text != '\0') {
        const char *end = strstr(text, "\n\n");
        size_t length = end != NULL ? (size_t)(end - text) : strlen(text);
        while (length > 0 && text[length - 1] == '\n')
            length--;
        const char *line = memchr(text, '\n', length);
        int as_it_is = line != NULL && line[1] == ' ';
        fputs(as_it_is ? ".PP\n.nf\n" : ".PP\n", out);
        put_roff(out, text, length);
        fputs(as_it_is ? "\n.fi\n" : "\n", out);
        text = end != NULL ? end + 2 : text + strlen(text);
    }
}

/* ---- commands ---------------------------------------------------------------------------------------- */

/* "--json" in bold, then `between` and in italics what the option takes. */
static void put_option_name(FILE *out, const struct argp_option *row, const char *between)
{
    char name[64];
    snprintf(name, sizeof name, "--%s", row->name);
    put_roff(out, name, strlen(name));
    if (row->arg != NULL)
        fprintf(out, "%s\\fI%s\\fR", between, row->arg);
}

static void put_option_in_synopsis(void *context, const struct argp_option *row)
{
    FILE *out = context;
    fputc('[', out);
    put_option_name(out, row, " ");
    fputs("]\n", out);
}

static void put_synopsis(FILE *out, const struct command *c)
{
    fprintf(out, ".HP\n.B cagd %s\n", c->name);
    visit_options(c, put_option_in_synopsis, out);
    fprintf(out, "\\fI%s\\fR\n", c->usage);
}

static void put_option(void *context, const struct argp_option *row)
{
    FILE *out = context;
    fputs(".TP\n", out);
    if (row->key > ' ' && row->key <= '~')
        fprintf(out, "\\fB\\-%c\\fR, ", row->key);
    put_option_name(out, row, "=");
    fputc('\n', out);
    put_roff(out, row->doc, strlen(row->doc));
    fputc('\n', out);
}

static void put_command(FILE *out, const struct command *c)
{
    const char *after = strchr(c->text, '\v');
    char *before = strndup(c->text, after != NULL ? (size_t)(after - c->text) : strlen(c->text));
    if (before == NULL)
        abort();
    fprintf(out, ".SS cagd %s\n", c->name);
    put_paragraphs(out, before);
    visit_options(c, put_option, out);
    if (after != NULL)
        put_paragraphs(out, after + 1);
    free(before);
}

int write_manual(const char *folder)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/cagd.1", folder);
    struct output *o = output_open(path);
    if (o == NULL)
        return -1;
    FILE *out = output_stream(o);
    fputs(".TH CAGD 1 \"\" \"cagd " CAGD_VERSION "\" \"User Commands\"\n"
          ".nh\n"
          ".SH NAME\n"
          "cagd \\- decide the statements of textbooks on geometric design, exactly as printed\n"
          ".SH SYNOPSIS\n",
          out);
    for (int k = 0; commands[k] != NULL; k++)
        put_synopsis(out, commands[k]);
    fputs(
        ".HP\n.B cagd\n\\fB\\-\\-help\\fR | \\fB\\-\\-version\\fR\n"
        ".SH DESCRIPTION\n"
        ".B cagd\n"
        "takes the statements of textbooks on Bézier, rational Bézier and B-spline curves as they are printed and\n"
        "decides each one by exact computation: it holds, it holds under further hypotheses, or it fails, and then a\n"
        "counterexample and a corrected statement that was itself decided are shown.\n"
        ".SH COMMANDS\n",
        out);
    for (int k = 0; commands[k] != NULL; k++)
        put_command(out, commands[k]);
    for (int k = 0; commands[k] != NULL; k++)
        for (const struct topic *t = commands[k]->topics; t != NULL && t->title != NULL; t++) {
            fprintf(out, ".SH %s\n", t->title);
            put_paragraphs(out, t->text);
        }
    fputs(
        ".SH EXIT STATUS\n"
        ".TP\n0\nas expected\n"
        ".TP\n1\na verdict is not as expected; a knot or a degree that cannot be removed; a fit that did not converge, "
        "or not to a minimum\n"
        ".TP\n2\nthe call, a file that is read or the name of a file to write to has to be mended; this is seen first, "
        "and "
        "nothing was written\n"
        ".TP\n3\nsomething failed on the way: writing, on a full disk say, memory, or the program itself\n"
        ".SH ENVIRONMENT\n"
        ".TP\n.B NO_COLOR\nwhen set and not empty, no colours are used.\n",
        out);
    return output_close(o);
}
