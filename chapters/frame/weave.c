/* weave.c -- collects the claims and statements from the comments of the chapter files.
 *
 *     weave REGISTER.c TYPES CHAPTER_FOLDER...
 *
 * A chapter folder has an index.md whose toctree lists its sections in reading order; section S is
 * the file S.claims.h and, where it is drawn, S.figure.c.  In the comments of a section stand blocks
 *
 *     :::{statement} wang-ch3:3.2.8          :::{claim} elevation_keeps_rational_curve
 *     :title: ...                            :title: ...
 *     :holds-by: elevation_keeps_...         :control: ...
 *                                            :::
 *     A paragraph on it.                     CLAIM(elevation_keeps_rational_curve) { ... }
 *     :::
 *
 * An option goes on to the next line that begins with ':' or is blank; the rest of a block is its
 * note.  The register, C tables of what was found, is written to REGISTER.c.  A missing field, an
 * unknown word, a claim without a block or a body, a link to nothing or to a claim of the wrong kind,
 * a section that the index does not list: each is an error that names file and line, and stops the
 * build.  TYPES are the number types that are compiled, such as
 * "field rational interval double"; a claim that has none of them is left out. */
#include <ctype.h>
#include <dirent.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int errors;

static void complain(const char *file, int line, const char *format, ...) __attribute__((format(printf, 3, 4)));
static void complain(const char *file, int line, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    fprintf(stderr, "%s:%d: ", file, line);
    vfprintf(stderr, format, list);
    fputc('\n', stderr);
    va_end(list);
    errors++;
}

static void *must(void *p)
{
    if (p == NULL) {
        fputs("weave: out of memory\n", stderr);
        exit(3);
    }
    return p;
}

/* ---- strings and lists ------------------------------------------------------------------------ */

static char *copy_of(const char *s, size_t n)
{
    char *r = must(malloc(n + 1));
    memcpy(r, s, n);
    r[n] = '\0';
    return r;
}

/* s itself, the blanks at its ends taken away. */
static char *trimmed(char *s)
{
    size_t blanks = 0, n = strlen(s);
    while (isspace((unsigned char)s[blanks]))
        blanks++;
    n -= blanks;
    memmove(s, s + blanks, n + 1);
    while (n > 0 && isspace((unsigned char)s[n - 1]))
        s[--n] = '\0';
    return s;
}

/* a, a blank (or newline) and b. */
static char *joined(char *a, char between, const char *b)
{
    size_t n = strlen(a), m = strlen(b);
    char *r = must(malloc(n + m + 2));
    memcpy(r, a, n);
    if (n > 0)
        r[n++] = between;
    memcpy(r + n, b, m + 1);
    free(a);
    return r;
}

struct list {
    char **at;
    int count;
};
static void append(struct list *l, char *s)
{
    l->at = must(realloc(l->at, (size_t)(l->count + 1) * sizeof *l->at));
    l->at[l->count++] = s;
}
static int contains(const struct list *l, const char *s)
{
    for (int k = 0; k < l->count; k++)
        if (strcmp(l->at[k], s) == 0)
            return 1;
    return 0;
}

static struct list lines_of(const char *path)
{
    struct list l = {0};
    FILE *f = fopen(path, "r");
    if (f == NULL)
        return l;
    char *line = NULL;
    size_t room = 0;
    for (ssize_t n; (n = getline(&line, &room, f)) >= 0;)
        append(&l, copy_of(line, (size_t)(n > 0 && line[n - 1] == '\n' ? n - 1 : n)));
    free(line);
    fclose(f);
    return l;
}

/* ---- blocks ------------------------------------------------------------------------------------- */

struct option {
    char *key, *value;
    int line;
};
struct block {
    int is_claim, line, options;
    char *name, *note, *file, *chapter;
    struct option *option;
};
static struct block *blocks;
static int block_count;
static struct body {
    char *name, *file; /* CLAIM(name) */
    int line;
} * bodies;
static int body_count;
static struct list figures; /* names in FIGURE(...) */

