/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finite rows of dominoes of any sizes: how a row falls, how to mend a row that stops, how precisely a row
 * must be set up, and how to design one. <domino.h> has the introduction. */
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
    bool floor;    /* true to find the friction that the floor needs */
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
    /* The friction that the floor needs, as in struct dom_floor, but with dominoes numbered from 1. Unless
     * row->floor is set, the coefficients are NaN and the numbers of dominoes are 0. */
    dom_real floor_motion, floor_hit;
    size_t floor_domino, floor_hit_domino;
};

struct dom_verdict {
    enum dom_row_end end;
    size_t
        domino; /* the last domino that was hit; if the status is DOM_BAD_..., the one with the bad value */
    /* the missing energy in J: > 0 for DOM_ROW_STOPS and DOM_ROW_BACK, infinite if friction locks the row */
    dom_real short_by;
    dom_real seconds; /* until all dominoes lie on the floor, or until the last hit; NaN without times */
    /* the number of the falling domino with the smallest margin / barrier, apart from dominoes that begin at
     * rest; 0 if there is none */
    size_t weakest;
    dom_real spare; /* margin / barrier of the weakest domino; infinite without a barrier */
};

/* Runs a row. Calls visit, which may be NULL, for each domino that is hit, in order. If `times` is false, the
 * run is faster, and all times are NaN. compute->method is not used. */
typedef bool dom_fall_visit(const struct dom_fall *fall, void *context);
enum dom_status dom_row_run(const struct dom_row *row, const struct dom_compute *compute, bool times,
                            dom_fall_visit *visit, void *context, struct dom_verdict *verdict);

/* Finds the largest row->release: the tilt in rad at which the first domino touches the second one, or pi/2
 * if it touches none. The statuses are those of dom_row_run. */
enum dom_status dom_row_touch(const struct dom_row *row, const struct dom_compute *compute, dom_real *tilt);

/* The state of a row at one moment. */
struct dom_moment {
    dom_real time; /* in s, measured as in struct dom_fall */
    size_t head;   /* number of the last domino that was hit, counted from 1 */
    size_t moving; /* the number of dominoes that move, the head included */
    /* tilts in rad and angular velocities in rad/s, from domino 1 on; valid only during the visit */
    const dom_real *tilt, *omega;
};

/* Runs a row and visits its state at `count` times in s, in ascending order. For a time after the end of the
 * motion, such as INFINITY, visit gets the final state and the time at which the row reached it. A domino
 * that detaches keeps its tilt from then on. Without a push, times may be negative. The status is
 * DOM_BAD_TIME if they are not in order or not allowed, and DOM_NO_MARGIN if the row comes so close to a stop
 * that later times cannot be computed. Other statuses are those of dom_row_run. */
typedef bool dom_moment_visit(const struct dom_moment *moment, void *context);
enum dom_status dom_row_watch(const struct dom_row *row, const struct dom_compute *compute,
                              const dom_real *times, size_t count, dom_moment_visit *visit, void *context,
                              struct dom_verdict *verdict);

/* Writes the first `count` dominoes of a train. Each gap is s times the height of its domino, and each width
 * is train->width times the height. The first domino has the given mass in kg. Does not check the
 * arguments. */
void dom_row_of_train(const struct dom_train *train, const struct dom_scale *scale, dom_real mass,
                      struct dom_domino *domino, size_t count);

/* ==== From here on everything exists only in double, with dom_ ==== */

/* An engine that runs rows instead of this library, for instance a rigid-body simulation. `run` does what
 * dom_row_run does, and finds its private data in row->engine->context. Studies may call it from many threads
 * at once. All functions that run a row call it, except that dom_row_watch returns DOM_NO_METHOD, as do
 * domf_row_run and domq_row_run, and that the search of dom_row_improve runs the model. */
typedef enum dom_status dom_row_runner(const struct dom_row *row, const struct dom_compute *compute,
                                       bool times, dom_fall_visit *visit, void *context,
                                       struct dom_verdict *verdict);
struct dom_engine {
    dom_row_runner *run;
    void *context;
};

/* A callback that reports the progress of a long computation: `done` parts of `of` are complete. It may be
 * NULL. */
typedef void dom_progress(size_t done, size_t of, void *context);

/* ---- The largest growth, and the weakest push ---- */

