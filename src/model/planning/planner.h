/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds how safe the candidates for a design are, and how long. A candidate is a train or a row with a
 * constant growth. */
#ifndef DOM_PLANNER_H
#define DOM_PLANNER_H

#include "dispatch/dispatch.h"
#ifdef DOMQ
#define REAL_QUAD
#endif
#include "numerics/real.h"
#include <stdlib.h>

/* Separations are multiples of 1/GRID, which is about 0.05 mm for the standard domino. The search for the
 * best separation starts with steps of COARSE/GRID. */
enum { GRID = 1000, COARSE = 20 };

/* The state of a search. Once the status is not DOM_OK, no further train or row is computed, and every test
 * counts as failed. */
struct planner {
    struct dom_train train;
    /* settings of the search, which computes in double for every precision of the result */
    struct dom_compute compute;
    const struct dom_wish *wish;
    /* the sizes that the dominoes may have, or NULL if any sizes are allowed */
    const struct dom_limits *limits;
    struct dom_domino *domino; /* array with room for `room` dominoes */
    size_t room;
    enum dom_status status;
    dom_real failed; /* last separation at which a train or row could not be computed, or 0 */
    bool whole;     /* if false, a run of a row may end at the first domino that is less safe than required */
    size_t weakest; /* number of the domino with the smallest ratio in the last row */
    dom_real least; /* kinetic / barrier of the domino `weakest` */
    dom_real seconds, engine_seconds; /* duration of the last row, by the model and by the engine */
    bool engine_refused; /* true if a row that was safe enough in the model did not fall in the engine */
};

/* A candidate row: the separation k/GRID, and the number of steps from the first domino to the last. */
struct choice {
    int k;
    size_t steps;
};

/* Prepares a search. If a member of the wish or of the limits is outside its range, `status` says which one.
 * The caller frees `domino`. */
struct planner planner_make(const struct dom_train *train, const struct dom_wish *wish,
                            const struct dom_limits *limits, const struct dom_compute *compute);

dom_real separation(int k);

/* Returns the growth that leads from the first height to the last one in `steps` steps. */
dom_real growth(const struct planner *p, size_t steps);

/* Returns the kinetic energy of the endless train divided by its barrier, or 0 if the train has no cycle. */
dom_real train_ratio(struct planner *p, dom_real s, dom_real r);

/* Writes the dominoes of a candidate row, and enlarges the array if necessary. Returns false if memory is
 * exhausted. */
bool row_write(struct planner *p, struct choice c);

/* Returns the row whose dominoes were written last. */
struct dom_row row_of(const struct planner *p, struct choice c, dom_real push,
                      const struct dom_engine *engine);

/* Returns the smallest kinetic / barrier of the row's dominoes, or 0 if not all of them fall. Unless `times`
 * is set, the run ends at the first ratio below the required safety. */
dom_real row_ratio(struct planner *p, struct choice c, dom_real push, bool times);

/* Returns the length of the standing row from the back of the first domino to the front of the last one, for
 * the separation s and the thickness d of the train, before the dimensions are rounded. */
dom_real feet_of(const struct planner *p, size_t steps, dom_real s);

/* Returns the length of the row after the last domino has fallen forwards, before the dimensions are rounded.
 */
dom_real length_of(const struct planner *p, struct choice c);

/* Returns the length from the back of the first domino to the front of the last one of the row that was
 * written last. */
dom_real row_feet(const struct planner *p, struct choice c);

/* Returns the largest k such that a row with the separation k/GRID fits into a hall of this length. Returns a
 * number below 1 if there is none. */
int widest(const struct planner *p, size_t steps, dom_real hall);

/* Computes the chosen row with the requested precision, and fills the design with the result. */
void design_fill(struct planner *p, struct choice c, const struct dom_compute *compute,
                 struct dom_design *design);

/* A design without a row. */
extern const struct dom_design no_design;

#endif
