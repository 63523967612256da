#include "exact/kernels_i.h"

#define KERNEL
#define G(name) name##_i
#include "core/kernels/kernels.tmpl.h"
