/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The benchmark: what a question costs this library and other programs, how near that is to the floor, and
 * how it grows. Everything is measured in one run, in turns, and the smallest of several times counts, so
 * that other work of the machine affects all in the same way.
 */
#ifndef BENCH_H
#define BENCH_H

#include "../unit/ask.h"
#include <stdio.h>
#include <sys/types.h>

/* Marks a value that does not exist. */
#define NONE ((double)NAN)

/* ---- measure.c: clocks, numbers and processes ---- */

double seconds_now(void);
unsigned cores(void);

/* Prints a blank and the number, or '-' for NONE. */
void number_print(int width, int digits, double value);

/* A whole process with its input from a string; its output is discarded. */
struct process {
    bool done; /* the process ran and ended with status 0 */
    double seconds;
    double work;      /* the processor's seconds */
    double megabytes; /* the most memory that the process held */
};

struct process process_run(const char *const *argv, const char *input);

/* A process that answers questions line by line. */
struct coprocess {
    pid_t pid;
    FILE *to, *from;
};

bool coprocess_start(struct coprocess *process, const char *const *argv);
/* Asks a question. The process reports how long the answer took, without the communication. */
bool coprocess_ask(struct coprocess *process, const char *question, double *seconds, double *value);
void coprocess_end(struct coprocess *process);

/* ---- compare.c: questions and contenders ---- */

enum task { RMAX, DURATION, ROW };

struct question {
    enum task task;
    struct asked train; /* of ROW the ratios */
    size_t dominoes;    /* of ROW */
    double push;        /* of ROW, rad/s */
};

enum contender { OURS, GSL, PAPER, NEWTON, SCIPY, CONTENDERS };

/* Starts SciPy, or prints that it is missing. */
void contenders_start(void);
void contenders_end(void);

struct result {
    bool asked;
    /* the largest tolerance with which the error is reached; for ours the target itself */
    double tol;
    double seconds;         /* mean time of one question */
    double error;           /* the largest relative error of the questions that are not missed */
    size_t missed;          /* number of questions whose error is above the target at any tolerance */
    double worst, missed_s; /* the largest error of those, and its separation */
};

/*
 * Asks the contenders in `contender`, a set of 1 << enum contender, the same n questions to the same relative
 * error, measured against our answers in quad precision; prints a table. `scale` questions count as one in
 * the table.
 */
void compare(const char *title, const struct question *question, size_t n, double target, unsigned contender,
             double scale, struct result result[CONTENDERS]);

/* Returns one answer of ours; NaN if there is none. */
domq_real ask_ours(const struct question *question, double tol, enum dom_precision precision,
                   struct dom_work *work);

/* Returns the least time in which a contender answers one question at this tolerance; NaN if it does not. */
double contender_seconds(enum contender contender, const struct question *question, double tol);

/* Writes questions for separations lo ... hi with q = 3 and, after them, q = 4; n in all, an even number. */
void rmax_questions(struct question *question, size_t n, double lo, double hi);

/* ---- curve.c: on one core and on several ---- */

/* Returns the seconds that the library needs for a curve of `points`, solid dominoes, s from 0.02 to 0.9. */
double curve_library(size_t points, unsigned threads);

/*
 * That curve on n different numbers of threads, the smallest of several times; and how many times the work of
 * one thread the machine does on that many threads that only multiply, since virtual cores may be less than
 * they seem.
 */
struct threaded {
    double seconds, given;
};

/* A dom_parallel: the pool is an unsigned, the number of threads. */
enum dom_status threads_tasks(size_t count, dom_task *task, void *context, void *pool);

void threads_measure(size_t points, const unsigned *threads, struct threaded *threaded, unsigned n);

/* ---- rows.c, record.c, start.c, lines.c ---- */

/* Prints rows per second. Returns the seconds of a row with r = 1.3 on one core, and of one with friction. */
struct rows_goals {
    double plain, friction;
};

struct rows_goals rows_print(void);

/*
 * Prints times of a budget and of a placement of examples/record.dom, and the memory of 100,000 dominoes.
 * Returns the seconds and the megabytes. A process counts the memory of the one that started it, too: call
 * this before the benchmark itself needs much.
 */
struct record_goals {
    double budget, placement, megabytes;
};

struct record_goals record_print(const char *domino);

/* Prints times of many lines. Returns ours over those of bc, and over those of the library alone. */
struct lines_goals {
    double print, rmax;
};

struct lines_goals lines_print(const char *build, const char *domino);

/* Prints start-up times. Returns ours over that of bc; NaN without bc. */
double start_print(const char *domino);

/* ---- floor.c ---- */

/* Nanoseconds a domino of the bare recurrence: for one train after the other, and for four together. */
struct recurrence {
    double one, four;
};

struct recurrence recurrence_measure(void);

/* Prints operations (unless NULL), passes and the floor next to the time of one of n answers. */
void floor_print(const char *title, const struct question *question, size_t n, double seconds,
                 const char *operations);

/*
 * Prints where the time of each main answer goes, by the script `shares`.
 */
void shares_print(const char *build);

/* ---- front.c, lengths.c ---- */

/* Prints front speeds beside those of the recipe of a published program. */
void front_print(void);

/*
 * Prints how the time of a row grows with its dominoes, and that of a study with its rows. Returns the
 * seconds of a row of 10,000.
 */
double lengths_print(void);

/* ---- growth.c ---- */

/* Prints tables of the growth of time with work, and writes a picture into the folder `build`. */
void growth_print(const char *build);

#endif
