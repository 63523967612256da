/* kernels.tmpl.h -- all kernels for one number type, each file after those it stands on. */

/* clang-format off */
#include "core/kernels/bernstein.tmpl.h"
#include "core/kernels/bezier.tmpl.h"
#include "core/kernels/rational.tmpl.h"
#include "core/kernels/differential.tmpl.h"
#include "core/kernels/bezier_surface.tmpl.h"
#include "core/kernels/conic.tmpl.h"
#include "core/kernels/determinant.tmpl.h"
#include "core/kernels/bspline.tmpl.h"
#include "core/kernels/nurbs.tmpl.h"
#include "core/kernels/nurbs_parameters.tmpl.h"
#include "core/kernels/power.tmpl.h"
#include "core/kernels/cubic_shape.tmpl.h"
#include "core/kernels/divided.tmpl.h"
#include "core/kernels/hermite.tmpl.h"
#include "core/kernels/coons.tmpl.h"
#include "core/kernels/bspline_matrix.tmpl.h"
#include "core/kernels/shape_parameter.tmpl.h"
/* clang-format on */
