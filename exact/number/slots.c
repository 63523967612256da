#include "exact/number/slots.h"

#include "exact/decide/polynomial_slot.h"
#include "exact/number/field.h"
#include "exact/number/field_slot.h"
#include "exact/number/interval.h"
#include "exact/number/rational.h"

static void rational_init(void *p) { mpq_init(p); }
static void rational_clear(void *p) { mpq_clear(p); }

static void interval_init(void *p)
{
    struct interval *x = p;
    mpfr_inits2(INTERVAL_PRECISION, x->lo, x->hi, (mpfr_ptr)0);
}
static void interval_clear(void *p)
{
    struct interval *x = p;
    mpfr_clears(x->lo, x->hi, (mpfr_ptr)0);
}

const struct slot_ops slot_ops[SLOT_KINDS] = {
    [SLOT_RATIONAL] = {sizeof(__mpq_struct), rational_init, rational_clear, 1},
    [SLOT_INTERVAL] = {sizeof(struct interval), interval_init, interval_clear, 1},
    [SLOT_FIELD] = {sizeof(struct field_element), field_slot_init, field_slot_clear, 0},
    [SLOT_POLYNOMIAL] = {sizeof(struct polynomial), polynomial_slot_init, polynomial_slot_clear, 0},
};

void exact_thread_end(void)
{
    region_free_all();
    field_close();
    mpfr_free_cache();
    flint_cleanup();
}
