/* loss.h -- the losses rho of cagd_fit.h and their derivatives. */
#ifndef CAGD_FIT_LOSS_H
#define CAGD_FIT_LOSS_H

#include "core/fit/cagd_fit.h"

/* rho, rho', rho'' at s >= 0: value[0], value[1], value[2]. */
void fit_loss(cagd_fit_loss loss, double scale, double s, double value[3]);
#endif
