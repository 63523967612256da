/* read_dots.c -- what dots leave out of a sum or of a product, where its ends say it.
 *
 *     a_0 + a_1 + \dots + a_n                      the sum of a_{0+k} over k = 0, ..., n
 *     1 + t + t^2 + \dots + t^n                    of t^{0+k}: where one term has a power, 1 and t are powers, too
 *     \frac{1}{1 \cdot 2} + \frac{1}{2 \cdot 3} + \dots + \frac{1}{n(n+1)}
 *     n(n-1) \cdots (n-r+1)                        the product of n-k over k = 0, ..., r-1
 *
 * The terms before the dots and the one behind them are put on top of each other.  At every place where they differ there are linear
 * forms in names, with coefficients that are numbers: from one term to the next they change by one constant d, a whole number, and
 * the last is m d away from the first, with the same m at every place.  Then the terms are those for k = 0, ..., m.  A single
 * term before the dots is enough where no other reading is near: the step is then 1, or -1 where the last place lies below the
 * first whatever the names are.  Everything else is refused. */
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

enum { MOST_SAMPLES = 8, MOST_PLACES = 16, MOST_ATOMS = 8, MOST_CALLS = 2000 };

/* constant + sum of coefficient * atom, the atoms being trees that are no sums. */
struct linear {
    num_q constant, coefficient[MOST_ATOMS];
    const cagd_tree *atom[MOST_ATOMS];
    int count;
};

/* A place where the terms differ: what stands there in each of them. */
struct place {
    const cagd_tree *at[MOST_SAMPLES];
    struct linear first;
    long step;
};

/* The terms that are put on top of each other: those before the dots, and the last one. */
struct terms {
    cagd_reader *reader;
    int count;
    struct place place[MOST_PLACES];
    int places;
    struct linear steps; /* m */
    int has_steps, calls, alternates;
    const char *letter;
};

/* ---- linear forms -------------------------------------------------------------------------------------- */

/* Adds times * t to the form; 0 where there is no room. */
static int add_linear(struct linear *form, const cagd_tree *t, num_q times)
{
    if (t->kind == CAGD_NUMBER) {
        form->constant = add_q(form->constant, mul_q(times, t->number));
        return 1;
    }
    if (t->kind == CAGD_NEGATIVE)
        return add_linear(form, t->at[0], neg_q(times));
    if (t->kind == CAGD_SUM) {
        for (int k = 0; k < t->count; k++)
            if (!add_linear(form, t->at[k], times))
                return 0;
        return 1;
    }
    if (t->kind == CAGD_PRODUCT && t->count == 2 && t->at[0]->kind == CAGD_NUMBER)
        return add_linear(form, t->at[1], mul_q(times, t->at[0]->number));
    for (int k = 0; k < form->count; k++)
        if (cagd_tree_equal(form->atom[k], t)) {
            form->coefficient[k] = add_q(form->coefficient[k], times);
            return 1;
        }
    if (form->count == MOST_ATOMS)
        return 0;
    form->atom[form->count] = t;
    form->coefficient[form->count++] = times;
    return 1;
}

/* b - a. */
static int difference(struct linear *form, const cagd_tree *a, const cagd_tree *b)
{
    *form = (struct linear){.constant = from_int_q(0)};
    return a->dimension == 0 && b->dimension == 0 && add_linear(form, b, from_int_q(1)) &&
           add_linear(form, a, from_int_q(-1));
}

/* The form is that number, whatever its atoms are; it is whole and small. */
static int is_constant(const struct linear *form, long *value)
{
    for (int k = 0; k < form->count; k++)
        if (!cagd_is_zero_q(form->coefficient[k]))
            return 0;
    if (!cagd_is_whole_q(form->constant) || !mpz_fits_sshort_p(mpq_numref(form->constant.at)))
        return 0;
    *value = mpz_get_si(mpq_numref(form->constant.at));
    return 1;
}

int cagd_difference_is_number(const cagd_tree *a, const cagd_tree *b, long *number)
{
    struct linear form;
    return difference(&form, a, b) && is_constant(&form, number);
}

