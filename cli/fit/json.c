/* json.c -- everything about a fit as JSON, and the curve as cagd curve reads it. */
#include "cli/fit/fit.h"

#include <stdlib.h>

#include <math.h>

static json_t *real(double x) { return isfinite(x) ? json_real(x) : json_null(); }

static json_t *reals(int count, const double x[])
{
    json_t *array = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(array, real(x[i]));
    return array;
}

json_t *fitted_curve_json(const cagd_spline *c)
{
    int bezier = c->count == c->degree + 1;
    for (int i = 0; i < c->count + c->degree + 1; i++)
        bezier = bezier && c->knots[i] == (i > c->degree);
    json_t *points = json_array();
    for (int j = 0; j < c->count; j++)
        json_array_append_new(points, reals(c->dim, c->points + j * c->dim));
    json_t *curve = json_pack("{s:s, s:i, s:o, s:o}", "kind", bezier ? "rational-bezier" : "nurbs", "degree", c->degree,
                              "points", points, "weights", reals(c->count, c->weights));
    if (!bezier)
        json_object_set_new(curve, "knots", reals(c->count + c->degree + 1, c->knots));
    return curve;
}

static json_t *estimate_json(cagd_fit_estimate e)
{
    static const char *const by[] = {"standard error", "profile", "none", "not sought"};
    return json_pack("{s:o, s:o, s:o, s:o, s:s}", "value", real(e.origin + e.value), "standard_error", real(e.error),
                     "low", real(e.origin + e.low), "high", real(e.origin + e.high), "interval_by", by[e.by]);
}

static json_t *unknowns_json(const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    json_t *list = json_array();
    for (int k = 0; k < r->unknowns; k++) {
        const cagd_fit_unknown *u = &r->unknown[k];
        char name[32];
        unknown_name(r, k, name);
        json_t *j =
            json_pack("{s:s, s:s, s:i}", "name", name, "kind", u->is_weight ? "weight" : "point", "index", u->index);
        if (!u->is_weight)
            json_object_set_new(j, "coordinate", json_integer(u->coordinate));
        cagd_fit_estimate e = cagd_fit_unknown_estimate(f->result, k);
        if (!u->is_weight)
            json_object_set_new(j, "from_origin", real(e.value));
        json_t *estimate = estimate_json(e);
        json_object_update(j, estimate);
        json_decref(estimate);
        json_object_set_new(j, "determined",
                            cagd_fit_is_minimum(f->result) ? json_boolean(r->determined[k]) : json_null());
        json_object_set_new(j, "at_bound", json_boolean(r->at_bound[k]));
        json_array_append_new(list, j);
    }
    return list;
}

static json_t *correlations_json(const cagd_fit_result *r)
{
    json_t *rows = json_array();
    for (int i = 0; i < r->unknowns; i++) {
        json_t *row = json_array();
        for (int j = 0; j < r->unknowns; j++)
            json_array_append_new(row, real(cagd_fit_correlation(r, i, j)));
        json_array_append_new(rows, row);
    }
    return rows;
}

static json_t *matrix_json(int rows, int columns, const double a[])
{
    json_t *list = json_array();
    for (int i = 0; i < rows; i++)
        json_array_append_new(list, reals(columns, a + (size_t)i * (size_t)columns));
    return list;
}

static json_t *conic_json(const cagd_fit_result *r)
{
    static const char *const kind[] = {"", "unknown", "straight", "undecided", "certain"};
    static const char *const type[] = {"ellipse", "parabola", "hyperbola"};
    cagd_fit_conic c = cagd_fit_conic_of(r);
    if (c.kind == CAGD_FIT_NOT_QUADRATIC)
        return json_null();
    return json_pack("{s:s, s:s, s:s, s:o, s:o}", "verdict", c.text, "kind", kind[c.kind], "type", type[c.type],
                     "log_invariant", real(c.log_invariant), "standard_error", real(c.error));
}

