/* value.c -- the table of values, and what they are made of; see value.h. */
#include "exact/code/value.h"

#include "exact/code/orders.h"

#include "exact/record/trace.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

struct cagd_code_machine cagd_code_machine;
const struct cagd_code_place *cagd_code_at;

/* ---- the end of a run, and what the parent reads ---------------------------------------------------------- */

void *cagd_code_room(size_t bytes)
{
    struct cagd_code_machine *m = &cagd_code_machine;
    bytes = (bytes + 15) & ~(size_t)15;
    if (bytes > (size_t)(m->end_of_room - m->free_room))
        cagd_code_stop(CAGD_CODE_BOUND, "more is told than there is room for");
    void *room = m->free_room;
    m->free_room += bytes;
    return room;
}

const char *cagd_code_keep(const char *text)
{
    size_t size = strlen(text) + 1;
    return memcpy(cagd_code_room(size), text, size);
}

_Noreturn void cagd_code_stop(enum cagd_code_end end, const char *format, ...)
{
    struct cagd_code_outcome *o = cagd_code_machine.outcome;
    va_list list;
    va_start(list, format);
    vsnprintf(o->message, sizeof o->message, format, list);
    va_end(list);
    if (cagd_code_at != NULL) {
        snprintf(o->file, sizeof o->file, "%s", cagd_code_at->file);
        snprintf(o->function, sizeof o->function, "%s", cagd_code_at->function);
        o->line = cagd_code_at->line;
    }
    o->end = end;
    fflush(NULL);
    _exit(0);
}

void cagd_code_check_faults(void)
{
    unsigned faults = cagd_region_faults;
    if (faults == 0)
        return;
    if (faults & CAGD_FAULT_MEMORY)
        cagd_code_stop(CAGD_CODE_BOUND, "no memory for a number");
    if (faults & CAGD_FAULT_CROWDED)
        cagd_code_stop(CAGD_CODE_BOUND, "more than %d variables and roots", CAGD_FIELD_MAX_VARIABLES);
    if (faults & CAGD_FAULT_UNABLE)
        cagd_code_stop(CAGD_CODE_REFUSED, "an enclosure contains a point where the operation is not defined");
    cagd_code_stop(CAGD_CODE_UNDEFINED, "a division by zero");
}

/* Variables of the field that are no inputs, and where they are at the point. */
static struct {
    cagd_num_f variable;
    cagd_num_i place;
} enclosed[CAGD_FIELD_MAX_VARIABLES];
static int enclosed_count;

/* ---- a double and its value -------------------------------------------------------------------------- */

/* The high word of a double in the table; a float is one of its own, with an index of 21 bits. */
static const uint32_t TAG = 0x7FFCA5C9, SINGLE_TAG = 0x7FE00000, MOST_SINGLES = 0x200000;
static const uint64_t NEVER_MADE = 0xFFFFFFFFFFFFFFFF, NEVER_FILLED = 0xAAAAAAAAAAAAAAAA, MARGIN = 0xFEFEFEFEFEFEFEFE;
static cagd_code_value *table;
static double *singles;
static uint32_t used, used_singles, most;

static void *lazily(size_t bytes)
{
    void *at = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (at == MAP_FAILED)
        cagd_code_stop(CAGD_CODE_BOUND, "no memory for the table of numbers");
    return at;
}

void cagd_code_values_open(void)
{
    most = (uint32_t)cagd_code_machine.job->most_values;
    table = lazily(most * sizeof *table);
    singles = lazily(MOST_SINGLES * sizeof *singles);
    used = used_singles = 0;
}

struct cagd_code_mark cagd_code_values_mark(void)
{
    return (struct cagd_code_mark){used, used_singles, cagd_region_open()};
}

void cagd_code_values_back(struct cagd_code_mark *mark)
{
    cagd_region_drop(mark->region);
    *mark = (struct cagd_code_mark){mark->used, mark->used_singles, cagd_region_open()};
    used = mark->used;
    used_singles = mark->used_singles;
    cagd_region_faults = 0;
    cagd_code_at = NULL;
    enclosed_count = 0;
}

