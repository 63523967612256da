/* kernels_f.h -- the kernels on rational functions in named variables; compiled once, in kernels_f.c. */
#ifndef CAGD_KERNELS_F_H
#define CAGD_KERNELS_F_H

#include "core/number/binomial.h"
#include "exact/number/field.h"
#include "exact/words.h"

#include <stddef.h>

#define G(name) name##_f
#include "core/kernels/spline_type.tmpl.h"

#include "core/kernels/net_type.tmpl.h"
#include "core/kernels/span_type.tmpl.h"
#undef G

#include "generated/kernels/f.h"
#endif
