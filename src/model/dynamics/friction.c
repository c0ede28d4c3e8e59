/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Friction between dominoes (van Leeuwen, The domino effect, Am. J. Phys. 78, 721 (2010)). The tip of a
 * follower slides down the face of its leader, and Coulomb's force mu N along the face brakes both. The arms
 * of the contact are a = Y/r - L x - mu d and b = (Y + mu X)/r (table 1). Energy is not conserved, so the
 * equation of motion replaces (21; c3). S_0 = 1 and S_{i+1} = S_i a_i / b_i (55; e4) are the factors with
 * which the torques of all dominoes add up without their contact forces. w = tau^2 omega^2 obeys
 *
 *     (A/2) dw/dtheta + B w = C,
 *     A = sum r^-(q+1)i S_i theta_i',   B = sum r^-(q+1)i S_i theta_i'',
 *     C = sum r^-qi S_i (x_i - d y_i) / 2,
 *
 * which is linear in w (flow.h). Without friction S_i = theta_i', A = J and C = -H'/2.
 */
#include "dynamics/energy_balance.h"
#include "dynamics/flow.h"
#include "geometry/far.h"
#include "geometry/rounded.h"
#include <stdlib.h>

#ifdef KERNEL_TEXTS
const struct dom_effect dom_effect_friction = {
    .name = "friction",
    .synonyms = "mu rub rough sandpaper slippery coefficient",
    .adds = "Coulomb friction between dominoes, also in the collision",
    .help = "Wood on wood has 0.2 to 0.5; 0 is the paper's model. The tip of each follower slides down the "
            "face of its leader; there the force mu N acts along the face, where N is the contact force. The "
            "arms of a contact become a = Y/r - L x - mu d on the leader and b = (Y + mu X)/r on the "
            "follower. The torques add up with S_0 = 1, S_{i+1} = S_i a_i/b_i. For w = tau^2 omega^2 the "
            "equation of motion is (A/2) dw/dtheta + B w = C, with A = sum r^-(q+1)i S_i theta_i', B = sum "
            "r^-(q+1)i S_i theta_i'', C = 1/2 sum r^-qi S_i (x_i - d y_i). The collision keeps (A(0) - "
            "1)/A(0) of the angular velocity. The barrier is the kinetic energy that the train needs to come "
            "over the hardest tilt. The verdict 'locks' exists with friction only: near r s = 1 the force on "
            "the struck domino passes on the wrong side of its hinge and cannot turn it. 'fuel paper' cannot "
            "be combined with friction: there is no closed form of the fuel.",
    .source = "J. M. J. van Leeuwen, The domino effect, Am. J. Phys. 78, 721 (2010)",
    .plan = "equation of motion, linear in omega^2: Chebyshev series",
    .dissipates = true,
    .argument = {{.name = "MU",
                  .unit = "",
                  .meaning = "friction coefficient",
                  .lowest = 0,
                  .highest = DOM_MU_HIGHEST,
                  .usual = (dom_real)0.2}},
};
#endif

/* ---- The equation of motion ---- */

/*
 * A, B and C of a train whose head leans at theta_inf - e, a far follower, as A[0] - A[1] e + A[2] e^2 / 2. B
 * holds only the part from theta_i'^2 of that head: its theta_i'' has the same factor as theta_i' has in A.
 */
struct far_friction {
    real A[3], B[3], C[3];
    bool known;
};

/* The memory that a train with friction needs. */
struct friction_room {
    struct flow flow;
    struct far_friction far;
};

static const struct far_friction *far_friction_of(const struct geometry *geometry)
{
    return &((const struct friction_room *)geometry->flow)->far;
}

/*
 * Returns the series from A(theta) = 1 + r^-(q+1) S_1 theta_1' A(theta_1) and the equations like it for B and
 * C, differentiated twice at theta_1 = theta = theta_inf, where X = 0 and Y = 1.
 */
