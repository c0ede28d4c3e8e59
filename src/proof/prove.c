/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'prove', which computes rigorous bounds on an answer. */
#include "domino_proof.h"
#include "interpreter/command.h"
#include "language/quad.h"
#include "train/train.h"

enum what { PROVE_RMAX, PROVE_PAIR, PROVE_BARRIER, PROVE_VERDICT, PROVE_COUNT };

static const char *prove_names(const void *context, int k)
{
    static const char *const name[] = {
        [PROVE_RMAX] = "rmax",       [PROVE_PAIR] = "pair",   [PROVE_BARRIER] = "barrier",
        [PROVE_VERDICT] = "verdict", [PROVE_COUNT] = "count", NULL};
    (void)context;
    return name[k];
}

static const struct column prove_columns[] = {
    {"s", "h", "separation: the gap divided by the height", 0},
    {"what", "", "the answer that the proof is about", 7},
    {"low", "", "proved lower bound on the answer", 0},
    {"high", "", "proved upper bound on the answer", 0},
    {"result", "", "the result of the proof", 12},
    {NULL, NULL, NULL, 0},
};

static struct dom_compute proof_compute(const struct query *query)
{
    /* the tolerance of the session, which can be finer than that of other answers in double */
    const struct any_compute *compute = &query->state->scene.compute;
    return (struct dom_compute){.tol = (double)compute->tol, .interrupt = compute->interrupt};
}

/* Enough digits for an exact round trip, because a rounded bound might be false. */
enum { ALL_DIGITS = 17 };

/* Returns a cell that shows `decimals` digits after the decimal point, or all digits if `decimals` is 0. */
static struct cell cell_proved(double value, int decimals)
{
    int before = value >= 1 && isfinite(value) ? (int)log10(value) + 1 : 0;
    struct cell cell = cell_real(value);
    cell.digits = decimals == 0 ? ALL_DIGITS : before + decimals;
    return cell;
}

/* Adds the row of the answer. `reason` may be NULL; the gap of an incomplete proof takes its place. */
static void prove_row(struct answer *a, double s, enum what what, struct cell low, struct cell high,
                      const char *result, enum dom_proof_gap gap, const char *reason)
{
    char text[ANSWER_REASON];
    snprintf(text, sizeof text, "not proved: %s", dom_proof_gap_text(gap));
    answer_row(a, ROW(cell_real(s), cell_word(prove_names(NULL, (int)what)), low, high, cell_word(result)),
               gap == DOM_PROOF_NONE ? reason : text);
}

static void say_limit(struct answer *a, const struct dom_proof *p, bool pair)
{
    const char *falls = pair ? "the first domino topples the next one even if it only just tips over"
                             : "the train keeps falling",
               *stops = pair ? "the first domino does not topple the next one if it only just tips over"
                             : "the train stops";
    /* The 12 printed digits may be rounded up, which would claim more than is proved. */
    double low = p->low * (1 - 6e-12);
    if (p->ends == DOM_PROVED_BARRIER)
        answer_say(a, "Proved: for every growth from %.12g to %.*f %s; at %.*f it %s.", p->from, p->decimals,
                   p->low, falls, p->decimals, p->high, pair ? "does not" : "stops");
    else if (p->ends == DOM_PROVED_REACH)
        answer_say(a, "Proved: for every growth from %.12g up to 1/s %s.", p->from, falls);
    else if (p->ends == DOM_PROVED_NONE)
        answer_say(a, "Proved: at growth 1 %s.", stops);
    else if (low > p->from)
        answer_say(a, "Only this is proved: for every growth from %.12g to %.12g %s.", p->from, low, falls);
    else if (p->low >= p->from)
        answer_say(a, "Only this is proved: at growth %.12g %s.", p->from, falls);
    else
        answer_say(a, "Nothing is proved.");
}

