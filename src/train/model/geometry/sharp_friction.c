/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pass down a chain with sharp edges and losses (equations: dynamics/losses.h). */
#include "geometry/far.h"
#include "geometry/law.h"

/*
 * Finds the functions A(e), B(e) and C(e) of far_friction. A(e) follows from the equation A(theta) = 1 +
 * r^(-(q+1)) S_1 theta_1' A(theta_1). B and C satisfy similar equations. All three equations are
 * differentiated twice at theta = theta_inf. There theta_1 = theta, so X = 0 and Y = 1.
 */
KERNEL void far_friction_make(struct geometry *geometry)
{
    real w = geometry->weight, m = geometry->inertia, x = geometry->inf.x, d = geometry->d, mu = geometry->mu;
    real o = geometry->r * geometry->L * x, p = geometry->r * d; /* -X' and -X'' */
    /* theta_1' and theta_1'' as functions of theta: their values and first two derivatives at theta_inf */
    const real step[] = {1 - o, -p, o * (1 - o * o)}, contact[] = {-p, step[2], p * (1 - 6 * o * o)};
    /* S_1 is the quotient a / b of the lever arms. `above` holds the values of a, a' and a'' at theta_inf.
     * `below1` and `below2` are the values of b' and b'' at theta_inf, where b is 1. */
    const real above[] = {1 - o - mu * p, -p, o * (1 - o)}, below1 = -mu * o, below2 = -o * o - mu * p;
    const real S1 = above[1] - above[0] * below1,
               S[] = {above[0], S1, above[2] - 2 * S1 * below1 - above[0] * below2};
    const real k = step[0], k1 = step[1];
    /* The products S theta_1', S theta_1'^2 and S theta_1'', each with its first two derivatives. */
    const real a[] = {S[0] * k, S[1] * k + S[0] * k1, S[2] * k + 2 * S[1] * k1 + S[0] * step[2]};
    const real b[] = {a[0] * k, a[1] * k + a[0] * k1, a[2] * k + 2 * a[1] * k1 + a[0] * step[2]};
    const real c[] = {S[0] * contact[0], S[1] * contact[0] + S[0] * contact[1],
                      S[2] * contact[0] + 2 * S[1] * contact[1] + S[0] * contact[2]};
    const real height_slope = geometry_height_slope(geometry, geometry->inf),
               height = geometry_height(geometry, geometry->inf),
               h[] = {-height_slope / 2, height / 2, height_slope / 2};
    struct far_friction f = {.known = fabs(above[0]) < 1};
    /* The denominator is 1 - r^-q S_1. rq_1 is r^q - 1, computed without cancellation. */
    f.C[0] = h[0] / (w * (geometry->rq_1 + o + mu * p));
    f.C[1] = (h[1] + w * S[1] * f.C[0]) / (1 - w * S[0] * k);
    f.C[2] = (h[2] + w * (S[2] * f.C[0] + (2 * S[1] * k + S[0] * k1) * f.C[1])) / (1 - w * S[0] * k * k);
    f.A[0] = 1 / (1 - m * a[0]);
    f.A[1] = m * a[1] * f.A[0] / (1 - m * a[0] * k);
    f.A[2] = m * (a[2] * f.A[0] + (2 * a[1] * k + a[0] * k1) * f.A[1]) / (1 - m * a[0] * k * k);
    f.B[0] = (geometry->drag + m * c[0] * f.A[0]) / (1 - m * b[0]);
    f.B[1] = m * (b[1] * f.B[0] + c[1] * f.A[0] + c[0] * k * f.A[1]) / (1 - m * b[0] * k);
    f.B[2] = m *
             (b[2] * f.B[0] + (2 * b[1] * k + b[0] * k1) * f.B[1] + c[2] * f.A[0] +
              (2 * c[1] * k + c[0] * k1) * f.A[1] + c[0] * k * k * f.A[2]) /
             (1 - m * b[0] * k * k);
    geometry->far_friction = f;
}

/* One domino with its S_i and theta_i''. */
struct friction_link {
    struct link link;
    real S, second_derivative;
    /* The rounding error of S, in units of the unit roundoff. It grows if X < 0, since digits then cancel in
     * the sum b = Y + mu X. */
    real noise;
    /* True if b <= 0 at some contact: the contact force then passes on the wrong side of the follower's
     * hinge. */
    bool wrong_side;
};

static void friction_next(struct friction_link *k)
{
    const struct contact *contact = &k->link.contact;
    const bool has_friction = k->link.geometry->mu != 0;
    real b = contact_arm_b(&k->link);
    k->wrong_side = k->wrong_side || (has_friction && b <= 0);
    k->noise += contact->X < 0 ? (contact->Y - k->link.geometry->mu * contact->X) / fabs(b) - 1 : 0;
    k->S *= has_friction ? torque_ratio(&k->link) : k->link.contact_slope;
    k->second_derivative = link_second_derivative(&k->link, k->second_derivative);
    link_next(&k->link);
}

