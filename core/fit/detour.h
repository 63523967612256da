#ifndef CAGD_FIT_DETOUR_H
#define CAGD_FIT_DETOUR_H

#include "core/fit/cagd_fit.h"

/* Where the curve makes a detour between two neighbouring feet that no points show: its length over their chord, how much longer than that it is, and
 * between which parameters.  length 0: nowhere. */
typedef struct fit_detour {
    double length, excess, from, to;
} fit_detour;

/* The length of a curve whose tangents keep within an angle phi is 1/cos(phi/2) times its chord at most.  phi is the angle by which the chords of the
 * feet turn from the one before over this one to the one behind; so two neighbours on the two sides of a sharp nose (机翼前缘), of a corner, or of a place
 * where the points go forth and back, say nothing.  A detour is more than CAGD_FIT_LONGEST_RATIO times as long as that, as a curve is of the whole polygon (cagd_fit_length_ratio), and ten times the root mean square of
 * the distances longer; of several the one with the largest excess.  closed: of the last foot and the first one the neighbours go over the seam.
 * OK, NO_MEMORY. */
cagd_status fit_detour_of(const cagd_fit_result *result, int closed, fit_detour *detour);
#endif
