/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The paper taken at its word, in plain double: what a program is before anybody has thought about
 * rounding, about when to stop, and about where H may have its maximum.  On friendly trains it is right;
 * a case that it gets right is not a hard one.
 */
#ifndef HARD_NAIVE_H
#define HARD_NAIVE_H

#include "reference.h"

/* NaN where it finds none. */
double naive_value(const struct ref_input *input, enum ref_quantity quantity);

#endif
