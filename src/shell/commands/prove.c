/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Answers with a proof. */
#include "commands/tables.h"
#include "domino_proof.h"
#include "language/quad.h"

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
    {"s", "h", "separation", 0},
    {"what", "", "what is proved of", 7},
    {"low", "", "proved: not less than this", 0},
    {"high", "", "proved: not more than this", 0},
    {"result", "", "what the proof ends with", 12},
    {"boxes", "", "parts of the plane of tilts and growths in the proof", 9},
    {"chains", "", "passes down the train in the proof", 9},
    {NULL, NULL, NULL, 0},
};

struct dom_train proof_train(const struct domq_train *train)
{
    struct dom_train t = dom_train_default();
#define COPY(name, default_, lowest, highest, unit, meaning) t.name = (double)train->name;
    DOM_TRAIN_PARAMETERS(COPY)
#undef COPY
#define COPY(effect, member, status) t.member = (double)train->member;
    DOM_DYNAMICS(COPY)
#undef COPY
    t.fuel = train->fuel;
    return t;
}

static struct dom_compute proof_compute(const struct query *query)
{
    struct dom_compute compute = dom_compute_default();
    compute.tol = (double)query->scene->compute.tol;
    compute.interrupt = query->scene->compute.interrupt;
    return compute;
}

/* A bound with the digits that the proof gives it. */
static struct cell cell_proved(double value, int digits)
{
    struct cell cell = cell_real(value);
    cell.digits = digits;
    return cell;
}

/* Returns how many digits a number has, with this many after its decimal point. */
static int digits_of(double value, int decimals)
{
    return (value >= 1 && isfinite(value) ? (int)log10(value) + 1 : 0) + decimals;
}

/* Read back as the same double: a rounded bound would be none. */
enum { ALL_DIGITS = 17 };

struct proved {
    enum what what;
    double low, high;
    int digits, high_digits;
    const char *result;
    struct dom_proof_work work;
};

static bool prove_row(const struct query *query, struct answer *a, struct problem *problem, double s,
                      const struct proved *p, const char *reason)
{
    (void)query, (void)problem;
    return answer_row(a,
                      ROW(cell_real(s), cell_word(prove_names(NULL, (int)p->what)),
                          p->what == PROVE_COUNT ? cell_count(p->low) : cell_proved(p->low, p->digits),
                          p->what == PROVE_COUNT ? cell_count(p->high) : cell_proved(p->high, p->high_digits),
                          cell_word(p->result), cell_count((domq_real)p->work.boxes),
                          cell_count((domq_real)p->work.chains)),
                      reason);
}

/* Why a proof is not whole, for people and programs. */
static const char *gap_reason(enum dom_proof_gap gap, char reason[ANSWER_REASON])
{
    if (gap == DOM_PROOF_NONE)
        return NULL;
    snprintf(reason, ANSWER_REASON, "not proved: %s", dom_proof_gap_text(gap));
    return reason;
}

/* Returns a number that is less than `proved` when it is printed with 12 digits: rounded up, it would claim
 * more than is proved. */
static double less_in_12_digits(double proved)
{
    return proved * (1 - 6e-12);
}

/* Says in words what is proved of the largest growth. */
static void say_limit(struct answer *a, const struct dom_proof *p, bool pair)
{
    const char *who = pair ? "a first domino that just tips over topples the next one" : "the train goes on";
    switch (p->ends) {
    case DOM_PROVED_BARRIER:
        answer_say(a, "Proved: for every growth from %.12g to %.*f %s; at %.*f it %s.", p->from, p->decimals,
                   p->low, who, p->decimals, p->high, pair ? "does not" : "stops");
        break;
    case DOM_PROVED_REACH:
        answer_say(a, "Proved: for every growth from %.12g up to 1/s %s.", p->from, who);
        break;
    case DOM_PROVED_NONE:
        answer_say(a, "Proved: at growth 1 %s.",
                   pair ? "a first domino that just tips over does not topple the next one"
                        : "the train stops");
        break;
    case DOM_PROVED_PARTLY:
        if (less_in_12_digits(p->low) > p->from)
            answer_say(a, "Proved, but no more: for every growth from %.12g to %.12g %s.", p->from,
                       less_in_12_digits(p->low), who);
        else if (p->low >= p->from)
            answer_say(a, "Proved, but no more: at growth %.12g %s.", p->from, who);
        else
            answer_say(a, "Nothing is proved.");
        break;
    }
}

