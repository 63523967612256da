/* objects.h -- which addresses are those of a variable, of memory that was asked for, or of nothing; only for exact/code.
 *
 * Every variable whose address is taken and every piece of memory of the rewritten code is an object with a margin on both sides.
 * An address that is computed belongs to the object of the address from which it was computed, also when it points into the margin, or
 * farther, to where there is no object.  One that would point into another object ends the run, as nobody could tell any more to
 * which it belongs.  So what is read or written outside its object is always noticed, however far, and named. */
#ifndef CAGD_CODE_OBJECTS_H
#define CAGD_CODE_OBJECTS_H

#include <stddef.h>

enum cagd_code_life { CAGD_CODE_GLOBAL, CAGD_CODE_LOCAL, CAGD_CODE_MEMORY };

/* The object [start, start + size) with margins of so many bytes; name: NULL where it has none, and then the place in the source
 * where it was made is told. */
void cagd_code_object(const char *start, size_t size, size_t before, size_t behind, const char *name,
                      enum cagd_code_life life);

/* The code begins: from here on, variables of static storage that are put into are told of, by the code and, from one of these calls to the
 * other, by functions of the libraries. */
void cagd_code_watch_globals(void);
void cagd_code_compare_globals(void);

/* Memory that begins there: its size is written and 1 returned, or 0 where no memory of ours begins. */
int cagd_code_memory_at(const char *start, size_t *size);

/* How many pieces of memory were asked for and not released yet. */
size_t cagd_code_memory_count(void);

/* It is given back: from now on using it ends the run.  `release` gives it to the system, when so much has come together. */
void cagd_code_memory_dies(const char *start, void (*release)(const char *start, size_t before));
#endif
