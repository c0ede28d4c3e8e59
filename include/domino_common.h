/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parts of <domino.h> that all floating-point types share: statuses, choices of the caller, names of
 * effects and events, and counters of work. */
#ifndef DOMINO_COMMON_H
#define DOMINO_COMMON_H

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Statuses: X(name, meaning) ---- */

#define DOM_STATUSES(X)                                                                                      \
    X(OK, "no error")                                                                                        \
    X(BAD_S, "the separation s is outside its range")                                                        \
    X(BAD_R, "the growth r is outside its range")                                                            \
    X(BAD_D, "the thickness d is outside its range")                                                         \
    X(BAD_Q, "the exponent q is outside its range")                                                          \
    X(BAD_WIDTH, "the width is outside its range")                                                           \
    X(BAD_MU, "the friction coefficient mu is outside its range")                                            \
    X(BAD_ALPHA, "the slope alpha of the floor is outside its range")                                        \
    X(BAD_WALLS, "the thickness of the walls is outside its range")                                          \
    X(BAD_RHO, "the radius rho of the edges is outside its range")                                           \
    X(BAD_AIR, "the density of the air is outside its range, or that of the dominoes is not known")          \
    X(BAD_DRAG, "the drag coefficient is outside its range")                                                 \
    X(BAD_FUEL, "the fuel is not a value of enum dom_fuel")                                                  \
    X(BAD_TOL, "the tolerance tol is outside its range, or below the smallest that the precision can reach") \
    X(BAD_TILT, "the tilt is outside [0, theta_c]")                                                          \
    X(BAD_TIME, "the time is negative, or later than the next hit")                                          \
    X(BAD_G, "the acceleration of gravity g is outside its range")                                           \
    X(BAD_PUSH, "the push is outside its range")                                                             \
    X(BAD_RELEASE, "the tilt at which the first domino is released is outside its range")                    \
    X(BAD_COUNT, "the row has no dominoes")                                                                  \
    X(BAD_HEIGHT, "a height is outside its range")                                                           \
    X(BAD_THICKNESS, "a thickness is outside its range")                                                     \
    X(BAD_GAP, "a gap is outside its range")                                                                 \
    X(BAD_MASS, "a mass is outside its range")                                                               \
    X(BAD_RADIUS, "the radius of an edge is outside its range")                                              \
    X(BAD_LEAN, "a lean is too large: a domino that leans that far falls over when it is set up")            \
    X(BAD_ERROR, "the size of an error is outside its range")                                                \
    X(BAD_ROWS, "the number of rows is 0, or smaller than the number of rows counted as fallen or unknown")  \
    X(BAD_PROBABILITY, "the probability is outside (0, 1)")                                                  \
    X(BAD_SAFETY, "the safety factor is not a finite number above 1")                                        \
    X(BAD_HALL, "the length of the hall is not greater than the height of the last domino")                  \
    X(OUT_OF_REACH, "r s > 1: the head falls past the next domino without touching it")                      \
    X(NO_FUEL, "the fuel P is not positive: a cycle releases no energy")                                     \
    X(STOPS, "the train stops: its kinetic energy after the collision is below the barrier")                 \
    X(LOCKS,                                                                                                 \
      "friction locks the train: the contact force on a domino passes on the wrong side of its hinge")       \
    X(NO_STAND,                                                                                              \
      "no domino can stand upright on this slope: the tangent of its angle must be below d - 2 rho")         \
    X(NO_ROOM, "the walls are thicker than half the thickness of a domino")                                  \
    X(NO_ROUND,                                                                                              \
      "the radius of the edges is too large: it must be at most half of the thickness, rho <= d/2")          \
    X(NO_LEAN, "dominoes that lean cannot be combined with rounded edges, or with a rigid-body engine")      \
    X(NO_AIR, "in air only solid dominoes (q = 4) make a train that is self-similar")                        \
    X(NO_MARGIN,                                                                                             \
      "the margin is 0 within rounding errors, so times cannot be computed; use a slightly smaller r")       \
    X(NO_GROWTH, "even equal dominoes (r = 1) do not keep falling at this separation")                       \
    X(OPEN, "at a smaller growth than this r_max the margin is 0 within rounding errors, so r_max is open")  \
    X(TOO_LONG, "the answer depends on more dominoes than can be computed")                                  \
    X(UNDERFLOW, "r^(2q+1) is too large for this precision; use a smaller r or q")                           \
    X(NO_PRECISION, "this machine has no floating-point type that is wider than double")                     \
    X(NO_METHOD, "the requested method cannot compute this answer")                                          \
    X(NEWER, "the program asks for something that came with a later version of this library")                \
    X(NOT_FINITE, "an intermediate value is not finite")                                                     \
    X(NOT_CONVERGED, "the iteration did not reach the tolerance")                                            \
    X(NO_MEMORY, "out of memory")                                                                            \
    X(INTERRUPTED, "interrupted")