/* A callback that writes `count` dominoes with the growth r. */
typedef void dom_row_make(double r, struct dom_domino *domino, size_t count, void *context);

/* All dominoes fall at growths from r_min, which is 1 if the row falls there, to r_max. */
struct dom_row_growth {
    double r_max, r_min; /* NaN if no growth was found */
    /* How the fall ends just above r_max: DOM_ROW_FALLS if r_max is `highest`. If r_max is NaN, how it ends
     * at r = 1. */
    enum dom_row_end ends;
};

/*
 * Finds the largest growth at which all dominoes of a row fall, to the relative tolerance compute->tol.
 * `make` writes the dominoes for each growth that is tried; row->domino is not used. For a train, let `make`
 * call dom_row_of_train, and let `highest` be dom_train_reach.
 *
 * The search starts at r = 1 and raises r in steps of 2 %, or of 10 % with an engine, until the row falls,
 * and then in steps of 2 %, until it no longer falls or r is `highest`. An interval of growths that is
 * narrower than a step can be missed. The statuses are those of dom_row_run, and DOM_BAD_R if `highest` is
 * not a finite number >= 1.
 */
enum dom_status dom_row_rmax(const struct dom_row *row, const struct dom_compute *compute, double highest,
                             dom_row_make *make, void *context, struct dom_row_growth *growth);

/* Finds the weakest push in rad/s that makes all dominoes of a row fall, rounded upwards to four digits. It
 * is row->push if all dominoes already fall, and NaN if no push up to `strongest` is enough. The search
 * starts from the push that turns the first domino over its edge, or from row->push if that is larger,
 * doubles it until all dominoes fall, and then bisects. The statuses are those of dom_row_run, and
 * DOM_BAD_PUSH unless `strongest` is finite and > 0. */
enum dom_status dom_row_weakest_push(const struct dom_row *row, const struct dom_compute *compute,
                                     double strongest, double *push);

/* ---- Mending, and how precisely a row must be set up ---- */

/* What dom_row_windows changes. Friction has no unit, leans are in rad, and all other values are in m. With
 * the height or the thickness of a domino, its mass changes in proportion to the volume of the wood. It keeps
 * its lean and its width, and all gaps stay the same. */
enum dom_window_of {
    DOM_WINDOW_GAP, /* the gap before a domino; all dominoes after it move by the same distance */
    /* the distance from the back of the first domino to the back of this one; no other domino moves */
    DOM_WINDOW_PLACE,
    DOM_WINDOW_HEIGHT,
    DOM_WINDOW_FRICTION, /* the friction between all dominoes */
    DOM_WINDOW_LEAN,
    DOM_WINDOW_THICKNESS
};

/* The values at which all dominoes fall while all other values stay as they are. */
struct dom_window {
    size_t domino;    /* the number of the domino; 0 for friction */
    double now;       /* the current value */
    double low, high; /* the window, rounded inward to seven digits; NaN if none was found */
    /* How the fall ends just below and just above the window. DOM_ROW_FALLS means that this is unknown,
     * because no value there was tried, or because the row does not fall at the current value. */
    enum dom_row_end below, above;
};

/*
 * Finds the windows of all gaps or places (row->count - 1 windows, from domino 2 on), of all heights,
 * thicknesses or leans (row->count windows), or of friction (one window).
 *
 * If the row falls, a window is the interval around the current value. If it does not, the window is the
 * interval nearest to the current value, on either side: a value in it mends the row. If the fall ends at
 * domino k, only the dominoes from k - 29 to k + 1 have windows, and if the gap after domino k is too wide to
 * reach across, no other gap has one. If the current value is larger than all that are tried, as for a gap
 * out of reach, and the row falls with the largest of these, the window extends from there downwards.
 *
 * These values are tried:
 * - gaps from 0 to the height of the domino before the gap,
 * - places up to the next domino, as long as the gap before the domino stays in the range of gaps,
 * - heights and thicknesses from 1/100 to 4 times the current one, if the domino can stand on the slope, and
 *   walls and rounded edges fit; a height stays on the same side of row->boxes_above,
 * - frictions from 0 to 2, or to 4 times the current friction if that is more, but at most DOM_MU_HIGHEST,
 * - leans in both directions, until the domino falls over by itself.
 *
 * In each direction, the search takes up to 40 steps of increasing length, of which the first is 1/64,000 of
 * the range, and then bisects. With an engine, there are up to 10 steps, the first is 1/1,000 of the range,
 * `low` and `high` have three digits, and a value for which it returns DOM_NOT_CONVERGED is outside the
 * window. All dominoes fall at `low` and at `high`. An interval that is narrower than a step can be missed,
 * within the window, too. Calls progress for each window. The statuses are those of dom_row_run.
 */
