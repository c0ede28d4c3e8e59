/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes how far a head reaches. The kernels and the public API share this function. In the API, `real` is
 * dom_real. */
#ifndef DOM_REACH_H
#define DOM_REACH_H

#include "numerics/real.h"

/* Returns the largest gap that a head with edges of radius rho can reach across. Both lengths are in units of
 * the head's height. */
KERNEL real reach_span(real rho)
{
    return 1 - 2 * rho + rho * PI / 2;
}

#endif
