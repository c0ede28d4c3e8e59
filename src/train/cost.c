/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'cost', which measures computing time. It uses a single thread: more threads would compete for
 * caches and memory, and lower the clock rate. */
#include "interpreter/command.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "train/train.h"

enum cost_of { COST_BARRIER, COST_DURATION, COST_RMAX, COST_PAIR };

static const struct {
    const char *name, *meaning;
} measured_answers[] = {
    [COST_BARRIER] = {"barrier", "the margin, kinetic energy minus barrier"},
    [COST_DURATION] = {"duration", "t_f / tau"},
    [COST_RMAX] = {"rmax", "r_max"},
    [COST_PAIR] = {"pair", "r_max of two dominoes"},
    {NULL, NULL},
};

/* The names of the quantities, as a names_list (see names.h). */
static const char *cost_names(const void *context, int k)
{
    (void)context;
    return measured_answers[k].name;
}

/* ---- Measuring ---- */

/* Who computes: the library in an enum precision, or the method of a feature, in double. */
enum { BY_METHOD = IN_QUAD + 1, CONTENDERS };

static const double tolerances[] = {1e-1,  1e-2,  1e-3,  1e-6,  1e-9,  1e-12, 1e-15,
                                    1e-18, 1e-21, 1e-24, 1e-27, 1e-30, 1e-33};
enum { TOLERANCES = sizeof tolerances / sizeof *tolerances };

struct cost_row {
    int by;
    double tol;
    enum dom_status status; /* if `status` is not DOM_OK, the members below are not set */
    domq_real error;        /* the relative error of the result, or that of the reference if it is larger */
    struct dom_work work;
    double seconds; /* the time that an answer takes: the shortest of up to seven measurements */
};

struct cost {
    const struct domq_train *train;
    const struct any_compute *compute;
    const struct method *method; /* NULL if no feature of this build has one */
    enum cost_of which;
    domq_real reference; /* the most accurate value */
    struct cost_row row[(int)CONTENDERS * (int)TOLERANCES];
    int rows;
};

static enum precision precision_of(int by)
{
    return by == BY_METHOD ? IN_DOUBLE : (enum precision)by;
}

/* Finds the quantity. A train that stops has a margin, too. */
static enum dom_status value_find(const struct cost *cost, int by, const struct any_compute *given,
                                  domq_real *value)
{
    struct any_compute compute = *given;
    struct domq_barrier barrier;
    struct domq_limit limit = {.ends = DOM_END_BARRIER};
    enum dom_status status = DOM_NO_METHOD;
    compute.precision = precision_of(by);
    if (by == BY_METHOD) {
        const struct dom_train train = train_in_double(cost->train);
        const struct dom_compute in_double = compute_in_double(given);
        struct dom_barrier its_barrier = {.margin = 0};
        struct dom_limit its_limit = {.r_max = 0};
        if (cost->which == COST_BARRIER)
            status = cost->method->barrier(&train, &in_double, &its_barrier);
        else if (cost->which == COST_RMAX)
            status = cost->method->rmax(&train, &in_double, &its_limit);
        *value = (domq_real)(its_barrier.margin + its_limit.r_max); /* one of them is 0 */
    } else if (cost->which == COST_DURATION) {
        return any_cycle_duration(cost->train, &compute, value);
    } else if (cost->which == COST_BARRIER) {
        status = any_barrier_find(cost->train, &compute, &barrier);
        *value = barrier.margin;
    } else {
        status = (cost->which == COST_RMAX ? any_limit_rmax : any_limit_pair)(cost->train, &compute, &limit);
        *value = limit.r_max;
    }
    return status == DOM_STOPS && cost->which == COST_BARRIER ? DOM_OK
           : status == DOM_OK && limit.ends == DOM_END_NONE   ? DOM_NO_GROWTH
                                                              : status;
}

/* Measures a value once, and then its time in batches: the fastest of up to seven. A slow value is timed only
 * once. */
