/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands about a train, what their files share, and runs of the scene's row by the model or the
 * rigid-body engine. */
#pragma once

#include "interpreter/command.h"

extern const struct command cycle_commands[], walk_commands[], cost_commands[];

/* The members that most commands about a train share. */
#define TRAIN_COMMAND .precision = PRECISION_AS_SET, .train = true

/* The parts of commands that are defined outside the files of their tables. */
extern const struct column why_columns[];
/* Finds the largest growth with each of the two formulas for the fuel. */
enum dom_status limits_find(struct domq_train train, const struct any_compute *compute,
                            struct domq_limit *exact, struct domq_limit *paper);

bool run_count(const struct query *query, struct answer *a, struct problem *problem);
bool run_why(const struct query *query, struct answer *a, struct problem *problem);

/* Returns a word for the verdict about a train: "goes on", "stops", "locks" or "no fuel". */
struct cell verdict_cell(enum dom_status verdict);

/* Returns the reason why a train with this verdict does not keep falling, or NULL for any other status. */
const char *verdict_reason(enum dom_status verdict);

/* Prints whether the train keeps falling, and its energy divided by the energy that it needs. */
void verdict_train_say(const struct query *query, struct answer *answer, enum dom_status verdict,
                       const struct domq_barrier *barrier);

/* A method of a feature, with which 'cost' compares. It computes in double. */
struct method {
    const char *name;
    enum dom_status (*barrier)(const struct dom_train *, const struct dom_compute *, struct dom_barrier *);
    enum dom_status (*rmax)(const struct dom_train *, const struct dom_compute *, struct dom_limit *);
};

/* Returns omega. Omega is computed from its square: omegasq is tau^2 omega^2. */
struct cell cell_omega(domq_real omegasq, domq_real tau);

/* ---- A walk through the cycles of the train, event by event ---- */

/* The units in which the model measures one cycle. The head of each cycle is r times as large as the head
 * before it, and the units grow with the head. If the mass of the dominoes is not known, `energy` is
 * relative to the energy of the first head. */
struct walk_units {
    domq_real height; /* height of the head, in m */
    domq_real tau;    /* unit of time, in s */
    /* m g h / 2 of the head, in J if a mass is known */
    domq_real energy;
};

/* Cycles are numbered from 1. */
struct walk_units walk_units(const struct query *query, int cycle);

/* Returns the session's walk. Returns NULL if there is no walk, or if the train has changed since the walk
 * began. */
const struct walk *walk_now(const struct query *query);

/* Replaces the unit mgh/2 by J in the columns of an answer. */
void columns_in_joules(struct answer *answer);
/* Calls columns_in_joules if the mass of the dominoes is known. */
void walk_columns_in(const struct query *query, struct answer *answer);

/* Formats an angle in the session's unit for a sentence, for example as "28.65 deg" or "0.5 rad". */
struct measured angle_text(const struct query *query, domq_real theta, int digits);

/* ---- Words and numbers ---- */

/* Returns a cell that a table shows with this many digits and without an error bound. */
struct cell cell_narrow(domq_real value, int digits);

/* Rounds a positive number to this many significant digits, up or down. Returns any other number
 * unchanged. */
domq_real round_digits(domq_real value, int digits, bool up);

struct words {
    char text[CELL_TEXT + 40];
};

/* Returns a phrase about the energy that something has, divided by the energy that it needs: "needs 42 % of
 * the energy that it has", "has more than 100 times the energy that it needs" or, for a share below 1, "has
 * 96 % of the energy that it needs". */
struct words energy_words(domq_real share);

/* Returns "solid dominoes" for q = 4 and the noun "dominoes", or "dominoes with q = 3.5". */
struct words dominoes_words(domq_real q, const char *noun);

/* Returns a limit as text with the digits that the tolerance justifies, but no more than `most`. It is
 * rounded down, so that the printed value is still possible. A growth above 1 that would be rounded to 1 gets
 * more digits. */
struct words limit_words(const struct answer *a, domq_real limit, int most);

/* Returns where a first domino is released: "at 20 deg", "against the second" or, if it starts upright, "".
 * The tilt is that of struct domq_row. */
struct words release_words(domq_real release);

