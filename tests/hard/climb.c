/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The barrier and the stop, as roots of H' and of H - K in many bits. The sketch gives estimates of these
 * roots. */
#include "reference.h"

#include <stdio.h>
#include <stdlib.h>

#define N MPFR_RNDN

/* Computes f at a tilt, and the sums at this tilt. */
typedef void curve(struct ref *ref, mpfr_srcptr tilt, struct ref_sums *sums, mpfr_t f);

static void slope_of_H(struct ref *ref, mpfr_srcptr tilt, struct ref_sums *sums, mpfr_t f)
{
    ref_walk(ref, tilt, sums);
    mpfr_set(f, sums->dH_prime, N);
}

static void energy_left(struct ref *ref, mpfr_srcptr tilt, struct ref_sums *sums, mpfr_t f)
{
    ref_walk(ref, tilt, sums);
    mpfr_sub(f, ref_value(ref, REF_KINETIC), sums->dH, N);
}

/* Returns true if the bracket determines the root to about ref->cut - 20 bits. */
static bool narrow(const struct ref *ref, mpfr_srcptr lo, mpfr_srcptr hi, mpfr_t t)
{
    mpfr_sub(t, hi, lo, N);
    return mpfr_zero_p(t) || mpfr_get_exp(t) < mpfr_get_exp(hi) - (mpfr_exp_t)(ref->cut - 20);
}

/*
 * Finds the root of f, between f(lo) > 0 and f(hi) <= 0, and writes it to hi. The method is regula falsi with
 * the Illinois rule, which halves the value at an end that does not move. Every fourth step is a bisection.
 */
static void fall_to_zero(struct ref *ref, curve *f, mpfr_t lo, mpfr_t hi, struct ref_sums *sums)
{
    mpfr_t f_lo, f_hi, f_x, x, t;
    mpfr_inits2(ref->bits, f_lo, f_hi, f_x, x, t, (mpfr_ptr)0);
    f(ref, lo, sums, f_lo);
    f(ref, hi, sums, f_hi);
    for (int step = 1, side = 0; step < 400 && !narrow(ref, lo, hi, t); step++) {
        if (step % 4 == 0) {
            mpfr_div_2ui(t, t, 1, N);
        } else {
            mpfr_mul(t, t, f_lo, N);
            mpfr_sub(x, f_lo, f_hi, N);
            mpfr_div(t, t, x, N);
        }
        mpfr_add(x, lo, t, N);
        f(ref, x, sums, f_x);
        if (mpfr_sgn(f_x) > 0) {
            mpfr_set(lo, x, N);
            mpfr_set(f_lo, f_x, N);
            if (side == 1)
                mpfr_div_2ui(f_hi, f_hi, 1, N);
            side = 1;
        } else {
            mpfr_set(hi, x, N);
            mpfr_set(f_hi, f_x, N);
            if (side == -1)
                mpfr_div_2ui(f_lo, f_lo, 1, N);
            side = -1;
            if (mpfr_zero_p(f_x))
                mpfr_set(lo, x, N);
        }
    }
    mpfr_clears(f_lo, f_hi, f_x, x, t, (mpfr_ptr)0);
}

/* ---- Barrier ---- */

/* Compares a candidate for the maximum of H with the best one so far, which is in ref->value. */
static void consider(struct ref *ref, mpfr_srcptr tilt, int at_end, struct ref_sums *sums)
{
    ref_walk(ref, tilt, sums);
    if (mpfr_greater_p(sums->dH, ref->value[REF_BARRIER])) {
        mpfr_set(ref->value[REF_BARRIER], sums->dH, N);
        mpfr_set(ref->value[REF_THETA_M], tilt, N);
        ref->at_end = at_end;
    }
}

static bool brackets(struct ref *ref, mpfr_srcptr lo, mpfr_srcptr hi, struct ref_sums *sums)
{
    ref_walk(ref, lo, sums);
    if (mpfr_sgn(sums->dH_prime) <= 0)
        return false;
    ref_walk(ref, hi, sums);
    return mpfr_sgn(sums->dH_prime) <= 0;
}