static json_t *verdict_json(const struct fit *f)
{
    /* what the cost does when weights leave their bounds */
    static const char *const bounds[] = {NULL, "grows", "falls", "not known"};
    const cagd_stationary_verdict *v = &f->verdict;
    if (!f->checked)
        return json_pack("{s:s}", "status", "not asked");
    if (nothing_is_free(f) || is_ellipse(f)) {
        const cagd_nearest_verdict *n = &f->nearest;
        return json_pack("{s:s, s:o, s:o, s:o}", "status",
                         n->verified  ? "verified"
                         : n->refuted ? "refuted"
                                      : "not verified",
                         "excess", n->verified ? real(n->excess) : json_null(), "reason",
                         n->verified ? json_null() : json_string(n->reason), "point",
                         n->where >= 0 ? json_integer(n->where + 1) : json_null());
    }
    if (v->verified) {
        char name[32];
        if (v->bound >= 0)
            unknown_name(f->result, v->bound, name);
        return json_pack("{s:s, s:b, s:i, s:o, s:o, s:o, s:o, s:o, s:o}", "status", "verified", "strict_minimum",
                         v->minimum, "dimension", v->dimension, "weight_radius", real(v->weight_radius), "point_radius",
                         real(v->point_radius), "weight_alone", real(v->weight_alone), "point_alone",
                         real(v->point_alone), "leaving_bounds",
                         bounds[v->bounds] != NULL ? json_string(bounds[v->bounds]) : json_null(), "bound",
                         v->bound >= 0 ? json_string(name) : json_null());
    }
    return json_pack("{s:s, s:s, s:o}", "status", "not verified", "reason", v->reason, "point",
                     v->where >= 0 ? json_integer(v->where + 1) : json_null());
}

static json_t *history_json(const cagd_fit_result *r)
{
    json_t *list = json_array();
    for (int k = 0; k < r->steps; k++) {
        const cagd_fit_step *s = &r->history[k];
        json_array_append_new(list, json_pack("{s:i, s:b, s:o, s:o, s:o, s:o}", "iteration", s->iteration, "accepted",
                                              s->accepted, "cost", real(s->cost), "gradient", real(s->gradient_norm),
                                              "step", real(s->step_norm), "trust_radius", real(s->trust_radius)));
    }
    return list;
}

/* The numbers, from 1, of the points that are measurements of the ends; null without. */
static json_t *end_points_json(const cagd_fit_result *r)
{
    return r->end_points[0] < 0 ? json_null() : json_pack("[i, i]", r->end_points[0] + 1, r->end_points[1] + 1);
}

/* Of a robust loss; otherwise null. */
static json_t *outliers_json(const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    json_t *points = json_array(), *lines = json_array();
    for (int i = 0; i < r->count; i++)
        if (r->outlier[i]) {
            json_array_append_new(points, json_integer(i + 1));
            json_array_append_new(lines, json_integer(f->points.line[i]));
        }
    json_t *all = json_pack("{s:o, s:o, s:o, s:o, s:o, s:[i, i], s:[b, b]}", "points", points, "lines", lines, "limit",
                            real(r->outlier_limit), "deviation", real(r->deviation), "rms_of_others",
                            real(r->rms_of_others), "left_out_at_ends", r->left_out[0], r->left_out[1], "ends_judged",
                            r->end_is_judged[0], r->end_is_judged[1]);
    if (f->options.loss != CAGD_FIT_SQUARES)
        return all;
    json_decref(all);
    return json_null();
}

/* The value, which is then owned by the caller alone; null where the curve is no minimum. */
static json_t *of_minimum(const struct fit *f, json_t *value)
{
    if (cagd_fit_is_minimum(f->result))
        return value;
    json_decref(value);
    return json_null();
}

static json_t *interval_json(cagd_fit_number x)
{
    return json_pack("{s:o, s:o, s:o, s:o}", "value", real(x.value), "standard_error", real(x.error), "low",
                     real(x.low), "high", real(x.high));
}

/* Of an ellipse; otherwise null. */
static json_t *ellipse_json(const struct fit *f)
{
    const cagd_fit_ellipse *e = &f->result->found.ellipse;
    if (!e->known)
        return json_null();
    json_t *centre = json_array();
    for (int c = 0; c < f->data.dim; c++)
        json_array_append_new(centre, interval_json(e->circle ? e->circle_centre[c] : e->centre[c]));
    return json_pack("{s:b, s:b, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:i}", "whole", e->whole, "circle", e->circle,
                     "centre", centre, "radius", interval_json(e->radius), "major", interval_json(e->major), "minor",
                     interval_json(e->minor), "angle",
                     f->data.dim == 2 && !e->circle ? interval_json(e->angle) : json_null(), "sweep", real(e->sweep),
                     "f_ratio", real(e->ratio), "f_degrees_of_freedom", e->freedom);
}

/* Of a conic that is told as an arc of a circle; otherwise null. */
static json_t *circle_json(const struct fit *f)
{
    const cagd_fit_circle *c = &f->circle;
    if (!tells_circle(f))
        return json_null();
    return json_pack("{s:[o, o], s:o, s:o, s:o, s:o, s:i, s:o}", "centre", interval_json(c->centre[0]),
                     interval_json(c->centre[1]), "radius", interval_json(c->radius), "sweep", real(c->sweep), "rms",
                     real(c->rms), "f_ratio", real(c->ratio), "f_degrees_of_freedom", c->freedom, "probability",
                     real(c->probability));
}

