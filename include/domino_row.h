/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finite rows of any dominoes: how they fall, what saves a row that does not fall, how precisely a row must
 * be set up, and the design of a row. <domino.h>, which has the introduction, includes this header.
 */
#ifndef DOMINO_ROW_H
#define DOMINO_ROW_H

#include "domino.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How a row ends: X(name, meaning). */
#define DOM_ROW_ENDS(X)                                                                                      \
    X(FALLS, "all fall")                                                                                     \
    X(STOPS, "its energy is not enough to tip it over")                                                      \
    X(MISSES, "it misses the next domino: the gap is larger than its height")                                \
    X(PASSES, "its upper edge passes above the next domino, a contact that the model does not include")      \
    X(LEANS, "it touches the next domino before it tips over: it needs a push")                              \
    X(PARTS, "it moves ahead of the dominoes that lean on it, which the model does not include")             \
    X(LOCKS, "friction locks it: the contact force passes on the wrong side of its hinge")                   \
    X(SKEWED, "as one of them leans, it touches the next already, or where the model has no contact")

enum dom_row_end {
#define DOM_ROW_ENUM(name, text) DOM_ROW_##name,
    DOM_ROW_ENDS(DOM_ROW_ENUM)
#undef DOM_ROW_ENUM
};

/* Returns the meaning of an end: a phrase about the domino where the row ends. */
const char *dom_row_end_text(enum dom_row_end end);

/* What a design keeps small. Mass: at given heights of the first and last, the fewest dominoes weigh least.
 */
enum dom_least { DOM_LEAST_DOMINOES, DOM_LEAST_LENGTH, DOM_LEAST_MASS };

/* What makes a wish impossible. */
enum dom_design_limit {
    DOM_DESIGN_FITS,   /* nothing: there is a row */
    DOM_DESIGN_SAFETY, /* no train has this safety; `needs` is less than the largest that one has */
    DOM_DESIGN_START,  /* the start is too weak; `needs` is a push in rad/s that is enough, or NaN */
    DOM_DESIGN_HALL,   /* the hall is too short; `needs` is the length of the shortest row found, in m */
    DOM_DESIGN_ENGINE, /* rows with this safety do not fall in the engine of the wish */
    DOM_DESIGN_FAILED  /* not known: trains or rows could not be computed; `needs` is the s of one of them */
};

/* What dom_row_windows changes. */
enum dom_window_of {
    DOM_WINDOW_GAP,    /* the gap before a domino; all after it move along */
    DOM_WINDOW_PLACE,  /* the place of a domino, which alone moves: from the back of the first to its back */
    DOM_WINDOW_HEIGHT, /* the height of a domino; its density stays, so that its mass changes with it */
    DOM_WINDOW_FRICTION, /* the friction between all dominoes */
    DOM_WINDOW_PLUMB     /* the lean of a domino, in rad */
};

/* The most changes that dom_row_mend finds. */
enum { DOM_MENDS = 31 };

/* Reports that `done` of `of` parts of a long computation are done: a function of the caller. */
typedef void dom_progress(size_t done, size_t of, void *context);

/* ---- Parallel work ---- */

/*
 * The library starts no threads. It divides parallel work into tasks, and calls a function of the caller, a
 * dom_parallel, to run them. That function runs task(0, context) to task(count - 1, context), each once, in
 * any order and on any threads, and waits for all of them. It returns DOM_OK, or the reason why tasks were
 * left out, such as DOM_INTERRUPTED. `pool` is the caller's own.
 */
typedef void dom_task(size_t index, void *context);
typedef enum dom_status dom_parallel(size_t count, dom_task *task, void *context, void *pool);

/* ==== From here on everything is also in <domino_quad.h>, with domq_ instead of dom_ ==== */

/* ---- A finite row of any dominoes ---- */

/*
 * A solid block. The gap is the free distance to the domino before it, at the foot, as if it were upright; 0
 * for the first, which has none. A domino whose floor or foot is not flat is not plumb: it rests tilted about
 * its front edge, the one on which it turns when it falls. Its lean must be within its dom_lean_limits.
 */
