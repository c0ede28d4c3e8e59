/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The answers of the reference: values, which are computed when they are first needed, errors, and the scale
 * of errors. */
#include "reference.h"

#include <stdlib.h>

#define N MPFR_RNDN

const char *ref_name(enum ref_quantity quantity)
{
    static const char *const names[] = {
#define REF_NAME(NAME, name) name,
        REF_QUANTITIES(REF_NAME)
#undef REF_NAME
    };
    return names[quantity];
}

/* Finds the launch of a pair: domino 1 just tips over and hits domino 0, w_1 = sqrt(1 + d^2) - h(theta_c),
 * (9; b5) and (15; b11). */
static void find_pair_launch(struct ref *ref)
{
    mpfr_ptr w = ref->value[REF_LAUNCH_OMEGASQ], K = ref->value[REF_KINETIC];
    mpfr_srcptr d = ref->in[REF_D], r = ref->in[REF_R];
    mpfr_t k, t, x;
    mpfr_set_nan(w);
    mpfr_set_nan(K);
    if (!mpfr_less_p(ref->theta_u, ref->theta_c))
        return;
    mpfr_inits2(ref->bits, k, t, x, (mpfr_ptr)0);
    mpfr_div(k, ref->rq, r, N);
    mpfr_sin_cos(t, x, ref->theta_c, N);
    mpfr_mul(t, t, d, N);
    mpfr_add(t, t, x, N);
    mpfr_sqr(w, d, N);
    mpfr_add_ui(w, w, 1, N);
    mpfr_sqrt(w, w, N);
    mpfr_sub(w, w, t, N);
    mpfr_mul(w, w, r, N);
    mpfr_add_ui(x, k, 1, N);
    mpfr_div(k, k, x, N);
    mpfr_mul(w, w, k, N);
    mpfr_mul(w, w, k, N);
    mpfr_mul(K, w, x, N);
    mpfr_clears(k, t, x, (mpfr_ptr)0);
}

/* Finds w = P T / (J0 (r^q J0 - T)), J0 = 1 + T (24; c6). */
static void find_launch(struct ref *ref)
{
    if (ref->dominoes == 2) {
        find_pair_launch(ref);
        return;
    }
    mpfr_srcptr P = ref->paper ? ref->fuel_paper : ref->fuel_exact;
    mpfr_ptr w = ref->value[REF_LAUNCH_OMEGASQ], K = ref->value[REF_KINETIC];
    mpfr_set_nan(w);
    mpfr_set_nan(K);
    if (mpfr_sgn(P) <= 0)
        return;
    mpfr_t J0, t;
    mpfr_inits2(ref->bits, J0, t, (mpfr_ptr)0);
    mpfr_add_ui(J0, ref->T, 1, N);
    mpfr_div(t, J0, ref->rq, N);
    mpfr_sub(t, t, ref->T, N);
    mpfr_mul(K, P, ref->T, N);
    mpfr_div(K, K, t, N);
    mpfr_div(w, K, J0, N);
    mpfr_clears(J0, t, (mpfr_ptr)0);
}

static void find_train_values(struct ref *ref)
{
    mpfr_t *v = ref->value;
    mpfr_set(v[REF_THETA_C], ref->theta_c, N);
    mpfr_set(v[REF_THETA_U], ref->theta_u, N);
    mpfr_set(v[REF_THETA_INF], ref->theta_inf, N);
    mpfr_set(v[REF_THETA_F], ref->theta_f, N);
    mpfr_set(v[REF_THETA_LEAVE], ref->theta_leave, N);
    mpfr_set(v[REF_FUEL_EXACT], ref->fuel_exact, N);
    mpfr_set(v[REF_FUEL_PAPER], ref->fuel_paper, N);
    mpfr_add_ui(v[REF_J0], ref->T, 1, N);
    find_launch(ref);
    for (int k = 0; k <= REF_KINETIC; k++)
        ref->known[k] |= k <= REF_THETA_LEAVE || k >= REF_J0;
}

/* Finds omega^2 by (21; c3). The result is negative if the head does not reach the tilt. */
static void find_omegasq(struct ref *ref)
{
    mpfr_ptr w = ref->value[REF_OMEGASQ];
    mpfr_sub(w, ref_value(ref, REF_KINETIC), ref_value(ref, REF_DH), N);
    mpfr_div(w, w, ref->value[REF_J], N);
    ref->known[REF_OMEGASQ] = true;
}

static void find(struct ref *ref, enum ref_quantity quantity)
{
    if (quantity >= REF_THETA_1 && quantity <= REF_J)
        ref_walk_at_tilt(ref);
    else if (quantity <= REF_KINETIC)
        find_train_values(ref);
    else if (quantity <= REF_MARGIN)
        ref_find_barrier(ref);
    else if (quantity == REF_OMEGASQ)
        find_omegasq(ref);
    else if (quantity == REF_STOP)
        ref_find_stop(ref);
    else if (quantity == REF_DURATION)
        ref_find_duration(ref);
    else
        abort(); /* see the functions for growths */
}

mpfr_srcptr ref_value(struct ref *ref, enum ref_quantity quantity)
{
    if (!ref->known[quantity])
        find(ref, quantity);
    return ref->value[quantity];
}

double ref_double(struct ref *ref, enum ref_quantity quantity)
{
    return mpfr_get_d(ref_value(ref, quantity), N);
}

double ref_error(struct ref *ref, enum ref_quantity quantity, domq_real got)
{
    mpfr_t x;
    mpfr_init2(x, ref->bits > 192 ? ref->bits : 192);
    ref_set_real(x, got);
    mpfr_sub(x, x, ref_value(ref, quantity), N);
    double error = fabs(mpfr_get_d(x, N));
    mpfr_clear(x);
    return error;
}

/* Returns the size of the terms whose difference is the value. */
static double own_size(struct ref *ref, enum ref_quantity quantity)
{
    double size = fabs(ref_double(ref, quantity));
    switch (quantity) {
    case REF_OMEGASQ:
        return (ref_double(ref, REF_KINETIC) + fabs(ref_double(ref, REF_DH))) / ref_double(ref, REF_J);
    case REF_THETA_M:
        return size + ref->theta_m_size;
    case REF_STOP:
        return size + ref->stop_size;
    default:
        return size;
    }
}

double ref_change(struct ref *ref, enum ref_quantity quantity, int input)
{
    /* Nearby references start from this value, so it must be computed first. */
    mpfr_srcptr here = ref_value(ref, quantity);
    struct ref *near = ref_near(ref, input);
    if (!near)
        return 0;
    mpfr_t x;
    mpfr_init2(x, ref->bits);
    mpfr_sub(x, ref_value(near, quantity), here, N);
    double change = mpfr_get_d(x, N) / ref->nearby[input];
    mpfr_clear(x);
    return change;
}

double ref_scale_up_to(struct ref *ref, enum ref_quantity quantity, double enough)
{
    if (quantity == REF_DURATION)
        return ref_double(ref, quantity) + ref->duration_size;
    if (quantity == REF_MARGIN)
        return ref_scale(ref, REF_KINETIC) + ref_scale(ref, REF_BARRIER);
    const double own = own_size(ref, quantity);
    double sum = 0;
    for (int k = 0; k < REF_INPUTS && fmax(own, sum) < enough; k++)
        sum += fabs(ref_change(ref, quantity, k));
    return fmax(own, sum);
}

double ref_scale(struct ref *ref, enum ref_quantity quantity)
{
    return ref_scale_up_to(ref, quantity, (double)INFINITY);
}

/* ---- Growths ---- */

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
