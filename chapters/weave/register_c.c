/* register_c.c -- the register as C tables. */
#include "chapters/weave/book.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void put_string(FILE *out, const char *s)
{
    fputc('"', out);
    for (; s != NULL && *s; s++)
        switch (*s) {
        case '"':
            fputs("\\\"", out);
            break;
        case '\\':
            fputs("\\\\", out);
            break;
        case '\n':
            fputs("\\n", out);
            break;
        case '?':
            fputs("\\?", out);
            break;
        default:
            fputc(*s, out);
        }
    fputc('"', out);
}

static void put_field(FILE *out, const char *field, const char *s)
{
    fprintf(out, ", .%s = ", field);
    put_string(out, s);
}

static void put_option(FILE *out, const char *field, const struct block *b, const char *key)
{
    put_field(out, field, value_of(b, key));
}

#define TYPE_NAME(tag, name, suffix, kernels) #tag "_TYPE",
#define SUFFIX(tag, name, suffix, kernels)    #suffix,
#define KIND(tag, name)                       #tag,
#define ROLE(tag, key, form)                  #tag,
#define PLACE(tag, key)                       "IN_" #tag,
static const char *const type_tags[] = {NUMBER_TYPE_LIST(TYPE_NAME)};
static const char *const suffixes[] = {NUMBER_TYPE_LIST(SUFFIX)};
static const char *const kind_tags[] = {KIND_LIST(KIND)};
static const char *const role_tags[] = {ROLE_LIST(ROLE)};
static const char *const place_tags[] = {DATA_LIST(PLACE)};

/* ---- claims --------------------------------------------------------------------------------------- */

static void put_data(FILE *out, const struct block *b, int index)
{
    for (int k = 0; k < b->entries; k++) {
        const struct entry *e = &b->entry[k];
        fprintf(out, "static const char *const values_%d_%d[] = {", index, k);
        for (int j = 0; j < e->values.count; j++) {
            fputs(j > 0 ? ", " : "", out);
            put_string(out, e->values.at[j]);
        }
        fputs("};\n", out);
    }
    fprintf(out, "static const datum data_%d[] = {\n", index);
    for (int k = 0; k < b->entries; k++) {
        const struct entry *e = &b->entry[k];
        fputs("    {.name = ", out);
        put_string(out, e->name);
        put_field(out, "text", e->text);
        fprintf(out, ", .place = %s, .rows = %d, .columns = %d, .value = values_%d_%d},\n", place_tags[e->place],
                e->rows, e->columns, index, k);
    }
    fputs("    {.name = NULL}};\n", out);
}

/* What the variables of a claim stand for: what its block says, before what the letters of the chapter say. */
static char *over_of(const struct book *book, const struct block *b)
{
    const struct block *letters = block_named(book, b->chapter, LETTERS_BLOCK);
    const char *own = value_of(b, "over"), *all = letters != NULL ? value_of(letters, "over") : NULL;
    char *over = whole_copy(own != NULL ? own : "");
    return all != NULL ? joined(over, ';', all) : over;
}

/* The letter of its degrees, its own before that of the chapter. */
static const char *letter_of(const struct book *book, const struct block *b, const struct degrees *d)
{
    const struct block *letters = block_named(book, b->chapter, LETTERS_BLOCK);
    const char *letter = letters != NULL ? value_of(letters, "degree") : NULL;
    return d->letter[0] != '\0' ? d->letter : letter;
}

/* Which phrases of scopes are narrower than which: what the letters of all chapters declare, a row each. */
static char *within_of(const struct book *book)
{
    char *rows = whole_copy("");
    for (int k = 0; k < book->blocks; k++)
        for (int j = 0; book->block[k].kind == LETTERS_BLOCK && j < book->block[k].options; j++)
            if (strcmp(book->block[k].option[j].key, "within") == 0) {
                struct link row = read_link(book->block[k].option[j].value, PLACE_TEXT);
                rows = joined(joined(rows, ';', row.place), ' ', joined(whole_copy("|"), ' ', row.text));
            }
    return rows;
}

