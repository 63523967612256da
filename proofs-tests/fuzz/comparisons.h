/* comparisons.h -- the comparisons of the C library, byte by byte: AddressSanitizer checks every byte where it is read, and nothing is asked of
 * its own or the fuzzer's, which take half of the time of a reader.  What they check is checked: of strings the bytes up to the first
 * that differs, of memory all n, also behind it.  Every file of the fuzzers begins with it. */
#ifndef CAGD_FUZZ_COMPARISONS_H
#define CAGD_FUZZ_COMPARISONS_H

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
    int first = 0;
    for (size_t k = 0; k < n; k++) {
        const int difference = a[k] - b[k];
        first = first != 0 ? first : difference;
    }
    return first;
}

#define strcmp(a, b) compare_strings(a, b)
#define strncmp(a, b, n) compare_starts(a, b, n)
#define memcmp(a, b, n) compare_bytes(a, b, n)
#endif