static bool prove_limit(const struct query *query, struct answer *a, struct problem *problem, enum what what)
{
    static const char *const result[] = {[DOM_PROVED_BARRIER] = "barrier",
                                         [DOM_PROVED_REACH] = "reach",
                                         [DOM_PROVED_NONE] = "none",
                                         [DOM_PROVED_PARTLY] = "not proved"};
    struct dom_train train = proof_train(&query->scene->train);
    struct dom_compute compute = proof_compute(query);
    struct dom_proof proof = {.low = DOM_NAN};
    char reason[ANSWER_REASON];
    if (query->given->count > 1)
        train.s = (double)query->given->number[1];
    enum dom_status status = (what == PROVE_PAIR ? dom_prove_pair : dom_prove_rmax)(&train, &compute, &proof);
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    struct proved p = {.what = what,
                       .low = proof.low,
                       .high = proof.ends == DOM_PROVED_NONE ? DOM_NAN : proof.high,
                       .digits = digits_of(proof.low, proof.decimals),
                       .high_digits = digits_of(proof.high, proof.decimals),
                       .result = result[proof.ends],
                       .work = proof.work};
    if (proof.ends != DOM_PROVED_BARRIER)
        p.digits = p.high_digits = ALL_DIGITS;
    answer_holds(a, proof.ends == DOM_PROVED_BARRIER || proof.ends == DOM_PROVED_REACH);
    prove_row(query, a, problem, train.s, &p, gap_reason(proof.gap, reason));
    say_limit(a, &proof, what == PROVE_PAIR);
    return true;
}

/* Says in words what is proved of one growth. */
static void say_cycle(const struct query *query, struct answer *a, const struct dom_proof_cycle *p)
{
    static const char *const says[] = {
        [DOM_PROVED_GOES_ON] =
            "the train goes on: for no tilt of the cycle is the climb more than its energy",
        [DOM_PROVED_STOPS] = "the train stops: at one tilt the climb is more than its energy",
        [DOM_PROVED_NO_FUEL] = "the train stops: a cycle sets no energy free",
        [DOM_PROVED_OUT_OF_REACH] = "r s > 1: the head falls past the next domino",
        [DOM_PROVED_NOTHING] = NULL};
    if (says[p->verdict])
        answer_say(a, "Proved: at growth %.12g %s.", (double)query->scene->train.r, says[p->verdict]);
}

static bool prove_cycle(const struct query *query, struct answer *a, struct problem *problem, enum what what)
{
    static const char *const result[] = {[DOM_PROVED_GOES_ON] = "goes on",
                                         [DOM_PROVED_STOPS] = "stops",
                                         [DOM_PROVED_NO_FUEL] = "no fuel",
                                         [DOM_PROVED_OUT_OF_REACH] = "out of reach",
                                         [DOM_PROVED_NOTHING] = "not proved"};
    struct dom_train train = proof_train(&query->scene->train);
    struct dom_compute compute = proof_compute(query);
    struct dom_proof_cycle proof = {.gap = DOM_PROOF_NONE};
    char reason[ANSWER_REASON];
    enum dom_status status = dom_prove_cycle(&train, &compute, &proof);
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    struct dom_interval range = what == PROVE_BARRIER ? proof.barrier : proof.margin;
    struct proved p = {.what = what,
                       .low = range.low,
                       .high = range.high,
                       .digits = ALL_DIGITS,
                       .high_digits = ALL_DIGITS,
                       .result = result[proof.verdict],
                       .work = proof.work};
    answer_holds(a, proof.verdict == DOM_PROVED_GOES_ON);
    prove_row(query, a, problem, train.s, &p, gap_reason(proof.gap, reason));
    if (what == PROVE_BARRIER && isfinite(range.high))
        answer_say(a, "Proved: the barrier is between these two, in m g h/2 of the head.");
    say_cycle(query, a, &proof);
    return true;
}