static struct far_friction far_friction_make(const struct geometry *geometry)
{
    real w = geometry->weight, m = geometry->inertia, x = geometry->inf.x, d = geometry->d, mu = geometry->mu;
    real o = geometry->r * geometry->L * x, p = geometry->r * d; /* -X' and -X'' */
    /* theta_1', as a function of theta, and theta_1'', each with its derivatives. */
    const real step[] = {1 - o, -p, o * (1 - o * o)}, contact[] = {-p, step[2], p * (1 - 6 * o * o)};
    /* S_1 = a / b. */
    const real above[] = {1 - o - mu * p, -p, o * (1 - o)}, below1 = -mu * o, below2 = -o * o - mu * p;
    const real S1 = above[1] - above[0] * below1,
               S[] = {above[0], S1, above[2] - 2 * S1 * below1 - above[0] * below2};
    const real k = step[0], k1 = step[1];
    /* Derivatives of the products S theta_1', S theta_1'^2 and S theta_1''. */
    const real a[] = {S[0] * k, S[1] * k + S[0] * k1, S[2] * k + 2 * S[1] * k1 + S[0] * step[2]};
    const real b[] = {a[0] * k, a[1] * k + a[0] * k1, a[2] * k + 2 * a[1] * k1 + a[0] * step[2]};
    const real c[] = {S[0] * contact[0], S[1] * contact[0] + S[0] * contact[1],
                      S[2] * contact[0] + 2 * S[1] * contact[1] + S[0] * contact[2]};
    const real height_slope = geometry_height_slope(geometry, geometry->inf),
               height = geometry_height(geometry, geometry->inf),
               h[] = {-height_slope / 2, height / 2, height_slope / 2};
    struct far_friction f = {.known = fabs(above[0]) < 1};
    /* 1 - r^-q S_1, from r^q - 1. */
    f.C[0] = h[0] / (w * (geometry->rq_1 + o + mu * p));
    f.C[1] = (h[1] + w * S[1] * f.C[0]) / (1 - w * S[0] * k);
    f.C[2] = (h[2] + w * (S[2] * f.C[0] + (2 * S[1] * k + S[0] * k1) * f.C[1])) / (1 - w * S[0] * k * k);
    f.A[0] = 1 / (1 - m * a[0]);
    f.A[1] = m * a[1] * f.A[0] / (1 - m * a[0] * k);
    f.A[2] = m * (a[2] * f.A[0] + (2 * a[1] * k + a[0] * k1) * f.A[1]) / (1 - m * a[0] * k * k);
    f.B[0] = m * c[0] * f.A[0] / (1 - m * b[0]);
    f.B[1] = m * (b[1] * f.B[0] + c[1] * f.A[0] + c[0] * k * f.A[1]) / (1 - m * b[0] * k);
    f.B[2] = m *
             (b[2] * f.B[0] + (2 * b[1] * k + b[0] * k1) * f.B[1] + c[2] * f.A[0] +
              (2 * c[1] * k + c[0] * k1) * f.A[1] + c[0] * k * k * f.A[2]) /
             (1 - m * b[0] * k * k);
    return f;
}

static void friction_count(const struct geometry *geometry, size_t n)
{
    chain_count(geometry, n);
    if (geometry->work)
        geometry->work->entered[DOM_EFFECT_friction]++;
}

/* One domino, its S_i, and theta_i''. */
struct friction_link {
    struct link link;
    real S, second_derivative;
    real noise; /* rounding error of S, in units; more than 1 where b = Y + mu X cancels, since X < 0 */
    /* the contact force on a follower that lies too flat passes on the wrong side of its hinge: b <= 0 */
    bool wrong_side;
};

static void friction_next(struct friction_link *k)
{
    const struct contact *contact = &k->link.contact;
    real b = contact_arm_b(&k->link);
    k->wrong_side = k->wrong_side || b <= 0;
    k->noise += contact->X < 0 ? (contact->Y - k->link.geometry->mu * contact->X) / fabs(b) - 1 : 0;
    k->S *= torque_ratio(&k->link);
    k->second_derivative = link_second_derivative(&k->link, k->second_derivative);
    link_next(&k->link);
}

static void drive_add(const struct friction_link *k, struct series *C)
{
    const struct link *link = &k->link;
    series_add(C, -link->weight * k->S * geometry_height_slope(link->geometry, link->tilt) / 2);
}

/*
 * Returns true when the tail of C can be left out at a tolerance. friction_done finds the same for all three
 * sums. Far down the train, dominoes pass on no more than near the end of an endless train.
 */
static bool drive_done(const struct friction_link *k, struct series *C, real tol)
{
    const struct geometry *geometry = k->link.geometry;
    real ratio = fmax(geometry->weight * fabs(torque_ratio(&k->link)), geometry->decay);
    return series_done(C, k->link.weight * fabs(k->S) * geometry->reach, ratio, tol);
}