/* Like problem_status, for a search for the largest growth: if the limit is open, names the growth at which
 * the margin may be 0, and the later root. */
bool problem_limit(struct problem *problem, const struct scene *scene, enum dom_status status,
                   const struct domq_limit *limit);

/* ---- Whether a row that is at rest starts to fall ---- */

/* The result of running a row. If 'set push' is on, the fall starts with this push. If it is off, the
 * first domino just tips over. */
struct start {
    enum dom_status status; /* of the run, before a push is sought */
    size_t count;           /* number of dominoes in the row that was run */
    bool falls;             /* true if all dominoes of the row fall */
    enum dom_row_end end;
    double spare;       /* the smallest margin / barrier of the dominoes, if they fall or the row stops */
    size_t stops_at;    /* number of the domino at which the fall ends, counted from 1 */
    domq_real push;     /* the weakest push in rad/s that makes the row fall, or NaN */
    const char *engine; /* why the rigid-body engine runs the row, or NULL if the model runs it */
};

/* Finds the weakest push that makes all dominoes fall, or NaN if that push would lift the first domino off
 * the floor. The statuses are those of dom_row_weakest_push. */
enum dom_status push_find(const struct dom_row *row, const struct dom_compute *compute, double *push);

/* A very long row need not be run to its end. If the endless train keeps falling, and a row of this many
 * dominoes falls, then any longer row also falls, because a row forgets its start: in the model, the energy
 * of a cycle is a linear function of the energy of the cycle before it, with a slope below 1. */
enum { START_DOMINOES = 64 };

/* Runs a row of `dominoes` dominoes of the train, or the first part of a very long row. If the row does not
 * fall in the model and `seeks_push` is true, also finds start->push. Does not search for a push with the
 * rigid-body engine. */
bool start_run(const struct query *query, const struct domq_train *train, domq_real dominoes, bool seeks_push,
               struct start *start, struct problem *problem);

extern const char engine_undecided[]; /* what DOM_NOT_CONVERGED means if the engine runs the row */

/* Returns a copy of the scene with a row of `count` dominoes. The copy shares the memory of the original. */
struct scene start_scene(const struct query *query, const struct domq_train *train, size_t count);

struct start_growths {
    domq_real r_max;       /* the largest growth at which a row starts, or NaN if no growth is small enough */
    domq_real uncertainty; /* r_max is wrong by at most this number */
    bool is_too_slow;      /* true if r_max is NaN because the engine would take too long */
};

/* Fills in the q of the train, and of the other kinds of domino that have a name. Returns their number. */
enum { KINDS_MOST = 8 };
size_t kinds_find(const struct query *query, const struct domq_train *train, domq_real kind[KINDS_MOST]);

/* Finds the largest growth, up to `highest`, at which a row of the train's dominoes starts. */
bool start_growths_find(const struct query *query, const struct domq_train *train, domq_real highest,
                        struct start_growths *growths, struct problem *problem);

/* Returns "if its first domino just tips over", or "with a push of 3 rad/s". */
struct words start_words(const struct query *query);

/* Writes to `text` the reason why a row does not fall, for example "with a push of 3 rad/s, the fall ends at
 * domino 2: it has too little energy to tip over". Returns `text`. */
enum { START_TEXT = 400 };
const char *start_problem(const struct query *query, const struct start *start, char text[START_TEXT]);

/* ---- Searches along one variable (seek.c), for functions that are known only by their values. A place
 * without a value has the value NaN. ---- */

struct spot {
    double x, value;
};

typedef double seek_value(double x, void *context);

/* Climbs to a maximum between `low` and `high` by golden sections, from a spot between them or at one of
 * them. Stops when the interval is at most `grain` wide, when the value is above `enough`, or on level
 * ground. Returns the highest spot. */
struct spot seek_top(seek_value *at, void *context, double low, struct spot from, double high, double grain,
                     double enough);

/* Finds where a function changes its sign: the value at *good is at least 0, that at *bad is below 0 or NaN.
 * Moves both towards each other until they are at most `grain` apart, or until no double lies between them.
 */
void seek_edge(seek_value *at, void *context, struct spot *good, struct spot *bad, double grain);
