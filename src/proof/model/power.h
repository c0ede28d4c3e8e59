/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_PROOF_POWER_H
#define DOM_PROOF_POWER_H

#include "proof/model/span.h"

/* Returns x^q for x >= 1 and q > 0. Integers q up to 64 need only multiplications. */
struct span span_power(struct span x, struct span q);

/* Returns ln x for x >= 1. */
struct span span_log(struct span x);

/* Returns e^x for 0 <= x <= 700. */
struct span span_exp(struct span x);

#endif
