/* digest.c -- SHA-256 of a text. */
#include "cli/digest.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { BLOCK = 64, WORDS = 8, ROUNDS = 64 };

/* The first 32 bits of the fractional parts of the cube roots of the first 64 primes. */
static const uint32_t round_constant[ROUNDS] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

static uint32_t turned(uint32_t x, int n) { return x >> n | x << (32 - n); }

/* One block into the state h: 64 rounds with the words w of the block and those that follow from them. */
static void compress(uint32_t h[WORDS], const unsigned char block[BLOCK])
{
    uint32_t w[ROUNDS], s[WORDS];
    for (int t = 0; t < 16; t++)
        w[t] = (uint32_t)block[4 * t] << 24 | (uint32_t)block[4 * t + 1] << 16 | (uint32_t)block[4 * t + 2] << 8 |
               block[4 * t + 3];
    for (int t = 16; t < ROUNDS; t++) {
        uint32_t near = w[t - 2], far = w[t - 15];
        w[t] = w[t - 16] + (turned(far, 7) ^ turned(far, 18) ^ far >> 3) + w[t - 7] +
               (turned(near, 17) ^ turned(near, 19) ^ near >> 10);
    }
    memcpy(s, h, sizeof s);
    for (int t = 0; t < ROUNDS; t++) {
        uint32_t a = s[0], b = s[1], c = s[2], e = s[4];
        uint32_t choice = (e & s[5]) ^ (~e & s[6]), majority = (a & b) ^ (a & c) ^ (b & c);
        uint32_t first = s[7] + (turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)) + choice + round_constant[t] + w[t];
        uint32_t second = (turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)) + majority;
        memmove(s + 1, s, (WORDS - 1) * sizeof *s);
        s[4] += first;
        s[0] = first + second;
    }
    for (int k = 0; k < WORDS; k++)
        h[k] += s[k];
}

/* Behind the bytes stand a bit 1, zeros, and its length in bits, in the last block or in one more. */
void digest_of_bytes(const void *bytes, size_t length, char digest[DIGEST])
{
    const unsigned char *text = bytes;
    /* The first 32 bits of the fractional parts of the square roots of the first eight primes. */
    uint32_t h[WORDS] = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    unsigned char block[BLOCK];
    size_t left = length;
    for (; left >= BLOCK; left -= BLOCK, text += BLOCK)
        compress(h, text);
    memset(block, 0, sizeof block);
    memcpy(block, text, left);
    block[left] = 0x80;
    if (left >= BLOCK - 8) {
        compress(h, block);
        memset(block, 0, sizeof block);
    }
    for (int k = 0; k < 8; k++)
        block[BLOCK - 1 - k] = (unsigned char)((uint64_t)length * 8 >> 8 * k);
    compress(h, block);
    for (int k = 0; k < WORDS; k++)
        snprintf(digest + 8 * k, 9, "%08x", (unsigned)h[k]);
}

void digest_of_text(const char *text, char digest[DIGEST]) { digest_of_bytes(text, strlen(text), digest); }
