/* junit.h -- results as a file of JUnit XML. */
#ifndef CAGD_JUNIT_H
#define CAGD_JUNIT_H

/* The cases of one suite, in the order in which they are added.  The texts are copied. */
struct junit;
struct junit *junit_new(void);
/* failure: what came out, and what was expected; NULL where it is as expected.  text: the case in which it fails. */
void junit_add(struct junit *j, const char *group, const char *name, double seconds, const char *failure,
               const char *text);
/* Writes the suite to the file, and frees it.  0, or -1 and a line on stderr. */
int junit_write(struct junit *j, const char *suite, const char *path);
#endif