int cagd_code_is_one(uint64_t bits) { return bits >> 32 == TAG && (uint32_t)bits < used; }
int cagd_code_is_single(uint32_t bits) { return bits >= SINGLE_TAG && bits - SINGLE_TAG < used_singles; }

int cagd_code_was_computed(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits != NEVER_MADE && bits != NEVER_FILLED;
}

static void refuse_never_computed(uint64_t bits)
{
    if (bits == NEVER_MADE || bits == NEVER_FILLED)
        cagd_code_stop(CAGD_CODE_REFUSED, "a value that was never computed");
    if (bits == MARGIN)
        cagd_code_stop(CAGD_CODE_REFUSED, "a value from outside an array");
}

cagd_code_value cagd_code_constant(cagd_num_q q)
{
    cagd_code_value v = {.q = q};
    switch (cagd_code_machine.job->numbers) {
    case CAGD_CODE_ROUNDING:
        v.d = cagd_to_double_q(q);
        break;
    case CAGD_CODE_INTERVAL:
        v.i = cagd_from_rational_i(q);
        break;
    default:
        break;
    }
    return v;
}

cagd_code_value cagd_code_integer(long n) { return cagd_code_constant(cagd_from_int_q(n)); }
cagd_code_value cagd_code_special(double d) { return (cagd_code_value){.d = d, .special = 1}; }
cagd_code_value cagd_code_enclosed(cagd_num_i i) { return (cagd_code_value){.i = i}; }

cagd_code_value cagd_code_value_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    if (cagd_code_is_one(bits))
        return table[(uint32_t)bits];
    refuse_never_computed(bits);
    if (!isfinite(x))
        return cagd_code_special(x);
    if (x != 0 && bits << 1 >> 1 < (uint64_t)1 << 32)
        cagd_code_stop(CAGD_CODE_REFUSED, "the bits of an integer as a number");
    return cagd_code_constant(cagd_from_double_q(x));
}

/* Whether q is a binary64, not far from 1. */
static int is_binary64(cagd_num_q q)
{
    mpz_srcptr numerator = mpq_numref(q.at), denominator = mpq_denref(q.at);
    size_t bits = mpz_sizeinbase(denominator, 2);
    return mpz_sizeinbase(numerator, 2) <= 53 && bits <= 900 && mpz_scan1(denominator, 0) == bits - 1;
}

void cagd_code_bound_bits(cagd_num_q q)
{
    long most_bits = cagd_code_machine.job->most_bits;
    if ((long)(mpz_sizeinbase(mpq_numref(q.at), 2) + mpz_sizeinbase(mpq_denref(q.at), 2)) > most_bits)
        cagd_code_stop(CAGD_CODE_BOUND, "a number of more than %ld bits", most_bits);
}

double cagd_code_number(cagd_code_value v)
{
    if (v.special)
        return v.d;
    cagd_code_check_faults();
    if (v.q.at != NULL) {
        cagd_code_bound_bits(v.q);
        /* in a run with rounding the binary64 has to be the number, whatever happened before */
        if (v.f.at == NULL && is_binary64(v.q) && v.shares == 0 && v.made == 0) {
            double d = cagd_to_double_q(v.q);
            if (cagd_code_machine.job->numbers != CAGD_CODE_ROUNDING || d == v.d)
                return d;
        }
    }
    if (used == most)
        cagd_code_stop(CAGD_CODE_BOUND, "more than %ld numbers", cagd_code_machine.job->most_values);
    uint64_t bits = (uint64_t)TAG << 32 | used;
    double d;
    table[used++] = v;
    memcpy(&d, &bits, sizeof d);
    return d;
}

double cagd_code_widen(float a)
{
    uint32_t bits;
    memcpy(&bits, &a, sizeof bits);
    if (cagd_code_is_single(bits))
        return singles[bits - SINGLE_TAG];
    refuse_never_computed((uint64_t)bits << 32 | bits);
    return (double)a;
}

