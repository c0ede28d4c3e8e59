/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far a head reaches, for the kernels and for the public API (`real` is dom_real there). */
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
