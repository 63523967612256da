/* svg_string.c -- growing strings, UTF-8 and the escapes of XML. */
#include "figures/svg_parts.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static void put_bytes(struct string *out, const char *bytes, size_t n)
{
    if (out->broken)
        return;
    if (out->used + n + 1 > out->room) {
        size_t room = 2 * out->room + n + 64;
        char *at = realloc(out->at, room);
        if (at == NULL) {
            out->broken = true;
            return;
        }
        out->at = at;
        out->room = room;
    }
    memcpy(out->at + out->used, bytes, n);
    out->used += n;
    out->at[out->used] = '\0';
}

static void put_natural(struct string *out, unsigned long n)
{
    char digit[24];
    size_t k = sizeof digit;
    do
        digit[--k] = (char)('0' + n % 10);
    while ((n /= 10) > 0);
    put_bytes(out, digit + k, sizeof digit - k);
}

static void put_integer(struct string *out, long n)
{
    if (n < 0)
        put_bytes(out, "-", 1);
    put_natural(out, n < 0 ? 0UL - (unsigned long)n : (unsigned long)n);
}

static void put_hundredths(struct string *out, long n)
{
    unsigned long size = n < 0 ? 0UL - (unsigned long)n : (unsigned long)n;
    if (n < 0)
        put_bytes(out, "-", 1);
    put_natural(out, size / 100);
    put_bytes(out, (char[]){'.', (char)('0' + size / 10 % 10), (char)('0' + size % 10)}, 3);
}

static void put_escaped(struct string *out, const char *utf8)
{
    for (uint32_t code; (code = next_character(&utf8)) != 0;)
        put_character(out, code);
}

void put(struct string *out, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    for (const char *c = format; *c != '\0'; c++) {
        if (*c != '%') {
            size_t n = strcspn(c, "%");
            put_bytes(out, c, n);
            c += n - 1;
            continue;
        }
        switch (*++c) {
        case 's': {
            const char *text = va_arg(arguments, const char *);
            put_bytes(out, text, strlen(text));
            break;
        }
        case 'x':
            put_escaped(out, va_arg(arguments, const char *));
            break;
        case 'd':
            put_integer(out, va_arg(arguments, int));
            break;
        case 'h':
            put_hundredths(out, va_arg(arguments, long));
            break;
        default:
            put_bytes(out, c, 1);
        }
    }
    va_end(arguments);
}

void put_character(struct string *out, uint32_t code)
{
    static const struct {
        uint32_t code;
        const char *entity;
    } special[] = {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
    for (size_t k = 0; k < sizeof special / sizeof *special; k++)
        if (code == special[k].code) {
            put_bytes(out, special[k].entity, strlen(special[k].entity));
            return;
        }
    int tail = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    static const unsigned lead[] = {0x00, 0xC0, 0xE0, 0xF0};
    char byte[4] = {(char)(lead[tail] | code >> 6 * tail)};
    for (int k = 1; k <= tail; k++)
        byte[k] = (char)(0x80 | (code >> 6 * (tail - k) & 0x3F));
    put_bytes(out, byte, (size_t)tail + 1);
}

void empty_string(struct string *out)
{
    out->used = 0;
    if (out->at != NULL)
        out->at[0] = '\0';
}

void free_string(struct string *out)
{
    free(out->at);
    *out = (struct string){0};
}

const char *content(const struct string *s) { return s->at == NULL ? "" : s->at; }

/* What XML 1.0 calls a character. */
static bool is_xml_character(uint32_t c)
{
    return c == '\t' || c == '\n' || (c >= 0x20 && c < 0xD800) || (c >= 0xE000 && c <= 0xFFFD) ||
           (c >= 0x10000 && c <= 0x10FFFF);
}

uint32_t next_character(const char **utf8)
{
    enum { REPLACEMENT = 0xFFFD };
    const unsigned char *byte = (const unsigned char *)*utf8;
    if (*byte == 0)
        return 0;
    int tail = *byte < 0x80 ? 0 : *byte >> 5 == 6 ? 1 : *byte >> 4 == 14 ? 2 : *byte >> 3 == 30 ? 3 : -1;
    static const uint32_t least[] = {0, 0x80, 0x800, 0x10000};
    static const uint32_t payload[] = {0x7F, 0x1F, 0x0F, 0x07};
    *utf8 += 1;
    if (tail < 0)
        return REPLACEMENT;
    uint32_t code = *byte & payload[tail];
    for (int k = 1; k <= tail; k++) {
        if (byte[k] >> 6 != 2)
            return REPLACEMENT;
        code = code << 6 | (byte[k] & 0x3F);
    }
    *utf8 += tail;
    return code < least[tail] || !is_xml_character(code) ? REPLACEMENT : code;
}
