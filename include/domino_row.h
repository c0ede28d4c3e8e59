/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finite rows of dominoes of any sizes, how they fall, and forces. <domino_study.h> has more questions about
 * rows, and <domino.h> the introduction. */
#ifndef DOMINO_ROW_H
#define DOMINO_ROW_H

#include "domino.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How a fall ends: X(name, meaning). */
#define DOM_ROW_ENDS(X)                                                                                      \
    X(FALLS, "all fall")                                                                                     \
    X(STOPS, "it has too little energy to tip over")                                                         \
    X(MISSES, "it misses the next domino: the gap is larger than its height")                                \
    X(PASSES, "its upper edge passes above the next domino, and the model does not include the contact "     \
              "that follows")                                                                                \
    X(LEANS, "it touches the next domino before it tips over: it needs a push")                              \
    X(PARTS, "it moves ahead of the dominoes that lean on it, and the model does not include this motion")   \
    X(LOCKS, "friction locks it: the contact force passes on the wrong side of its hinge")                   \
    X(SKEWED, "because it or the next domino leans, the two already touch, or would touch in a way that "    \
              "the model does not include")                                                                  \
    X(BACK, "it falls back, because the tilt at which it is released is too small")

enum dom_row_end {
#define DOM_ROW_ENUM(name, text) DOM_ROW_##name,
    DOM_ROW_ENDS(DOM_ROW_ENUM)
#undef DOM_ROW_ENUM
};

/* Returns the meaning of an end. The word "it" in a meaning stands for the domino at which the fall ends. */
const char *dom_row_end_text(enum dom_row_end end);

struct dom_engine; /* below */

/* ==== From here on everything is also in <domino_float.h> and <domino_quad.h> ==== */

/* ---- A finite row of any dominoes ---- */

/* A domino of a row: a solid block, or a box if the row has walls. */
struct dom_domino {
    /* Sizes in m. The gap is the clear distance to the previous domino, measured at the foot as if the domino
     * were upright; the first domino has a gap of 0. */
    dom_real height, thickness, gap;
    dom_real mass;   /* kg */
    dom_real radius; /* of the edges, in m, if rho of the row is not 0; 0 stands for rho times the height */
    /* The tilt in rad before the domino is hit, > 0 in the direction of the fall, within dom_lean_limits. The
     * domino rests on its front edge, and turns about this edge when it falls. */
    dom_real lean;
    dom_real width; /* m, used only with walls or air; 0 stands for half the height */
};

/* Finds how far a domino may lean: between lean[0] = -limit - alpha and lean[1] = limit - alpha, in rad, it
 * stands, with tan limit = thickness / height - 2 rho, since its centre must be above the flat part of its
 * foot. With sharp edges, `limit` is theta_u (4; b1). rho is the radius of the edges divided by the height,
 * unless the domino has a radius of its own. Does not check the arguments. */
void dom_lean_limits(const struct dom_domino *domino, dom_real alpha, dom_real rho, dom_real lean[2]);

/* Dominoes 1, 2, ... of any sizes, in the order in which they fall. */
struct dom_row {
    const struct dom_domino *domino; /* array of `count` dominoes; domino[0] is number 1 */
    size_t count;                    /* at least 1 */
    dom_real g;                      /* acceleration of gravity in m/s^2, > 0 */
    /* The angular velocity in rad/s, >= 0, that the first domino gets. NaN means that there is no push: the
     * first domino is tipped over its edge and released. */
    dom_real push;
    /* The tilt in rad, >= 0, at which the first domino gets the push, unless `push` is NaN. If it is not 0,
     * it takes the place of the lean of the first domino. INFINITY stands for the tilt at which the domino
     * leans against the second one (dom_row_touch); with a larger finite tilt, the fall ends with
     * DOM_ROW_SKEWED. */
    dom_real release;
    /* The effects of DOM_DYNAMICS, as in struct dom_train. `walls` is a length in m, and `air` a density in
     * kg/m^3, so all masses must be in kg. */
    dom_real mu, alpha, walls, rho, air, drag;
    dom_real feet; /* only for an engine, which adds it to the floor's friction coefficient */
    /* The engine that simulates the row instead of this library, or NULL. It exists in double only. */
    const struct dom_engine *engine;
    dom_real boxes_above;      /* the height, in m, above which dominoes have walls; 0 if all have walls */
    dom_real later[DOM_LATER]; /* must be 0, see "Versions" in <domino.h> */
};

/* Returns a row without dominoes, a push, effects or an engine, at g = 9.81 m/s^2. */
struct dom_row dom_row_default(void);

