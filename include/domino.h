/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * libdomino: how far can a domino train grow?
 *
 * The model of J. M. J. van Leeuwen, "Domino Magnification": an endless row of dominoes, each r times
 * larger than the one before, that lean on each other without friction while they fall. "(c6)" in a
 * comment is the equation of the paper with that label; "corrected" marks where the paper has a slip.
 *
 * Units: lengths in the height h of the head (the foremost falling domino, number 0; its pushers are
 * 1, 2, ... down the train), energies in m g h / 2 of the head, angles in radians from the vertical,
 * time in tau (a1).  Only struct dom_scale brings in metres and seconds.
 *
 * Every function is free of global state and of input and output.  Functions that can fail return a
 * status; unless it is DOM_OK (or the comment says otherwise) nothing was written to the result.
 */
#ifndef DOMINO_H
#define DOMINO_H

#include <math.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define DOM_VERSION "0.1.0"

/*
 * The widest arithmetic there is: parameters and answers travel in it, whatever precision computes them.
 * It converts from and to double as every floating type does; printf wants (double)x.
 */
#if defined __SIZEOF_FLOAT128__ && defined __GLIBC__ && !defined DOM_NO_FLOAT128
__extension__ typedef __float128 dom_real;
#define DOM_REAL_FLOAT128
#else
typedef long double dom_real;
#endif

/* What does not exist. */
#define DOM_NAN ((dom_real)NAN)

/* ---- Statuses: X(name, what it means) ---- */

#define DOM_STATUSES(X)                                                                                      \
    X(OK, "no error")                                                                                        \
    X(BAD_PARAMETER, "a parameter is outside its range")                                                     \
    X(OUT_OF_REACH, "r s > 1: the head falls past the next domino without touching it")                      \
    X(BAD_TILT, "the tilt is outside [0, theta_c]")                                                          \
    X(NO_FUEL, "the fuel P is not positive: a cycle sets no energy free")                                    \
    X(STOPS, "the kinetic energy after the collision is below the barrier")                                  \
    X(LOCKS, "friction locks the train: a contact force passes behind the hinge that it is to turn")         \
    X(NO_MARGIN, "the margin is 0 to rounding: times grow like ln(1/margin) and have no value here; a "      \
                 "slightly smaller r has")                                                                   \
    X(NO_GROWTH, "even equal dominoes (r = 1) do not keep falling at this separation")                       \
    X(TOO_LONG, "more dominoes matter than can be followed")                                                 \
    X(UNDERFLOW, "r^(2q+1) is beyond the range of the precision; a smaller r or q is not")                   \
    X(NO_PRECISION, "this machine has no arithmetic of that precision")                                      \
    X(NO_METHOD, "this method does not give that answer")                                                    \
    X(NOT_FINITE, "a value on the way is not finite")                                                        \
    X(NOT_CONVERGED, "the iteration did not reach the tolerance")                                            \
    X(NO_MEMORY, "out of memory")                                                                            \
    X(INTERRUPTED, "interrupted")

enum dom_status {
#define DOM_STATUS_ENUM(name, text) DOM_##name,
    DOM_STATUSES(DOM_STATUS_ENUM)
#undef DOM_STATUS_ENUM
};

/* What a status means, as one line without a full stop. */
const char *dom_status_text(enum dom_status status);

/* ---- Precision ---- */

enum dom_precision { DOM_FLOAT, DOM_DOUBLE, DOM_QUAD };

struct dom_arithmetic {
    const char *name; /* of the precision: "float", "double", "quad" */
    const char *type; /* of C that it is made of */
    int bits;         /* of the significand; 0 where this machine has no such arithmetic */
    double epsilon;   /* twice the unit roundoff */
    dom_real tol_default, tol_floor;
    int digits; /* of an answer, worth printing at tol_default */
};

/* quad is __float128 where the compiler and the library have it, else long double if that is wider. */
const struct dom_arithmetic *dom_arithmetic(enum dom_precision precision);

/* ---- Parameters: X(name, default, lowest, highest, unit, meaning); both ends are allowed ---- */