int cagd_difference_is_multiple(const cagd_tree *a, const cagd_tree *b, long number)
{
    struct linear form;
    int is = difference(&form, a, b) && cagd_is_whole_q(div_q(form.constant, from_int_q(number)));
    for (int k = 0; is && k < form.count; k++)
        is = cagd_is_whole_q(div_q(form.coefficient[k], from_int_q(number))) &&
             (cagd_is_zero_q(form.coefficient[k]) || (form.atom[k]->kind == CAGD_NAME && form.atom[k]->count == 0));
    return is;
}

/* No coefficient above 0, and one below: the form is negative where its atoms are large. */
static int points_down(const struct linear *form)
{
    int below = form->count == 0 && cagd_sign_q(form->constant) < 0;
    for (int k = 0; k < form->count; k++) {
        if (cagd_sign_q(form->coefficient[k]) > 0)
            return 0;
        below |= cagd_sign_q(form->coefficient[k]) < 0;
    }
    return below;
}

static int is_whole(const struct linear *form)
{
    int whole = cagd_is_whole_q(form->constant);
    for (int k = 0; k < form->count; k++)
        whole &= cagd_is_whole_q(form->coefficient[k]);
    return whole;
}

static int are_equal(const struct linear *a, const struct linear *b)
{
    struct linear d = *a;
    long zero;
    d.constant = sub_q(d.constant, b->constant);
    for (int k = 0; k < b->count; k++)
        if (!add_linear(&d, b->atom[k], neg_q(b->coefficient[k])))
            return 0;
    return is_constant(&d, &zero) && zero == 0;
}

/* The form, and step * letter where step is not 0, as a tree with the bytes of `where`. */
static const cagd_tree *tree_of(cagd_reader *r, const struct linear *form, long step, const char *letter,
                                const cagd_tree *where)
{
    const cagd_tree *list[MOST_ATOMS + 2];
    int count = 0;
    if (!cagd_is_zero_q(form->constant)) {
        cagd_tree *c = cagd_tree_number(0, where->from, where->to);
        if (c == NULL)
            return NULL;
        c->number = form->constant;
        list[count++] = c;
    }
    for (int k = 0; k <= form->count; k++) {
        int is_letter = k == form->count;
        num_q times = is_letter ? from_int_q(step) : form->coefficient[k];
        if (cagd_is_zero_q(times))
            continue;
        cagd_tree *of = is_letter ? cagd_new(r, CAGD_NAME, where->from, 0) : NULL;
        if (is_letter && of != NULL)
            of->head = letter, of->to = where->to;
        const cagd_tree *t = is_letter ? of : form->atom[k];
        if (t != NULL && cagd_equal_q(times, from_int_q(-1))) {
            t = cagd_new_of(r, CAGD_NEGATIVE, where->from, 1, &t);
        } else if (t != NULL && !cagd_equal_q(times, from_int_q(1))) {
            cagd_tree *c = cagd_tree_number(0, where->from, where->to);
            if (c != NULL)
                c->number = times;
            t = cagd_new_of(r, CAGD_PRODUCT, where->from, 2, (const cagd_tree *[]){c, t});
        }
        if (t == NULL)
            return NULL;
        list[count++] = t;
    }
    if (count == 0)
        return cagd_tree_number(0, where->from, where->to);
    cagd_tree *sum = count > 1 ? cagd_new_of(r, CAGD_SUM, where->from, count, list) : NULL;
    if (sum != NULL)
        sum->to = where->to;
    return count == 1 ? list[0] : sum;
}

/* ---- putting terms on top of each other ---------------------------------------------------------------- */

static const cagd_tree *overlay(struct terms *s, const cagd_tree *const at[]);