static const char *value_of(const struct block *b, const char *key)
{
    for (int k = 0; k < b->options; k++)
        if (strcmp(b->option[k].key, key) == 0)
            return b->option[k].value;
    return NULL;
}

/* Reads the block whose first line is at l->at[k]; returns the index of its closing line. */
static int read_block(const struct list *l, int k, const char *file, const char *chapter, const char *head)
{
    struct block b = {.is_claim = strncmp(head, "claim}", 6) == 0,
                      .line = k + 1,
                      .name = trimmed(copy_of(strchr(head, '}') + 1, strlen(strchr(head, '}') + 1))),
                      .note = copy_of("", 0),
                      .file = copy_of(file, strlen(file)),
                      .chapter = copy_of(chapter, strlen(chapter))};
    int in_options = 1;
    for (k++; k < l->count && strcmp(l->at[k], ":::") != 0; k++) {
        char *line = l->at[k];
        if (in_options && line[0] == ':' && strchr(line + 1, ':') != NULL) {
            char *end = strchr(line + 1, ':');
            b.option = must(realloc(b.option, (size_t)(b.options + 1) * sizeof *b.option));
            b.option[b.options++] = (struct option){copy_of(line + 1, (size_t)(end - line - 1)),
                                                    trimmed(copy_of(end + 1, strlen(end + 1))), k + 1};
        } else if (in_options && b.options > 0 && trimmed(copy_of(line, strlen(line)))[0] != '\0') {
            struct option *o = &b.option[b.options - 1];
            o->value = joined(o->value, ' ', trimmed(copy_of(line, strlen(line))));
        } else {
            in_options = 0;
            b.note = joined(b.note, '\n', line);
        }
    }
    b.note = trimmed(b.note);
    if (k == l->count)
        complain(file, b.line, "block '%s' has no closing :::", b.name);
    blocks = must(realloc(blocks, (size_t)(block_count + 1) * sizeof *blocks));
    blocks[block_count++] = b;
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

static void read_section(const char *folder, const char *chapter, const char *section)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s.claims.h", folder, section);
    struct list l = lines_of(path);
    if (l.count == 0)
        complain(path, 1, "the index lists this section, but there is no such file");
    for (int k = 0; k < l.count; k++) {
        char *head = l.at[k], *name;
        if (strncmp(head, ":::{claim}", 10) == 0 || strncmp(head, ":::{statement}", 14) == 0) {
            k = read_block(&l, k, path, chapter, head + 4);
        } else if (strncmp(head, ":::", 3) == 0) {
            complain(path, k + 1, "'%s' begins neither a claim nor a statement", head);
        } else if ((name = called(head, "CLAIM")) != NULL) {
            bodies = must(realloc(bodies, (size_t)(body_count + 1) * sizeof *bodies));
            bodies[body_count++] = (struct body){name, copy_of(path, strlen(path)), k + 1};
        }
    }
    snprintf(path, sizeof path, "%s/%s.figure.c", folder, section);
    l = lines_of(path);
    for (int k = 0; k < l.count; k++) {
        char *name = called(l.at[k], "FIGURE");
        if (name != NULL && contains(&figures, name))
            complain(path, k + 1, "there is another FIGURE(%s)", name);
        if (name != NULL)
            append(&figures, name);
    }
}

/* ---- checks --------------------------------------------------------------------------------------- */

static const struct block *block_named(const char *name, int is_claim)
{
    for (int k = 0; k < block_count; k++)
        if (blocks[k].is_claim == is_claim && strcmp(blocks[k].name, name) == 0)
            return &blocks[k];
    return NULL;
}

static const struct {
    const char *key, *name;
    int has_text; /* written claim | text, or text alone; the others list claims */
} roles[] = {{"holds-by", "HOLDS_BY", 0},     {"refuted-by", "REFUTED_BY", 0}, {"corrected-by", "CORRECTED_BY", 0},
             {"hypothesis", "HYPOTHESIS", 1}, {"needs", "NEEDS", 1},           {"reading", "READING", 1},
             {"checked-by", "CHECKED_BY", 0}};