/* A run with rounding rounds; elsewhere a float is whatever the number is. */
float cagd_code_narrow(double a)
{
    uint64_t bits;
    memcpy(&bits, &a, sizeof bits);
    if (!cagd_code_is_one(bits) && (!isfinite(a) || (double)(float)a == a))
        return (float)a;
    if (cagd_code_machine.job->numbers == CAGD_CODE_ROUNDING) {
        cagd_code_value v = cagd_code_value_of(a);
        double rounded = (double)(float)v.d, amount = rounded - v.d;
        struct cagd_code_share *share = cagd_region_array(v.shares + 1, 1, sizeof *share);
        cagd_code_check_faults();
        if (v.shares > 0)
            memcpy(share, v.share, (size_t)v.shares * sizeof *share);
        share[v.shares] = (struct cagd_code_share){cagd_code_at, amount};
        v.shares += amount != 0, v.share = share, v.d = rounded, v.made = 0;
        a = cagd_code_number(v);
    }
    if (used_singles == MOST_SINGLES)
        cagd_code_stop(CAGD_CODE_BOUND, "more than %u numbers of type float", MOST_SINGLES);
    uint32_t tagged = SINGLE_TAG + used_singles;
    float f;
    singles[used_singles++] = a;
    memcpy(&f, &tagged, sizeof f);
    return f;
}

/* ---- views of a value --------------------------------------------------------------------------------- */

cagd_num_f cagd_code_function(cagd_code_value v) { return v.f.at != NULL ? v.f : cagd_from_rational_f(v.q); }

cagd_num_i cagd_code_interval(cagd_code_value v)
{
    if (v.i.at != NULL)
        return v.i;
    return cagd_from_rational_i(v.q);
}

const char *cagd_code_text(cagd_code_value v)
{
    char *text = cagd_region_bytes(80);
    if (text == NULL)
        cagd_code_check_faults();
    if (v.special)
        snprintf(text, 80, "%g", v.d);
    else if (v.q.at != NULL && cagd_code_machine.job->numbers != CAGD_CODE_INTERVAL)
        return cagd_to_string_q(v.q);
    else
        snprintf(text, 80, "in [%.17g, %.17g]", cagd_lower_i(v.i), cagd_upper_i(v.i));
    return text;
}

const char *cagd_code_field_text(cagd_code_value v)
{
    return v.special || v.f.at == NULL ? cagd_code_text(v) : cagd_to_string_f(v.f);
}

/* ---- variables that are no inputs ------------------------------------------------------------------------ */

void cagd_code_enclose_variable(cagd_num_f variable, cagd_num_i place)
{
    cagd_code_check_faults(); /* there is no room for more variables than the field has */
    enclosed[enclosed_count].variable = variable;
    enclosed[enclosed_count++].place = place;
}

int cagd_code_enclosed_count(void) { return enclosed_count; }
cagd_num_f cagd_code_enclosed_at(int k, cagd_num_i *place)
{
    *place = enclosed[k].place;
    return enclosed[k].variable;
}

/* ---- roots as variables -------------------------------------------------------------------------------- */

enum { MOST_ROOTS = 32 };
static struct {
    cagd_num_f variable, square;
    int is_positive;
} roots[MOST_ROOTS];
static int root_count, root_names; /* root1, root2, ..., without those that are inputs */

int cagd_code_is_input(const char *name)
{
    const struct cagd_code_job *job = cagd_code_machine.job;
    for (int k = 0; k < job->inputs; k++)
        if (strcmp(job->input[k].name, name) == 0)
            return 1;
    return 0;
}

cagd_code_value cagd_code_new_root(cagd_num_f square, cagd_code_value at_point, int is_positive)
{
    char name[CAGD_FIELD_MAX_NAME + 1];
    for (int k = 0; k < root_count; k++)
        if (is_positive && roots[k].is_positive && cagd_equal_f(roots[k].square, square)) {
            cagd_code_value v = at_point;
            v.f = roots[k].variable;
            return v;
        }
    if (root_count == MOST_ROOTS)
        cagd_code_stop(CAGD_CODE_BOUND, "more than %d roots", MOST_ROOTS);
    do
        snprintf(name, sizeof name, "root%d", ++root_names);
    while (cagd_code_is_input(name));
    roots[root_count].variable = cagd_variable_f(name);
    roots[root_count].square = square;
    cagd_code_enclose_variable(roots[root_count].variable, cagd_code_interval(at_point));
    at_point.f = roots[root_count].variable;
    roots[root_count++].is_positive = is_positive;
    cagd_code_check_faults();
    return at_point;
}