/* What was chosen, and why. */
static json_t *choice_json(const struct fit *f)
{
    static const char *const closing[] = {"open", "repeated", "around", "corner"};
    const cagd_fit_found *c = &f->result->found;
    json_t *list = json_array();
    for (int k = 0; k < c->candidates; k++)
        json_array_append_new(list, json_pack("{s:s, s:i, s:b, s:b, s:o, s:o}", "name", c->candidate[k].name,
                                              "unknowns", c->candidate[k].unknowns, "converged",
                                              c->candidate[k].converged, "good", c->candidate[k].problems == 0, "score",
                                              real(c->candidate[k].score), "rms", real(c->candidate[k].rms)));
    json_t *test = c->weights < 0 || c->weights_number == 0
                       ? json_null()
                       : json_pack("{s:b, s:o, s:[i, i], s:o}", "fitted", c->weights == 1, "f_ratio",
                                   real(c->weights_ratio), "degrees_of_freedom", c->weights_number, c->weights_freedom,
                                   "probability", real(c->weights_probability));
    const double lambda = f->options.smooth > 0 ? f->options.smooth : c->smooth;
    json_t *smoothing = !(lambda > 0) ? json_null()
                                      : json_pack("{s:o, s:s, s:o, s:o}", "lambda", real(lambda), "by",
                                                  c->smoothed == 0   ? "given"
                                                  : c->smoothed == 1 ? "cross-validation"
                                                  : c->smoothed == 3 ? "the distance"
                                                                     : "cross-validation, for lack of a good fit",
                                                  "effective_unknowns", real(f->result->effective), "roughness",
                                                  real(f->result->roughness));
    return json_pack("{s:s, s:b, s:b, s:b, s:o, s:o, s:o, s:o}", "points_are", closing[c->closing], "closed",
                     f->result->period > 0 || (c->ellipse.known && c->ellipse.whole), "control_points_chosen",
                     c->count_chosen, "knots_chosen", c->knots_chosen, "tolerance_met",
                     c->within == 0 ? json_null() : json_boolean(c->within > 0), "candidates", list, "weights_test",
                     test, "smoothing", smoothing);
}

/* The part of the curve that passes its points by most. */
static json_t *part_json(const cagd_fit_runs *runs)
{
    if (runs->points == 0)
        return json_null();
    return json_pack("{s:i, s:o, s:o, s:o, s:o}", "points", runs->points, "from", real(runs->from), "to",
                     real(runs->to), "excess", real(runs->excess), "probability", real(runs->local_probability));
}

static json_t *quality_json(const struct fit *f)
{
    const cagd_fit_quality *q = &f->quality;
    char *sentence[MOST_PROBLEMS];
    json_t *list = json_array();
    const int count = problems_of(f, sentence);
    for (int k = 0; k < count; k++) {
        json_array_append_new(list, json_string(sentence[k]));
        free(sentence[k]);
    }
    static const char *const beneath[] = {NULL, "digits", "deviations", "size"};
    return json_pack("{s:b, s:o, s:s?, s:i, s:i, s:o, s:o, s:o, s:o, s:i, s:o, s:o}", "good", count == 0, "problems",
                     list, "structure_beneath", beneath[q->beneath], "crossings", q->crossings, "crossings_of_points",
                     q->crossings_of_points, "widest_gap", real(q->gap), "same_side", json_integer(q->runs.same),
                     "pairs", json_integer(q->runs.pairs), "probability", real(q->runs.probability), "far_off",
                     q->strays, "part", part_json(&q->runs), "tried", cures_json(f));
}

