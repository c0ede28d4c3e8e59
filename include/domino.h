/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * libdomino computes how a row of dominoes falls, and how much larger each domino may be than the one before.
 *
 * A train is an endless row of dominoes (J. M. J. van Leeuwen, "Domino Magnification"). Each domino is r
 * times as large as the one before. The falling dominoes lean on each other. The library determines whether a
 * train keeps falling, how large r may be, how fast the train runs and which forces act, and the same for a
 * finite row of any dominoes (<domino_row.h>). Describe the train, call a function, and check the status:
 *
 *     struct dom_train train = dom_train_default();
 *     struct dom_limit limit;
 *     train.s = 0.4;
 *     if (dom_limit_rmax(&train, NULL, &limit) == DOM_OK)
 *         printf("%.12g\n", limit.r_max);
 *
 * The second argument says how to compute (struct dom_compute). NULL means double precision and a relative
 * tolerance of 1e-12.
 *
 * Units: lengths are in units of the height h of the head, energies in m g h / 2 of the head, and times in
 * tau (1; a1). dom_scale_tau returns tau in seconds. Angles are in radians from the vertical. Only struct
 * dom_scale and rows are in metres, kilograms and seconds.
 *
 * Numbers: the head is the foremost falling domino and has number 0. Its followers are the dominoes that push
 * it. They have the numbers 1, 2, ..., counted backwards from the head.
 *
 * Statuses: a function that can fail returns a status. DOM_BAD_... names the parameter that is outside its
 * range. With any status but DOM_OK, the result is not written, unless the function's comment says otherwise.
 *
 * Precision: the functions in this header compute in double. <domino_float.h> and <domino_quad.h> declare
 * its functions, structures and macros again, for float and for the widest floating-point type of the
 * machine. Their names begin with domf_ and domq_ instead of dom_. The widest type is __float128 if the
 * machine has it, otherwise long double. If that is no wider than double, the functions return
 * DOM_NO_PRECISION.
 *
 * Errors: to learn how accurate a number is, compute it again with a function of <domino_quad.h> and the
 * tolerance 1e-30. The two numbers differ by the error of the first one.
 *
 * Versions: struct dom_train, struct dom_row and struct dom_compute have room for members of later versions,
 * which are off at 0. A program that sets such a member gets DOM_NEWER from a library that does not know it.
 * The structures of results do not grow: a new result has a new function.
 *
 * Threads: functions keep no state between calls, do no input or output, and may be called from any thread.
 *
 * Equations: "(24; c6)" in a comment is an equation of the paper. 24 is its printed number, and c6 is its
 * label in the source text. "corrected" marks an equation that is misprinted in the paper. The equations hold
 * for trains without effects. The member `help` of struct dom_effect says what an effect changes.
 */
#ifndef DOMINO_H
#define DOMINO_H

#include "domino_common.h"
#include <math.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this header. */
#define DOM_VERSION "2.0"

/* Returns the version of the library, which may be newer than this header. */
const char *dom_version(void);

/* ==== From here on everything is also in <domino_float.h> and <domino_quad.h> ==== */

/* The type of parameters and results. */
typedef double dom_real;

/* The value of a result that does not exist. */
#define DOM_NAN ((dom_real)NAN)

/* ---- The train ---- */

/* Returns the largest growth of a train, or NaN: dom_limit_rmax in one call. */
dom_real dom_rmax(dom_real s, dom_real d, dom_real q);

/* The parameters of a train: X(name, default, lowest, highest, unit, meaning). Ranges include both ends. */
#define DOM_TRAIN_PARAMETERS(X)                                                                              \
    X(s, (dom_real)4 / 10, 1e-6, 1, "h", "separation: the gap before a domino divided by its height")        \
    X(r, (dom_real)3 / 2, 1, 1e6, "", "growth: the size of each domino relative to the one before")          \
    X(d, (dom_real)7 / 48, 1e-12, 100, "h", "thickness divided by height")                                   \
    X(q, 4, 1e-6, 100, "", "mass exponent: 4 for solid dominoes, 3 for hollow ones")                         \
    X(width, (dom_real)1 / 2, 1e-12, 100, "h", "width divided by height")

