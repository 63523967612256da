/* page.h -- one statement or one claim as a page, on standard output. */
#ifndef CAGD_PAGE_H
#define CAGD_PAGE_H

#include "chapters/judge/register.h"
#include "chapters/judge/run.h"

/* A statement; results: of all claims that it names.  numbers: with what each of them did in every number type. */
void print_statement(const cagd_register *reg, const statement_result *r, const claim_result *results, int count,
                     int numbers);
/* A printed table whose entries are statements: each with its verdict, and what is right where it is wrong. */
void print_table(const cagd_register *reg, const char *id, const statement_result *entries, int count);
/* A claim, and the statements of the register that name it. */
void print_claim(const cagd_register *reg, const claim_result *r);
#endif