#define DOM_TRAIN_PARAMETERS(X)                                                                              \
    X(s, (dom_real)4 / 10, 1e-6, 1, "h", "separation: free gap to the next domino over height")              \
    X(r, (dom_real)3 / 2, 1, 1e6, "", "growth: how much larger each domino is than the one before")          \
    X(d, (dom_real)7 / 48, 1e-12, 100, "h", "thickness over height")                                         \
    X(q, 4, 1e-6, 100, "", "mass exponent: hollow = 3, massive = 4")                                         \
    X(tol, 1 / (dom_real)1e12, 1e-34, 0.1, "", "relative tolerance of the answers")

#define DOM_SCALE_PARAMETERS(X)                                                                              \
    X(h, (dom_real)48 / 1000, (dom_real)1 / 1000000000, 1e9, "m", "height of the first domino")              \
    X(g, (dom_real)981 / 100, (dom_real)1 / 1000000000, 1e9, "m/s^2", "acceleration of gravity")

/*
 * Effects beyond the paper: struct dom_effect says what each adds.  One that is off is not computed, and none
 * of its code is entered (struct dom_work counts).
 *
 * Effects that change how dominoes move, each in src/model/dynamics/: X(effect, the member of struct
 * dom_train and struct dom_row that holds its value; 0 is off).
 */
#define DOM_DYNAMICS(X) X(friction, mu)

/* How many these are; they come first in enum dom_effect_name. */
#define DOM_DYNAMICS_ONE(name, member) +1
enum { DOM_DYNAMICS_COUNT = DOM_DYNAMICS(DOM_DYNAMICS_ONE) };
#undef DOM_DYNAMICS_ONE

/* Effects of a row and of what is asked about it, each in src/model/effects/: X(effect). */
#define DOM_EFFECTS(X) X(row) X(push) X(placement) X(floor)

enum dom_effect_name {
#define DOM_DYNAMICS_ENUM(name, member) DOM_EFFECT_##name,
#define DOM_EFFECT_ENUM(name)           DOM_EFFECT_##name,
    DOM_DYNAMICS(DOM_DYNAMICS_ENUM) DOM_EFFECTS(DOM_EFFECT_ENUM)
#undef DOM_DYNAMICS_ENUM
#undef DOM_EFFECT_ENUM
        DOM_EFFECT_COUNT
};

/* The largest friction coefficient that is taken. */
#define DOM_MU_HIGHEST 100

/* The fuel P that enters (c6): see dom_fuel_find. */
enum dom_fuel { DOM_FUEL_EXACT, DOM_FUEL_PAPER };

/*
 * Who computes: this library; or, to compare with and in double precision only, solvers of GSL around the
 * textbook formulas, and the paper's own recipe, which raises theta and r step by step.
 */
enum dom_method { DOM_METHOD_OURS, DOM_METHOD_GSL, DOM_METHOD_PAPER };

/* The work that answers took; every answer adds its own. */
struct dom_work {
    size_t passes;                    /* evaluations: passes down the train */
    size_t dominoes;                  /* followed in all of them */
    size_t longest;                   /* in one pass */
    size_t entered[DOM_EFFECT_COUNT]; /* how often the code of an effect was */
};

/*
 * Is the flag of an interrupt up?  NULL never is.  A handler of signals in one thread may raise what others
 * look at: where both are atomic, as here, that is no race.
 */
static inline bool dom_raised(const volatile sig_atomic_t *flag)
{
#if defined __GNUC__
    return flag && __atomic_load_n(flag, __ATOMIC_RELAXED) != 0;
#else
    return flag && *flag;
#endif
}

/* A self-similar train.  Start from dom_train_default() and change what differs. */
struct dom_train {
#define DOM_MEMBER(name, default_, lowest, highest, unit, meaning) dom_real name;
    DOM_TRAIN_PARAMETERS(DOM_MEMBER)
    enum dom_precision precision; /* in which answers are computed; parameters are rounded to it */
    enum dom_fuel fuel;
    enum dom_method method;
    /*
     * The effects of DOM_DYNAMICS, each 0 for off.  With any of them the methods to compare with and the
     * paper's closed fuel are NO_METHOD.  mu is Coulomb's friction between dominoes, >= 0: with it no bounds
     * of errors are known, they are NaN.
     */
#define DOM_DYNAMICS_MEMBER(effect, member) dom_real member;
    DOM_DYNAMICS(DOM_DYNAMICS_MEMBER)
    struct dom_work *work; /* where not NULL, counts */
    /* Where not NULL, long computations end with DOM_INTERRUPTED soon after it becomes non-zero. */
    const volatile sig_atomic_t *interrupt;
};