static bool prove_limit(const struct query *query, struct answer *a, struct problem *problem, enum what what,
                        double s)
{
    static const char *const result[] = {[DOM_PROVED_BARRIER] = "barrier",
                                         [DOM_PROVED_REACH] = "reach",
                                         [DOM_PROVED_NONE] = "none",
                                         [DOM_PROVED_PARTLY] = "not proved"};
    struct dom_train train = train_in_double(&query->scene->train);
    struct dom_compute compute = proof_compute(query);
    struct dom_proof proof = {.low = DOM_NAN};
    train.s = s;
    if (!query_status(query, problem,
                      (what == PROVE_PAIR ? dom_prove_pair : dom_prove_rmax)(&train, &compute, &proof)))
        return false;
    int decimals = proof.ends == DOM_PROVED_BARRIER ? proof.decimals : 0;
    answer_set_verdict(a, proof.ends == DOM_PROVED_BARRIER || proof.ends == DOM_PROVED_REACH);
    prove_row(a, s, what, cell_proved(proof.low, decimals),
              cell_proved(proof.ends == DOM_PROVED_NONE ? DOM_NAN : proof.high, decimals), result[proof.ends],
              proof.gap, NULL);
    say_limit(a, &proof, what == PROVE_PAIR);
    return true;
}

/* What is printed for each verdict about the session's train: a word in the table, and a sentence below the
 * table. */
static const struct {
    const char *result, *sentence;
} cycle_verdicts[] = {
    [DOM_PROVED_GOES_ON] =
        {"goes on", "the train keeps falling: at every tilt of the cycle it has enough energy for the climb"},
    [DOM_PROVED_STOPS] = {"stops",
                          "the train stops: at one tilt of the cycle it has too little energy for the climb"},
    [DOM_PROVED_NO_FUEL] = {"no fuel", "the train stops: a cycle releases no energy"},
    [DOM_PROVED_OUT_OF_REACH] = {"out of reach", "the head falls past the next domino, because r s > 1"},
    [DOM_PROVED_NOTHING] = {"not proved", NULL},
};

static void say_cycle(const struct query *query, struct answer *a, const struct dom_proof_cycle *p)
{
    if (cycle_verdicts[p->verdict].sentence)
        answer_say(a, "Proved: at growth %.12g %s.", (double)query->scene->train.r,
                   cycle_verdicts[p->verdict].sentence);
}

static bool prove_cycle(const struct query *query, struct answer *a, struct problem *problem, enum what what)
{
    struct dom_train train = train_in_double(&query->scene->train);
    struct dom_compute compute = proof_compute(query);
    struct dom_proof_cycle proof = {.gap = DOM_PROOF_NONE};
    if (!query_status(query, problem, dom_prove_cycle(&train, &compute, &proof)))
        return false;
    struct dom_interval range = what == PROVE_BARRIER ? proof.barrier : proof.margin;
    answer_set_verdict(a, proof.verdict == DOM_PROVED_GOES_ON);
    prove_row(a, train.s, what, cell_proved(range.low, 0), cell_proved(range.high, 0),
              cycle_verdicts[proof.verdict].result, proof.gap, NULL);
    if (what == PROVE_BARRIER && isfinite(range.high))
        answer_say(a, "Proved: the barrier is between these two bounds, in units of the head's m g h/2.");
    say_cycle(query, a, &proof);
    return true;
}

