#include "chapters/frame/figure.h"
#include "figures/svg.h"
FIGURE(local_control) { return svg_new("a", "stub", "stub"); }
FIGURE(nurbs_circle) { return svg_new("a", "stub", "stub"); }
FIGURE(recursion_steps) { return svg_new("a", "stub", "stub"); }
FIGURE(nurbs_definition) { return svg_new("a", "stub", "stub"); }
FIGURE(missing_end) { return svg_new("a", "stub", "stub"); }
FIGURE(idle_point) { return svg_new("a", "stub", "stub"); }
FIGURE(bezier_knots) { return svg_new("a", "stub", "stub"); }
FIGURE(deboor_triangle) { return svg_new("a", "stub", "stub"); }
FIGURE(wrong_interval) { return svg_new("a", "stub", "stub"); }
FIGURE(nurbs_polygons_converge) { return svg_new("a", "stub", "stub"); }
FIGURE(insertions_commute) { return svg_new("a", "stub", "stub"); }
FIGURE(insertion_to_the_curve) { return svg_new("a", "stub", "stub"); }
FIGURE(no_convergence) { return svg_new("a", "stub", "stub"); }
