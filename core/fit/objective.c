#include "core/fit/objective.h"

#include "core/fit/statistics.h"
#include "core/number/limits.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void fit_problem_set(const fit_problem *p, const double theta[], fit_curve *curve)
{
    for (int k = 0; k < p->unknowns; k++) {
        cagd_fit_unknown u = p->unknown[k];
        if (u.is_weight)
            curve->weights[u.index] = exp(theta[k]);
        else
            curve->points[u.index * p->dim + u.coordinate] = theta[k];
    }
    fit_curve_update(curve);
}

void fit_problem_get(const fit_problem *p, const fit_curve *curve, double theta[])
{
    for (int k = 0; k < p->unknowns; k++) {
        cagd_fit_unknown u = p->unknown[k];
        theta[k] = u.is_weight ? log(curve->weights[u.index]) : curve->points[u.index * p->dim + u.coordinate];
    }
}

double fit_problem_loss(const fit_problem *p, double x, double *slope)
{
    double value[3] = {x, 1, 0};
    if (p->loss != CAGD_FIT_SQUARES)
        fit_loss(p->loss, p->loss_scale, x, value);
    *slope = value[1];
    return value[0];
}

fit_objective *fit_objective_new(const fit_problem *p)
{
    fit_objective *o = calloc(1, sizeof *o);
    if (o == NULL)
        return NULL;
    size_t n = (size_t)p->unknowns + 1, points = (size_t)p->points;
    o->problem = p;
    o->limit = FOOT_EXACT;
    o->curve = fit_curve_new(p->degree, p->count, p->dim, p->knots);
    if (o->curve != NULL)
        o->rows = fit_reduction_new(p->unknowns, 1, o->curve->pieces, p->first, p->reach);
    o->feet = malloc(points * sizeof *o->feet);
    o->new_feet = malloc(points * sizeof *o->new_feet);
    o->theta = malloc(n * sizeof *o->theta);
    o->new_theta = malloc(n * sizeof *o->new_theta);
    o->triangle = malloc(n * n * sizeof *o->triangle);
    if (!o->curve || !o->rows || !o->feet || !o->new_feet || !o->theta || !o->new_theta || !o->triangle) {
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
    free(o->feet);
    free(o->new_feet);
    free(o->theta);
    free(o->new_theta);
    free(o->triangle);
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
    /* The other two columns of the reflection that takes an axis to the tangent T: e - v v_e/(1 + |T_axis|), v = T + sign axis. */
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

/* The rows of point i at its foot t, in `dim` dimensions, a constant for the compiler; returns its loss. */
static inline double point_rows(fit_objective *o, const int dim, int i, fit_foot_kind kind, double t, const double D[],
                                int weighted)
{
    const fit_problem *p = o->problem;
    const fit_curve *curve = o->curve;
    const int piece = curve->pieces == 1 ? 0 : fit_curve_piece(curve, t), degree = p->degree;
    const double *q = p->Q + (size_t)i * (size_t)dim, *P = curve->points + (curve->span[piece] - degree) * dim;
    double R[MAX_DEGREE + 1], n[3][3], precision = p->precision[i], left[3], square = 0, slope = 1;
    const int count = directions(dim, kind, D + dim, n);
    fit_curve_shares(curve, piece, t, R);
    for (int r = 0; r < count; r++) {
        left[r] = 0;
        for (int c = 0; c < dim; c++)
            left[r] += n[r][c] * (q[c] - D[c]);
        left[r] *= precision;
        square += left[r] * left[r];
    }
    const double loss = p->loss == CAGD_FIT_SQUARES ? square : fit_problem_loss(p, square, &slope);
    const double factor = weighted ? sqrt(slope) : 1, scale = -factor * precision;
    const cagd_fit_unknown *slot = p->slot + p->first[piece], *end = p->slot + p->first[piece + 1];
    for (int r = 0; r < count; r++) {
        int stride;
        double *row = fit_reduction_row(o->rows, piece, &stride);
        for (const cagd_fit_unknown *u = slot; u < end; u++, row += stride) {
            double along = n[r][u->coordinate];
            if (u->is_weight) {
                along = 0;
                for (int c = 0; c < dim; c++)
                    along += n[r][c] * (P[u->index * dim + c] - D[c]);
            }
            *row = R[u->index] * scale * along;
        }
        *row = factor * left[r];
    }
    return loss;
}

/* Whether weights and points are numbers, and no weight has vanished. */
static int is_curve(const fit_problem *p, const double theta[], const fit_curve *curve)
{
    int good = 1;
    for (int k = 0; k < p->unknowns; k++)
        good =
            good && isfinite(theta[k]) && (!p->unknown[k].is_weight || isnormal(curve->weights[p->unknown[k].index]));
    return good;
}

void fit_objective_evaluate(fit_objective *o, const double theta[], int weighted)
{
    const fit_problem *p = o->problem;
    int n = p->unknowns + 1;
    double sum = 0, lost = 0, D[9];
    fit_problem_set(p, theta, o->curve);
    fit_reduction_clear(o->rows);
    const int curve = is_curve(p, theta, o->curve);
    for (int i = 0; i < p->points; i++) {
        double t = o->new_feet[i] = o->feet[i];
        if (!curve)
            continue;
        fit_foot_kind kind = fit_foot_near(o->curve, p->Q + (size_t)i * (size_t)p->dim, o->limit, &t, D);
        double loss =
            p->dim == 2 ? point_rows(o, 2, i, kind, t, D, weighted) : point_rows(o, 3, i, kind, t, D, weighted);
        o->new_feet[i] = t;
        double next = sum + (loss - lost); /* with the rounding of the last sum taken off: Kahan */
        lost = (next - sum) - (loss - lost);
        sum = next;
    }
    memcpy(o->triangle, fit_reduction_triangle(o->rows), (size_t)(n * n) * sizeof *o->triangle);
    memmove(o->new_theta, theta, (size_t)p->unknowns * sizeof *theta);
    o->cost = curve ? sum / 2 : HUGE_VAL;
    o->evaluated = weighted;
}

void fit_objective_at(fit_objective *o, const double theta[])
{
    if (!o->evaluated || memcmp(theta, o->new_theta, (size_t)o->problem->unknowns * sizeof *theta) != 0)
        fit_objective_evaluate(o, theta, 1);
}

void fit_objective_accept(fit_objective *o)
{
    memcpy(o->feet, o->new_feet, (size_t)o->problem->points * sizeof *o->feet);
    memcpy(o->theta, o->new_theta, (size_t)o->problem->unknowns * sizeof *o->theta);
}

int fit_objective_residuals(void *objective, const double theta[], double residuals[], double jacobian[])
{
    fit_objective *o = objective;
    int n = o->problem->unknowns;
    fit_objective_at(o, theta);
    if (!isfinite(o->cost))
        return 0;
    double rest = 2 * o->cost;
    for (int k = 0; k < n; k++) {
        residuals[k] = o->triangle[k * (n + 1) + n];
        rest -= residuals[k] * residuals[k];
    }
    residuals[n] = sqrt(fmax(0, rest));
    if (jacobian != NULL) {
        for (int k = 0; k < n; k++)
            memcpy(jacobian + k * n, o->triangle + k * (n + 1), (size_t)n * sizeof *jacobian);
        memset(jacobian + n * n, 0, (size_t)n * sizeof *jacobian);
        fit_objective_accept(o);
    }
    return 1;
}
