/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Studies of rows, in double: how to mend a row that stops, how precisely a row must be set up, how reliably
 * it falls, and how to design one. */
#ifndef DOMINO_STUDY_H
#define DOMINO_STUDY_H

#include "domino_row.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Reports the progress of a long computation: `done` parts of `of` are complete. May be NULL. */
typedef void dom_progress(size_t done, size_t of, void *context);

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
    size_t domino; /* the number of the domino; 0 for friction */
    double now;    /* the current value */
    /* The window, or NaN if none was found. An end is rounded inward to seven digits, unless it is an end of
     * the range of values that are tried. */
    double low, high;
};

/*
 * Finds the windows of all gaps or places (row->count - 1 windows, from domino 2 on), of all heights,
 * thicknesses or leans (row->count windows), or of friction (one window).
 *
 * If the row falls, a window is the interval around the current value. If it does not, the window is the
 * nearest interval, on either side: a value in it mends the row. If the fall ends at domino k, only the
 * dominoes from k - 29 to k + 1 have windows, and if the gap after domino k is too wide to reach across, no
 * other gap has one. These values are tried:
 * - gaps from 0 to the height of the domino before the gap,
 * - places up to the next domino, as long as the gap before the domino stays in the range of gaps,
 * - heights and thicknesses from 1/100 to 4 times the current one, if the domino can stand on the slope, and
 *   walls and rounded edges fit; a height stays on the same side of row->boxes_above,
 * - frictions from 0 to 2, or to 4 times the current friction if that is more, but at most DOM_MU_HIGHEST,
 * - leans in both directions, until the domino falls over by itself.
 *
 * All dominoes fall at `low` and at `high`. In each direction, the search takes up to 40 steps of increasing
 * length, of which the first is 1/64,000 of the range. An interval that is narrower than a step can be
 * missed, within the window, too. With an engine, there are up to 10 steps, the first is 1/1,000 of the
 * range, and `low` and `high` have three digits. Calls progress for each window. The statuses are those of
 * dom_row_run.
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
    DOM_DESIGN_HALL    /* the hall is too short; `needs` is the length of the shortest row, in m */
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
    size_t dominoes; /* the least number of dominoes, or 0 for the smallest number that does */
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
 * The row has the fewest dominoes, and r is such that the last one is exactly `height` tall. The separation
 * is a multiple of 0.001, as close to that of the largest growth as the hall and the start of the row allow.
 * If the row is too long for the hall, the shortest row is tried, which may have up to 30 more dominoes.
 *
 * Unless `limits` is NULL, the row can be built: sizes and gaps are multiples of the grid, except the sizes
 * of the first domino and the height of the last, and every thickness is that of a board, if there are
 * boards. The rounded row is as safe as wish->safety demands and fits into wish->hall. The results about the
 * endless train are computed before rounding. The members `sizes` and `hall` of the limits have no effect.
 *
 * Unless `domino` is NULL, *domino is set to the design->steps + 1 dominoes of the row, which the caller
 * frees with free(), or to NULL if no row was found. The first mass is 1 kg.
 *
 * The status is DOM_BAD_HEIGHT, DOM_BAD_SAFETY, DOM_BAD_HALL, DOM_BAD_G or DOM_BAD_PUSH if a member of the
 * wish is outside its range, and DOM_BAD_Q, DOM_BAD_HALL, DOM_BAD_GAP (the grid) or DOM_BAD_THICKNESS (a
 * board) if a member of the limits is.
 */
enum dom_status dom_design_find(const struct dom_train *train, const struct dom_wish *wish,
                                const struct dom_limits *limits, const struct dom_compute *compute,
                                struct dom_design *design, struct dom_domino **domino);

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
    X(place, "m", "place of each domino but the first; an error moves no other domino")                      \
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
    size_t unknown;    /* rows that the model cannot decide (DOM_ROW_PASSES and DOM_ROW_PARTS) */
    /* The 95 % interval (Clopper and Pearson) for the probability that a row falls. Unknown rows widen it. */
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
 * 95 % interval. `sigma` is infinite if enough rows fall even with the largest size, and `low` is 0 if there
 * are too few rows for a lower bound. */
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
 * Changes a row so that it falls as reliably as possible with the random errors of a placement, and writes
 * the row->count changed dominoes. study[0] counts how many rows of the placement fall before the changes,
 * and study[1] how many fall after them. The search uses other random rows, whose numbers follow those of the
 * placement, and the model; an engine runs only the rows that are counted.
 *
 * If the given row is within the limits, it is the result unless a more reliable row is found. If it is not,
 * the result is the best row found within the limits, even if it is less reliable. If none was found, the
 * result is the given row, and study[1].rows is 0.
 *
 * After an interrupt, the status is DOM_INTERRUPTED, and the result is the best row so far; if study[0].rows
 * is 0, the dominoes are not written. The status is DOM_BAD_HALL if the dominoes do not fit into the hall
 * even without gaps, and DOM_BAD_THICKNESS (a board), DOM_BAD_Q or DOM_BAD_GAP (the grid) if a member of the
 * limits is outside its range. Other statuses are those of dom_placement_study.
 */
enum dom_status dom_row_improve(const struct dom_row *row, const struct dom_compute *compute,
                                const struct dom_placement *placement, const struct dom_limits *limits,
                                dom_progress *progress, void *context, struct dom_domino *domino,
                                struct dom_study study[2]);

#ifdef __cplusplus
}
#endif

#endif
