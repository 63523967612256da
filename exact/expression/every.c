#include "exact/expression/every.h"

#include "exact/expression/closed.h"
#include "exact/expression/induction.h"
#include "exact/record/trace.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

enum { MOST_ORDER = 2, FURTHEST = 1000, MOST_BY = 4, MOST_LEFT_OUT = 20 };

static num_f shifted(num_f a, num_f x, long by) { return substitute_f(a, x, add_f(x, from_int_f(by))); }

/* ---- the sum ------------------------------------------------------------------------------------------- */

/* The sum that t is, perhaps by a definition, with a factor before it: its tree and frame; the factor goes to `out`. */
static const cagd_tree *find_sum(cagd_search *s, const cagd_tree *t, const cagd_frame *f, cagd_frame room[],
                                 const cagd_frame **inner, cagd_product *out)
{
    *inner = f;
    if (t->kind == CAGD_SUM_OVER)
        return t->count == 3 ? t : NULL;
    if (t->kind == CAGD_NAME) {
        const cagd_tree *body = cagd_called_body(s, t, f, room, inner);
        return body != NULL && body->kind == CAGD_SUM_OVER && body->count == 3 ? body : NULL;
    }
    if (t->kind != CAGD_PRODUCT || t->at[t->count - 1]->kind != CAGD_SUM_OVER)
        return NULL;
    for (int i = 0; i + 1 < t->count; i++)
        if (!cagd_take(s, t->at[i], f, 1, out))
            return NULL;
    return t->at[t->count - 1]->count == 3 ? t->at[t->count - 1] : NULL;
}

/* For the number n: the first term of the sum that `whole` is, its factor with it, and the value of the other side. */
static int at_number(cagd_search *s, const cagd_tree *whole, const cagd_tree *other, const char *n, long number,
                     long begin, num_f *first, num_f *start)
{
    cagd_frame room[CAGD_MOST_CHILDREN];
    const cagd_frame *f;
    cagd_product unused = {cagd_term_one(), from_int_f(1)};
    num_f x;
    cagd_binding_of(&s->c, n)->value = cagd_value_int(number);
    const cagd_tree *sum = find_sum(s, whole, NULL, room, &f, &unused);
    int good = sum != NULL && cagd_value_in(s, other, NULL, start);
    if (good) {
        cagd_frame inner = {sum->head, cagd_value_int(begin), f};
        good = cagd_value_in(s, sum->at[2], &inner, first);
    }
    for (int i = 0; good && whole->kind == CAGD_PRODUCT && i + 1 < whole->count; i++) {
        good = cagd_value_in(s, whole->at[i], NULL, &x);
        *first = good ? mul_f(*first, x) : *first;
    }
    cagd_binding_of(&s->c, n)->value = (cagd_value){.f = s->n};
    return good && !cagd_is_zero_f(*start) && !cagd_is_zero_f(*first);
}

/* What is found: n - by_n and k - (begin_by n + begin) of the statement are the n and k of the question. */
struct proof {
    const cagd_tree *sum, *whole, *other;
    cagd_sum question;
    cagd_telescoper T;
    long begin, by_n, from;
    int begin_by;
};

/* The terms with k counted from k_0 = d n + c: F(n, k + k_0). */
static cagd_term counted_from(const cagd_search *s, cagd_term F, int d, long c)
{
    num_f n = s->n, k = s->k, first = add_f(mul_f(from_int_f(d), n), from_int_f(c)), here = add_f(k, first);
    num_f at_next = shifted(F.by_k, n, 1), by_n = substitute_f(F.by_n, k, here);
    for (int i = 0; i < d; i++)
        by_n = mul_f(by_n, substitute_f(at_next, k, add_f(here, from_int_f(i))));
    for (int i = 1; i <= -d; i++)
        by_n = div_f(by_n, substitute_f(at_next, k, sub_f(here, from_int_f(i))));
    return (cagd_term){by_n, substitute_f(F.by_k, k, here)};
}