struct dom_domino {
    dom_real height, thickness, gap; /* m */
    dom_real mass;                   /* kg */
    /* m, of its edges if rho of the row is not 0; 0: rho times the height */
    dom_real radius;
    dom_real lean; /* rad, its tilt before it is hit, > 0 in the direction of the fall */
};

/*
 * Finds the leans, lean[0] < lean[1], between which a domino stands on a floor with the slope alpha without
 * falling over by itself, in rad: -(limit + alpha) and limit - alpha, since the centre of the block must be
 * above the flat part of its foot, tan limit = thickness / height - 2 rho. rho, the radius of its edges over
 * its height, is as in struct dom_row, unless the domino has a radius of its own. With sharp edges the limit
 * is theta_u (4; b1). An upright domino stands if 0 is between the two leans. Checks nothing.
 */
void dom_lean_limits(const struct dom_domino *domino, dom_real alpha, dom_real rho, dom_real lean[2]);

/*
 * Dominoes 1, 2, ... of any sizes, in the order in which they fall. As in a train, the foremost falling
 * domino is the head, and all before it lean on it, until it hits the next.
 */
struct dom_engine;
struct dom_row {
    const struct dom_domino *domino; /* `count` of them: domino[0] is number 1 */
    size_t count;                    /* at least 1 */
    dom_real g;                      /* acceleration of gravity in m/s^2, > 0 */
    dom_real push; /* rad/s, >= 0, of the first, upright domino; NaN: it is tipped over its edge and let go */
    /* The effects of DOM_DYNAMICS, as in struct dom_train, but the thickness of the walls is in m, the same
     * for all dominoes. */
    dom_real mu, alpha, walls, rho;
    bool floor;                      /* true: find the friction that the floor needs */
    const struct dom_engine *engine; /* runs the row instead of this library; NULL: the library does */
};

/* Returns a row without dominoes, to fill in: g = 9.81 m/s^2, no push, no effects, no engine. */
struct dom_row dom_row_default(void);

/* One domino of the row as head: from when it is hit to when it hits the next or lies on the floor. */
struct dom_fall {
    size_t domino;     /* number of this domino, from 1 */
    dom_real time;     /* s, when it was hit; the clock starts with the push, or else with the first hit */
    dom_real duration; /* s, until it hits the next or lies on the floor; NaN if it does neither */
    dom_real omega;    /* rad/s, just after it was hit */
    dom_real kinetic;  /* J, of all dominoes that move, just after it was hit */
    dom_real barrier;  /* J, the kinetic energy needed to go on; infinite if friction locks on the way */
    dom_real margin;   /* J, kinetic - barrier */
    dom_real lost;     /* J, in the collision */
    dom_real friction_work; /* J, to friction between dominoes since it was hit; NaN if the row ends here */
    dom_real theta_m;       /* rad, the tilt where it is hardest to go on */
    dom_real theta;         /* rad, the tilt where it hits the next, lies on the floor, or comes to rest */
    size_t moving;          /* how many dominoes move when it is hit, itself included */
    /* As in struct dom_floor, with numbers from 1; NaN and 0 unless row->floor is set. */
    dom_real floor_motion, floor_hit;
    size_t floor_domino, floor_hit_domino;
};

struct dom_verdict {
    enum dom_row_end end;
    size_t domino;     /* the last domino that was hit, where the row ends; with DOM_BAD_... the wrong one */
    dom_real short_by; /* J, missing there: > 0 for DOM_ROW_STOPS, infinite if friction locks farther on */
    dom_real seconds;  /* until all dominoes lie, or until the last hit; NaN without times */
    size_t weakest;    /* the domino that goes on with the smallest margin / barrier; 0: none */
    dom_real spare;    /* that ratio; infinite if there is no barrier */
};

/*
 * Runs a row. visit, unless NULL, is called for each domino that is hit, in order; it returns false to end
 * the run early. times = false saves the work that only times need, which are then NaN. DOM_BAD_HEIGHT and
 * other statuses about a domino write its number to verdict->domino. compute->method is not used.
 */
