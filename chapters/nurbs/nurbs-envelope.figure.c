/* nurbs-envelope.figure.c -- drawings for nurbs-envelope.claims.h. */
#include "chapters/nurbs/family-figures.h"

FIGURE(nurbs_envelope_families)
{
    svg *s = svg_new("nurbs_envelope_families", "t", "d");
    svg_panel(s, svg_integer_window(0, 0, 1, 1), 100, 0, NULL);
    return s;
}

FIGURE(nurbs_envelope_whole)
{
    svg *s = svg_new("nurbs_envelope_whole", "t", "d");
    svg_panel(s, svg_integer_window(0, 0, 1, 1), 100, 0, NULL);
    return s;
}
