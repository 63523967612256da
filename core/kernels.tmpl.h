/* kernels.tmpl.h -- all kernels for one number type, each file after those it stands on. */

/* clang-format off */
#include "core/bernstein.tmpl.h"
#include "core/bezier.tmpl.h"
#include "core/rational.tmpl.h"
#include "core/differential.tmpl.h"
#include "core/bezier_surface.tmpl.h"
#include "core/conic.tmpl.h"
#include "core/determinant.tmpl.h"
#include "core/bspline.tmpl.h"
#include "core/nurbs.tmpl.h"
#include "core/nurbs_parameters.tmpl.h"
#include "core/power.tmpl.h"
#include "core/cubic_shape.tmpl.h"
#include "core/divided.tmpl.h"
#include "core/hermite.tmpl.h"
#include "core/coons.tmpl.h"
#include "core/bspline_matrix.tmpl.h"
#include "core/shape_parameter.tmpl.h"
/* clang-format on */