/* The largest friction coefficient between dominoes. */
#define DOM_MU_HIGHEST 100

/*
 * A self-similar train. Start from dom_train_default() and change the members that differ. These are the
 * effects of DOM_DYNAMICS, which are off at 0:
 * - mu: the coefficient of Coulomb friction between dominoes, 0 ... DOM_MU_HIGHEST.
 * - alpha: the slope of the floor in radians, -1.5 ... 1.5, positive if the floor slopes down in the
 *   direction of the train. DOM_NO_STAND if no domino can stand upright on that slope.
 * - walls: the thickness of the walls of hollow boxes divided by the height, 1e-9 ... 1. The width counts
 *   only together with walls or air. DOM_NO_ROOM if the walls do not fit.
 * - rho: the radius of the edges divided by the height, 0 ... 0.49. DOM_NO_ROUND if rho is more than d/2.
 * - air: the density of the air divided by that of the dominoes, 0 ... 100. DOM_NO_AIR unless q is 4,
 *   because other trains are not self-similar in air. drag is the drag coefficient, 0.001 ... 100, where 0
 *   stands for 1.2.
 *
 * With mu, alpha, rho or air, answers that depend on the fuel return DOM_NO_METHOD for DOM_FUEL_PAPER.
 */
struct dom_train {
    dom_real s, r, d, q, width; /* see DOM_TRAIN_PARAMETERS */
    enum dom_fuel fuel;         /* default DOM_FUEL_EXACT */
    dom_real mu, alpha, walls, rho, air, drag;
    dom_real later[DOM_LATER]; /* must be 0, see "Versions" */
};

#define DOM_SCALE_PARAMETERS(X)                                                                              \
    X(h, (dom_real)48 / 1000, (dom_real)1 / 1000000000, 1e9, "m", "height of the first domino")              \
    X(g, (dom_real)981 / 100, (dom_real)1 / 1000000000, 1e9, "m/s^2", "acceleration of gravity")

struct dom_scale {
    dom_real h, g;
};

struct dom_train dom_train_default(void);
struct dom_scale dom_scale_default(void);

/* ---- How to compute ---- */

#define DOM_COMPUTE_PARAMETERS(X)                                                                            \
    X(tol, 1 / (dom_real)1e12, 1e-34, 0.1, "", "relative tolerance of the answers")

/* How to compute. Start from dom_compute_default(), or pass NULL to use the defaults. */
struct dom_compute {
    dom_real tol;          /* relative tolerance of the results */
    struct dom_work *work; /* counters to which the work is added; may be NULL */
    /* A long computation returns DOM_INTERRUPTED soon after *interrupt becomes non-zero. May be NULL. */
    const volatile sig_atomic_t *interrupt;
    size_t later[DOM_LATER]; /* must be 0, see "Versions" */
};

struct dom_compute dom_compute_default(void);

/* The properties of the floating-point type dom_real. */
struct dom_arithmetic {
    const char *name;                /* "float", "double" or "quad" */
    const char *type;                /* the C type that is used */
    int bits;                        /* bits of the significand; 0 if the machine has no such type */
    double epsilon;                  /* twice the unit roundoff */
    dom_real tol_default, tol_floor; /* a sensible tolerance, and the smallest allowed one */
    int digits;                      /* significant digits worth printing at tol_default */
};

const struct dom_arithmetic *dom_arithmetic(void);

/* Returns the largest growth at which the head can still touch the next domino: (1 - 2 rho + rho pi/2)/s,
 * which is 1/s with sharp edges. Does not use train->r. */
dom_real dom_train_reach(const struct dom_train *train);

/* ---- One domino leaning on the next (section 'Two dominoes' and appendix A) ---- */

struct dom_angles {
    dom_real theta_c;   /* the head hits the next domino at this angle: sin theta_c = r s (2; a2) */
    dom_real theta_u;   /* a single domino tips over at this angle: tan theta_u = d (4; b1) */
    dom_real theta_inf; /* the angle that distant followers approach: cos theta_inf = d / (s + d) (40; A16) */
    dom_real theta_f;   /* the final angle of a follower: (42; A18) if it detaches, otherwise theta_inf */
    /* The angle of a leader at which its follower detaches. NaN if no follower does. */
    dom_real theta_leave;
    bool detaches; /* true if followers detach from their leaders (41; A17) */
};