/* Whether the term is 0 at k = at(n) for every n: a rational factor is, or a binomial coefficient beyond its row. */
static int vanishes_at(cagd_search *s, const cagd_tree *term, const cagd_frame *f, const char *k, num_f rational,
                       num_f at)
{
    cagd_frame inner = {k, cagd_value_f(at), f};
    num_f value;
    int is = cagd_is_zero_f(substitute_f(rational, s->k, at)) && region_faults == 0;
    if (!is && region_faults == 0)
        is = cagd_closed(s, term, &inner, &value) && cagd_is_zero_f(value);
    region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    return is;
}

static long floor_of(long a, long b) { return a / b - (a % b != 0 && (a < 0) != (b < 0)); }

static int find_proof(cagd_search *s, const cagd_scope *scope, const cagd_tree *statement, const cagd_variable *name,
                      long low, int checked, struct proof *out)
{
    if (statement->kind != CAGD_RELATION || statement->count != 2 || statement->relation[0] != CAGD_EQUAL ||
        low <= -FURTHEST)
        return 0;
    cagd_search_begin(s, scope, name->head, low < FURTHEST ? (int)low : FURTHEST);
    cagd_product F = {cagd_term_one(), from_int_f(1)}, S = F;
    cagd_frame room[CAGD_MOST_CHILDREN];
    const cagd_frame *f = NULL;
    const cagd_tree *sum = NULL, *other = NULL, *whole = NULL;
    for (int side = 0; side < 2 && sum == NULL; side++) {
        F = S;
        whole = statement->at[side], other = statement->at[!side];
        sum = find_sum(s, whole, NULL, room, &f, &F);
    }
    num_f first, last;
    int first_by, by, begin_at, end_at;
    if (sum == NULL || !cagd_value_in(s, sum->at[0], f, &first) || !cagd_value_in(s, sum->at[1], f, &last) ||
        !cagd_linear_with_n(s, first, &first_by, &begin_at) || !cagd_linear_with_n(s, last, &by, &end_at) ||
        by - first_by < 1 || by - first_by > MOST_BY)
        return 0;
    cagd_frame inner = {sum->head, {.f = s->k}, f};
    /* k runs from first_by n + begin to by n + end; where the term vanishes at an end, that end is left out. */
    long begin = begin_at, end = end_at;
    cagd_range range = {first_by, by, begin, end};
    if (!cagd_take_within(s, sum->at[2], &inner, range, &F) || !cagd_take(s, other, NULL, 1, &S) ||
        !cagd_divisors_are_not_zero(s, range))
        return 0;
    s->c.divisor = NULL;
    num_f n = s->n;
    for (; begin < begin_at + MOST_LEFT_OUT; begin++)
        if (!vanishes_at(s, sum->at[2], f, sum->head, F.rational,
                         add_f(mul_f(from_int_f(first_by), n), from_int_f(begin))))
            break;
    for (; end > end_at - MOST_LEFT_OUT; end--)
        if (!vanishes_at(s, sum->at[2], f, sum->head, F.rational, add_f(mul_f(from_int_f(by), n), from_int_f(end))))
            break;
    /* By p n + length, and p (n - by_n) + beyond: the n of the sum is n - by_n, its k is counted from the first one. */
    int p = by - first_by;
    long by_n = -floor_of(end - begin, p), beyond = end - begin + p * by_n;
    cagd_term counted = counted_from(s, F.ratio, first_by, begin);
    cagd_sum question = {.F = {shifted(counted.by_n, n, by_n), shifted(counted.by_k, n, by_n)},
                         .first = from_int_f(0),
                         .ratio = shifted(S.ratio.by_n, n, by_n),
                         .start = from_int_f(0),
                         .generic = 1,
                         .by = p,
                         .beyond = (int)beyond};
    region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    for (long from = low > by_n ? low : by_n; from < low + checked; from++) {
        question.from = (int)(from - by_n);
        if (!at_number(s, whole, other, name->head, from, first_by * from + begin, &question.first, &question.start))
            continue;
        enum cagd_sum_answer answer = cagd_sum_for_every_n(&question, s->n, s->k, MOST_ORDER, &out->T);
        unsigned faults = region_faults;
        region_faults &= FAULT_MEMORY | FAULT_CROWDED;
        if (answer != CAGD_SUM_PROVED || faults != 0)
            continue;
        out->sum = sum, out->whole = whole, out->other = other, out->question = question;
        out->begin = begin, out->begin_by = first_by, out->by_n = by_n, out->from = from;
        return 1;
    }
    return 0;
}

