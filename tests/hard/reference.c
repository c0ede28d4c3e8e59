/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The geometry, the train, and sums over its dominoes, in many bits. */
#include "reference.h"

#include <stdio.h>
#include <stdlib.h>

#define N MPFR_RNDN

/* ---- One domino leaning on the next ---- */

struct geometry {
    mpfr_t theta, sin, cos, h, h_prime; /* the leader */
    mpfr_t next, slope, a, b;           /* the follower */
    mpfr_t X, Y, t;
};

#define LEAN_ALL(l)                                                                                          \
    (l)->theta, (l)->sin, (l)->cos, (l)->h, (l)->h_prime, (l)->next, (l)->slope, (l)->a, (l)->b, (l)->X,     \
        (l)->Y, (l)->t, (mpfr_ptr)0

static void lean_at(const struct ref *ref, struct geometry *l)
{
    mpfr_sin_cos(l->sin, l->cos, l->theta, N);
    mpfr_fma(l->h, ref->in[REF_D], l->sin, l->cos, N);
    mpfr_fms(l->h_prime, ref->in[REF_D], l->cos, l->sin, N);
}

/* Returns true if a follower leans on the domino. At the reach, an upright domino has a follower with the
 * slope 1, which is the limit for r s -> 1. */
static bool has_follower(const struct ref *ref, mpfr_srcptr theta)
{
    return !ref->detaches || mpfr_zero_p(theta) || mpfr_less_p(theta, ref->theta_leave);
}

static void geometry_follow(const struct ref *ref, struct geometry *l)
{
    mpfr_srcptr r = ref->in[REF_R];
    mpfr_fms(l->X, ref->L, l->cos, ref->in[REF_D], N);
    mpfr_mul(l->X, l->X, r, N);
    if (mpfr_cmp_ui(l->X, 1) > 0) /* r = 1/s, rounded up */
        mpfr_set_ui(l->X, 1, N);
    mpfr_asin(l->next, l->X, N);
    mpfr_add(l->next, l->next, l->theta, N);
    mpfr_sqr(l->t, l->X, N);
    mpfr_ui_sub(l->t, 1, l->t, N);
    mpfr_sqrt(l->Y, l->t, N);
    mpfr_div(l->b, l->Y, r, N);
    mpfr_mul(l->t, ref->L, l->sin, N);
    mpfr_sub(l->a, l->b, l->t, N);
    if (mpfr_zero_p(l->sin))
        mpfr_set_ui(l->slope, 1, N);
    else
        mpfr_div(l->slope, l->a, l->b, N);
}

/* ---- The train at tilt 0 ---- */

static void keep_energy(struct ref *ref, const struct geometry *l)
{
    if ((ref->n & (ref->n - 1)) == 0)
        ref->h0 = realloc(ref->h0, (ref->n ? 2 * ref->n : 1) * sizeof *ref->h0);
    if (!ref->h0 || ref->n > 10000000) {
        fprintf(stderr, "reference: too many dominoes\n");
        abort();
    }
    mpfr_init2(ref->h0[ref->n], ref->bits);
    mpfr_set(ref->h0[ref->n++], l->h, N);
}

/*
 * Returns b such that the chain ends at a domino with less than 2^-b of the head's motion. All later dominoes
 * together have up to 1 / (1 - rho) times as much, where rho is the ratio between the motions of two
 * successive dominoes.
 */
static double cut_here(const struct ref *ref)
{
    if (ref->detaches)
        return ref->cut;
    mpfr_t rho, t;
    mpfr_inits2(ref->bits, rho, t, (mpfr_ptr)0);
    mpfr_sqr(t, ref->L, N);
    mpfr_sqr(rho, ref->in[REF_D], N);
    mpfr_sub(t, t, rho, N);
    mpfr_sqrt(t, t, N);
    mpfr_mul(t, t, ref->in[REF_R], N);
    mpfr_ui_sub(t, 1, t, N);
    mpfr_mul(rho, t, ref->rq, N);
    double left = 1 - mpfr_get_d(rho, N);
    mpfr_clears(rho, t, (mpfr_ptr)0);
    return ref->cut - log2(left > 0x1p-40 ? left : 0x1p-40);
}

