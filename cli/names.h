/* names.h -- names as people type them: the end of an id, the words of a book, a word of a title; and those nearest to them. */
#ifndef CAGD_NAMES_H
#define CAGD_NAMES_H

#include "cli/select.h"

/* The id or the name that a text which names nothing stands for: the only one that ends with it, where "定理3.3.2" and
 * "Theorem 3.3.2" are read as thm-3.3.2, and "(3.3.2)" as a formula; or the only one that has it in its title.  Otherwise
 * NULL and one line on stderr: the names that it may stand for, or those that are spelled nearly so, or how to find
 * the names. */
const char *name_meant_by(const cagd_register *r, const char *text, enum kind_of_name kind);
/* Every name of a statement, a table or a claim that matches, a line each: a claim has two, NAME and CHAPTER.NAME. */
void print_names(const cagd_register *r, const struct patterns *p);
#endif