/* Size of the head and gravity, in SI units. */
struct dom_scale {
    DOM_SCALE_PARAMETERS(DOM_MEMBER)
#undef DOM_MEMBER
};

struct dom_train dom_train_default(void);
struct dom_scale dom_scale_default(void);

/*
 * DOM_OK where every parameter is in its range, tol not below the floor of the precision, and the head
 * reaches the next domino, r s <= 1; else BAD_PARAMETER, OUT_OF_REACH, UNDERFLOW or NO_PRECISION.
 * r = 1/s rounded to the precision counts as r s = 1.
 * Every function below that takes a train makes this check itself.
 *
 * Each of them takes a pointer `error` behind that to its result.  Where it is not NULL, it gets a bound
 * of the absolute error of every member: of rounding on the way from the parameters, as rounded to the
 * precision, and of what tol cuts off.  NULL costs nothing.
 */
enum dom_status dom_train_check(const struct dom_train *train);

/* ---- One domino leaning on the next (section 'Two dominoes' and appendix A) ---- */

struct dom_angles {
    dom_real theta_c;     /* the head hits the next domino, sin theta_c = r s          (a2) */
    dom_real theta_u;     /* a single domino tips over, tan theta_u = d                (b1) */
    dom_real theta_inf;   /* far followers approach it, cos theta_inf = d / (s + d)    (A16) */
    dom_real theta_f;     /* the last angle of a follower: (A18) if it falls off, else theta_inf */
    dom_real theta_leave; /* leader's angle at which its follower falls off; NaN if none does */
    bool detaches;        /* (A17) */
};

enum dom_status dom_angles_find(const struct dom_train *train, struct dom_angles *angles,
                                struct dom_angles *error);

/* A domino at tilt theta and the follower that leans on it. */
struct dom_contact {
    dom_real theta_1; /* angle of the follower (b8); theta_f where it has fallen off */
    dom_real slope;   /* d theta_1 / d theta (b10); 0 where it has fallen off */
    dom_real arm_a;   /* arm of the contact force on the leader, in h; NaN where fallen off */
    dom_real arm_b;   /* arm of the contact force on the follower, in h; NaN where fallen off */
};

/* 0 <= theta <= theta_c, else DOM_BAD_TILT. */
enum dom_status dom_contact_find(const struct dom_train *train, dom_real theta, struct dom_contact *contact,
                                 struct dom_contact *error);

/* ---- The train behind the head at one tilt ---- */

struct dom_link {
    size_t i;              /* number of the domino, 0 = head */
    dom_real theta;        /* its angle (A2) */
    dom_real slope;        /* d theta_i / d theta (A9) */
    dom_real arm_a, arm_b; /* of the contact with its own follower; NaN without one (table 1) */
    dom_real weight;       /* r^(-q i): its share in H (c1) */
};

/*
 * Calls visit for the head and for each follower that matters at the train's tolerance, in order;
 * visit returns false to stop the walk early (the status is still DOM_OK).  Its error is NULL unless
 * errors are asked for.
 */
typedef bool dom_visit(const struct dom_link *link, const struct dom_link *error, void *context);
enum dom_status dom_chain_walk(const struct dom_train *train, dom_real theta, bool errors, dom_visit *visit,
                               void *context);

/* ---- Energy ---- */

struct dom_energy {
    dom_real dH; /* H(theta) - H(0), H the potential energy of the train (c1), in m g h / 2 */
    dom_real J;  /* inertia of the train: kinetic energy = J tau^2 omega^2 (c2) */
    dom_real J0; /* J(0) = 1 + r^-(q+1) J(theta_c) (d8, corrected) */
};

enum dom_status dom_energy_find(const struct dom_train *train, dom_real theta, struct dom_energy *energy,
                                struct dom_energy *error);

