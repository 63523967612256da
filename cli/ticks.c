#include "cli/ticks.h"

#include "exact/words.h"

#include <math.h>
#include <stdlib.h>

num_q nice_step(double length, int most)
{
    double wanted = length / most;
    int e = (int)floor(log10(wanted));
    for (;; e++)
        for (int k = 0; k < 3; k++) {
            static const long digit[] = {1, 2, 5};
            num_q step = from_int_q(digit[k]), ten = from_int_q(10);
            for (int i = 0; i < abs(e); i++)
                step = e > 0 ? mul_q(step, ten) : div_q(step, ten);
            if (to_double_q(step) >= wanted)
                return step;
        }
}