/* One domino of the row while it is the head: from the collision in which it is hit (the hit) until it hits
 * the next domino or lies on the floor. */
struct dom_fall {
    size_t domino;     /* number of the domino, counted from 1 */
    dom_real time;     /* of the hit in s, from the push, or without a push from the first hit */
    dom_real duration; /* in s, from the hit to the next hit or to the floor; NaN if neither happens */
    dom_real omega;    /* angular velocity of the domino just after the hit, in rad/s */
    dom_real kinetic;  /* kinetic energy of all moving dominoes just after the hit, in J */
    dom_real barrier;  /* the kinetic energy, in J, needed to pass it; infinite if friction locks the row */
    dom_real margin;   /* kinetic - barrier, in J */
    dom_real lost;     /* energy lost in the collision, in J */
    dom_real friction_work; /* lost to friction and air after the hit, in J; NaN if the fall ends here */
    dom_real theta_m;       /* tilt of the domino at the top of the barrier, in rad */
    dom_real theta;         /* the last tilt in rad: at the next hit, on the floor, or at rest */
    size_t moving;          /* the number of dominoes that move just after the hit, this one included */
};

struct dom_verdict {
    enum dom_row_end end;
    size_t domino; /* the last one that was hit; if the status is DOM_BAD_..., the one with the bad value */
    dom_real short_by; /* missing energy in J, > 0 for DOM_ROW_STOPS and DOM_ROW_BACK; infinite if locked */
    dom_real seconds;  /* until all dominoes lie on the floor, or until the last hit; NaN without times */
    /* the falling domino with the smallest margin / barrier that does not begin at rest; 0 if there is none
     */
    size_t weakest;
    dom_real spare; /* margin / barrier of the weakest domino; infinite without a barrier */
};

/* Runs a row. Calls visit, which may be NULL, for each domino that is hit, in order. If `times` is false, the
 * run is faster, and all times are NaN. */
typedef bool dom_fall_visit(const struct dom_fall *fall, void *context);
enum dom_status dom_row_run(const struct dom_row *row, const struct dom_compute *compute, bool times,
                            dom_fall_visit *visit, void *context, struct dom_verdict *verdict);

/* Finds the largest row->release: the tilt in rad at which the first domino touches the second one, or pi/2
 * if it touches none. The statuses are those of dom_row_run. */
enum dom_status dom_row_touch(const struct dom_row *row, const struct dom_compute *compute, dom_real *tilt);

/* Writes the first `count` dominoes of a train. Gaps and widths are s and train->width times the height, and
 * the first domino has the given mass in kg. Does not check the arguments. */
void dom_row_of_train(const struct dom_train *train, const struct dom_scale *scale, dom_real mass,
                      struct dom_domino *domino, size_t count);

/* ==== From here on everything exists only in double, with dom_ ==== */

/* An engine that runs rows instead of this library, for instance a rigid-body simulation. `run` does what
 * dom_row_run does, and finds its private data in row->engine->context. Studies may call it from many threads
 * at once. All functions that run a row call it, except that dom_row_watch and dom_row_floor return
 * DOM_NO_METHOD, as do domf_row_run and domq_row_run, and that the search of dom_row_improve runs the model.
 */
typedef enum dom_status dom_row_runner(const struct dom_row *row, const struct dom_compute *compute,
                                       bool times, dom_fall_visit *visit, void *context,
                                       struct dom_verdict *verdict);
struct dom_engine {
    dom_row_runner *run;
    void *context;
};

/* ---- Many trains at once ---- */

/* The questions that dom_trains_ask can ask: X(question, function that answers it for one train, type of the
 * answer). AT stands for X if the question needs a tilt. */
#define DOM_QUESTIONS(X, AT)                                                                                 \
    X(ANGLES, dom_angles_find, struct dom_angles)                                                            \
    AT(CONTACT, dom_contact_find, struct dom_contact)                                                        \
    AT(ENERGY, dom_energy_find, struct dom_energy)                                                           \
    X(FUEL, dom_fuel_find, struct dom_fuels)                                                                 \
    X(LAUNCH, dom_launch_find, struct dom_launch)                                                            \
    X(BARRIER, dom_barrier_find, struct dom_barrier)                                                         \
    AT(OMEGASQ, dom_cycle_omegasq, double)                                                                   \
    X(DURATION, dom_cycle_duration, double)                                                                  \
    X(RMAX, dom_limit_rmax, struct dom_limit)                                                                \
    X(PAIR, dom_limit_pair, struct dom_limit)                                                                \
    X(BEST, dom_limit_best, struct dom_best)

