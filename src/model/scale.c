/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "domino.h"
#include <float.h>
#include <math.h>

double dom_scale_tau(const struct dom_scale *scale, double d)
{
    return sqrt(scale->h * (1 + d * d) / (3 * scale->g));
}

double dom_scale_speed(const struct dom_scale *scale, const struct dom_train *train, double duration)
{
    double seconds = duration * dom_scale_tau(scale, train->d);
    return (train->s + train->d) * train->r * scale->h / seconds;
}

/* Is first r^n >= height?  Three rounded inputs and a pow: what is closer than that counts as equal. */
static bool tall_enough(double first, double height, double r, double n)
{
    double slack = (n / 2 + 3) * DBL_EPSILON;
    return pow(r, n) >= height / first * (1 - slack);
}

enum dom_status dom_count_find(double first, double height, double r, struct dom_count *count)
{
    if (!(first > 0 && height > 0 && r >= 1 && isfinite(first) && isfinite(height) && isfinite(r)))
        return DOM_BAD_PARAMETER;
    double ratio = height / first, ln_r = log1p(r - 1), exact = log(ratio) / ln_r;
    if (r == 1) {
        bool there = ratio <= 1;
        *count = (struct dom_count){there ? 0 : (double)INFINITY, there ? 0 : (double)INFINITY,
                                    there ? first : DOM_NAN};
        return DOM_OK;
    }
    /* Beyond 2^53 neighbouring integers are one double. */
    if (!(ratio >= DBL_MIN && isfinite(ratio) && exact < 0x1p53))
        return DOM_BAD_PARAMETER;
    double n = fmax(ceil(exact), 0);
    /* The logarithm may be off by rounding at an exact power. */
    if (n > 0 && tall_enough(first, height, r, n - 1))
        n--;
    else if (!tall_enough(first, height, r, n))
        n++;
    *count = (struct dom_count){n, fmax(exact, 0), first * pow(r, n)};
    return DOM_OK;
}
