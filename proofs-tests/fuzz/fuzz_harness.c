/* fuzz_harness.c -- blocks that ask about code: what is read has a driver and points, whose values are numbers that keep what was said of
 * them; what is not read has a cause and a line of the text. */
#include "proofs-tests/fuzz/file.h"

#include "exact/code/driver.h"
#include "exact/code/points.h"
#include "exact/number/rational.h"
#include "exact/words.h"

#include <string.h>

/* The value of element j, or of the input where it is one number. */
static num_q value(const struct cagd_code_point *p, int i, int j)
{
    num_q q = from_string_q(p->input[i].value[j]);
    if (region_faults != 0)
        abort();
    return q;
}

static void look(const struct cagd_code_harness *h, const struct cagd_code_point *p)
{
    if (p->inputs != h->inputs)
        abort();
    for (int i = 0; i < p->inputs; i++) {
        int count = p->input[i].count > 0 ? p->input[i].count : 1, shape = (int)h->input[i].shape;
        for (int j = 0; j < count; j++) {
            num_q x = value(p, i, j);
            if (shape == CAGD_CODE_POSITIVE && cagd_sign_q(x) <= 0)
                abort();
            int order = j > 0 ? cagd_compare_q(value(p, i, j - 1), x) : -1;
            if ((shape == CAGD_CODE_INCREASING && order >= 0) || (shape == CAGD_CODE_NONDECREASING && order > 0))
                abort();
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct cagd_code_harness_error error = {0};
    char *text = malloc(size + 1), *driver = NULL;
    size_t room;
    if (text == NULL)
        abort();
    memcpy(text, data, size);
    text[size] = '\0';
    int lines = 1;
    for (const char *s = text; *s != '\0'; s++)
        lines += *s == '\n';
    region_faults = 0;
    region_mark mark = region_open();
    struct cagd_code_harness *all = cagd_code_read_harness(text, &error);
    if (all == NULL && (error.cause[0] == '\0' || error.line < 0 || error.line > lines))
        abort();
    int seen = 0;
    for (const struct cagd_code_harness *h = all; h != NULL && seen++ < 4; h = h->next) {
        FILE *out = open_memstream(&driver, &room);
        cagd_code_write_driver(h, "fuzz.md", out);
        fclose(out);
        free(driver);
        if (cagd_code_patterns(h) < 1 || cagd_code_variables(h) < 0)
            abort();
        for (long k = 0; k < 3; k++) {
            struct cagd_code_point *p = cagd_code_point_new(h, k, k == 2), *copy = cagd_code_point_copy(p);
            look(h, p);
            look(h, copy);
            cagd_code_point_free(p);
            cagd_code_point_free(copy);
        }
    }
    cagd_code_harness_free(all);
    region_drop(mark);
    free(text);
    return 0;
}
