/* options.c -- what cagd fit is asked: its options, read and checked. */
#include "cli/commands.h"
#include "cli/fit/fit.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    KEY_DEGREE = 256,
    KEY_KNOTS,
    KEY_CONTROL_POINTS,
    KEY_FREE,
    KEY_ENDS,
    KEY_INITIAL,
    KEY_BETWEEN,
    KEY_LOSS,
    KEY_SCALE,
    KEY_UNORDERED,
    KEY_DIM,
    KEY_SIGMA_COLUMN,
    KEY_SIGMA,
    KEY_STARTS,
    KEY_SEED,
    KEY_TOLERANCE,
    KEY_ITERATIONS,
    KEY_NO_VERIFY,
    KEY_RESIDUALS,
    KEY_SVG,
    KEY_CURVE,
    KEY_CLOSED,
    KEY_OPEN,
    KEY_WITHIN,
    KEY_SMOOTH,
    KEY_MONOTONE,
    MOST_CONTROL_POINTS = 10000,
    MOST_ROUNDS = 1000000
};

static double positive(struct argp_state *state, const char *option, const char *text)
{
    double x = to_double_q(exact_number(state, option, text));
    if (!(x > 0) || !isfinite(x))
        refuse_call(state->name, "%s takes a number > 0, not '%s'", option, text);
    return x;
}

/* "weights,inner,ends", or "none". */
static int parts(struct argp_state *state, const char *text)
{
    static const char *const part[] = {"weights", "inner", "ends"};
    int sum = 0;
    if (strcmp(text, "none") == 0)
        return 0;
    for (const char *s = text;; s++) {
        size_t n = strcspn(s, ",");
        int k = 0;
        while (k < 3 && (strlen(part[k]) != n || strncmp(s, part[k], n) != 0))
            k++;
        if (k == 3)
            refuse_call(state->name, "--free takes a list of weights, inner and ends, or none, not '%s'", text);
        else
            sum |= 1 << k;
        if (*(s += n) == '\0')
            return sum;
    }
}

/* How free ends are fitted; exact ends are not free. */
static void read_ends(struct argp_state *state, const char *text, struct fit_arguments *a)
{
    a->exact_ends = strcmp(text, "exact") == 0;
    if (strcmp(text, "sliding") == 0)
        a->options.ends = CAGD_FIT_ENDS_SLIDE;
    else if (strcmp(text, "measured") == 0)
        a->options.ends = CAGD_FIT_ENDS_MEASURED;
    else if (!a->exact_ends)
        refuse_call(state->name, "--ends takes measured, exact or sliding, not '%s'", text);
    a->ends = text;
}

/* LOW:HIGH with 0 < LOW < 1 < HIGH. */
static void bounds(struct argp_state *state, const char *text, cagd_fit_options *o)
{
    const char *colon = strchr(text, ':');
    char *low = colon == NULL ? NULL : strndup(text, (size_t)(colon - text));
    if (low == NULL)
        refuse_call(state->name, "--weights-between takes LOW:HIGH, not '%s'", text);
    else {
        o->weight_low = positive(state, "--weights-between", low);
        o->weight_high = positive(state, "--weights-between", colon + 1);
        if (!(o->weight_low < 1 && 1 < o->weight_high))
            refuse_call(state->name,
                        "--weights-between takes LOW:HIGH with LOW < 1 < HIGH, not '%s': the first weight is 1", text);
    }
    free(low);
}

static cagd_fit_loss loss(struct argp_state *state, const char *text)
{
    static const char *const name[] = {"squares", "huber", "cauchy"};
    for (int k = 0; k < 3; k++)
        if (strcmp(text, name[k]) == 0)
            return (cagd_fit_loss)k;
    refuse_call(state->name, "--loss takes squares, huber or cauchy, not '%s'", text);
    return CAGD_FIT_SQUARES;
}