/* f = E + O r with r^2 known: 0 if E = O = 0, which do not contain r.  Sufficient; and r may be no root of the field. */
static int vanishes_from(int last, cagd_num_f f)
{
    while (last >= 0 && !cagd_is_zero_f(f) && cagd_degree_f(f, roots[last].variable) < 1)
        last--;
    if (last < 0 || cagd_is_zero_f(f))
        return cagd_is_zero_f(f);
    cagd_num_f r = roots[last].variable, square = roots[last].square,
               part[2] = {cagd_from_int_f(0), cagd_from_int_f(0)};
    cagd_num_f power = cagd_from_int_f(1);
    int degree = cagd_degree_f(f, r);
    for (int k = 0; k <= degree; k++) {
        part[k % 2] = cagd_add_f(part[k % 2], cagd_mul_f(cagd_coefficient_f(f, r, k), power));
        if (k % 2 == 1)
            power = cagd_mul_f(power, square);
    }
    for (int k = 0; k < 2; k++)
        if (!vanishes_from(last - 1, cagd_numerator_f(part[k])))
            return 0;
    return 1;
}

int cagd_code_vanishes(cagd_num_f f)
{
    cagd_trace_pause();
    int answer = cagd_is_zero_f(f) || (root_count > 0 && vanishes_from(root_count - 1, cagd_numerator_f(f)));
    cagd_trace_resume();
    cagd_code_check_faults();
    return answer;
}

/* ---- variables, and a function at the point -------------------------------------------------------------- */

static struct {
    cagd_num_f variable;
    cagd_num_q value;
} variables[CAGD_FIELD_MAX_VARIABLES];
static int variable_count;

cagd_code_value cagd_code_variable(const char *name, cagd_num_q value)
{
    cagd_code_value v = {.q = value, .f = cagd_variable_f(name)};
    cagd_code_check_faults();
    for (int k = 0; k < variable_count; k++)
        if (cagd_equal_f(variables[k].variable, v.f))
            return v;
    variables[variable_count].variable = v.f;
    variables[variable_count++].value = value;
    return v;
}

int cagd_code_has_roots(void) { return root_count > 0; }

cagd_num_q cagd_code_value_at_point(const char *name)
{
    const struct cagd_code_job *job = cagd_code_machine.job;
    for (int k = 0; k < job->inputs; k++) {
        size_t n = strlen(job->input[k].name);
        if (strncmp(job->input[k].name, name, n) == 0 && (name[n] == 0 || name[n] == '['))
            return cagd_from_string_q(job->input[k].value[name[n] == '[' ? strtol(name + n + 1, NULL, 10) : 0]);
    }
    return (cagd_num_q){NULL};
}

int cagd_code_variable_count(void) { return variable_count; }
cagd_num_f cagd_code_variable_at(int k, cagd_num_q *value)
{
    *value = variables[k].value;
    return variables[k].variable;
}

/* The first of the names, as a variable; *names moves behind it. */
static cagd_num_f next_variable(const char **names)
{
    char name[CAGD_FIELD_MAX_NAME + 1];
    size_t length = strcspn(*names, " ");
    memcpy(name, *names, length);
    name[length] = 0;
    *names += length + ((*names)[length] == ' ');
    return cagd_variable_f(name);
}

int cagd_code_has_others(cagd_num_f f)
{
    for (const char *names = cagd_field_variables(); *names != 0;) {
        cagd_num_f x = next_variable(&names);
        int is_input = 0;
        for (int k = 0; k < variable_count && !is_input; k++)
            is_input = cagd_equal_f(variables[k].variable, x);
        if (!is_input && (cagd_degree_f(f, x) > 0 || cagd_denominator_degree_f(f, x) > 0))
            return 1;
    }
    return 0;
}

int cagd_code_solve(cagd_num_f f, cagd_num_f *variable, cagd_num_f *value)
{
    for (int k = variable_count - 1; k >= 0; k--)
        if (cagd_has_degrees_f(f, variables[k].variable, 1, 0)) {
            cagd_num_f slope = cagd_coefficient_f(f, variables[k].variable, 1);
            if (!cagd_is_constant_f(slope, NULL))
                continue;
            *variable = variables[k].variable;
            *value = cagd_neg_f(cagd_div_f(cagd_coefficient_f(f, *variable, 0), slope));
            return 1;
        }
    return 0;
}