/* The variable w that stands for b^n, (p n)!, a sum or a product, in the letters of the statement. */
static struct cagd_variable_text told_growth(const cagd_search *s, const cagd_growth *g, const char *n)
{
    struct cagd_variable_text out = {.name = cagd_to_string_f(g->w), .of = g->of, .by = g->by};
    out.times = cagd_in_letters(s, g->times, n, ""), out.plus = cagd_in_letters(s, g->plus, n, "");
    if (g->kind == CAGD_OF_POWER)
        out.power_of = cagd_in_letters(s, g->base, n, "");
    return out;
}

/* Both sides, and all of a chain, have closed forms that are equal, or differ by what is 0 by induction, which begins with a number that is
 * known. */
static int have_closed_forms(cagd_search *s, const cagd_scope *scope, const cagd_tree *statement,
                             const cagd_variable *n, long low, int checked, cagd_every *out)
{
    if (statement->kind != CAGD_RELATION || low > FURTHEST || low < -FURTHEST)
        return 0;
    cagd_search_begin(s, scope, n->head, (int)low);
    *out = (cagd_every){.closed = 1, .from = low, .n = n->head, .k = "", .R = ""};
    num_f before, value, N, r;
    for (int i = 0; i < statement->count; i++, before = value) {
        if (!cagd_closed(s, statement->at[i], NULL, &value) || (i > 0 && statement->relation[i - 1] != CAGD_EQUAL))
            return 0;
        if (i == 0 || cagd_equal_closed(s, before, value))
            continue;
        if (checked < 1 || out->E != NULL || !cagd_vanishes_by_induction(s, sub_f(before, value), &N, &r))
            return 0;
        out->E = cagd_in_letters(s, N, n->head, ""), out->ratio = cagd_in_letters(s, r, n->head, "");
    }
    for (int i = 0; out->E != NULL && i < s->growths; i++)
        out->variable[out->variables++] = told_growth(s, &s->growth[i], n->head);
    out->sums = s->closed_sums;
    for (int i = 0; i < out->sums; i++) {
        const cagd_closed_sum *sum = &s->closed[i];
        out->sum[i].k = sum->k;
        out->sum[i].a = cagd_in_letters(s, sum->a, n->head, sum->k);
        const char *of_sum = cagd_in_letters(s, sum->R, n->head, sum->k);
        out->sum[i].R = sum->is_polynomial ? NULL : of_sum;
        out->sum[i].G = sum->is_polynomial ? of_sum : NULL;
    }
    return region_faults == 0;
}

/* The last side of the chain that has a closed form without sums, if it has one: then every other side is compared with it; else with its neighbour. */
static int plain_side(const cagd_scope *scope, const cagd_tree *chain, const cagd_variable *n, long low)
{
    cagd_search *s = region_bytes(sizeof *s);
    num_f value;
    for (int i = chain->count - 1; s != NULL && i >= 0; i--) {
        cagd_search_begin(s, scope, n->head, (int)low);
        if (cagd_closed(s, chain->at[i], NULL, &value) && s->closed_sums == 0 && region_faults == 0)
            return i;
        region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    }
    return -1;
}

/* A chain a = b = c: told are the sides that have a sum, each equal to the plain one. */
static int links_hold(const cagd_scope *scope, const cagd_tree *chain, const cagd_variable *n, long low, int checked,
                      cagd_every *out)
{
    static const cagd_relation equal[] = {CAGD_EQUAL};
    const int plain = low > FURTHEST || low < -FURTHEST ? -1 : plain_side(scope, chain, n, low);
    cagd_every *last = NULL;
    for (int i = 0; i + 1 < chain->count; i++)
        if (chain->relation[i] != CAGD_EQUAL)
            return 0;
    for (int i = 0; i < chain->count; i++) {
        const int with = plain >= 0 ? plain : i + 1;
        if (i == plain || with >= chain->count)
            continue;
        cagd_tree *link = cagd_tree_new(CAGD_RELATION, chain->at[i]->from, chain->at[i]->to, 2);
        cagd_every *of_link = region_bytes(sizeof *of_link);
        if (link == NULL || of_link == NULL)
            return 0;
        link->at[0] = chain->at[i], link->at[1] = chain->at[with], link->relation = equal;
        if (!cagd_holds_for_every(scope, link, n, low, checked, of_link))
            return 0;
        of_link->of = link;
        if (of_link->closed && of_link->sums == 0 && of_link->E == NULL)
            continue;
        if (last != NULL)
            last->next = of_link;
        else
            *out = *of_link;
        last = last == NULL ? out : of_link;
    }
    if (last == out) /* there is no other */
        out->of = NULL;
    return last != NULL;
}