/* Increasing numbers between 0 and 1, separated by commas. */
static void read_knots(struct argp_state *state, struct fit_arguments *a)
{
    const char *s = a->knots;
    if (*s == '\0')
        return;
    for (;; s++) {
        size_t n = strcspn(s, ",");
        char *text = strndup(s, n);
        double *more = realloc(a->inner, (size_t)(a->inner_knots + 1) * sizeof *more);
        if (text == NULL || more == NULL)
            abort();
        a->inner = more;
        double u = more[a->inner_knots] = positive(state, "--knots", text);
        free(text);
        if (!(u < 1))
            refuse_call(state->name, "--knots takes inner knots between 0 and 1, not %.*s", (int)n, s);
        if (a->inner_knots > 0 && u < more[a->inner_knots - 1])
            refuse_call(state->name, "--knots takes increasing numbers: %.*s is smaller than the one before", (int)n,
                        s);
        if (a->inner_knots >= a->options.degree && u == more[a->inner_knots - a->options.degree])
            refuse_call(state->name, "--knots: %.*s stands more than %d times, which would break a curve of degree %d",
                        (int)n, s, a->options.degree, a->options.degree);
        a->inner_knots++;
        if (*(s += n) == '\0')
            break;
    }
    if (a->inner_knots > MOST_CONTROL_POINTS)
        refuse_call(state->name, "at most %d inner knots", MOST_CONTROL_POINTS);
}

/* What is left for the points to say.  Of a spline weights are fitted where a test says so, unless --free is given. */
static void choose(struct argp_state *state, struct fit_arguments *a)
{
    cagd_fit_options *o = &a->options;
    cagd_fit_choices *c = &a->choices;
    if (o->monotone && (o->unordered || o->loss != CAGD_FIT_SQUARES || (a->free_given && o->free == 0)))
        refuse_call(state->name,
                    "--monotone is for points in order, squares and a curve that is fitted; --unordered, --loss and "
                    "--free none do not go with it");
    const int smoothed = a->smooth || o->smooth > 0, counted = a->knots != NULL || o->count != 0;
    if (a->initial != NULL && (a->closed > 0 || a->automatic || a->within > 0 || smoothed))
        refuse_call(state->name,
                    "--closed, --control-points auto, --tolerance-distance and --smooth do not go with --initial");
    if (a->within > 0 && (counted || smoothed))
        refuse_call(state->name,
                    "--tolerance-distance chooses the control points; --control-points N, --knots and --smooth "
                    "do not go with it");
    if (a->closed > 0 && (a->ends != NULL || a->knots != NULL))
        refuse_call(state->name,
                    "a closed curve has no ends, and even knots; --ends and --knots do not go with --closed");
    if (smoothed && a->free_given && o->free & CAGD_FIT_WEIGHTS)
        refuse_call(state->name, "--smooth leaves weights out; --free weights does not go with it");
    if (smoothed && o->degree == 1)
        refuse_call(state->name, "--smooth needs a degree of 2 or more");
    *c = (cagd_fit_choices){.closed = a->closed,
                            .degree = a->degree_automatic,
                            .smooth = a->smooth                   ? 1
                                      : smoothed || a->free_given ? 0
                                                                  : 2,
                            .within = a->within};
    if (c->closed < 0 &&
        (a->ends != NULL || a->knots != NULL || a->initial != NULL || (a->free_given && o->free & CAGD_FIT_END_POINTS)))
        c->closed = 0;
    c->form = !o->monotone && !a->degree_given && !counted && !a->automatic && !(a->within > 0) && !smoothed &&
              !a->free_given && a->initial == NULL && o->weight_low == 0 && isinf(o->weight_high);
    const int monotone_spline = o->monotone && !a->degree_given && a->initial == NULL;
    c->count = !counted &&
               (c->form || monotone_spline || c->degree || a->automatic || a->within > 0 || smoothed || a->closed > 0);
    c->weights = !a->free_given;
    if (c->count && !c->form && !a->degree_given)
        o->degree = 3;
    const int spline = c->count ? !c->form : a->knots != NULL ? *a->knots != '\0' : o->count > o->degree + 1;
    if (!a->free_given && a->initial == NULL && (spline || c->degree || smoothed || a->closed > 0))
        o->free &= ~CAGD_FIT_WEIGHTS;
}

