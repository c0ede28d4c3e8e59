/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The law of contact of the paper, for dominoes with sharp edges. The sharp upper edge of a follower touches
 * the flat back of its leader. A domino turns about the front edge of its foot. */
#include "geometry/far.h"
#include "geometry/law.h"

/* ---- Preparing a train or a row ---- */

static enum dom_status sharp_set(struct geometry *geometry)
{
    const real s = geometry->s, r = geometry->r, d = geometry->d, L = geometry->L;
    geometry->c = tilt_make(fmin(r * s, 1), sqrt(geometry->short_of * (1 + r * s)));
    real x_inf = sqrt(s * (s + 2 * d)) / L;
    geometry->inf = (struct tilt){x_inf, d / L, s / L};
    geometry->decay = geometry->weight * fmax(0, 1 - r * L * x_inf);

    /* Followers detach if theta_leave < theta_inf (41; A17). The tilt theta_leave follows from 1 - cos
     * theta_leave = (1/r^2 - s^2) / (2 d L). */
    geometry->leave_at = geometry->short_of * (1 + r * s);
    geometry->leave_by = 2 * d * L * r * r;
    real v_leave = geometry->leave_at / geometry->leave_by;
    geometry->detaches = v_leave < geometry->inf.v;
    geometry->f = geometry->inf;
    if (geometry->detaches) {
        geometry->leave = (struct tilt){sqrt(v_leave * (2 - v_leave)), 1 - v_leave, v_leave};
        /* Equation (42; A18) gives sin theta_f. The cosine follows from
         * 1 - sin theta_f = (d - (1/r - L)) (d + (1/r - L)) r / (2 L), where 1/r - L = short_of / r - d. */
        real one_minus_x = (2 * r * d - geometry->short_of) * geometry->short_of / (2 * r * L);
        real x_f =
            2 * one_minus_x < 1 ? 1 - one_minus_x : fmin((1 + r * r * s * (s + 2 * d)) / (2 * r * L), 1);
        geometry->f = tilt_make(x_f, sqrt(one_minus_x * (2 - one_minus_x)));
    }
    return DOM_OK;
}

static struct tilt sharp_hit(const struct geometry *geometry, real gap)
{
    (void)geometry;
    real sine = fmin(gap, 1);
    return tilt_make(sine, sqrt((1 - sine) * (1 + sine)));
}

/* ---- One domino ---- */

static struct tilt sharp_leader(const struct geometry *geometry, struct tilt follower)
{
    /* If the follower's tilt is given, the contact equation (12; b8) is A cos theta + B sin theta = d. The
     * smaller root theta is the leader's tilt. */
    real A = geometry->L - follower.x / geometry->r, B = follower.y / geometry->r;
    real R = hypot(A, B), root = sqrt(fmax((R - geometry->d) * (R + geometry->d), 0));
    real least = geometry->lean < 0 ? sin(geometry->lean) : 0;
    return tilt_make(fmax((B * geometry->d - A * root) / (R * R), least),
                     (A * geometry->d + B * root) / (R * R));
}

static real sharp_paper_fuel(const struct geometry *geometry)
{
    real s = geometry->s, d = geometry->d, x = geometry->h.x, y = geometry->h.y;
    /* h(0) - h(theta_f) = sin theta_f (h.y tan(theta_f / 2) - h.x). */
    if (geometry->detaches)
        return geometry->f.x * (y * geometry->f.x / (1 + geometry->f.y) - x);
    /* This is h(0) - h(theta_inf), in a form that keeps its digits where the fuel is nearly 0. On a level
     * floor the fuel is 0 at s = 2 d^3 / (1 - d^2). */
    return s * fma(s, (y - x) * (y + x), -2 * d * x * x) /
           (geometry->L * (y * s + x * geometry->L * geometry->inf.x));
}

static real sharp_tipped_omegasq(const struct geometry *geometry)
{
    real sine, cosine;
    geometry_tips(geometry, &sine, &cosine);
    return sine > 0 ? geometry->steepest * sine * sine / (1 + cosine) : 0;
}

static void sharp_turns(const struct geometry *geometry, int order, real *p)
{
    /* p = tan(asin(X) / 2) = X / (1 + Y), where X = 2 r L z (sin theta_inf - z cos theta_inf) / (1 + z^2). */
    real X[FAR_ORDER + 2], Y[FAR_ORDER + 2];
    const real rL = geometry->rL;
    for (int k = 1; k <= order; k++) {
        X[k] = k == 1 ? 2 * rL * geometry->inf.x : k == 2 ? -2 * rL * geometry->inf.y : -X[k - 2];
        real square = 0, half = X[k]; /* p follows from Y^2 = 1 - X^2 and p (1 + Y) = X */
        for (int j = 1; j < k; j++) {
            square += X[j] * X[k - j] + Y[j] * Y[k - j];
            half -= p[j] * Y[k - j];
        }
        Y[k] = -square / 2;
        p[k] = half / 2;
    }
}

/* ---- The chain ---- */

static struct walk sharp_begin(const struct geometry *geometry, struct tilt head)
{
    return (struct walk){.link = link_head(geometry, head)};
}

static void sharp_next(struct walk *walk)
{
    walk->curve = link_curve(&walk->link);
    walk->second_derivative = link_second_derivative(&walk->link, walk->curve, walk->second_derivative);
    link_next(&walk->link);
}

static void sharp_touch(struct walk *walk)
{
    walk->link.contact = geometry_contact(walk->link.geometry, walk->link.tilt);
}

KERNEL struct arms sharp_arms(const struct link *link)
{
    const struct contact *contact = &link->contact;
    const real mu = link->geometry->mu, a = contact->arm - mu * link->geometry->r * link->geometry->d,
               b = contact->Y + mu * contact->X;
    /* without friction the ratio is the slope (14; b10) */
    return (struct arms){
        .a = a, .b = b, .b_plain = contact->Y, .ratio = mu != 0 ? a / b : link->contact.slope};
}

static const struct contact_law sharp_edges = {
    .work_most = 60000000,
    .set = sharp_set,
    .hit = sharp_hit,
    .leader = sharp_leader,
    .paper_fuel = sharp_paper_fuel,
    .tipped_omegasq = sharp_tipped_omegasq,
    .turns = sharp_turns,
    .begin = sharp_begin,
    .next = sharp_next,
    .touch = sharp_touch,
    .arms = sharp_arms,
};
