#include "core/fit/objective.h"

#include "core/fit/batch.h"
#include "core/fit/feet.h"
#include "core/fit/loss.h"
#include "core/fit/smoothing.h"
#include "core/fit/unknowns.h"
#include "core/number/limits.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

fit_objective *fit_objective_new(const fit_problem *p)
{
    fit_objective *o = calloc(1, sizeof *o);
    if (o == NULL)
        return NULL;
    size_t n = (size_t)p->unknowns + 1, points = (size_t)p->points;
    o->problem = p;
    o->limit = FOOT_EXACT;
    o->width = fit_batch_widest();
    o->curve = fit_curve_new(p->degree, p->count, p->period, p->dim, p->knots);
    if (o->curve != NULL)
        o->rows = fit_reduction_new(&p->support, 1);
    if (o->curve != NULL)
        o->second = fit_curvature_new(&p->support);
    o->feet = malloc(points * sizeof *o->feet);
    o->new_feet = malloc(points * sizeof *o->new_feet);
    o->x = malloc(n * sizeof *o->x);
    o->new_x = malloc(n * sizeof *o->new_x);
    o->triangle = malloc(n * n * sizeof *o->triangle);
    o->base = fit_curve_new(p->degree, p->count, p->period, p->dim, p->knots);
    o->inverse = malloc((size_t)p->count * sizeof *o->inverse);
    if (!o->curve || !o->rows || !o->second || !o->feet || !o->new_feet || !o->x || !o->new_x || !o->triangle ||
        !o->base || !o->inverse) {
        fit_objective_free(o);
        return NULL;
    }
    return o;
}

void fit_objective_free(fit_objective *o)
{
    if (o == NULL)
        return;
    fit_curve_free(o->curve);
    fit_reduction_free(o->rows);
    fit_curvature_free(o->second);
    free(o->feet);
    free(o->new_feet);
    free(o->x);
    free(o->new_x);
    free(o->triangle);
    fit_curve_free(o->base);
    free(o->inverse);
    free(o);
}

/* Orthonormal directions: those orthogonal to the tangent, or all.  Their number. */
static int directions(int dim, fit_foot_kind kind, const double tangent[], double n[3][3])
{
    if (kind != FOOT_ORTHOGONAL) {
        for (int i = 0; i < dim; i++)
            for (int c = 0; c < dim; c++)
                n[i][c] = i == c;
        return dim;
    }
    double length = sqrt(tangent[0] * tangent[0] + tangent[1] * tangent[1] + (dim == 3 ? tangent[2] * tangent[2] : 0));
    if (dim == 2) {
        n[0][0] = -tangent[1] / length;
        n[0][1] = tangent[0] / length;
        return 1;
    }
    /* The other two columns of the reflection that takes an axis to the tangent T: e - v v_e/(1 + |T_axis|), v = T +
     * sign axis. */
    double T[3] = {tangent[0] / length, tangent[1] / length, tangent[2] / length};
    int axis = fabs(T[0]) > fabs(T[1]) ? 0 : 1;
    axis = fabs(T[2]) > fabs(T[axis]) ? 2 : axis;
    double v[3] = {T[0], T[1], T[2]}, factor = 1 / (1 + fabs(T[axis]));
    v[axis] += T[axis] < 0 ? -1 : 1;
    for (int i = 0, c = 0; c < 3; c++)
        if (c != axis) {
            for (int k = 0; k < 3; k++)
                n[i][k] = (k == c) - factor * v[c] * v[k];
            i++;
        }
    return 2;
}

/* What the second derivatives of point i add to the Hessian matrix, r = (C - Q)/s_i and derivatives in units of s_i.
 *
 * Along x_j and x_k  r . C_jk,  and where the foot moves,  (tau_j tau_k)/|C'|^2 - (tau_j + rho_j)(tau_k + rho_k)/f, f
 * = |C'|^2 + r . C'',  tau_j = C_j . C',  rho_j = r . C'_j:  rows of distances lack the tangential part of C_j . C_k,
 * and the foot takes a part of it away.  The two nearly cancel; their difference is -(rho_j a_k + tau_j b_k)/f, a =
 * rho + tau, b = rho - kappa tau, kappa = r . C''/|C'|^2.  With h_j = r . C_j, and e_j = N_j/(sum N w) for weights, 0
 * for the others, r . C_jk = -(h_j e_k + e_j h_k).  The loss multiplies with rho' and adds 2 rho'' h_j h_k. */
