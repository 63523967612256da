/* driver.c -- see driver.h. */
#include "exact/code/driver.h"

#include "exact/number/rational.h"

#include <stdlib.h>
#include <string.h>

int cagd_code_is_cpp(const struct cagd_code_harness *h)
{
    static const char *const ends[] = {".cc", ".cpp", ".cxx", ".C"};
    for (int k = 0; k < h->source.count; k++)
        for (size_t e = 0; e < sizeof ends / sizeof *ends; e++) {
            size_t n = strlen(h->source.text[k]), m = strlen(ends[e]);
            if (n > m && strcmp(h->source.text[k] + n - m, ends[e]) == 0)
                return 1;
        }
    for (int k = 0; k < h->flag.count; k++) /* of a library: what is called is not to be seen from its name */
        if (strncmp(h->flag.text[k], "-std=", 5) == 0 && strstr(h->flag.text[k], "++") != NULL)
            return 1;
    return 0;
}

/* In C, exactly: a literal of a whole number ends at 2^64, and so a longer one is written by its digits in the base 2^53, (a * 2^53 + b) * 2^53
 * + c, each of which is a binary64. */
static void write_whole(mpz_srcptr n, FILE *out)
{
    enum { BITS = 53 };
    size_t digits = (mpz_sizeinbase(n, 2) + BITS - 1) / BITS;
    mpz_t digit;
    mpz_init(digit);
    if (mpz_sgn(n) < 0 && digits > 1)
        putc('-', out);
    for (size_t k = 1; k < digits; k++)
        putc('(', out);
    for (size_t k = digits; k-- > 0;) {
        mpz_tdiv_q_2exp(digit, n, BITS * k);
        mpz_tdiv_r_2exp(digit, digit, BITS);
        const char *sign = mpz_sgn(n) < 0 && digits == 1 ? "-" : "";
        fprintf(out, "%s(double)%s%lu%s", k + 1 < digits ? " * 9007199254740992.0 + " : "", sign, mpz_get_ui(digit),
                k + 1 < digits ? ")" : "");
    }
    mpz_clear(digit);
}

/* In C: an input, or a number as a quotient of integers. */
static void write_end(const char *text, FILE *out)
{
    cagd_region_mark mark = cagd_region_open();
    if (cagd_code_is_number(text)) {
        cagd_num_q q = cagd_from_string_q(text);
        putc('(', out);
        write_whole(mpq_numref(q.at), out);
        fputs(" / ", out);
        write_whole(mpq_denref(q.at), out);
        putc(')', out);
    } else {
        fputs(text, out);
    }
    cagd_region_drop(mark);
}

static void write_precondition(const struct cagd_code_asked_input *in, FILE *out)
{
    const char *element = in->count > 0 ? "[cagd_k]" : "";
    if (in->shape == CAGD_CODE_ANY || in->shape == CAGD_CODE_FIXED)
        return;
    int ordered = in->shape == CAGD_CODE_INCREASING || in->shape == CAGD_CODE_NONDECREASING;
    fprintf(out, "    for (int cagd_k = %d; cagd_k < %d; cagd_k++)\n        cagd_code_where(", ordered,
            in->count > 0 ? in->count : 1);
    if (ordered)
        fprintf(out, "%s[cagd_k - 1] %s %s[cagd_k]", in->name,
                in->shape == CAGD_CODE_INCREASING ? "<" : "<=", in->name);
    else if (in->shape == CAGD_CODE_POSITIVE)
        fprintf(out, "%s%s > 0", in->name, element);
    else {
        write_end(in->low, out);
        fprintf(out, " %s %s%s && %s%s %s ", in->open_low ? "<" : "<=", in->name, element, in->name, element,
                in->open_high ? "<" : "<=");
        write_end(in->high, out);
    }
    fputs(");\n", out);
}

/* "R = f(x)" or "R[3] = W": what was got, its elements, and what was wanted. */
static void write_expectation(const char *text, int line, const char *path, FILE *out)
{
    const char *equal = strchr(text, '=');
    char *left = cagd_code_trimmed(text, (size_t)(equal - text)),
         *right = cagd_code_trimmed(equal + 1, strlen(equal + 1));
    int name = (int)strcspn(left, "[");
    long count;
    fprintf(out, "#line %d \"%s\"\n", line, path);
    if (cagd_code_is_array(left, &count))
        fprintf(out, "    cagd_code_expect(\"%.*s\", %ld, %.*s, %s);\n", name, left, count, name, left, right);
    else
        fprintf(out,
                "    { const double cagd_got = %s; cagd_code_side(2);\n      const double cagd_wanted = %s; "
                "cagd_code_side(0);\n      cagd_code_expect(\"%s\", 1, &cagd_got, &cagd_wanted); }\n",
                left, right, left);
    free(left);
    free(right);
}

/* "curves.c:12 = f(x)" or "curves.c:12[6] = W". */
static void write_known(const char *text, int line, const char *path, FILE *out)
{
    const char *equal = strchr(text, '=');
    char *place = cagd_code_trimmed(text, (size_t)(equal - text)),
         *right = cagd_code_trimmed(equal + 1, strlen(equal + 1));
    char *bracket = strchr(place, '[');
    long count = bracket != NULL ? strtol(bracket + 1, NULL, 10) : 0;
    place[strcspn(place, "[ \t")] = 0;
    fprintf(out, "#line %d \"%s\"\n", line, path);
    if (count > 0)
        fprintf(out, "    cagd_code_known(\"%s\", %ld, %s);\n", place, count, right);
    else
        fprintf(out, "    { const double cagd_wanted = %s; cagd_code_known(\"%s\", 1, &cagd_wanted); }\n", right,
                place);
    free(place);
    free(right);
}

