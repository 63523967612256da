/* select.h -- which claims, statements and figures of a register are meant by patterns and ids. */
#ifndef CAGD_SELECT_H
#define CAGD_SELECT_H

#include "chapters/judge/register.h"

#include <stddef.h>

/* Patterns are shell globs, or words of titles.  A glob matches a claim by its name, by chapter.name, or by the id of a
 * statement that the claim decides; a statement by its id, with or without its source, or by the names of its claims; a figure
 * by its name.  The name of a table matches its entries.  Words, of which no name is made, match what has them in its English
 * or Chinese title.  No pattern matches all. */
struct patterns {
    char **at;
    int count;
};

/* What matches, in the order of the register.  The caller frees the list. */
const claim **matching_claims(const cagd_register *r, const struct patterns *p, int *count);
const statement **matching_statements(const cagd_register *r, const struct patterns *p, int *count);
const figure **matching_figures(const cagd_register *r, const struct patterns *p, int *count);
/* The claims that the statements name.  The caller frees the list. */
const claim **claims_of(const cagd_register *r, const statement *const list[], int statements, int *count);

/* What a pattern or an id may name. */
enum kind_of_name { CLAIMS, STATEMENTS, FIGURES };
/* Whether every pattern matches something of the kind; a line on stderr about the first that does not.  A name that is
 * spelled in another way (cli/names.h) is replaced in the patterns by the one that is meant. */
int all_match(const cagd_register *r, const struct patterns *p, enum kind_of_name kind);
/* Whether the pattern matches the id of a statement, as above. */
int id_matches(const char *pattern, const char *id);
/* How long the name of the table is of which the id is an entry, TABLE-row-ROW-COLUMN; 0 for no entry. */
size_t table_length(const char *id);
/* Whether the text is a glob, and whether it is in one of the titles, where it begins a word. */
int is_glob(const char *text);
int is_in_title(const char *text, const char *title, const char *title_zh);
#endif
