/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Types and functions that the files in this directory share, and the commands that are defined in them. */
#pragma once

#include "domino_study.h"
#include "interpreter/question.h"
#include "tables/csv.h"
#include "train/train.h"

extern const struct column fall_columns[], verdict_columns[], mend_columns[], tolerance_columns[],
    slip_columns[], fewest_columns[];
bool run_fall(const struct query *query, struct answer *a, struct problem *problem);
bool run_verdict(const struct query *query, struct answer *a, struct problem *problem);
bool run_mend(const struct query *query, struct answer *a, struct problem *problem);
bool run_tolerance(const struct query *query, struct answer *a, struct problem *problem);
bool run_fewest(const struct query *query, struct answer *a, struct problem *problem);
bool run_slip(const struct query *query, struct answer *a, struct problem *problem);

/* The parts of 'change', 'place', 'remove' and 'insert' (change.c). */
bool change_parse_dominoes(struct reader *reader, struct question *question);
bool change_parse_value(struct reader *reader, struct question *question);
bool change_bind(const struct question *question, const struct query *query, struct arguments *given,
                 struct problem *problem);
bool remove_bind(const struct question *question, const struct query *query, struct arguments *given,
                 struct problem *problem);
bool run_change(const struct query *query, struct answer *a, struct problem *problem);
bool run_remove(const struct query *query, struct answer *a, struct problem *problem);
const char *insert_sizes(const void *context, int k);
bool run_insert(const struct query *query, struct answer *a, struct problem *problem);

/* ---- A row of one's own (listed.c) ---- */

/* The measurements of a domino that 'change' can change. */
enum row_measure {
    MEASURE_HEIGHT,
    MEASURE_THICKNESS,
    MEASURE_GAP,
    MEASURE_MASS,
    MEASURE_RADIUS,
    MEASURE_LEAN,
    MEASURE_WIDTH,
    ROW_MEASURES
};

/* The dominoes of a file. */
struct row_file {
    size_t holders; /* reference count */
    struct domq_domino *domino;
    size_t count;
    bool has_masses;   /* the masses are in kg; otherwise, only their ratios are known */
    bool from_volumes; /* the masses follow from the volumes, not from a column "mass" or "relative" */
    char *path;
};

/* A domino of a row that has been changed. */
struct changed_domino {
    /* The domino that it is, or that it was copied from: its index in the file, or in the row that 'set row
     * N' makes. Along the row, these indices never decrease. */
    size_t origin;
    /* The changed measurements, and NaN for the others. A changed mass is stored as a factor, because the
     * mass also changes with the size. */
    struct domq_domino to;
};

/* The slot of a scene whose row comes from a file, or whose dominoes have been changed. Once it is in a
 * scene, it does not change. */
struct listed_row {
    struct slot slot;
    struct row_file *file;          /* NULL if the row is a changed 'set row N' */
    size_t changes;                 /* the number of dominoes in `change`, or 0 if none has been changed */
    struct changed_domino change[]; /* all dominoes of the row */
};

/* Returns NULL if the scene has no row, or the plain row of 'set row N'. */
static inline const struct listed_row *row_of(const struct scene *scene)
{
    return (const void *)scene->slot;
}

/* Returns true if the row comes from a file. */
static inline bool row_has_file(const struct scene *scene)
{
    return scene->slot && row_of(scene)->file;
}

/* Returns a row without changes and with room for `room` of them, or NULL if memory runs out. Shares the
 * file, which may be NULL. Until the row is in a scene, the caller owns it. */
struct listed_row *row_new(struct row_file *file, size_t room);

/* Returns a copy of the row of a scene that may be changed, with room for one more domino. If memory runs
 * out, sets *problem and returns NULL. */
struct listed_row *row_edit(const struct scene *scene, struct problem *problem);

/* Turns on the effect 'row' with the dominoes of a file. It is an error if a leaning domino would fall over
 * by itself on the slope of the scene. On failure, sets *problem, changes nothing and returns false. */
bool rowfile_load(struct scene *scene, const char *name, const struct run_context *run_context,
                  struct problem *problem);

/* Returns the number of dominoes in the row, or 0 if there is no row. */
size_t scene_row_count(const struct scene *scene);

/* Makes the row of a scene and prepares it for a run in the model or in the engine. If there is no row, or if
 * the row cannot be run, sets *problem and returns false. */
bool scene_row_make(const struct scene *scene, struct scene_row *row, struct problem *problem);

