/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "growth.h"
#include "sketch.h"

static struct ref *open_at(const struct ref_input *input, bool pair, int digits2, domq_real r)
{
    struct ref_input at = *input;
    at.r = r;
    at.tilt = 0;
    return pair ? ref_open_pair(&at, digits2) : ref_open_for(&at, digits2);
}

double growth_margin(const struct ref_input *input, bool pair, int digits2, domq_real r)
{
    struct ref *ref = open_at(input, pair, digits2, r);
    double margin = ref_double(ref, REF_MARGIN);
    margin /= ref_double(ref, REF_KINETIC) + ref_double(ref, REF_BARRIER);
    ref_close(ref);
    return margin;
}

/*
 * Returns dr = M / (dM/dr). The derivatives of the reference are with respect to u = 1 - r s, and to r at
 * constant r s. Here they are converted to derivatives with respect to s at constant r, and to r at constant
 * s.
 */
double growth_error(const struct ref_input *input, bool pair, int digits2, domq_real r, double *scale)
{
    struct ref *ref = open_at(input, pair, digits2, r);
    double u = mpfr_get_d(ref->u, MPFR_RNDN), part = fmin(1, u / (1 - u)), r_ = (double)r;
    double by_s = ref_change(ref, REF_MARGIN, REF_S) / part;
    double by_r = ref_change(ref, REF_MARGIN, REF_R) + by_s;
    double others = fabs(ref_change(ref, REF_MARGIN, REF_D)) + fabs(ref_change(ref, REF_MARGIN, REF_Q));
    double own = ref_double(ref, REF_KINETIC) + ref_double(ref, REF_BARRIER);
    double error = ref_double(ref, REF_MARGIN) / by_r * r_;
    *scale = r_ * fmax(1, (fabs(by_s) + others + own) / fabs(by_r));
    ref_close(ref);
    return error;
}

/* Returns true if the train keeps falling. No train keeps falling beyond the reach. */
static bool margin_is_good(const struct ref_input *input, bool pair, int digits2, domq_real r)
{
    return r * input->s < 1 && growth_margin(input, pair, digits2, r) >= 0;
}

/* At first, the bracket is at most eight times as wide as the distance. So the distance is found to a
 * relative 1e-4, less than the slack of the comparison with quad. */
enum { HALVINGS = 16 };

double growth_distance(const struct ref_input *input, bool pair, int digits2, domq_real r, double delta)
{
    domq_real lo = r, hi = r;
    for (; delta < (double)r - 1; delta *= 4) {
        lo = r - (domq_real)delta;
        hi = r + (domq_real)delta;
        if (margin_is_good(input, pair, digits2, lo) && !margin_is_good(input, pair, digits2, hi))
            break;
    }
    for (int k = 0; k < HALVINGS; k++) {
        domq_real middle = lo + (hi - lo) / 2;
        *(margin_is_good(input, pair, digits2, middle) ? &lo : &hi) = middle;
    }
    domq_real error = r - (lo + (hi - lo) / 2);
    return (double)(error < 0 ? -error : error);
}
