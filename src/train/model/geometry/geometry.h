/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The geometry of a train, and of one domino: section 2 and appendix A of the paper. An angle theta is stored
 * as a struct tilt, so the loops down the train need no trigonometry. */
#pragma once

#include "numerics/interrupt.h"
#include "numerics/real.h"

struct tilt {
    real x, y; /* sin theta, cos theta (29; A4) */
    real v;    /* 1 - cos theta, accurate even near theta = 0 */
};

static const struct tilt standing = {.x = 0, .y = 1, .v = 0};

struct flow; /* dynamics.h */

/* The lowest and the highest order of the series for the far tail. */
#if REAL_BITS <= 24
enum { FAR_FIRST = 4, FAR_ORDER = 4 };
#elif REAL_BITS <= 64
enum { FAR_FIRST = 4, FAR_ORDER = 12 };
#else
enum { FAR_FIRST = 4, FAR_ORDER = 20 };
#endif

/* H and J of a train, as power series around theta_inf (far.c) */
struct far {
    int order; /* the order of both series, which is even; 0 if there are no series */
    real from; /* the series are probably accurate enough where 1 - cos theta >= from */
    real radius, rest_H, rest_J;
    /* From one domino of a pass to the next, z decreases by x^power while the omitted terms decrease by x. */
    real power;
    real H[FAR_ORDER + 1], J[FAR_ORDER + 1];
};

/*
 * The shape of a domino with rounded edges (rounded.c). Lengths are divided by its height. The moment of
 * inertia is taken about the line where the foot touches the floor. It is i times the moment of inertia that
 * the domino would have about its edge if its edges were sharp, where
 *
 *     i(theta) = i.c + i.x sin theta + i.y cos theta.
 *
 * With sharp edges, i is 1 and rho is 0.
 */
struct rounded {
    real rho;           /* radius of the edges */
    real tall, wide;    /* the lengths of the flat parts: 1 - 2 rho and d - 2 rho */
    real rho_1, tall_1; /* `rho` and `tall` of the follower, divided by the height of this domino */
    real roll;          /* rolling on a slope adds this term to dh/dtheta */
    struct {
        real c, x, y;
    } i;
};

/* A train that has been checked, with the quantities that stay constant during a cycle. In a row, where every
 * domino can be different, this structure describes one domino with its follower. */
struct geometry {
    real s, r, d, q, tol;
    /* True if the motion conserves energy. The barrier is then the maximum of the potential energy H. If it
     * is false, an equation of motion is solved (dynamics.h). */
    bool conservative;
    real mu;    /* friction coefficient between dominoes, >= 0 */
    real width; /* width divided by height, for boxes */
    /* A domino that moves is braked by the torque drag I omega^2, even if it touches no other domino. */
    real drag;
    real inertia_factor; /* moment of inertia divided by that of a solid block */
    real entrained;      /* the share of this moment of inertia that is outside the domino */
    bool rolls;          /* true if edges are rounded, so that dominoes roll */
    struct flow *flow;   /* solution of the equation of motion, unless energy is conserved */
    const volatile sig_atomic_t *interrupt;
    struct dom_work *work;
    /* The number of dominoes visited in the current search so far, and its limit. `effort` is NULL if there
     * is no limit. */
    size_t *effort;
    size_t effort_most;
    real L;        /* s + d */
    real rs, rL;   /* r s, r L */
    real short_of; /* span - r s >= 0: how far the gap falls short of what the head can reach across */
    /* 1 - r^2 s^2. With sharp edges, a follower detaches when its leader has 1 - cos theta >= leave_at /
     * leave_by. */
    real leave_at;
    real leave_by; /* 2 r^2 L d */
    real weight;   /* r^-q: weight of a follower / weight of its leader in H (19; c1) */
    real inertia;  /* r^-(q+1): weight of a follower / weight of its leader in J (20; c2) */
    real rq, rq_1; /* r^q and r^q - 1 */
    real steepest; /* the largest |dh/dtheta|, apart from rolling; sqrt(1 + d^2) with sharp edges */
    struct {
        /* The components of gravity along the floor and into it, divided by g. On a level floor, `along` is
         * 0 and `down` is 1. */
        real along, down;
    } g;
    struct {
        /* The energy h(theta) of one domino is h.y cos theta + h.x sin theta + rounded.roll theta, plus a
         * constant. With sharp edges on a level floor, h.x = d, h.y = 1, and rounded.roll = 0. */
        real x, y;
    } h;
    /* The tails of sums are bounded by geometric series. The ratio of such a series is taken to be at least
     * `decay` for H1 and dH, and at least decay_J for J. In a train, `decay` is r^-q theta_1'(theta_inf), the
     * ratio that successive terms of H1 approach far down the train, and decay_J is 0. In a row, joint_make
     * sets both. */
    real decay, decay_J;
    struct tilt c;   /* theta_c (2; a2) */
    struct tilt inf; /* theta_inf (40; A16) */
    struct tilt f;   /* theta_f (42; A18) if followers detach, else theta_inf */
    /* theta_leave, the tilt of a leader at which its follower detaches. In a train, it is set only if
     * followers detach. In a row, it is pi (so y = -1) if the follower does not detach. */
    struct tilt leave;
    bool detaches; /* (41; A17) */
    struct far far;
    size_t n; /* number of dominoes from this one to the end of the chain */
    /* The geometry of the follower in a row. NULL in a train, whose dominoes share one geometry. */
    const struct geometry *follower;
    real upright_inertia; /* i(0) of struct rounded; 1 with sharp edges */
    real span; /* the largest gap that a head can reach across, divided by its height; 1 with sharp edges */
    struct rounded rounded;
    real lean; /* tilt before the hit; 0 if the domino is plumb */
};