/*
 * Returns true when the tails of all three sums can be left out. Each tail is bounded by a geometric series.
 * The ratio of this series is at least `decay`, because without friction the ratio of successive terms of C
 * tends to `decay` far down an endless train.
 */
static bool friction_done(const struct friction_link *k, struct series *A, struct series *B, struct series *C)
{
    const struct link *link = &k->link;
    const struct geometry *geometry = link->geometry;
    real S = fabs(k->S), Y = link->contact.Y, passed = fabs(torque_ratio(link)),
         margin_slope = (geometry->r * geometry->L / (Y * Y) + geometry->drag) * link->slope * link->slope;
    real ratio = fmax(geometry->inertia * passed, fmax(geometry->decay, geometry->decay_J));
    return series_done(C, link->weight * S * geometry->steepest,
                       fmax(geometry->weight * passed, geometry->decay), geometry->tol) &&
           series_done(A, link->inertia * S * link->slope, ratio, geometry->tol) &&
           series_done(B, link->inertia * S * (fabs(k->second_derivative) + margin_slope), ratio,
                       geometry->tol);
}

/* Returns the angle from a tilt to theta_inf, correct to the fourth order of this angle. */
static real far_angle(const struct geometry *geometry, struct tilt t)
{
    real z = far_variable(geometry, t);
    return 2 * z * (1 - z * z / 3);
}

static real far_value(const real f[3], real e)
{
    return f[0] - f[1] * e + f[2] * e * e / 2;
}

/*
 * Uses far_friction to add this domino and all dominoes behind it to the sums. If far_friction does not
 * apply, if the tilt is too far from theta_inf, or if the quadratic terms matter, adds nothing and returns
 * false.
 */
static bool friction_closes(const struct friction_link *k, struct series *A, struct series *B,
                            struct series *C)
{
    const struct link *link = &k->link;
    const struct geometry *geometry = link->geometry;
    const struct far_friction *far = &geometry->far_friction;
    if (geometry->n != CHAIN_ENDLESS || geometry->follower || !far->known)
        return false;
    real e = far_angle(geometry, link->tilt), part = link->inertia * k->S, slope = link->slope,
         drive = link->weight * k->S, turns = k->second_derivative, square = slope * slope;
    if (e > geometry->inf.x / 16 ||
        !far_done(A, part * slope * far->A[0], part * slope * far->A[2] * e * e, geometry->tol) ||
        !far_done(B, part * (turns * far->A[0] + square * far->B[0]),
                  part * (fabs(turns * far->A[2]) + square * fabs(far->B[2])) * e * e, geometry->tol) ||
        !far_done(C, drive * far->C[0], drive * far->C[2] * e * e, geometry->tol))
        return false;
    series_add(A, part * slope * far_value(far->A, e));
    series_add(B, part * (turns * far_value(far->A, e) + square * far_value(far->B, e)));
    series_add(C, drive * far_value(far->C, e));
    return true;
}

KERNEL enum dom_status sharp_equation(const struct geometry *geometry, struct tilt head,
                                      struct equation_of_motion *equation)
{
    struct series A = {0}, B = {0}, C = {0};
    struct friction_link k = {.link = link_head(geometry, head), .S = 1, .noise = 1};
    for (;;) {
        const struct link *link = &k.link;
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        if (friction_closes(&k, &A, &B, &C))
            break;
        series_add(&A, link->inertia * k.S * link->slope);
        series_add(&B, link->inertia * k.S *
                           (k.second_derivative + link->geometry->drag * link->slope * link->slope));
        series_add(&C, -link->weight * k.S * geometry_height_slope(link->geometry, link->tilt) / 2);
        if (link->i + 1 >= geometry->n || !link->leads || friction_done(&k, &A, &B, &C))
            break;
        friction_next(&k);
    }
    chain_count(geometry, k.link.i + 1);
    if (geometry->work && geometry->mu != 0)
        geometry->work->entered[DOM_EFFECT_friction]++;
    *equation = (struct equation_of_motion){.A = A.sum + A.lost,
                                            .B = B.sum + B.lost,
                                            .C = C.sum + C.lost,
                                            .A_size = A.size * k.noise,
                                            .B_size = B.size * k.noise,
                                            .C_size = C.size * k.noise,
                                            .n = k.link.i + 1};
    equation->locks = k.wrong_side || equation->A <= 0;
    return isfinite(equation->A) && isfinite(equation->B) && isfinite(equation->C) ? DOM_OK : DOM_NOT_FINITE;
}