/* Several equalities, each by itself. */
static int all_hold(const cagd_scope *scope, const cagd_tree *all, const cagd_variable *n, long low, int checked,
                    cagd_every *out)
{
    cagd_every *last = NULL;
    for (int i = 0; i < all->count; i++) {
        cagd_every *one = i == 0 ? out : region_bytes(sizeof *one);
        if (one == NULL || all->at[i]->kind != CAGD_RELATION ||
            !cagd_holds_for_every(scope, all->at[i], n, low, checked, one))
            return 0;
        if (one->of == NULL)
            one->of = all->at[i];
        if (last != NULL)
            last->next = one;
        for (last = one; last->next != NULL;)
            last = (cagd_every *)last->next;
    }
    return last != NULL;
}

int cagd_holds_for_every(const cagd_scope *scope, const cagd_tree *statement, const cagd_variable *n, long low,
                         int checked, cagd_every *out)
{
    if (statement->kind == CAGD_ALL)
        return all_hold(scope, statement, n, low, checked, out);
    cagd_search *s = region_bytes(sizeof *s);
    struct proof p;
    if (s == NULL)
        return 0;
    if (statement->kind == CAGD_RELATION && statement->count > 2)
        return have_closed_forms(s, scope, statement, n, low, checked, out) ||
               links_hold(scope, statement, n, low, checked, out);
    if (!find_proof(s, scope, statement, n, low, checked, &p))
        return have_closed_forms(s, scope, statement, n, low, checked, out);
    *out = (cagd_every){.order = p.T.order, .from = p.from, .n = n->head, .k = p.sum->head};
    for (int j = 0; j <= p.T.order; j++) /* the n and k of the statement again */
        out->a[j] = cagd_in_letters(s, shifted(p.T.a[j], s->n, -p.by_n), n->head, p.sum->head);
    out->R = cagd_in_letters(s, shifted(shifted(p.T.R, s->k, p.begin_by == 0 ? -p.begin : 0), s->n, -p.by_n), n->head,
                             p.sum->head);
    out->counted = p.begin_by != 0;
    return region_faults == 0;
}

/* ---- as a certificate ---------------------------------------------------------------------------------- */

enum { NEVER_ZERO = 5, MOST_NOTED_FACTORS = 64 };

/* p = rest f_0^e_0 ..., the f being the factors that contain n or k; their number, or -1. */
static int factors_in(const cagd_search *s, num_f p, int room, num_f *rest, num_f f[], int e[])
{
    num_f variable[] = {s->n, s->k};
    int count = 0;
    *rest = p;
    for (int v = 0; v < 2; v++) {
        int found = cagd_factors_f(*rest, variable[v], room - count, f + count, e + count);
        if (found < 0)
            return -1;
        for (int i = 0; i < found; i++, count++)
            *rest = div_f(*rest, cagd_power_f(f[count], e[count]));
    }
    return count;
}

/* The nodes of both sides at `rows` numbers, computed from the names. */
static int note_rows(const cagd_search *s, const cagd_scope *scope, const struct proof *p, const char *n, int rows,
                     int left[], int right[])
{
    cagd_context *c = region_bytes(sizeof *c);
    if (c == NULL)
        return 0;
    *c = (cagd_context){.scope = scope, .in_field = 1, .steps = CAGD_USUAL_STEPS};
    for (int m = 0; m < s->c.count; m++) {
        char name[16];
        snprintf(name, sizeof name, "v%d", m);
        cagd_bind(c, s->c.binding[m].key, (cagd_value){.f = variable_f(name)});
    }
    for (int i = 0; i < rows && region_faults == 0; i++) {
        cagd_binding_of(c, n)->value = cagd_value_constant(from_int_q(p->from + i));
        const cagd_tree *const side[] = {p->whole, p->other};
        for (int k = 0; k < 2; k++) {
            cagd_value v = cagd_evaluate(c, side[k]);
            (k == 0 ? left : right)[i] = v.rational ? cagd_node_of_q(v.q) : cagd_node_of_f(v.f);
        }
    }
    return region_faults == 0;
}

