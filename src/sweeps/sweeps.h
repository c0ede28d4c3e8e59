/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Types and functions that 'solve', 'sensitivity', 'assert' and 'watch' share, and the commands themselves.
 */
#ifndef SHELL_SWEEPS_H
#define SHELL_SWEEPS_H

#include "interpreter/question.h"

/* ---- An answer along a parameter ---- */

/* A question that is evaluated many times, each time with a different value of one parameter. */
struct probe {
    const struct query *query;
    const char *command; /* the name of the command that uses the probe, for messages */
    const struct question *question;
    const struct parameter *parameter; /* the parameter that is changed, or NULL */
    bool verdict;           /* true if the answer is a verdict, which is stored as 1 for yes and -1 for no */
    bool seeks_yes;         /* see struct run_context */
    struct problem problem; /* why the last evaluation gave no answer */
    bool wrong;             /* true if the question itself is wrong, so that it fails at every value */
    struct quantity unit;   /* the unit of the last answer, and its text */
    char unit_text[UNIT_TEXT];
};

/* Returns the answer for these values of parameters. If there is no answer, returns NaN and sets
 * probe->problem. */
domq_real probe_ask(struct probe *probe, const struct assigned *assigned, int count);

/* Returns the answer for this value of the parameter. If there is no answer, returns NaN and sets
 * probe->problem. */
domq_real probe_at(struct probe *probe, domq_real value);

/* Reports in *problem why the last evaluation gave no answer, or that it was interrupted. Returns false. */
bool probe_report(const struct probe *probe, struct problem *problem);

/* A parameter, or "NAME FROM TO" with its range; the words 'from' and 'to' may stand before the values. */
struct ranged {
    const struct parameter *parameter;
    domq_real from, to;
};
struct ranged_parsed {
    const struct parameter *parameter;
    struct item from, to; /* zero if they were not typed */
};

/* Parses a parameter with its range up to a ':' or ','. ranges_end checks that the ':' is next, and
 * colon_pass skips it and checks that something follows. */
bool ranged_parse(struct reader *reader, names_list *names, struct ranged_parsed *parsed);
bool ranges_end(const struct reader *reader);
bool colon_pass(struct reader *reader);
bool ranged_bind(const struct ranged_parsed *parsed, const struct text *text, const struct query *query,
                 struct ranged *range, struct problem *problem);

/* The arguments of 'solve' and 'watch'. */
struct solve {
    const struct parameter *parameter;
    domq_real from, to;
    const struct question *question;
    bool verdict;          /* true to search for changes of a verdict, not for a value */
    struct quantity value; /* the value that the answer should have */
};

enum { ROOTS_MOST = 64, SCAN_POINTS = 241 };

/* A search for the values x of a parameter at which an answer is equal to a given value. */
struct scan {
    struct probe probe;
    const struct solve *solve;
    struct root {
        domq_real x, answer;
        /* "rising" or "falling"; for a verdict, "true up to here" or "true from here on" */
        const char *branch;
    } root[ROOTS_MOST]; /* the roots found so far; at the end they are sorted by x */
    int roots;
    domq_real jump; /* an x at which the answer jumps past the given value */
    struct scan_point {
        domq_real x, f;                /* f is the answer minus the value, or NaN if there is no answer */
    } most, least, point[SCAN_POINTS]; /* the highest and the lowest point, and the points of the grid */
    size_t answers;                    /* the number of points with an answer */
    char no_answer[PROBLEM_TEXT / 2];  /* the reason for the first missing answer */
};

/* Searches the whole range. Returns false after an error or an interrupt; then call probe_report. */
bool scan_run(struct scan *scan);

/* ---- The commands ---- */

extern const struct column solve_columns[], sensitivity_columns[], optimum_columns[];
bool run_solve(const struct query *query, struct answer *a, struct problem *problem);
bool run_sensitivity(const struct query *query, struct answer *a, struct problem *problem);
bool run_optimum(const struct query *query, struct answer *a, struct problem *problem);
bool run_assert(const struct query *query, struct answer *a, struct problem *problem);

bool solve_parse_parameter(struct reader *reader, struct question *question);
bool solve_parse_answer(struct reader *reader, struct question *question);
bool watch_parse_answer(struct reader *reader, struct question *question);
bool solve_bind(const struct question *question, const struct query *query, struct arguments *given,
                struct problem *problem);
bool sensitivity_parse(struct reader *reader, struct question *question);
bool assert_parse(struct reader *reader, struct question *question);
bool maximize_parse(struct reader *reader, struct question *question);
bool minimize_parse(struct reader *reader, struct question *question);
bool optimum_parse_answer(struct reader *reader, struct question *question);
bool optimum_bind(const struct question *question, const struct query *query, struct arguments *given,
                  struct problem *problem);

/* names_lists (see names.h) */
const char *solve_names(const void *context, int k);   /* the parameters that 'solve' and 'watch' change */
const char *assert_names(const void *context, int k);  /* the commands with a verdict */
const char *optimum_names(const void *context, int k); /* the parameters of 'maximize' and 'minimize' */

#endif