#define CHAIN_ENDLESS SIZE_MAX

/* Returns -d2h/dtheta2 of one domino. With sharp edges, this is also the potential energy h(theta) itself. */
KERNEL_LOOP real geometry_height(const struct geometry *geometry, struct tilt t)
{
    return geometry->h.y * t.y + geometry->h.x * t.x;
}

/* Returns dh/dtheta of one domino. It is 0 at theta_u. */
KERNEL_LOOP real geometry_lift(const struct geometry *geometry, struct tilt t)
{
    return geometry->h.x * t.y - geometry->h.y * t.x + geometry->rounded.roll;
}

/* These two functions return i(theta) of struct rounded, and its derivative. */
KERNEL real geometry_inertia(const struct geometry *geometry, struct tilt t)
{
    const struct rounded *of = &geometry->rounded;
    return of->i.c + of->i.x * t.x + of->i.y * t.y;
}

KERNEL real geometry_inertia_slope(const struct geometry *geometry, struct tilt t)
{
    return geometry->rounded.i.x * t.y - geometry->rounded.i.y * t.x;
}

/*
 * Returns an estimate of the smallest tilt of the head that matters at the beginning of a cycle. Two tilts
 * can matter. At theta_u, the head tips over. At the second tilt, a follower that started near pi/2 begins to
 * turn more slowly than the head. Returns the smaller of the two tilts, or, if one of them is 0, the other
 * one. (theta_u is 0 if the edges have the radius d/2. The second tilt is 0 if the edges are sharp and
 * r s = 1.)
 */
KERNEL real geometry_finest(const struct geometry *geometry)
{
    const struct rounded *of = &geometry->rounded;
    real theta_u = geometry->h.x / geometry->h.y,
         down = sqrt(geometry->short_of + of->rho * of->rho / (2 * of->tall));
    return theta_u > 0 && !(down > 0 && down < theta_u) ? theta_u : down;
}

/* Checks the parameters of a train and of the computation (entry.c). */
KERNEL enum dom_status train_check(const struct dom_train *train, const struct dom_compute *compute);

/* Checks the separation and the growth of a train, and sets what depends on them, such as theta_c and
 * theta_inf. May be called again with other values. Returns DOM_OUT_OF_REACH if r s is too large. */
KERNEL enum dom_status geometry_set(struct geometry *geometry, real s, real r);

