/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/costs.h"
#include "io/terminal.h"
#include "language/quad.h"

/* ---- Answers that have a tolerance ---- */

#define VALUE_OF(result, member) ((struct domq_value){(result).member, (result).error.member})

static enum dom_status ask_fuel(const struct domq_train *train, const struct domq_compute *compute,
                                struct domq_value *answer)
{
    struct domq_fuels fuels;
    enum dom_status status = domq_fuel_find(train, compute, &fuels);
    *answer = train->fuel == DOM_FUEL_PAPER ? VALUE_OF(fuels, paper) : VALUE_OF(fuels, exact);
    return status;
}

static enum dom_status ask_launch(const struct domq_train *train, const struct domq_compute *compute,
                                  struct domq_value *answer)
{
    struct domq_launch launch;
    enum dom_status status = domq_launch_find(train, compute, &launch);
    *answer = VALUE_OF(launch, omegasq);
    return status;
}

static enum dom_status ask_barrier(const struct domq_train *train, const struct domq_compute *compute,
                                   struct domq_value *answer)
{
    struct domq_barrier barrier;
    enum dom_status status = domq_barrier_find(train, compute, &barrier);
    *answer = VALUE_OF(barrier, margin);
    return status == DOM_STOPS ? DOM_OK : status;
}

static enum dom_status limit_value(enum dom_status status, const struct domq_limit *limit,
                                   struct domq_value *answer)
{
    *answer = VALUE_OF(*limit, r_max);
    return status == DOM_OK && limit->ends == DOM_END_NONE ? DOM_NO_GROWTH : status;
}

static enum dom_status ask_rmax(const struct domq_train *train, const struct domq_compute *compute,
                                struct domq_value *answer)
{
    struct domq_limit limit;
    return limit_value(domq_limit_rmax(train, compute, &limit), &limit, answer);
}

static enum dom_status ask_pair(const struct domq_train *train, const struct domq_compute *compute,
                                struct domq_value *answer)
{
    struct domq_limit limit;
    return limit_value(domq_limit_pair(train, compute, &limit), &limit, answer);
}

const struct costed cost_answers[] = {
    {"fuel", "the fuel P", ask_fuel},
    {"launch", "tau^2 omega(0)^2", ask_launch},
    {"barrier", "the margin, kinetic energy less barrier", ask_barrier},
    {"duration", "t_f / tau", domq_cycle_duration},
    {"rmax", "r_max", ask_rmax},
    {"pair", "r_max of two dominoes", ask_pair},
    {NULL, NULL, NULL},
};

const char *cost_names(const void *context, int k)
{
    (void)context;
    return cost_answers[k].name;
}

const char *cost_method(enum dom_method method)
{
    return method == DOM_METHOD_PAPER ? "paper" : method == DOM_METHOD_GSL ? "GSL" : "ours";
}

/* ---- Measuring ---- */

/* The clock ticks in nanoseconds: a batch of this length is known to a thousandth. */
#define BATCH_SECONDS 1e-4
#define BATCHES       7
#define SLOW_SECONDS  0.05 /* runs that last longer are not repeated as often */
#define MOST_SECONDS  2.0  /* no row of the paper's recipe is tried that would take longer */

/* Returns the seconds of one answer: the least of several batches, each long enough for the clock. */
static double least_seconds(const struct costed *answer, const struct domq_train *train,
                            const struct domq_compute *compute, double first)
{
    struct domq_value value;
    double least = first;
    long repeats = first < BATCH_SECONDS ? (long)(BATCH_SECONDS / (first + 1e-9)) + 1 : 1;
    int batches = first > SLOW_SECONDS ? 1 : BATCHES;
    for (int b = 0; b < batches; b++) {
        double begun = terminal_clock();
        for (long i = 0; i < repeats; i++)
            if (answer->ask(train, compute, &value) != DOM_OK)
                return least;
        double seconds = (terminal_clock() - begun) / (double)repeats;
        least = seconds < least ? seconds : least;
    }
    return least;
}