static void row_measure(const struct cost *cost, struct cost_row *row)
{
    const double shortest = 2e-4; /* in s; the clock is too coarse for a shorter batch */
    const double slow = 0.1;      /* in s; a batch that takes longer is the last */
    const int batches = 7;
    struct any_compute compute = *cost->compute;
    domq_real value = 0;
    compute.tol = (domq_real)row->tol;
    compute.work = &row->work;
    row->status = value_find(cost, row->by, &compute, &value);
    const domq_real size = cost->reference == 0 ? 1 : quad(fabs)(cost->reference),
                    rounding = (domq_real)any_arithmetic(IN_QUAD).epsilon * size;
    row->error = quad_larger(quad(fabs)(value - cost->reference), rounding) / size;
    row->seconds = HUGE_VAL;
    compute.work = NULL;
    long repeats = 1;
    for (int batch = 0; batch < batches && row->status == DOM_OK;) {
        const double begun = terminal_clock();
        for (long i = 0; i < repeats && row->status == DOM_OK; i++)
            row->status = value_find(cost, row->by, &compute, &value);
        const double seconds = terminal_clock() - begun;
        if (seconds < shortest) {
            repeats *= 2;
            continue;
        }
        row->seconds = fmin(row->seconds, seconds / (double)repeats);
        batch += seconds > slow ? batches : 1;
    }
}

/* Measures one contender, with smaller and smaller tolerances. Returns false if the user interrupts it. */
static bool contender_measure(struct cost *cost, int by)
{
    const double longest = 2; /* in s; a measurement that would probably take longer is not made */
    const double finest = (double)any_arithmetic(precision_of(by)).tol_floor;
    for (int t = 0; t < TOLERANCES && tolerances[t] >= finest; t++) {
        struct cost_row *row = &cost->row[cost->rows];
        *row = (struct cost_row){.by = by, .tol = tolerances[t]};
        /* The paper's method takes up to ten times as many steps for each further digit. */
        if (t > 0 && by == BY_METHOD && row[-1].seconds * tolerances[t - 1] / tolerances[t] > longest)
            break;
        row_measure(cost, row);
        if (row->status == DOM_INTERRUPTED || row->status == DOM_NO_METHOD || row->status == DOM_NO_PRECISION)
            return row->status != DOM_INTERRUPTED;
        cost->rows++;
    }
    return true;
}

/* ---- The command ---- */

static const struct column cost_columns[] = {
    {"method", "", "the method: ours, or one for comparison", 6},
    {"precision", "", "the arithmetic", 9},
    {"tol", "", "the relative tolerance that was requested", 7},
    {"error", "", "the relative error that was achieved, compared with the most accurate quad answer", 9},
    {"dominoes", "", "the largest number of dominoes in one pass along the train", 8},
    {"passes", "", "how many times the computation passes along the train", 9},
    {"time", "us", "time that one answer takes: the shortest of up to seven measurements", 10},
    {"times", "", "time divided by the time of the cheapest answer", 9},
    {NULL, NULL, NULL, 0},
};

/* Returns the shortest time in s in which a contender, or any if `by` is -1, reached this relative error, or
 * NaN if it never did. */
static double seconds_for(const struct cost *cost, int by, double error)
{
    double least = (double)NAN;
    for (const struct cost_row *row = cost->row; row < cost->row + cost->rows; row++)
        if ((by < 0 || row->by == by) && row->status == DOM_OK && row->error <= (domq_real)error)
            least = fmin(least, row->seconds); /* fmin ignores the initial NaN */
    return least;
}

/* Compares the times of a contender with ours in double. Without one of the times, prints nothing. */
static void times_say(struct answer *a, const struct cost *cost, const char *name, int by, int digits)
{
    const double error = pow(10, -digits),
                 times = seconds_for(cost, by, error) / seconds_for(cost, IN_DOUBLE, error);
    if (isfinite(times))
        answer_say(a, "%-7s %s times as long as ours, for %d digits", name,
                   measured((domq_real)times, "", 3).text, digits);
}