enum { ROLES = sizeof roles / sizeof *roles };

static int is_role(const char *key)
{
    for (int role = 0; role < ROLES; role++)
        if (strcmp(roles[role].key, key) == 0)
            return 1;
    return 0;
}

static int has_body(const char *name)
{
    for (int k = 0; k < body_count; k++)
        if (strcmp(bodies[k].name, name) == 0)
            return 1;
    return 0;
}

static void check_keys(const struct block *b, const char *const known[], const char *const needed[])
{
    for (int k = 0; k < b->options; k++) {
        int found = 0;
        for (int j = 0; known[j] != NULL; j++)
            found |= strcmp(known[j], b->option[k].key) == 0;
        if (!found)
            complain(b->file, b->option[k].line, "unknown option '%s'", b->option[k].key);
        for (int j = 0; j < k; j++)
            if (strcmp(b->option[j].key, b->option[k].key) == 0 && !is_role(b->option[k].key))
                complain(b->file, b->option[k].line, "option '%s' occurs twice", b->option[k].key);
    }
    for (int j = 0; needed[j] != NULL; j++) {
        const char *v = value_of(b, needed[j]);
        if (v == NULL || *v == '\0')
            complain(b->file, b->line, "'%s' has no %s", b->name, needed[j]);
    }
    static const char *const plain[] = {"title", "zh"}; /* they stand in tables */
    for (int j = 0; j < 2; j++)
        if (value_of(b, plain[j]) != NULL && strpbrk(value_of(b, plain[j]), "$\\") != NULL)
            complain(b->file, b->line, "'%s': a title has no formulas in TeX", b->name);
}

static int is_one_of(const char *word, const char *const words[])
{
    for (int k = 0; words[k] != NULL; k++)
        if (strcmp(words[k], word) == 0)
            return 1;
    return 0;
}

static void check_claim(const struct block *b)
{
    static const char *const known[] = {"title", "zh",      "given", "let",     "then",    "method", "kind",
                                        "types", "degrees", "scope", "control", "defines", NULL};
    static const char *const needed[] = {"title", "zh", "given", "then", "method", "control", NULL};
    static const char *const kinds[] = {"identity", "decision", "counterexample", NULL};
    static const char *const all_types[] = {"field", "rational", "interval", "double", NULL};
    check_keys(b, known, needed);
    const char *kind = value_of(b, "kind");
    if (kind != NULL && !is_one_of(kind, kinds))
        complain(b->file, b->line, "'%s': unknown kind '%s'", b->name, kind);
    const char *types = value_of(b, "types");
    if (types != NULL && *types == '\0')
        complain(b->file, b->line, "'%s' lists no types", b->name);
    char *listed = copy_of(types != NULL ? types : "", types != NULL ? strlen(types) : 0);
    for (char *word = strtok(listed, " "); word != NULL; word = strtok(NULL, " "))
        if (!is_one_of(word, all_types))
            complain(b->file, b->line, "'%s': unknown type '%s'", b->name, word);
    if (!has_body(b->name))
        complain(b->file, b->line, "claim '%s' has no body CLAIM(%s)", b->name, b->name);
}