/* Finds the angles of a train. Like every function below that takes a train, checks it first: DOM_OK means
 * that every parameter is in its range, that tol is at least dom_arithmetic()->tol_floor, and that the head
 * reaches the next domino, r <= dom_train_reach. Otherwise the status is DOM_BAD_..., DOM_OUT_OF_REACH,
 * DOM_UNDERFLOW, DOM_NO_METHOD or DOM_NO_PRECISION, or one named at struct dom_train. If r is 1/s rounded to
 * the precision, r s counts as 1, even if rounding has made it slightly larger. */
enum dom_status dom_angles_find(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_angles *angles);

/* The contact of a domino at the tilt theta with the follower that leans on it. */
struct dom_contact {
    /* If the follower has detached: theta_1 = theta_f, slope = 0, and the arms are NaN. */
    dom_real theta_1; /* angle of the follower (12; b8) */
    dom_real slope;   /* d theta_1 / d theta (14; b10) */
    dom_real arm_a;   /* lever arm of the contact force on the leader, in h */
    dom_real arm_b;   /* lever arm of the contact force on the follower, in h */
};

/* For a tilt theta outside 0 ... theta_c, this function and all functions below return DOM_BAD_TILT. */
enum dom_status dom_contact_find(const struct dom_train *train, const struct dom_compute *compute,
                                 dom_real theta, struct dom_contact *contact);

/* ---- The dominoes of the train at one tilt ---- */

/* Domino i of the train. */
struct dom_link {
    size_t i;
    dom_real theta; /* its angle theta_i (27; A2) */
    dom_real slope; /* d theta_i / d theta (33; A9) */
    /* The lever arms, in h, of the contact with domino i + 1 (table 1). NaN if the two do not touch. */
    dom_real arm_a, arm_b;
    dom_real weight; /* r^(-q i), the weight of the domino in H (19; c1) */
};

/* Visits the head and each follower that is not negligible at the tolerance, while the head leans at theta.
 * Here and below, a visitor may return false to end the walk early; the status is still DOM_OK. */
typedef bool dom_visit(const struct dom_link *link, void *context);
enum dom_status dom_chain_walk(const struct dom_train *train, const struct dom_compute *compute,
                               dom_real theta, dom_visit *visit, void *context);

/* ---- Energy ---- */

struct dom_energy {
    dom_real dH; /* H(theta) - H(0), where H is the potential energy (19; c1), in m g h / 2 */
    dom_real J;  /* inertia: the kinetic energy is J tau^2 omega^2 (20; c2) */
    dom_real J0; /* J(0) = 1 + r^(-(q+1)) J(theta_c), by equation (50; d8, corrected) */
};

enum dom_status dom_energy_find(const struct dom_train *train, const struct dom_compute *compute,
                                dom_real theta, struct dom_energy *energy);

struct dom_fuels {
    dom_real exact; /* the potential energy lost in one cycle: H(0) - H(theta_c) */
    /* the paper's closed form (25; c7), h(0) - h(theta_f), which holds only for r = 1 */
    dom_real paper;
};

/* Finds the fuel, which drives a cycle, by both formulas. If it is <= 0, the train does not keep falling. */
enum dom_status dom_fuel_find(const struct dom_train *train, const struct dom_compute *compute,
                              struct dom_fuels *fuels);

/* ---- Collision ---- */

struct dom_launch {
    /* The fuel P that train->fuel selects. With friction or air, this member is instead the kinetic energy
     * that a cycle would have at its end if it had none at its start. */
    dom_real fuel;
    dom_real J0; /* J(0) */
    /* omega(0) just after the collision, divided by omega_1(theta_c) just before the collision. By equation
     * (22; c4) the ratio is (J(0) - 1) / J(0). */
    dom_real velocity_ratio;
    dom_real omegasq; /* tau^2 omega(0)^2 after the collision (24; c6) */
    dom_real kinetic; /* J(0) tau^2 omega(0)^2 */
};

