/* curve.c -- cagd curve: computes with a curve in exact arithmetic. */
#include "cli/commands.h"
#include "cli/curve_json.h"
#include "cli/report.h"
#include "exact/decide/sign.h"
#include "exact/kernels_q.h"
#include "exact/span.h"
#include "exact/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_PARAMETERS = 1000 };
enum action { DESCRIBE, INSERT, REMOVE, ELEVATE, REDUCE, SPLIT, BEZIER };

struct arguments {
    struct asked asked;
    const char *path;
    num_q at[MOST_PARAMETERS], knot[MOST_PARAMETERS];
    int parameters, knots, derivatives, left;
    enum action action;
};

static void act(struct argp_state *state, struct arguments *a, enum action action)
{
    if (a->action != DESCRIBE && (a->action != action || action == SPLIT))
        argp_error(state,
                   "one change at a time: of --insert, --remove, --elevate, --reduce, --split and --bezier only one is "
                   "possible (--insert and --remove may be repeated)");
    a->action = action;
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    switch (key) {
    case 't':
    case 'i':
    case 'r':
    case 's':
        if (a->parameters + a->knots >= MOST_PARAMETERS)
            argp_error(state, "at most %d parameters and knots", MOST_PARAMETERS);
        if (key == 't') {
            a->at[a->parameters++] = exact_number(state, "--at", arg);
            break;
        }
        act(state, a, key == 'i' ? INSERT : key == 'r' ? REMOVE : SPLIT);
        a->knot[a->knots++] = exact_number(state, key == 'i' ? "--insert" : key == 'r' ? "--remove" : "--split", arg);
        break;
    case 'd':
        a->derivatives = whole_number(state, "--derivatives", arg, 0, MAX_DEGREE);
        break;
    case 'l':
        a->left = 1;
        break;
    case 'e':
        act(state, a, ELEVATE);
        break;
    case 'u':
        act(state, a, REDUCE);
        break;
    case 'b':
        act(state, a, BEZIER);
        break;
    case ARGP_KEY_ARG:
        if (a->path != NULL)
            argp_error(state, "one curve at a time: '%s' or '%s'?", a->path, arg);
        a->path = arg;
        break;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "expected the file of a curve");
        break;
    case ARGP_KEY_END:
        if (a->action != DESCRIBE && a->parameters > 0)
            argp_error(state, "--at belongs to the curve as it is; the changed curve can be read again");
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

/* ---- values at a parameter -------------------------------------------------------------------- */

static num_q *numbers(int count) { return region_bytes((size_t)count * sizeof(num_q)); }

static int complain(const struct arguments *a, const char *what, num_q t)
{
    fprintf(stderr, "cagd: %s: %s %s\n", strcmp(a->path, "-") == 0 ? "standard input" : a->path, what, to_string_q(t));
    return EXIT_USAGE;
}

static json_t *vector_json(int dim, const num_q x[], int rounded)
{
    json_t *array = json_array();
    for (int c = 0; c < dim; c++)
        json_array_append_new(array, rounded ? json_real(to_double_q(x[c])) : number_json(x[c]));
    return array;
}

/* "(1/3, 2)  = (0.333333333333333, 2)"; the exact values only where they are short enough to read. */
static void print_vector(const char *name, int dim, const num_q x[])
{
    enum { READABLE = 48 };
    size_t length = 0;
    int whole = 1;
    for (int c = 0; c < dim; c++) {
        length += strlen(to_string_q(x[c]));
        whole &= mpz_cmp_ui(mpq_denref(x[c].at), 1) == 0;
    }
    printf("  %-14s", name);
    if (length <= READABLE) {
        for (int c = 0; c < dim; c++)
            printf("%s%s", c == 0 ? "(" : ", ", to_string_q(x[c]));
        printf("%s", whole ? ")" : ")  = ");
    }
    for (int c = 0; c < dim && !(whole && length <= READABLE); c++)
        printf("%s%.15g%s", c == 0 ? "(" : ", ", to_double_q(x[c]), c == dim - 1 ? ")" : "");
    puts("");
}

/* Derivatives, curvature and torsion at t, into `values` or printed. */
static int evaluate(const struct arguments *a, const struct curve *c, num_q t, json_t *values)
{
    int mu = (a->left ? find_span_left_q : find_span_q)(c->count, c->degree, c->knots, t), dim = c->dim;
    if (mu < 0)
        return complain(a, "there is no point outside the domain, at", t);
    if (c->weights != NULL && cagd_is_zero_q(nurbs_weight_q(c->degree, c->knots, mu, c->weights, t)))
        return complain(a, "the total weight is 0, and so there is no point, at", t);
    int rows = a->derivatives > 3 ? a->derivatives + 1 : 4;
    num_q *D = numbers(rows * dim);
    if (c->weights != NULL)
        nurbs_derivatives_q(c->degree, dim, c->knots, mu, c->points, c->weights, t, rows - 1, D);
    else
        bspline_derivatives_q(c->degree, dim, c->knots, mu, c->points, t, rows, D);
    int regular = dim > 1 && !cagd_is_zero_q(norm_squared_q(dim, D + dim));
    int turns = dim == 3 && !cagd_is_zero_q(gram_q(3, D + 3, D + 6));
    json_t *value = json_pack("{s:o}", "t", number_json(t));
    if (values == NULL)
        printf("at t = %s%s\n", to_string_q(t), a->left ? ", from the left" : "");
    json_t *exact = json_array(), *rounded = json_array();
    for (int k = 0; k <= a->derivatives; k++) {
        char name[32];
        snprintf(name, sizeof name, k == 0 ? "point" : "derivative %d", k);
        json_array_append_new(exact, vector_json(dim, D + k * dim, 0));
        json_array_append_new(rounded, vector_json(dim, D + k * dim, 1));
        if (values == NULL)
            print_vector(name, dim, D + k * dim);
    }
    json_object_set_new(value, "derivatives", exact);
    json_object_set_new(value, "rounded", rounded);
    if (regular) {
        num_q squared = curvature_squared_q(dim, D + dim, D + 2 * dim);
        json_object_set_new(value, "curvature_squared", number_json(squared));
        if (values == NULL)
            printf("  curvature     %.15g\n", sqrt(to_double_q(squared)));
    }
    if (turns) {
        num_q torsion = torsion_q(D + 3, D + 6, D + 9);
        json_object_set_new(value, "torsion", number_json(torsion));
        if (values == NULL)
            print_vector("torsion", 1, &torsion);
    }
    if (values != NULL)
        json_array_append(values, value);
    json_decref(value);
    return EXIT_AS_EXPECTED;
}

/* ---- what the curve is ------------------------------------------------------------------------ */

/* Whether the total weight vanishes somewhere in the domain; decided on every span. */
static int has_poles(const struct curve *c)
{
    if (c->weights == NULL)
        return 0;
    for (int mu = c->degree; mu < c->count; mu++) {
        num_q b[MAX_DEGREE + 1];
        if (!before_q(c->knots[mu], c->knots[mu + 1]))
            continue;
        bspline_to_bezier_q(c->degree, 1, c->knots, mu, c->weights, b);
        enum cagd_sign_pattern s =
            cagd_sign_on(poly_from_bernstein(c->degree, b), from_int_q(0), from_int_q(1), CLOSED);
        if (s != SIGN_POSITIVE && s != SIGN_NEGATIVE)
            return 1;
    }
    return 0;
}

static void describe(const struct curve *c)
{
    static const char *const where[] = {"", "on a line", "in the plane", "in space"};
    int n = c->count, p = c->degree, segments = 0, first = 1;
    for (int mu = p; mu < n; mu++)
        segments += before_q(c->knots[mu], c->knots[mu + 1]);
    printf("%s curve of degree %d (order %d) %s\n", c->weights != NULL ? "NURBS" : "B-spline", p, p + 1, where[c->dim]);
    printf("  points      %d\n", n);
    printf("  domain      [%s, %s], %d segment%s\n", to_string_q(c->knots[p]), to_string_q(c->knots[n]), segments,
           segments == 1 ? "" : "s");
    fputs("  knots      ", stdout);
    for (int i = 0, times = 1; i <= n + p; i++, times++) {
        if (i < n + p && cagd_equal_q(c->knots[i], c->knots[i + 1]))
            continue;
        printf("%s %s", first ? "" : ",", to_string_q(c->knots[i]));
        if (times > 1)
            printf(" (%d times)", times);
        times = 0;
        first = 0;
    }
    puts("");
    int clamped = cagd_equal_q(c->knots[0], c->knots[p]), clamped_end = cagd_equal_q(c->knots[n], c->knots[n + p]);
    printf("  ends        %s\n", clamped && clamped_end ? "clamped"
                                 : clamped              ? "clamped at the start"
                                 : clamped_end          ? "clamped at the end"
                                                        : "not clamped");
    if (c->weights != NULL) {
        int negative = 0, zero = 0;
        for (int i = 0; i < n; i++) {
            negative += cagd_sign_q(c->weights[i]) < 0;
            zero += cagd_is_zero_q(c->weights[i]);
        }
        printf("  weights     ");
        if (negative == 0 && zero == 0)
            puts("positive");
        else
            printf("%d positive, %d zero, %d negative; the total weight %s\n", n - negative - zero, zero, negative,
                   has_poles(c) ? "vanishes somewhere in the domain" : "vanishes nowhere in the domain");
    }
}

/* ---- changed curves --------------------------------------------------------------------------- */

/* The points in homogeneous coordinates where there are weights, else as they are; *dim is their dimension. */
static num_q *homogeneous(const struct curve *c, int *dim)
{
    *dim = c->dim + (c->weights != NULL);
    if (c->weights == NULL)
        return c->points;
    num_q *H = numbers(c->count * *dim);
    rational_homogenize_q(c->count - 1, c->dim, c->points, c->weights, H);
    return H;
}

/* The curve of the points H over the knots v.  -1 and a line on stderr when a weight is 0. */
static int curve_of(const struct arguments *a, const struct curve *model, int degree, int count, num_q v[], num_q H[],
                    struct curve *out)
{
    *out = (struct curve){degree, count, model->dim, v, H, NULL};
    if (model->weights == NULL)
        return 0;
    for (int i = 0; i < count; i++)
        if (cagd_is_zero_q(H[i * (model->dim + 1) + model->dim])) {
            fprintf(stderr, "cagd: %s: point %d of the result would have the weight 0\n", a->path, i);
            return -1;
        }
    out->points = numbers(count * model->dim);
    out->weights = numbers(count);
    rational_dehomogenize_q(count - 1, model->dim, H, out->points, out->weights);
    return 0;
}

static int insert(const struct arguments *a, const struct curve *c, num_q x, struct curve *out)
{
    int n = c->count, p = c->degree, dim, mu = find_span_q(n, p, c->knots, x);
    if (mu < 0 || cagd_equal_q(x, c->knots[n]))
        return complain(a, "a knot can be inserted from the start of the domain to before its end, not at", x);
    if (multiplicity_q(n + p + 1, c->knots, x) > p)
        return complain(a, "there are as many knots as the degree allows at", x);
    num_q *H = homogeneous(c, &dim), *v = numbers(n + p + 2), *d = numbers((n + 1) * dim);
    bspline_insert_q(n, p, dim, c->knots, mu, H, x, v, d);
    return curve_of(a, c, p, n + 1, v, d, out) == 0 ? EXIT_AS_EXPECTED : EXIT_USAGE;
}

static int without(const struct arguments *a, const struct curve *c, num_q x, struct curve *out)
{
    int n = c->count, p = c->degree, dim, times = multiplicity_q(n + p + 1, c->knots, x);
    if (times == 0 || !before_q(c->knots[p], x) || !before_q(x, c->knots[n]))
        return complain(a, "there is no inner knot", x);
    num_q *H = homogeneous(c, &dim), *v = numbers(n + p), *b = numbers((n - 1) * dim), defect[MAX_DIM];
    bspline_remove_q(n, p, dim, c->knots, H, find_span_q(n, p, c->knots, x), times, v, b, defect);
    for (int k = 0; k < dim; k++)
        if (!cagd_is_zero_q(defect[k])) {
            complain(a, "the curve would change without the knot", x);
            return EXIT_NOT_AS_EXPECTED;
        }
    return curve_of(a, c, p, n - 1, v, b, out) == 0 ? EXIT_AS_EXPECTED : EXIT_USAGE;
}

static int elevate(const struct arguments *a, const struct curve *c, struct curve *out)
{
    int n = c->count, p = c->degree, dim;
    if (p == MAX_DEGREE)
        return complain(a, "the degree is at most", from_int_q(MAX_DEGREE));
    int m = raised_knots_q(n, p, c->knots, NULL), *span = region_bytes((size_t)m * sizeof *span);
    num_q *H = homogeneous(c, &dim), *v = numbers(m + p + 2), *d = numbers(m * dim);
    raised_knots_q(n, p, c->knots, v);
    spans_of_points_q(n, p, c->knots, m, p + 1, v, span);
    bspline_elevate_q(p, dim, c->knots, H, m, v, span, d);
    return curve_of(a, c, p + 1, m, v, d, out) == 0 ? EXIT_AS_EXPECTED : EXIT_USAGE;
}

/* Possible if and only if every segment is of the lower degree; its continuity at the knots is then what the lowered
 * multiplicities ask for. */
static int reduce(const struct arguments *a, const struct curve *c, struct curve *out)
{
    int n = c->count, p = c->degree, dim;
    if (p == 0)
        return complain(a, "the degree is already", from_int_q(0));
    num_q *H = homogeneous(c, &dim), b[(MAX_DEGREE + 1) * MAX_DIM], lower[(MAX_DEGREE + 1) * MAX_DIM], defect[MAX_DIM];
    for (int mu = p; mu < n; mu++) {
        if (!before_q(c->knots[mu], c->knots[mu + 1]))
            continue;
        bspline_to_bezier_q(p, dim, c->knots, mu, H, b);
        bezier_reduce_q(p, dim, b, lower, defect);
        for (int k = 0; k < dim; k++)
            if (!cagd_is_zero_q(defect[k])) {
                complain(a, "the curve would change: it is not of lower degree on the segment from", c->knots[mu]);
                return EXIT_NOT_AS_EXPECTED;
            }
    }
    int m = lowered_knots_q(n, p, c->knots, NULL), *span = region_bytes((size_t)m * sizeof *span);
    num_q *v = numbers(m + p), *d = numbers(m * dim);
    lowered_knots_q(n, p, c->knots, v);
    spans_of_points_q(n, p, c->knots, m, p - 1, v, span);
    bspline_reduce_q(p, dim, c->knots, H, m, v, span, d);
    return curve_of(a, c, p - 1, m, v, d, out) == 0 ? EXIT_AS_EXPECTED : EXIT_USAGE;
}

static int split(const struct arguments *a, const struct curve *c, num_q t, struct curve *left, struct curve *right)
{
    int n = c->count, p = c->degree, dim, mu = find_span_q(n, p, c->knots, t);
    if (mu < 0 || !before_q(c->knots[p], t) || cagd_equal_q(t, c->knots[n]))
        return complain(a, "a curve is split inside its domain, not at", t);
    int times = multiplicity_q(n + p + 1, c->knots, t), lefts = mu - times + 1, rights = n - mu + p;
    num_q *H = homogeneous(c, &dim), *u = numbers(lefts + p + 1), *v = numbers(rights + p + 1);
    num_q *L = numbers(lefts * dim), *R = numbers(rights * dim);
    bspline_split_q(n, p, dim, c->knots, mu, times, H, t, u, L, v, R);
    return curve_of(a, c, p, lefts, u, L, left) == 0 && curve_of(a, c, p, rights, v, R, right) == 0 ? EXIT_AS_EXPECTED
                                                                                                    : EXIT_USAGE;
}

/* One Bézier curve a segment, over its own interval [u_mu, u_{mu+1}]. */
static int beziers(const struct arguments *a, const struct curve *c, json_t *list)
{
    int p = c->degree, dim;
    num_q *H = homogeneous(c, &dim);
    for (int mu = p; mu < c->count; mu++) {
        if (!before_q(c->knots[mu], c->knots[mu + 1]))
            continue;
        num_q *b = numbers((p + 1) * dim), *v = numbers(2 * p + 2);
        struct curve segment;
        bspline_to_bezier_q(p, dim, c->knots, mu, H, b);
        for (int i = 0; i < 2 * p + 2; i++)
            v[i] = c->knots[i <= p ? mu : mu + 1];
        if (curve_of(a, c, p, p + 1, v, b, &segment) != 0)
            return EXIT_USAGE;
        json_array_append_new(list, curve_json(&segment));
    }
    return EXIT_AS_EXPECTED;
}

/* ---- the command ------------------------------------------------------------------------------ */

/* The changed curves, as a list of JSON. */
static int change(const struct arguments *a, const struct curve *c, json_t *list)
{
    struct curve now = *c, next, right;
    int code = EXIT_AS_EXPECTED;
    switch (a->action) {
    case INSERT:
    case REMOVE:
        for (int k = 0; k < a->knots && code == EXIT_AS_EXPECTED; k++) {
            code = (a->action == INSERT ? insert : without)(a, &now, a->knot[k], &next);
            now = next;
        }
        break;
    case ELEVATE:
        code = elevate(a, c, &now);
        break;
    case REDUCE:
        code = reduce(a, c, &now);
        break;
    case SPLIT:
        code = split(a, c, a->knot[0], &now, &right);
        break;
    case BEZIER:
        return beziers(a, c, list);
    case DESCRIBE:
        break;
    }
    if (code != EXIT_AS_EXPECTED)
        return code;
    json_array_append_new(list, curve_json(&now));
    if (a->action == SPLIT)
        json_array_append_new(list, curve_json(&right));
    return code;
}

static int compute(const struct arguments *a)
{
    struct curve c;
    if (read_curve(a->path, &c) != 0)
        return EXIT_USAGE;
    if (a->action != DESCRIBE) {
        json_t *list = json_array();
        int code = change(a, &c, list);
        if (code != EXIT_AS_EXPECTED)
            json_decref(list);
        else if (json_array_size(list) == 1 && a->action != BEZIER) {
            print_json_exactly(json_incref(json_array_get(list, 0)));
            json_decref(list);
        } else
            print_json_exactly(list);
        return code;
    }
    json_t *values = a->asked.json ? json_array() : NULL;
    if (!a->asked.json && a->parameters == 0)
        describe(&c);
    for (int k = 0; k < a->parameters; k++) {
        int code = evaluate(a, &c, a->at[k], values);
        if (code != EXIT_AS_EXPECTED) {
            json_decref(values);
            return code;
        }
    }
    if (a->asked.json)
        print_json_exactly(json_pack("{s:s, s:o, s:b, s:o}", "schema", "cagd-curve-1", "curve", curve_json(&c),
                                     "positive_denominator", !has_poles(&c), "values", values));
    return EXIT_AS_EXPECTED;
}

static int run(const struct call *call)
{
    static struct arguments a;
    region_mark mark = region_open();
    parse_arguments(call, &a.asked);
    int code = compute(&a);
    region_drop(mark);
    cagd_thread_end();
    return code;
}

static const struct argp_option options[] = {
    {"at", 't', "T", 0, "The point at T, with curvature and torsion; may be repeated", 0},
    {"derivatives", 'd', "R", 0, "With --at, also the derivatives of orders 1 to R", 0},
    {"left", 'l', 0, 0, "With --at, at a knot the segment on the left (default: on the right)", 0},
    {"insert", 'i', "X", 0, "The same curve with the knot X more; may be repeated", 1},
    {"remove", 'r', "X", 0, "The same curve without one knot X, if there is one; may be repeated", 1},
    {"elevate", 'e', 0, 0, "The same curve, one degree higher", 1},
    {"reduce", 'u', 0, 0, "The same curve, one degree lower, if there is one", 1},
    {"split", 's', "T", 0, "The parts of the curve on the left and on the right of T", 1},
    {"bezier", 'b', 0, 0, "The segments as Bézier curves", 1},
    {0}};

static const struct topic topics[] = {
    {"CURVES",
     "A curve is a JSON object with the fields \"kind\" (bezier, rational-bezier, bspline or nurbs), \"degree\" or "
     "\"order\", which is one more, \"points\", an array of arrays of 1 to 3 numbers, and where the kind asks for them "
     "\"weights\" and \"knots\" (points + degree + 1 of them). A number is a JSON number, taken as the binary64 that "
     "it "
     "denotes, or a string: \"3/7\", \"0.1\" (the decimal, exactly), \"0x1.8p-3\". The file - is standard input."},
    {0}};

const struct command command_curve = {
    .name = "curve",
    .summary = "a Bézier, B-spline or NURBS curve in exact arithmetic: points, knots, degree",
    .example = "  cagd curve circle.json --at 1/3  a point of a curve, exactly\n",
    .usage = "CURVE.json",
    .text =
        "Computes with a curve in exact arithmetic.\n\n"
        "Examples:\n"
        "  cagd curve circle.json\n"
        "  cagd curve circle.json --at 1/3 --derivatives 2\n"
        "  cagd curve circle.json --insert 1/2 >finer.json\n"
        "  cagd curve circle.json --elevate | cagd curve - --at 0.5\n"
        "\vA curve is {\"kind\": \"bezier\", \"rational-bezier\", \"bspline\" or \"nurbs\", \"degree\": p (or "
        "\"order\": p+1), \"points\": [[...], ...], \"weights\": [...], \"knots\": [...]}.  A number is a JSON number, "
        "taken as the binary64 it denotes, or a string: \"3/7\", \"0.1\", \"0x1.8p-3\".  Changed curves are printed in "
        "this format, too.  Exit status 1: the knot or the degree cannot be removed.",
    .arguments = FILE_NAME,
    .shared = TAKES_JSON,
    .options = options,
    .parse = parse,
    .topics = topics,
    .run = run,
};