static inline void point_curvature(fit_objective *o, const int dim, int i, int piece, fit_foot_kind kind,
                                   const double D[], const double B[], const double N[], const double N1[],
                                   const double loss[3])
{
    const fit_problem *p = o->problem;
    const double *q = p->Q + (size_t)i * (size_t)dim, *D1 = D + dim, *D2 = D1 + dim;
    const double precision = p->precision[i], scale = -loss[1] * precision * precision;
    double r[3], speed = 0, bend = 0, slide = 0;
    for (int c = 0; c < dim; c++) {
        r[c] = D[c] - q[c];
        speed += D1[c] * D1[c];
        bend += r[c] * D2[c];
        slide += r[c] * D1[c];
    }
    const int moves = kind == FOOT_ORTHOGONAL && speed + bend > 0, robust = p->loss != CAGD_FIT_SQUARES;
    const double f = moves ? scale / (speed + bend) : 0, kappa = moves ? bend / speed : 0;
    const cagd_fit_unknown *local = p->local + p->support.first[piece], *end = p->local + p->support.first[piece + 1];
    const int n = (int)(end - local);
    int stride;
    double *x = fit_curvature_pairs(o->second, piece, 4 + robust, &stride), *y = x + n * stride;
    for (const cagd_fit_unknown *u = local; u < end; u++, x += stride, y += stride) {
        double along = D1[u->coordinate], off = r[u->coordinate], fixed = 0;
        if (u->is_weight) {
            along = off = 0;
            for (int c = 0; c < dim; c++) {
                along += (B[u->index * dim + c] - D[c]) * D1[c];
                off += (B[u->index * dim + c] - D[c]) * r[c];
            }
            fixed = N[u->index];
        }
        const double tau = N[u->index] * along, rho = N1[u->index] * off - fixed * slide, hold = N[u->index] * off;
        x[0] = f * rho, y[0] = rho + tau;
        x[1] = f * tau, y[1] = rho - kappa * tau;
        x[2] = scale * hold, y[2] = fixed;
        x[3] = scale * fixed, y[3] = hold;
        if (robust)
            x[4] = 2 * loss[2] * precision * precision * precision * precision * hold, y[4] = hold;
    }
}

/* The rows of point i at its foot t, in `dim` dimensions, a constant for the compiler, none for its cost alone; returns its loss. */
static inline double point_rows(fit_objective *o, const int dim, int i, fit_foot_kind kind, double t, const double D[],
                                fit_extent extent)
{
    const fit_problem *p = o->problem;
    const fit_curve *curve = o->curve;
    const int piece = curve->pieces == 1 ? 0 : fit_curve_piece(curve, t), degree = p->degree;
    const double *q = p->Q + (size_t)i * (size_t)dim, *B = o->base->points + (curve->span[piece] - degree) * dim,
                 *inverse = o->inverse + curve->span[piece] - degree;
    double N[MAX_DEGREE + 1], N1[MAX_DEGREE + 1], n[3][3], precision = p->precision[i], left[3], square = 0;
    const int count = directions(dim, kind, D + dim, n), weighted = extent == FIT_ROWS;
    for (int r = 0; r < count; r++) {
        left[r] = 0;
        for (int c = 0; c < dim; c++)
            left[r] += n[r][c] * (q[c] - D[c]);
        left[r] *= precision;
        square += left[r] * left[r];
    }
    double loss[3] = {square, 1, 0};
    if (p->loss != CAGD_FIT_SQUARES)
        fit_loss(p->loss, p->loss_scale, square, loss);
    if (extent == FIT_COST)
        return loss[0];
    fit_curve_shares(curve, piece, t, N, N1);
    for (int m = 0; m <= degree; m++) { /* without their weights: N/(sum N w) */
        N[m] *= inverse[m];
        N1[m] *= inverse[m];
    }
    const double factor = weighted ? sqrt(loss[1]) : 1, scale = -factor * precision;
    const cagd_fit_unknown *local = p->local + p->support.first[piece], *end = p->local + p->support.first[piece + 1];
    for (int r = 0; r < count; r++) {
        int stride;
        double *row = fit_reduction_row(o->rows, piece, &stride);
        for (const cagd_fit_unknown *u = local; u < end; u++, row += stride) {
            double along = n[r][u->coordinate];
            if (u->is_weight) {
                along = 0;
                for (int c = 0; c < dim; c++)
                    along += n[r][c] * (B[u->index * dim + c] - D[c]);
            }
            *row = N[u->index] * scale * along;
        }
        *row = factor * left[r];
    }
    if (weighted && o->newton)
        point_curvature(o, dim, i, piece, kind, D, B, N, N1, loss);
    return loss[0];
}

