/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rounding to decimals, so that results are short enough to type. */
#pragma once

#include <math.h>

/* Returns the place value of one digit of `value`. If places = 0, this is the first significant digit. If
 * places = 1, it is the next digit, and so on. For example, digit_of(250, 1) is 10. */
static inline double digit_of(double value, int places)
{
    return pow(10, floor(log10(value)) - (double)places);
}

/* Returns units * step, where `units` is a whole number. If the step is a decimal such as 0.003, the product
 * is the double nearest to the exact product, so it can be written with few digits. */
static inline double multiple_of(double units, double step)
{
    double scale = 1;
    while (fabs(round(step * scale) - step * scale) > 1e-12 * step * scale && scale < 1e22)
        scale *= 10;
    return units * round(step * scale) / scale;
}
