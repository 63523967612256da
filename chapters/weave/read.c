/* read.c -- from the files of a chapter to blocks. */
#include "chapters/weave/book.h"

#include <dirent.h>
#include <glob.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const block_word[] = {"claim", "statement", "letters", "source"};

/* The kind of block that ":::{kind} name" begins, or -1; *name is what follows. */
static int block_begins(const char *line, const char **name)
{
    for (int kind = CLAIM_BLOCK; kind <= SOURCE_BLOCK; kind++) {
        size_t n = strlen(block_word[kind]);
        if (strncmp(line, ":::{", 4) == 0 && strncmp(line + 4, block_word[kind], n) == 0 && line[4 + n] == '}') {
            *name = line + 4 + n + 1;
            return kind;
        }
    }
    return -1;
}

static void add_option(struct block *b, char *key, char *value, int line)
{
    b->option = must(realloc(b->option, (size_t)(b->options + 1) * sizeof *b->option));
    b->option[b->options++] = (struct option){key, value, line};
}

/* Reads the block whose first line is l->at[k]; returns the index of its closing line. */
static int read_block(struct book *book, const struct list *l, int k, struct block b)
{
    int in_options = 1;
    b.line = k + 1;
    b.note = whole_copy("");
    for (k++; k < l->count && strcmp(l->at[k], ":::") != 0; k++) {
        const char *line = l->at[k], *end = line[0] == ':' ? strchr(line + 1, ':') : NULL;
        char *words = trimmed(whole_copy(line));
        if (in_options && end != NULL) {
            add_option(&b, copy_of(line + 1, (size_t)(end - line - 1)), trimmed(whole_copy(end + 1)), k + 1);
        } else if (in_options && b.options > 0 && words[0] != '\0') {
            struct option *o = &b.option[b.options - 1];
            o->value = joined(o->value, ' ', words);
        } else {
            in_options = 0;
            b.note = joined(b.note, '\n', line);
        }
    }
    b.note = trimmed(b.note);
    b.end = k + 1;
    if (k == l->count)
        complain(b.file, b.line, "block '%s' has no closing :::", b.name);
    if (b.kind == CLAIM_BLOCK)
        read_data(&b);
    book->block = must(realloc(book->block, (size_t)(book->blocks + 1) * sizeof *book->block));
    book->block[book->blocks++] = b;
    return k;
}

/* The name inside MACRO(name) at the start of a line, or NULL. */
static char *called(const char *line, const char *macro)
{
    size_t n = strlen(macro);
    const char *end = strchr(line, ')');
    return strncmp(line, macro, n) == 0 && line[n] == '(' && end != NULL
               ? copy_of(line + n + 1, (size_t)(end - line) - n - 1)
               : NULL;
}

/* The blocks and bodies of one file. */
static void read_blocks(struct book *book, const struct list *l, const char *path, const char *chapter)
{
    for (int k = 0; k < l->count; k++) {
        const char *head = l->at[k], *rest;
        char *name;
        int kind = block_begins(head, &rest);
        if (kind >= 0) {
            k = read_block(book, l, k,
                           (struct block){.kind = (enum block_kind)kind,
                                          .name = trimmed(whole_copy(rest)),
                                          .file = whole_copy(path),
                                          .chapter = whole_copy(chapter)});
        } else if (strncmp(head, ":::", 3) == 0) {
            complain(path, k + 1, "'%s' begins neither a claim nor a statement", head);
        } else if ((name = called(head, "CLAIM")) != NULL) {
            book->body = must(realloc(book->body, (size_t)(book->bodies + 1) * sizeof *book->body));
            book->body[book->bodies++] = (struct body){name, whole_copy(path), k + 1};
        }
    }
}

static void read_figures(struct book *book, const char *path)
{
    struct list l = lines_of(path);
    for (int k = 0; k < l.count; k++) {
        char *name = called(l.at[k], "FIGURE");
        if (name != NULL && contains(&book->figures, name))
            complain(path, k + 1, "there is another FIGURE(%s)", name);
        if (name != NULL)
            append(&book->figures, name);
    }
}

static void read_section(struct book *book, const char *folder, const char *chapter, const char *section)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s.claims.h", folder, section);
    struct list l = lines_of(path);
    if (l.count == 0)
        complain(path, 1, "the index lists this section, but there is no such file");
    read_blocks(book, &l, path, chapter);
    snprintf(path, sizeof path, "%s/%s.figure.c", folder, section);
    read_figures(book, path);
}

