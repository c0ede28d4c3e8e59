/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerics/real.h"

KERNEL enum dom_status count_find(dom_real first_, dom_real height_, dom_real r_, struct dom_count *count,
                                  struct dom_count *error)
{
    real first = (real)first_, height = (real)height_, r = (real)r_;
    if (!(first > 0 && height > 0 && r >= 1 && isfinite(first) && isfinite(height) && isfinite(r)))
        return DOM_BAD_PARAMETER;
    real ratio = height / first, ln_r = log1p(r - 1), exact = log(ratio) / ln_r;
    struct dom_count none = {.dominoes = 0, .exact = 0, .last = 0};
    if (r == 1) {
        bool there = ratio <= 1;
        dom_real n = there ? (dom_real)0 : (dom_real)INFINITY;
        *count = (struct dom_count){n, n, there ? (dom_real)first : DOM_NAN};
        if (error)
            *error = none;
        return DOM_OK;
    }
    /* Beyond 2^(REAL_BITS) neighbouring integers are one number. */
    if (!(ratio >= REAL_MIN && isfinite(ratio) && exact < 2 / REAL_EPSILON))
        return DOM_BAD_PARAMETER;
    /*
     * A power that meets the height: the typed heights and r are rounded decimals, which moves exact by
     * the slack.  Where that is no small part of one domino, the numbers count as they are.
     */
    real slack = REAL_EPSILON * ((2 + fabs(exact) / 2) / ln_r + 2 * fabs(exact));
    real nearest = round(exact), snap = fmin(slack, (real)1e-6);
    real n = fmax(fabs(exact - nearest) <= snap ? nearest : ceil(exact), 0), last = first * pow(r, n);
    *count = (struct dom_count){n, exact, last};
    if (error) /* a division and a logarithm each; the power */
        *error = (struct dom_count){
            .dominoes = 0,
            .exact = UNIT * (2 / ln_r + 5 * fabs(exact)),
            .last = 4 * UNIT * last,
        };
    return DOM_OK;
}
