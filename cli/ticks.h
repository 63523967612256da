/* ticks.h -- the steps of the ticks of axes. */
#ifndef CLI_TICKS_H
#define CLI_TICKS_H

#include "exact/number/rational.h"

/* 1, 2 or 5 times a power of ten: the smallest step of which at most `most` fit into the length, which is positive. */
cagd_num_q nice_step(double length, int most);
#endif
