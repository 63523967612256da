#include "exact/expression/value.h"

#include "exact/number/recorder.h"
#include "exact/words.h"

cagd_value cagd_value_q(num_q q) { return (cagd_value){.rational = 1, .q = q}; }
cagd_value cagd_value_constant(num_q q)
{
    if (!cagd_noting())
        return cagd_value_q(q);
    num_q copy = from_mpq_q(q.at);
    cagd_recorder->literal(copy.at, "c", 1, &copy);
    return cagd_value_q(copy);
}
cagd_value cagd_value_int(long m) { return cagd_value_q(from_int_q(m)); }

cagd_value cagd_value_f(num_f f)
{
    num_q q;
    if (region_faults != 0)
        return cagd_value_int(0);
    if (!is_constant_f(f, &q))
        return (cagd_value){.f = f};
    if (cagd_noting()) /* the number is what the function was made of */
        cagd_recorder->alias(q.at, cagd_node_of_f(f));
    return cagd_value_q(q);
}

num_f cagd_in_field(cagd_value a) { return a.rational ? from_rational_f(a.q) : a.f; }

/* Products of numbers of more words, or of more coefficients, are not computed. */
static const long most_words = 2000000;

static long words(cagd_value a)
{
    if (!a.rational)
        return cagd_words_f(a.f);
    return (long)(mpz_size(mpq_numref(a.q.at)) + mpz_size(mpq_denref(a.q.at)));
}

/* Whether the two are small enough; UNABLE. */
static int fit(cagd_value a, cagd_value b)
{
    if (region_faults == 0 && words(a) * words(b) > most_words)
        region_faults |= FAULT_UNABLE;
    return region_faults == 0;
}

cagd_value cagd_value_add(cagd_value a, cagd_value b)
{
    if (!fit(a, b))
        return cagd_value_int(0);
    if (a.rational && b.rational)
        return cagd_value_q(add_q(a.q, b.q));
    return cagd_value_f(add_f(cagd_in_field(a), cagd_in_field(b)));
}
cagd_value cagd_value_sub(cagd_value a, cagd_value b)
{
    if (!fit(a, b))
        return cagd_value_int(0);
    if (a.rational && b.rational)
        return cagd_value_q(sub_q(a.q, b.q));
    return cagd_value_f(sub_f(cagd_in_field(a), cagd_in_field(b)));
}
cagd_value cagd_value_mul(cagd_value a, cagd_value b)
{
    if (!fit(a, b))
        return cagd_value_int(0);
    if (a.rational && b.rational)
        return cagd_value_q(mul_q(a.q, b.q));
    return cagd_value_f(mul_f(cagd_in_field(a), cagd_in_field(b)));
}
cagd_value cagd_value_div(cagd_value a, cagd_value b)
{
    if (!fit(a, b))
        return cagd_value_int(0);
    if (a.rational && b.rational)
        return cagd_value_q(div_q(a.q, b.q));
    return cagd_value_f(div_f(cagd_in_field(a), cagd_in_field(b)));
}

int cagd_value_is_zero(cagd_value a) { return a.rational && cagd_is_zero_q(a.q); }

int cagd_value_is_whole(cagd_value a, long *m)
{
    if (!a.rational || !cagd_is_whole_q(a.q) || !mpz_fits_slong_p(mpq_numref(a.q.at)))
        return 0;
    *m = mpz_get_si(mpq_numref(a.q.at));
    return 1;
}
