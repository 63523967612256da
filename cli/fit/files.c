/* files.c -- the files of a fit: its curve, and its residuals as a table. */
#include "cli/fit/fit.h"

#include <math.h>
#include <stdlib.h>

static const char coordinate[] = "xyz";

int write_curve(const struct fit *f, const char *path)
{
    json_t *curve = fitted_curve_json(&f->result->curve);
    char *text = json_dumps(curve, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
    struct output *o = output_open(path);
    if (o != NULL)
        fprintf(output_stream(o), "%s\n", text);
    int code = o == NULL ? -1 : output_close(o);
    free(text);
    json_decref(curve);
    return code;
}

/* One row a point: its number, its line in the file, its coordinates, the parameter of the foot and the foot, the
 * residual in every coordinate, the distance, and that over the standard deviation, which is the estimated one where
 * none is given, and nothing where the curve is no minimum; of a robust
 * loss whether it is an outlier. */
int write_residuals(const struct fit *f, const char *path)
{
    const cagd_fit_result *r = f->result;
    int dim = f->data.dim, robust = f->options.loss != CAGD_FIT_SQUARES;
    struct output *o = output_open(path);
    if (o == NULL)
        return -1;
    FILE *out = output_stream(o);
    fputs("row,line", out);
    for (int x = 0; x < dim; x++)
        fprintf(out, ",%c", coordinate[x]);
    fputs(",t", out);
    for (int x = 0; x < dim; x++)
        fprintf(out, ",foot_%c", coordinate[x]);
    for (int x = 0; x < dim; x++)
        fprintf(out, ",residual_%c", coordinate[x]);
    fprintf(out, ",distance,standardised%s\n", robust ? ",outlier" : "");
    for (int i = 0; i < r->count; i++) {
        const double *Q = f->data.points + i * dim, *e = r->residuals + i * dim;
        double standardised = cagd_fit_standardised(&f->data, r, i);
        fprintf(out, "%d,%d", i + 1, f->points.line[i]);
        for (int x = 0; x < dim; x++)
            fprintf(out, ",%.17g", Q[x]);
        fprintf(out, ",%.17g", r->feet[i]);
        for (int x = 0; x < dim; x++)
            fprintf(out, ",%.17g", Q[x] - e[x]);
        for (int x = 0; x < dim; x++)
            fprintf(out, ",%.17g", e[x]);
        fprintf(out, ",%.17g,", r->distances[i]);
        if (isfinite(standardised))
            fprintf(out, "%.17g", standardised);
        fprintf(out, robust ? ",%d\n" : "\n", r->outlier[i]);
    }
    return output_close(o);
}