typedef bool dom_fall_visit(const struct dom_fall *fall, void *context);
enum dom_status dom_row_run(const struct dom_row *row, const struct dom_compute *compute, bool times,
                            dom_fall_visit *visit, void *context, struct dom_verdict *verdict);

/*
 * Runs rows instead of this library, for instance in a rigid-body engine, with effects that the model lacks.
 * run answers as dom_row_run does, and finds `own` in row->engine. All functions of rows then call it, except
 * dom_row_watch: DOM_NO_METHOD. Studies may call it in many threads.
 */
typedef enum dom_status dom_row_runner(const struct dom_row *row, const struct dom_compute *compute,
                                       bool times, dom_fall_visit *visit, void *context,
                                       struct dom_verdict *verdict);
struct dom_engine {
    dom_row_runner *run;
    void *own;
};

/* The row at one time. */
struct dom_moment {
    dom_real time;                /* s, as in struct dom_fall */
    size_t head;                  /* number of the last domino that was hit, from 1 */
    size_t moving;                /* how many dominoes move with it, itself included */
    const dom_real *tilt, *omega; /* of domino 1 at [0], ...: rad and rad/s; valid during the visit */
};

/*
 * Runs a row and calls visit for each of `count` times in s, which do not decrease; a time after the motion
 * gives the state in which the run ends, with the time when it ends, so INFINITY finds that. A domino that
 * has detached keeps the tilt it had then. times < 0 are for a first domino that is tipped over its edge;
 * else, and for NaN: DOM_BAD_TIME. DOM_NO_MARGIN: the row comes so close to a stop that later times have no
 * value. visit returns false to end the run. Other statuses as dom_row_run.
 */
typedef bool dom_moment_visit(const struct dom_moment *moment, void *context);
enum dom_status dom_row_watch(const struct dom_row *row, const struct dom_compute *compute,
                              const dom_real *times, size_t count, dom_moment_visit *visit, void *context,
                              struct dom_verdict *verdict);

/* Writes `count` dominoes of a train, with gaps of s times own height and the first mass in kg. No checks. */
void dom_row_of_train(const struct dom_train *train, const struct dom_scale *scale, dom_real mass,
                      struct dom_domino *domino, size_t count);

/* Writes a row with the growth r to domino[0] ... domino[count - 1]: a function of the caller. */
typedef void dom_row_make(dom_real r, struct dom_domino *domino, size_t count, void *context);

/* The largest growth of a row. */
struct dom_row_growth {
    dom_real r_max; /* NaN if not all dominoes fall at any growth that was tried */
    dom_real r_min; /* from here to r_max all fall: 1 unless the row does not fall at r = 1 */
    /* How the row ends just above r_max, or at r = 1 if r_max is NaN; DOM_ROW_FALLS if `highest` limits
     * r_max. */
    enum dom_row_end ends;
};

/*
 * Finds the largest growth at which all dominoes of a row fall, to the relative tolerance: r is raised from 1
 * to `highest`, up to the first growth at which they fall, and from there to the first one at which they do
 * not. make writes the dominoes for each r that is tried; for a train it calls dom_row_of_train, and
 * `highest` is dom_train_reach. row->domino is not used. With steps of 2 % in r, 10 % where an engine does
 * not let the row fall, a narrower interval can be missed. Statuses as dom_row_run, also for the dominoes
 * that make writes; DOM_BAD_R: `highest` is not a finite number >= 1.
 */
enum dom_status dom_row_rmax(const struct dom_row *row, const struct dom_compute *compute, dom_real highest,
                             dom_row_make *make, void *context, struct dom_row_growth *growth);

/* A change of one gap that makes all dominoes of a row fall. */
struct dom_mend {
    size_t domino;  /* the number of the domino whose gap changes, from 2 */
    dom_real gap;   /* m, the gap now */
    dom_real to;    /* m, the nearest gap found with which all fall, to seven digits */
    dom_real until; /* m, the farthest such gap: all fall from `to` to `until` */
};

