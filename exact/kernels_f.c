#include "exact/kernels_f.h"

#define KERNEL
#define G(name) name##_f
#include "core/kernels/kernels.tmpl.h"