/* The rows of the smoothing term, and its square. */
static double smoothing_rows(fit_objective *o)
{
    const fit_problem *p = o->problem;
    const fit_curve *curve = o->curve;
    const int nodes = fit_smoothing_nodes(p);
    double N[MAX_DEGREE + 1], sum = 0;
    for (int piece = 0; piece < curve->pieces && nodes > 0; piece++)
        for (int g = 0; g < nodes; g++) {
            fit_smoothing_row(p, curve, piece, g, N);
            const double *inverse = o->inverse + curve->span[piece] - p->degree;
            for (int c = 0; c < p->dim; c++) {
                int stride;
                double *row = fit_reduction_row(o->rows, piece, &stride);
                for (int k = p->support.first[piece]; k < p->support.first[piece + 1]; k++, row += stride)
                    *row = p->local[k].coordinate == c ? N[p->local[k].index] * inverse[p->local[k].index] : 0;
                *row = fit_smoothing_residual(p, curve, piece, N, c);
                sum += *row * *row;
            }
        }
    return sum;
}

/* Whether weights and points are numbers, and no weight has vanished. */
static int is_curve(const fit_problem *p, const double x[], const fit_curve *curve)
{
    int good = 1;
    for (int k = 0; k < p->unknowns; k++)
        good = good && isfinite(x[k]) && (!p->unknown[k].is_weight || isnormal(curve->weights[p->unknown[k].index]));
    return good;
}

/* Columns and curvature by weights w become those by y, w = b phi(y): a factor dw/dy, and phi''/phi' times the
 * gradient. */
static void by_weights(fit_objective *o, const double x[], int newton)
{
    const fit_problem *p = o->problem;
    int n = p->unknowns;
    for (int k = 0; k < n; k++) {
        if (!p->unknown[k].is_weight)
            continue;
        double slope = o->base->weights[p->unknown[k].index] * fit_weight_slope(x[k]);
        for (int i = 0; i < n; i++) {
            o->triangle[i * (n + 1) + k] *= slope;
            if (newton)
                o->curvature[i * n + k] *= slope, o->curvature[k * n + i] *= slope;
        }
        if (newton)
            o->curvature[k * n + k] += fit_weight_bend(x[k]) * fit_objective_gradient(o, k);
    }
}

/* Foot and rows of point i; returns its loss. */
static double point(fit_objective *o, int i, int curve, fit_extent extent)
{
    const fit_problem *p = o->problem;
    double t = o->new_feet[i] = o->feet[i], D[9];
    if (!curve)
        return 0;
    fit_foot_kind kind = fit_held_foot(p, o->curve, i, &t, D)
                             ? FOOT_AT_END
                             : fit_foot_near(o->curve, p->Q + (size_t)i * (size_t)p->dim, o->limit, &t, D);
    o->new_feet[i] = t;
    return p->dim == 2 ? point_rows(o, 2, i, kind, t, D, extent) : point_rows(o, 3, i, kind, t, D, extent);
}

