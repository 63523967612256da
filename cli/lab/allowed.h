/* allowed.h -- the functions of the C library that an assignment may call: numbers, memory, texts, and printing, which is noticed.
 * Besides them those of exact/code/names.h. */
#ifndef CAGD_LAB_ALLOWED_H
#define CAGD_LAB_ALLOWED_H

#define LAB_ALLOWED(NAME)                                                                                              \
    NAME(calloc)                                                                                                       \
    NAME(free)                                                                                                         \
    NAME(memcpy)                                                                                                       \
    NAME(memmove)                                                                                                      \
    NAME(memset)                                                                                                       \
    NAME(abs)                                                                                                          \
    NAME(labs)                                                                                                         \
    NAME(llabs)                                                                                                        \
    NAME(qsort)                                                                                                        \
    NAME(bsearch)                                                                                                      \
    NAME(strlen)                                                                                                       \
    NAME(strcmp)                                                                                                       \
    NAME(strcpy)                                                                                                       \
    NAME(puts)                                                                                                         \
    NAME(putchar)                                                                                                      \
    NAME(fputs)                                                                                                        \
    NAME(fputc)                                                                                                        \
    NAME(putc)                                                                                                         \
    NAME(fflush)                                                                                                       \
    NAME(stdout)                                                                                                       \
    NAME(stderr)                                                                                                       \
    NAME(exit)                                                                                                         \
    NAME(abort)                                                                                                        \
    NAME(__assert_fail)

/* Of those in names.h, what an assignment may not call. */
#define LAB_TEXTS(NAME)                                                                                                \
    NAME(sprintf)                                                                                                      \
    NAME(snprintf)                                                                                                     \
    NAME(vsprintf)                                                                                                     \
    NAME(vsnprintf)
#endif