static bool friction_done(const struct friction_link *k, struct series *A, struct series *B, struct series *C)
{
    const struct link *link = &k->link;
    const struct geometry *geometry = link->geometry;
    real S = fabs(k->S), Y = link->contact.Y,
         margin_slope = geometry->r * geometry->L / (Y * Y) * link->slope * link->slope;
    real ratio = fmax(geometry->inertia * fabs(torque_ratio(link)), fmax(geometry->decay, geometry->decay_J));
    return drive_done(k, C, geometry->tol) &&
           series_done(A, link->inertia * S * link->slope, ratio, geometry->tol) &&
           series_done(B, link->inertia * S * (fabs(k->second_derivative) + margin_slope), ratio,
                       geometry->tol);
}

/* Returns the distance of a tilt from theta_inf, to the fourth order. */
static real far_angle(const struct geometry *geometry, struct tilt t)
{
    real z = far_off(geometry, t);
    return 2 * z * (1 - z * z / 3);
}

static real far_value(const real f[3], real e)
{
    return f[0] - f[1] * e + f[2] * e * e / 2;
}

/* Adds the rest of C from this domino on, if it is so near to theta_inf that the last term does not
 * matter. */
static bool drive_closes(const struct friction_link *k, struct series *C, real tol)
{
    const struct link *link = &k->link;
    const struct geometry *geometry = link->geometry;
    if (geometry->n != CHAIN_ENDLESS || geometry->follower || !far_friction_of(geometry)->known)
        return false;
    const struct far_friction *far = far_friction_of(geometry);
    real e = far_angle(geometry, link->tilt), part = link->weight * k->S;
    if (e > geometry->inf.x / 16 || !far_done(C, part * far->C[0], part * far->C[2] * e * e, tol))
        return false;
    series_add(C, part * far_value(far->C, e));
    return true;
}

/* Adds the rest of all three sums, under this condition for each. */
static bool friction_closes(const struct friction_link *k, struct series *A, struct series *B,
                            struct series *C)
{
    const struct link *link = &k->link;
    const struct geometry *geometry = link->geometry;
    const struct far_friction *far = far_friction_of(geometry);
    real e = far_angle(geometry, link->tilt), part = link->inertia * k->S, slope = link->slope;
    if (geometry->n != CHAIN_ENDLESS || geometry->follower || !far->known ||
        !far_done(A, part * slope * far->A[0], part * slope * far->A[2] * e * e, geometry->tol))
        return false;
    real rest = part * (k->second_derivative * far->A[0] + slope * slope * far->B[0]),
         last = part * (fabs(k->second_derivative * far->A[2]) + slope * slope * fabs(far->B[2])) * e * e;
    if (!far_done(B, rest, last, geometry->tol) || !drive_closes(k, C, geometry->tol))
        return false;
    series_add(A, part * slope * far_value(far->A, e));
    series_add(B,
               part * (k->second_derivative * far_value(far->A, e) + slope * slope * far_value(far->B, e)));
    return true;
}

static enum dom_status friction_equation_of_motion(const struct geometry *geometry, struct tilt head,
                                                   struct equation_of_motion *equation_of_motion)
{
    if (geometry->rounded.on)
        return rounded_equation_of_motion(geometry, head, equation_of_motion);
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
        series_add(&B, link->inertia * k.S * k.second_derivative);
        drive_add(&k, &C);
        if (link->i + 1 >= geometry->n || !link->leads || friction_done(&k, &A, &B, &C))
            break;
        friction_next(&k);
    }
    friction_count(geometry, k.link.i + 1);
    *equation_of_motion = (struct equation_of_motion){.A = A.sum + A.lost,
                                                      .B = B.sum + B.lost,
                                                      .C = C.sum + C.lost,
                                                      .A_size = A.size * k.noise,
                                                      .B_size = B.size * k.noise,
                                                      .C_size = C.size * k.noise,
                                                      .n = k.link.i + 1};
    equation_of_motion->locks = k.wrong_side || equation_of_motion->A <= 0;
    return isfinite(equation_of_motion->A) && isfinite(equation_of_motion->B) &&
                   isfinite(equation_of_motion->C)
               ? DOM_OK
               : DOM_NOT_FINITE;
}

/* Finds C alone, which is 0 at the top of a barrier. With tol = 1 only its sign is right, and few dominoes
 * are enough. */