struct dom_fuels {
    dom_real exact; /* what all dominoes lose in one cycle, with their weights: H(0) - H(theta_c) */
    dom_real paper; /* 1 - h(theta_f): the second equality of (c7), which holds only for r = 1 */
};

/* Both fuels, in m g h / 2; they may be zero or negative (no domino effect). */
enum dom_status dom_fuel_find(const struct dom_train *train, struct dom_fuels *fuels,
                              struct dom_fuels *error);

/* ---- Collision ---- */

struct dom_launch {
    dom_real fuel; /* P, the one that train->fuel selects, less what friction takes of it */
    dom_real J0;   /* J(0) */
    dom_real
        velocity_ratio; /* omega(0) over omega_1(theta_c): the share of momentum, (J(0) - 1) / J(0) (c4) */
    dom_real omegasq;   /* tau^2 omega(0)^2 after the collision (c6) */
    dom_real kinetic;   /* J(0) tau^2 omega(0)^2 */
};

/*
 * DOM_NO_FUEL where P <= 0: then fuel, J0 and keeps are written, omegasq and kinetic are NaN.
 * DOM_LOCKS, from here on also of the others: friction lets no cycle begin; nothing is written.
 */
enum dom_status dom_launch_find(const struct dom_train *train, struct dom_launch *launch,
                                struct dom_launch *error);

/* ---- Barrier and verdict ---- */

struct dom_barrier {
    dom_real theta_m; /* where the barrier is highest, 0 <= theta_m <= theta_c */
    /* max over the cycle of H(theta) - H(0), a global maximum, >= 0; with friction the kinetic energy that it
     * takes to get there */
    dom_real barrier;
    dom_real kinetic; /* after the collision; NaN without fuel */
    dom_real margin;  /* kinetic - barrier (c8, corrected); NaN without fuel */
};

/*
 * DOM_OK: the train goes on (margin >= 0).  DOM_STOPS: it does not; all members are written.  Every function
 * of one cycle gives this same verdict, also where a rough tolerance does not show it: then it is refined.
 * DOM_NO_FUEL: theta_m and barrier are written, the others are NaN.
 */
enum dom_status dom_barrier_find(const struct dom_train *train, struct dom_barrier *barrier,
                                 struct dom_barrier *error);

/* ---- One cycle ---- */

/*
 * tau^2 omega(theta)^2 on the way from one collision to the next (c3).  DOM_NO_FUEL: no cycle, NaN.
 * DOM_STOPS: the head does not come as far as theta; *omegasq is NaN.
 */
enum dom_status dom_cycle_omegasq(const struct dom_train *train, dom_real theta, dom_real *omegasq,
                                  dom_real *error);

/*
 * Where a train that does not go on comes to rest: the smallest tilt at which H(theta) - H(0) has used up
 * the kinetic energy.  DOM_OK with NaN where it does go on; DOM_NO_FUEL where it does not start.
 */
enum dom_status dom_cycle_stop(const struct dom_train *train, dom_real *theta, dom_real *error);

/*
 * Duration of a cycle t_f / tau = integral of 1/(tau omega) over [0, theta_c].  It diverges like
 * ln(1 / margin): where the margin is 0 to rounding it is NO_MARGIN, and before that its relative error
 * grows like kinetic / margin times the unit roundoff.  NO_FUEL or STOPS without a whole cycle.
 */
enum dom_status dom_cycle_duration(const struct dom_train *train, dom_real *duration, dom_real *error);

/* ---- One cycle, event by event ---- */

enum dom_event_kind {
    DOM_EVENT_LAUNCH, /* the head has been hit, and moves */
    DOM_EVENT_FALL,   /* a follower falls off the domino that it leaned on (A17) */
    DOM_EVENT_TOP,    /* the top of the barrier, where there is one */
    DOM_EVENT_STOP,   /* the train comes to rest below the top: there is no next hit */
    DOM_EVENT_HIT     /* the head hits the next domino (a2) */
};

struct dom_event {
    enum dom_event_kind kind;
    dom_real theta; /* tilt of the head */
    dom_real time;  /* since the launch, in tau */
    size_t domino;  /* that falls off; else 0, the head */
};

enum { DOM_EVENTS_MAX = 5 };

