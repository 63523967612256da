/* scratch.h -- a folder for what is kept while a program is built. */
#ifndef CAGD_CODE_SCRATCH_H
#define CAGD_CODE_SCRATCH_H

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

enum { SCRATCH = 4096, IN_SCRATCH = SCRATCH + 64 }; /* bytes of the name of the folder, and of a file in it */

/* Makes NAME-XXXXXX below the folder that TMPDIR names, or /tmp; its name to path.  0, or -1 and errno. */
static inline int make_scratch(char path[SCRATCH], const char *name)
{
    const char *place = getenv("TMPDIR");
    int length = snprintf(path, SCRATCH, "%s/%s-XXXXXX", place != NULL && *place != '\0' ? place : "/tmp", name);
    if (length >= SCRATCH) {
        errno = ENAMETOOLONG;
        return -1;
    }
    return mkdtemp(path) != NULL ? 0 : -1;
}
#endif
