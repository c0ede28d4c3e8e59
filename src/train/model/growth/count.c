/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The number of dominoes of a growth r between two heights: the smallest n with first r^n >= height. */
#include "numerics/real.h"

/* Returns true if `first` * r^n >= `height`. If the two sides differ only by rounding errors, they count as
 * equal. */
static bool count_reaches(real first, real height, real r, real ln_r, real n)
{
    /* The user's decimal values of `first`, `height` and r have been rounded. This can change the quotient
     * `first` * r^n / `height` by 2 + n/2 units in the last place, and `slack` allows for this change.
     * `slack` is at most a millionth of ln r, so it is small compared with the relative step from one domino
     * to the next, which is at least ln r. */
    real slack = fmin(ROUNDOFF * (4 + n), (real)1e-6 * ln_r);
#ifdef DOMF /* float is too coarse to compare powers */
    return (double)first * (pow)((double)r, (double)n) >= (double)height * (1 - (double)slack);
#else
    return first * pow(r, n) >= height * (1 - slack);
#endif
}

enum dom_status dom_count_find(dom_real first, dom_real height, dom_real r, struct dom_count *count)
{
    if (dom_arithmetic()->bits == 0)
        return DOM_NO_PRECISION;
    if (!(first > 0 && height > 0 && isfinite(first) && isfinite(height)))
        return DOM_BAD_HEIGHT;
    if (!(r >= 1 && isfinite(r)))
        return DOM_BAD_R;
    real ratio = height / first, ln_r = log1p(r - 1), exact = log(ratio) / ln_r;
    if (r == 1) {
        bool there = ratio <= 1;
        dom_real n = there ? (dom_real)0 : (dom_real)INFINITY;
        *count = (struct dom_count){.dominoes = n, .exact = n, .last = there ? (dom_real)first : DOM_NAN};
        return DOM_OK;
    }
    /* Above 2^REAL_BITS not every integer can be represented. */
    if (!(ratio >= REAL_MIN && isfinite(ratio) && exact < 2 / REAL_EPSILON))
        return DOM_BAD_HEIGHT;
    real error_of_exact =
        ROUNDOFF * (2 / ln_r + 5 * fabs(exact)); /* errors of one division and two logarithms */
    real nearest = fmax(round(exact), 0), n = fmax(ceil(exact), 0);
    if (fabs(exact - nearest) <= error_of_exact + ROUNDOFF * (4 + nearest) / ln_r)
        n = count_reaches(first, height, r, ln_r, nearest) ? nearest : nearest + 1;
    real last = first * pow(r, n);
    *count = (struct dom_count){.dominoes = n, .exact = exact, .last = last};
    return DOM_OK;
}
