/* book.h -- what weave reads: the blocks of the chapter files, the bodies, the figures. */
#ifndef CAGD_WEAVE_BOOK_H
#define CAGD_WEAVE_BOOK_H

#include "chapters/judge/claim.h"
#include "chapters/weave/text.h"

enum block_kind { CLAIM_BLOCK, STATEMENT_BLOCK, LETTERS_BLOCK, SOURCE_BLOCK };

struct option {
    char *key, *value;
    int line;
};

/* An entry `name = value` of the options data, instead and result; see struct datum. */
struct entry {
    enum data_place place;
    char *name, *text;
    int rows, columns, line;
    struct list values;
};

/* :::{claim} NAME, options, a note, :::.  A claim's option is a statement's, or a source's, too. */
struct block {
    enum block_kind kind;
    int line, end; /* the lines of its first and last colons */
    char *name, *note, *file, *chapter;
    struct option *option;
    int options;
    struct entry *entry; /* of a claim */
    int entries;
};

/* CLAIM(name). */
struct body {
    char *name, *file;
    int line;
};

struct book {
    struct block *block;
    int blocks;
    struct body *body;
    int bodies;
    struct list figures; /* names in FIGURE(...) */
    struct list chapters, titles;
    struct list bilingual; /* the chapters whose heading is Chinese, too */
    struct list printed;   /* ids of the blocks :::{printed} ID of print*.md */
    struct list for_every; /* of these the ones with a range without end, :for: n = 1.. */
    const char *types;     /* the number types that are compiled, separated by blanks */
};

/* The place of a chapter in reading order: what `order` says among its letters, INT_MAX where nothing does. */
int place_of_chapter(const char *folder);
/* Reads the chapter whose folder has an index.md; a folder whose index lists no section has sources only.  Complains of what
 * is not there. */
void read_chapter(struct book *book, const char *folder);
/* The entries of the options data, instead and result of a claim's block. */
void read_data(struct block *b);

/* Complains of everything that is missing, unknown, twice, or leads nowhere. */
void check_book(const struct book *book);

/* The value of an option, or NULL. */
const char *value_of(const struct block *b, const char *key);
const struct block *block_named(const struct book *book, const char *name, enum block_kind kind);
/* Whether the blank-separated list has the word. */
int has_word(const char *list, const char *word);
/* The role of that key, or ROLES. */
int role_of(const char *key);
role_form form_of(int r);
/* Whether the claim is run in the type, by its option `types`; decisions and counterexamples are rational unless it says
 * otherwise. */
int has_type(const struct book *book, const struct block *b, number_type t);
int is_compiled(const struct book *book, const struct block *b);
/* The kind of a claim by its name, or KINDS; IDENTITY when absent. */
int kind_of(const struct block *b);
/* The degrees that a claim visits; 0 where the option cannot be read. */
struct degrees {
    char letter[16]; /* empty: that of the chapter */
    int low, high, sampled, all;
};
int read_degrees(const struct block *b, struct degrees *d);
/* claim | text, claim | place | text or place | text, each trimmed; NULL is what is not there, but for the text. */
struct link {
    char *claim, *place, *text;
};
struct link read_link(const char *value, role_form form);

/* The register as C tables, and as JSON for everybody else.  0 on success, else a line on stderr. */
int write_register_c(const struct book *book, const char *path);
int write_register_json(const struct book *book, const char *path);
#endif