static void find_train_at_zero(struct ref *ref)
{
    struct geometry l;
    mpfr_t w, wr, slope, t;
    mpfr_inits2(ref->bits, LEAN_ALL(&l));
    mpfr_inits2(ref->bits, w, wr, slope, t, (mpfr_ptr)0);
    const double cut = cut_here(ref);
    mpfr_set_zero(l.theta, 1);
    mpfr_set_zero(ref->T, 1);
    mpfr_set_zero(ref->fuel_exact, 1);
    mpfr_set_ui(w, 1, N);
    mpfr_set_ui(wr, 1, N);
    mpfr_set_ui(slope, 1, N);
    lean_at(ref, &l);
    keep_energy(ref, &l);
    while (ref->n < ref->dominoes && has_follower(ref, l.theta)) {
        mpfr_mul(t, w, slope, N);
        if (mpfr_zero_p(t) || -(double)mpfr_get_exp(t) > cut)
            break;
        mpfr_fma(ref->fuel_exact, w, l.h, ref->fuel_exact, N);
        geometry_follow(ref, &l);
        mpfr_mul(slope, slope, l.slope, N);
        mpfr_set(l.theta, l.next, N);
        lean_at(ref, &l);
        mpfr_mul(t, w, l.h, N);
        mpfr_sub(ref->fuel_exact, ref->fuel_exact, t, N);
        mpfr_mul(w, w, ref->rq, N);
        mpfr_mul(wr, wr, ref->rq, N);
        mpfr_div(wr, wr, ref->in[REF_R], N);
        mpfr_sqr(t, slope, N);
        mpfr_fma(ref->T, t, wr, ref->T, N);
        keep_energy(ref, &l);
    }
    /* After the last domino, the tilt is theta_inf or theta_f. */
    mpfr_sub(t, l.h, ref->h_f, N);
    mpfr_fma(ref->fuel_exact, t, w, ref->fuel_exact, N);
    mpfr_clears(w, wr, slope, t, (mpfr_ptr)0);
    mpfr_clears(LEAN_ALL(&l));
}

/* ---- The train at another tilt ---- */

void ref_sums_init(struct ref_sums *sums, mpfr_prec_t bits)
{
    mpfr_inits2(bits, sums->dH, sums->dH_prime, sums->J, sums->dH_prime_size, (mpfr_ptr)0);
}

void ref_sums_clear(struct ref_sums *sums)
{
    mpfr_clears(sums->dH, sums->dH_prime, sums->J, sums->dH_prime_size, (mpfr_ptr)0);
}

/* Stores the contact of domino 0 and the requested link. */
static void keep_link(struct ref *ref, size_t i, const struct geometry *l, mpfr_t wsv[3], bool leads)
{
    mpfr_t *v = ref->value;
    if (i == 0) {
        mpfr_set(v[REF_THETA_1], leads ? l->next : ref->theta_f, N);
        mpfr_set_zero(v[REF_SLOPE], 1);
        if (leads) {
            mpfr_set(v[REF_SLOPE], l->slope, N);
            mpfr_set(v[REF_ARM_A], l->a, N);
            mpfr_set(v[REF_ARM_B], l->b, N);
        }
    }
    if (i == ref->link) {
        mpfr_set(v[REF_LINK_THETA], l->theta, N);
        mpfr_set(v[REF_LINK_SLOPE], wsv[1], N);
        mpfr_set(v[REF_LINK_WEIGHT], wsv[0], N);
        if (leads) {
            mpfr_set(v[REF_LINK_ARM_A], l->a, N);
            mpfr_set(v[REF_LINK_ARM_B], l->b, N);
        }
    }
}

/* Adds domino i and all later ones, which have the tilt of a domino that has detached. */
static void add_fallen(const struct ref *ref, size_t i, mpfr_srcptr weight, struct ref_sums *sums)
{
    mpfr_t w, t;
    mpfr_inits2(ref->bits, w, t, (mpfr_ptr)0);
    mpfr_set(w, weight, N);
    for (; i < ref->n; i++) {
        mpfr_sub(t, ref->h_f, ref->h0[i], N);
        mpfr_fma(sums->dH, t, w, sums->dH, N);
        mpfr_mul(w, w, ref->rq, N);
    }
    mpfr_clears(w, t, (mpfr_ptr)0);
}

static void add_domino(const struct ref *ref, const struct geometry *l, size_t i, mpfr_t wsv[3], mpfr_t t,
                       struct ref_sums *sums)
{
    mpfr_sub(t, l->h, ref->h0[i], N);
    mpfr_fma(sums->dH, t, wsv[0], sums->dH, N);
    mpfr_mul(t, wsv[0], wsv[1], N);
    mpfr_mul(t, t, l->h_prime, N);
    mpfr_add(sums->dH_prime, sums->dH_prime, t, N);
    mpfr_abs(t, t, N);
    mpfr_add(sums->dH_prime_size, sums->dH_prime_size, t, N);
    mpfr_sqr(t, wsv[1], N);
    mpfr_fma(sums->J, t, wsv[2], sums->J, N);
}

