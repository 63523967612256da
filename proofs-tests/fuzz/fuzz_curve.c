/* fuzz_curve.c -- files of curves: a curve that is read passes the check, and what is written of it is read as the same curve. */
#include "proofs-tests/fuzz/file.h"

#include "cli/curve_json.h"

#include <string.h>

static int same(int count, const num_q a[], const num_q b[])
{
    for (int i = 0; i < count; i++)
        if (!cagd_equal_q(a[i], b[i]))
            return 0;
    return 1;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input_error error = {0};
    cagd_spline_q c, again;
    int where;
    region_faults = 0;
    region_mark mark = region_open();
    if (read_curve(file_of("fuzz.json", data, size), &c, &error) != 0) {
        if (error.cause[0] == '\0')
            abort();
    } else {
        if (cagd_spline_check_q(&c, &where) != CAGD_OK)
            abort();
        json_t *document = curve_json(&c);
        char *text = json_dumps(document, 0);
        json_decref(document);
        if (read_curve(file_of("fuzz.json", (const uint8_t *)text, strlen(text)), &again, &error) != 0 ||
            again.degree != c.degree || again.count != c.count || again.dim != c.dim ||
            (again.weights == NULL) != (c.weights == NULL) || !same(c.count * c.dim, c.points, again.points) ||
            !same(c.count + c.degree + 1, c.knots, again.knots) ||
            (c.weights != NULL && !same(c.count, c.weights, again.weights)))
            abort();
        free(text);
    }
    region_drop(mark);
    return 0;
}
