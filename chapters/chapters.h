/* chapters.h -- the register of the chapters that are compiled in. */
#ifndef CAGD_CHAPTERS_H
#define CAGD_CHAPTERS_H

#include "chapters/judge/register.h"

extern const cagd_register compiled_chapters;
#endif
