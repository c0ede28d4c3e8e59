/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files about planning give each other and the table of their commands. */
#ifndef SHELL_PLANNING_H
#define SHELL_PLANNING_H

#include "interpreter/question.h"

/* ---- An answer along a parameter ---- */

/* A question that is asked again and again, in copies of the state with other values of one parameter. */
struct probe {
    const struct query *query;
    const char *command; /* the name of the command that asks, for problems */
    const struct question *question;
    const struct parameter *parameter; /* NULL if nothing is changed */
    bool verdict;                      /* the answer is the verdict of the command: 1 if true, or -1 */
    struct problem problem;            /* why the last question had no answer */
    bool wrong;                        /* the question is wrong, whatever the value of the parameter */
    struct quantity unit;              /* of the last answer */
};

/* Returns the answer at a value of the parameter, or NaN with probe->problem. */
domq_real probe_at(struct probe *probe, domq_real value);

/* Describes why the last question had no answer. Returns false. */
bool probe_report(const struct probe *probe, struct problem *problem);

/* What 'solve' and 'watch' are given. */
struct solve {
    const struct parameter *parameter;
    domq_real from, to;
    const struct question *question;
    bool verdict;          /* no value is given: 'solve' finds where the verdict changes */
    struct quantity value; /* the value that the answer is to take */
};

enum { ROOTS_MOST = 64, SCAN_POINTS = 241 };

/* What a scan has found of an answer along a parameter. */
struct scan {
    struct probe probe;
    const struct solve *solve;
    struct root {
        domq_real x, answer;
        const char *branch; /* how the answer changes there */
    } root[ROOTS_MOST];     /* in the order of x */
    int roots;
    domq_real jump; /* where the answer passes the value without taking it */
    struct point {
        domq_real x, f;                /* f: the answer less the value; NaN if there is no answer */
    } most, least, point[SCAN_POINTS]; /* the extrema are those of all points with an answer */
    size_t answers;
    char no_answer[PROBLEM_TEXT / 2]; /* why the first point without an answer has none */
};

/* Scans the whole range. Returns false if the question is wrong, or after an interrupt: see scan->probe. */
bool scan_run(struct scan *scan);

/* ---- What a builder wishes of a design ---- */

struct wishes {
    domq_real safety, hall;
    enum dom_least least;
};
extern const struct wishes usual_wishes;

/* ---- For the table of the commands ---- */

extern const struct column design_columns[], solve_columns[], sensitivity_columns[], fit_columns[];
bool run_design(const struct query *query, struct answer *a, struct problem *problem);
bool run_solve(const struct query *query, struct answer *a, struct problem *problem);
bool run_sensitivity(const struct query *query, struct answer *a, struct problem *problem);
bool run_fit(const struct query *query, struct answer *a, struct problem *problem);
bool run_assert(const struct query *query, struct answer *a, struct problem *problem);
bool run_watch(struct session *session, const struct arguments *given, struct answer *a,
               struct problem *problem);

/* Parse and bind arguments. */
bool wishes_parse(struct reader *reader, struct question *question);
bool wishes_bind(const struct question *question, const struct query *query, struct arguments *given,
                 struct problem *problem);
bool solve_parse_parameter(struct reader *reader, struct question *question);
bool solve_parse_answer(struct reader *reader, struct question *question);
bool watch_parse_answer(struct reader *reader, struct question *question);
bool solve_bind(const struct question *question, const struct query *query, struct arguments *given,
                struct problem *problem);
bool sensitivity_parse(struct reader *reader, struct question *question);
bool assert_parse(struct reader *reader, struct question *question);

/* List for names.h: wishes, the parameters of 'solve' and 'watch', what 'fit' finds, and the commands with a
 * verdict. */
const char *wish_names(const void *context, int k);
const char *solve_names(const void *context, int k);
const char *fit_names(const void *context, int k);
const char *assert_names(const void *context, int k);

#endif