/*
 * The events of the cycle in their order, at most DOM_EVENTS_MAX.  DOM_STOPS: the last is DOM_EVENT_STOP.
 * DOM_NO_FUEL: there are none.  DOM_NO_MARGIN, of all that have a time: see dom_cycle_duration.
 */
enum dom_status dom_cycle_events(const struct dom_train *train, struct dom_event *events, int *count);

/* "launch", "fall", "top", "stop", "hit". */
const char *dom_event_text(enum dom_event_kind kind);

/*
 * The train at one tilt on its way, and the ledger of its energy in m g h / 2 of the head:
 * before - lost - climbed - rubbed = kinetic.  With the paper's fuel it does not close, since that is no
 * balance.
 */
struct dom_state {
    dom_real theta;
    dom_real time;          /* since the launch, in tau */
    dom_real omegasq;       /* tau^2 omega^2 (c3) */
    dom_real acceleration;  /* tau^2 times that of the head, (c3) differentiated */
    dom_real kinetic;       /* J(theta) tau^2 omega^2 */
    dom_real climbed;       /* H(theta) - H(0); what is negative was set free */
    dom_real fallen;        /* the part of it in dominoes that fell off in this cycle */
    dom_real before;        /* kinetic energy of the hitting train, just before the collision */
    dom_real lost;          /* of that in the collision: without friction the share 1 / J(0) (c4) */
    dom_real friction_work; /* what friction has taken since the launch */
};

/* 0 <= theta <= theta_c.  DOM_STOPS: the head does not come as far; DOM_NO_FUEL: it does not start. */
enum dom_status dom_cycle_state(const struct dom_train *train, dom_real theta, struct dom_state *state,
                                struct dom_state *error);

/* The tilt at a time after the launch, in tau, up to the next hit or the stop; else DOM_BAD_TILT. */
enum dom_status dom_cycle_tilt(const struct dom_train *train, dom_real time, dom_real *theta);

/* How the rows of dom_cycle_walk are spaced. */
enum dom_spacing { DOM_BY_TIME, DOM_BY_TILT };

/*
 * Calls visit for `rows` states of the cycle evenly in time or in tilt, and for each event (else NULL), in
 * order; it returns false to end the walk early.  Its error is NULL unless errors are asked for.  Statuses as
 * dom_cycle_events, DOM_STOPS after all rows; many states cost far less than as many dom_cycle_state.
 */
typedef bool dom_state_visit(const struct dom_state *state, const struct dom_state *error,
                             const struct dom_event *event, void *context);
enum dom_status dom_cycle_walk(const struct dom_train *train, size_t rows, enum dom_spacing by, bool errors,
                               dom_state_visit *visit, void *context);

/* Domino i, and the contact of the follower that leans on it. */
struct dom_force {
    size_t i;
    dom_real force;   /* in m g of the head; NaN without a follower */
    dom_real of_own;  /* the same in the weight of domino i */
    dom_real impulse; /* in the collision (NaN unless theta = 0), in m g tau of the head: > 0 presses them */
};

/*
 * Calls visit for the dominoes that matter at the tilt theta of a moving train, from the head down (model of
 * section 5: they stay in contact as long as every force is > 0).  Statuses as dom_cycle_state.
 */
typedef bool dom_force_visit(const struct dom_force *force, void *context);
enum dom_status dom_cycle_forces(const struct dom_train *train, dom_real theta, dom_force_visit *visit,
                                 void *context);

/* Whether the dominoes stay in contact: > 0 where they do.  Infinite where there is no contact in the cycle.
 */
struct dom_least_force {
    dom_real force;   /* the smallest of the cycle, in the weight of the domino that it pushes */
    dom_real theta;   /* the tilt of the head then */
    size_t domino;    /* that is pushed, 0 = head */
    dom_real impulse; /* the smallest of the collision, in m g tau of the head */
};

/* Over the cycle, or up to where the train stops, to about 1e-5 of that weight.  Statuses as dom_cycle_state.
 */
enum dom_status dom_cycle_least_force(const struct dom_train *train, struct dom_least_force *least);

/*
 * The friction coefficient that the floor needs so that no hinge slips: |R_x| / R_z of the floor's force, and
 * of its impulse in the collision; infinite where a domino would be lifted off it.
 */