static void walk(struct ref *ref, mpfr_srcptr tilt, bool keep, struct ref_sums *sums)
{
    struct geometry l;
    mpfr_t wsv[3], t; /* weight in H, slope, weight in J */
    mpfr_inits2(ref->bits, LEAN_ALL(&l));
    mpfr_inits2(ref->bits, wsv[0], wsv[1], wsv[2], t, (mpfr_ptr)0);
    mpfr_set(l.theta, tilt, N);
    for (int k = 0; k < 3; k++)
        mpfr_set_ui(wsv[k], 1, N);
    mpfr_set_zero(sums->dH, 1);
    mpfr_set_zero(sums->dH_prime, 1);
    mpfr_set_zero(sums->J, 1);
    mpfr_set_zero(sums->dH_prime_size, 1);
    for (size_t i = 0; i < ref->n; i++) {
        lean_at(ref, &l);
        add_domino(ref, &l, i, wsv, t, sums);
        bool leads = has_follower(ref, l.theta);
        if (leads)
            geometry_follow(ref, &l);
        if (keep)
            keep_link(ref, i, &l, wsv, leads);
        mpfr_mul(wsv[0], wsv[0], ref->rq, N);
        mpfr_mul(wsv[2], wsv[2], ref->rq, N);
        mpfr_div(wsv[2], wsv[2], ref->in[REF_R], N);
        if (!leads) {
            add_fallen(ref, i + 1, wsv[0], sums);
            break;
        }
        mpfr_mul(wsv[1], wsv[1], l.slope, N);
        mpfr_set(l.theta, l.next, N);
    }
    mpfr_clears(wsv[0], wsv[1], wsv[2], t, (mpfr_ptr)0);
    mpfr_clears(LEAN_ALL(&l));
}

void ref_walk(struct ref *ref, mpfr_srcptr tilt, struct ref_sums *sums)
{
    walk(ref, tilt, false, sums);
}

void ref_walk_at_tilt(struct ref *ref)
{
    struct ref_sums sums;
    ref_sums_init(&sums, ref->bits);
    for (int k = REF_THETA_1; k <= REF_J; k++) {
        mpfr_set_nan(ref->value[k]);
        ref->known[k] = true;
    }
    walk(ref, ref->in[REF_TILT], true, &sums);
    mpfr_set(ref->value[REF_DH], sums.dH, N);
    mpfr_set(ref->value[REF_J], sums.J, N);
    ref_sums_clear(&sums);
}

/* ---- Geometry ---- */

static void find_leaving(struct ref *ref)
{
    mpfr_srcptr r = ref->in[REF_R], d = ref->in[REF_D];
    mpfr_t LL, dd, rr, t;
    mpfr_inits2(ref->bits, LL, dd, rr, t, (mpfr_ptr)0);
    mpfr_sqr(LL, ref->L, N);
    mpfr_sqr(dd, d, N);
    mpfr_sqr(rr, r, N);
    mpfr_ui_div(rr, 1, rr, N);
    mpfr_sub(t, LL, dd, N);
    ref->detaches = mpfr_less_p(rr, t);
    mpfr_set_nan(ref->theta_leave);
    mpfr_set(ref->theta_f, ref->theta_inf, N);
    if (ref->detaches) {
        mpfr_add(t, t, rr, N);
        mpfr_div(t, t, ref->L, N);
        mpfr_mul(t, t, r, N);
        mpfr_div_2ui(t, t, 1, N);
        if (mpfr_cmp_ui(t, 1) > 0)
            mpfr_set_ui(t, 1, N);
        mpfr_asin(ref->theta_f, t, N);
        mpfr_add(t, LL, dd, N);
        mpfr_sub(t, t, rr, N);
        mpfr_div(t, t, d, N);
        mpfr_div(t, t, ref->L, N);
        mpfr_div_2ui(t, t, 1, N);
        if (mpfr_cmp_ui(t, 1) > 0)
            mpfr_set_ui(t, 1, N);
        mpfr_acos(ref->theta_leave, t, N);
    }
    mpfr_clears(LL, dd, rr, t, (mpfr_ptr)0);
}

static void find_geometry(struct ref *ref)
{
    mpfr_srcptr s = ref->in[REF_S], r = ref->in[REF_R], d = ref->in[REF_D];
    mpfr_t t, x;
    mpfr_inits2(ref->bits, t, x, (mpfr_ptr)0);
    mpfr_add(ref->L, s, d, N);
    mpfr_mul(t, r, s, N);
    mpfr_ui_sub(ref->u, 1, t, N);
    if (mpfr_sgn(ref->u) < 0)
        mpfr_set_ui(t, 1, N);
    mpfr_asin(ref->theta_c, t, N);
    mpfr_atan(ref->theta_u, d, N);
    mpfr_div(t, d, ref->L, N);
    mpfr_acos(ref->theta_inf, t, N);
    mpfr_neg(t, ref->in[REF_Q], N);
    mpfr_pow(ref->rq, r, t, N);
    find_leaving(ref);
    mpfr_sin_cos(t, x, ref->theta_f, N);
    mpfr_mul(t, t, d, N);
    mpfr_add(ref->h_f, t, x, N);
    mpfr_ui_sub(ref->fuel_paper, 1, ref->h_f, N);
    mpfr_clears(t, x, (mpfr_ptr)0);
}

void ref_start(struct ref *ref)
{
    find_geometry(ref);
    find_train_at_zero(ref);
}
