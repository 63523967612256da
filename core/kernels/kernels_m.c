#include "core/kernels/kernels_m.h"

#define KERNEL
#define G(name) name##_m
#include "core/kernels/kernels.tmpl.h"