static void finish(struct argp_state *state, struct fit_arguments *a)
{
    cagd_fit_options *o = &a->options;
    if (a->initial != NULL && (a->degree_given || a->knots != NULL || o->count != 0))
        refuse_call(state->name,
                    "--initial gives degree and knots; --degree, --knots and --control-points do not go with it");
    if (a->knots != NULL && o->count != 0)
        refuse_call(state->name,
                    "the knots give the number of control points; --control-points does not go with --knots");
    if (o->count != 0 && o->count < o->degree + 1)
        refuse_call(state->name, "--control-points %d: a curve of degree %d has at least %d", o->count, o->degree,
                    o->degree + 1);
    if (a->degree_automatic && a->knots != NULL)
        refuse_call(state->name, "the knots are those of a degree; --degree auto does not go with --knots");
    if (a->ends != NULL && a->free_given && a->exact_ends == (o->free & CAGD_FIT_END_POINTS) / CAGD_FIT_END_POINTS)
        refuse_call(state->name, "--ends %s does not go with --free %s", a->ends,
                    a->exact_ends ? "that has ends" : "without ends, which are then exact or those of --initial");
    choose(state, a);
    if (a->exact_ends)
        o->free &= ~CAGD_FIT_END_POINTS;
    if (a->initial == NULL && o->free == 0)
        refuse_call(state->name, "--free none takes the distances from a given curve, and needs --initial CURVE.json");
    if (a->initial == NULL && !(o->free & CAGD_FIT_INNER_POINTS) && o->degree > 1)
        refuse_call(state->name, "without --initial the inner points are free: --free needs inner");
    if (o->loss == CAGD_FIT_SQUARES && o->loss_scale != 0)
        refuse_call(state->name, "--scale belongs to --loss huber or --loss cauchy");
    if (o->loss == CAGD_FIT_SQUARES)
        o->loss_scale = 1;
    if (a->sigma != 0 && a->columns.sigma != NULL)
        refuse_call(state->name, "--sigma and --sigma-column exclude one another");
    if (a->knots != NULL)
        read_knots(state, a);
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct fit_arguments *a = state->input;
    cagd_fit_options *o = &a->options;
    switch (key) {
    case KEY_DEGREE:
        a->degree_automatic = strcmp(arg, "auto") == 0;
        o->degree = a->degree_automatic ? 2 : whole_number(state, "--degree", arg, 1, CAGD_MAX_DEGREE);
        a->degree_given = 1;
        break;
    case KEY_KNOTS:
        a->knots = arg;
        break;
    case KEY_CONTROL_POINTS:
        a->automatic = strcmp(arg, "auto") == 0;
        o->count = a->automatic ? 0 : whole_number(state, "--control-points", arg, 2, MOST_CONTROL_POINTS);
        break;
    case KEY_FREE:
        o->free = parts(state, arg);
        a->free_given = 1;
        break;
    case KEY_ENDS:
        read_ends(state, arg, a);
        break;
    case KEY_INITIAL:
        a->initial = arg;
        break;
    case KEY_BETWEEN:
        bounds(state, arg, o);
        break;
    case KEY_LOSS:
        o->loss = loss(state, arg);
        break;
    case KEY_SCALE:
        o->loss_scale = positive(state, "--scale", arg);
        break;
    case KEY_CLOSED:
        a->closed = 1;
        break;
    case KEY_OPEN:
        a->closed = 0;
        break;
    case KEY_WITHIN:
        a->within = positive(state, "--tolerance-distance", arg);
        break;
    case KEY_SMOOTH:
        a->smooth = strcmp(arg, "auto") == 0;
        o->smooth = a->smooth ? 0 : positive(state, "--smooth", arg);
        break;
    case KEY_MONOTONE:
        o->monotone = 1;
        break;
    case KEY_UNORDERED:
        o->unordered = 1;
        break;
    case KEY_DIM:
        a->columns.dim = whole_number(state, "--dim", arg, 2, 3);
        break;
    case KEY_SIGMA_COLUMN:
        a->columns.sigma = arg;
        break;
    case KEY_SIGMA:
        a->sigma = positive(state, "--sigma", arg);
        break;
    case KEY_STARTS:
        o->starts = whole_number(state, "--starts", arg, 1, MOST_ROUNDS);
        break;
    case KEY_SEED:
        o->seed = (unsigned long)whole_number(state, "--seed", arg, 0, INT_MAX);
        break;
    case KEY_TOLERANCE:
        o->tolerance = positive(state, "--tolerance", arg);
        break;
    case KEY_ITERATIONS:
        o->max_iterations = whole_number(state, "--max-iterations", arg, 1, MOST_ROUNDS);
        break;
    case KEY_NO_VERIFY:
        a->verify = 0;
        break;
    case KEY_RESIDUALS:
        a->residuals = arg;
        break;
    case KEY_SVG:
        a->svg = arg;
        break;
    case KEY_CURVE:
        a->curve = arg;
        break;
    case 'v':
        a->verbose = 1;
        break;
    case ARGP_KEY_END:
        finish(state, a);
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

struct fit_arguments read_fit_arguments(const struct call *call)
{
    struct fit_arguments a = {.options = cagd_fit_defaults(), .verify = 1, .closed = -1};
    a.options.loss_scale = 0;
    parse_arguments(call, &a.asked);
    return a;
}

static const struct argp_option options[] = {
    {"degree", KEY_DEGREE, "P", 0,
     "Degree of the curve (default: 2, of a spline that is chosen 3); auto: the one of 2 to 5 that the points ask for",
     1},
    {"knots", KEY_KNOTS, "U,...", 0, "Inner knots between 0 and 1 (default: none, a Bézier curve)", 1},
    {"control-points", KEY_CONTROL_POINTS, "N", 0,
     "So many control points, over even knots, or where no good curve is found so over knots that the points place; "
     "auto: as many as the points ask for, with knots where these ask for them",
     1},
    {"tolerance-distance", KEY_WITHIN, "D", 0,
     "The fewest control points found that keep every point within this distance of the curve", 1},
    {"closed", KEY_CLOSED, 0, 0,
     "A closed curve, smooth everywhere (default: where the points come back to their beginning)", 1},
    {"open", KEY_OPEN, 0, 0, "An open curve, wherever the points end", 1},
    {"smooth", KEY_SMOOTH, "LAMBDA", 0,
     "Add LAMBDA/2 times the integral of the squared second derivative of a spline; auto: by cross-validation", 1},
    {"free", KEY_FREE, "LIST", 0,
     "What may move, of weights, inner and ends (default: all, but inner,ends of a curve of several segments; without "
     "ends these are the first and the last point, or "
     "those of --initial); none: only the distances from the curve of --initial",
     1},
    {"ends", KEY_ENDS, "HOW", 0,
     "measured: the first and the last point are measurements of the ends (default); exact: they are the ends; "
     "sliding: "
     "the curve is cut off somewhere beyond them",
     1},
    {"initial", KEY_INITIAL, "CURVE.json", 0, "Where to start; gives degree and knots, and what is not free", 1},
    {"weights-between", KEY_BETWEEN, "LOW:HIGH", 0, "Bounds on the weights", 1},
    {"loss", KEY_LOSS, "NAME", 0, "squares, huber or cauchy (default: squares)", 2},
    {"scale", KEY_SCALE, "A", 0,
     "Of the loss, in standard deviations where these are given (default: estimated from the median of the distances)",
     2},
    {"monotone", KEY_MONOTONE, 0, 0,
     "Feet in the order of the points: where one would fall back it is that of the point before, which keeps a curve "
     "with few points from going back and forth between them",
     2},
    {"unordered", KEY_UNORDERED, 0, 0, "The points come in no order", 2},
    {"dim", KEY_DIM, "D", 0, "So many coordinates, 2 or 3, where columns have no names", 3},
    {"sigma-column", KEY_SIGMA_COLUMN, "C", 0, "The column, by name or number, of standard deviations", 3},
    {"sigma", KEY_SIGMA, "S", 0, "One standard deviation for all coordinates", 3},
    {"starts", KEY_STARTS, "N", 0,
     "Start N times, with other weights (default: 1); takes N times as long; a terminal shows how many have ended", 4},
    {"seed", KEY_SEED, "N", 0, "Of the other starts (default: 1)", 4},
    {"tolerance", KEY_TOLERANCE, "E", 0, "Relative, of convergence (default: 1e-14)", 4},
    {"max-iterations", KEY_ITERATIONS, "N", 0, "At most N iterations (default: 200)", 4},
    {"no-verify", KEY_NO_VERIFY, 0, 0, "Do not verify the minimum in intervals", 4},
    {"verbose", 'v', 0, 0, "Print the iterations too", 5},
    {"curve", KEY_CURVE, "FILE", 0, "Write the curve, for cagd curve", 5},
    {"residuals", KEY_RESIDUALS, "FILE", 0, "Write foot points, residuals and distances as CSV", 5},
    {"svg", KEY_SVG, "FILE", 0, "Write a picture", 5},
    {0}};

static const struct option_words words[] = {{"loss", "squares huber cauchy"},
                                            {"free", "weights inner ends weights,inner weights,inner,ends none"},
                                            {"ends", "measured exact sliding"},
                                            {0}};

static const struct topic topics[] = {
    {"FITTED CURVES",
     "cagd fit finds the curve that comes closest to measured points: the least sum of squared orthogonal distances, "
     "or of "
     "a robust loss of them. The foot points are unknowns of their own. Without options the points say which curve it "
     "is: "
     "a conic in one segment where its distances are noise, otherwise an ellipse or circle, whole or an arc of any "
     "length, or a cubic spline whose control points and knots are chosen; what was tried is told under Chosen. Where "
     "the "
     "points come back to their beginning the curve is closed and smooth there, unless they have a corner there; a "
     "last "
     "point that repeats the first one is left out; --open and --closed decide otherwise. --degree alone asks for a "
     "Bézier curve, --control-points N for a spline over even knots, --control-points auto and --tolerance-distance "
     "for "
     "one whose knots are chosen, --degree auto also for the degree. The weights of a spline are 1 unless a test says "
     "that they explain something. A "
     "spline that does not converge, or has excursions that no points show, is given knots that the points place, and "
     "smoothed where these do not help, which is told; --smooth does "
     "so always. With --monotone the feet follow the order of the points: where one would fall back it is shared with "
     "the point before, whose distance then counts along the curve as well; intervals are not sought then. Of weights, "
     "inner points and end points those in --free move, and with none only the distances from "
     "the curve of --initial are told. The first and the last point are measurements of the ends of the curve, with "
     "errors as the others have: their distances count along the curve as well. With --ends exact, or without ends in "
     "--free, the curve begins and ends in these two points as they are, and no interval knows of their errors; with "
     "--ends sliding it is cut off somewhere beyond them, and weights and ends are not determined. Printed are the "
     "estimates with standard errors and 95 % intervals, what the points leave undetermined, the distances, whether "
     "something speaks against the fit, and what of other options, which are tried then, cures it, which conic a curve "
     "of degree 2 is, and whether the minimum "
     "was verified in interval arithmetic. --json prints all that, the covariance and the iterations; --curve writes "
     "the curve for cagd curve; --residuals writes a table with a row for each point: row, line, coordinates, t, foot, "
     "residual, distance (in the plane positive on the left of the curve), distance over standard deviation; --svg "
     "draws."},
    {"POINTS",
     "A point stands on a line of its own: coordinates, and perhaps a standard deviation of each of them. The "
     "fields are separated by semicolons, tabs, commas or blanks; a decimal comma is possible where commas do "
     "not separate, or in double quotes. Blank lines and lines that begin with # are passed over, as is a byte"
     " order mark of UTF-8; lines end with LF, CRLF or CR. A first line without any number names the columns: "
     "x, y, z and sigma (or s, sd, std, stddev), perhaps followed by a unit as in \"x [mm]\", or a pair of names that "
     "maps and surveys use, such as lon lat, easting northing, Ost Nord, Rechtswert Hochwert, 横坐标 纵坐标, with a "
     "height as z if --dim 3 asks for it. If x or y is not among the names, a column that is called a number or a name "
     "of "
     "the points (Nr, id, Punkt, 序号) is set aside, and the only two that are left beside sigma are x and y, as in "
     "\"x,z\" or \"t,x\". Columns that are not used are told. Without "
     "such names two columns are x y, four are x y z sigma, and three are"
     " x y z with --dim 3, x y sigma with --dim 2. A unit may stand behind every number, as in \"1.23 mm\". Other "
     "lines before the first row, such as the title of an airfoil"
     " or a count, are passed over; an airfoil in Lednicer's order, two counts and both sides from the nose, "
     "becomes one line. Points are also read from JSON (an array of arrays or of objects with x and y, an object "
     "with arrays x and y, GeoJSON), from a GPX track, whose degrees become metres in the plane, from a path, polyline "
     "or polygon in SVG, and from a polyline or points in DXF; of curved pieces only the ends are taken. Such a file "
     "has"
     " one line of points. What was read in another way than it stands there is told under Read. Nothing is guessed: a "
     "row"
     " that does not fit is named by its line, and the exit status is 2."},
    {"JSON OF A FIT",
     "The fields of the schema cagd-fit-1: \"converged\", of the minimiser; \"at_minimum\", which is false "
     "when it did not converge, and when it was verified that the curve is no minimum; \"points\" (file, "
     "count, dimension, sigma: column, one or unknown; format; notes: what was read otherwise than it stands there); "
     "\"options\"; \"origin\", from which the fit counts "
     "coordinates: measured ones less these are exact in binary64; \"minimiser\" (termination, message, "
     "iterations, costs, gradient, history); \"curve\", in the format of CURVES; \"unknowns\", each with name,"
     " kind, index, coordinate, value, from_origin (value without the rounding far from 0), standard_error, "
     "low, high, interval_by (standard error, profile or none), determined, at_bound; \"finer_than_points\": some "
     "standard error of a coordinate is less than"
     " the steps of binary64 at the points; \"rank\", \"free_directions\", \"covariance\" and \"correlations\""
     " by rows in the order of the unknowns, weights in logarithms; \"invariants\" w_j^2/(w_{j-1} w_{j+1}); "
     "\"conic\"; \"statistics\" (chi_squared, reduced_chi_squared, degrees_of_freedom, aic, bic, "
     "scale_squared, scaled_by, level, quantile; of a robust loss chi_squared is the sum of the losses, and "
     "there is no aic, bic and reduced_chi_squared); \"distances\"; \"outliers\" of a robust loss (points, lines, "
     "limit, in deviations, deviation, rms_of_others; left_out_at_ends, how many of the first and of the last points, "
     "and ends_judged, whether they were judged by a fit without them); \"length_ratio\", the length of the curve over "
     "that of the "
     "polygon of ordered points; \"points_on_curve\": these are no larger "
     "than roundings; \"ends_taken_as_exact\"; \"end_points\", the numbers of the points that are measurements of the "
     "ends; \"cusp\", the parameter of a place where the curve turns on a "
     "radius no larger than the distances; \"choice\" (points_are: open, repeated, around or corner; closed; "
     "control_points_chosen; tolerance_met; candidates, the chosen one first, with unknowns, converged, good, score "
     "and rms; "
     "weights_test; smoothing: lambda, by, effective_unknowns, roughness); \"ellipse\" (whole, circle, centre, radius "
     "of "
     "the closest circle, major and minor semi-axis, angle and sweep in degrees, f_ratio of the test against a "
     "circle), or "
     "null; \"circle\": of a conic in one segment that the points do not tell from an arc of a circle (centre, radius, "
     "sweep in degrees, rms, f_ratio, "
     "f_degrees_of_freedom and probability of the test against the conic), or "
     "null; \"quality\" (good, problems, structure_beneath: null, or digits, deviations or size, what all distances "
     "are beneath where they have "
     "structure that is no problem; crossings of the curve with itself and of the polygon of the points, "
     "widest_gap "
     "as a part of the length, same_side of pairs of neighbours and the probability of so many, how many points lie "
     "far_off; part, of the curve that passes its points by most, with points, from, to, "
     "excess and probability; tried: of a fit that is not good what else was asked for, with options, "
     "converged, problems and rms); \"verification\" "
     "(status: verified, not verified or not asked; "
     "\"leaving_bounds\": whether the cost grows when weights leave their bounds; with --free none also "
     "refuted, and \"excess\", by how much the foot of a point may be farther than the nearest point of the "
     "curve). Standard error, low and high of a weight are those of its logarithm, carried over. What is not "
     "known is null; of a curve that is no minimum standard errors, rank, covariance and probabilities are "
     "not."},
    {0}};

const struct command command_fit = {
    .name = "fit",
    .summary = "a rational curve fitted to measured points, with statistics and a picture",
    .example = "  cagd fit points.csv --degree 3   the rational cubic closest to measured points\n",
    .usage = "POINTS.csv",
    .text =
        "Fits a curve to measured points: the least sum of squared orthogonal distances.\n\n"
        "Examples:\n"
        "  cagd fit points.csv\n"
        "  cagd fit outline.csv --svg outline.svg\n"
        "  cagd fit section.csv --tolerance-distance 0.01 --curve section.json\n"
        "  cagd fit points.csv --degree 3 --svg points.svg --residuals residuals.csv\n"
        "  cagd fit points.csv --control-points 8 --degree 3 --loss huber\n"
        "  cagd fit points.csv --ends exact\n"
        "  cagd fit points.csv --initial arc.json --free weights --json\n"
        "  cagd fit points.csv --initial arc.json --free none --residuals distances.csv\n"
        "  cagd fit points.csv --curve arc.json && cagd curve arc.json --at 1/2\n\v"
        "A point a line: x y, x y z, and perhaps its standard deviation sigma, separated by commas, semicolons, tabs "
        "or blanks, with decimal points or, where commas do not separate, decimal commas.  A first line without "
        "numbers "
        "names the columns; three columns without names need --dim 2 (x y sigma) or --dim 3.  Lines that begin with # "
        "are comments, titles are passed over; also JSON, GeoJSON, GPX, a path of SVG or DXF; - is standard input.  "
        "Exit status 1: not converged, or to no minimum; with --free none, a foot "
        "that was verified not to be the nearest point.",
    .arguments = FILE_NAME,
    .file = "the points",
    .shared = TAKES_JSON,
    .options = options,
    .parse = parse,
    .words = words,
    .topics = topics,
    .run = run_fit,
};
