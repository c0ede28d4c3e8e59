/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The command 'fit', which finds the parameter values that best explain the measurements. The measurements
 * come from a csv file (see tables/csv.h) of one of these kinds:
 *
 *     gap (mm), speed (m/s)          the speed of the front in a row of equal dominoes
 *     gap (mm), dominoes, time (s)   how long a row of equal dominoes takes to fall
 *     domino, time (s)               when each domino of a row is hit, as a camera shows it
 *     time (s)                       when dominoes are hit, as a microphone hears some of them
 *
 * fit_data.c reads the file and numbers the hits of a sound, fit_solve.c finds the smallest sum of squares,
 * and fit_answer.c writes the answer.
 */
#pragma once

#include "interpreter/question.h"
#include "rows/rows.h"

enum { FIT_UNKNOWNS = 4 };

enum fit_kind { FIT_SPEEDS, FIT_HITS, FIT_TOTALS };

/* One measurement, in SI units. */
struct fit_point {
    size_t run; /* index of the run to which the measurement belongs */
    double gap; /* for a speed or a total time: the gap of the row */
    /* for a hit: the number of the domino, or 0 until it is known; for a total time: how many dominoes the
     * row has */
    size_t domino;
    long line;       /* the line of the file */
    double measured; /* a speed, or a time; the time of a hit is on the clock of its run */
    double error;    /* the standard error of `measured`, or NaN if it is not known */
};

/* The hits of one run. Each run has its own clock, with an unknown start. A file of speeds or of total times
 * counts as a single run. */
struct fit_run {
    double number; /* the number of the run in the file */
    double gap;    /* the gap of the row in this run, or NaN to use the gaps of the scene */
    size_t first, count;
};

struct fit_data {
    enum fit_kind kind;
    struct fit_point *point;
    struct fit_run *run;
    size_t points, runs;
    bool has_errors; /* true if the errors of all measurements are known */
    bool has_pitch;  /* true if the file has pitches instead of gaps */
    /* The spread of repeated measurements: the root mean square of their deviations, divided by their means,
     * or 0 if there are none. */
    double spread;
    /* for hits: true to compare the intervals between successive hits instead of the times of hits */
    bool intervals;
};

/* Returns true if each line of the file is about another row, and false if the times of a run share a clock.
 */
static inline bool fit_has_rows(const struct fit_data *data)
{
    return data->kind != FIT_HITS;
}

/* An unknown parameter, and what the fit finds out about it. */
struct fit_unknown {
    const struct parameter *parameter;
    double value, deviation; /* the best value, and its standard deviation */
    bool is_at_limit;        /* true if `value` is a limit of its range; `deviation` is then NaN */
};

struct fit {
    const struct query *query;
    struct fit_data data;
    struct fit_unknown unknown[FIT_UNKNOWNS];
    int unknowns;
    int free[FIT_UNKNOWNS]; /* the indices of the unknowns that are not at a limit */
    size_t free_count;
    /* For j < i, correlation[j][i] is the correlation between unknowns j and i, or NaN if one is at a limit.
     */
    double correlation[FIT_UNKNOWNS][FIT_UNKNOWNS];
    double reduced_chi_squared; /* the sum of (residual / error)^2, divided by the degrees of freedom */
    size_t freedom;             /* the number of residuals minus the number of fitted values */
    double *computed;       /* the model's result for each measurement, at the best values of the unknowns */
    struct problem problem; /* why the last computation gave no answer */
};

static inline bool fit_is_first(const struct fit *fit, size_t k)
{
    return k == fit->data.run[fit->data.point[k].run].first;
}

/* Runs the row of a run of hits: that of the session or, if it has none, one as long as the run, up to domino
 * `dominoes`. The unknowns have the values `value` or, if it is NULL, those of the session. Call row_run_free
 * afterwards. On failure, sets fit->problem, and nothing needs to be freed. */
bool fit_row(struct fit *fit, const double *value, const struct fit_run *run, size_t dominoes,
             struct row_run *row);

/* Reports that a measured domino, as `what` says, is beyond the end of the row, or of its fall. Returns
 * false. */
bool fit_ends(struct problem *problem, const char *what, const struct domq_verdict *verdict);

/* Reads the measurements, whose arrays the caller frees, even after a failure. `rate` is in frames per
 * second, or NaN if it is not known. */
bool fit_read(const struct query *query, const char *name, double rate, struct fit_data *data,
              struct problem *problem);

/* Numbers the dominoes of all hits that have no number. A recording has the times of hits, but not the
 * dominoes, and may lack some hits. */
bool fit_number(struct fit *fit, struct problem *problem);

/* Finds the values of the unknowns for which the sum of squares is smallest. Also finds their standard
 * deviations and correlations. */
bool fit_solve(struct fit *fit, struct problem *problem);