static void check_statement(const struct block *b)
{
    static const char *const known[] = {
        "title",      "zh",           "printed",    "class", "corrected", "figure",     "definition", "holds-by",
        "refuted-by", "corrected-by", "hypothesis", "needs", "reading",   "checked-by", "striking",   NULL};
    static const char *const needed[] = {"title", "zh", "printed", NULL};
    static const char *const classes[] = {"misprint", "false", "missing-hypothesis", "invalid-proof", NULL};
    check_keys(b, known, needed);
    const char *class = value_of(b, "class"), *figure = value_of(b, "figure");
    if (class != NULL && !is_one_of(class, classes))
        complain(b->file, b->line, "'%s': unknown class '%s'", b->name, class);
    if ((value_of(b, "refuted-by") != NULL) != (class != NULL))
        complain(b->file, b->line, "'%s': a refuted statement, and no other, has a class", b->name);
    if ((value_of(b, "corrected") != NULL) != (value_of(b, "corrected-by") != NULL))
        complain(b->file, b->line, "'%s': a corrected statement and its claim come together", b->name);
    if (class != NULL && value_of(b, "corrected") == NULL)
        complain(b->file, b->line, "'%s' is refuted but not corrected", b->name);
    if (figure != NULL && !contains(&figures, figure))
        complain(b->file, b->line, "'%s': there is no FIGURE(%s)", b->name, figure);
}

/* ---- output ----------------------------------------------------------------------------------------- */

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

static const char *compiled_types;

/* Whether the claim is run in the type, by its option `types`; decisions are rational unless it says
 * otherwise. */
static int has_type(const struct block *b, const char *type)
{
    if (strstr(compiled_types, type) == NULL)
        return 0;
    const char *types = value_of(b, "types"), *kind = value_of(b, "kind");
    if (types == NULL)
        types = kind == NULL || strcmp(kind, "identity") == 0 ? "field rational interval double" : "rational";
    return strstr(types, type) != NULL;
}

static int is_compiled(const struct block *b)
{
    return has_type(b, "field") || has_type(b, "rational") || has_type(b, "interval") || has_type(b, "double");
}

static void put_claim(FILE *out, const struct block *b)
{
    static const char *const type[] = {"field", "rational", "interval", "double"};
    static const char *const tag[] = {"FIELD_TYPE", "RATIONAL_TYPE", "INTERVAL_TYPE", "DOUBLE_TYPE"};
    static const char suffix[] = "fqim";
    const char *kind = value_of(b, "kind"), *degrees = value_of(b, "degrees");
    int low = 0, high = 0, sampled = 0, all = degrees != NULL && strcmp(degrees, "all") == 0;
    if (degrees != NULL && !all) {
        int read = sscanf(degrees, "%d..%d sampled %d", &low, &high, &sampled);
        if (read < 2 || low < 0 || high < low)
            complain(b->file, b->line, "'%s': degrees are written as 1..6 or 1..6 sampled 12", b->name);
    }
    fputs("    {.name = ", out);
    put_string(out, b->name);
    put_field(out, "title", value_of(b, "title"));
    put_field(out, "title_zh", value_of(b, "zh"));
    put_field(out, "given", value_of(b, "given"));
    put_field(out, "let", value_of(b, "let"));
    put_field(out, "then", value_of(b, "then"));
    put_field(out, "method", value_of(b, "method"));
    put_field(out, "control", value_of(b, "control"));
    put_field(out, "scope", value_of(b, "scope"));
    put_field(out, "defines", value_of(b, "defines"));
    put_field(out, "chapter", b->chapter);
    put_field(out, "file", b->file);
    fprintf(out,
            ", .line = %d, .kind = %s, .degree_low = %d, .degree_high = %d, .degree_sampled = %d, .all_degrees = %d",
            b->line,
            kind == NULL || kind[0] == 'i' ? "IDENTITY"
            : kind[0] == 'd'               ? "DECISION"
                                           : "COUNTEREXAMPLE",
            low, high, sampled > high ? sampled : high, all);
    fputs(", .body = {", out);
    for (int t = 0; t < 4; t++)
        if (has_type(b, type[t]))
            fprintf(out, "[%s] = claim_%s_%c, ", tag[t], b->name, suffix[t]);
    fputs("}},\n", out);
}