/* The table that all claims share, character by character: it is longer than the string literals that every compiler takes. */
static void put_within(FILE *out, const struct book *book)
{
    char *rows = within_of(book);
    fputs("\nstatic const char within[] = {", out);
    for (const char *at = rows; *at != '\0'; at++)
        fprintf(out, "%s'\\x%02x',", (at - rows) % 16 == 0 ? "\n    " : " ", (unsigned)(unsigned char)*at);
    fputs("\n    '\\0'};\n", out);
    free(rows);
}

static void put_argument(FILE *out, const char *argued)
{
    struct link link = read_link(argued != NULL ? argued : "", PLACE_TEXT);
    put_field(out, "argued_for", link.place);
    put_field(out, "argued", link.text);
}

static void put_claim(FILE *out, const struct book *book, const struct block *b, int index)
{
    struct degrees d;
    (void)read_degrees(b, &d);
    fputs("    {.name = ", out);
    put_string(out, b->name);
    put_option(out, "title", b, "title");
    put_option(out, "title_zh", b, "zh");
    put_option(out, "given", b, "given");
    put_option(out, "let", b, "let");
    put_option(out, "then", b, "then");
    put_option(out, "method", b, "method");
    put_option(out, "control", b, "control");
    put_option(out, "scope", b, "scope");
    put_option(out, "where", b, "where");
    put_option(out, "defines", b, "defines");
    put_field(out, "over", over_of(book, b));
    put_field(out, "letter", letter_of(book, b, &d));
    fputs(", .within = within", out);
    put_argument(out, value_of(b, "argued"));
    put_field(out, "chapter", b->chapter);
    put_field(out, "file", b->file);
    fprintf(out,
            ", .line = %d, .kind = %s, .degree_low = %d, .degree_high = %d, .degree_sampled = %d, .all_degrees = %d",
            b->line, kind_of(b) < KINDS ? kind_tags[kind_of(b)] : "KINDS", d.low, d.high, d.sampled, d.all);
    if (b->entries > 0)
        fprintf(out, ", .data = data_%d", index);
    fputs(", .body = {", out);
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        if (has_type(book, b, t))
            fprintf(out, "[%s] = claim_%s_%s, ", type_tags[t], b->name, suffixes[t]);
    fputs("}},\n", out);
}

static void put_claims(FILE *out, const struct book *book)
{
    for (int k = 0; k < book->blocks; k++)
        for (number_type t = 0; t < NUMBER_TYPES; t++)
            if (book->block[k].kind == CLAIM_BLOCK && has_type(book, &book->block[k], t))
                fprintf(out, "void claim_%s_%s(trial *T);\n", book->block[k].name, suffixes[t]);
    fputc('\n', out);
    for (int k = 0; k < book->blocks; k++)
        if (book->block[k].kind == CLAIM_BLOCK && book->block[k].entries > 0)
            put_data(out, &book->block[k], k);
    put_within(out, book);
    fputs("\nstatic const claim claims[] = {\n", out);
    for (int k = 0; k < book->blocks; k++)
        if (book->block[k].kind == CLAIM_BLOCK && is_compiled(book, &book->block[k]))
            put_claim(out, book, &book->block[k], k);
    fputs("    {.name = NULL}};\n\n", out);
}

/* ---- statements ------------------------------------------------------------------------------------ */

static void put_link(FILE *out, int r, const struct link *link, const char *letters)
{
    const char *digest = r == HYPOTHESIS || r == NEEDS ? first_clause(link->text) : letters;
    const char *const parts[] = {link->claim, link->place, link->text, digest};
    fprintf(out, "    {%s", role_tags[r]);
    for (int k = 0; k < 4; k++) {
        fputs(", ", out);
        if (parts[k] != NULL)
            put_string(out, parts[k]);
        else
            fputs("NULL", out);
    }
    fputs("},\n", out);
}

/* Whether the letter there is the index of a sum that begins with it: i in \sum_{i=0}^n, \sum_i. */
static int is_index_of_sum(const char *text, const char *letter)
{
    static const char *const sums[] = {"\\sum_{", "\\sum_", "\\prod_{", "\\prod_"};
    for (size_t k = 0; k < sizeof sums / sizeof *sums; k++) {
        size_t n = strlen(sums[k]);
        if ((size_t)(letter - text) >= n && strncmp(letter - n, sums[k], n) == 0)
            return 1;
    }
    return 0;
}