/* The place where these stand, if they change by one constant; what stands there in the term number k. */
static const cagd_tree *place(struct terms *s, const cagd_tree *const at[])
{
    struct linear change, whole;
    long step = 0, next;
    if (s->places == MOST_PLACES || !difference(&whole, at[0], at[s->count - 1]))
        return NULL;
    for (int k = 0; k + 2 < s->count; k++) {
        if (!difference(&change, at[k], at[k + 1]) || !is_constant(&change, &next) || (k > 0 && next != step))
            return NULL;
        step = next;
    }
    if (s->count == 2)
        step = points_down(&whole) ? -1 : 1;
    if (step == 0)
        return NULL;
    whole.constant = div_q(whole.constant, from_int_q(step));
    for (int k = 0; k < whole.count; k++)
        whole.coefficient[k] = div_q(whole.coefficient[k], from_int_q(step));
    if (!is_whole(&whole) || (s->has_steps && !are_equal(&whole, &s->steps)))
        return NULL;
    s->steps = whole, s->has_steps = 1;
    struct place *p = &s->place[s->places++];
    memcpy(p->at, at, (size_t)s->count * sizeof *at);
    p->step = step;
    p->first = (struct linear){.constant = from_int_q(0)};
    return add_linear(&p->first, at[0], from_int_q(1)) ? tree_of(s->reader, &p->first, step, s->letter, at[0]) : NULL;
}

/* The exponent with which t is a power of the base: of t itself it is 1, of the number 1 it is 0. */
static const cagd_tree *exponent_of(const cagd_tree *t, const cagd_tree *base)
{
    if (t->kind == CAGD_POWER && cagd_tree_equal(t->at[0], base))
        return t->at[1];
    int is_one = t->kind == CAGD_NUMBER && cagd_equal_q(t->number, from_int_q(1));
    if (is_one || cagd_tree_equal(t, base))
        return cagd_tree_number(!is_one, t->from, t->to);
    if (t->kind != CAGD_NUMBER || base->kind != CAGD_NUMBER || cagd_compare_q(base->number, from_int_q(2)) < 0)
        return NULL;
    num_q power = base->number; /* 1 + 2 + 4 + \dots + 2^n */
    for (int e = 2; cagd_compare_q(power, t->number) < 0; e++) {
        power = mul_q(power, base->number);
        if (cagd_equal_q(power, t->number))
            return cagd_tree_number(e, t->from, t->to);
    }
    return NULL;
}

static const cagd_tree *powers(struct terms *s, const cagd_tree *const at[])
{
    const cagd_tree *base = NULL, *exponent[MOST_SAMPLES];
    for (int k = 0; k < s->count && base == NULL; k++)
        base = at[k]->kind == CAGD_POWER ? at[k]->at[0] : NULL;
    for (int k = 0; k < s->count; k++)
        if (base == NULL || (exponent[k] = exponent_of(at[k], base)) == NULL)
            return NULL;
    const cagd_tree *e = overlay(s, exponent);
    return e != NULL ? cagd_new_of(s->reader, CAGD_POWER, at[0]->from, 2, (const cagd_tree *[]){base, e}) : NULL;
}

static int are_alike(const cagd_tree *a, const cagd_tree *b)
{
    return a->kind == b->kind && a->count == b->count && a->count > 0 && a->order == b->order && a->lower == b->lower &&
           a->upper == b->upper && (a->head == NULL) == (b->head == NULL) &&
           (a->head == NULL || strcmp(a->head, b->head) == 0) && a->times == b->times;
}

/* Terms of one kind: the same again, with what comes out for their parts. */
static const cagd_tree *parts(struct terms *s, const cagd_tree *const at[])
{
    const cagd_tree *list[CAGD_MOST_CHILDREN], *part[MOST_SAMPLES];
    if (at[0]->kind == CAGD_RELATION || at[0]->count > CAGD_MOST_CHILDREN)
        return NULL;
    for (int k = 1; k < s->count; k++)
        if (!are_alike(at[0], at[k]))
            return NULL;
    for (int m = 0; m < at[0]->count; m++) {
        for (int k = 0; k < s->count; k++)
            part[k] = at[k]->at[m];
        if ((list[m] = overlay(s, part)) == NULL)
            return NULL;
    }
    cagd_tree *t = cagd_new(s->reader, at[0]->kind, at[0]->from, at[0]->count);
    if (t == NULL)
        return NULL;
    const cagd_tree **room = t->at;
    *t = *at[0];
    t->at = room;
    memcpy(room, list, (size_t)t->count * sizeof *list);
    return t;
}

