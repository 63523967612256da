/* kernels_i.h -- the kernels on intervals. */
#ifndef CAGD_KERNELS_I_H
#define CAGD_KERNELS_I_H

#include "exact/number/interval.h"
#include "exact/words.h"

#define G(name) name##_i
#include "core/kernels/kernels.tmpl.h"
#undef G
#endif