static bool narrower(struct ref *ref, const struct sketch *sketch, long double a, long double b, mpfr_t lo,
                     mpfr_t hi, struct ref_sums *sums)
{
    for (int j = 0; j < 60 && b - a > 1e-13L * b; j++) {
        long double middle = (a + b) / 2;
        *(sketch_slope(sketch, middle) > 0 ? &a : &b) = middle;
    }
    mpfr_set_ld(lo, a * (1 - 1e-12L), N);
    mpfr_set_ld(hi, b * (1 + 1e-12L), N);
    return brackets(ref, lo, hi, sums);
}

static void consider_maxima(struct ref *ref, struct ref_sums *sums)
{
    long double node[SKETCH_NODES], slope[SKETCH_NODES];
    const struct sketch sketch = sketch_of(ref);
    const int n = sketch_nodes(&sketch, node);
    mpfr_t lo, hi;
    mpfr_inits2(ref->bits, lo, hi, (mpfr_ptr)0);
    for (int i = 0; i < n; i++)
        slope[i] = sketch_slope(&sketch, node[i]);
    for (int i = 0; i + 1 < n; i++) {
        if (!(slope[i] > 0 && slope[i + 1] <= 0))
            continue;
        if (!narrower(ref, &sketch, node[i], node[i + 1], lo, hi, sums)) {
            mpfr_set_ld(lo, node[i > 0 ? i - 1 : 0], N);
            mpfr_set_ld(hi, node[i + 2 < n ? i + 2 : n - 1], N);
            if (!brackets(ref, lo, hi, sums))
                continue; /* the maximum is at an end */
        }
        fall_to_zero(ref, slope_of_H, lo, hi, sums);
        consider(ref, hi, 0, sums);
    }
    mpfr_clears(lo, hi, (mpfr_ptr)0);
}

/* Finds the maximum for slightly changed inputs, by the secant method, starting from the maximum of
 * ref->centre. */
static void follow_maximum(struct ref *ref, struct ref_sums *sums)
{
    mpfr_t x, y, f_x, f_y, t;
    mpfr_inits2(ref->bits, x, y, f_x, f_y, t, (mpfr_ptr)0);
    mpfr_set(x, ref->centre->value[REF_THETA_M], N);
    mpfr_div_2ui(y, x, 50, N);
    mpfr_add(y, y, x, N);
    slope_of_H(ref, x, sums, f_x);
    for (int step = 0; step < 6; step++) {
        slope_of_H(ref, y, sums, f_y);
        mpfr_sub(t, f_y, f_x, N);
        if (mpfr_zero_p(t))
            break;
        mpfr_div(t, f_y, t, N);
        mpfr_sub(f_x, y, x, N);
        mpfr_mul(t, t, f_x, N);
        mpfr_set(x, y, N);
        mpfr_set(f_x, f_y, N);
        mpfr_sub(y, y, t, N);
    }
    mpfr_set_inf(ref->value[REF_BARRIER], -1);
    consider(ref, y, 0, sums);
    mpfr_clears(x, y, f_x, f_y, t, (mpfr_ptr)0);
}

/* Finds how far rounding errors of the terms of H' move theta_m. */
static void size_theta_m(struct ref *ref, struct ref_sums *sums)
{
    mpfr_t x, f;
    mpfr_inits2(ref->bits, x, f, (mpfr_ptr)0);
    ref->theta_m_size = 0;
    if (ref->at_end == 0) {
        mpfr_div_2ui(x, ref->value[REF_THETA_M], 50, N);
        mpfr_add(x, x, ref->value[REF_THETA_M], N);
        slope_of_H(ref, ref->value[REF_THETA_M], sums, f);
        ref_walk(ref, x, sums);
        mpfr_sub(f, sums->dH_prime, f, N);
        mpfr_div(f, sums->dH_prime_size, f, N);
        mpfr_sub(x, x, ref->value[REF_THETA_M], N);
        mpfr_mul(f, f, x, N);
        ref->theta_m_size = fabs(mpfr_get_d(f, N));
    }
    mpfr_clears(x, f, (mpfr_ptr)0);
}