/* The factors of a term, of which at most one is a sign: -1. */
struct factors {
    int negative, count;
    const cagd_tree *const *at;
};

static struct factors factors_of(const cagd_tree *const *t)
{
    int negative = (*t)->kind == CAGD_NEGATIVE;
    const cagd_tree *const *inside = negative ? (*t)->at : t;
    int many = (*inside)->kind == CAGD_PRODUCT;
    return (struct factors){negative, many ? (*inside)->count : 1, many ? (*inside)->at : inside};
}

/* 1, or -1. */
static int is_unit(const cagd_tree *t, int sign)
{
    if (sign < 0)
        return t->kind == CAGD_NEGATIVE && is_unit(t->at[0], 1);
    return t->kind == CAGD_NUMBER && cagd_equal_q(t->number, from_int_q(1));
}

/* The bases of the powers among the factors of all terms. */
static int bases_of(const struct factors of[], int terms, const cagd_tree *base[])
{
    int bases = 0;
    for (int k = 0; k < terms; k++)
        for (int m = 0; m < of[k].count; m++) {
            const cagd_tree *t = of[k].at[m];
            int is_new = t->kind == CAGD_POWER;
            for (int b = 0; b < bases && is_new; b++)
                is_new = !cagd_tree_equal(base[b], t->at[0]);
            if (is_new && bases < MOST_ATOMS)
                base[bases++] = t->at[0];
        }
    return bases;
}

/* Divides the factors of a term into one power of each base, its exponent, and the others; the number of others, or -1. */
static int divide(const struct factors *f, const cagd_tree *const base[], int bases, const cagd_tree *exponent[],
                  const cagd_tree *other[])
{
    int others = 0, signs = 0;
    memset(exponent, 0, (size_t)bases * sizeof *exponent);
    for (int m = 0; m < f->count; m++) {
        const cagd_tree *t = f->at[m], *e = NULL;
        int b = -1;
        while (e == NULL && ++b < bases)
            e = is_unit(t, 1) ? NULL : exponent_of(t, base[b]);
        if (e == NULL && others == MOST_ATOMS)
            return -1;
        if (e == NULL)
            other[others++] = t;
        else if (exponent[b] != NULL)
            return -1;
        else
            exponent[b] = e;
    }
    for (int b = 0; b < bases; b++) {
        int is_sign = is_unit(base[b], -1) && f->negative;
        if (is_sign && exponent[b] != NULL)
            return -1;
        signs += is_sign;
        if (exponent[b] == NULL)
            exponent[b] = cagd_tree_number(is_sign, f->at[0]->from, f->at[0]->to);
        if (exponent[b] == NULL)
            return -1;
    }
    return f->negative && signs == 0 ? -1 : others;
}

/* The exponents of -1, of which only the parity counts: those of the first terms are numbers, and change by 1 each time, or by 2, and
 * that of the last fits to the number of steps. */
static const cagd_tree *alternating(struct terms *s, const cagd_tree *const at[])
{
    struct linear e, rest;
    long first, next;
    e = (struct linear){.constant = from_int_q(0)};
    if (!s->has_steps || s->count == 2 || !add_linear(&e, at[0], from_int_q(1)) || !is_constant(&e, &first))
        return NULL;
    for (int k = 1; k + 1 < s->count; k++)
        if (!difference(&rest, at[0], at[k]) || !is_constant(&rest, &next) || (next - k) % 2 != 0)
            return NULL;
    if (!difference(&rest, at[0], at[s->count - 1]))
        return NULL;
    for (int k = 0; k < s->steps.count; k++)
        if (!add_linear(&rest, s->steps.atom[k], neg_q(s->steps.coefficient[k])))
            return NULL;
    rest.constant = div_q(sub_q(rest.constant, s->steps.constant), from_int_q(2));
    for (int k = 0; k < rest.count; k++)
        rest.coefficient[k] = div_q(rest.coefficient[k], from_int_q(2));
    s->alternates = 1;
    return is_whole(&rest) ? tree_of(s->reader, &e, 1, s->letter, at[0]) : NULL;
}

