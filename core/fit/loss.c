#include "core/fit/loss.h"

#include <math.h>

void fit_loss(cagd_fit_loss loss, double scale, double s, double value[3])
{
    double a = scale, root = sqrt(s), ratio = 1 + s / (a * a);
    switch (loss) {
    case CAGD_FIT_HUBER:
        if (root > a) {
            value[0] = 2 * a * root - a * a;
            value[1] = a / root;
            value[2] = -a / (2 * s * root);
            return;
        }
        break;
    case CAGD_FIT_CAUCHY:
        value[0] = a * a * log1p(s / (a * a));
        value[1] = 1 / ratio;
        value[2] = -1 / (a * a * ratio * ratio);
        return;
    case CAGD_FIT_SQUARES:
        break;
    }
    value[0] = s;
    value[1] = 1;
    value[2] = 0;
}