enum dom_status dom_row_windows(const struct dom_row *row, const struct dom_compute *compute,
                                enum dom_window_of of, dom_progress *progress, void *context,
                                struct dom_window *windows);

/* ---- The design of a row ---- */

/* The sizes that the dominoes of a row may have, for designs and for dom_row_improve. */
struct dom_limits {
    /* For dom_row_improve: true to change not only gaps but also sizes, except those of the first and the
     * last domino. A domino keeps its proportions, unless it gets the thickness of a board. */
    bool sizes;
    /* The mass exponent: a domino x times as large has x^(q - 1) times the mass. With walls, the masses
     * follow from the walls instead. */
    double q;
    double hall; /* length of the hall in m, into which the fallen row must fit; may be infinite */
    double grid; /* in m: changed sizes and gaps are multiples of it; 0 means that there is no grid */
    /* The thicknesses in m that dominoes may have, in increasing order. If `boards` is 0, any thickness is
     * allowed. In a row with boxes_above > 0, boxes may have any thickness. */
    const double *board;
    size_t boards;
};

/* Why a wish cannot be fulfilled, and what dom_design.needs means in that case. */
enum dom_design_limit {
    DOM_DESIGN_FITS,   /* the wish can be fulfilled */
    DOM_DESIGN_SAFETY, /* no train has this safety; `needs` is slightly below the largest possible one */
    DOM_DESIGN_START,  /* the start is too weak; `needs` is a push in rad/s that is enough, or NaN */
    DOM_DESIGN_HALL,   /* the hall is too short; `needs` is the length of the shortest row, in m */
    /* some trains or rows could not be computed; `needs` is the separation s of one of them */
    DOM_DESIGN_FAILED
};

/* The row that a builder wants. */
struct dom_wish {
    double first, height;    /* heights of the first and the last domino, in m; height > first */
    double safety;           /* the kinetic energy of each cycle over the energy that it needs, > 1 */
    double hall;             /* as in struct dom_limits; > height */
    double g, push, release; /* as in struct dom_row */
    /* As in struct dom_row, in m. If boxes_above is 0, both are ignored. Otherwise `walls` replaces the walls
     * of the train, and all masses follow from the volume of the wood. */
    double walls, boxes_above;
};

/* A row, built like a train, that was designed for a struct dom_wish. If no row was found, all members except
 * `limit` and `needs` are NaN or 0. */
struct dom_design {
    double s, r;    /* the gap of a domino divided by its height, a multiple of 0.001, and the growth */
    size_t steps;   /* `first` r^steps = `height`, so the row has steps + 1 dominoes */
    double feet;    /* length from the first domino to the last, in m */
    double length;  /* length after the last domino has fallen: `feet` + `height`, in m */
    double seconds; /* as in struct dom_verdict */
    double train;   /* kinetic / barrier of the endless train */
    double row;     /* the smallest ratio kinetic / barrier among all dominoes after the first */
    size_t weakest; /* the number of the domino with this ratio; at least 2 */
    enum dom_design_limit limit;
    double needs; /* see enum dom_design_limit; NaN with DOM_DESIGN_FITS */
};

/*
 * Finds a row, built like a train, that falls reliably: kinetic >= safety * barrier, in the endless train and
 * at each domino of the row after the first. train->s and train->r are not used.
 *
 * The search first finds the best separation s, at which a train with this safety has the largest growth r,
 * and so the fewest dominoes. r is then reduced until the last domino is exactly `height` tall. The
 * separation stays as close to the best one as the hall and the start of the row allow. If the row is too
 * long for the hall, the shortest row is tried, which may have up to 30 more dominoes. Separations are
 * multiples of 0.001; one at which a train or a row cannot be computed is skipped.
 *
 * Unless `limits` is NULL, the row can be built: sizes and gaps are multiples of the grid, except the sizes
 * of the first domino and the height of the last, and every thickness is that of a board, if there are
 * boards. The rounded row is as safe as wish->safety demands and fits into wish->hall. The results about the
 * endless train are computed before rounding. The members `sizes` and `hall` of the limits have no effect.
 *
 * The status is DOM_BAD_HEIGHT, DOM_BAD_SAFETY, DOM_BAD_HALL, DOM_BAD_G or DOM_BAD_PUSH if a member of the
 * wish is outside its range, and DOM_BAD_Q, DOM_BAD_HALL, DOM_BAD_GAP (the grid) or DOM_BAD_THICKNESS (a
 * board) if a member of the limits is.
 */
