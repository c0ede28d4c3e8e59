/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'cost', which measures computing time. It uses a single thread: more threads would compete for
 * caches and memory, and lower the clock rate. */
#include "interpreter/command.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "train/train.h"

/* ---- The quantities that can be measured ---- */

enum { COST_FUEL, COST_LAUNCH, COST_BARRIER, COST_DURATION, COST_RMAX, COST_PAIR };

static const struct {
    const char *name, *meaning;
} measured_answers[] = {
    [COST_FUEL] = {"fuel", "the fuel P"},
    [COST_LAUNCH] = {"launch", "tau^2 omega(0)^2"},
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

static enum dom_status compute_answer(int which, const struct domq_train *train,
                                      const struct any_compute *compute, domq_real *value)
{
    struct domq_fuels fuels;
    struct domq_launch launch;
    struct domq_barrier barrier;
    struct domq_limit limit;
    enum dom_status status;
    switch (which) {
    case COST_FUEL:
        status = any_fuel_find(train, compute, &fuels);
        *value = train->fuel == DOM_FUEL_PAPER ? fuels.paper : fuels.exact;
        return status;
    case COST_LAUNCH:
        status = any_launch_find(train, compute, &launch);
        *value = launch.omegasq;
        return status;
    case COST_BARRIER:
        status = any_barrier_find(train, compute, &barrier);
        *value = barrier.margin;
        return status == DOM_STOPS ? DOM_OK : status;
    case COST_DURATION:
        return any_cycle_duration(train, compute, value);
    default:
        status = (which == COST_RMAX ? any_limit_rmax : any_limit_pair)(train, compute, &limit);
        *value = limit.r_max;
        return status == DOM_OK && limit.ends == DOM_END_NONE ? DOM_NO_GROWTH : status;
    }
}

/* ---- Measuring ---- */

static const struct {
    enum dom_method method;
    enum precision precision;
    double share; /* roughly the fraction of the time that this contender takes, for the progress display */
} contenders[] = {
    {DOM_METHOD_PAPER, IN_DOUBLE, 0.1}, {DOM_METHOD_GSL, IN_DOUBLE, 0.05}, {DOM_METHOD_OURS, IN_FLOAT, 0.02},
    {DOM_METHOD_OURS, IN_DOUBLE, 0.03}, {DOM_METHOD_OURS, IN_QUAD, 0.8},
};
enum { CONTENDERS = sizeof contenders / sizeof *contenders };

static const double tolerances[] = {1e-1,  1e-2,  1e-3,  1e-6,  1e-9,  1e-12, 1e-15,
                                    1e-18, 1e-21, 1e-24, 1e-27, 1e-30, 1e-33};
enum { TOLERANCES = sizeof tolerances / sizeof *tolerances };

struct cost_row {
    enum dom_method method;
    enum precision precision;
    double tol;
    enum dom_status status; /* if `status` is not DOM_OK, the members below are not set */
    domq_real error;        /* the relative error of the result, or that of the reference if it is larger */
    struct dom_work work;
    double seconds; /* the time that an answer takes: the shortest of up to seven measurements */
};

struct cost {
    struct cost_row row[(int)CONTENDERS * (int)TOLERANCES];
    int rows;
    double cheapest; /* time of the quickest measurement, in seconds */
};

/* Returns how many seconds the answer takes, in the fastest of up to seven batches. A slow answer is timed
 * only once. Returns NaN if there is no answer. */
static double seconds_of(int which, const struct domq_train *train, const struct any_compute *compute)
{
    const double shortest = 2e-4; /* in s; the clock is too coarse for a shorter batch */
    const double slow = 0.1;      /* in s; a batch that takes longer is the last */
    const int batches = 7;
    double least = HUGE_VAL;
    long repeats = 1;
    domq_real value;
    for (int batch = 0; batch < batches;) {
        double begun = terminal_clock();
        for (long i = 0; i < repeats; i++)
            if (compute_answer(which, train, compute, &value) != DOM_OK)
                return (double)NAN;
        double seconds = terminal_clock() - begun;
        if (seconds < shortest) {
            repeats *= 2;
            continue;
        }
        least = fmin(least, seconds / (double)repeats);
        batch += seconds > slow ? batches : 1;
    }
    return least;
}

static void row_measure(int which, const struct query *query, domq_real reference, struct cost_row *row)
{
    const struct domq_train *train = &query->scene->train;
    struct any_compute compute = query->scene->compute;
    domq_real value = 0;
    compute.method = row->method;
    compute.precision = row->precision;
    compute.tol = (domq_real)row->tol;
    compute.work = &row->work;
    row->status = compute_answer(which, train, &compute, &value);
    if (row->status != DOM_OK)
        return;
    const domq_real size = reference == 0 ? 1 : quad(fabs)(reference),
                    rounding = (domq_real)any_arithmetic(IN_QUAD).epsilon * size;
    row->error = quad_larger(quad(fabs)(value - reference), rounding) / size;
    compute.work = NULL;
    row->seconds = seconds_of(which, train, &compute);
}

/* Measures one method in one precision, with smaller and smaller tolerances. */
static enum dom_status contender_measure(int which, const struct query *query, domq_real reference,
                                         int contender, double done, struct cost *cost)
{
    const double longest = 2; /* in s; a measurement that would probably take longer is not made */
    const struct domq_arithmetic arithmetic = any_arithmetic(contenders[contender].precision);
    for (int t = 0; t < TOLERANCES && tolerances[t] >= (double)arithmetic.tol_floor; t++) {
        struct cost_row *row = &cost->row[cost->rows];
        *row = (struct cost_row){.method = contenders[contender].method,
                                 .precision = contenders[contender].precision,
                                 .tol = tolerances[t]};
        /* The paper's method takes up to ten times as many steps for each further digit. */
        if (t > 0 && row->method == DOM_METHOD_PAPER &&
            row[-1].seconds * tolerances[t - 1] / tolerances[t] > longest)
            break;
        row_measure(which, query, reference, row);
        if (row->status == DOM_INTERRUPTED || row->status == DOM_NO_METHOD || row->status == DOM_NO_PRECISION)
            return row->status;
        if (row->status == DOM_OK)
            cost->cheapest = fmin(cost->cheapest, row->seconds);
        cost->rows++;
        progress_show(done + contenders[contender].share * (t + 1) / TOLERANCES);
    }
    return DOM_OK;
}

/* ---- The command ---- */

static const struct column cost_columns[] = {
    {"method", "", "the method: the paper's recipe, GSL's solvers, or our own", 6},
    {"precision", "", "the arithmetic", 9},
    {"tol", "", "the relative tolerance that was requested", 7},
    {"error", "", "the relative error that was achieved, compared with the most accurate quad answer", 9},
    {"dominoes", "", "the largest number of dominoes in one pass along the train", 8},
    {"passes", "", "how many times the computation passes along the train", 9},
    {"time", "us", "time that one answer takes: the shortest of up to seven measurements", 10},
    {"times", "", "time divided by the time of the cheapest answer", 9},
    {NULL, NULL, NULL, 0},
};

static void cost_line(struct answer *a, const struct cost *cost, const struct cost_row *row)
{
    static const char *const methods[] = {
        [DOM_METHOD_OURS] = "ours", [DOM_METHOD_PAPER] = "paper", [DOM_METHOD_GSL] = "GSL"};
    struct cell cells[] = {cell_word(methods[row->method]),
                           cell_word(any_arithmetic(row->precision).name),
                           cell_brief(row->tol),
                           cell_brief((double)row->error),
                           cell_count((domq_real)row->work.longest),
                           cell_count((domq_real)row->work.passes),
                           cell_brief(1e6 * row->seconds),
                           cell_brief(row->seconds / cost->cheapest)};
    for (int i = 3; i < 8 && row->status != DOM_OK; i++)
        cells[i] = cell_real(DOMQ_NAN);
    answer_row(a, cells, NULL);
}

/* Returns the shortest time in s in which a method reached this relative error, or NaN if it never did. */
static double seconds_for(const struct cost *cost, enum dom_method method, enum precision precision,
                          double error)
{
    double least = (double)NAN;
    for (const struct cost_row *row = cost->row; row < cost->row + cost->rows; row++)
        if (row->method == method && row->precision == precision && row->status == DOM_OK &&
            row->error <= (domq_real)error)
            least = fmin(least, row->seconds); /* fmin ignores the initial NaN */
    return least;
}

/* Prints a line such as "paper   12 times as long", unless a time is missing. */
static void times_say(struct answer *a, const char *what, double seconds, double others, const char *than)
{
    if (isfinite(seconds / others))
        answer_say(a, "%-7s %s times as long as %s", what,
                   measured((domq_real)(seconds / others), "", 3).text, than);
}

/* Compares the times for 3, 6 and 12 correct digits. The true error, not the tolerance, decides how many
 * digits are correct. */
static void cost_say(struct answer *a, const struct cost *cost, int which)
{
    double few = seconds_for(cost, DOM_METHOD_OURS, IN_DOUBLE, 1e-3);
    double six = seconds_for(cost, DOM_METHOD_OURS, IN_DOUBLE, 1e-6);
    double twelve = seconds_for(cost, DOM_METHOD_OURS, IN_DOUBLE, 1e-12);
    double quad = seconds_for(cost, DOM_METHOD_OURS, IN_QUAD, 1e-12) / twelve;
    answer_say(a, "%s, the time for one answer:", measured_answers[which].meaning);
    answer_say(a, "ours    %.3g us for 3 digits, %.3g us for 6, %.3g us for 12", 1e6 * few, 1e6 * six,
               1e6 * twelve);
    times_say(a, "quad", quad * twelve, twelve, "ours, for 12 digits");
    times_say(a, "GSL", seconds_for(cost, DOM_METHOD_GSL, IN_DOUBLE, 1e-6), six, "ours, for 6 digits");
    times_say(a, "paper", seconds_for(cost, DOM_METHOD_PAPER, IN_DOUBLE, 1e-6), six, "ours, for 6 digits");
    if (isnan(twelve))
        answer_say(a, "Double precision cannot give 12 digits here, because the answer depends too strongly "
                      "on the parameters.");
}

static bool run_cost(const struct query *query, struct answer *a, struct problem *problem)
{
    struct cost cost = {.cheapest = HUGE_VAL};
    struct any_compute finest = query->scene->compute;
    const int which = (int)query->given->number[0];
    domq_real reference = 0;
    double done = 0;
    finest.method = DOM_METHOD_OURS;
    finest.precision = any_arithmetic(IN_QUAD).bits ? IN_QUAD : IN_DOUBLE;
    finest.tol = any_arithmetic(finest.precision).tol_floor;
    enum dom_status status = compute_answer(which, &query->scene->train, &finest, &reference);
    for (int c = 0; c < CONTENDERS && status == DOM_OK; c++) {
        if (contender_measure(which, query, reference, c, done, &cost) == DOM_INTERRUPTED)
            status = DOM_INTERRUPTED;
        done += contenders[c].share;
    }
    progress_show(1);
    if (status == DOM_NO_FUEL || status == DOM_STOPS || status == DOM_NO_GROWTH)
        return problem_error(problem, "there is no answer to measure here: %s", dom_status_text(status));
    if (!query_status(query, problem, status))
        return false;
    for (int k = 0; k < cost.rows; k++)
        cost_line(a, &cost, &cost.row[k]);
    cost_say(a, &cost, which);
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
     .help = "COMMAND is fuel, launch, barrier, duration, rmax or pair, with the parameters of the session. "
             "Each method computes the answer several times, with smaller and smaller tolerances. Our method "
             "is measured in every precision, the others only in double. The error in the table is the true "
             "error, which includes the effect of rounding the parameters.",
     .see = "rmax set",
     .sweep.refusal =
         "it measures computing time, and points computed at the same time would slow each other down",
     .rows = true,
     .brief = "",
     ANSWER(cost)},
    {.name = NULL},
};
