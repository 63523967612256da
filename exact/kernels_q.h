/* kernels_q.h -- the kernels on rationals. */
#ifndef CAGD_KERNELS_Q_H
#define CAGD_KERNELS_Q_H

#include "exact/number/rational.h"
#include "exact/words.h"

#define G(name) name##_q
#include "core/kernels/kernels.tmpl.h"
#undef G
#endif
