/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands placement and budget, and the table of all commands about rows with random errors. */
#include "commands/rows/rows.h"
#include "commands/tables.h"
#include "language/quad.h"
#include "parallel/workers.h"
#include <stdlib.h>

/* A row that is set up many times with random errors. Do not copy this struct: it contains a pointer to the
 * pool inside it. */
struct trials {
    struct scene_row scene;
    struct domq_placement placement;
    struct task_pool pool;
};

/* Makes the row and the parameters of its random errors. If this fails, sets *problem and returns false;
 * nothing needs to be freed then. */
static bool trials_make(const struct query *query, struct problem *problem, domq_real rows, bool progress,
                        struct trials *t)
{
    const struct effect_state *errors = &query->scene->effect[DOM_EFFECT_placement];
    if (!scene_row_make(query->scene, &t->scene, problem))
        return false;
    t->pool = (struct task_pool){.threads = query->state->settings.threads,
                                 .progress = progress,
                                 .interrupt = query->scene->compute.interrupt};
    t->placement = (struct domq_placement){
        .sigma = errors->on ? errors->value[0] : 0,
        .heights = errors->on ? errors->value[1] : 0,
        .seed = (unsigned long)query->scene->seed,
        .rows = (size_t)rows,
        .parallel = workers_tasks,
        .pool = &t->pool,
    };
    return true;
}

/* ---- placement ---- */

static bool placement_answer(const struct query *query, struct answer *a, struct problem *problem,
                             const struct trials *t)
{
    const struct domq_placement *p = &t->placement;
    const size_t count = t->scene.row.count;
    struct domq_study study = {.rows = 0};
    char partial[80];
    size_t *stops = calloc(count, sizeof *stops);
    enum dom_status status =
        stops ? domq_placement_study(&t->scene.row, &t->scene.compute, p, &study, stops) : DOM_NO_MEMORY;
    /* Within a sweep, an interrupted study has no answer. */
    bool interrupted = status == DOM_INTERRUPTED && study.rows > 0 && !a->sink;
    snprintf(partial, sizeof partial, "interrupted after %zu of %zu rows", study.rows, p->rows);
    if (status == DOM_OK || interrupted)
        study_answer(a, p->sigma, p->heights, &study, stops, count, interrupted ? partial : NULL);
    free(stops);
    return status == DOM_OK || row_status(query, problem, status);
}

static bool run_placement(const struct query *query, struct answer *a, struct problem *problem)
{
    struct trials t;
    if (!trials_make(query, problem, query->given->count > 0 ? query->given->number[0] : 2000, true, &t))
        return false;
    bool done = !query->scene->effect[DOM_EFFECT_placement].on
                    ? problem_error(problem, "this command needs random errors; first enter 'effect "
                                             "placement 1 mm'")
                : query->means->shard.parts > 0 ? study_blocks(query, a, problem, &t.scene, &t.placement)
                                                : placement_answer(query, a, problem, &t);
    free(t.scene.domino);
    return done;
}

/* ---- budget ---- */

static const struct column budget_columns[] = {
    {"probability", "share", "the share of the rows that fall completely", 0},
    {"sigma", "m", "the standard deviation of the gaps with which this share falls", 0},
    {"low", "m", "the lower end of the 95 % interval of sigma", 0},
    {"high", "m", "the upper end of this interval; more rows make it narrower", 0},
    {"rows", "", "the number of rows that were set up at each sigma", 0},
    {NULL, NULL, NULL, 0},
};

/* Returns 100 or 1000 if the share is a whole number of rows out of 100 or out of 1000. Returns 0 if it is
 * neither. */
static int rows_of(domq_real share)
{
    for (int of = 100; of <= 1000; of *= 10)
        if (quad(fabs)(share * of - quad(round)(share * of)) < (domq_real)1e-9)
            return of;
    return 0;
}

/* Returns a phrase such as "95 of 100" or "999 of 1000". If neither form is exact, returns one such as "99.95
 * % of the". */
static struct words share_words(domq_real share)
{
    struct words words;
    const int of = rows_of(share);
    if (of)
        snprintf(words.text, sizeof words.text, "%.0f of %d", round((double)share * of), of);
    else
        snprintf(words.text, sizeof words.text, "%s of the", measured(share, "share", 6).text);
    return words;
}

/* Rounds sigma down to two digits. Rounding down is safe, because more rows fall with a smaller sigma. */
static domq_real two_digits(domq_real sigma)
{
    return round_digits(sigma * (1 + (domq_real)1e-12), 2, false);
}

/* Runs a study with sigma rounded to two digits, and prints how precisely to place the gaps and how many rows
 * then fall. */
static enum dom_status budget_say(struct answer *a, const struct trials *t, const struct domq_budget *budget,
                                  domq_real share)
{
    struct domq_placement at = t->placement;
    struct domq_study study;
    at.sigma = two_digits(budget->sigma);
    enum dom_status status = domq_placement_study(&t->scene.row, &t->scene.compute, &at, &study, NULL);
    if (status != DOM_OK)
        return status;
    const int of = rows_of(share), digits = of ? 0 : 2;
    const double digit = pow(10, -digits), scale = of ? of : 100;
    answer_say(a, "Place the gaps within %s (one standard deviation): then %s rows fall (%.*f to %.*f%s).",
               measured(at.sigma, "m", 2).text, share_words(share).text, digits,
               floor(scale * study.low / digit) * digit, digits, ceil(scale * study.high / digit) * digit,
               of ? "" : " %");
    return DOM_OK;
}