/* What refutes is a counterexample; what decides that something is true is none. */
static void check_link(const struct block *b, int role, const char *claim)
{
    const struct block *target = block_named(claim, 1);
    if (target == NULL) {
        complain(b->file, b->line, "'%s' names a claim that does not exist: '%s'", b->name, claim);
        return;
    }
    const char *kind = value_of(target, "kind"), *key = roles[role].key;
    int is_counterexample = kind != NULL && strcmp(kind, "counterexample") == 0;
    int refutes = strcmp(key, "refuted-by") == 0;
    if (refutes && !is_counterexample)
        complain(b->file, b->line, "'%s' is refuted by '%s', which is no counterexample", b->name, claim);
    if (!refutes && !roles[role].has_text && is_counterexample)
        complain(b->file, b->line, "'%s' lists the counterexample '%s' under %s", b->name, claim, key);
}

static void put_link(FILE *out, const struct block *b, int role, const char *claim, const char *text)
{
    if (claim != NULL)
        check_link(b, role, claim);
    fprintf(out, "    {%s, ", roles[role].name);
    if (claim == NULL)
        fputs("NULL", out);
    else
        put_string(out, claim);
    fputs(", ", out);
    put_string(out, text);
    fputs("},\n", out);
}

static void put_links(FILE *out, const struct block *b, int index)
{
    fprintf(out, "static const statement_link links_%d[] = {\n", index);
    for (int k = 0; k < b->options; k++)
        for (int role = 0; role < ROLES; role++) {
            if (strcmp(roles[role].key, b->option[k].key) != 0)
                continue;
            char *value = copy_of(b->option[k].value, strlen(b->option[k].value));
            if (roles[role].has_text) {
                char *bar = strchr(value, '|');
                if (bar == NULL && strcmp(roles[role].key, "reading") != 0)
                    complain(b->file, b->option[k].line, "'%s' has a %s that no claim tries: claim | text", b->name,
                             roles[role].key);
                if (bar == NULL) {
                    put_link(out, b, role, NULL, value);
                } else {
                    *bar = '\0';
                    put_link(out, b, role, trimmed(value), trimmed(bar + 1));
                }
            } else {
                for (char *word = strtok(value, " "); word != NULL; word = strtok(NULL, " "))
                    put_link(out, b, role, word, "");
            }
        }
    fputs("    {HOLDS_BY, NULL, NULL}};\n", out);
}

static void put_statement(FILE *out, const struct block *b, int index)
{
    fputs("    {.id = ", out);
    put_string(out, b->name);
    put_field(out, "title", value_of(b, "title"));
    put_field(out, "title_zh", value_of(b, "zh"));
    put_field(out, "printed", value_of(b, "printed"));
    put_field(out, "class", value_of(b, "class"));
    put_field(out, "corrected", value_of(b, "corrected"));
    put_field(out, "figure", value_of(b, "figure"));
    put_field(out, "note", b->note);
    put_field(out, "chapter", b->chapter);
    put_field(out, "file", b->file);
    const char *rank = value_of(b, "striking");
    fprintf(out, ", .line = %d, .is_definition = %d, .striking = %d, .links = links_%d},\n", b->line,
            value_of(b, "definition") != NULL, rank != NULL ? atoi(rank) : 0, index);
}