struct dom_floor {
    dom_real motion, theta; /* the most in motion, and the tilt of the head then */
    size_t domino;          /* whose hinge, 0 = head */
    dom_real hit;           /* the most in the collision */
    size_t hit_domino;
};

/*
 * Over the cycle, or up to where the train stops, of the dominoes that move with a thousandth of the head's
 * speed at least; a smooth maximum is right to a millionth.  DOM_NO_FUEL, DOM_LOCKS: no cycle.
 */
enum dom_status dom_cycle_floor(const struct dom_train *train, struct dom_floor *floor);

/* ---- The limits of growth ---- */

enum dom_end { DOM_END_NONE, DOM_END_BARRIER, DOM_END_REACH };

/* "none", "barrier" or "reach". */
const char *dom_end_text(enum dom_end end);

struct dom_limit {
    dom_real r_max;    /* NaN with DOM_END_NONE */
    enum dom_end ends; /* by what growth is limited */
};

/*
 * The first r, raised from 1, at which the margin reaches 0; 1/s where that never happens.  train->r is
 * not used.  DOM_OK with DOM_END_NONE where already r = 1 does not go on; *why, unless why is NULL,
 * then tells whether by NO_FUEL, STOPS or LOCKS.  Without friction bounds cover every growth up to r_max:
 * what can be missed is a dip of the margin narrower than 1e-6 in ln r (1e-4 just before r_max; more where
 * 1,500 intervals do not decide).  With friction there are samples alone.  DOM_TOO_LONG, also of the next
 * two: more work than a second or two in double.
 */
enum dom_status dom_limit_rmax(const struct dom_train *train, struct dom_limit *limit,
                               struct dom_limit *error, enum dom_status *why);

/*
 * The same for two dominoes (section "Two dominoes"): domino 1, just tipped over, must carry domino 0
 * over the barrier of the pair.  train->r and train->fuel are not used.  Where equal dominoes fail, but
 * larger ones succeed ((b0) is a lower bound on r), the first band of r that succeeds counts.
 */
enum dom_status dom_limit_pair(const struct dom_train *train, struct dom_limit *limit,
                               struct dom_limit *error);

struct dom_best {
    dom_real s;     /* the separation that allows the largest growth */
    dom_real r_max; /* that growth */
};

/*
 * train->s and train->r are not used.  DOM_NO_GROWTH where no separation allows r > 1.  Without friction
 * bounds exclude larger growths elsewhere, but for tops of r_max(s) narrower than 0.2 % of s; with friction
 * there are samples alone.
 */
enum dom_status dom_limit_best(const struct dom_train *train, struct dom_best *best, struct dom_best *error);

/* ---- A finite row of any dominoes ---- */

/* A solid block; the gap is the free one to the domino before it, of which the first has none. */
struct dom_domino {
    dom_real height, thickness, gap; /* m */
    dom_real mass;                   /* kg */
};

/*
 * Dominoes 1, 2, ... in the order in which they fall, of any sizes.  They start one after the other as a
 * train does: a head that all before it lean on, until it hits the next.
 */
struct dom_row {
    const struct dom_domino *domino; /* count of them: domino[0] is number 1 */
    size_t count;
    dom_real g;    /* m/s^2 */
    dom_real push; /* rad/s, of the first, upright domino; NaN: it is tipped over its edge and let go */
    DOM_DYNAMICS(DOM_DYNAMICS_MEMBER) /* as of a train */
#undef DOM_DYNAMICS_MEMBER
    bool floor;   /* is it asked what friction the floor needs? */
    dom_real tol; /* relative tolerance */
    enum dom_precision precision;
    struct dom_work *work;                  /* where not NULL, counts */
    const volatile sig_atomic_t *interrupt; /* as of a train */
};

/* How a row ends: X(name, what it means). */
#define DOM_ROW_ENDS(X)                                                                                      \
    X(FALLS, "all fall")                                                                                     \
    X(STOPS, "what is left of the motion does not carry it over its barrier")                                \
    X(MISSES, "it falls short of the next: the gap is larger than it is tall")                               \
    X(PASSES,                                                                                                \
      "its tip passes above the next one: a contact of another kind, which this model does not have")        \
    X(LEANS, "the first touches the second before it is over its edge: it needs a push")                     \
    X(PARTS, "it runs ahead of those that lean on it: the contact opens, which this model does not follow")  \
    X(LOCKS, "friction locks: a contact force passes behind the hinge that it is to turn")