/* Products in which powers have the exponents 1 and 0, too, and a number 1 may be left out: 1 + 2x + 3x^2 + \dots + n x^{n-1}; a
 * sign before a term is a power of -1 where another term has one. */
static const cagd_tree *products(struct terms *s, const cagd_tree *const at[])
{
    struct factors of[MOST_SAMPLES];
    const cagd_tree *base[MOST_ATOMS], *exponent[MOST_SAMPLES][MOST_ATOMS], *other[MOST_SAMPLES][MOST_ATOMS];
    const cagd_tree *column[MOST_SAMPLES], *list[2 * MOST_ATOMS];
    int others[MOST_SAMPLES], most = 0, count = 0;
    for (int k = 0; k < s->count; k++)
        of[k] = factors_of(&at[k]);
    int bases = bases_of(of, s->count, base);
    if (bases == 0)
        return NULL;
    for (int k = 0; k < s->count; k++) {
        others[k] = divide(&of[k], base, bases, exponent[k], other[k]);
        if (others[k] < 0 || (s->count == 2 && others[k] != others[0])) /* a number 1 would be a guess */
            return NULL;
        most = others[k] > most ? others[k] : most;
    }
    for (int m = 0; m < most; m++) { /* what is missing is a number 1 in front */
        for (int k = 0; k < s->count; k++) {
            int from = m - (most - others[k]);
            column[k] = from >= 0 ? other[k][from] : cagd_tree_number(1, at[k]->from, at[k]->to);
            if (column[k] == NULL)
                return NULL;
        }
        if ((list[count++] = overlay(s, column)) == NULL)
            return NULL;
    }
    for (int with_sign = 0; with_sign <= 1; with_sign++) /* how many steps there are is said by the others */
        for (int b = 0; b < bases; b++) {
            if (is_unit(base[b], -1) != with_sign)
                continue;
            for (int k = 0; k < s->count; k++)
                column[k] = exponent[k][b];
            const cagd_tree *e = with_sign ? alternating(s, column) : overlay(s, column);
            list[count++] = e != NULL
                                ? cagd_new_of(s->reader, CAGD_POWER, at[0]->from, 2, (const cagd_tree *[]){base[b], e})
                                : NULL;
            if (list[count - 1] == NULL)
                return NULL;
        }
    return count == 1 ? list[0] : cagd_new_of(s->reader, CAGD_PRODUCT, at[0]->from, count, list);
}

/* The term number k, where the first and those behind it are at[0], at[1], ..., and the last one; NULL if no rule is evident. */
static const cagd_tree *overlay(struct terms *s, const cagd_tree *const at[])
{
    static const cagd_tree *(*const way[])(struct terms *, const cagd_tree *const[]) = {parts, powers, products, place};
    int same = 1;
    for (int k = 1; k < s->count; k++)
        same &= cagd_tree_equal(at[0], at[k]);
    if (same)
        return at[0];
    for (size_t k = 0; k < sizeof way / sizeof *way && s->calls < MOST_CALLS; k++) {
        int places = s->places, has_steps = s->has_steps;
        struct linear steps = s->steps;
        s->calls++;
        const cagd_tree *t = way[k](s, at);
        if (t != NULL)
            return t;
        s->places = places, s->has_steps = has_steps, s->steps = steps;
    }
    return NULL;
}

/* ---- dots ---------------------------------------------------------------------------------------------- */

/* A letter that is not known and does not occur in the terms. */
static const char *free_letter(const cagd_reader *r, const cagd_tree *const at[], int count)
{
    static const char *const letters[] = {"k", "j", "l", "m", "r", "s", "p", "q", "\\kappa", "\\nu"};
    for (size_t m = 0; m < sizeof letters / sizeof *letters; m++) {
        int is_free = !cagd_is_known(r, letters[m]);
        for (int k = 0; k < count; k++)
            is_free &= !cagd_tree_has(at[k], letters[m]);
        if (is_free)
            return letters[m];
    }
    return NULL;
}

