/* prose.c -- the words of a page on standard output, filled to its width. */
#include "cli/prose.h"

#include "cli/layout.h"
#include "cli/terminal.h"
#include "cli/tex.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void heading(const char *text) { printf("\n%s%s%s\n", style(stdout, BOLD), text, style(stdout, PLAIN)); }

void paragraph(const char *text, int indent) { put_paragraph(stdout, text, indent, page_width(WIDEST)); }

void prose(const char *text, int indent)
{
    for (const char *p = text; *p != '\0';) {
        const char *end = strstr(p, "\n\n");
        size_t n = end != NULL ? (size_t)(end - p) : strlen(p);
        char *raw = strndup(p, n);
        if (raw == NULL)
            abort();
        char *plain = tex_to_layout(raw, 1);
        paragraph(plain, indent);
        free(plain), free(raw);
        p += n;
        if (end != NULL) {
            putchar('\n');
            p += 2;
        }
    }
}

void formula(const char *tex, int indent)
{
    int sentence = strchr(tex, '$') != NULL || strpbrk(tex, "\\_^=") == NULL;
    char *plain = tex_to_layout(tex, sentence);
    paragraph(plain, indent);
    free(plain);
}

void labelled(const char *label, const char *text, int indent)
{
    if (text[0] == '\0')
        return;
    char *plain = tex_to_layout(text, 1), *whole;
    size_t room = strlen(plain) + strlen(label) + 4;
    whole = malloc(room);
    if (whole == NULL)
        abort();
    snprintf(whole, room, "%s  %s", label, plain);
    paragraph(whole, indent);
    free(whole), free(plain);
}

void hanging(const char *label, const char *text, int columns, int indent)
{
    if (text[0] == '\0')
        return;
    char *plain = tex_to_layout(text, 1);
    printf("%*s", indent, "");
    put_padded(stdout, label, columns);
    put_behind(stdout, plain, indent + columns, indent + columns, page_width(WIDEST));
    free(plain);
}

void clause(const char *words, int indent)
{
    char *sentence = malloc(strlen(words) + 2);
    if (sentence == NULL)
        abort();
    sprintf(sentence, "%s.", words);
    sentence[0] = (char)(sentence[0] >= 'a' && sentence[0] <= 'z' ? sentence[0] - 'a' + 'A' : sentence[0]);
    char *plain = tex_to_text(sentence, 1);
    paragraph(plain, indent);
    free(plain), free(sentence);
}
