/* generic_off.h -- close the section opened by generic_on.h. */
#undef spline
#undef nurbs
#undef num
#undef add
#undef sub
#undef mul
#undef div
#undef neg
#undef from_int
#undef from_ratio
#undef root
