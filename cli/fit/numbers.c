/* numbers.c -- names of unknowns, and numbers as they are written. */
#include "chapters/judge/memory_text.h"
#include "cli/fit/fit.h"

#include <math.h>
#include <mpfr.h>
#include <stdlib.h>
#include <string.h>

void unknown_name(const cagd_fit_result *r, int k, char name[32])
{
    const cagd_fit_unknown *u = &r->unknown[k];
    if (u->is_weight)
        snprintf(name, 32, "w%d", u->index);
    else
        snprintf(name, 32, "P%d %c", u->index, "xyz"[u->coordinate]);
}

/* The exponent of x as %.*e with so many decimals writes it. */
static int exponent_of(double x, int decimals)
{
    char digits[48];
    snprintf(digits, sizeof digits, "%.*e", decimals, x);
    return atoi(strchr(digits, 'e') + 1);
}

/* origin + value, to so many decimals of the form e or f; the sum of two binary64 has less than 2200 bits. */
static void put_sum(FILE *out, char form, int decimals, double origin, double value)
{
    char format[] = "%.*RNf", text[100];
    mpfr_t sum;
    mpfr_init2(sum, 2200);
    mpfr_set_d(sum, origin, MPFR_RNDN);
    mpfr_add_d(sum, sum, value, MPFR_RNDN);
    format[5] = form;
    mpfr_snprintf(text, sizeof text, format, decimals, sum);
    fputs(text, out);
    mpfr_clear(sum);
}

void put_given(FILE *out, double origin, double x)
{
    char text[40];
    for (int digits = 10; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, x);
        if (origin == 0 || strtod(text, NULL) == x)
            break;
    }
    fputs(text, out);
}

void put_rounded(FILE *out, double origin, double value, double error)
{
    enum { LONGEST = 12, MOST_ZEROS = 4, EXACT = 17, MOST = 40 };
    double whole_value = origin + value;
    if (!isfinite(error) || !(error > 0)) {
        put_given(out, origin, whole_value);
        return;
    }
    int places = 1 - exponent_of(error, 1); /* of the second digit of the error, as it is rounded */
    double size = fmax(fabs(whole_value), fabs(error));
    int whole = size > 0 ? exponent_of(size, 1) : 0;
    if (origin == 0 && places + whole >= EXACT) /* finer than binary64 holds the value */
        places = EXACT - 1 - whole;
    if (-MOST_ZEROS <= places && -MOST_ZEROS <= whole && places + whole < EXACT && whole < LONGEST) {
        put_sum(out, 'f', places > 0 ? places : 0, origin, value);
        return;
    }
    int decimals = whole_value != 0 ? places + exponent_of(whole_value, 1) : 1, most = origin != 0 ? MOST : EXACT;
    put_sum(out, 'e', decimals < 1 ? 1 : decimals > most ? most : decimals, origin, value);
}

/* How many bytes the character of UTF-8 that begins at s has; 0 where none does. */
static size_t character(const char *s)
{
    for (size_t length = 1; length <= 4 && s[length - 1] != '\0'; length++) {
        json_t *one = json_stringn(s, length);
        json_decref(one);
        if (one != NULL)
            return length;
    }
    return 0;
}

json_t *text_json(const char *text)
{
    char *whole;
    size_t size;
    FILE *out = text_open(&whole, &size);
    for (size_t length; *text != '\0'; text += length > 0 ? length : 1) {
        length = character(text);
        fprintf(out, "%.*s", length > 0 ? (int)length : 3, length > 0 ? text : "\xEF\xBF\xBD");
    }
    text_close(out, &whole);
    json_t *json = json_string(whole);
    free(whole);
    return json;
}