/* Adds the letters of the formulas in a text, each once: "t", "beta" for \beta; t_i is another one.  A text without dollar signs is a formula if it has
 * any sign of one, and three letters in a row are a word.  The index of a sum is no letter of its formula from there on. */
static char *with_letters(char *letters, const char *text)
{
    int mixed = strpbrk(text, "$=_^\\") == NULL || strchr(text, '$') != NULL, inside = !mixed;
    char *indices = whole_copy("");
    for (const char *at = text; *at != '\0'; at++) {
        inside ^= mixed && *at == '$';
        if (*at == '$')
            indices[0] = '\0';
        const char *name = at + (*at == '\\');
        size_t n = strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
        int is_command = *at == '\\';
        for (size_t k = 0; inside && k < n && (is_command || n < 3); k += is_command ? n : 1) {
            char *letter = copy_of(name + k, is_command ? n : 1);
            if (!is_command && k == 0 && is_index_of_sum(text, name))
                indices = joined(indices, ' ', letter);
            int has_index = name[k + strlen(letter)] == '_';
            if (!has_index && !has_word(letters, letter) && !has_word(indices, letter))
                letters = joined(letters, ' ', letter);
        }
        at = n > 0 ? name + n - 1 : at;
    }
    return letters;
}

static const struct block *source_of(const struct book *book, const struct block *b)
{
    return block_named(book, copy_of(b->name, strcspn(b->name, ":")), SOURCE_BLOCK);
}

/* The letters of a statement, as it is printed or corrected, and that of the parameter that all functions of its source have. */
static char *letters_of_statement(const struct book *book, const struct block *b)
{
    const struct block *source = source_of(book, b);
    const char *corrected = value_of(b, "corrected"), *shape = source != NULL ? value_of(source, "parameter") : NULL;
    char *letters = with_letters(whole_copy(""), value_of(b, "printed"));
    letters = with_letters(letters, corrected != NULL ? corrected : "");
    return shape != NULL && !has_word(letters, shape) ? joined(letters, ' ', shape) : letters;
}

static void put_links(FILE *out, const struct book *book, const struct block *b, int index)
{
    fprintf(out, "static const statement_link links_%d[] = {\n", index);
    for (int k = 0; k < b->options; k++) {
        int r = role_of(b->option[k].key);
        if (r == ROLES)
            continue;
        if (form_of(r) != CLAIM_LIST) {
            struct link link = read_link(b->option[k].value, form_of(r));
            char *letters = r == READING ? with_letters(letters_of_statement(book, b), link.text) : NULL;
            put_link(out, r, &link, letters);
        } else {
            char *words = whole_copy(b->option[k].value);
            for (char *word = strtok(words, " "); word != NULL; word = strtok(NULL, " "))
                put_link(out, r, &(struct link){word, NULL, whole_copy("")}, NULL);
        }
    }
    fputs("    {HOLDS_BY, NULL, NULL, NULL, NULL}};\n", out);
}

/* What a statement calls the degree: the letter of its source, or, where the statement does not have it, what the source counts
 * with it, "degree" or "order". */
static const char *name_of_degree(const struct book *book, const struct block *b, const char *letters)
{
    const struct block *source = source_of(book, b);
    const char *letter = source != NULL ? value_of(source, "letter") : NULL;
    const char *counts = source != NULL ? value_of(source, "counts") : NULL;
    return counts != NULL && !has_word(letters, letter != NULL ? letter : "n") ? counts : letter;
}

static void put_statement(FILE *out, const struct book *book, const struct block *b, int index)
{
    const char *rank = value_of(b, "striking"), *degree = value_of(b, "degree"),
               *letters = letters_of_statement(book, b);
    fputs("    {.id = ", out);
    put_string(out, b->name);
    put_option(out, "title", b, "title");
    put_option(out, "title_zh", b, "zh");
    put_option(out, "printed", b, "printed");
    put_option(out, "class", b, "class");
    put_option(out, "corrected", b, "corrected");
    put_option(out, "figure", b, "figure");
    put_option(out, "example", b, "example");
    put_field(out, "note", b->note);
    put_field(out, "letter", name_of_degree(book, b, letters));
    put_field(out, "letters", letters);
    put_field(out, "chapter", b->chapter);
    put_field(out, "file", b->file);
    fprintf(out, ", .line = %d, .is_definition = %d, .striking = %d, .degree = %d, .links = links_%d},\n", b->line,
            value_of(b, "definition") != NULL, rank != NULL ? atoi(rank) : 0, degree != NULL ? atoi(degree) : 0, index);
}