/* Finds the motion just after a collision. With DOM_NO_FUEL (P <= 0), omegasq and kinetic are NaN, and the
 * other members are written. If friction prevents the cycle from beginning, this function and all that
 * compute a cycle return DOM_LOCKS. */
enum dom_status dom_launch_find(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_launch *launch);

/* ---- Barrier and verdict ---- */

struct dom_barrier {
    dom_real theta_m; /* the tilt at the top of the barrier, 0 <= theta_m <= theta_c */
    /* The maximum of H(theta) - H(0), >= 0. With friction or air, it is instead the kinetic energy that the
     * train needs just after the collision to pass every tilt. */
    dom_real barrier;
    dom_real kinetic; /* kinetic energy just after the collision; NaN with DOM_NO_FUEL */
    dom_real margin;  /* kinetic - barrier (26; c8, corrected); NaN with DOM_NO_FUEL */
    /* The tilt at which a train that stops comes to rest: the smallest tilt at which the climb H(theta) -
     * H(0) has used up the kinetic energy of the launch. NaN unless the status is DOM_STOPS. */
    dom_real stop;
};

/* Determines whether the train keeps falling. The status is the verdict:
 * - DOM_OK: the train keeps falling (margin >= 0).
 * - DOM_STOPS: the train stops. All members are written.
 * - DOM_NO_FUEL: a cycle releases no energy. Only theta_m and barrier are computed.
 * All functions that compute a cycle give the same verdict, with a finer tolerance if that needs one. */
enum dom_status dom_barrier_find(const struct dom_train *train, const struct dom_compute *compute,
                                 struct dom_barrier *barrier);

/* ---- One cycle ----
 *
 * The status of these functions is DOM_NO_FUEL if there is no cycle, and DOM_STOPS if the train stops before
 * the tilt theta or, without a tilt, before the end of the cycle. Functions that find a time return
 * DOM_NO_MARGIN if the margin is 0 within rounding errors. */

/* Finds tau^2 omega^2 of the head at theta (21; c3), or NaN. */
enum dom_status dom_cycle_omegasq(const struct dom_train *train, const struct dom_compute *compute,
                                  dom_real theta, dom_real *omegasq);

/* Finds the duration t_f of a cycle in tau, the integral of 1/(tau omega) from 0 to theta_c. Where the margin
 * is small, it grows like ln(1 / margin), and its relative error like kinetic / margin times the unit
 * roundoff. */
enum dom_status dom_cycle_duration(const struct dom_train *train, const struct dom_compute *compute,
                                   dom_real *duration);

struct dom_event {
    enum dom_event_kind kind;
    dom_real theta; /* tilt of the head */
    dom_real time;  /* time since the launch, in tau */
    size_t domino;  /* number of the domino that detaches; 0 for all other events */
};

/* Finds the events of the cycle in order, at most DOM_EVENTS_MAX, also if the status is DOM_STOPS. The last
 * event is then DOM_EVENT_STOP. With any other error, *count is 0. */
enum dom_status dom_cycle_events(const struct dom_train *train, const struct dom_compute *compute,
                                 struct dom_event *events, int *count);

/* The train at one tilt of a cycle. Energies are in units of m g h / 2 of the head. Unless the paper's fuel
 * is used, the energies balance: before - lost - climbed - friction_work = kinetic. */
struct dom_state {
    dom_real theta;         /* tilt of the head */
    dom_real time;          /* time since the launch, in tau */
    dom_real omegasq;       /* tau^2 omega^2 (21; c3) */
    dom_real acceleration;  /* tau^2 times the angular acceleration of the head */
    dom_real kinetic;       /* J(theta) tau^2 omega^2 */
    dom_real climbed;       /* H(theta) - H(0), negative while the train is lower than at the launch */
    dom_real fallen;        /* the part of `climbed` due to dominoes that detached in this cycle */
    dom_real before;        /* kinetic energy just before the collision */
    dom_real lost;          /* energy lost in the collision, `before` / J(0) by equation (22; c4) */
    dom_real friction_work; /* energy lost to friction and to the air since the launch */
};

