#include "exact/thread_end.h"

#include "exact/num_field.h"
#include "exact/region.h"

#include <flint/flint.h>
#include <mpfr.h>

void exact_thread_end(void)
{
    region_free_all();
    field_close();
    mpfr_free_cache();
    flint_cleanup();
}