static bool prove_count(const struct query *query, struct answer *a, struct problem *problem, double height)
{
    struct dom_train train = train_in_double(&query->scene->train);
    struct dom_compute compute = proof_compute(query);
    struct dom_proof_cycle proof = {.gap = DOM_PROOF_NONE};
    struct start start;
    char ends[START_TEXT];
    double least, most;
    if (!query_status(query, problem,
                      dom_prove_count((double)query->scene->scale.h, height, train.r, &least, &most)) ||
        !query_status(query, problem, dom_prove_cycle(&train, &compute, &proof)))
        return false;
    bool is_known = least == most, is_enough = is_known && isfinite(least),
         goes_on = proof.verdict == DOM_PROVED_GOES_ON;
    if (!start_run(query, &query->scene->train, (domq_real)most + 1, true, &start, problem))
        return false;
    answer_set_verdict(a, is_enough && goes_on && start.falls);
    prove_row(a, train.s, PROVE_COUNT, cell_count(least), cell_count(most),
              !is_known || proof.verdict == DOM_PROVED_NOTHING ? "not proved"
              : !goes_on                                       ? "does not"
              : start.falls                                    ? "goes on"
                                                               : "no start",
              proof.gap,
              !is_known
                  ? "not proved: there are too many dominoes, or the last digit of a height or of r matters"
              : !is_enough ? "with r = 1 all dominoes are equally tall, so none of them reaches this height"
              : goes_on && !start.falls ? start_problem(query, &start, ends)
                                        : NULL);
    if (is_enough)
        answer_say(a, "Proved: %.0f dominoes are enough at growth %.12g, and fewer are not.", least, train.r);
    say_cycle(query, a, &proof);
    answer_say(a, "Computed, but not proved: the row %s %s.", start.falls ? "starts" : "does not start",
               start_words(query).text);
    return true;
}

static bool run_prove(const struct query *query, struct answer *a, struct problem *problem)
{
    static const struct argument separation = {.name = "S", .kind = ARGUMENT_VALUE_OF, .parameter = "s"},
                                 height = {.name = "H", .kind = ARGUMENT_HEIGHT};
    enum what what = (enum what)query->given->number[0];
    bool has_value = query->given->count > 1, of_limit = what == PROVE_RMAX || what == PROVE_PAIR;
    domq_real value = query->scene->train.s;
    if (what == PROVE_COUNT && !has_value)
        return problem_error(problem, "'prove count' needs a height, for example 'prove count 112 m'");
    if (what != PROVE_COUNT && !of_limit && has_value)
        return problem_error(problem, "'prove %s' takes no value; 'set s' and 'set r' choose the train",
                             prove_names(NULL, (int)what));
    if (has_value &&
        !argument_check(query, of_limit ? &separation : &height, query->given->quantity[1], &value, problem))
        return false;
    a->in_double = true;
    return what == PROVE_COUNT ? prove_count(query, a, problem, (double)value)
           : of_limit          ? prove_limit(query, a, problem, what, (double)value)
                               : prove_cycle(query, a, problem, what);
}

static const struct command prove_commands[] = {
    {.name = "prove",
     .precision = PRECISION_DOUBLE,
     .synonyms = "proof rigorous certain guaranteed interval enclosure",
     .train = true,
     .argument =
         {{.name = "WHAT", .kind = ARGUMENT_CHOICE, .noun = "answer with a proof", .choices = prove_names},
          {.name = "VALUE", .kind = ARGUMENT_ANY, .noun = "value", .optional = true}},
     .summary = "an answer with a proof: rmax, pair, barrier, verdict or count",
     .help =
         "'prove rmax S' and 'prove pair S' find two decimal numbers, 'tol' apart, with the largest "
         "growth between them. The train keeps falling at every growth up to the first number and stops at "
         "the second. 'prove barrier' and 'prove verdict' are about the growth r. 'prove count H' is "
         "about the number of dominoes. It also computes whether such a row starts, but does not prove "
         "this. A proof covers every tilt and every growth in a range, not only samples; domino-model(7) "
         "explains how. If a proof fails or is interrupted, the answer is 'not proved', with what has "
         "been proved so far. There are no proofs with friction, slopes or rounded edges.",
     .equation = "(26; c8), section 'A general domino train'",
     .example = "prove rmax 0.4",
     .see = "rmax pair barrier count",
     .sweep.echo = "s",
     .holds = "there is a proof that the train keeps falling",
     ANSWER(prove)},
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"Answers with a proof", "limits", prove_commands},
    {NULL, NULL, NULL},
};

const struct feature proof_feature = {.name = "proof", .groups = groups};