enum dom_status dom_cycle_state(const struct dom_train *train, const struct dom_compute *compute,
                                dom_real theta, struct dom_state *state);

/* Visits the states of a cycle in chronological order: `count` states that are evenly spaced over the cycle,
 * for which `event` is NULL, and one state at each event. This takes far less time than dom_cycle_state for
 * each. DOM_STOPS is returned after all states. */
typedef bool dom_state_visit(const struct dom_state *state, const struct dom_event *event, void *context);
enum dom_status dom_cycle_walk(const struct dom_train *train, const struct dom_compute *compute, size_t count,
                               enum dom_spacing by, dom_state_visit *visit, void *context);

/* If the smallest force and the smallest impulse are > 0, the dominoes stay in contact. If there is no
 * contact at all, both are infinite. */
struct dom_least_force {
    dom_real force; /* the smallest force of the cycle, divided by the weight of the domino that it pushes */
    dom_real theta; /* the tilt of the head at which the smallest force occurs */
    size_t domino;  /* the domino that is pushed, 0 = head */
    dom_real impulse; /* the smallest impulse of the collision, divided by the head's m g tau */
};

/* Finds the smallest contact force during the cycle, or until the train stops, with an error of at most 1e-5
 * of the weight of the pushed domino. A train that stops has the status DOM_OK. */
enum dom_status dom_cycle_least_force(const struct dom_train *train, const struct dom_compute *compute,
                                      struct dom_least_force *least);

/* ---- The limits of growth ---- */

struct dom_limit {
    dom_real r_max;    /* the largest growth; NaN with DOM_END_NONE */
    enum dom_end ends; /* what limits the growth */
    /* DOM_OK or, with DOM_END_NONE, how r = 1 ends: DOM_NO_FUEL, DOM_STOPS, DOM_LOCKS, DOM_OUT_OF_REACH. */
    enum dom_status why;
    /* How far r_max may be from its exact value because of rounding errors and the tolerance, estimated from
     * the slope of the margin. NaN with DOM_END_NONE. */
    dom_real uncertainty;
    dom_real open; /* with DOM_OPEN, a growth below r_max that may be the limit; otherwise NaN */
};

/* Finds the largest growth of a train: the first growth r >= 1 at which the margin falls to 0, or
 * dom_train_reach if there is none. If even equal dominoes do not keep falling, the status is DOM_OK and
 * `ends` is DOM_END_NONE. Does not use train->r. Only a dip of the margin that leaves no trace in the samples
 * of the search can be missed. If rounding errors hide the sign of a minimum, even in quad precision, the
 * status is DOM_OPEN: the largest growth is then either `open`, the growth of this minimum, or `r_max`, a
 * later root. This function and the next two return DOM_TOO_LONG if the computation would take more than a
 * second or two in double precision. */
enum dom_status dom_limit_rmax(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_limit *limit);

/* Finds the largest growth of a pair of dominoes (section "Two dominoes"). Domino 1 starts at the point of
 * tipping over and must carry domino 0 over the barrier of the pair. Domino 1 tips over only if r is large
 * enough (5; b0), so r_max is the upper end of the first interval of growths that succeed. Does not use
 * train->r and train->fuel. */
enum dom_status dom_limit_pair(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_limit *limit);

struct dom_best {
    dom_real s;     /* the separation that allows the largest growth */
    dom_real r_max; /* the largest growth at the separation s */
    /* How far s and r_max may be from their exact values. The train with the separation s keeps falling at
     * growths up to r_max - r_uncertainty. */
    dom_real s_uncertainty, r_uncertainty;
};

/* Finds the separation that allows the largest growth. Does not use train->s and train->r. The status is
 * DOM_NO_GROWTH if no separation allows r > 1. Often r_max jumps at the best separation, because a dip of the
 * margin touches 0 there. Then s is on the side of the jump where the train passes the dip. */
enum dom_status dom_limit_best(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_best *best);

/* ---- Effects ---- */