static void write_output(const char *text, int line, const char *path, FILE *out)
{
    int name = (int)strcspn(text, "[");
    long count;
    fprintf(out, "#line %d \"%s\"\n", line, path);
    if (cagd_code_is_array(text, &count))
        fprintf(out, "    cagd_code_output(\"%.*s\", %ld, %.*s);\n", name, text, count, name, text);
    else
        fprintf(out, "    { const double cagd_out = %s; cagd_code_output(\"%s\", 1, &cagd_out); }\n", text, text);
}

/* A literal of C. */
static void write_text(const char *text, FILE *out)
{
    putc('"', out);
    for (; *text != 0; text++)
        if (*text == '\n')
            putc(' ', out);
        else if (*text == '"' || *text == '\\')
            fprintf(out, "\\%c", *text);
        else
            putc(*text, out);
    putc('"', out);
}

static void write_name(const char *name, int count, FILE *out)
{
    fprintf(out, "    cagd_code_name(\"%s\", %d, %s%s);\n", name, count, count > 0 ? "" : "&", name);
}

/* What is printed, of inputs as they were given and of outputs. */
static void write_formulas(const struct cagd_code_harness *h, const char *path, FILE *out)
{
    char name[CAGD_CODE_MOST_NAME + 1];
    int count;
    for (int k = 0; k < h->output.count; k++)
        if (cagd_code_output_name(h->output.text[k], name, &count))
            write_name(name, count, out);
    for (int k = 0; k < h->let.count; k++) {
        fputs("    cagd_code_let(", out);
        write_text(h->let.text[k], out);
        fputs(");\n", out);
    }
    for (int k = 0; k < h->printed.count; k++) {
        fprintf(out, "#line %d \"%s\"\n    cagd_code_printed(", h->printed.number[k], path);
        write_text(h->printed.text[k], out);
        fputs(", ", out);
        write_text(h->ranges, out);
        fputs(", __FILE__, __LINE__);\n", out);
    }
}

void cagd_code_write_driver(const struct cagd_code_harness *h, const char *path, FILE *out)
{
    fputs("#ifdef __cplusplus\nextern \"C\" {\n#endif\n"
          "void cagd_code_input(const char *, long, double *);\n"
          "void cagd_code_given(int);\nvoid cagd_code_where(int);\n"
          "void cagd_code_output(const char *, long, const double *);\n"
          "void cagd_code_expect(const char *, long, const double *, const double *);\n"
          "void cagd_code_side(int);\n"
          "void cagd_code_known(const char *, long, const double *);\n"
          "void cagd_code_formulas(void);\n"
          "void cagd_code_name(const char *, long, const double *);\n"
          "void cagd_code_let(const char *);\n"
          "void cagd_code_printed(const char *, const char *, const char *, int);\n"
          "void cagd_code_entry(void);\n"
          "#ifdef __cplusplus\n}\n#endif\n",
          out);
    for (int k = 0; k < h->include.count; k++)
        fprintf(out, "#line %d \"%s\"\n#include %s\n", h->include.number[k], path, h->include.text[k]);
    for (int k = 0; k < h->declare.count; k++)
        fprintf(out, "#line %d \"%s\"\n%s\n", h->declare.number[k], path, h->declare.text[k]);
    fputs("void cagd_code_entry(void)\n{\n", out);
    for (int k = 0; k < h->inputs; k++) {
        const struct cagd_code_asked_input *in = &h->input[k];
        if (in->count > 0)
            fprintf(out, "    double %s[%d];\n    cagd_code_input(\"%s\", %d, %s);\n", in->name, in->count, in->name,
                    in->count, in->name);
        else
            fprintf(out, "    double %s;\n    cagd_code_input(\"%s\", 1, &%s);\n", in->name, in->name, in->name);
    }
    if (h->printed.count > 0)
        fputs("    cagd_code_formulas();\n", out);
    for (int k = 0; h->printed.count > 0 && k < h->inputs; k++)
        write_name(h->input[k].name, h->input[k].count, out);
    fputs("    cagd_code_given(1);\n", out);
    for (int k = 0; k < h->inputs; k++)
        write_precondition(&h->input[k], out);
    for (int k = 0; k < h->where.count; k++)
        fprintf(out, "#line %d \"%s\"\n    cagd_code_where(%s);\n", h->where.number[k], path, h->where.text[k]);
    fputs("    cagd_code_given(0);\n    cagd_code_side(1);\n", out);
    for (int k = 0; k < h->call.count; k++)
        fprintf(out, "#line %d \"%s\"\n    %s\n", h->call.number[k], path, h->call.text[k]);
    fputs("    cagd_code_side(0);\n", out);
    for (int k = 0; k < h->known.count; k++)
        write_known(h->known.text[k], h->known.number[k], path, out);
    for (int k = 0; k < h->output.count; k++)
        write_output(h->output.text[k], h->output.number[k], path, out);
    for (int k = 0; k < h->expect.count; k++)
        write_expectation(h->expect.text[k], h->expect.number[k], path, out);
    if (h->printed.count > 0)
        write_formulas(h, path, out);
    fputs("}\n", out);
}
