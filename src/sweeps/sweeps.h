/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the commands of this feature share: answers at many points of the parameters. */
#pragma once

#include "interpreter/question.h"
#include "train/train.h"

/* ---- Questions inside other commands (question.c) ---- */

/* Parses a question inside another command, such as 'sweep'. The question can be a command, a command with
 * the key of a column, such as "rmax.r", or an expression, which stands for 'print'. The answer must be one
 * number. If `is_number` is false, it may also be yes or no. Completion offers the names in `offered`. */
bool question_parse_any(struct reader *reader, struct question *question, bool is_number,
                        names_list *offered);

/* A names_list of the commands that completion offers for question_parse_any. */
const char *question_names(const void *context, int k);

/* Returns a copy of the text from `begin` to `end` without trailing blanks, shortened and escaped. */
const char *question_name(struct reader *reader, const char *begin, const char *end);

/* Binds a question and runs its command. */
bool question_ask(const struct question *question, const struct query *query, struct answer *answer,
                  struct problem *problem);

/* Binds a question and computes its value, which is one number in SI units. For a command, this number is
 * the cell in column question->key of the answer. For 'print', it is the value of the expression. Also stores
 * the unit of the number, as text for the head of a column. */
bool question_measure(const struct question *question, const struct query *query, struct quantity *value,
                      char unit[UNIT_TEXT], struct problem *problem);

/* Returns true if the answer to the question is one number. Otherwise reports a problem that lists the keys
 * from which the user can choose. */
bool question_needs_number(const struct question *question, struct problem *problem);

/* ---- An answer along a parameter ---- */

/* A question that is evaluated many times, each time with other values of parameters. */
struct probe {
    const struct query *query;
    const char *command; /* the name of the command that uses the probe, for messages */
    const struct question *question;
    const struct parameter *parameter; /* the parameter that probe_at changes, or NULL */
    bool verdict;           /* true if the answer is a verdict, which is stored as 1 for yes and -1 for no */
    bool seeks_yes;         /* see struct run_context */
    struct problem problem; /* why the last evaluation gave no answer */
    bool wrong;             /* true if the question itself is wrong, so that it fails at every value */
    struct quantity unit;   /* the unit of the last answer, and its text */
    char unit_text[UNIT_TEXT];
};

/* Returns the answer for these values of parameters, or for this value of the probe's parameter. If there is
 * no answer, returns NaN and sets probe->problem. */
domq_real probe_ask(struct probe *probe, const struct assigned *assigned, int count);
domq_real probe_at(struct probe *probe, domq_real value);

/* Reports in *problem why the last evaluation gave no answer, or that it was interrupted. Returns false. */
bool probe_report(const struct probe *probe, struct problem *problem);

/* ---- Grids: "s 0.1 0.9 81 q hollow, solid friction 0 0.5 6", and ranges: "s 0.1 0.9, r" ---- */

/* The values of one parameter, or of the first argument of one effect. */
struct axis {
    const struct parameter *parameter;
    size_t count; /* 0 for a range */
    domq_real from, to;
    bool logarithmic; /* true if neighbouring values have a constant ratio instead of a constant difference */
    const domq_real *list; /* the values of a list, or NULL */
};

struct grid {
    struct axis axis[ASSIGNED_MAX]; /* the value of the first axis changes slowest */
    int axes;
    size_t points; /* the product of the counts of all axes */
};

/* Returns value number k of an axis, counted from 0. */
domq_real axis_value(const struct axis *axis, size_t k);

struct cell axis_cell(const struct axis *axis, domq_real value);

/* The arguments of 'sweep', 'solve', 'watch', 'maximize' and 'minimize'. */
struct sweep {
    struct grid grid;
    const struct question *answer; /* what is evaluated at each point */
    size_t answers;                /* if there are several answers, each is one number and has one column */
    const char *typed;             /* the answers as they were typed */
    bool verdict;                  /* 'solve' searches for changes of a verdict, not for a value */
    struct quantity value;         /* the value that 'solve' seeks */
};

/* Parsers of the first argument: a grid, up to so many parameters with or without a range, or names alone. */
bool sweep_parse_grid(struct reader *reader, struct question *question);
bool range_parse_one(struct reader *reader, struct question *question);
bool range_parse_two(struct reader *reader, struct question *question);
bool range_parse_names(struct reader *reader, struct question *question, int most);
const char *varied_names(const void *context, int k); /* a names_list of what can have a range */

