/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands about the limits of growth, and the quiz: how many dominoes up to a given height? */
#include "commands/tables.h"
#include "language/quad.h"
#include "parallel/points.h"
#include <string.h>

/* The i-th argument, or what stands for it where it is missing. */
static domq_real argument_or(const struct call *call, int i, domq_real fallback)
{
    return i < call->count ? call->number[i] : fallback;
}

/* Returns why no growth is possible, or NULL where one is. */
static const char *no_growth(struct domq_limit limit)
{
    if (limit.ends != DOM_END_NONE)
        return NULL;
    return limit.why == DOM_NO_FUEL ? "no growth possible: at this s and d even equal dominoes (r = 1) have "
                                      "no fuel, a fallen one lies no lower than it stood"
           : limit.why == DOM_LOCKS ? "no growth possible: friction locks already equal dominoes (r = 1)"
                                    : "no growth possible: at this s and d even equal dominoes (r = 1) do "
                                      "not get over their barrier";
}

/* Finds the limits with either fuel; with friction there is none with the paper's. */
static enum dom_status limits_find(struct domq_train train, const struct domq_compute *compute,
                                   struct domq_limit *exact, struct domq_limit *paper)
{
    train.fuel = DOM_FUEL_EXACT;
    enum dom_status status = domq_limit_rmax(&train, compute, exact);
    if (status != DOM_OK)
        return status;
    *paper = (struct domq_limit){.r_max = DOMQ_NAN, .ends = DOM_END_NONE, .why = exact->why};
    train.fuel = DOM_FUEL_PAPER;
    return domq_dynamics(&train) ? DOM_OK : domq_limit_rmax(&train, compute, paper);
}

