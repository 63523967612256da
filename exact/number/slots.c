#include "exact/number/slots.h"

#include "exact/number/field.h"
#include "exact/number/field_slot.h"
#include "exact/number/interval.h"
#include "exact/number/polynomial_slot.h"
#include "exact/number/rational.h"
#include "exact/words.h"

static void rational_init(void *p) { mpq_init(p); }
static void rational_clear(void *p) { mpq_clear(p); }

static void interval_init(void *p)
{
    struct cagd_interval *x = p;
    mpfr_inits2(cagd_region_precision(), x->lo, x->hi, (mpfr_ptr)0);
}
static void interval_clear(void *p)
{
    struct cagd_interval *x = p;
    mpfr_clears(x->lo, x->hi, (mpfr_ptr)0);
}

const struct cagd_slot_ops cagd_slot_ops[SLOT_KINDS] = {
    [SLOT_RATIONAL] = {sizeof(__mpq_struct), rational_init, rational_clear, 1},
    [SLOT_INTERVAL] = {sizeof(struct cagd_interval), interval_init, interval_clear, 1},
    [SLOT_FIELD] = {sizeof(struct cagd_field_element), cagd_field_slot_init, cagd_field_slot_clear, 0},
    [SLOT_POLYNOMIAL] = {sizeof(struct cagd_polynomial), cagd_polynomial_slot_init, cagd_polynomial_slot_clear, 0},
};

void cagd_thread_end(void)
{
    region_free_all();
    field_close();
    mpfr_free_cache();
    flint_cleanup();
}
