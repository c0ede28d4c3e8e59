/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The benchmark measures how long this library and other programs take for a question, compares these times
 * with a lower bound, and shows how they grow. Everything is measured in one run, the contenders take turns,
 * and the shortest of several times counts. So other work of the machine affects all contenders alike.
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

/* Prints a blank and a number in `width` columns, or '-' for NONE. */
void number_print(int width, int digits, double value);

/* The result of a process that reads its input from a string, and whose output is discarded. */
struct process {
    bool done; /* true if the process has run and ended with status 0 */
    double seconds;
    double work;      /* processor time in s */
    double megabytes; /* the largest memory of the process */
};

struct process process_run(const char *const *argv, const char *input);

/* A process that answers questions line by line. */
struct coprocess {
    pid_t pid;
    FILE *to, *from;
};

bool coprocess_start(struct coprocess *process, const char *const *argv);
/* Asks a question. The process reports how long it took to answer, not counting the communication. */
bool coprocess_ask(struct coprocess *process, const char *question, double *seconds, double *value);
void coprocess_end(struct coprocess *process);

/* ---- compare.c: questions and contenders ---- */

enum task { RMAX, DURATION, ROW };

struct question {
    enum task task;
    struct setup train; /* the train; for ROW, the ratios of the row's dominoes */
    size_t dominoes;    /* only for ROW: their number */
    double push;        /* only for ROW: the push in rad/s */
};

enum contender { OURS, GSL, PAPER, NEWTON, SCIPY, CONTENDERS };

/* Starts SciPy, or prints that it is missing. */
void contenders_start(void);
void contenders_end(void);

struct result {
    bool compared;
    /* The largest tolerance with which a contender reaches the target or, if it never does, misses the fewest
     * questions. For our own library, the target itself. */
    double tol;
    double seconds; /* mean time of one question */
    double error;   /* the largest relative error that is within the target */
    size_t missed;  /* number of questions whose error is above the target with `tol` */
    /* the largest error of the missed questions, and the separation for which it occurs */
    double worst, missed_s;
};

/*
 * Asks some contenders the same n questions, with the same target for the relative error, and prints a table.
 * `contender` is a set of bits 1 << enum contender. Errors are measured against our answers in quad
 * precision. The table gives the time of `scale` questions.
 */
void compare(const char *title, const struct question *question, size_t n, double target, unsigned contender,
             double scale, struct result result[CONTENDERS]);

/* Returns an answer of our own library, or NaN if there is none. */
domq_real ask_ours(const struct question *question, double tol, enum precision precision,
                   struct dom_work *work);

/* Returns the shortest time in which a contender answers one question with this tolerance, or NaN if it has
 * no answer. */
double contender_seconds(enum contender contender, const struct question *question, double tol);

/* Writes n questions, an even number, for separations from lo to hi: first with q = 3, and then with q =
 * 4. */
void rmax_questions(struct question *question, size_t n, double lo, double hi);

/* ---- curve.c: on one core and on several ---- */

/* Returns the seconds that the library takes for a curve with this many points, of solid dominoes with s from
 * 0.02 to 0.9. */
double curve_library(size_t points, unsigned threads);

/*
 * The shortest of several times for this curve on some number of threads. `given` is the speed-up that the
 * machine allows: the speed-up of a loop of multiplications on as many threads. It may be less than the
 * number of threads, because a virtual core may be less than a real one.
 */
struct threaded {
    double seconds, given;
};

/* A dom_parallel. The pool points to an unsigned, the number of threads. */
enum dom_status threads_tasks(size_t count, dom_task *task, void *context, void *pool);

void threads_measure(size_t points, const unsigned *threads, struct threaded *threaded, unsigned n);

/* ---- waits.c ---- */

/* A line of the table at the end. Numbers that do not exist are NONE. */
struct goal {
    const char *text, *unit;
    double first; /* measured before the goal was set, on another machine */
    double goal, measured;
    bool at_least;      /* the goal is a lower bound */
    const char *reason; /* why the goal may be missed; printed if it is missed; may be NULL */
};

/* Measures the questions for which people have to wait. Writes at most WAITS_MOST goals and returns their
 * number. Call this function before the benchmark itself takes much memory: the system counts it as memory of
 * the processes that the benchmark starts. */
enum { WAITS_MOST = 24 };
size_t waits_measure(const char *build, struct goal *goal);

/* ---- rows.c, start.c, lines.c ---- */

/* Prints rows per second. Returns the seconds for a row with r = 1.3 on one core, without friction and with
 * friction. */
struct rows_goals {
    double plain, friction;
};

struct rows_goals rows_print(void);

/* Prints the times for many lines. Returns our time for 'print' divided by the time of bc, and our time for
 * 'rmax' divided by the time of the library alone. */
struct lines_goals {
    double print, rmax;
};

struct lines_goals lines_print(const char *build, const char *domino);

/* Prints start-up times. Returns our time divided by the time of bc, or NaN if bc is missing. */
double start_print(const char *domino);

/* ---- floor.c ---- */

/* The time of the bare recurrence in nanoseconds per domino, for one train at a time and for four trains at a
 * time. */
struct recurrence {
    double one, four;
};

struct recurrence recurrence_measure(void);

/* Prints the mean time of n answers in seconds next to its lower bound, with the numbers of passes and
 * dominoes. `operations` describes what the processor executes for a domino, and may be NULL. */
void floor_print(const char *title, const struct question *question, size_t n, double seconds,
                 const char *operations);

/* Prints the times of r_max with sharp and with rounded edges, and their ratio. Also prints what this ratio
 * would be if the two searches visited the same number of dominoes. */
void floor_print_edges(const struct question *sharp, double sharp_seconds, const struct question *rounded,
                       double rounded_seconds);

/* Runs the script `shares`, which prints where the time of each main answer goes. */
void shares_print(const char *build);

/* ---- front.c, lengths.c ---- */

/* Prints our front speeds next to the speeds by the method of a published program. */
void front_print(void);

/* Prints how the time for a row grows with the number of dominoes. Returns the seconds for a row of 10,000
 * dominoes. */
double lengths_print(void);

/* ---- growth.c ---- */

/* Prints tables that show how time grows with the work and writes a picture into the folder `build`. */
void growth_print(const char *build);

#endif