static bool prove_count(const struct query *query, struct answer *a, struct problem *problem)
{
    struct dom_train train = proof_train(&query->scene->train);
    struct dom_compute compute = proof_compute(query);
    struct dom_proof_cycle proof = {.gap = DOM_PROOF_NONE};
    double least, most, first = (double)query->scene->scale.h, height = (double)query->given->number[1];
    enum dom_status status = dom_prove_count(first, height, train.r, &least, &most);
    if (status == DOM_OK)
        status = dom_prove_cycle(&train, &compute, &proof);
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    bool known = least == most;
    struct proved p = {.what = PROVE_COUNT,
                       .low = least,
                       .high = most,
                       .result = known ? proof.verdict == DOM_PROVED_GOES_ON ? "goes on" : "does not"
                                       : "not proved",
                       .work = proof.work};
    if (proof.verdict == DOM_PROVED_NOTHING)
        p.result = "not proved";
    answer_holds(a, known && isfinite(least) && proof.verdict == DOM_PROVED_GOES_ON);
    prove_row(query, a, problem, train.s, &p,
              !known             ? "not proved: the last digit of a height or of r decides"
              : !isfinite(least) ? "r = 1: the dominoes do not grow, no number of them is enough"
                                 : NULL);
    if (known && isfinite(least))
        answer_say(a, "Proved: %.0f dominoes are as many as it takes at growth %.12g, and no fewer.", least,
                   train.r);
    say_cycle(query, a, &proof);
    return true;
}

static bool run_prove(const struct query *query, struct answer *a, struct problem *problem)
{
    enum what what = (enum what)query->given->number[0];
    const struct argument separation = {.name = "S", .kind = ARGUMENT_OF, .of = "s"},
                          height = {.name = "H", .kind = ARGUMENT_HEIGHT};
    struct arguments checked = *query->given;
    bool given = query->given->count > 1;
    if (what == PROVE_COUNT && !given)
        return problem_error(problem, "'prove count' needs a height, for example 'prove count 112 m'");
    if ((what == PROVE_BARRIER || what == PROVE_VERDICT) && given)
        return problem_error(problem, "'prove %s' takes no value; 'set s' and 'set r' say which train",
                             prove_names(NULL, (int)what));
    if (given && !argument_check(query, what == PROVE_COUNT ? &height : &separation,
                                 query->given->quantity[1], &checked.number[1], problem))
        return false;
    struct query asked = *query;
    asked.given = &checked;
    return what == PROVE_COUNT                                 ? prove_count(&asked, a, problem)
           : given || what == PROVE_RMAX || what == PROVE_PAIR ? prove_limit(&asked, a, problem, what)
                                                               : prove_cycle(&asked, a, problem, what);
}

const struct command prove_commands[] = {
    {.name = "prove",
     .synonyms = "proof rigorous certain guaranteed interval enclosure",
     .train = true,
     .argument =
         {{.name = "WHAT", .kind = ARGUMENT_CHOICE, .of = "answer with a proof", .choices = prove_names},
          {.name = "VALUE", .kind = ARGUMENT_ANY, .of = "value", .optional = true}},
     .summary = "an answer with a proof: rmax, pair, barrier, verdict or count",
     .help = "'prove rmax S' and 'prove pair S' enclose the largest growth between two decimals, 'tol' "
             "apart: for "
             "every growth up to the first the train goes on, and at the second it stops. 'prove barrier' "
             "and 'prove "
             "verdict' are about the growth r, 'prove count H' about the number of dominoes. The proof takes "
             "all tilts "
             "and all growths in between; domino-model(7) says how. Where it fails, the answer is 'not "
             "proved' with "
             "what was proved so far, also after ^C. Friction and slopes have no proof.",
     .equation = "(26; c8), section 'A general domino train'",
     .example = "prove rmax 0.4",
     .see = "rmax pair barrier count",
     .echo = "s",
     .holds = "there is a proof that the train goes on",
     ANSWER(prove)},
    {.name = NULL},
};