json_t *fit_json(const struct fit *f)
{
    static const char *const termination[] = {"converged", "not converged", "failed"};
    static const char *const loss_name[] = {"squares", "huber", "cauchy"};
    static const char *const part[] = {"weights", "inner", "ends"};
    const cagd_fit_result *r = f->result;
    const cagd_fit_options *o = &f->options;
    json_t *free = json_array(), *invariants = json_array(), *notes = json_array();
    for (int k = 0; k < 3; k++)
        if (k == 0 && !nothing_is_free(f) ? fits_weights(f) : o->free & 1 << k)
            json_array_append_new(free, json_string(part[k]));
    for (int j = 0; j < r->invariants; j++)
        json_array_append_new(invariants, estimate_json(cagd_fit_invariant_estimate(f->result, j)));
    for (int k = 0; k < f->points.notes; k++)
        json_array_append_new(notes, text_json(f->points.note[k]));
    json_t *points = json_pack("{s:o, s:i, s:i, s:s, s:s, s:o}", "file", text_json(f->path), "count", f->data.count,
                               "dimension", f->data.dim, "sigma",
                               f->data.sigma == NULL ? "unknown"
                               : f->sigma_given      ? "one"
                                                     : "column",
                               "format", f->points.format, "notes", notes);
    json_t *options =
        json_pack("{s:o, s:s, s:o, s:b, s:o, s:o, s:i, s:I, s:o, s:i}", "free", free, "loss", loss_name[o->loss],
                  "scale", o->loss == CAGD_FIT_SQUARES ? json_null() : real(r->loss_scale), "unordered", o->unordered,
                  "weight_low", real(o->weight_low), "weight_high", real(o->weight_high), "starts", o->starts, "seed",
                  (json_int_t)o->seed, "tolerance", real(o->tolerance), "max_iterations", o->max_iterations);
    json_t *minimiser =
        json_pack("{s:s, s:s, s:i, s:i, s:i, s:o, s:o, s:o, s:o}", "termination", termination[r->termination],
                  "message", r->message, "iterations", r->iterations, "best_start", r->best_start, "agreeing_starts",
                  r->agreeing_starts, "initial_cost", real(r->initial_cost), "cost", real(r->cost), "gradient",
                  real(r->gradient_norm), "history", history_json(r));
    json_t *distances =
        json_pack("{s:o, s:o, s:i, s:i, s:i, s:i, s:i}", "rms", real(r->rms), "largest", real(r->largest),
                  "largest_point", r->largest_at + 1, "largest_line", f->points.line[r->largest_at], "feet_at_ends",
                  r->feet_at_ends, "feet_out_of_order", r->out_of_order, "feet_shared", r->tied);
    double cusp;
    int has_cusp = cagd_fit_has_cusp(r, &cusp);
    int robust = o->loss != CAGD_FIT_SQUARES; /* the sum of losses has no known distribution */
    const char *scaled_by = r->scale_is_given ? "the given standard deviations" : "the scatter of the points";
    json_t *statistics = json_pack(
        "{s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:f, s:o}", "chi_squared", real(r->chi_squared), "reduced_chi_squared",
        of_minimum(f, real(robust ? NAN : r->reduced_chi_squared)), "degrees_of_freedom",
        of_minimum(f, json_integer(r->degrees_of_freedom)), "aic", of_minimum(f, real(robust ? NAN : r->aic)), "bic",
        of_minimum(f, real(robust ? NAN : r->bic)), "scale_squared", of_minimum(f, real(r->scale_squared)), "scaled_by",
        of_minimum(f, json_string(scaled_by)), "level", 0.95, "quantile", of_minimum(f, real(r->quantile)));
    json_t *document =
        json_pack("{s:s, s:b, s:b, s:o, s:o, s:o, s:o}", "schema", "cagd-fit-1", "converged",
                  r->termination == CAGD_FIT_CONVERGED, "at_minimum", cagd_fit_is_minimum(f->result), "points", points,
                  "options", options, "minimiser", minimiser, "curve", fitted_curve_json(&r->curve));
    double spacing;
    json_object_set_new(document, "origin", reals(f->data.dim, r->origin));
    json_object_set_new(document, "finer_than_points", json_boolean(cagd_fit_finest_unknown(r, &spacing) >= 0));
    json_t *of_unknowns =
        json_pack("{s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "unknowns", unknowns_json(f), "rank",
                  of_minimum(f, json_integer(r->rank)), "free_directions",
                  of_minimum(f, matrix_json(r->flat, r->unknowns, r->free_directions)), "covariance",
                  of_minimum(f, matrix_json(r->unknowns, r->unknowns, r->covariance)), "correlations",
                  of_minimum(f, correlations_json(r)), "invariants", invariants, "conic", of_minimum(f, conic_json(r)));
    json_t *rest = json_pack("{s:o, s:o, s:b, s:b, s:o, s:o, s:o}", "statistics", statistics, "distances", distances,
                             "points_on_curve", f->result->points_on_curve, "ends_taken_as_exact",
                             f->result->ends_are_exact, "end_points", end_points_json(r), "cusp",
                             has_cusp ? real(cusp) : json_null(), "verification", verdict_json(f));
    json_object_update(document, of_unknowns);
    json_object_set_new(rest, "outliers", outliers_json(f));
    json_object_set_new(rest, "choice", choice_json(f));
    json_object_set_new(rest, "ellipse", ellipse_json(f));
    json_object_set_new(rest, "circle", circle_json(f));
    json_object_set_new(rest, "quality", quality_json(f));
    json_object_set_new(rest, "length_ratio", o->unordered ? json_null() : real(cagd_fit_length_ratio(&f->data, r)));
    json_object_update(document, rest);
    json_decref(of_unknowns);
    json_decref(rest);
    return document;
}