void ref_find_barrier(struct ref *ref)
{
    struct ref_sums sums;
    ref_sums_init(&sums, ref->bits);
    mpfr_set_zero(ref->value[REF_THETA_M], 1);
    mpfr_set_zero(ref->value[REF_BARRIER], 1);
    if (!ref->centre) {
        ref->at_end = -1;
        consider(ref, ref->theta_c, 1, &sums);
        consider_maxima(ref, &sums);
        size_theta_m(ref, &sums);
    } else if (ref->centre->at_end == 1) {
        consider(ref, ref->theta_c, 1, &sums);
    } else if (ref->centre->at_end == 0) {
        follow_maximum(ref, &sums);
    }
    ref->known[REF_THETA_M] = ref->known[REF_BARRIER] = ref->known[REF_MARGIN] = true;
    mpfr_sub(ref->value[REF_MARGIN], ref_value(ref, REF_KINETIC), ref->value[REF_BARRIER], N);
    ref_sums_clear(&sums);
}

/* ---- The tilt at which a train that stops comes to rest ---- */

/* Returns true if H - H(0) first reaches K between these two tilts. */
static bool passes(struct ref *ref, long double from, mpfr_srcptr to, mpfr_t lo, mpfr_t hi,
                   struct ref_sums *sums)
{
    mpfr_t f;
    mpfr_init2(f, ref->bits);
    mpfr_set_ld(lo, from, N);
    mpfr_set(hi, to, N);
    energy_left(ref, lo, sums, f);
    if (mpfr_sgn(f) <= 0) /* the sketch was wrong */
        mpfr_set_zero(lo, 1);
    energy_left(ref, hi, sums, f);
    bool found = mpfr_sgn(f) <= 0;
    mpfr_clear(f);
    return found;
}

/* Finds a bracket of the stop. Returns false if the train does not stop. A bracket may end at theta_m, since
 * H may exceed K only close to theta_m. */
static bool bracket_stop(struct ref *ref, mpfr_t lo, mpfr_t hi, struct ref_sums *sums)
{
    long double node[SKETCH_NODES];
    const struct sketch sketch = sketch_of(ref);
    const int n = sketch_nodes(&sketch, node);
    const long double K = mpfr_get_ld(ref_value(ref, REF_KINETIC), N);
    const long double top = mpfr_get_ld(ref_value(ref, REF_THETA_M), N);
    mpfr_t to;
    mpfr_init2(to, ref->bits);
    bool found = false;
    for (int i = 1; i < n && !found; i++) {
        if (node[i] >= top && node[i - 1] < top)
            found = passes(ref, node[i - 1], ref->value[REF_THETA_M], lo, hi, sums);
        /* The sketch may be wrong where H is close to K. */
        if (!found && sketch_energy_change(&sketch, node[i]) >= K * (1 - 1e-6L)) {
            mpfr_set_ld(to, node[i], N);
            if (mpfr_greater_p(to, ref->theta_c))
                mpfr_set(to, ref->theta_c, N);
            found = passes(ref, node[i - 1], to, lo, hi, sums);
        }
    }
    mpfr_clear(to);
    return found;
}

void ref_find_stop(struct ref *ref)
{
    struct ref_sums sums;
    mpfr_t lo, hi;
    ref_sums_init(&sums, ref->bits);
    mpfr_inits2(ref->bits, lo, hi, (mpfr_ptr)0);
    mpfr_set_nan(ref->value[REF_STOP]);
    ref->known[REF_STOP] = true;
    if (!mpfr_nan_p(ref_value(ref, REF_KINETIC)) && bracket_stop(ref, lo, hi, &sums)) {
        fall_to_zero(ref, energy_left, lo, hi, &sums);
        mpfr_set(ref->value[REF_STOP], hi, N);
        ref_walk(ref, hi, &sums);
        mpfr_div(hi, ref_value(ref, REF_KINETIC), sums.dH_prime, N);
        ref->stop_size = fabs(mpfr_get_d(hi, N));
    }
    mpfr_clears(lo, hi, (mpfr_ptr)0);
    ref_sums_clear(&sums);
}