/*
 * Finds the changes of single gaps that make all dominoes fall, the smallest change first, and writes their
 * number to *count; 0 for a row that falls already. Tries the gap after the domino where the row ends, and
 * the 30 gaps before that one: down to 0, and up to the height of the domino before the gap; for a gap that
 * is wider than that height, `to` is the height if all fall then. Each way takes 40 steps, the first 1/64,000
 * of the way and each larger than the one before, then bisection; an interval of gaps narrower than a step
 * can be missed. progress, unless NULL, is called for each gap. Statuses as dom_row_run.
 */
enum dom_status dom_row_mend(const struct dom_row *row, const struct dom_compute *compute,
                             dom_progress *progress, void *context, struct dom_mend mends[DOM_MENDS],
                             size_t *count);

/* The values of one gap, place, height, friction or lean with which all dominoes fall, all others being as
 * they are. */
struct dom_window {
    size_t domino; /* the number of the domino; 0 for the friction */
    dom_real now;  /* the value now, in m; of the friction without a unit, of a lean in rad */
    dom_real low;  /* the smallest value of the window, to seven digits; NaN: no window was found */
    dom_real high; /* the largest value of the window */
    bool others;   /* true: the row also falls with values outside the window */
    /* How the row ends with a value just outside; DOM_ROW_FALLS if the window reaches the end of the values
     * that are tried. Both are DOM_ROW_FALLS for a row that does not fall now. */
    enum dom_row_end below, above;
};

/*
 * Finds the windows of all gaps or places (row->count - 1 of them, from domino 2 on), of all heights or leans
 * (row->count), or of the friction (one). If the row falls, a window is the one around the value now, low <=
 * now <= high; if not, it is the nearest one beside the value, and dominoes farther than the one after the
 * end of the row have none. Tries gaps from 0 up to the height of the domino before the gap; places that are
 * such gaps, up to the next domino; heights from 1/100 to 4 times the height now, as far as the domino stands
 * on the slope, with its density and the angle of its lean; friction from 0 to 2, or to 4 times the friction
 * now; and leans to either side, until the domino falls over by itself. Steps as dom_row_mend, then
 * bisection; all fall with low and high themselves. An interval narrower than a step, in which the row does
 * not fall, can be missed. For an engine's rows a window has a quarter of the steps and three digits, and a
 * value that the engine cannot decide ends it. progress, unless NULL, is called for each window. Statuses as
 * dom_row_run.
 */
enum dom_status dom_row_windows(const struct dom_row *row, const struct dom_compute *compute,
                                enum dom_window_of of, dom_progress *progress, void *context,
                                struct dom_window *windows);

/*
 * Finds the weakest push with which all dominoes of a row fall, in rad/s, rounded up to four digits. Doubles
 * the push that turns the first domino over its edge, or row->push if that is larger, until all fall; then
 * bisects. Writes NaN if no push tried up to `strongest` is enough, and row->push if all fall already.
 * Statuses as dom_row_run; DOM_BAD_PUSH also if `strongest` is not a finite number > 0.
 */
enum dom_status dom_row_push(const struct dom_row *row, const struct dom_compute *compute, dom_real strongest,
                             dom_real *push);

/* ---- The design of a row ---- */

/* What a builder wishes. */
struct dom_wish {
    dom_real first, height; /* m, of the first domino and of the last; height > first */
    dom_real safety;        /* > 1: times the energy that each cycle needs */
    dom_real hall;          /* m, for the row with its last domino lying; > height; infinite: no limit */
    dom_real g, push;       /* as in struct dom_row */
    enum dom_least least;
    const struct dom_engine *engine; /* in which the row must fall, too; NULL: none */
};

/* A row of a train, from a wish. Unless limit is DOM_DESIGN_FITS, only limit and needs are set, else NaN or
 * 0. */
struct dom_design {
    dom_real s, r;    /* gap of each domino over its height, a multiple of 0.001; growth */
    size_t steps;     /* first r^steps = height: there are steps + 1 dominoes */
    dom_real feet;    /* m, from the back of the first to the front of the last */
    dom_real length;  /* m, the same with the last lying: feet + height */
    dom_real seconds; /* as in struct dom_verdict, by the engine of the wish if it has one */
    dom_real train;   /* kinetic / barrier of the endless train */
    dom_real row;     /* the smallest kinetic / barrier of the row's dominoes, the first left out */
    size_t weakest;   /* the number of that domino, from 2 */
    enum dom_design_limit limit;
    dom_real needs; /* what would make the wish possible; NaN with DOM_DESIGN_FITS */
};

