/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The benchmark: what a question costs us and others, how near that is to the floor, and how it grows.
 * Everything is measured in one run, in turns, and the least of several times counts, so that whatever else
 * the machine does hits all alike.
 */
#ifndef BENCH_H
#define BENCH_H

#include "../unit/ask.h"
#include <stdio.h>
#include <sys/types.h>

/* What is not there. */
#define NONE ((double)NAN)

/* ---- measure.c: clocks, numbers and processes ---- */

double seconds_now(void);
unsigned cores(void);

/* A blank and the number, '-' where there is none. */
void number_print(int width, int digits, double value);

/* A whole process, its input from a string, its output thrown away. */
struct process {
    bool done; /* it ran and ended with status 0 */
    double seconds;
    double megabytes; /* the most memory that it held */
};

struct process process_run(const char *const *argv, const char *input);

/* A process that is asked line by line. */
struct coprocess {
    pid_t pid;
    FILE *to, *from;
};

bool coprocess_start(struct coprocess *process, const char *const *argv);
/* It tells how long it took to answer, without the way there and back. */
bool coprocess_ask(struct coprocess *process, const char *question, double *seconds, double *value);
void coprocess_end(struct coprocess *process);

/* ---- compare.c: questions and who answers them ---- */

enum task { RMAX, DURATION, ROW };

struct question {
    enum task task;
    struct asked train; /* of ROW the ratios */
    size_t dominoes;    /* of ROW */
    double push;        /* of ROW, rad/s */
};

enum who { OURS, GSL, PAPER, NEWTON, OCTAVE, SCIPY, CONTENDERS };

extern const char *const who_name[CONTENDERS];

/* Those that are programs of their own are started; says who is missing. */
void contenders_start(void);
void contenders_end(void);

struct result {
    bool asked;
    double tol;             /* the loosest with which the error is reached; ours is the target itself */
    double seconds;         /* of one question, the mean over them */
    double error;           /* the worst relative one, of the questions that are not missed */
    size_t missed;          /* questions whose error is above the target at any tolerance */
    double worst, missed_s; /* the worst error of those, and where */
};

/*
 * Asks `who`, as a set of 1 << enum who, the same n questions to the same relative error, against our
 * answers in quad precision; prints a table.  `scale` questions make one of what the table counts.
 */
void compare(const char *title, const struct question *question, size_t n, double target, unsigned who,
             double scale, struct result result[CONTENDERS]);

/* One answer of ours; NaN if there is none. */
domq_real ask_ours(const struct question *question, double tol, enum dom_precision precision,
                   struct dom_work *work);

/* Separations lo ... hi for q = 3 and, after them, q = 4; n in all, an even number. */
void rmax_questions(struct question *question, size_t n, double lo, double hi);

/* ---- curve.c: on one core and on several ---- */

/* Seconds of a curve of points by the library, massive, from 0.02 to 0.9. */
double curve_library(size_t points, unsigned threads);

/*
 * That curve on each of n numbers of threads, the least of several; and how many times the work of one thread
 * the machine does on so many, when they do nothing but multiply: virtual cores may be less than they seem.
 */
struct threaded {
    double seconds, given;
};

/* A dom_parallel: the pool is an unsigned, the number of threads. */
enum dom_status threads_tasks(size_t count, dom_task *task, void *context, void *pool);

void threads_measure(size_t points, const unsigned *threads, struct threaded *threaded, unsigned n);

/* ---- rows.c, start.c ---- */

void rows_print(void);

/* How many times bc's our start-up is; NaN without bc. */
double start_print(const char *domino);

/* ---- floor.c ---- */

/* ns a domino of the bare recurrence, one train after the other, and four side by side. */
struct recurrence {
    double one, four;
};

struct recurrence recurrence_measure(void);

/* Prints operations (unless NULL), passes and the floor beside the time of one of n answers. */
void floor_print(const char *title, const struct question *question, size_t n, double seconds,
                 const char *operations);

/* ---- growth.c ---- */

/* Tables of the growth of time with work, and a picture in the folder `build`. */
void growth_print(const char *build);

#endif
