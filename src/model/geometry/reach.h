/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far a head reaches. The kernels include this header, and so does the public API, with dom_real as
 * `real`. */
#ifndef DOM_REACH_H
#define DOM_REACH_H

#include "numerics/real.h"

/* Returns the largest gap that a head with edges of radius rho reaches. Both lengths are relative to the
 * height of the head. */
KERNEL real reach_span(real rho)
{
    return 1 - 2 * rho + rho * PI / 2;
}

#endif