static const struct column rmax_columns[] = {
    {"s", "h", "separation", 0},
    {"r_max", "", "largest growth at which the train goes on", 0},
    {"ends_by", "", "barrier (too high), reach (the next is missed), none", 7},
    {"r_max_exact", "", "with the fuel from the energy balance", 0},
    {"r_max_paper", "", "with the paper's closed form of the fuel", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_rmax(struct session *session, const struct call *call)
{
    const struct domq_compute compute = session_compute(session);
    struct domq_train train = session->train;
    struct domq_limit exact, paper;
    train.s = argument_or(call, 0, train.s);
    enum dom_status status = limits_find(train, &compute, &exact, &paper);
    if (status != DOM_OK)
        return session_status(session, status);
    struct domq_limit used = train.fuel == DOM_FUEL_PAPER ? paper : exact;
    answer_row(call->answer,
               ROW(cell_real(train.s), CELL_OF(used, r_max), cell_word(dom_end_text(used.ends)),
                   CELL_OF(exact, r_max), CELL_OF(paper, r_max)),
               no_growth(used));
    if (domq_law(&train)->dissipates)
        answer_say(call->answer,
                   "with friction %.6g between dominoes; the paper's closed form of the fuel knows none",
                   (double)train.mu);
    else if (domq_dynamics(&train))
        answer_say(call->answer, "the paper's closed form of the fuel knows no %s",
                   domq_dynamics(&train)->name);
    else if (used.ends != DOM_END_NONE && exact.r_max == paper.r_max)
        answer_say(call->answer, "both end by the reach 1/s, where the fuel does not matter");
    else if (used.ends != DOM_END_NONE)
        answer_say(call->answer,
                   "they differ since (c7)'s closed form of the fuel leaves out the weights r^(-q i)");
    return true;
}

static const struct column pair_columns[] = {
    {"s", "h", "separation", 0},
    {"r_max", "", "largest growth at which the first topples the next", 0},
    {"ends_by", "", "barrier, reach or none", 7},
    {NULL, NULL, NULL, 0},
};

static bool run_pair(struct session *session, const struct call *call)
{
    const struct domq_compute compute = session_compute(session);
    struct domq_train train = session->train;
    struct domq_limit limit;
    train.s = argument_or(call, 0, train.s);
    enum dom_status status = domq_limit_pair(&train, &compute, &limit);
    if (status != DOM_OK)
        return session_status(session, status);
    return answer_row(
        call->answer, ROW(cell_real(train.s), CELL_OF(limit, r_max), cell_word(dom_end_text(limit.ends))),
        limit.ends == DOM_END_NONE ? "no growth possible: a domino that just tips over does not topple "
                                     "the next one at this s and d"
                                   : NULL);
}

static const struct column best_columns[] = {
    {"s", "h", "the separation that allows the largest growth", 0},
    {"r_max", "", "that growth", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_best(struct session *session, const struct call *call)
{
    const struct domq_compute compute = session_compute(session);
    struct domq_best best = {.s = DOMQ_NAN, .r_max = DOMQ_NAN};
    enum dom_status status = domq_limit_best(&session->train, &compute, &best);
    if (status != DOM_OK && status != DOM_NO_GROWTH)
        return session_status(session, status);
    return answer_row(call->answer, ROW(CELL_OF(best, s), CELL_OF(best, r_max)),
                      status == DOM_OK
                          ? NULL
                          : "no growth possible: dominoes this thick do not topple larger ones at any s");
}

static const struct column curve_columns[] = {
    {"s", "h", "separation", 0},
    {"exact", "", "r_max with the fuel from the energy balance", 0},
    {"paper", "", "r_max with the paper's closed form of the fuel", 0},
    {"pair", "", "r_max of the two-domino model", 0},
    {"reach", "", "1/s", 0},
    {NULL, NULL, NULL, 0},
};

/* A worker's; the first four are the same for all. */
struct curve {
    domq_real from, to, n;
    struct domq_train train;
    struct domq_compute compute;
    struct answer answer;
    bool gaps;
    enum dom_status status; /* of the point that ended it */
};

static bool curve_point(void *own, size_t k, FILE *out)
{
    struct curve *c = own;
    struct domq_limit exact, paper, pair;
    struct answer a = answer_part(&c->answer, out, k == 0);
    domq_real f = c->n > 1 ? (domq_real)k / (c->n - 1) : 0;
    c->train.s = (1 - f) * c->from + f * c->to;
    c->status = limits_find(c->train, &c->compute, &exact, &paper);
    if (c->status == DOM_OK)
        c->status = domq_limit_pair(&c->train, &c->compute, &pair);
    if (c->status != DOM_OK)
        return false;
    answer_cells(&a, cell_real(c->train.s), CELL_OF(exact, r_max), CELL_OF(paper, r_max),
                 CELL_OF(pair, r_max), cell_real(1 / c->train.s));
    c->gaps = c->gaps || exact.ends == DOM_END_NONE || pair.ends == DOM_END_NONE;
    return true;
}

static void curve_gather(void *own, const void *worker)
{
    struct curve *c = own;
    c->gaps = c->gaps || ((const struct curve *)worker)->gaps;
}

static bool run_curve(struct session *session, const struct call *call)
{
    struct curve c = {.from = call->number[0],
                      .to = call->number[1],
                      .n = call->number[2],
                      .train = session->train,
                      .compute = session_compute(session)};
    struct answer *a = call->answer;
    struct cell number = cell_real(0);
    bool by_point;
    if (c.n == 1 && c.from != c.to)
        return session_error(session, "one row cannot cover %g to %g; N is at least 2", (double)c.from,
                             (double)c.to);
    answer_plan(a, ROW(number, number, number, number, number));
    c.answer = *a;
    const struct points points = {
        .total = (size_t)c.n, .point = curve_point, .own = &c, .size = sizeof c, .gather = curve_gather};
    if (!points_answer(session, a, &points, &by_point))
        return by_point ? session_status(session, c.status) : false;
    if (c.gaps)
        answer_say(a, "-: no growth possible; 'rmax S' and 'pair S' say why");
    return true;
}

static const struct column count_columns[] = {
    {"height", "m", "the domino to topple is at least this tall", 0},
    {"r", "", "growth from domino to domino", 0},
    {"dominoes", "", "n, the smallest with first_height r^n >= height", 0},
    {"exact", "", "ln(height / first_height) / ln r", 0},
    {"first_height", "m", "height of the first domino", 0},
    {"last_height", "m", "height of the toppled one, first_height r^n", 0},
    {"feasible", "", "does a train with these s, d, q and r go on?", 8},
    {NULL, NULL, NULL, 0},
};

/* "hollow", "solid", or "q = 3.5". */
static const char *mass_name(domq_real q, char name[32])
{
    const char *word = parameter_word(parameter_find("q"), q);
    if (word)
        snprintf(name, 32, "%s", word);
    else
        snprintf(name, 32, "q = %g", (double)q);
    return name;
}

/* Whether a train goes on; why is the reason where it does not. */
static enum dom_status count_feasible(const struct domq_train *train, const struct domq_compute *compute,
                                      bool *feasible, const char **why)
{
    struct domq_barrier barrier;
    enum dom_status status = domq_barrier_find(train, compute, &barrier);
    *feasible = status == DOM_OK;
    *why = status == DOM_OUT_OF_REACH ? "r s > 1, each domino falls past the next one without touching it"
           : status == DOM_STOPS      ? "the train stops below its barrier"
           : status == DOM_NO_FUEL    ? "there is no fuel, a cycle sets no energy free"
           : status == DOM_LOCKS      ? "friction locks the train"
           : status == DOM_UNDERFLOW  ? "r is so large that nothing is left of the energy"
                                      : NULL;
    return *feasible || *why ? DOM_OK : status;
}

/* For one kind of domino: is this growth possible, and what would the largest one make of the count? */
static bool count_kind(struct session *session, const struct call *call, struct domq_train train,
                       domq_real height)
{
    struct domq_limit limit;
    struct domq_count count = {.dominoes = DOMQ_NAN, .exact = DOMQ_NAN, .last = DOMQ_NAN};
    char name[32], number[WIDE_TEXT], said[96] = "no number of them gets there";
    bool feasible;
    const char *why;
    enum dom_status status = count_feasible(&train, &session->compute, &feasible, &why);
    if (status == DOM_OK)
        status = domq_limit_rmax(&train, &session->compute, &limit);
    if (status != DOM_OK)
        return session_status(session, status);
    if (limit.ends == DOM_END_NONE) {
        answer_say(call->answer, "  %-8s no; not even equal ones keep falling", mass_name(train.q, name));
        return true;
    }
    if (domq_count_find(session->scale.h, height, limit.r_max, &session->compute, &count) == DOM_OK &&
        isfinite(count.dominoes))
        snprintf(said, sizeof said, "%s domino%s", quad_text(count.dominoes, WIDE_DIGITS, number),
                 count.dominoes == 1 ? "" : "es");
    answer_say(call->answer, "  %-8s %-4s the largest is %.6g (ends by %s): %s", mass_name(train.q, name),
               feasible ? "yes;" : "no;", (double)limit.r_max, dom_end_text(limit.ends), said);
    return true;
}

/* The quiz as a person asks it: what the rows do not say. */
static bool count_explain(struct session *session, const struct call *call, const struct domq_train *train,
                          domq_real height)
{
    bool named = false;
    answer_say(call->answer, "\nIs a growth of %.10g possible at s = %.6g?", (double)train->r,
               (double)train->s);
    for (const struct word *w = parameter_find("q")->words; w->name; w++) {
        struct domq_train kind = *train;
        if (strcmp(parameter_word(parameter_find("q"), w->value), w->name) != 0)
            continue; /* a synonym */
        kind.q = w->value;
        named = named || kind.q == train->q;
        if (!count_kind(session, call, kind, height))
            return false;
    }
    return named || count_kind(session, call, *train, height);
}

static bool run_count(struct session *session, const struct call *call)
{
    const struct domq_compute compute = session_compute(session);
    domq_real height = call->number[0], first = session->scale.h;
    struct domq_train train = session->train;
    struct domq_count count;
    bool feasible;
    const char *why;
    char number[WIDE_TEXT], growth[WIDE_TEXT], tall[WIDE_TEXT];
    train.r = argument_or(call, 1, train.r);
    if (domq_count_find(first, height, train.r, &compute, &count) != DOM_OK)
        return session_no_answer(
            session, "H = %s m, h = %s m, r = %s: the number of dominoes cannot be counted in %s precision",
            quad_shown(height).text, quad_shown(first).text, quad_shown(train.r).text,
            domq_arithmetic(compute.precision)->name);
    enum dom_status status = count_feasible(&train, &session->compute, &feasible, &why);
    if (status != DOM_OK)
        return session_status(session, status);

    struct answer *a = call->answer;
    if (count.dominoes == 0)
        answer_say(a, "No domino is needed: the first is %s m tall already.\n", quad_text(first, 6, tall));
    else if (isfinite(count.dominoes))
        answer_say(a, "%s domino%s, each %s times as large as the one before, %s one of %s m.\n",
                   quad_text(count.dominoes, WIDE_DIGITS, number), count.dominoes == 1 ? "" : "es",
                   quad_text(train.r, (int)a->style.digits, growth),
                   !feasible             ? "would be needed to topple"
                   : count.dominoes == 1 ? "topples"
                                         : "topple",
                   quad_text(height, 6, tall));
    else
        why = "r = 1: the dominoes do not grow, no number of them is enough";
    char reason[160], name[32];
    answer_holds(a, feasible && isfinite(count.dominoes));
    if (!feasible)
        snprintf(reason, sizeof reason, "not possible at s = %.6g with %s dominoes: %s", (double)train.s,
                 mass_name(train.q, name), why);
    else if (why)
        snprintf(reason, sizeof reason, "%s", why);
    answer_row(a,
               ROW(cell_real(height), cell_real(train.r), cell_count(count.dominoes), CELL_OF(count, exact),
                   cell_real(first), CELL_OF(count, last), cell_flag(feasible)),
               why ? reason : NULL);
    return !answer_for_people(a) || count_explain(session, call, &train, height);
}

#define SEPARATION .name = "S", .kind = ARGUMENT_OF, .of = "s", .optional = true

const struct command limit_commands[] = {
    {.name = "rmax",
     .synonyms = "maximum ratio factor larger",
     .train = true,
     .argument = {{SEPARATION}},
     .summary = "the largest growth r at separation S (or s)",
     .equation = "(c8), section 'A general domino train'",
     .help = "The first r, raised from 1, at which the kinetic energy no longer reaches the barrier; or 1/s, "
             "beyond which a domino falls past the next one.",
     .example = "set q hollow; rmax 0.3",
     .see = "best curve pair count",
     .echo = "s",
     .principal = "r_max",
     ANSWER(rmax)},
    {.name = "pair",
     .synonyms = "two maximum",
     .train = true,
     .argument = {{SEPARATION}},
     .summary = "the largest growth for two: the first just tips over",
     .equation = "(b5) (b11) (b13)",
     .example = "pair 0.3",
     .see = "rmax curve",
     .echo = "s",
     .principal = "r_max",
     ANSWER(pair)},
    {.name = "best",
     .synonyms = "optimum optimal spacing distance maximum",
     .train = true,
     .summary = "the separation that allows the largest growth",
     .example = "best",
     .see = "rmax curve",
     .principal = "s",
     ANSWER(best)},
    {.name = "curve",
     .synonyms = "graph figure table",
     .train = true,
     .argument = {{.name = "FROM", .kind = ARGUMENT_OF, .of = "s"},
                  {.name = "TO", .kind = ARGUMENT_OF, .of = "s"},
                  {.name = "N", .kind = ARGUMENT_COUNT}},
     .summary = "the largest growth at N separations: the paper's figures",
     .example = "set q hollow; curve 0.1 0.9 5",
     .see = "rmax pair best",
     .rows = true,
     ANSWER(curve)},
    {.name = "count",
     .synonyms = "quiz tower building Domtoren height number tall",
     .argument = {{.name = "H", .kind = ARGUMENT_HEIGHT},
                  {.name = "R", .kind = ARGUMENT_OF, .of = "r", .optional = true}},
     .summary = "how many dominoes topple one H tall, at growth R (or r)",
     .help = "n is the smallest integer with h r^n >= H: n dominoes, the first h tall, topple one that is "
             "at least H tall.",
     .example = "count 112 m 2",
     .see = "rmax best",
     .echo = "r",
     .principal = "dominoes",
     .holds = "the growth is possible, and gets there",
     ANSWER(count)},
    {.name = NULL},
};
