/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The paper word for word, in plain double: a program without thought for rounding errors, for when to stop,
 * and for where H may have its maximum. It is right for friendly trains; a case for which it is right is not
 * a hard one.
 */
#ifndef HARD_NAIVE_H
#define HARD_NAIVE_H

#include "reference.h"

/* Returns the value; NaN if it finds none. */
double naive_value(const struct ref_input *input, enum ref_quantity quantity);

#endif