enum dom_status dom_design_find(const struct dom_train *train, const struct dom_wish *wish,
                                const struct dom_limits *limits, const struct dom_compute *compute,
                                struct dom_design *design);

/* Writes the design->steps + 1 dominoes of a design that was found for these arguments. The first mass is
 * 1 kg. `limits` may be NULL. The status is DOM_BAD_COUNT unless design->limit is DOM_DESIGN_FITS. */
enum dom_status dom_design_dominoes(const struct dom_train *train, const struct dom_wish *wish,
                                    const struct dom_limits *limits, const struct dom_design *design,
                                    struct dom_domino *domino);

/* ---- Parallel work ---- */

/* The library starts no threads. It divides parallel work into tasks, and a callback of the caller runs them:
 * task(0, context) to task(count - 1, context), each exactly once, in any order and on any threads. The
 * callback returns DOM_OK when all tasks are done, or the reason why it left out some. The library passes
 * `pool` to it unchanged. */
typedef void dom_task(size_t index, void *context);
typedef enum dom_status dom_parallel(size_t count, dom_task *task, void *context, void *pool);

/* ---- Errors: the same row, set up many times ---- */

/*
 * The errors that a row may have after it has been set up: X(name, unit, meaning). If the unit is "", the
 * error is relative to the value. The friction between dominoes and the friction of the floor are exceptions:
 * their errors are added to the coefficient. From `gap` to `radius`, each domino has its own error. From
 * `friction` on, there is one error for the whole row.
 */
#define DOM_ERRORS(X)                                                                                        \
    X(gap, "m", "gap before each domino; an error moves this domino and all later ones")                     \
    X(place, "m", "place of each domino; an error moves no other domino")                                    \
    X(height, "", "height of each domino; the error is relative to the height")                              \
    X(thickness, "", "thickness of each domino; the error is relative to the thickness")                     \
    X(mass, "", "mass of each domino; the error is relative to the mass")                                    \
    X(lean, "rad", "lean of each domino")                                                                    \
    X(radius, "", "radius of the edges of each domino; the error is relative to the radius")                 \
    X(friction, "", "friction between dominoes, the same for all dominoes")                                  \
    X(slope, "rad", "slope of the floor, the same for all dominoes")                                         \
    X(floor, "", "friction of the floor, the same for all dominoes")                                         \
    X(push, "rad/s", "push of the first domino")

enum dom_error_of {
#define DOM_ERROR_ENUM(name, unit, meaning) DOM_ERROR_##name,
    DOM_ERRORS(DOM_ERROR_ENUM)
#undef DOM_ERROR_ENUM
        DOM_ERROR_COUNT
};

/* A random error. */
struct dom_random_error {
    double size;  /* >= 0: the standard deviation of a normal distribution, or the limit of a uniform one */
    bool uniform; /* true if all errors from -size to size are equally likely */
};

/*
 * The random errors of a row. When an error changes the height or the thickness of a domino, its mass changes
 * too. A solid domino keeps its density. A box keeps the density of its wood and the thickness of its walls.
 *
 * Errors of radii count only if the row has rounded edges. Errors of the floor count only if an engine runs
 * the row. Errors of the push count only if the row has a push.
 *
 * Errors that are too large are cut off:
 * - Dominoes that would overlap are moved until they touch.
 * - No size falls below 1/100 of its intended value.
 * - A thickness never becomes too small for the walls or the rounded edges, and a radius never too large.
 * - A slope on which a domino would fall over by itself becomes the steepest slope on which all stand.
 * - A domino that would fall over by itself gets the largest lean at which it stands.
 * - A friction or a push that would be negative becomes 0.
 * - If the first domino would touch the second one at a smaller tilt than row->release, it is released where
 *   they touch.
 */