enum dom_status {
#define DOM_STATUS_ENUM(name, text) DOM_##name,
    DOM_STATUSES(DOM_STATUS_ENUM)
#undef DOM_STATUS_ENUM
};

/* Returns the meaning of a status: one line without a full stop. */
const char *dom_status_text(enum dom_status status);

/* ---- Choices ---- */

/* The formula for the fuel P in (24; c6): see struct dom_fuels. */
enum dom_fuel { DOM_FUEL_EXACT, DOM_FUEL_PAPER };

/* The effects, beyond the paper, that change how dominoes move: X(effect, member, status). The value of the
 * effect is in the member `member` of struct dom_train and of struct dom_row, where 0 means off. If the value
 * is outside its range, functions return `status`. The code of an effect runs only while the effect is on. */
#define DOM_DYNAMICS(X)                                                                                      \
    X(friction, mu, DOM_BAD_MU)                                                                              \
    X(slope, alpha, DOM_BAD_ALPHA)                                                                           \
    X(walls, walls, DOM_BAD_WALLS)                                                                           \
    X(edges, rho, DOM_BAD_RHO) X(air, air, DOM_BAD_AIR) X(drag, drag, DOM_BAD_DRAG)

/* The effects that are not in DOM_DYNAMICS. They concern rows and questions about rows: X(effect). */
#define DOM_EFFECTS(X) X(row) X(push) X(release)

/* All effects, in the order of DOM_DYNAMICS and DOM_EFFECTS. */
enum dom_effect_name {
#define DOM_DYNAMICS_ENUM(effect, member, status) DOM_EFFECT_##effect,
#define DOM_EFFECT_ENUM(effect)                   DOM_EFFECT_##effect,
    DOM_DYNAMICS(DOM_DYNAMICS_ENUM) DOM_EFFECTS(DOM_EFFECT_ENUM)
#undef DOM_DYNAMICS_ENUM
#undef DOM_EFFECT_ENUM
        DOM_EFFECT_COUNT
};

/* The number of effects in DOM_DYNAMICS. */
#define DOM_DYNAMICS_ONE(effect, member, status) +1
enum { DOM_DYNAMICS_COUNT = DOM_DYNAMICS(DOM_DYNAMICS_ONE) };
#undef DOM_DYNAMICS_ONE

/* The number of members that later versions can add to a structure: see "Versions" in <domino.h>. */
enum { DOM_LATER = 4 };

/* The largest number of arguments that an effect has. */
enum { DOM_EFFECT_ARGUMENTS = 3 };

/* What limits the growth: the barrier, or the reach of the head (dom_train_reach). DOM_END_NONE means that
 * even equal dominoes do not keep falling. */
enum dom_end { DOM_END_NONE, DOM_END_BARRIER, DOM_END_REACH };

/* Returns "none", "barrier" or "reach". For any other number, such functions return "unknown". */
const char *dom_end_text(enum dom_end end);

enum dom_event_kind {
    DOM_EVENT_LAUNCH, /* the head has been hit and begins to move */
    DOM_EVENT_DETACH, /* a follower detaches from its leader, the domino on which it leaned (41; A17) */
    DOM_EVENT_TOP,    /* the head passes the top of the barrier, if there is a barrier */
    DOM_EVENT_STOP,   /* the train comes to rest before the top of the barrier, and there is no next hit */
    DOM_EVENT_HIT     /* the head hits the next domino (2; a2) */
};

/* The largest number of events in a cycle. */
enum { DOM_EVENTS_MAX = 5 };

/* Returns "launch", "fall", "top", "stop" or "hit". */
const char *dom_event_text(enum dom_event_kind kind);

/* Whether the states that dom_cycle_walk visits are evenly spaced in time or in tilt. */
enum dom_spacing { DOM_BY_TIME, DOM_BY_TILT };

/* ---- Work and interrupts ---- */

/* Counters, to which every call adds. The caller initializes them with {0}. */
struct dom_work {
    size_t passes;   /* number of passes down the chain of dominoes */
    size_t dominoes; /* number of dominoes visited in all passes */
    size_t longest;  /* number of dominoes visited in the longest pass */
};

/* Returns true if flag is not NULL and *flag is not 0, which another thread may set. */
static inline bool dom_raised(const volatile sig_atomic_t *flag)
{
#if defined __GNUC__
    return flag && __atomic_load_n(flag, __ATOMIC_RELAXED) != 0;
#else
    return flag && *flag;
#endif
}

#ifdef __cplusplus
}
#endif

#endif