enum dom_row_end {
#define DOM_ROW_ENUM(name, text) DOM_ROW_##name,
    DOM_ROW_ENDS(DOM_ROW_ENUM)
#undef DOM_ROW_ENUM
};

/* What it means, as a phrase about the domino where it ends. */
const char *dom_row_end_text(enum dom_row_end end);

/* One domino of the row, from when it is hit to when it hits the next, or lies on the floor. */
struct dom_fall {
    size_t domino;     /* its number, from 1 */
    dom_real time;     /* s, when it was hit; the clock starts with the push, or else with the first hit */
    dom_real duration; /* s, until it hits the next one, or lies on the floor; NaN where it does not */
    dom_real omega;    /* rad/s, just after it was hit */
    dom_real kinetic;  /* J, of all that move, just after it was hit */
    dom_real barrier;  /* J, that it takes to go on; infinite where friction locks on the way */
    dom_real margin;   /* J, kinetic - barrier */
    dom_real lost;     /* J, in the collision */
    dom_real
        friction_work; /* J, to friction between dominoes since it was hit; NaN where it does not go on */
    dom_real theta_m;  /* where it is hardest to go on */
    dom_real theta;    /* where it hits the next, lies on the floor, or comes to rest */
    size_t moving;     /* dominoes that moved with it */
    /* Where the floor is asked for, as of a train; by numbers in the row.  Else NaN and 0. */
    dom_real floor_motion, floor_hit;
    size_t floor_domino, floor_hit_domino;
};

struct dom_verdict {
    enum dom_row_end end;
    size_t domino; /* the last that was hit: where the row ends */
    dom_real
        short_by; /* J, of what is missing there: > 0 for STOPS, infinite where friction locks farther on */
    dom_real seconds; /* until all lie, or until the last hit */
    size_t weakest;   /* of those that go on the one that does so with the smallest margin / barrier */
    dom_real spare;   /* that ratio; infinite where nothing has to be climbed */
};

/*
 * Runs a row.  visit is called for each domino that is hit, in order, unless it is NULL; it returns false to
 * stop early.  times = false leaves out what only times need: they are NaN.  The verdict is written with
 * DOM_OK.  BAD_PARAMETER: a size, g, push, tol or an effect is not finite, or not in its range.
 */
typedef bool dom_fall_visit(const struct dom_fall *fall, void *context);
enum dom_status dom_row_run(const struct dom_row *row, bool times, dom_fall_visit *visit, void *context,
                            struct dom_verdict *verdict);

/* Of a train: domino k = 1 ... count, each r times as large, gap s of its own height; the first weighs mass.
 */
void dom_row_of_train(const struct dom_train *train, const struct dom_scale *scale, dom_real mass,
                      struct dom_domino *domino, size_t count);

/* ---- Errors of placement: the same row, set up again and again ---- */

/*
 * Every gap gets an error of its own, normal with the standard deviation sigma; where it would overlap, the
 * dominoes touch.  Heights may get relative errors; masses follow them.
 */
struct dom_placement {
    dom_real sigma;     /* m */
    dom_real heights;   /* relative */
    unsigned long seed; /* row number i is the same for the same seed, whoever computes it */
    size_t first, rows; /* numbers of the rows: first, first + 1, ... */
    unsigned threads;   /* 0: as many as there are processors */
    /* Where not NULL, called now and then with how many are done. */
    void (*progress)(size_t done, size_t rows, void *context);
    void *context;
};

struct dom_study {
    size_t rows, fall;
    size_t unknown;   /* of which the model does not tell: PASSES or PARTS */
    double low, high; /* 95 % interval of the probability (Clopper and Pearson); unknown ones widen it */
};

/*
 * stops, unless NULL, has room for row->count: how often the row ended at each domino without falling, the
 * unknown left out.  Independent of the number of threads.  BAD_PARAMETER: also sigma or heights is no
 * number >= 0, or rows is 0.
 */
