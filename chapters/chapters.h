/* chapters.h -- the register of the chapters that are compiled in. */
#ifndef CAGD_CHAPTERS_H
#define CAGD_CHAPTERS_H

#include "chapters/judge/register.h"

extern const cagd_register compiled_chapters;

/* Until every command is given its register. */
#define all_claims     (compiled_chapters.claims)
#define all_statements (compiled_chapters.statements)
#define all_figures    (compiled_chapters.figures)
#endif
