/* knots.h -- what can be wrong with a knot vector. */
#ifndef CAGD_KNOTS_H
#define CAGD_KNOTS_H

typedef enum knot_fault {
    KNOTS_GOOD,
    KNOTS_TOO_FEW,      /* not more points than the degree                    */
    KNOTS_DECREASE,     /* u_i < u_{i-1}                                      */
    KNOTS_TOO_MULTIPLE, /* u_i is the (p+2)-nd knot of one value              */
    KNOTS_NO_DOMAIN     /* u_p = u_n                                          */
} knot_fault;
#endif
