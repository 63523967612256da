/* strategy.h -- the numbers that say how the minimum is reached and have no part in where it is.
 *
 * Halved or doubled, each of them leads to the same minimum; test_fit tries that.  What decides about a result, the last feet, the
 * last steps and the rank, is bounded by the precision of binary64, where it is computed. */
#ifndef CAGD_FIT_STRATEGY_H
#define CAGD_FIT_STRATEGY_H

#include "core/fit/cagd_fit.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fit_strategy {
    double nearly; /* Ceres hands over to Newton when a step gains less than this part of the cost            */
    double
        rough; /* on the way feet are taken from Taylor's polynomial over this part of the length on which the curve changes */
    int enough;     /* so many points for each unknown suffice to come near                                    */
    int times;      /* so many times as many means of points know the minimum nearly as well as all points do  */
    int anchors;    /* so many points say on which sides of a polygon the others have their feet               */
    int sides;      /* no side of that polygon is longer than one over this of the whole                       */
    int guesses;    /* so many uneven weights are tried where no curve is given,                               */
    int steps;      /* with at most so many steps each,                                                        */
    double spread;  /* between one over this and this,                                                         */
    double telling; /* to where the unknowns can take away no more than this part of the residuals             */
    int groups;     /* the chords of points that no curve is given for are those of so many means              */
    int rounds;     /* so often the points of the curve and the feet are found in turn before weights move       */
    int more;       /* so many starts more are made when none comes to a minimum                               */
} fit_strategy;

/* What cagd_fit does. */
extern const fit_strategy fit_usual_strategy;

/* cagd_fit by another strategy. */
cagd_status fit_with_strategy(const cagd_fit_data *data, const cagd_fit_options *options, const fit_strategy *strategy,
                              cagd_fit_result **result, int *where);

#ifdef __cplusplus
}
#endif
#endif