static void put_statements(FILE *out, const struct book *book)
{
    for (int k = 0; k < book->blocks; k++)
        if (book->block[k].kind == STATEMENT_BLOCK)
            put_links(out, book, &book->block[k], k);
    fputs("\nstatic const statement statements[] = {\n", out);
    for (int k = 0; k < book->blocks; k++)
        if (book->block[k].kind == STATEMENT_BLOCK)
            put_statement(out, book, &book->block[k], k);
    fputs("    {.id = NULL}};\n\n", out);
}

static void put_ids(FILE *out, const char *name, const struct list *ids)
{
    fprintf(out, "static const char *const %s[] = {\n", name);
    for (int k = 0; k < ids->count; k++)
        fprintf(out, "    \"%s\",\n", ids->at[k]);
    fputs("    NULL};\n\n", out);
}

/* ---- the rest --------------------------------------------------------------------------------------- */

static void put_sources(FILE *out, const struct book *book)
{
    fputs("static const source sources[] = {\n", out);
    for (int k = 0; k < book->blocks; k++) {
        const struct block *b = &book->block[k];
        if (b->kind != SOURCE_BLOCK)
            continue;
        fputs("    {.key = ", out);
        put_string(out, b->name);
        put_option(out, "author", b, "author");
        put_option(out, "title", b, "title");
        put_option(out, "title_zh", b, "zh");
        put_option(out, "year", b, "year");
        put_option(out, "publisher", b, "publisher");
        put_option(out, "part", b, "part");
        put_option(out, "letter", b, "letter");
        fputs("},\n", out);
    }
    fputs("    {.key = NULL}};\n\n", out);
}

static void put_block_data(FILE *out, const struct book *book)
{
    fputs("static const block_data blocks[] = {\n", out);
    for (int k = 0; k < book->blocks; k++)
        if (book->block[k].kind == CLAIM_BLOCK && book->block[k].entries > 0) {
            fputs("    {", out);
            put_string(out, book->block[k].name);
            fprintf(out, ", data_%d},\n", k);
        }
    fputs("    {NULL, NULL}};\n\n", out);
}

static void put_chapters(FILE *out, const struct book *book)
{
    fputs("static const chapter chapters[] = {\n", out);
    for (int k = 0; k < book->chapters.count; k++) {
        fputs("    {", out);
        put_string(out, book->chapters.at[k]);
        fputs(", ", out);
        put_string(out, book->titles.at[k]);
        fputs("},\n", out);
    }
    fputs("    {NULL, NULL}};\n\n", out);
}

static void put_figures(FILE *out, const struct book *book)
{
    for (int k = 0; k < book->figures.count; k++)
        fprintf(out, "FIGURE(%s);\n", book->figures.at[k]);
    fputs("\nstatic const figure figures[] = {\n", out);
    for (int k = 0; k < book->figures.count; k++)
        fprintf(out, "    {\"%s\", figure_%s},\n", book->figures.at[k], book->figures.at[k]);
    fputs("    {NULL, NULL}};\n\n", out);
}

int write_register_c(const struct book *book, const char *path)
{
    FILE *out = fopen(path, "w");
    if (out == NULL) {
        perror(path);
        return -1;
    }
    fputs("/* Written by weave from the comments of the chapter files. */\n#include \"chapters/chapters.h\"\n\n"
          "#include <stddef.h>\n\n",
          out);
    put_claims(out, book);
    put_statements(out, book);
    put_chapters(out, book);
    put_figures(out, book);
    put_sources(out, book);
    put_block_data(out, book);
    put_ids(out, "printed", &book->printed);
    put_ids(out, "for_every", &book->for_every);
    fputs("const cagd_register compiled_chapters = {claims, statements, chapters, figures, sources, blocks, printed, "
          "for_every};\n",
          out);
    if (fclose(out) != 0) {
        perror(path);
        return -1;
    }
    return 0;
}
