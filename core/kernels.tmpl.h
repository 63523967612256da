/* kernels.tmpl.h -- all kernels for one number type, each file after those it stands on. */

/* A degree is never negative, so every loop that fills a workspace runs; gcc cannot know that. */
#if defined __GNUC__ && !defined __clang__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
/* clang-format off */
#include "core/bernstein.tmpl.h"
#include "core/bezier.tmpl.h"
#include "core/rational.tmpl.h"
#include "core/differential.tmpl.h"
#include "core/conic.tmpl.h"
#include "core/determinant.tmpl.h"
/* clang-format on */
#if defined __GNUC__ && !defined __clang__
#pragma GCC diagnostic pop
#endif
