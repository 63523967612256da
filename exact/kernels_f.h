/* kernels_f.h -- the kernels on rational functions in named variables. */
#ifndef CAGD_KERNELS_F_H
#define CAGD_KERNELS_F_H

#include "exact/number/field.h"
#include "exact/words.h"

#define G(name) name##_f
#include "core/kernels/kernels.tmpl.h"
#undef G
#endif
