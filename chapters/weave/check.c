/* check.c -- what is missing, unknown, twice, or leads nowhere. */
#include "chapters/weave/book.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int is_one_of(const char *word, const char *const words[])
{
    for (int k = 0; words[k] != NULL; k++)
        if (strcmp(words[k], word) == 0)
            return 1;
    return 0;
}

#define KEY(tag, key, form) key,
#define PLACE(tag, key)     key,
static const char *const role_keys[] = {ROLE_LIST(KEY) NULL};

static void check_keys(const struct block *b, const char *const known[], const char *const more[],
                       const char *const needed[])
{
    for (int k = 0; k < b->options; k++) {
        const char *key = b->option[k].key;
        if (!is_one_of(key, known) && !is_one_of(key, more))
            complain(b->file, b->option[k].line, "unknown option '%s'", key);
        for (int j = 0; j < k; j++)
            if (strcmp(b->option[j].key, key) == 0 && !is_one_of(key, more))
                complain(b->file, b->option[k].line, "option '%s' occurs twice", key);
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

/* A chapter whose heading is in two languages has its titles in both. */
static void check_chinese(const struct book *book, const struct block *b)
{
    const char *zh = value_of(b, "zh");
    if (contains(&book->bilingual, b->chapter) && (zh == NULL || *zh == '\0'))
        complain(b->file, b->line, "'%s' has no zh, a Chinese title as the heading of its chapter has one", b->name);
}

static void check_types(const struct block *b)
{
#define NAME(tag, name, suffix, kernels) #name,
    static const char *const all_types[] = {NUMBER_TYPE_LIST(NAME) NULL};
#undef NAME
    const char *types = value_of(b, "types");
    if (types != NULL && *types == '\0')
        complain(b->file, b->line, "'%s' lists no types", b->name);
    char *listed = whole_copy(types != NULL ? types : "");
    for (char *word = strtok(listed, " "); word != NULL; word = strtok(NULL, " "))
        if (!is_one_of(word, all_types))
            complain(b->file, b->line, "'%s': unknown type '%s'", b->name, word);
}

/* The claim's body, or its first where two number types have different ones, follows its block: no other block and no
 * other body stands between them. */
static void check_body(const struct book *book, const struct block *b)
{
    const struct body *mine = NULL;
    for (int k = book->bodies - 1; k >= 0; k--)
        if (strcmp(book->body[k].name, b->name) == 0)
            mine = &book->body[k];
    if (mine == NULL) {
        complain(b->file, b->line, "claim '%s' has no body CLAIM(%s)", b->name, b->name);
        return;
    }
    int apart = strcmp(mine->file, b->file) != 0 || mine->line < b->line;
    for (int k = 0; k < book->bodies; k++)
        apart |=
            strcmp(book->body[k].file, b->file) == 0 && b->line < book->body[k].line && book->body[k].line < mine->line;
    for (int k = 0; k < book->blocks; k++)
        apart |= strcmp(book->block[k].file, b->file) == 0 && b->line < book->block[k].line &&
                 book->block[k].line < mine->line;
    if (apart)
        complain(b->file, b->line, "the body of claim '%s', line %d, does not follow its block", b->name, mine->line);
}

/* What is given and yet no condition, "words of given | why": the words stand in what is given. */
static void check_conditions(const struct block *b)
{
    const char *where = value_of(b, "where"), *given = value_of(b, "given");
    if (where != NULL && (*where == '\0' || kind_of(b) == COUNTEREXAMPLE))
        complain(b->file, b->line, "'%s': where says on what a decision or an identity stands, one condition; another",
                 b->name);
    for (int k = 0; k < b->options; k++) {
        if (strcmp(b->option[k].key, "harmless") != 0)
            continue;
        struct link link = read_link(b->option[k].value, PLACE_TEXT);
        if (link.place == NULL || link.place[0] == '\0' || link.text[0] == '\0' || given == NULL ||
            strstr(given, link.place) == NULL)
            complain(b->file, b->option[k].line, "'%s': harmless is written as words of what is given | why", b->name);
    }
}

static void check_claim(const struct book *book, const struct block *b)
{
    static const char *const known[] = {"title",   "zh",    "given", "let",  "then",   "method",  "kind",    "types",
                                        "degrees", "scope", "where", "over", "argued", "control", "defines", NULL};
    static const char *const repeated[] = {DATA_LIST(PLACE) "harmless", NULL};
    static const char *const needed[] = {"title", "given", "then", "method", "control", NULL};
    struct degrees d;
    check_keys(b, known, repeated, needed);
    check_conditions(b);
    check_chinese(book, b);
    if (kind_of(b) == KINDS)
        complain(b->file, b->line, "'%s': unknown kind '%s'", b->name, value_of(b, "kind"));
    if (!read_degrees(b, &d))
        complain(b->file, b->line, "'%s': degrees are written as 1..6, k = 1..6 sampled 12, all or all from 2",
                 b->name);
    if (value_of(b, "argued") != NULL && strchr(value_of(b, "argued"), '|') == NULL)
        complain(b->file, b->line, "'%s': what is argued is written as cases | text", b->name);
    check_types(b);
    check_body(book, b);
}

/* What refutes is a counterexample; what decides that something is true is none. */
static void check_link(const struct book *book, const struct block *b, int r, const char *name)
{
    const struct block *target = block_named(book, name, CLAIM_BLOCK);
    if (target == NULL) {
        complain(b->file, b->line, "'%s' names a name that does not exist: '%s'", b->name, name);
        return;
    }
    int is_counterexample = kind_of(target) == COUNTEREXAMPLE;
    if (r == REFUTED_BY && !is_counterexample)
        complain(b->file, b->line, "'%s' is refuted by '%s', which is no counterexample", b->name, name);
    if (r != REFUTED_BY && form_of(r) == CLAIM_LIST && is_counterexample)
        complain(b->file, b->line, "'%s' lists the counterexample '%s' under %s", b->name, name, role_keys[r]);
}

/* The first clause of a hypothesis is its condition, which the scope tells behind "where": short, and no sentence. */
static void check_hypothesis(const struct block *b, int line, const char *text)
{
    enum { LONGEST = 110 };
    const char *clause = first_clause(text);
    int is_sentence = clause[0] >= 'A' && clause[0] <= 'Z';
    if (clause[0] == '\0' || is_sentence || strlen(clause) > LONGEST || strstr(clause, ", as ") != NULL)
        complain(b->file, line,
                 "'%s': a hypothesis begins with its condition, \"the weights are positive: why\", not '%s'", b->name,
                 clause);
}

static void check_links(const struct book *book, const struct block *b)
{
    for (int k = 0; k < b->options; k++) {
        int r = role_of(b->option[k].key);
        if (r == ROLES)
            continue;
        if (form_of(r) != CLAIM_LIST) {
            struct link link = read_link(b->option[k].value, form_of(r));
            if (link.claim != NULL)
                check_link(book, b, r, link.claim);
            else if (form_of(r) != PLACE_TEXT && r != READING)
                complain(b->file, b->option[k].line, "'%s' has a %s that no claim tries: claim | text", b->name,
                         role_keys[r]);
            if (form_of(r) == CLAIM_PLACE_TEXT && link.claim != NULL && link.place == NULL)
                complain(b->file, b->option[k].line, "'%s': where does the source state it? claim | place | text",
                         b->name);
            if (r == HYPOTHESIS || (r == NEEDS && link.place != NULL))
                check_hypothesis(b, b->option[k].line, link.text);
            if (form_of(r) == PLACE_TEXT && (link.place == NULL || link.text[0] == '\0'))
                complain(b->file, b->option[k].line, "'%s': %s is written as place | text", b->name, role_keys[r]);
        } else {
            char *words = whole_copy(b->option[k].value);
            for (char *word = strtok(words, " "); word != NULL; word = strtok(NULL, " "))
                check_link(book, b, r, word);
        }
    }
}

/* Whether the claim stands under the key. */
static int lists(const struct block *b, const char *key, const char *name)
{
    for (int k = 0; k < b->options; k++)
        if (strcmp(b->option[k].key, key) == 0 && has_word(b->option[k].value, name))
            return 1;
    return 0;
}

/* What a statement rests on does not confirm it, too: nothing rests on what confirms. */
static void check_confirming(const struct block *b)
{
    static const char *const resting[] = {"holds-by", "corrected-by", "checked-by"};
    for (int k = 0; k < b->options; k++) {
        if (role_of(b->option[k].key) != CONFIRMED_BY)
            continue;
        char *words = whole_copy(b->option[k].value);
        for (char *word = strtok(words, " "); word != NULL; word = strtok(NULL, " "))
            for (int j = 0; j < 3; j++)
                if (lists(b, resting[j], word))
                    complain(b->file, b->option[k].line, "'%s' is confirmed by '%s', which stands in %s already",
                             b->name, word, resting[j]);
    }
}

/* Whether a reading is true is derived from its claim, and not typed in. */
static void check_words_of_reading(const struct block *b, int line, const char *text)
{
    if (strstr(text, ": true") != NULL || strstr(text, ": false") != NULL)
        complain(b->file, line, "'%s': whether a reading is true is derived from its claim", b->name);
}

/* Whether no claim decides that the reading is true. */
static int is_false_reading(const struct book *book, const char *value)
{
    struct link link = read_link(value, CLAIM_TEXT_WORDS);
    const struct block *target = link.claim != NULL ? block_named(book, link.claim, CLAIM_BLOCK) : NULL;
    return target == NULL || kind_of(target) == COUNTEREXAMPLE;
}

/* Where a reading fails it is said what the text itself means, unless readings are all that is known. */
static void check_readings(const struct book *book, const struct block *b)
{
    int decided =
        value_of(b, "holds-by") != NULL || value_of(b, "refuted-by") != NULL || value_of(b, "definition") != NULL;
    int told = value_of(b, "meant") != NULL || !decided;
    for (int k = 0; k < b->options; k++) {
        const int before = k > 0 ? role_of(b->option[k - 1].key) : ROLES;
        if (role_of(b->option[k].key) == READING_WITH &&
            (before != READING || is_false_reading(book, b->option[k - 1].value)))
            complain(b->file, b->option[k].line, "'%s': reading-with stands behind a reading that a claim decides",
                     b->name);
        struct link link = read_link(b->option[k].value, CLAIM_TEXT_WORDS);
        const struct block *target = link.claim != NULL ? block_named(book, link.claim, CLAIM_BLOCK) : NULL;
        if (role_of(b->option[k].key) != READING || target == NULL)
            continue;
        int fails = kind_of(target) == COUNTEREXAMPLE;
        check_words_of_reading(b, b->option[k].line, link.text);
        if (fails && !told)
            complain(b->file, b->option[k].line, "'%s' is decided, and so read it fails: which reading is meant?",
                     b->name);
    }
}

/* What a statement is read as is said under meant, with that by which it is known, and not in a remark alone. */
static void check_remark(const struct block *b)
{
    static const char *const phrases[] = {"Read as ",      "Read so",      "Read with ", " read as ",
                                          " read so ",     " is meant",    " are meant", " taken as ",
                                          " taken to be ", " means here ", NULL};
    if (value_of(b, "meant") != NULL)
        return;
    char *note = whole_copy(b->note);
    for (char *at = note; *at != '\0'; at++)
        if (*at == '\n')
            *at = ' ';
    for (int k = 0; phrases[k] != NULL; k++)
        if (strstr(note, phrases[k]) != NULL)
            complain(b->file, b->line, "'%s': what it is read as is no remark: meant: place | text", b->name);
}

static void check_source_of(const struct book *book, const struct block *b)
{
    const char *colon = strchr(b->name, ':');
    int sources = 0;
    for (int k = 0; k < book->blocks; k++)
        sources += book->block[k].kind == SOURCE_BLOCK;
    if (sources > 0 &&
        (colon == NULL || block_named(book, copy_of(b->name, (size_t)(colon - b->name)), SOURCE_BLOCK) == NULL))
        complain(b->file, b->line, "'%s' is of no source that chapters/sources knows", b->name);
}

static void check_statement(const struct book *book, const struct block *b)
{
#define CLASS(name) name,
    static const char *const classes[] = {CLASS_LIST(CLASS) NULL};
#undef CLASS
    static const char *const known[] = {"title",      "zh",       "printed", "class",  "corrected", "figure",
                                        "definition", "striking", "example", "degree", NULL};
    static const char *const needed[] = {"title", "printed", NULL};
    check_keys(b, known, role_keys, needed);
    check_chinese(book, b);
    const char *class = value_of(b, "class"), *figure = value_of(b, "figure");
    if (class != NULL && !is_one_of(class, classes))
        complain(b->file, b->line, "'%s': unknown class '%s'", b->name, class);
    if ((value_of(b, "refuted-by") != NULL) != (class != NULL))
        complain(b->file, b->line, "'%s': a refuted statement, and no other, has a class", b->name);
    if ((value_of(b, "corrected") != NULL) != (value_of(b, "corrected-by") != NULL))
        complain(b->file, b->line, "'%s': a corrected statement and its claim come together", b->name);
    if (class != NULL && value_of(b, "corrected") == NULL)
        complain(b->file, b->line, "'%s' is refuted but not corrected", b->name);
    if (figure != NULL && !contains(&book->figures, figure))
        complain(b->file, b->line, "'%s': there is no FIGURE(%s)", b->name, figure);
    check_links(book, b);
    check_confirming(b);
    check_readings(book, b);
    check_remark(b);
    check_source_of(book, b);
}

static void check_source(const struct block *b)
{
    static const char *const known[] = {"author", "title",  "zh",     "year",      "publisher",
                                        "part",   "letter", "counts", "parameter", NULL};
    static const char *const needed[] = {"author", "title", NULL}, *const none[] = {NULL};
    check_keys(b, known, none, needed);
}

/* Whether the n characters are one of the phrases, "one; another". */
static int is_among_phrases(const char *phrases, const char *text, size_t n)
{
    for (const char *at = phrases; at != NULL && *at != '\0'; at += strspn(at, "; ")) {
        size_t m = strcspn(at, ";");
        if (m == n && strncmp(at, text, n) == 0)
            return 1;
        at += m;
    }
    return 0;
}

/* Whether the n characters are a phrase of the scope of some claim, or a condition of a claim or of a hypothesis. */
static int is_phrase(const struct book *book, const char *text, size_t n)
{
    for (int k = 0; k < book->blocks; k++) {
        const struct block *b = &book->block[k];
        if (b->kind == CLAIM_BLOCK &&
            (is_among_phrases(value_of(b, "scope"), text, n) || is_among_phrases(value_of(b, "where"), text, n)))
            return 1;
        for (int j = 0; j < b->options; j++) {
            int r = role_of(b->option[j].key);
            if (b->kind == STATEMENT_BLOCK && (r == HYPOTHESIS || r == NEEDS) &&
                is_among_phrases(first_clause(read_link(b->option[j].value, form_of(r)).text), text, n))
                return 1;
        }
    }
    return 0;
}

/* "narrow | wide": two phrases of scopes; "* | wide": any phrase is narrower. */
static void check_within(const struct book *book, const struct block *b, const struct option *o)
{
    struct link row = read_link(o->value, PLACE_TEXT);
    int any = row.place != NULL && strcmp(row.place, "*") == 0;
    if (row.place == NULL || (!any && !is_phrase(book, row.place, strlen(row.place))) ||
        !is_phrase(book, row.text, strlen(row.text)))
        complain(b->file, o->line, "what is within is written as narrow | wide, two phrases of scopes: '%s'", o->value);
}

/* The letters of a chapter: what the variables of its claims stand for, unless a claim says otherwise; and which phrases of
 * their scopes are narrower than which. */
static void check_letters(const struct book *book, const struct block *b)
{
    static const char *const known[] = {"over", "degree", "order", NULL}, *const rows[] = {"within", NULL},
                             *const none[] = {NULL};
    check_keys(b, known, rows, none);
    const char *order = value_of(b, "order");
    if (order != NULL &&
        (*order == '\0' || strspn(order, "0123456789") != strlen(order) || strlen(order) > 6 || atoi(order) == 0))
        complain(b->file, b->line, "the order of chapter '%s' is a whole number from 1 on, not '%s'", b->chapter,
                 order);
    for (int k = 0; k < b->options; k++)
        if (strcmp(b->option[k].key, "within") == 0)
            check_within(book, b, &b->option[k]);
    if (strcmp(b->name, b->chapter) != 0)
        complain(b->file, b->line, "the letters of chapter '%s' are called '%s'", b->chapter, b->name);
}

void check_book(const struct book *book)
{
    for (int k = 0; k < book->blocks; k++) {
        const struct block *b = &book->block[k];
        if (b->kind == CLAIM_BLOCK)
            check_claim(book, b);
        else if (b->kind == STATEMENT_BLOCK)
            check_statement(book, b);
        else if (b->kind == LETTERS_BLOCK)
            check_letters(book, b);
        else
            check_source(b);
        if (block_named(book, b->name, b->kind) != b)
            complain(b->file, b->line, "'%s' occurs twice", b->name);
    }
    for (int k = 0; k < book->bodies; k++)
        if (block_named(book, book->body[k].name, CLAIM_BLOCK) == NULL)
            complain(book->body[k].file, book->body[k].line, "CLAIM(%s) has no claim block", book->body[k].name);
}
