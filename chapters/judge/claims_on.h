/* claims_on.h -- open the generic text of a chapter: the arithmetic words and the judge's. */
#include "core/number/generic_on.h"
#define unknown      G(unknown)
#define positive     G(positive)
#define parameter    G(parameter)
#define whole(...)   G(whole)(__VA_ARGS__)
#define inside(...)  G(inside)(__VA_ARGS__) /* `inside` is also a member of struct cagd_hull_certificate */
#define same         G(same)
#define vanishes     G(vanishes)
#define nonnegative  G(nonnegative)
#define show         G(show)
#define show_points  G(show_points)
#define given(...)   G(given)(__VA_ARGS__)
#define given_points G(given_points)
#define found(...)   G(found)(__VA_ARGS__) /* and `found` of many searches */
#define found_points G(found_points)
