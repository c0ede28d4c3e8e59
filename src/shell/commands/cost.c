/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Commands about the price of accuracy.  They run on one thread: what they answer is time, and others at work
 * would share caches, memory and the clock of the processor with what is measured.  The quad reference alone
 * could go beside, and takes a fiftieth of the whole.
 */
#include "commands/costs.h"
#include "commands/tables.h"
#include "domino_proof.h"
#include "io/terminal.h"
#include <string.h>

static const struct column cost_columns[] = {
    {"method", "", "the paper's recipe, solvers of GSL, or ours", 6},
    {"precision", "", "the arithmetic", 9},
    {"tol", "", "the relative tolerance that was requested", 7},
    {"error", "", "relative error that was achieved, against quad at its floor", 9},
    {"dominoes", "", "the most dominoes that one pass down the train followed", 8},
    {"passes", "", "evaluations: passes down the train", 9},
    {"time", "us", "time of one answer, the shortest of several", 10},
    {"times", "", "times as long as the cheapest", 9},
    {NULL, NULL, NULL, 0},
};

static void cost_line(struct answer *a, const struct cost *cost, const struct cost_row *row)
{
    bool good = row->status == DOM_OK;
    struct cell none = cell_real(DOMQ_NAN);
    answer_cells(a, cell_word(cost_method(row->method)), cell_word(domq_arithmetic(row->precision)->name),
                 cell_brief(row->tol), good ? cell_brief((double)row->error) : none,
                 good ? cell_count((domq_real)row->work.longest) : none,
                 good ? cell_count((domq_real)row->work.passes) : none,
                 good ? cell_brief(1e6 * row->seconds) : none,
                 good ? cell_brief(row->seconds / cost->cheapest) : none);
}

/*
 * Adds rows of the same limit with a proof. The error is half of the distance between the two proved sides,
 * over r_max; passes are chains. Each proof is measured once, since it lasts long. Returns the seconds of the
 * proof to 1e-12, or 0.
 */
static double cost_proved(const struct query *query, struct answer *a, const struct cost *cost,
                          const struct costed *answer)
{
    static const double tolerances[] = {1e-3, 1e-6, 1e-9, 1e-12, 1e-14};
    enum dom_status (*prove)(const struct dom_train *, const struct dom_compute *, struct dom_proof *) =
        strcmp(answer->name, "rmax") == 0   ? dom_prove_rmax
        : strcmp(answer->name, "pair") == 0 ? dom_prove_pair
                                            : NULL;
    struct dom_train train = proof_train(&query->scene->train);
    struct dom_compute compute = dom_compute_default();
    double twelve = 0;
    compute.interrupt = query->scene->compute.interrupt;
    for (size_t k = 0; prove && k < sizeof tolerances / sizeof *tolerances; k++) {
        struct dom_proof proof = {.low = DOM_NAN};
        compute.tol = tolerances[k];
        double begun = terminal_clock();
        if (prove(&train, &compute, &proof) != DOM_OK ||
            (proof.ends != DOM_PROVED_BARRIER && proof.ends != DOM_PROVED_REACH))
            break;
        double seconds = terminal_clock() - begun, error = (proof.high - proof.low) / (2 * proof.low);
        answer_cells(a, cell_word("proved"), cell_word("double"), cell_brief(tolerances[k]),
                     cell_brief(error), cell_real(DOMQ_NAN), cell_count((domq_real)proof.work.chains),
                     cell_brief(1e6 * seconds), cell_brief(seconds / cost->cheapest));
        twelve = tolerances[k] == 1e-12 ? seconds : twelve;
    }
    return twelve;
}

/* Returns the time of a row over that of another row; 0 where one of them is missing. */
static double times_of(const struct cost_row *row, const struct cost_row *other)
{
    return row && other ? row->seconds / other->seconds : 0;
}

static struct measured times_text(double times)
{
    return measured((domq_real)times, "", 3);
}

/* Prints what digits cost, in sentences: compares errors that were reached, not tolerances that were
 * requested. */
static void cost_say(struct answer *a, const struct cost *cost, const struct costed *answer)
{
    const struct cost_row *few = cost_reaching(cost, DOM_METHOD_OURS, DOM_DOUBLE, 1e-3);
    const struct cost_row *six = cost_reaching(cost, DOM_METHOD_OURS, DOM_DOUBLE, 1e-6);
    const struct cost_row *many = cost_reaching(cost, DOM_METHOD_OURS, DOM_DOUBLE, 1e-12);
    double gsl = times_of(cost_reaching(cost, DOM_METHOD_GSL, DOM_DOUBLE, 1e-6), six);
    double paper = times_of(cost_reaching(cost, DOM_METHOD_PAPER, DOM_DOUBLE, 1e-6), six);
    double quad = times_of(cost_reaching(cost, DOM_METHOD_OURS, DOM_QUAD, 1e-12), many);
    answer_say(a, "What is measured: %s.", answer->says);
    if (paper > 0)
        answer_say(a, "To 6 digits the paper's recipe takes %s times our time.", times_text(paper).text);
    if (gsl > 0)
        answer_say(a, "To 6 digits the solvers of GSL take %s times our time.", times_text(gsl).text);
    if (few && many && quad > 0)
        answer_say(a, "12 digits cost %s times what 3 digits cost; quad costs %s times double.",
                   times_text(times_of(many, few)).text, times_text(quad).text);
    else if (few && many)
        answer_say(a, "12 digits cost %s times what 3 digits cost.", times_text(times_of(many, few)).text);
    else
        answer_say(a, "Double precision has no 12 digits of it here: the parameters are too sensitive.");
}

bool cost_of(const struct query *query, struct problem *problem, const struct costed *answer,
             struct cost *cost)
{
    enum dom_status status = cost_measure(answer, &query->scene->train, &query->scene->compute, cost);
    if (status == DOM_NO_FUEL || status == DOM_STOPS || status == DOM_NO_GROWTH)
        return problem_error(problem, "there is no answer to measure here: %s", dom_status_text(status));
    return status == DOM_OK || problem_status(problem, query->scene, status);
}

static bool run_cost(const struct query *query, struct answer *a, struct problem *problem)
{
    struct cost cost;
    const struct costed *answer = &cost_answers[(int)query->given->number[0]];
    if (!cost_of(query, problem, answer, &cost))
        return false;
    for (int k = 0; k < cost.rows; k++)
        cost_line(a, &cost, &cost.row[k]);
    double proved = cost_proved(query, a, &cost, answer);
    cost_say(a, &cost, answer);
    const struct cost_row *ours = cost_reaching(&cost, DOM_METHOD_OURS, DOM_DOUBLE, 1e-12);
    if (proved > 0 && ours)
        answer_say(a, "A proof of 12 digits takes %s times our time without one.",
                   times_text(proved / ours->seconds).text);
    return true;
}

const struct command cost_commands[] = {
    {.name = "cost",
     .synonyms = "accuracy precision benchmark speed fast",
     .argument = {{.name = "COMMAND",
                   .kind = ARGUMENT_CHOICE,
                   .of = "command with a tolerance",
                   .choices = cost_names}},
     .summary = "what each digit of an answer costs in time",
     .help =
         "COMMAND is fuel, launch, barrier, duration, rmax or pair, at the session's parameters. Each "
         "method and precision computes more and more digits. The error is the true one, and includes the "
         "rounding of typed parameters; times are measured in separate runs. rmax and pair also have rows "
         "with a proof, as 'prove' gives it.",
     .see = "plot",
     .unswept = "it measures time, which points side by side would disturb",
     .rows = true,
     ANSWER(cost)},
    {.name = NULL},
};
