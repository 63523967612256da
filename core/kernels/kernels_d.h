/* kernels_d.h -- the kernels on binary64. */
#ifndef CAGD_KERNELS_D_H
#define CAGD_KERNELS_D_H

#include "core/number/num_double.h"

#define G(name) name##_d
#include "core/kernels/kernels.tmpl.h"
#undef G
#endif
