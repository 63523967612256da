#include "exact/kernels_q.h"

#define KERNEL
#define G(name) name##_q
#include "core/kernels/kernels.tmpl.h"