void fit_objective_evaluate(fit_objective *o, const double x[], fit_extent extent)
{
    const fit_problem *p = o->problem;
    const int n = p->unknowns + 1, weighted = extent == FIT_ROWS;
    double sum[FIT_BATCH] = {0}, lost[FIT_BATCH] = {0};
    fit_unknowns_to_curve(p, o->base, x, o->curve);
    for (int j = 0; j < p->count; j++)
        o->inverse[j] = 1 / o->curve->weights[j];
    fit_reduction_clear(o->rows);
    if (weighted && o->newton)
        fit_curvature_clear(o->second);
    const int curve = is_curve(p, x, o->curve);
    for (int i = 0, count; i < p->points; i += count) {
        double loss[FIT_BATCH] = {0};
        count = curve && fit_batch(o, i, extent, loss) ? FIT_BATCH : 0;
        if (count == 0) { /* one by one, as many */
            for (; count < FIT_BATCH && i + count < p->points; count++)
                loss[count] = point(o, i + count, curve, extent);
        }
        for (int k = 0; k < FIT_BATCH;
             k++) { /* so many sums, each with the rounding of the last one taken off: Kahan */
            double more = loss[k] - lost[k], next = sum[k] + more;
            lost[k] = (next - sum[k]) - more;
            sum[k] = next;
        }
    }
    for (int k = 1; k < FIT_BATCH; k++)
        sum[0] += sum[k];
    const double bending = curve && extent != FIT_DISTANCES ? smoothing_rows(o) : 0;
    if (extent != FIT_COST) {
        memcpy(o->triangle, fit_reduction_triangle(o->rows), (size_t)(n * n) * sizeof *o->triangle);
        if (weighted && o->newton)
            o->curvature = fit_curvature_matrix(o->second);
        by_weights(o, x, weighted && o->newton);
    }
    memmove(o->new_x, x, (size_t)p->unknowns * sizeof *x);
    o->cost = curve ? (sum[0] + bending) / 2 : HUGE_VAL;
    o->evaluated = weighted;
}

void fit_objective_at(fit_objective *o, const double x[])
{
    if (!o->evaluated || memcmp(x, o->new_x, (size_t)o->problem->unknowns * sizeof *x) != 0)
        fit_objective_evaluate(o, x, FIT_ROWS);
}

void fit_objective_accept(fit_objective *o)
{
    o->accepted = o->cost;
    memcpy(o->feet, o->new_feet, (size_t)o->problem->points * sizeof *o->feet);
    memcpy(o->x, o->new_x, (size_t)o->problem->unknowns * sizeof *o->x);
}

/* Puts the curve there as the base, with its weights between the bounds, and evaluates it. */
static void begin(fit_objective *o, const fit_curve *curve, const double feet[], fit_extent extent)
{
    const fit_problem *p = o->problem;
    fit_curve_copy(o->curve, curve);
    fit_curve_copy(o->base, curve);
    memcpy(o->feet, feet, (size_t)p->points * sizeof *feet);
    for (int k = 0; k < p->unknowns; k++)
        if (p->unknown[k].is_weight) {
            double *w = &o->curve->weights[p->unknown[k].index];
            *w = fmin(fmax(*w, p->low), p->high);
        }
    fit_unknowns_of_curve(p, o->base, o->curve, o->x);
    fit_objective_evaluate(o, o->x, extent);
    fit_objective_accept(o);
}

void fit_objective_begin(fit_objective *o, const fit_curve *curve, const double feet[])
{
    begin(o, curve, feet, FIT_ROWS);
}

double fit_objective_cost(fit_objective *o, const fit_curve *curve, const double feet[])
{
    begin(o, curve, feet, FIT_COST);
    return o->cost;
}

/* Along log w_j the weight moves by w_j and w_j (P_j - B_j) by itself, along P_j by w_j. */
void fit_objective_by_theta(fit_objective *o)
{
    const fit_problem *p = o->problem;
    int n = p->unknowns, rows = n + 1;
    for (int k = 0; k < n; k++) {
        cagd_fit_unknown u = p->unknown[k];
        double w = o->curve->weights[u.index];
        double scale = u.is_weight ? o->base->weights[u.index] * fit_weight_slope(o->x[k]) : 1;
        for (int i = 0; i < n; i++) {
            double *row = o->triangle + i * rows, by_point = 0;
            for (int m = k + 1; u.is_weight && m < n && p->unknown[m].index == u.index; m++) {
                int c = u.index * p->dim + p->unknown[m].coordinate;
                by_point += row[m] * (o->curve->points[c] - o->base->points[c]);
            }
            row[k] = w * (row[k] / scale + by_point);
        }
    }
    o->evaluated = 0;
}

double fit_objective_gradient(const fit_objective *o, int k)
{
    int n = o->problem->unknowns;
    double g = 0;
    for (int i = 0; i < n; i++)
        g += o->triangle[i * (n + 1) + k] * o->triangle[i * (n + 1) + n];
    return g;
}