/* Parsers of the second argument: ": ANSWER, ANSWER ...", ": ANSWER", and ": ANSWER = VALUE" or, for a
 * verdict, ": COMMAND". */
bool sweep_parse_answers(struct reader *reader, struct question *question);
bool answer_parse_number(struct reader *reader, struct question *question);
bool answer_parse_value(struct reader *reader, struct question *question);

/* Binds all of them to a struct sweep. */
bool sweep_bind(const struct question *question, const struct query *query, struct arguments *given,
                struct problem *problem);
/* The argument N of 'curve FROM TO N', which is a sweep over s. */
bool curve_bind(const struct question *question, const struct query *query, struct arguments *given,
                struct problem *problem);

/* ---- Searches (search.c) ---- */

/* What 'solve', 'maximize' and 'minimize' share: an answer at evenly spaced values of a parameter, and
 * between them. */
enum { SEARCHED_MOST = 2, POINTS = 241, POINTS_OF_TWO = 41 /* along each of two parameters */ };

struct search;

/* The search along one parameter. */
struct line {
    struct search *search;
    int axis;
    double from, to, grain; /* the range, and how accurately a place is found */
    bool whole;             /* only whole numbers are places */
    size_t count;
    struct spot point[POINTS]; /* evenly spaced */
    double level;              /* for line_above */
};

struct search {
    const struct sweep *sweep;
    struct probe probe;
    double sign; /* minima are sought as maxima of the answer times -1 */
    struct line line[SEARCHED_MOST];
    double place[SEARCHED_MOST];
    domq_real answer; /* the last answer, with its own sign */
    /* The largest value at a place of the first of two parameters, along the second one. */
    double (*along)(struct line *second);
    struct problem fault;  /* the last error in the question itself; its kind is PROBLEM_NONE before */
    bool is_wrong[POINTS]; /* the question itself turned out to be wrong at this point */
    size_t missing;        /* the number of points along the first parameter without an answer */
    char reason[PROBLEM_TEXT / 2]; /* why the first of the missing answers is missing */
};

void search_begin(struct search *search, const struct sweep *sweep, struct probe probe, double sign);

/* Computes the answers at the points of the first parameter, in parallel. */
bool search_points(struct search *search, struct problem *problem);

/* Returns search->sign times the answer at search->place, minus the value that is sought, or NaN. */
double search_ask(struct search *search);

/* Functions of a place along a line, whose context is the line: the value, and its distance to line->level.
 */
double line_at(double x, void *line);
double line_above(double x, void *line);

/* Places the points of a line. */
void line_place(struct line *line);

/* Reports that the answer is the same everywhere. Returns false. */
bool search_constant(const struct search *search, domq_real answer, struct problem *problem);

/* Writes the ranges of the parameters, such as "s = 0.02 .. 1 and push = 0 .. 30 rad/s". Returns `text`. */
enum { RANGES_TEXT = 192 };
const char *search_ranges(const struct search *search, char text[RANGES_TEXT]);

/* ---- The commands ---- */

extern const struct column growths_columns[], solve_columns[], sensitivity_columns[], optimum_columns[];
bool run_sweep(const struct query *query, struct answer *a, struct problem *problem);
bool run_solve(const struct query *query, struct answer *a, struct problem *problem);
bool run_sensitivity(const struct query *query, struct answer *a, struct problem *problem);
bool run_maximize(const struct query *query, struct answer *a, struct problem *problem);
bool run_minimize(const struct query *query, struct answer *a, struct problem *problem);
bool run_assert(const struct query *query, struct answer *a, struct problem *problem);

bool sensitivity_parse(struct reader *reader, struct question *question);
bool assert_parse(struct reader *reader, struct question *question);
const char *assert_names(const void *context, int k); /* a names_list of the commands with a verdict */

/* The arguments of a command that varies parameters in a range, and asks for a number or a verdict. */
#define A_RANGE_AND_ANSWER(varied, parse_range, parse_answer)                                                \
    .argument = {{.name = (varied), .kind = ARGUMENT_GRID, .parse = (parse_range), .choices = varied_names}, \
                 {.name = ": ANSWER",                                                                        \
                  .kind = ARGUMENT_COMMAND,                                                                  \
                  .parse = (parse_answer),                                                                   \
                  .bind = sweep_bind,                                                                        \
                  .choices = question_names}}