struct dom_placement {
    struct dom_random_error error[DOM_ERROR_COUNT];
    /* Each error of row i depends only on the seed, the kind of the error and i. */
    unsigned long seed;
    size_t first, rows;     /* run the rows from number `first` to `first` + `rows` - 1; `rows` >= 1 */
    dom_parallel *parallel; /* runs batches of rows; NULL to run them one after the other */
    void *pool;             /* the last argument of `parallel` */
};

/* How many rows of a placement fall. */
struct dom_study {
    size_t rows, fall; /* the number of rows, and how many of them fall completely */
    /* The number of rows that the model cannot decide (DOM_ROW_PASSES and DOM_ROW_PARTS). They widen the
     * interval. */
    size_t unknown;
    /* the 95 % interval (Clopper and Pearson) for the probability that a row falls */
    double low, high;
};

/*
 * Runs the rows of a placement and counts how many of them fall. The tolerance is 1e-9 or compute->tol,
 * whichever is larger. The result does not depend on placement->parallel. After DOM_INTERRUPTED, only the
 * rows that were run are counted. Unless `stops` is NULL, stops[k] is set to the number of rows that ended at
 * domino k + 1, except those that the model cannot decide.
 *
 * The status is DOM_BAD_ERROR if the size of an error is not a finite number >= 0. It is DOM_NO_LEAN if leans
 * have errors, and either the row has rounded edges or an engine runs it. A status that dom_row_run or
 * placement->parallel returns is passed on.
 */
enum dom_status dom_placement_study(const struct dom_row *row, const struct dom_compute *compute,
                                    const struct dom_placement *placement, struct dom_study *study,
                                    size_t *stops);

/* Sets `low` and `high` from the counts. The counts may be sums over several studies of one placement. */
enum dom_status dom_study_interval(struct dom_study *study);

/* How precisely a row must be set up: the size of an error in its unit, or a factor for all errors, with its
 * 95 % interval. `sigma` is infinite if enough rows fall even with the largest size that is tried, and `low`
 * is 0 if there are too few rows for a lower bound. */
struct dom_budget {
    double sigma, low, high;
};

/*
 * Finds how large one kind of error may be: the size `sigma` at which the whole row falls with the given
 * probability, 0 < probability < 1. The errors of all other kinds stay as they are. If `kind` is
 * DOM_ERROR_COUNT, all errors are multiplied by the factor `sigma` instead. The largest sizes that are tried
 * are the widest gap of the row for gaps and places, 1 for relative errors and friction, the steepest slope
 * on which the row stands for angles, the push itself for the push, and 64 for factors.
 *
 * The status is DOM_STOPS if too few rows fall even at sigma = 0.
 */
enum dom_status dom_placement_budget(const struct dom_row *row, const struct dom_compute *compute,
                                     const struct dom_placement *placement, enum dom_error_of kind,
                                     double probability, struct dom_budget *budget);

/* ---- The most reliable row ---- */

/*
 * Changes a row so that it falls as reliably as possible with the random errors of a placement. Writes the
 * row->count changed dominoes.
 *
 * study[0] counts how many rows of the placement fall before the changes, and study[1] how many fall after
 * them. The search uses other random rows, whose numbers follow those of the placement, and the model; an
 * engine runs only the rows that are counted. The result does not depend on placement->parallel.
 *
 * If the given row is within the limits, it is the result unless a more reliable row is found. If it is not,
 * the result is the best row found within the limits, even if it is less reliable. If none was found, the
 * result is the given row, and study[1].rows is 0.
 *
 * After an interrupt, the status is DOM_INTERRUPTED, and the result is the best row so far; if study[0].rows
 * is 0, the dominoes are not written. The status is DOM_BAD_HALL if the dominoes do not fit into the hall
 * even without gaps. If a member of the limits is outside its range, the status is DOM_BAD_THICKNESS (a
 * board), DOM_BAD_Q or DOM_BAD_GAP (the grid). Other statuses are those of
 * dom_placement_study.
 */
enum dom_status dom_row_improve(const struct dom_row *row, const struct dom_compute *compute,
                                const struct dom_placement *placement, const struct dom_limits *limits,
                                dom_progress *progress, void *context, struct dom_domino *domino,
                                struct dom_study study[2]);

#ifdef __cplusplus
}
#endif

#endif