/* An argument of an effect. Its value is a number. */
struct dom_effect_argument {
    const char *name, *unit, *meaning;
    dom_real lowest, highest; /* the range of the argument; both ends are allowed */
    dom_real usual;           /* a typical value, which is the default of an optional argument */
    bool optional;            /* this argument and all later ones may be left out */
    bool whole;               /* the argument is a whole number */
    const char *or_file;      /* the kind of file that may replace the number, or NULL */
    /* The words for the values 0, 1, ..., ended by NULL. NULL if the argument is a number. */
    const char *const *words;
};

/* The description of an effect. */
struct dom_effect {
    const char *name;
    const char *adds;   /* what the effect adds, in a few words */
    const char *help;   /* a description in full sentences, with equations in the paper's notation */
    const char *source; /* the publication from which the mathematics comes */
    struct dom_effect_argument argument[DOM_EFFECT_ARGUMENTS]; /* a NULL name ends the list early */
    unsigned needs;         /* the effects that must be on as well, as bits 1 << DOM_EFFECT_... */
    const char *dissipates; /* what takes energy from moving dominoes, in a few words; NULL if nothing does */
    const char *const *equations; /* that the effect adds or changes, ended by NULL; NULL if there are none */
    bool cancels; /* true if the effect changes only tau, so that times in units of tau stay the same */
    const char *synonyms; /* search words for the effect, separated by blanks */
};

/* The descriptions of all effects. dom_effect returns one of them, or NULL if there is no such effect. */
extern const struct dom_effect dom_effect_friction, dom_effect_slope, dom_effect_walls, dom_effect_edges,
    dom_effect_air, dom_effect_drag, dom_effect_row, dom_effect_push, dom_effect_release;
const struct dom_effect *dom_effect(enum dom_effect_name name);

/* Returns the first effect that is on in a train and changes anything besides tau, or NULL. */
const struct dom_effect *dom_first_effect(const struct dom_train *train);

/* Returns true if dominoes lose energy while they move. If not, energy is conserved between collisions. */
bool dom_dissipates(const struct dom_train *train);

/* ---- Metres and seconds ---- */

/* A hollow box with six walls of the same thickness. */
struct dom_box {
    dom_real filled;  /* volume of the walls divided by the volume of the box */
    dom_real inertia; /* about a lower edge, divided by that of a solid block of equal mass */
};

/* The four lengths have the same unit, and the first three are outer sizes. The status is DOM_NO_ROOM if a
 * size is not positive, or if the walls are thicker than half the thickness of the box. */
enum dom_status dom_box_find(dom_real height, dom_real thickness, dom_real width, dom_real walls,
                             struct dom_box *box);

/* Returns the unit of time tau in seconds (1; a1). For solid blocks it is sqrt((h^2 + (d h)^2) / (3 g h)).
 * For boxes it is larger. Does not check the arguments. */
dom_real dom_scale_tau(const struct dom_scale *scale, const struct dom_train *train);

/* Returns the front speed in m/s: the distance (s + d) r h divided by the duration of a cycle. The argument
 * `duration` is in tau. Does not check the arguments. */
dom_real dom_scale_speed(const struct dom_scale *scale, const struct dom_train *train, dom_real duration);

struct dom_count {
    /* The number n: the smallest integer with first * r^n >= height; infinite if r = 1 and height > first. */
    dom_real dominoes;
    dom_real exact; /* ln(height / first) / ln r; equal to `dominoes` if r = 1 */
    dom_real last;  /* first * r^n, in the unit of `first`; NaN if n is infinite */
};

/* Finds how many dominoes it takes to topple one that is at least `height` tall, if the first domino has the
 * height `first`, in the same unit, and each is r times as tall as the one before. first * r^n counts as
 * equal to `height` if the two differ by at most 2 + n/2 units in the last place, and relatively by at most a
 * millionth of ln r. The status is DOM_BAD_HEIGHT if a height is not a finite number > 0, or if n or height /
 * first is too large or too small for the precision, and DOM_BAD_R if r is not a finite number >= 1. */
enum dom_status dom_count_find(dom_real first, dom_real height, dom_real r, struct dom_count *count);

#ifdef __cplusplus
}
#endif

#endif