static void put_register(FILE *out, const struct list *chapters, const struct list *titles)
{
    fputs("/* Written by weave from the comments of the chapter files. */\n"
          "#include \"chapters/frame/claim.h\"\n#include \"chapters/frame/figure.h\"\n\n#include <stddef.h>\n\n",
          out);
    static const char suffix[] = "fqim";
    static const char *const type[] = {"field", "rational", "interval", "double"};
    for (int k = 0; k < block_count; k++)
        for (int t = 0; t < 4; t++)
            if (blocks[k].is_claim && has_type(&blocks[k], type[t]))
                fprintf(out, "void claim_%s_%c(trial *T);\n", blocks[k].name, suffix[t]);
    fputs("\nconst claim all_claims[] = {\n", out);
    for (int k = 0; k < block_count; k++)
        if (blocks[k].is_claim && is_compiled(&blocks[k]))
            put_claim(out, &blocks[k]);
    fputs("    {.name = NULL}};\n\n", out);
    for (int k = 0; k < block_count; k++)
        if (!blocks[k].is_claim)
            put_links(out, &blocks[k], k);
    fputs("\nconst statement all_statements[] = {\n", out);
    for (int k = 0; k < block_count; k++)
        if (!blocks[k].is_claim)
            put_statement(out, &blocks[k], k);
    fputs("    {.id = NULL}};\n\nconst chapter all_chapters[] = {\n", out);
    for (int k = 0; k < chapters->count; k++) {
        fputs("    {", out);
        put_string(out, chapters->at[k]);
        fputs(", ", out);
        put_string(out, titles->at[k]);
        fputs("},\n", out);
    }
    fputs("    {NULL, NULL}};\n\n", out);
    for (int k = 0; k < figures.count; k++)
        fprintf(out, "FIGURE(%s);\n", figures.at[k]);
    fputs("\nconst figure all_figures[] = {\n", out);
    for (int k = 0; k < figures.count; k++)
        fprintf(out, "    {\"%s\", figure_%s},\n", figures.at[k], figures.at[k]);
    fputs("    {NULL, NULL}};\n", out);
}

/* A section that the index forgets would be compiled, and never judged. */
static void check_listed(const char *folder, const char *index, const struct list *sections)
{
    static const char suffix[] = ".claims.h";
    DIR *d = opendir(folder);
    for (struct dirent *entry; d != NULL && (entry = readdir(d)) != NULL;) {
        size_t n = strlen(entry->d_name), m = strlen(suffix);
        if (n <= m || strcmp(entry->d_name + n - m, suffix) != 0)
            continue;
        char *section = copy_of(entry->d_name, n - m);
        if (!contains(sections, section))
            complain(index, 1, "section '%s' is not in the toctree", section);
        free(section);
    }
    if (d != NULL)
        closedir(d);
}

int main(int argc, char **argv)
{
    if (argc < 4) {
        fputs("usage: weave REGISTER.c TYPES CHAPTER_FOLDER...\n", stderr);
        return 2;
    }
    compiled_types = argv[2];
    struct list chapters = {0}, titles = {0};
    for (int k = 3; k < argc; k++) {
        char path[512];
        const char *slash = strrchr(argv[k], '/'), *chapter = slash != NULL ? slash + 1 : argv[k];
        snprintf(path, sizeof path, "%s/index.md", argv[k]);
        struct list l = lines_of(path), sections = {0};
        char *title = copy_of(chapter, strlen(chapter));
        int in_toctree = 0;
        for (int j = 0; j < l.count; j++) {
            char *line = trimmed(copy_of(l.at[j], strlen(l.at[j])));
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
        for (int j = 0; j < sections.count; j++)
            read_section(argv[k], chapter, sections.at[j]);
        check_listed(argv[k], path, &sections);
        append(&chapters, copy_of(chapter, strlen(chapter)));
        append(&titles, title);
    }
    for (int k = 0; k < block_count; k++) {
        (blocks[k].is_claim ? check_claim : check_statement)(&blocks[k]);
        for (int j = 0; j < k; j++)
            if (blocks[j].is_claim == blocks[k].is_claim && strcmp(blocks[j].name, blocks[k].name) == 0)
                complain(blocks[k].file, blocks[k].line, "'%s' occurs twice", blocks[k].name);
    }
    for (int k = 0; k < body_count; k++)
        if (block_named(bodies[k].name, 1) == NULL)
            complain(bodies[k].file, bodies[k].line, "CLAIM(%s) has no claim block", bodies[k].name);
    FILE *out = fopen(argv[1], "w");
    if (out == NULL) {
        perror(argv[1]);
        return 3;
    }
    put_register(out, &chapters, &titles);
    if (fclose(out) != 0)
        return 3;
    if (errors > 0)
        remove(argv[1]);
    return errors > 0;
}