/* Only fills in the dominoes and their number. */
bool scene_row_list(const struct scene *scene, struct scene_row *row, struct problem *problem);

/* Fills in the first `count` dominoes of the row, with their masses and with the changes that the user has
 * made. If 'change' changes the height, the width stays as it was. */
void scene_row_fill(const struct scene *scene, struct domq_domino *domino, size_t count);

/* Returns true if the masses of the row are known in kg. Energies are then in J. If the masses are not known,
 * the unit of energy is m g h/2 of the first domino. */
bool scene_has_masses(const struct scene *scene);

/* Reports that the session has no row. Returns false. */
bool problem_no_row(struct problem *problem);

/* Returns how far the top of a domino is off plumb, in m. A backward lean is negative. */
domq_real lean_offset(const struct domq_domino *domino);

/* Returns true if a leaning domino with sharp edges does not fall over by itself on a slope of `alpha`
 * radians. If the domino would fall over, writes a message with the limit of the lean, and returns false. */
enum { LEAN_MESSAGE = 400 };
bool lean_stands(const struct domq_domino *domino, domq_real alpha, char message[LEAN_MESSAGE]);

/* Returns a pointer to the member that holds a measurement. `domino` may be the
 * member `to` of struct changed_domino. */
domq_real *row_measure_at(struct domq_domino *domino, enum row_measure measure);

/* Returns true if the measurement is a size: the height, the thickness or the width. When a size changes, the
 * domino keeps its density. */
static inline bool row_measure_is_size(enum row_measure measure)
{
    return measure == MEASURE_HEIGHT || measure == MEASURE_THICKNESS || measure == MEASURE_WIDTH;
}

/* ---- A run of the row ---- */

/* Results of a run of the rigid-body engine that commands show but the library does not need. */
struct engine_report {
    /* How far the foot of each domino that was hit has slid, in m; negative if it slid backwards. The caller
     * provides an element for each domino. */
    double *slid;
    bool lies; /* the last domino that was hit has fallen to the floor */
    /* How much the last halving of the time step changed the times: the largest change of any time, divided
     * by the duration. */
    double change;
    double steps;     /* time steps per sqrt(h/g) in the last run */
    double tolerance; /* how accurate the velocities are after each step of that run */
    double zero; /* the time in s from the start of that run to the moment from which times are measured */
    const char *version; /* of the engine */
    /* Does the same as dom_row_watch, but in the engine. The step size comes from this report. Before each
     * call of `visit`, stores in feet[k] how far the foot of domino k has slid, in m. k is counted from 0. */
    enum dom_status (*watch)(const struct dom_row *row, const struct dom_compute *compute,
                             const double *times, size_t count, dom_moment_visit *visit, void *context,
                             double *feet);
};

/* The row of the scene and the result of its run. Do not copy this struct: the engine points into it. */
struct row_run {
    struct scene_row scene;
    struct engine_report report; /* if the engine has run the row */
    struct domq_verdict verdict;
    struct domq_fall *fall; /* row_run stores an element for each domino that is hit, in order */
    size_t hits;
    bool timeless; /* a domino almost stops, so later times cannot be computed */
};

/* Makes the row of the scene without running it. After a failure nothing needs to be freed. */
bool row_run_begin(const struct query *query, struct problem *problem, struct row_run *run);
void row_run_free(struct row_run *run);

/* Makes the row of the scene, runs it, and stores every hit. The hits have times only if `timed` is true. The
 * friction that the floor needs is not computed. After a failure nothing needs to be freed. */
bool row_run(const struct query *query, struct problem *problem, bool timed, struct row_run *run);

/* Returns true for DOM_OK. For other statuses, reports why a computation about the row failed. */
bool row_status(const struct query *query, struct problem *problem, enum dom_status status);

/* In a row without a push, the first domino is tilted until it tips over. Returns true if domino k, counted
 * from 0, is this domino. */
bool row_run_tipped(const struct row_run *run, size_t k);

/* Returns a phrase such as "All 8 fall", "Both fall" or "It falls". */
struct words all_fall_words(size_t count);

/* Returns kinetic / barrier, or NaN if the barrier is not a positive finite number. */
domq_real fall_share(const struct domq_fall *fall);

/* Prints which domino has the least energy to spare, if this is known; with as_detail, among the details. */
void weakest_say(struct answer *answer, const struct domq_verdict *verdict, bool as_detail);

/* The number of the effect 'floor'. */
extern int floor_number;