/* Whether a name in it is declared as one that need not be a whole number. */
static int has_real_name(const cagd_reader *r, const cagd_tree *t)
{
    if (t->kind == CAGD_NAME && !cagd_is_bound(r, t->head)) {
        const cagd_variable *v = cagd_declared(r->scope, t->head);
        if (v != NULL && !v->whole)
            return 1;
    }
    for (int k = 0; k < t->count; k++)
        if (has_real_name(r, t->at[k]))
            return 1;
    return 0;
}

/* Whether the number of steps is said by what can be a whole number; behind a single term by a name, once. */
static int is_evident(const struct terms *s)
{
    for (int k = 0; k < s->steps.count; k++) {
        const cagd_tree *t = s->steps.atom[k];
        num_q c = s->steps.coefficient[k];
        if (cagd_is_zero_q(c))
            continue;
        int is_once = cagd_equal_q(c, from_int_q(1)) || cagd_equal_q(c, from_int_q(-1));
        if (has_real_name(s->reader, t) || (s->count == 2 && (t->kind != CAGD_NAME || !is_once)))
            return 0;
    }
    return 1;
}

/* The term number k of before[start..count) and the last one, and m; NULL if no rule is evident. */
static const cagd_tree *term_of(struct terms *s, cagd_reader *r, const cagd_tree *const before[], int start, int count,
                                const cagd_tree *last)
{
    const cagd_tree *at[MOST_SAMPLES];
    *s = (struct terms){.reader = r, .count = count - start + 1};
    if (s->count > MOST_SAMPLES)
        return NULL;
    memcpy(at, before + start, (size_t)(count - start) * sizeof *at);
    at[s->count - 1] = last;
    s->letter = free_letter(r, at, s->count);
    const cagd_tree *t = s->letter != NULL ? overlay(s, at) : NULL;
    int is_one = start == 0 || s->count > 2 || s->places == 1; /* behind other terms, a single one */
    return s->has_steps && is_one && is_evident(s) ? t : NULL;
}

/* Whether b could be the term behind a, whatever their signs are: then a is none that stands before the first. */
static int may_follow(cagd_reader *r, const cagd_tree *a, const cagd_tree *b)
{
    struct terms s;
    long steps;
    a = a->kind == CAGD_NEGATIVE ? a->at[0] : a;
    b = b->kind == CAGD_NEGATIVE ? b->at[0] : b;
    return cagd_tree_equal(a, b) || (term_of(&s, r, &a, 0, 1, b) != NULL && is_constant(&s.steps, &steps));
}

/* Refused; with what could be meant where the ends differ at one place. */
static cagd_tree *refuse(cagd_reader *r, const cagd_token *dots, cagd_tree_kind kind, const cagd_tree *first,
                         const cagd_tree *last)
{
    enum { MOST_SHOWN = 40 };
    struct terms s;
    const char *sign = kind == CAGD_SUM_OVER       ? "\\sum"
                       : kind == CAGD_PRODUCT_OVER ? "\\prod"
                       : kind == CAGD_MAXIMUM_OVER ? "\\max"
                                                   : "\\min";
    r->token = dots;
    if (kind != CAGD_PRODUCT_OVER && term_of(&s, r, &first, 0, 1, last) != NULL && s.places == 1 &&
        s.place[0].step == 1) {
        const cagd_tree *low = s.place[0].at[0], *high = s.place[0].at[1];
        /* The exponent of u is 1, and is not written: that number stands where u does. */
        int is_written = high->kind != CAGD_NUMBER || strchr("0123456789.", r->text[high->from]) != NULL;
        int before = (is_written ? high->from : high->to) - last->from, behind = last->to - high->to;
        const char *start = low->kind == CAGD_NUMBER ? to_string_q(low->number)
                                                     : cagd_text_of(r->text + low->from, low->to - low->from);
        if (before >= 0 && behind >= 0 && before + behind < MOST_SHOWN && start != NULL && strlen(start) < MOST_SHOWN &&
            high->to - high->from < MOST_SHOWN)
            return cagd_refuse_token(r, "what is left out? if it is every one, write %s_{%s=%s}^{%.*s} %.*s%s%s%.*s",
                                     sign, s.letter, start, is_written ? high->to - high->from : 1,
                                     is_written ? r->text + high->from : "1", before, r->text + last->from,
                                     is_written ? "" : "^", s.letter, behind, r->text + high->to);
    }
    return cagd_refuse_token(r, "what is left out? the ends do not say it: write %s_{k=0}^{n} and the term for k",
                             sign);
}