cagd_num_q cagd_code_at_point(cagd_num_f f)
{
    cagd_num_q value = {NULL};
    for (int k = 0; k < variable_count; k++)
        f = cagd_substitute_f(f, variables[k].variable, cagd_from_rational_f(variables[k].value));
    cagd_code_check_faults();
    cagd_is_constant_f(f, &value);
    return value;
}

/* Whether all monomials are squares with coefficients of one sign, and so is the denominator: f >= 0 for all values. */
static int is_sum_of_squares(cagd_num_f f)
{
    const char *names = cagd_field_variables();
    while (*names != 0) {
        cagd_num_f x = next_variable(&names);
        if (!cagd_equal_f(cagd_substitute_f(f, x, cagd_neg_f(x)), f))
            return 0; /* some power of x is odd */
    }
    return cagd_coefficients_sign_f(f) >= 0;
}

/* A root needs a number that is not negative: a condition, unless it is known. */
static void need_root(cagd_code_value a)
{
    if (a.f.at != NULL && !is_sum_of_squares(a.f) && cagd_code_relation(a, cagd_code_integer(0), 3) == 4)
        cagd_code_stop(CAGD_CODE_UNDEFINED, "the square root of a negative number");
}

/* The root of a that is a function, positive at the point; or a variable of its own. */
static cagd_code_value field_root(cagd_code_value a, cagd_code_value root)
{
    if (a.f.at == NULL && root.q.at != NULL)
        return root;
    cagd_num_f f = cagd_root_f(2, cagd_code_function(a));
    cagd_num_q value = {NULL};
    if (cagd_region_faults & CAGD_FAULT_UNABLE)
        cagd_region_faults &= ~(unsigned)CAGD_FAULT_UNABLE;
    else
        value = cagd_code_at_point(f);
    if (value.at == NULL && cagd_code_machine.job->no_root_variables)
        cagd_code_stop(CAGD_CODE_REFUSED, "a square root, which is asked for as an interval");
    if (value.at == NULL)
        return cagd_code_new_root(cagd_code_function(a), root, 1);
    root.f = f;
    root.q = value;
    if (cagd_sign_q(value) < 0)
        root = cagd_code_negative(root);
    cagd_code_relation(root, cagd_code_integer(0), 3);
    return root;
}

cagd_code_value cagd_code_square_root(cagd_code_value a)
{
    const struct cagd_code_job *job = cagd_code_machine.job;
    if (a.special)
        return cagd_code_special(sqrt(a.d));
    if (job->numbers == CAGD_CODE_FIELD)
        need_root(a);
    if (a.q.at != NULL ? cagd_sign_q(a.q) < 0 : cagd_sign_i(a.i) < 0)
        cagd_code_stop(CAGD_CODE_UNDEFINED, "the square root of a negative number");
    cagd_code_value v = {.d = sqrt(a.d)};
    if (a.q.at != NULL && job->numbers != CAGD_CODE_INTERVAL) {
        v.q = cagd_root_q(2, a.q);
        if (cagd_region_faults & CAGD_FAULT_UNABLE) {
            cagd_region_faults &= ~(unsigned)CAGD_FAULT_UNABLE;
            v.q.at = NULL;
        }
    }
    if (v.q.at == NULL)
        v.i = cagd_root_i(2, cagd_code_interval(a));
    if (job->numbers == CAGD_CODE_FIELD)
        return field_root(a, v);
    if (v.q.at == NULL && job->numbers == CAGD_CODE_RATIONAL && !job->enclose)
        cagd_code_stop(CAGD_CODE_REFUSED, "a square root that is not rational");
    if (job->numbers == CAGD_CODE_ROUNDING) {
        double twice = v.d + cagd_code_real(v);
        cagd_code_shared(&v, a, twice != 0 ? 1 / twice : 0, (cagd_code_value){0}, 0,
                         v.d != 0 ? fma(v.d, v.d, -a.d) / (2 * v.d) : 0);
        cagd_code_note_made(&v, 'r', a, a);
    }
    return v;
}