/* Prints what the search had found when ^C interrupted it. */
static void interrupted_say(struct answer *a, const struct domq_budget *b, domq_real share)
{
    const bool open = !isfinite(b->high);
    answer_say(a, "Interrupted: with gaps placed within %s at least %s rows fall%s%s.",
               measured(two_digits(b->sigma), "m", 2).text, share_words(share).text,
               open ? "; how many fall with larger errors is not known" : ", and fewer with ",
               open ? "" : measured(b->high, "m", 2).text);
}

static bool run_budget(const struct query *query, struct answer *a, struct problem *problem)
{
    struct trials t;
    struct domq_budget budget = {.sigma = 0};
    domq_real share = query->given->number[0],
              rows = query->given->count > 1 ? query->given->number[1] : 1000;
    if (!(share > 0 && share < 1))
        return problem_error(problem,
                             "P = %s is out of range; P is a probability between 0 and 1, such as 0.9",
                             quad_shown(share).text);
    if (!trials_make(query, problem, rows, false /* how many studies the search takes is not known */, &t))
        return false;
    enum dom_status status =
        domq_placement_budget(&t.scene.row, &t.scene.compute, &t.placement, (double)share, &budget);
    bool any = !isfinite(budget.sigma);
    if (status == DOM_OK && !any && answer_for_people(a))
        status = budget_say(a, &t, &budget, share);
    free(t.scene.domino);
    if (status == DOM_STOPS)
        return problem_no_answer(problem,
                                 t.placement.heights > 0
                                     ? "even with exact gaps fewer rows than that fall; enter a smaller P"
                                     : "even with exact gaps the row does not fall; 'mend' finds a "
                                       "change that saves it");
    const bool interrupted = status == DOM_INTERRUPTED && budget.sigma > 0 && !any;
    if (status != DOM_OK && !interrupted)
        return row_status(query, problem, status);
    if (interrupted)
        interrupted_say(a, &budget, share);
    const int digits = interrupted ? 4 : 0;
    answer_row(a,
               ROW(cell_real(share), cell_narrow(budget.sigma, digits), cell_narrow(budget.low, digits),
                   cell_narrow(budget.high, digits), cell_count(rows)),
               any ? "more rows than that fall even if errors are as large as the largest gap"
               : interrupted && !answer_for_people(a) ? "interrupted: the answer is between low and high"
                                                      : NULL);
    return !interrupted || row_status(query, problem, status);
}

/* ---- The table of commands ---- */

const struct command study_commands[] = {
    {.name = "placement",
     .synonyms = "probability chance random risk precision",
     .argument = {{.name = "ROWS", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "the probability that all fall, and where rows stop",
     .help = "Sets up the row ROWS times (2000 if ROWS is left out), each gap with a random error: first "
             "enter 'effect placement 1 mm'. With the same 'seed', row number i is always the same, with any "
             "number of 'threads'. ^C ends the study, and the answer is then about the rows so far. With "
             "'domino --shard 2/7' the answer is the second of seven parts of the study: counts for blocks "
             "of 100 rows, which 'pool' adds up.",
     .example = "effect row 13; effect placement 8 mm; placement 500",
     .see = "pool budget effect",
     .principal = "probability",
     ANSWER(placement)},
    {.name = "pool",
     .synonyms = "cluster parallel merge combine add",
     .argument = {{.name = "FILE", .kind = ARGUMENT_FILE}},
     .summary = "the answer of 'placement', from the parts of a study",
     .help = "FILE, or '-' for standard input, has the outputs of 'domino --shard I/N' with 'set output csv' "
             "and 'placement' for all I, concatenated in any order. The answer is that of the whole study, "
             "digit for digit. If rows are missing, the answer says so; it is an error if rows are there "
             "twice, or if blocks are of different studies.",
     .see = "placement",
     .columns = placement_columns,
     .unswept = "it reads a file",
     .principal = "probability",
     .files = true,
     .run = run_pool},
    {.name = "budget",
     .synonyms = "probability chance random precision spacing tolerance",
     .argument = {{.name = "P", .kind = ARGUMENT_ANY, .of = "share"},
                  {.name = "ROWS", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "how precise gaps must be to fall with probability P",
     .help = "Finds the standard deviation of the gaps, sigma, at which the share P of ROWS rows falls (1000 "
             "rows if ROWS is left out). The random rows are the same at every sigma. The numbers after the "
             "share are its 95 % interval. With 'effect placement 1 mm 0.01' heights have random errors, "
             "too; the errors of gaps in this effect are not used. ^C ends the search, and the answer is "
             "then what it has found so far.",
     .example = "effect row 13; budget 0.9 200",
     .see = "placement mend",
     .principal = "sigma",
     ANSWER(budget)},
    {.name = "slip",
     .synonyms = "foot feet slide slippery ground",
     .train = true,
     .summary = "the friction of the floor with which no foot slips",
     .help = "Finds the largest friction that the foot of any moving domino needs during the cycle: while "
             "dominoes fall, and separately in the instant of a hit.",
     .example = "effect floor 0.5; slip",
     .see = "effect fall",
     .principal = "motion",
     ANSWER(slip)},
    {.name = NULL},
};
