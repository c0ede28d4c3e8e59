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
    /*
     * A power that meets the height: the typed heights and r are rounded decimals, which moves exact by
     * the slack.  Where that is no small part of one domino, the doubles count as they are.
     */
    double slack = fmin(DBL_EPSILON * ((2 + fabs(exact) / 2) / ln_r + 2 * fabs(exact)), 1e-6);
    double nearest = round(exact), n = fmax(fabs(exact - nearest) <= slack ? nearest : ceil(exact), 0);
    *count = (struct dom_count){n, exact, first * pow(r, n)};
    return DOM_OK;
}
