/* strategy.h -- the numbers that say how the minimum is reached and have no part in where it is.
 *
 * Halved or doubled, each of them leads to the same minimum; test_fit tries that.  What decides about a result is the
 * last feet, the last steps and the rank; these are bounded by the precision of binary64, and not by any number that
 * stands here. */
#ifndef CAGD_FIT_STRATEGY_H
#define CAGD_FIT_STRATEGY_H

#include "core/fit/cagd_fit.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fit_strategy {
    /* The first curve, where none is given (initial.h, starts.h). */
    int chord_groups;      /* parameters follow the chords between the centres of so many groups of points        */
    int alternations;      /* so many times the points of the curve and the feet are found in turn                 */
    int guesses;           /* so many sets of random weights are tried beside the even ones                        */
    double weight_spread;  /* random weights lie between 1/weight_spread and weight_spread                         */
    int guess_steps;       /* each guess is given so many steps                                                    */
    double guess_accuracy; /* a guess is left when the decrement is this part of the residuals                    */
    int extra_starts;      /* so many starts are added when none of those asked for comes to a minimum            */
    /* The way to the minimum (approach.h, descend.h). */
    int points_per_unknown; /* the first approach takes so many points for each unknown                           */
    int means_factor;       /* the second one takes so many times as many means of points                         */
    double handover;        /* Newton's steps begin when a step of Ceres gains less than this part of the cost    */
    double taylor_reach;    /* before that, a foot is taken from Taylor's polynomial when it is no farther than   */
                            /* this part of the length on which the curve changes                                 */
    int intervals; /* whether intervals by the profile of the cost are sought at the end (profile.h)              */
    /* The search for feet (feet.h). */
    int anchors; /* the order of the points is kept for so many of them                                           */
    int sides;   /* the polygon in the place of the curve has at least so many sides; of points in no order,       */
                 /* which nothing but their distance tells where they belong, twice as many                       */
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