static enum dom_status friction_drive(const struct geometry *geometry, struct tilt head, real tol,
                                      real *drive)
{
    if (geometry->rounded.on) {
        struct equation_of_motion equation = {.C = REAL_NAN};
        enum dom_status status = rounded_equation_of_motion(geometry, head, &equation);
        *drive = equation.C;
        return status;
    }
    struct series C = {0};
    struct friction_link k = {.link = link_head(geometry, head), .S = 1};
    for (;;) {
        enum dom_status status = chain_watch(geometry, k.link.i);
        if (status != DOM_OK)
            return status;
        if (drive_closes(&k, &C, tol))
            break;
        drive_add(&k, &C);
        if (k.link.i + 1 >= geometry->n || !k.link.leads || drive_done(&k, &C, tol))
            break;
        k.S *= torque_ratio(&k.link);
        link_next(&k.link);
    }
    friction_count(geometry, k.link.i + 1);
    *drive = C.sum + C.lost;
    return isfinite(*drive) ? DOM_OK : DOM_NOT_FINITE;
}

/* ---- The collision ---- */

static enum dom_status friction_inertia_ratio(const struct geometry *next, const struct geometry *hitting,
                                              struct tilt at, real J, real *inertia_ratio)
{
    (void)J;
    struct equation_of_motion at_hit;
    struct link rest = roller_begin(next, geometry_rest(next)).link;
    real a = link_arm_a(&rest);
    *inertia_ratio = 0;
    if (!(a > 0))
        return DOM_LOCKS;
    enum dom_status status = friction_equation_of_motion(hitting, at, &at_hit);
    if (status == DOM_OK)
        *inertia_ratio = next->inertia * rest.step * at_hit.A * (a / link_arm_b(&rest)) / next->upright;
    return status != DOM_OK || *inertia_ratio > 0 ? status : DOM_LOCKS;
}

/* ---- The law ---- */

/* Finds the slope of u: C replaces -H'/2. */
static enum dom_status friction_slope(const struct geometry *geometry, struct tilt head, bool rough,
                                      real *slope)
{
    enum dom_status status = friction_drive(geometry, head, rough ? 1 : geometry->tol, slope);
    *slope *= -2;
    return status;
}

static enum dom_status friction_acceleration(const struct geometry *geometry, struct tilt head, real w,
                                             real *acceleration, size_t *n)
{
    struct equation_of_motion equation;
    /* The forces need as many dominoes as the energies. */
    enum dom_status status = n ? energy_acceleration(geometry, head, w, acceleration, n) : DOM_OK;
    if (status == DOM_OK)
        status = friction_equation_of_motion(geometry, head, &equation);
    if (status == DOM_OK)
        *acceleration = (equation.C - equation.B * w) / equation.A;
    return status;
}

static struct arms friction_arms(const struct link *link)
{
    return (struct arms){.ratio = link_arm_a(link) / link_arm_b(link), .b = link_arm_b(link)};
}

static enum dom_status friction_begin(struct geometry *geometry)
{
    struct friction_room *room = calloc(1, sizeof *room);
    if (!room)
        return DOM_NO_MEMORY;
    room->flow.equation = friction_equation_of_motion;
    if (!geometry->rounded.on && !geometry->detaches && !geometry->follower && geometry->n == CHAIN_ENDLESS)
        room->far = far_friction_make(geometry);
    geometry->flow = &room->flow;
    return DOM_OK;
}

static void friction_end(struct geometry *geometry)
{
    flow_free(geometry->flow);
    geometry->flow = NULL;
}

static const struct dynamics friction = {
    .text = &dom_effect_friction,
    .begin = friction_begin,
    .end = friction_end,
    .solve = flow_solve,
    .solve_piece = flow_solve_piece,
    .spent = flow_spent,
    .braked = flow_braked,
    .collide = flow_collide,
    .inertia_ratio = friction_inertia_ratio,
    .slope = friction_slope,
    .required_energy = flow_required,
    .unsure = flow_unsure,
    .speed = flow_speed,
    .before_rest = flow_before_rest,
    .acceleration = friction_acceleration,
    .gain = flow_gain,
    .arms = friction_arms,
};

/* Turns the effect on: mu = value. */
KERNEL enum dom_status friction_apply(struct geometry *geometry, real value)
{
    geometry->mu = value;
    geometry->dynamics = &friction;
    return DOM_OK;
}