enum dom_question {
#define DOM_QUESTION_ENUM(name, find, type) DOM_ASK_##name,
    DOM_QUESTIONS(DOM_QUESTION_ENUM, DOM_QUESTION_ENUM)
#undef DOM_QUESTION_ENUM
};

/* Answers the same question about `count` trains, so that slow languages such as Python need no loop.
 * `answers` is an array of the type that DOM_QUESTIONS names, and `statuses` has a status for each train.
 * `tilts` may be NULL if the question needs no tilt. Returns DOM_OK, or DOM_NO_METHOD if the question is not
 * in the enumeration. After an interrupt, returns DOM_INTERRUPTED, also for all remaining trains. */
enum dom_status dom_trains_ask(enum dom_question question, const struct dom_train *trains,
                               const double *tilts, size_t count, const struct dom_compute *compute,
                               void *answers, enum dom_status *statuses);

/* ---- Forces in the cycle of a train ---- */

/* The contact force and the impulse between domino i and its follower. The two stay in contact while the
 * force is > 0, as the paper assumes in its section 'Introduction'. */
struct dom_force {
    size_t i;
    double force;      /* contact force divided by the weight m g of the head; NaN without a follower */
    double per_weight; /* the force divided by the weight of domino i */
    double impulse;    /* impulse of the collision, divided by the head's m g tau; NaN if theta > 0 */
};

/* Visits the dominoes from the head to the last that contributes, while the head leans at theta. The statuses
 * are those of dom_cycle_state. */
typedef bool dom_force_visit(const struct dom_force *force, void *context);
enum dom_status dom_cycle_forces(const struct dom_train *train, const struct dom_compute *compute,
                                 double theta, dom_force_visit *visit, void *context);

/* The friction coefficient that the floor needs so that no foot slips: the largest |R_x| / R_z, where R is
 * the force of the floor on a foot. It is infinite if a domino would be lifted off the floor. */
struct dom_floor {
    double motion, theta; /* the coefficient during the motion, and the tilt of the head */
    size_t domino;        /* the domino whose foot needs it, 0 = head */
    double hit;           /* the coefficient in the collision, where R is an impulse */
    size_t hit_domino;    /* the domino whose foot needs it */
};

/* Finds the friction that the floor needs during the cycle, or until the train stops. Dominoes slower than a
 * thousandth of the speed of the head are left out. Where |R_x| / R_z is smooth around its maximum, the
 * relative error is at most a millionth. The status is DOM_NO_FUEL if there is no cycle. */
enum dom_status dom_cycle_floor(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_floor *floor);

/* ---- Rows ---- */

/* The state of a row at one moment. */
struct dom_moment {
    double time;   /* in s, measured as in struct dom_fall */
    size_t head;   /* number of the last domino that was hit, counted from 1 */
    size_t moving; /* the number of dominoes that move, the head included */
    /* tilts in rad and angular velocities in rad/s, from domino 1 on; valid only during the visit */
    const double *tilt, *omega;
};

/* Runs a row and visits its state at `count` times in s, in ascending order. For a time after the end of the
 * motion, such as INFINITY, visit gets the final state and the time at which the row reached it. A domino
 * that detaches keeps its tilt from then on. The status is DOM_BAD_TIME if the times are negative or not in
 * order, and DOM_NO_MARGIN if the row comes so close to a stop that later times cannot be computed. Other
 * statuses are those of dom_row_run. */
typedef bool dom_moment_visit(const struct dom_moment *moment, void *context);
enum dom_status dom_row_watch(const struct dom_row *row, const struct dom_compute *compute,
                              const double *times, size_t count, dom_moment_visit *visit, void *context,
                              struct dom_verdict *verdict);

/* Finds the friction that the floor needs while each domino of a row is the head: floor[k] for domino k + 1,
 * with dominoes numbered from 1. The coefficients are NaN, and the numbers 0, for a domino that is not hit.
 * The statuses are those of dom_row_run. */
enum dom_status dom_row_floor(const struct dom_row *row, const struct dom_compute *compute,
                              struct dom_floor *floor);

/* Finds the weakest push in rad/s that makes all dominoes of a row fall, rounded upwards to four digits. It
 * is row->push if all dominoes already fall, and NaN if no push up to `strongest` is enough. The search
 * starts from a push that is too weak for the first domino, or from row->push if that is larger, doubles it
 * until all dominoes fall, and then bisects. The statuses are those of dom_row_run, and
 * DOM_BAD_PUSH unless `strongest` is finite and > 0. */
enum dom_status dom_row_weakest_push(const struct dom_row *row, const struct dom_compute *compute,
                                     double strongest, double *push);

#ifdef __cplusplus
}
#endif

#endif