enum dom_status dom_placement_study(const struct dom_row *row, const struct dom_placement *placement,
                                    struct dom_study *study, size_t *stops);

/*
 * low and high from the counts: studies of other rows of one placement add up to a study of all of them.
 * BAD_PARAMETER: rows is 0, or fewer than fall + unknown.
 */
enum dom_status dom_study_interval(struct dom_study *study);

/* How precisely must it be placed? */
struct dom_budget {
    /* m, with its 95 % interval; infinite where no error up to the largest gap matters; low is 0 where so few
     * rows do not tell. */
    double sigma, low, high;
};

/*
 * The sigma at which the whole row falls with the given probability; placement->sigma is not used.
 * DOM_STOPS: even without any error it does not.
 */
enum dom_status dom_placement_budget(const struct dom_row *row, const struct dom_placement *placement,
                                     double probability, struct dom_budget *budget);

/* ---- Effects ---- */

struct dom_effect_argument {
    const char *name, *unit, *meaning;
    dom_real lowest, highest;
    dom_real usual;      /* where it is left out, and what its price is measured with */
    bool optional;       /* may be left out; those behind it too */
    bool whole;          /* a whole number */
    const char *or_file; /* what a file may give in its place; NULL for nothing */
};

enum { DOM_EFFECT_ARGUMENTS = 2 };

/* What an effect tells of itself: the manual is made of it. */
struct dom_effect {
    const char *name;
    const char *adds;    /* in a few words */
    const char *help;    /* in full sentences, equations in the paper's letters */
    const char *source;  /* where its mathematics is from */
    const char *plan;    /* what is solved where it is on, and how */
    const char *example; /* commands */
    struct dom_effect_argument argument[DOM_EFFECT_ARGUMENTS]; /* ends early with a NULL name */
    unsigned needs;  /* 1 << DOM_EFFECT_...: those without which it says nothing */
    bool dissipates; /* it is a law of motion that takes energy: see dom_law */
};

#define DOM_DYNAMICS_DECLARE(name, member) extern const struct dom_effect dom_effect_##name;
#define DOM_EFFECT_DECLARE(name)           extern const struct dom_effect dom_effect_##name;
DOM_DYNAMICS(DOM_DYNAMICS_DECLARE)
DOM_EFFECTS(DOM_EFFECT_DECLARE)
#undef DOM_DYNAMICS_DECLARE
#undef DOM_EFFECT_DECLARE

/* All of them, in the order of DOM_DYNAMICS and DOM_EFFECTS. */
const struct dom_effect *dom_effect(enum dom_effect_name name);

/* The first effect of DOM_DYNAMICS that a train has; NULL for none. */
const struct dom_effect *dom_dynamics(const struct dom_train *train);

/* What the law of motion without any effect says of itself. */
extern const struct dom_effect dom_energy_balance;

/* The law of motion of a train: the effect that takes energy in the motion, or else dom_energy_balance. */
const struct dom_effect *dom_law(const struct dom_train *train);

/* ---- Metres and seconds ---- */

/* tau = sqrt((h^2 + (d h)^2) / (3 g h)) in seconds (a1), for solid blocks; d in h. */
dom_real dom_scale_tau(const struct dom_scale *scale, dom_real d);

/* Front speed of a cycle in m/s: (s + d) r h over its duration (given in tau). */
dom_real dom_scale_speed(const struct dom_scale *scale, const struct dom_train *train, dom_real duration);

struct dom_count {
    dom_real
        dominoes;   /* n, the smallest integer with first r^n >= height; infinite for r = 1 < height/first */
    dom_real exact; /* ln(height / first) / ln r */
    dom_real last;  /* first r^n, in the unit of first; NaN where n is infinite */
};

/*
 * How many dominoes topple one at least `height` tall, the first of them being `first` tall and each r
 * times the one before.  A power that meets the height up to the rounding of the typed numbers, half a
 * unit of the precision for each of 4 + n of them, counts as exact.  Both heights > 0 in one unit, r >= 1,
 * else DOM_BAD_PARAMETER.
 */
enum dom_status dom_count_find(enum dom_precision precision, dom_real first, dom_real height, dom_real r,
                               struct dom_count *count, struct dom_count *error);

#ifdef __cplusplus
}
#endif

#endif