/* A section that the index forgets would be compiled, and never judged. */
static void check_listed(const char *folder, const char *index, const struct list *sections)
{
    static const char suffix[] = ".claims.h";
    DIR *d = opendir(folder);
    for (struct dirent *e; d != NULL && (e = readdir(d)) != NULL;) {
        size_t n = strlen(e->d_name), m = strlen(suffix);
        if (n <= m || strcmp(e->d_name + n - m, suffix) != 0)
            continue;
        char *section = copy_of(e->d_name, n - m);
        if (!contains(sections, section))
            complain(index, 1, "section '%s' is not in the toctree", section);
    }
    if (d != NULL)
        closedir(d);
}

int place_of_chapter(const char *folder)
{
    char path[512];
    int place = 0;
    snprintf(path, sizeof path, "%s/index.md", folder);
    struct list l = lines_of(path);
    for (int k = 0; k < l.count && place <= 0; k++)
        if (strncmp(l.at[k], ":order:", 7) == 0)
            place = atoi(l.at[k] + 7);
    return place > 0 ? place : INT_MAX;
}

/* Whether a text has Chinese characters, those from U+4E00 to U+9FFF: in UTF-8 they begin with the bytes E4 to E9. */
static int has_chinese(const char *text)
{
    for (; *text != '\0'; text++)
        if ((unsigned char)*text >= 0xE4 && (unsigned char)*text <= 0xE9)
            return 1;
    return 0;
}

static void append_once(struct list *to, char *id)
{
    for (int m = 0; m < to->count; m++)
        if (strcmp(to->at[m], id) == 0)
            return;
    append(to, id);
}

/* Whether the line is ":for: n = 1.." or the like: a range without end. */
static int is_for_every(const char *line)
{
    const char *dots = strncmp(line, ":for: ", 6) == 0 ? strstr(line, "..") : NULL;
    while (dots != NULL && dots[2 + strspn(dots + 2, " ")] != ',' && dots[2 + strspn(dots + 2, " ")] != '\0')
        dots = strstr(dots + 2, "..");
    return dots != NULL;
}

/* The ids of the statements whose formulas cagd check reads from their print, each once; and of those that are read for every n. */
static void read_printed(struct book *book, const char *folder)
{
    static const char begin[] = ":::{printed} ";
    char pattern[512];
    glob_t files;
    snprintf(pattern, sizeof pattern, "%s/print*.md", folder);
    if (glob(pattern, 0, NULL, &files) != 0)
        return;
    for (size_t f = 0; f < files.gl_pathc; f++) {
        struct list l = lines_of(files.gl_pathv[f]);
        for (int k = 0; k < l.count; k++) {
            if (strncmp(l.at[k], begin, sizeof begin - 1) != 0)
                continue;
            char *id = trimmed(whole_copy(l.at[k] + sizeof begin - 1));
            append_once(&book->printed, id);
            while (k + 1 < l.count && strcmp(trimmed(l.at[k + 1]), ":::") != 0)
                if (is_for_every(l.at[++k]))
                    append_once(&book->for_every, id);
        }
    }
    globfree(&files);
}

void read_chapter(struct book *book, const char *folder)
{
    const char *slash = strrchr(folder, '/'), *chapter = slash != NULL ? slash + 1 : folder;
    char path[512], *title = whole_copy(chapter);
    snprintf(path, sizeof path, "%s/index.md", folder);
    struct list l = lines_of(path), sections = {0};
    int in_toctree = 0;
    for (int k = 0; k < l.count; k++) {
        char *line = trimmed(whole_copy(l.at[k]));
        if (strncmp(line, "# ", 2) == 0)
            title = line + 2;
        else if (strncmp(line, "```{toctree}", 12) == 0)
            in_toctree = 1;
        else if (strncmp(line, "```", 3) == 0)
            in_toctree = 0;
        else if (in_toctree && line[0] != '\0' && line[0] != ':')
            append(&sections, line);
    }
    if (l.count == 0)
        complain(path, 1, "a chapter needs an index.md");
    int before = book->blocks;
    if (has_chinese(title))
        append(&book->bilingual, whole_copy(chapter));
    read_blocks(book, &l, path, chapter);
    for (int k = 0; k < sections.count; k++)
        read_section(book, folder, chapter, sections.at[k]);
    check_listed(folder, path, &sections);
    read_printed(book, folder);
    for (int k = before; sections.count == 0 && k < book->blocks; k++)
        if (book->block[k].kind == SOURCE_BLOCK)
            return; /* sources only */
    append(&book->chapters, whole_copy(chapter));
    append(&book->titles, title);
}
