/* digest.h -- SHA-256 (散列) of a text, by which a manifest knows a certificate again, and a kept file its content: as FIPS 180-4 defines it. */
#ifndef CAGD_DIGEST_H
#define CAGD_DIGEST_H

#include <stddef.h>

enum { DIGEST = 64 + 1 };

/* The digest in 64 hexadecimal digits, and the zero behind them. */
void digest_of_bytes(const void *bytes, size_t length, char digest[DIGEST]);
void digest_of_text(const char *text, char digest[DIGEST]);
#endif