/* Sets gravity and gives the dominoes sharp edges. geometry->d must be set. */
KERNEL void geometry_gravity(struct geometry *geometry, real along, real down);

/* Gives the dominoes rounded edges. rho is the radius of the edges divided by the height. Before the call,
 * gravity, geometry->d and geometry->inertia_factor must be set. If rho > d/2, returns DOM_NO_ROUND. */
KERNEL enum dom_status rounded_make(struct geometry *geometry, real rho);

/* The parts of the functions below, and of joint_make (row/joint.c), for rounded edges. rounded_hit
 * returns the tilt at which a head hits the next domino, with `gap` in units of the height of the head, and
 * `sharp` is how much farther it could reach with sharp edges. */
KERNEL enum dom_status rounded_set(struct geometry *geometry);
KERNEL void rounded_joint(struct geometry *geometry, const struct geometry *follower);
KERNEL struct tilt rounded_hit(const struct rounded *of, real gap, real sharp);
KERNEL struct tilt rounded_leader(const struct geometry *geometry, struct tilt follower);
/* Returns h(0) - h(theta) for one domino with rounded edges. */
KERNEL real rounded_fall(const struct geometry *geometry, struct tilt t);

/* Returns the leader's tilt for a given tilt (>= theta_c) of its follower. */
KERNEL struct tilt geometry_leader(const struct geometry *geometry, struct tilt follower);

/* Returns h(0) - h(theta_f), the paper's fuel (25; c7). */
KERNEL real geometry_paper_fuel(const struct geometry *geometry);

/* Returns tau_1^2 omega_1c^2. Here omega_1c is the angular velocity that domino 1 has at theta_c after it has
 * tipped over by itself, so theta_c must be at least theta_u. With sharp edges, the result is
 * h(theta_u) - h(theta_c), by equation (9; b5). */
KERNEL real geometry_tipped_omegasq(const struct geometry *geometry);

/* A single domino tips over at theta_u. These functions return theta_u, tan(theta_u / 2) and
 * h(theta_u) - h(0). */
KERNEL_SHARED real geometry_theta_u(const struct geometry *geometry);
KERNEL real geometry_half_u(const struct geometry *geometry);
KERNEL real geometry_rise_u(const struct geometry *geometry);

/* Converts an angle to a tilt. If the angle equals theta_c apart from rounding, the result is theta_c.
 * Returns DOM_BAD_TILT if the angle is less than the lean of the head (0 in a train), or exceeds theta_c. */
KERNEL_SHARED enum dom_status geometry_tilt(const struct geometry *geometry, real theta, struct tilt *tilt);

/* Returns the largest gap that a head with edges of radius rho can reach across. Both lengths are in units of
 * the head's height. */
KERNEL real reach_span(real rho)
{
    return 1 - 2 * rho + rho * PI / 2;
}

KERNEL struct tilt tilt_make(real x, real y)
{
    return (struct tilt){.x = x, .y = y, .v = x * x / (1 + y)};
}

KERNEL real tilt_angle(struct tilt t)
{
    return atan2(t.x, t.y);
}

/* Returns the tilt whose p = tan(theta / 2) is given. Searches vary p instead of the angle: p needs no
 * trigonometry, and keeps all digits of small tilts. */
KERNEL struct tilt tilt_half(real p)
{
    real pp = p * p, share = 2 / (1 + pp);
    return (struct tilt){.x = p * share, .y = 1 - pp * share, .v = pp * share};
}

KERNEL real half_of_tilt(struct tilt t)
{
    return t.x / (1 + t.y);
}

/* Returns the tangent of half the angle between two tilts. If `from` is upright, no digits are lost to
 * cancellation. */
KERNEL_LOOP real tan_half_between(struct tilt from, struct tilt head)
{
    real sine = head.x * from.y - head.y * from.x, cosine = head.y * from.y + head.x * from.x;
    return sine / (1 + cosine);
}

/* Returns the tilt of a domino before it is hit. */
KERNEL struct tilt geometry_rest(const struct geometry *geometry)
{
    return geometry->lean == 0 ? standing : tilt_make(sin(geometry->lean), cos(geometry->lean));
}