static void row_measure(const struct costed *answer, const struct domq_train *train,
                        struct domq_compute compute, const struct cost *cost, domq_real uncertain,
                        struct cost_row *row)
{
    struct domq_value value = {0, 0};
    compute.method = row->method;
    compute.precision = row->precision;
    compute.tol = (domq_real)row->tol;
    compute.work = &row->work;
    double begun = terminal_clock();
    row->status = answer->ask(train, &compute, &value);
    row->seconds = terminal_clock() - begun;
    if (row->status != DOM_OK)
        return;
    domq_real size = cost->value == 0 ? 1 : quad(fabs)(cost->value);
    row->error = quad_larger(quad(fabs)(value.value - cost->value), uncertain) / size;
    compute.work = NULL;
    row->seconds = least_seconds(answer, train, &compute, row->seconds);
}

static const struct {
    enum dom_method method;
    enum dom_precision precision;
    double share; /* of the time of the whole table, about: for its progress */
} contenders[] = {
    {DOM_METHOD_PAPER, DOM_DOUBLE, 0.1}, {DOM_METHOD_GSL, DOM_DOUBLE, 0.05},
    {DOM_METHOD_OURS, DOM_FLOAT, 0.02},  {DOM_METHOD_OURS, DOM_DOUBLE, 0.03},
    {DOM_METHOD_OURS, DOM_QUAD, 0.8},
};
enum { CONTENDERS = sizeof contenders / sizeof *contenders };

static const double tolerances[] = {1e-1,  1e-2,  1e-3,  1e-6,  1e-9,  1e-12, 1e-15,
                                    1e-18, 1e-21, 1e-24, 1e-27, 1e-30, 1e-33};
enum { TOLERANCES = sizeof tolerances / sizeof *tolerances };

_Static_assert((int)CONTENDERS *(int)TOLERANCES <= COST_ROWS + 1, "room for every row");

enum dom_status cost_measure(const struct costed *answer, const struct domq_train *train,
                             const struct domq_compute *compute, struct cost *cost)
{
    struct domq_compute finest = *compute;
    struct domq_value reference = {0, 0};
    double done = 0; /* shares of those before */
    finest.method = DOM_METHOD_OURS;
    finest.precision = domq_arithmetic(DOM_QUAD)->bits ? DOM_QUAD : DOM_DOUBLE;
    finest.tol = domq_arithmetic(finest.precision)->tol_floor;
    finest.errors = true;
    enum dom_status status = answer->ask(train, &finest, &reference);
    *cost = (struct cost){.cheapest = HUGE_VAL, .value = reference.value};
    for (int c = 0; c < CONTENDERS && status == DOM_OK; c++) {
        const struct domq_arithmetic *arithmetic = domq_arithmetic(contenders[c].precision);
        double before = 0; /* seconds of the row before */
        for (int t = 0; t < TOLERANCES && tolerances[t] >= (double)arithmetic->tol_floor; t++) {
            struct cost_row *row = &cost->row[cost->rows];
            *row = (struct cost_row){
                .method = contenders[c].method, .precision = contenders[c].precision, .tol = tolerances[t]};
            /* The paper's steps: each digit takes up to ten times as many. */
            bool too_long = row->method == DOM_METHOD_PAPER && t > 0 &&
                            before * tolerances[t - 1] / tolerances[t] > MOST_SECONDS;
            if (too_long)
                break;
            row_measure(answer, train, *compute, cost, reference.error, row);
            if (row->status == DOM_INTERRUPTED)
                status = DOM_INTERRUPTED;
            if (row->status == DOM_NO_METHOD || row->status == DOM_NO_PRECISION || status != DOM_OK)
                break;
            before = row->seconds;
            if (row->status == DOM_OK && row->seconds < cost->cheapest)
                cost->cheapest = row->seconds;
            cost->rows++;
            progress_show(done + contenders[c].share * (t + 1) / TOLERANCES);
        }
        done += contenders[c].share;
    }
    return status;
}

const struct cost_row *cost_reaching(const struct cost *cost, enum dom_method method,
                                     enum dom_precision precision, double error)
{
    const struct cost_row *found = NULL;
    for (const struct cost_row *row = cost->row; row < cost->row + cost->rows; row++)
        if (row->method == method && row->precision == precision && row->status == DOM_OK &&
            row->error <= (domq_real)error && (!found || row->seconds < found->seconds))
            found = row;
    return found;
}