/* Writes the table, and compares the times for 3, 6 and 12 correct digits. The true error, not the tolerance,
 * decides how many digits are correct. */
static void cost_write(struct answer *a, const struct cost *cost)
{
    const double cheapest = seconds_for(cost, -1, HUGE_VAL), twelve = seconds_for(cost, IN_DOUBLE, 1e-12);
    a->in_double = true;
    for (const struct cost_row *row = cost->row; row < cost->row + cost->rows; row++) {
        struct cell cells[] = {cell_word(row->by == BY_METHOD ? cost->method->name : "ours"),
                               cell_word(any_arithmetic(precision_of(row->by)).name),
                               cell_narrow((domq_real)row->tol, 3),
                               cell_narrow(row->error, 3),
                               cell_count((domq_real)row->work.longest),
                               cell_count((domq_real)row->work.passes),
                               cell_narrow((domq_real)(1e6 * row->seconds), 3),
                               cell_narrow((domq_real)(row->seconds / cheapest), 3)};
        for (int i = 3; i < 8 && row->status != DOM_OK; i++)
            cells[i] = cell_real(DOMQ_NAN);
        answer_row(a, cells, NULL);
    }
    answer_say(a, "%s, the time for one answer:", measured_answers[cost->which].meaning);
    answer_say(a, "ours    %.3g us for 3 digits, %.3g us for 6, %.3g us for 12",
               1e6 * seconds_for(cost, IN_DOUBLE, 1e-3), 1e6 * seconds_for(cost, IN_DOUBLE, 1e-6),
               1e6 * twelve);
    times_say(a, cost, "quad", IN_QUAD, 12);
    if (cost->method)
        times_say(a, cost, cost->method->name, BY_METHOD, 6);
    if (isnan(twelve))
        answer_say(a, "Double precision cannot give 12 digits here, because the answer depends too strongly "
                      "on the parameters.");
}

static bool run_cost(const struct query *query, struct answer *a, struct problem *problem)
{
    struct cost cost = {.train = &query->scene->train,
                        .compute = query_compute(query),
                        .which = (enum cost_of)query->given->number[0]};
    struct any_compute compute = *cost.compute;
    for (int f = 0; feature_at(f); f++)
        cost.method = feature_at(f)->method ? feature_at(f)->method : cost.method;
    const enum precision finest = any_arithmetic(IN_QUAD).bits ? IN_QUAD : IN_DOUBLE;
    compute.tol = any_arithmetic(finest).tol_floor;
    enum dom_status status = value_find(&cost, (int)finest, &compute, &cost.reference);
    if (status == DOM_NO_FUEL || status == DOM_STOPS || status == DOM_NO_GROWTH)
        return problem_error(problem, "there is no answer to measure here: %s", dom_status_text(status));
    bool goes_on = status == DOM_OK && (!cost.method || contender_measure(&cost, BY_METHOD));
    for (int by = IN_FLOAT; by <= IN_QUAD && goes_on; by++)
        goes_on = contender_measure(&cost, by);
    if (!query_status(query, problem, status == DOM_OK && !goes_on ? DOM_INTERRUPTED : status))
        return false;
    cost_write(a, &cost);
    return true;
}

const struct command cost_commands[] = {
    {.name = "cost",
     .synonyms = "accuracy precision benchmark speed fast",
     .argument = {{.name = "COMMAND",
                   .kind = ARGUMENT_CHOICE,
                   .noun = "command with a tolerance",
                   .choices = cost_names}},
     .summary = "how much time each digit of an answer costs",
     .help = "COMMAND is barrier, duration, rmax or pair, with the parameters of the session. "
             "Each method computes the answer several times, with smaller and smaller tolerances. Our method "
             "is measured in every precision, others only in double. The error in the table is the true "
             "error, which includes the effect of rounding the parameters.",
     .see = "rmax set",
     .sweep.refusal =
         "it measures computing time, and points computed at the same time would slow each other down",
     .rows = true,
     .brief = "",
     ANSWER(cost)},
    {.name = NULL},
};