/*
 * Finds the row of a train in which every cycle has at least `safety` times the energy that it needs: kinetic
 * >= safety barrier in the endless train, and at each domino of the row after the first. The fewest dominoes
 * are those of the largest growth at which the train has this safety at any s; r is then made smaller, so
 * that the last domino is exactly `height` tall, and s stays where that growth is largest, or as close as the
 * hall and the start of the row allow. DOM_LEAST_LENGTH takes the shortest row instead, with up to 30
 * dominoes more. train->s and train->r are not used. Separations are tried at multiples of 0.001, in double;
 * one at which a train or a row cannot be computed is passed over. With an engine in the wish, all dominoes
 * of the row also fall in the engine, which is asked at separations 0.1 apart; the safety is that of the
 * model. DOM_BAD_HEIGHT, DOM_BAD_SAFETY, DOM_BAD_HALL, DOM_BAD_G, DOM_BAD_PUSH: a wish is outside its range.
 */
enum dom_status dom_design_find(const struct dom_train *train, const struct dom_wish *wish,
                                const struct dom_compute *compute, struct dom_design *design);

/* ---- Errors of placement: the same row, set up many times ---- */

/*
 * Random errors, normally distributed, of every gap and height. A domino keeps its density: its mass changes
 * with its height. Dominoes that would overlap touch.
 */
struct dom_placement {
    dom_real sigma;         /* standard deviation of a gap in m, >= 0 */
    dom_real heights;       /* relative standard deviation of a height, 0 ... 1 */
    unsigned long seed;     /* row number i depends on the seed and i alone */
    size_t first, rows;     /* the rows are number first ... first + rows - 1; rows >= 1 */
    dom_parallel *parallel; /* runs batches of rows; NULL: the batches run one after the other */
    void *pool;             /* the last argument of `parallel` */
};

/* How many rows of a placement fall. */
struct dom_study {
    size_t rows, fall; /* all rows, and those in which every domino falls */
    size_t unknown;    /* rows that the model cannot decide, PASSES and PARTS; they widen the interval */
    double low, high;  /* 95 % interval of the probability that all fall (Clopper and Pearson) */
};

/*
 * Counts how many rows fall. stops, unless NULL, has room for row->count numbers: how often a row ended at
 * each domino, unknown rows left out. The answer does not depend on placement->parallel. Rows are computed
 * with a tolerance of 1e-9 or compute->tol, whichever is larger. After DOM_INTERRUPTED the counts are those
 * of the rows that were run, if there are any. Statuses as dom_row_run, and those that placement->parallel
 * returns.
 */
enum dom_status dom_placement_study(const struct dom_row *row, const struct dom_compute *compute,
                                    const struct dom_placement *placement, struct dom_study *study,
                                    size_t *stops);

/* Sets low and high from the counts, also from the sums of the counts of other rows of one placement. */
enum dom_status dom_study_interval(struct dom_study *study);

/* How precisely the dominoes must be placed. */
struct dom_budget {
    /* m, with its 95 % interval; infinite if no error up to the largest gap matters; low is 0 if there are
     * too few rows for a bound. */
    double sigma, low, high;
};

/*
 * Finds the sigma at which the whole row falls with the given probability, 0 < probability < 1.
 * placement->sigma is not used. DOM_STOPS: even with sigma = 0 too few rows fall. DOM_INTERRUPTED, once
 * one is known: sigma and low are the largest with which as many of these rows fall, and high is the smallest
 * with which fewer fall, or infinite.
 */
enum dom_status dom_placement_budget(const struct dom_row *row, const struct dom_compute *compute,
                                     const struct dom_placement *placement, double probability,
                                     struct dom_budget *budget);

#ifdef __cplusplus
}
#endif

#endif