/* Lists the dominoes of the row as 'row' does: all, or only one, counted from 1, if `only` is not 0. */
bool row_list(const struct query *query, size_t only, struct answer *a, struct problem *problem);

/* ---- The windows of a row: how inaccurate each domino may be before the row stops ---- */

enum { WINDOW_KINDS = DOM_WINDOW_THICKNESS + 1 };

struct windows {
    const struct scene_row *scene;
    size_t count; /* the number of dominoes */
    /* An array of windows for each kind of window. For example, kind[DOM_WINDOW_HEIGHT][2] is the window of
     * the height of the third domino. All dominoes have the same friction, so there is only one window for
     * it: kind[DOM_WINDOW_FRICTION][0]. */
    struct dom_window *kind[WINDOW_KINDS];
    /* For each kind, the number of a domino, counted from 1, or 0. If the row falls, it has the tightest
     * limits of all dominoes. If the row does not fall, it needs the smallest change to save the row. */
    size_t critical[WINDOW_KINDS];
    bool falls;
};

/* A callback of type dom_progress, which calls progress_show with done / of. */
void progress_count(size_t done, size_t of, void *context);

/* Finds all windows of the row, in parallel. Even after a failure, the caller frees w->kind[0],
 * which holds all windows. */
enum dom_status windows_find(const struct query *query, const struct scene_row *scene, struct windows *w);

/* ---- Rows in files (rowfile.c) ---- */

/*
 * A csv file that describes a measured row of dominoes looks like this:
 *
 *     # the hall, first try
 *     height (mm), thickness (mm), gap (mm), mass (g)
 *     48, 7.5, -, 10
 *     5.2 cm, 52/6, 22, 12.5
 *
 * - A column "pitch" or "position" may take the place of "gap". The pitch is the distance from the front face
 * of the domino before to the front face of this domino, so the gap is the pitch minus this domino's
 * thickness. The position is that of the front face, measured from anywhere in the direction of the fall. The
 * front face is the one in this direction.
 * - If there is no column "width", 'set width' gives the width. Until scene_row_fill sets it, it is 0, and
 *   the mass is that of a domino which is half as wide as it is tall.
 * - If there is no column "mass", the mass of a domino is density * height * thickness * width. In a box,
 *   only the walls count.
 * - If there is no column "density" either, the column "relative" may give the ratios of the masses. If it is
 *   missing, too, all dominoes have the density 1.
 * - A lean is the distance of the top from plumb. If a domino leans backwards, its lean is negative.
 * - The column "domino" is ignored. Unknown columns are ignored, too.
 */
/* The columns of the file. The first columns are the measurements of enum row_measure, in the same order. */
extern const struct csv_kind rowfile_kind;

/* Checks the measurements of a domino. They must fit together, and the lean must not make the domino fall
 * over by itself on a slope of `slope` radians. If a measurement is wrong, writes a message and returns the
 * measurement. Otherwise returns ROW_MEASURES. */
enum { MISFIT_MESSAGE = LEAN_MESSAGE };
enum row_measure domino_misfit(const struct domq_domino *domino, domq_real slope,
                               char message[MISFIT_MESSAGE]);

/* Reads all dominoes of a table. On failure, stores the problem in the table and returns NULL. */
struct row_file *rowfile_read(struct csv_table *csv, domq_real slope);

/* A row that owned the file no longer does. The last owner frees it. */
void rowfile_drop(struct row_file *file);

/* A names_list (see names.h) of the measurements that can change. */
const char *row_measure_names(const void *context, int k);

/* ---- Changes of a row (change.c) ---- */

/* A range of consecutive dominoes, counted from 1. */
struct row_range {
    size_t first, last;
};

/* A change, and the dominoes that it changes. */
struct row_change {
    enum row_measure measure;
    enum { CHANGE_TO, CHANGE_BY, CHANGE_TIMES } how; /* replace the measurement, add to it, or multiply it */
    domq_real value; /* a new value or a difference, in m or kg; or a factor */
    bool is_angle;   /* the value is a lean angle in rad, not the distance of the top from plumb */
    int ranges;      /* the number of ranges; 0 selects all dominoes */
    struct row_range range[];
};

/* Gives all dominoes of the row the gaps, heights, thicknesses and radii of the `count` dominoes in `to`, and
 * if `sizes` is true also their widths and the ratios of their masses. On failure, sets *problem and returns
 * false; the row may have changed. */
bool scene_row_set(struct scene *scene, const struct domq_domino *to, size_t count, bool sizes,
                   struct problem *problem);