int cagd_note_for_every(const cagd_scope *scope, const cagd_tree *statement, const cagd_variable *n, long low,
                        int checked)
{
    cagd_search *s = region_bytes(sizeof *s);
    struct proof p;
    if (s == NULL || !cagd_trace_noting())
        return 0;
    cagd_trace_pause();
    int found = find_proof(s, scope, statement, n, low, checked, &p), count = 0, counts[NEVER_ZERO];
    const num_f fraction[] = {p.question.F.by_n, p.question.F.by_k, p.question.ratio, p.T.R};
    num_f top[NEVER_ZERO], bottom[NEVER_ZERO], rest[NEVER_ZERO], factor[MOST_NOTED_FACTORS];
    int powers[MOST_NOTED_FACTORS], node[MOST_NOTED_FACTORS];
    for (int i = 0; found && i < NEVER_ZERO; i++) {
        if (i + 1 < NEVER_ZERO)
            top[i] = cagd_numerator_f(fraction[i]), bottom[i] = cagd_denominator_f(fraction[i]);
        else
            bottom[i] = p.T.a[p.T.order];
        counts[i] = factors_in(s, bottom[i], MOST_NOTED_FACTORS - count, &rest[i], factor + count, powers + count);
        found = counts[i] >= 0;
        count += found ? counts[i] : 0;
    }
    cagd_trace_resume();
    int a[CAGD_TELESCOPER_ORDER + 1], of_rest[NEVER_ZERO], left[CAGD_TELESCOPER_ORDER + 2],
        right[CAGD_TELESCOPER_ORDER + 2];
    if (!found || !note_rows(s, scope, &p, n->head, p.T.order + 2, left, right))
        return 0;
    int of_n = cagd_node_of_f(variable_f("vn")), of_k = cagd_node_of_f(variable_f("vk"));
    for (int i = 0; i < count; i++)
        node[i] = cagd_node_of_f(factor[i]);
    for (int i = 0; i < NEVER_ZERO; i++)
        of_rest[i] = cagd_node_of_f(rest[i]);
    for (int j = 0; j <= p.T.order; j++)
        a[j] = cagd_node_of_f(p.T.a[j]);
    int first = cagd_node_of_f(p.question.first);
    static const char *const name[] = {"by_n", "by_k", "ratio", "R"};
    int pair[4][2];
    for (int i = 0; i < 4; i++)
        pair[i][0] = cagd_node_of_f(top[i]), pair[i][1] = cagd_node_of_f(bottom[i]);
    if (region_faults != 0 || !cagd_trace_fact("sum_for_every_n"))
        return 0;
    cagd_trace_put("n", of_n);
    cagd_trace_put("k", of_k);
    for (int i = 0; i < 4; i++)
        cagd_trace_put_list(name[i], 2, pair[i]);
    cagd_trace_put_list("a", p.T.order + 1, a);
    cagd_trace_put("first", first);
    cagd_trace_put("from", p.question.from);
    if (p.question.by > 1) {
        cagd_trace_put("by", p.question.by);
        cagd_trace_put("beyond", p.question.beyond);
    }
    cagd_trace_put_list("left", p.T.order + 2, left);
    cagd_trace_put_list("right", p.T.order + 2, right);
    cagd_trace_put_list("rest", NEVER_ZERO, of_rest);
    cagd_trace_put_list("counts", NEVER_ZERO, counts);
    cagd_trace_put_list("factors", count, node);
    cagd_trace_put_list("powers", count, powers);
    cagd_trace_put("is", 1);
    cagd_trace_fact_end();
    cagd_trace_agree(1, "sum_for_every_n(n)");
    return region_faults == 0;
}
