/* search.h -- what searches over knots and smoothing terms have in common: what is sought, the fits on the way, and which one is best.
 *
 * The smaller the score the better.  Without a tolerance it is Schwarz's criterion for few points (candidate.h), and of a curve that is not good
 * higher by what is very strong evidence.  With one, eps: the largest distance as long as that is more than eps, then the number of knots. */
#ifndef CAGD_FIT_SEARCH_H
#define CAGD_FIT_SEARCH_H

#include "core/fit/cagd_fit.h"
#include "core/fit/knots.h"

enum {
    FIT_MOST_WORK = 4000000, /* points times the square of knots, up to which knots are taken out one by one */
    FIT_FIGURE = CAGD_FIT_EXCURSIONS | CAGD_FIT_LOOPS |
                 CAGD_FIT_GAPS /* what is not good about a curve alone, not about control points and feet */
};

/* What a curve is passed over for: FIT_FIGURE, or a cusp as well. */
enum { FIT_NO_FIGURE = 1, FIT_NO_CUSP };

typedef struct fit_search {
    const cagd_fit_data *data;
    const cagd_fit_options *options;
    const cagd_fit_choices *choices;
    int *where;
    int *without_memory; /* becomes 1 where there was not enough to look at a fit */
    cagd_fit_result *best;
    double within;  /* with a tolerance, the distance that every point is to keep within       */
    int good_alone; /* with a tolerance, whether a minimum that is not good or has loops is passed over too */
    int shapely;    /* what a curve is passed over for: nothing, or one of the two above    */
    int detours; /* whether a detour between two neighbours, all that excursions of a good curve are, counts on the way */
    int scattered; /* how many neighbours it takes until points do not scatter by more than they are apart, see means.h */
    int dense;     /* with a tolerance, whether segments and degrees of freedom may be as few as they can */
    double score;
    fit_knots at; /* of the best one */
} fit_search;

/* ---- fits on the way ------------------------------------------------------------------------------------- */

/* A fit among many, without intervals by the profile, which takes much longer than one that will not converge is worth. */
cagd_status fit_search_fit(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result,
                           int *where);

/* The spline on these knots, from the one before if there is one. */
cagd_status fit_search_over(const fit_search *s, const fit_knots *k, const cagd_fit_result *from,
                            cagd_fit_result **result);

/* Whether a curve with so many unknowns leaves half of the equations, of a dense one whether there are as many equations. */
int fit_search_has_room(const fit_search *s, const fit_knots *k);

/* Inner knots that a curve has at least. */
int fit_search_fewest_knots(const fit_search *s);

/* The sum of 1/sigma^2, by which the weight of a smoothing term is measured. */
double fit_precision_of(const cagd_fit_data *data);

/* ---- which one is best ----------------------------------------------------------------------------------- */

/* What is not good about a fit; all of it where it is no minimum or has excursions. */
int fit_search_problems(const fit_search *s, const cagd_fit_result *r);

/* A good fit that crosses itself no more often than its points do. */
int fit_search_has_no_loops(const fit_search *s, const cagd_fit_result *r);

/* Whether the curve has no excursions, loops and gaps and, if that is asked, does not turn back as at a cusp. */
int fit_search_is_shapely(const fit_search *s, const cagd_fit_result *r, int cusp_too);

/* Whether the fit is one that the search may end with. */
int fit_search_may_be_best(const fit_search *s, const cagd_fit_result *r);

/* Whether it keeps every point within the distance that is asked for. */
int fit_search_is_within(const fit_search *s, const cagd_fit_result *r);

/* The score; infinite of what may not be best. */
double fit_search_score(const fit_search *s, const fit_knots *k, const cagd_fit_result *r);

/* Takes knots and score for those of the best one if the fit is it; whether it is.  Neither it nor the one before is released, and s->best stays. */
int fit_search_is_best(fit_search *s, const fit_knots *k, const cagd_fit_result *r);
#endif
