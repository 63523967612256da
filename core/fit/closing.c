#include "core/fit/closing.h"

#include <math.h>
#include <stdlib.h>

/* closing.c -- whether points come back to where they began. */

enum { GROUPS = 64, FEWEST = 5 };

static const double FARTHEST = 1.5; /* times the longer step beside it may the way back be                       */
static const double CORNER = 60;    /* degrees: a turn at the seam that is larger, and                            */
static const double OTHERS = 1.5;   /* so many times as large as any other turn, is a corner                      */

static double distance(int dim, const double a[], const double b[])
{
    double sum = 0;
    for (int c = 0; c < dim; c++)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sqrt(sum);
}

/* The angle in degrees between b - a and d - c. */
static double turn(int dim, const double a[], const double b[], const double c[], const double d[])
{
    double inner = 0, u = distance(dim, a, b), v = distance(dim, c, d);
    for (int k = 0; k < dim; k++)
        inner += (b[k] - a[k]) * (d[k] - c[k]);
    return u > 0 && v > 0 ? acos(fmax(-1, fmin(1, inner / (u * v)))) * 180 / acos(-1) : 0;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The closing of the polygon of `count` points that do not repeat the first one. */
static cagd_fit_closing closing_of(int count, int dim, const double P[], int repeated)
{
    double step[GROUPS * 2], others = 0, at_seam;
    const double *last = P + (count - 1) * dim, *first = P;
    for (int i = 1; i < count; i++)
        step[i - 1] = distance(dim, P + (i - 1) * dim, P + i * dim);
    const double back = distance(dim, last, first), beside = fmax(step[0], step[count - 2]);
    qsort(step, (size_t)count - 1, sizeof *step, by_size);
    const double usual = step[(count - 1) / 2];
    if (!repeated && !(back <= FARTHEST * fmax(usual, beside)))
        return CAGD_FIT_OPEN;
    for (int i = 1; i < count - 1; i++)
        others = fmax(others, turn(dim, P + (i - 1) * dim, P + i * dim, P + i * dim, P + (i + 1) * dim));
    if (!repeated && back < usual / 4) /* a short way back has no direction of its own: the turn over it */
        at_seam = turn(dim, last - dim, last, first, first + dim);
    else
        at_seam = fmax(turn(dim, last - dim, last, last, first), turn(dim, last, first, first, first + dim));
    int corner = at_seam > CORNER && at_seam > OTHERS * others;
    return corner ? CAGD_FIT_CORNER : repeated ? CAGD_FIT_REPEATED : CAGD_FIT_AROUND;
}

/* A point and the angle under which it is seen. */
typedef struct seen {
    double angle;
    int index;
} seen;

static int by_angle(const void *a, const void *b)
{
    const seen *x = a, *y = b;
    return x->angle != y->angle ? (x->angle > y->angle) - (x->angle < y->angle)
                                : (x->index > y->index) - (x->index < y->index);
}

/* In the plane: the points by the angle under which the centre sees them.  They go around it where no gap between neighbours is
 * wider than a sixth of a turn, and where a group of neighbours scatters across by less than a quarter of its distance from the
 * centre. */
static cagd_fit_closing around_centre(const cagd_fit_data *data)
{
    const double round = 2 * acos(-1);
    const int n = data->count, groups = n / 4 < GROUPS / 2 ? n / 4 : GROUPS / 2;
    double centre[2] = {0}, widest = 0;
    seen *list = malloc((size_t)n * sizeof *list);
    if (list == NULL || data->dim != 2 || n < 12) {
        free(list);
        return CAGD_FIT_OPEN;
    }
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 2; c++)
            centre[c] += data->points[2 * i + c] / n;
    for (int i = 0; i < n; i++)
        list[i] = (seen){atan2(data->points[2 * i + 1] - centre[1], data->points[2 * i] - centre[0]), i};
    qsort(list, (size_t)n, sizeof *list, by_angle);
    for (int i = 0; i < n; i++)
        widest = fmax(widest, i > 0 ? list[i].angle - list[i - 1].angle : list[0].angle + round - list[n - 1].angle);
    int ring = widest < round / 6;
    for (int g = 0; g < groups && ring; g++) {
        const int low = (int)((long)n * g / groups), high = (int)((long)n * (g + 1) / groups);
        double sum = 0, slope = 0, along = 0, square = 0, middle = 0, across = 0;
        for (int i = low; i < high; i++) {
            sum += distance(2, data->points + 2 * list[i].index, centre) / (high - low);
            middle += list[i].angle / (high - low);
        }
        for (int i = low; i < high; i++) { /* the scatter about a line through the group */
            double r = distance(2, data->points + 2 * list[i].index, centre) - sum, a = list[i].angle - middle;
            slope += a * r, along += a * a, square += r * r;
        }
        across = square - (along > 0 ? slope * slope / along : 0);
        ring = sqrt(fmax(0, across) / (high - low)) < sum / 4;
    }
    free(list);
    return ring ? CAGD_FIT_AROUND : CAGD_FIT_OPEN;
}

int fit_repeats_first(const cagd_fit_data *data)
{
    double farthest = 0;
    const double *last = data->points + (size_t)(data->count - 1) * (size_t)data->dim;
    for (int i = 0; i < data->count; i++)
        farthest = fmax(farthest, distance(data->dim, data->points, data->points + (size_t)i * (size_t)data->dim));
    return data->count > FEWEST && distance(data->dim, data->points, last) <= 0x1p-40 * farthest;
}

cagd_fit_closing cagd_fit_closing_of(const cagd_fit_data *data, int unordered)
{
    const int dim = data->dim;
    if (unordered)
        return around_centre(data);
    const int repeated = fit_repeats_first(data), n = data->count - repeated, groups = n < GROUPS ? n : GROUPS;
    double P[GROUPS * 3] = {0};
    if (n < FEWEST)
        return CAGD_FIT_OPEN;
    for (int g = 0; g < groups; g++) { /* single points may be scattered by more than they are apart */
        const int low = (int)((long)n * g / groups), high = (int)((long)n * (g + 1) / groups);
        for (int i = low; i < high; i++)
            for (int c = 0; c < dim; c++)
                P[g * dim + c] += (data->points[(size_t)i * (size_t)dim + (size_t)c] - data->points[c]) / (high - low);
    }
    return closing_of(groups, dim, P, repeated);
}
