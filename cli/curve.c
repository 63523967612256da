/* curve.c -- cagd curve: computes with a curve in exact arithmetic. */
#include "chapters/judge/memory_text.h"
#include "cli/commands.h"
#include "cli/curve_json.h"
#include "cli/input.h"
#include "cli/refuse.h"
#include "cli/report.h"
#include "cli/waiting.h"
#include "core/number/limits.h"
#include "exact/words.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_PARAMETERS = 1000 };
enum action { DESCRIBE, INSERT, REMOVE, ELEVATE, REDUCE, SPLIT, BEZIER };

struct arguments {
    struct asked asked;
    num_q at[MOST_PARAMETERS], knot[MOST_PARAMETERS];
    int parameters, knots, derivatives, left, csv;
    const char *file; /* of more parameters; NULL: none */
    enum action action;
};

static void act(struct argp_state *state, struct arguments *a, enum action action)
{
    if (a->action != DESCRIBE && (a->action != action || action == SPLIT))
        refuse_call(
            state->name,
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
            refuse_call(state->name, "at most %d parameters and knots", MOST_PARAMETERS);
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
    case 'f':
        a->file = arg;
        break;
    case 'c':
        a->csv = 1;
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
    case ARGP_KEY_END:
        if (a->action != DESCRIBE && (a->parameters > 0 || a->file != NULL))
            refuse_call(state->name, "--at belongs to the curve as it is; the changed curve can be read again");
        if (a->parameters == 0 && a->file == NULL && (a->derivatives > 0 || a->left || a->csv))
            refuse_call(state->name, "%s is about the points of --at or --at-file, and none is given",
                        a->derivatives > 0 ? "--derivatives"
                        : a->left          ? "--left"
                                           : "--csv");
        if (a->csv && a->asked.json)
            refuse_call(state->name, "one format at a time: --csv or --json?");
        if (a->file != NULL && a->asked.path != NULL && strcmp(a->file, "-") == 0 && strcmp(a->asked.path, "-") == 0)
            refuse_call(state->name, "standard input has either the curve or the parameters");
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

/* ---- values at a parameter -------------------------------------------------------------------- */

static int complain(const struct arguments *a, const char *what, num_q t)
{
    refuse_line("%s: %s %s", name_of_input(a->asked.path), what, to_string_q(t));
    return EXIT_USAGE;
}

/* null where binary64 has no such number. */
static json_t *rounded_json(double x) { return isfinite(x) ? json_real(x) : json_null(); }

static json_t *vector_json(int dim, const num_q x[], int rounded)
{
    json_t *array = json_array();
    for (int c = 0; c < dim; c++)
        json_array_append_new(array, rounded ? rounded_json(to_double_q(x[c])) : number_json(x[c]));
    return array;
}

/* "(1/3, 2)  = (0.333333333333333, 2)"; the exact values only where they are short enough to read. */
static void print_vector(FILE *out, const char *name, int dim, const num_q x[])
{
    enum { READABLE = 48 };
    size_t length = 0;
    int whole = 1;
    for (int c = 0; c < dim; c++) {
        length += strlen(to_string_q(x[c]));
        whole &= mpz_cmp_ui(mpq_denref(x[c].at), 1) == 0;
    }
    fprintf(out, "  %-14s", name);
    if (length <= READABLE) {
        for (int c = 0; c < dim; c++)
            fprintf(out, "%s%s", c == 0 ? "(" : ", ", to_string_q(x[c]));
        fprintf(out, "%s", whole ? ")" : ")  = ");
    }
    for (int c = 0; c < dim && !(whole && length <= READABLE); c++)
        fprintf(out, "%s%.15g%s", c == 0 ? "(" : ", ", to_double_q(x[c]), c == dim - 1 ? ")" : "");
    int beyond = 0;
    for (int c = 0; c < dim; c++)
        beyond |= !isfinite(to_double_q(x[c]));
    fputs(beyond && length > READABLE ? "  beyond binary64; --json has the digits" : "", out);
    fputc('\n', out);
}

/* What is known at t. */
struct values {
    num_q t, derivatives[(MAX_DEGREE + 1) * MAX_DIM], curvature_squared, torsion;
    int has_curvature, has_torsion;
    double curvature; /* rounded; in the plane with its sign, positive where the curve turns left */
};

/* Fills *v; an exit code, with a line on stderr unless it is EXIT_AS_EXPECTED. */
static int evaluate(const struct arguments *a, const cagd_spline_q *c, num_q t, struct values *v)
{
    cagd_side side = a->left ? CAGD_LEFT : CAGD_RIGHT;
    int turn;
    v->t = t;
    switch (cagd_spline_derivatives_q(c, t, side, a->derivatives, v->derivatives)) {
    case CAGD_OK:
        break;
    case CAGD_UNDEFINED:
        return complain(a, "the total weight is 0, and so there is no point, at", t);
    default:
        return complain(a, "there is no point outside the domain, at", t);
    }
    v->has_curvature = cagd_spline_curvature_squared_q(c, t, side, &v->curvature_squared) == CAGD_OK;
    v->has_torsion = cagd_spline_torsion_q(c, t, side, &v->torsion) == CAGD_OK;
    v->curvature = v->has_curvature ? sqrt(to_double_q(v->curvature_squared)) : NAN;
    if (v->has_curvature && cagd_spline_turn_q(c, t, side, &turn) == CAGD_OK && turn < 0)
        v->curvature = -v->curvature;
    return EXIT_AS_EXPECTED;
}

static void print_values(FILE *out, const struct arguments *a, int dim, const struct values *v)
{
    fprintf(out, "at t = %s%s\n", to_string_q(v->t), a->left ? ", from the left" : "");
    for (int k = 0; k <= a->derivatives; k++) {
        char name[32];
        snprintf(name, sizeof name, k == 0 ? "point" : "derivative %d", k);
        print_vector(out, name, dim, v->derivatives + k * dim);
    }
    if (v->has_curvature)
        fprintf(out, "  curvature     %.15g\n", v->curvature);
    if (v->has_torsion)
        print_vector(out, "torsion", 1, &v->torsion);
}

static json_t *values_json(const struct arguments *a, int dim, const struct values *v)
{
    json_t *exact = json_array(), *rounded = json_array();
    for (int k = 0; k <= a->derivatives; k++) {
        json_array_append_new(exact, vector_json(dim, v->derivatives + k * dim, 0));
        json_array_append_new(rounded, vector_json(dim, v->derivatives + k * dim, 1));
    }
    json_t *value = json_pack("{s:o, s:o, s:o}", "t", number_json(v->t), "derivatives", exact, "rounded", rounded);
    if (v->has_curvature) {
        json_object_set_new(value, "curvature", rounded_json(v->curvature));
        json_object_set_new(value, "curvature_squared", number_json(v->curvature_squared));
    }
    if (v->has_torsion)
        json_object_set_new(value, "torsion", number_json(v->torsion));
    return value;
}

/* The names of the columns: t,x,y, of the derivatives x_1,y_1, ..., curvature and torsion where the space has them. */
static void print_csv_names(FILE *out, const struct arguments *a, int dim)
{
    fputs("t", out);
    for (int k = 0; k <= a->derivatives; k++)
        for (int c = 0; c < dim; c++)
            fprintf(out, k == 0 ? ",%c" : ",%c_%d", "xyz"[c], k);
    fputs(dim == 1 ? "\n" : dim == 2 ? ",curvature\n" : ",curvature,torsion\n", out);
}

/* One row, rounded to binary64; empty where there is no such number. */
static void print_csv(FILE *out, const struct arguments *a, int dim, const struct values *v)
{
    fprintf(out, "%.17g", to_double_q(v->t));
    for (int m = 0; m < (a->derivatives + 1) * dim; m++) {
        double x = to_double_q(v->derivatives[m]);
        isfinite(x) ? fprintf(out, ",%.17g", x) : fprintf(out, ",");
    }
    if (dim > 1)
        isfinite(v->curvature) ? fprintf(out, ",%.17g", v->curvature) : fprintf(out, ",");
    if (dim > 2)
        v->has_torsion ? fprintf(out, ",%.17g", to_double_q(v->torsion)) : fprintf(out, ",");
    fputc('\n', out);
}

/* ---- at many parameters -------------------------------------------------------------------------------- */

/* The values at t, told as it is asked; an exit code. */
static int tell_at(const struct arguments *a, const cagd_spline_q *c, num_q t, json_t *values, FILE *out)
{
    static struct values v;
    int code = evaluate(a, c, t, &v);
    if (code != EXIT_AS_EXPECTED)
        return code;
    if (values != NULL)
        json_array_append_new(values, values_json(a, c->dim, &v));
    else if (a->csv)
        print_csv(out, a, c->dim, &v);
    else
        print_values(out, a, c->dim, &v);
    return EXIT_AS_EXPECTED;
}

/* At the parameters of the file: one a line; blank lines and those that begin with # are passed over. */
static int tell_at_file(const struct arguments *a, const cagd_spline_q *c, json_t *values, FILE *out)
{
    enum { LONGEST = 4096 };
    FILE *file = strcmp(a->file, "-") == 0 ? stdin : fopen(a->file, "r");
    char line[LONGEST];
    int number = 0, told = 0, code = EXIT_AS_EXPECTED;
    if (file == NULL) {
        refuse_line("%s: %s; expected a file of parameters, one a line", a->file, strerror(errno));
        return EXIT_USAGE;
    }
    while (code == EXIT_AS_EXPECTED && fgets(line, sizeof line, file) != NULL) {
        char *text = line + strspn(line, " \t\r\n");
        number++;
        text[strcspn(text, " \t\r\n")] = '\0';
        if (*text == '\0' || *text == '#')
            continue;
        region_mark mark = region_open();
        unsigned before = region_faults;
        waiting_at(told, told, "parameters");
        num_q t = from_string_q(text);
        if (region_faults != before) {
            region_faults = before;
            refuse_line("%s: line %d: expected a number such as 3/7, 0.1 or 0x1.8p-3, not '%.60s'",
                        name_of_input(a->file), number, text);
            code = EXIT_USAGE;
        } else {
            code = tell_at(a, c, t, values, out);
            told++;
        }
        region_drop(mark);
    }
    if (code == EXIT_AS_EXPECTED && ferror(file)) {
        refuse_line("%s: %s; expected a file of parameters, one a line", a->file, strerror(errno));
        code = EXIT_USAGE;
    }
    if (file != stdin)
        fclose(file);
    return code;
}

/* ---- what the curve is ------------------------------------------------------------------------ */

/* The knots, each with how often it stands there, and whether they clamp the ends. */
static void describe_knots(const cagd_spline_q *c, FILE *out)
{
    int n = c->count, p = c->degree, first = 1;
    fputs("  knots      ", out);
    for (int i = 0, times = 1; i <= n + p; i++, times++) {
        if (i < n + p && cagd_equal_q(c->knots[i], c->knots[i + 1]))
            continue;
        fprintf(out, "%s %s", first ? "" : ",", to_string_q(c->knots[i]));
        if (times > 1)
            fprintf(out, " (%d times)", times);
        times = 0;
        first = 0;
    }
    fputs("\n", out);
    int clamped = cagd_equal_q(c->knots[0], c->knots[p]), clamped_end = cagd_equal_q(c->knots[n], c->knots[n + p]);
    fprintf(out, "  ends        %s\n",
            clamped && clamped_end ? "clamped"
            : clamped              ? "clamped at the start"
            : clamped_end          ? "clamped at the end"
                                   : "not clamped");
}

static void describe_weights(const cagd_spline_q *c, FILE *out)
{
    int n = c->count, negative = 0, zero = 0;
    for (int i = 0; i < n; i++) {
        negative += cagd_sign_q(c->weights[i]) < 0;
        zero += cagd_is_zero_q(c->weights[i]);
    }
    fprintf(out, "  weights     ");
    if (negative == 0 && zero == 0)
        fputs("positive\n", out);
    else
        fprintf(out, "%d positive, %d zero, %d negative; the total weight %s\n", n - negative - zero, zero, negative,
                cagd_spline_has_poles_q(c) ? "vanishes somewhere in the domain" : "vanishes nowhere in the domain");
}

/* A Bézier curve is told without its knots, which say nothing. */
static void describe(const cagd_spline_q *c, FILE *out)
{
    static const char *const where[] = {"", "on a line", "in the plane", "in space"};
    static const char *const kinds[] = {"B-spline", "NURBS", "Bézier", "rational Bézier"};
    int n = c->count, p = c->degree, segments = 0, bezier = is_bezier(c);
    for (int mu = p; mu < n; mu++)
        segments += cagd_compare_q(c->knots[mu], c->knots[mu + 1]) < 0;
    fprintf(out, "%s curve of degree %d (order %d) %s\n", kinds[2 * bezier + (c->weights != NULL)], p, p + 1,
            where[c->dim]);
    fprintf(out, "  points      %d\n", n);
    fprintf(out, "  domain      [%s, %s], %d segment%s\n", to_string_q(c->knots[p]), to_string_q(c->knots[n]), segments,
            segments == 1 ? "" : "s");
    if (!bezier)
        describe_knots(c, out);
    if (c->weights != NULL)
        describe_weights(c, out);
}

/* ---- changed curves --------------------------------------------------------------------------- */

/* The exit code of an operation, with a line on stderr unless it was done: where there is no such curve, `otherwise` and the
 * number say why. */
static int exit_code_of(const struct arguments *a, cagd_status status, int where, const char *otherwise, num_q x)
{
    switch (status) {
    case CAGD_OK:
        return EXIT_AS_EXPECTED;
    case CAGD_UNDEFINED:
        refuse_line("%s: point %d of the result would have the weight 0", a->asked.path, where);
        return EXIT_USAGE;
    case CAGD_NO_MEMORY:
        refuse_line("%s: %s", a->asked.path, cagd_status_text(CAGD_NO_MEMORY));
        return EXIT_INTERNAL;
    default:
        return complain(a, otherwise, x);
    }
}

/* The curve would become another one: no mistake of the user's, but not what was asked for. */
static int would_change(const struct arguments *a, const char *what, num_q x)
{
    complain(a, what, x);
    return EXIT_NOT_AS_EXPECTED;
}

static int insert(const struct arguments *a, const cagd_spline_q *c, num_q x, cagd_spline_q *out)
{
    int where;
    cagd_status status = cagd_spline_insert_q(c, x, out, &where);
    return exit_code_of(a, status, where,
                        status == CAGD_KNOTS_MULTIPLE
                            ? "there are as many knots as the degree allows at"
                            : "a knot can be inserted from the start of the domain to before its end, not at",
                        x);
}

static int without(const struct arguments *a, const cagd_spline_q *c, num_q x, cagd_spline_q *out)
{
    int where;
    cagd_status status = cagd_spline_remove_q(c, x, out, &where);
    if (status == CAGD_CHANGES)
        return would_change(a, "the curve would change without the knot", x);
    return exit_code_of(a, status, where, "there is no inner knot", x);
}

static int elevate(const struct arguments *a, const cagd_spline_q *c, cagd_spline_q *out)
{
    int where;
    cagd_status status = cagd_spline_elevate_q(c, out, &where);
    return exit_code_of(a, status, where, "the degree is at most", from_int_q(MAX_DEGREE));
}

static int reduce(const struct arguments *a, const cagd_spline_q *c, cagd_spline_q *out)
{
    int where;
    cagd_status status = cagd_spline_reduce_q(c, out, &where);
    if (status == CAGD_CHANGES)
        return would_change(a, "the curve would change: it is not of lower degree on the segment from",
                            c->knots[where]);
    return exit_code_of(a, status, where, "the degree is already", from_int_q(0));
}

static int split(const struct arguments *a, const cagd_spline_q *c, num_q t, cagd_spline_q *left, cagd_spline_q *right)
{
    int where;
    cagd_status status = cagd_spline_split_q(c, t, left, right, &where);
    return exit_code_of(a, status, where, "a curve is split inside its domain, not at", t);
}

/* One Bézier curve a segment, over its own interval [u_mu, u_{mu+1}]. */
static int beziers(const struct arguments *a, const cagd_spline_q *c, json_t *list)
{
    for (int mu = c->degree; mu < c->count; mu++) {
        cagd_spline_q segment;
        int where;
        region_mark mark = region_open();
        waiting_at(mu - c->degree, c->count - c->degree, "segments");
        cagd_status status = cagd_spline_segment_q(c, mu, &segment, &where);
        if (status == CAGD_OK) /* otherwise there is no segment, between equal knots */
            json_array_append_new(list, curve_json(&segment));
        region_drop(mark);
        if (status == CAGD_UNDEFINED || status == CAGD_NO_MEMORY)
            return exit_code_of(a, status, where, "", from_int_q(0));
    }
    return EXIT_AS_EXPECTED;
}

/* ---- the command ------------------------------------------------------------------------------ */

/* The changed curves, as a list of JSON. */
static int change(const struct arguments *a, const cagd_spline_q *c, json_t *list)
{
    cagd_spline_q now = *c, next, right;
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
    cagd_spline_q c;
    struct input_error error;
    char what[32];
    if (read_curve(a->asked.path, &c, &error) != 0) {
        report_input_error(a->asked.path, &error);
        return EXIT_USAGE;
    }
    snprintf(what, sizeof what, "curve of degree %d", c.degree);
    waiting_begin(what);
    if (a->action != DESCRIBE) {
        json_t *list = json_array();
        int code = change(a, &c, list);
        waiting_end();
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
    int code = EXIT_AS_EXPECTED;
    char *text = NULL; /* all or nothing is printed */
    size_t room;
    FILE *out = text_open(&text, &room);
    if (!a->asked.json && a->parameters == 0 && a->file == NULL)
        describe(&c, out);
    if (a->csv)
        print_csv_names(out, a, c.dim);
    for (int k = 0; k < a->parameters && code == EXIT_AS_EXPECTED; k++)
        code = tell_at(a, &c, a->at[k], values, out);
    if (a->file != NULL && code == EXIT_AS_EXPECTED)
        code = tell_at_file(a, &c, values, out);
    text_close(out, &text);
    int has_poles = code == EXIT_AS_EXPECTED && a->asked.json && cagd_spline_has_poles_q(&c);
    waiting_end();
    if (code == EXIT_AS_EXPECTED)
        fputs(text, stdout);
    free(text);
    if (code != EXIT_AS_EXPECTED)
        json_decref(values);
    else if (a->asked.json)
        print_json_exactly(json_pack("{s:s, s:o, s:b, s:o}", "schema", "cagd-curve-1", "curve", curve_json(&c),
                                     "positive_denominator", !has_poles, "values", values));
    return code;
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
    {"at-file", 'f', "NUMBERS.txt", 0, "The points at all parameters of a file, one a line", 0},
    {"csv", 'c', 0, 0, "With --at or --at-file, a table: t, coordinates, derivatives, curvature, torsion, rounded", 0},
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
        "  cagd curve circle.json --at-file parameters.txt --csv >points.csv\n"
        "  cagd curve circle.json --insert 1/2 >finer.json\n"
        "  cagd curve circle.json --elevate | cagd curve - --at 0.5\n"
        "\vA curve is {\"kind\": \"bezier\", \"rational-bezier\", \"bspline\" or \"nurbs\", \"degree\": p (or "
        "\"order\": p+1), \"points\": [[...], ...], \"weights\": [...], \"knots\": [...]}.  A number is a JSON number, "
        "taken as the binary64 it denotes, or a string: \"3/7\", \"0.1\", \"0x1.8p-3\".  Changed curves are printed in "
        "this format, too.  In the plane the curvature is positive where the curve turns left.  Limits: degree 64, "
        "100000 "
        "points.  A curve of degree 30 with 1000 points takes seconds; the time grows with the number of points and "
        "the "
        "third power of the degree, and on a terminal it is said, from two seconds on, how far it is.  Exit status 1: "
        "the knot or the degree cannot be "
        "removed.",
    .arguments = FILE_NAME,
    .file = "a curve",
    .shared = TAKES_JSON,
    .options = options,
    .parse = parse,
    .topics = topics,
    .run = run,
};