const cagd_tree *cagd_fill_dots(cagd_reader *r, cagd_tree_kind kind, const cagd_token *dots,
                                const cagd_tree *const before[], int count, const cagd_tree *last, int signs_differ,
                                int *start)
{
    struct terms s;
    const cagd_tree *term = NULL;
    int from = count > MOST_SAMPLES - 1 ? count - MOST_SAMPLES + 1 : 0;
    for (*start = from; *start < count; ++*start) {
        term = term_of(&s, r, before, *start, count, last);
        if (term != NULL)
            break;
    }
    if (term == NULL || (signs_differ && !s.alternates) ||
        (*start > 0 && may_follow(r, before[*start - 1], before[*start])))
        return refuse(r, dots, kind, before[0], last);
    const cagd_tree *high = tree_of(r, &s.steps, 0, s.letter, last);
    cagd_tree *t =
        cagd_new_of(r, kind, before[*start]->from, 3,
                    (const cagd_tree *[]){cagd_tree_number(0, before[*start]->from, before[*start]->to), high, term});
    if (t != NULL)
        t->head = s.letter;
    return t;
}

/* ---- chains -------------------------------------------------------------------------------------------- */

/* The tree with letter + 1 for the letter. */
static const cagd_tree *next_of(cagd_reader *r, const cagd_tree *t, const char *letter)
{
    if (t->kind == CAGD_NAME && t->count == 0 && strcmp(t->head, letter) == 0) {
        cagd_tree *sum = cagd_new(r, CAGD_SUM, t->from, 2);
        if (sum != NULL)
            sum->at[0] = t, sum->at[1] = cagd_tree_number(1, t->from, t->to), sum->to = t->to;
        return sum;
    }
    cagd_tree *copy = t->count > 0 ? cagd_new(r, t->kind, t->from, t->count) : NULL;
    if (copy == NULL)
        return t;
    const cagd_tree **at = copy->at;
    *copy = *t;
    copy->at = at;
    for (int k = 0; k < t->count; k++)
        at[k] = next_of(r, t->at[k], letter);
    return copy;
}

const cagd_tree *cagd_fill_chain(cagd_reader *r, const cagd_tree *const before[], int count, const cagd_tree *last,
                                 cagd_relation relation, int *start)
{
    struct terms s;
    const cagd_tree *term = NULL;
    for (*start = count > MOST_SAMPLES - 1 ? count - MOST_SAMPLES + 1 : 0; *start < count; ++*start)
        if ((term = term_of(&s, r, before, *start, count, last)) != NULL)
            break;
    /* a = \dots = b of two values leaves steps out of a calculation */
    if (term == NULL || (s.count == 2 && (before[*start]->kind != CAGD_NAME || !are_alike(before[*start], last))))
        return NULL;
    s.steps.constant = sub_q(s.steps.constant, from_int_q(1));
    const cagd_tree *high = tree_of(r, &s.steps, 0, s.letter, last);
    const cagd_tree *pair =
        cagd_relate(r, before[*start]->from, 2, (const cagd_tree *[]){term, next_of(r, term, s.letter)}, &relation);
    cagd_tree *t =
        cagd_new_of(r, CAGD_FOR_ALL, before[*start]->from, 3,
                    (const cagd_tree *[]){cagd_tree_number(0, before[*start]->from, before[*start]->to), high, pair});
    if (t != NULL)
        t->head = s.letter;
    return t;
}
