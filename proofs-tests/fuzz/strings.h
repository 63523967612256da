/* strings.h -- the comparisons of the C library, byte by byte: every byte is checked where it is read, and nothing is asked of the
 * sanitizer's or the fuzzer's own, which take half of the time of a reader.  Every file of the fuzzers begins with it. */
#ifndef CAGD_FUZZ_STRINGS_H
#define CAGD_FUZZ_STRINGS_H

#include <string.h>

#define UNCOUNTED __attribute__((unused, no_sanitize("coverage")))

UNCOUNTED static int compare_strings(const char *a, const char *b)
{
    while (*a == *b && *a != '\0')
        a++, b++;
    return (unsigned char)*a - (unsigned char)*b;
}

UNCOUNTED static int compare_starts(const char *a, const char *b, size_t n)
{
    for (; n > 0 && *a == *b && *a != '\0'; n--)
        a++, b++;
    return n == 0 ? 0 : (unsigned char)*a - (unsigned char)*b;
}

UNCOUNTED static int compare_bytes(const void *one, const void *other, size_t n)
{
    const unsigned char *a = one, *b = other;
    for (; n > 0 && *a == *b; n--)
        a++, b++;
    return n == 0 ? 0 : *a - *b;
}

#define strcmp(a, b) compare_strings(a, b)
#define strncmp(a, b, n) compare_starts(a, b, n)
#define memcmp(a, b, n) compare_bytes(a, b, n)
#endif
