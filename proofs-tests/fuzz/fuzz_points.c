/* fuzz_points.c -- files of points: what is read are finite numbers, with the line of each point; the first byte says what is asked. */
#include "proofs-tests/fuzz/file.h"

#include "cli/fit/points.h"

#include <math.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const sigma[] = {NULL, "s", "3", "sigma"};
    if (size == 0)
        return -1;
    struct columns columns = {.dim = data[0] % 3 == 0 ? 0 : 1 + data[0] % 3, .sigma = sigma[data[0] / 3 % 4]};
    struct points points;
    struct input_error error = {0};
    if (read_points(file_of("fuzz", data + 1, size - 1), &columns, &points, &error) != 0) {
        if (error.cause[0] == '\0')
            abort();
        return 0;
    }
    if (points.count < 1 || points.dim < 2 || points.dim > 3)
        abort();
    for (int m = 0; m < points.count * points.dim; m++)
        if (!isfinite(points.at[m]))
            abort();
    for (int i = 0; i < points.count; i++)
        if (points.line[i] < 1)
            abort();
    free_points(&points);
    return 0;
}
