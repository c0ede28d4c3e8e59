/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files in this folder share, and what the table of the commands needs from them. */
#ifndef SHELL_PLANNING_H
#define SHELL_PLANNING_H

#include "interpreter/question.h"

/* ---- An answer along a parameter ---- */

/* A question that is asked many times, each time with another value of one parameter. */
struct probe {
    const struct query *query;
    const char *command; /* the name of the command that asks, for messages */
    const struct question *question;
    const struct parameter *parameter; /* NULL to ask with the state as it is */
    bool verdict;                      /* ask for the verdict of the command, which is 1 or -1 */
    struct problem problem;            /* why the last question had no answer */
    bool wrong;                        /* the question has an error that no value of the parameter avoids */
    struct quantity unit;              /* the unit of the last answer */
};

/* Returns the answer at a value of the parameter, or NaN with probe->problem. */
domq_real probe_at(struct probe *probe, domq_real value);

/* Describes why the last question had no answer. Returns false. */
bool probe_report(const struct probe *probe, struct problem *problem);

/* The arguments of 'solve' and 'watch'. */
struct solve {
    const struct parameter *parameter;
    domq_real from, to;
    const struct question *question;
    bool verdict;          /* there is no value: find where a verdict changes */
    struct quantity value; /* the value to solve for */
};

enum { ROOTS_MOST = 64, SCAN_POINTS = 241 };

/* A search for the values of a parameter at which an answer takes a value. */
struct scan {
    struct probe probe;
    const struct solve *solve;
    struct root {
        domq_real x, answer;
        const char *branch; /* "rising" or "falling", or where a verdict is true */
    } root[ROOTS_MOST];     /* sorted by x */
    int roots;
    domq_real jump; /* a place where the answer jumps over the value */
    struct point {
        domq_real x, f;                /* f is the answer minus the value, or NaN without an answer */
    } most, least, point[SCAN_POINTS]; /* the highest and lowest point found, and the points of the grid */
    size_t answers;                    /* the number of points with an answer */
    char no_answer[PROBLEM_TEXT / 2];  /* why the first point without an answer has none */
};

/* Searches the whole range. Returns false if probe_report has to describe a problem or an interrupt. */
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

/* List names for names.h: of wishes, of the parameters of 'solve' and 'watch', of what 'fit' can find, and of
 * the commands with a verdict. */
const char *wish_names(const void *context, int k);
const char *solve_names(const void *context, int k);
const char *fit_names(const void *context, int k);
const char *assert_names(const void *context, int k);

#endif
