/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands about rows with random errors, and about the friction of the floor. */
#include "commands/rows/falling.h"
#include "commands/rows/feet.h"
#include "commands/tables.h"
#include "language/quad.h"
#include "parallel/workers.h"
#include <stdlib.h>
#include <string.h>

/* Makes the row and its random errors. Reports an error if they are needed and there are none. */
static bool study_make(const struct query *query, struct problem *problem, domq_real rows, bool needed,
                       struct task_pool *pool, struct scene_row *scene, struct domq_placement *p)
{
    const struct effect_state *errors = &query->scene->effect[DOM_EFFECT_placement];
    if (!scene_row_make(query->scene, scene, problem))
        return false;
    if (!errors->on && needed) {
        free(scene->domino);
        problem_error(problem, "this command needs random errors; first enter 'effect placement 1 mm'");
        return false;
    }
    *p = (struct domq_placement){
        .sigma = errors->on ? errors->value[0] : 0,
        .heights = errors->on ? errors->value[1] : 0,
        .seed = (unsigned long)query->scene->seed,
        .rows = (size_t)rows,
        .parallel = workers_tasks,
        .pool = pool,
    };
    pool->threads = query->state->settings.threads;
    pool->interrupt = query->scene->compute.interrupt;
    return true;
}

/* ---- placement ---- */

static bool placement_all(const struct query *query, struct answer *a, struct problem *problem,
                          const struct scene_row *scene, const struct domq_placement *p)
{
    struct domq_study study = {.rows = 0};
    char partial[80];
    size_t *stops = calloc(scene->row.count, sizeof *stops);
    enum dom_status status =
        stops ? domq_placement_study(&scene->row, &scene->compute, p, &study, stops) : DOM_NO_MEMORY;
    bool interrupted = status == DOM_INTERRUPTED && study.rows > 0 && !a->point; /* no point of a sweep */
    snprintf(partial, sizeof partial, "interrupted after %zu of %zu rows", study.rows, p->rows);
    if (status == DOM_OK || interrupted)
        study_answer(a, p->sigma, p->heights, &study, stops, scene->row.count, interrupted ? partial : NULL);
    free(stops);
    return status == DOM_OK || row_status(query, problem, status);
}

static bool run_placement(const struct query *query, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    struct domq_placement p;
    struct task_pool pool = {.progress = true};
    domq_real rows = query->given->count > 0 ? query->given->number[0] : 2000;
    if (!study_make(query, problem, rows, true, &pool, &scene, &p))
        return false;
    bool done = query->means->shard.parts > 0 ? study_blocks(query, a, problem, &scene, &p)
                                              : placement_all(query, a, problem, &scene, &p);
    free(scene.domino);
    return done;
}

/* ---- budget ---- */

static const struct column budget_columns[] = {
    {"probability", "share", "share of the rows that fall completely", 0},
    {"sigma", "m", "standard deviation of the gaps that allows this", 0},
    {"low", "m", "95 % interval of sigma, from here ...", 0},
    {"high", "m", "... to here: more rows make it narrower", 0},
    {"rows", "", "number of rows that were set up at each sigma", 0},
    {NULL, NULL, NULL, 0},
};

/* Writes a share: "95 of 100", or "99.95 %" if it is not a whole number of 1000. */
enum { SHARE_OF = CELL_TEXT + 16 };
static const char *share_of(domq_real share, char text[SHARE_OF])
{
    for (int of = 100; of <= 1000; of *= 10) {
        domq_real number = quad(round)(share * of);
        if (quad(fabs)(share * of - number) < (domq_real)1e-9) {
            snprintf(text, SHARE_OF, "%.0f of %d", (double)number, of);
            return text;
        }
    }
    snprintf(text, SHARE_OF, "%s of the", measured(share, "share", 6).text);
    return text;
}

/* Returns sigma with two digits, rounded down, so that not fewer rows fall. */
static domq_real two_digits(domq_real sigma)
{
    domq_real digit = quad(pow)(10, quad(floor)(quad(log10)(sigma)) - 1);
    return quad(floor)(sigma / digit * (1 + (domq_real)1e-12)) * digit;
}

/* Says how precisely to place the gaps, and between which shares the rows fall then. */
static enum dom_status budget_say(struct answer *a, const struct scene_row *scene,
                                  const struct domq_placement *p, const struct domq_budget *budget,
                                  domq_real share)
{
    struct domq_placement at = *p;
    struct domq_study study;
    char text[SHARE_OF];
    at.sigma = two_digits(budget->sigma);
    enum dom_status status = domq_placement_study(&scene->row, &scene->compute, &at, &study, NULL);
    if (status != DOM_OK)
        return status;
    share_of(share, text);
    double of = strstr(text, "of 1000") ? 1000 : 100;
    int digits = strchr(text, '%') ? 2 : 0; /* rounded outwards */
    double digit = pow(10, -digits);
    answer_say(a, "Place the gaps within %s (one standard deviation): then %s rows fall (%.*f to %.*f%s).",
               measured(at.sigma, "m", 2).text, text, digits, floor(of * study.low / digit) * digit, digits,
               ceil(of * study.high / digit) * digit, digits ? " %" : "");
    return DOM_OK;
}

/* Answers with what was found before ^C. */
static void budget_partial(struct answer *a, const struct domq_budget *b, domq_real share, domq_real rows)
{
    static const char partial[] = "interrupted: the answer is between low and high";
    char text[SHARE_OF];
    bool open = !isfinite(b->high);
    if (answer_for_people(a))
        answer_say(a, "Interrupted: with gaps placed within %s at least %s rows fall%s%s.",
                   measured(two_digits(b->sigma), "m", 2).text, share_of(share, text),
                   open ? "; how many fall with larger errors is not known" : ", and fewer with ",
                   open ? "" : measured(b->high, "m", 2).text);
    answer_row(a,
               ROW(cell_real(share), cell_narrow(b->sigma, 4), cell_narrow(b->low, 4),
                   cell_narrow(b->high, 4), cell_count(rows)),
               answer_for_people(a) ? NULL : partial);
}

static bool run_budget(const struct query *query, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    struct domq_placement p;
    struct domq_budget budget = {.sigma = 0};
    struct task_pool pool = {.progress = false}; /* how many studies it takes is not known */
    domq_real share = query->given->number[0],
              rows = query->given->count > 1 ? query->given->number[1] : 1000;
    if (!(share > 0 && share < 1))
        return problem_error(problem,
                             "P = %s is out of range; P is a probability between 0 and 1, such as 0.9",
                             quad_shown(share).text);
    if (!study_make(query, problem, rows, false, &pool, &scene, &p))
        return false;
    enum dom_status status = domq_placement_budget(&scene.row, &scene.compute, &p, (double)share, &budget);
    bool any = !isfinite(budget.sigma);
    if (status == DOM_OK && !any && answer_for_people(a))
        status = budget_say(a, &scene, &p, &budget, share);
    free(scene.domino);
    if (status == DOM_STOPS)
        return problem_no_answer(problem, p.heights > 0
                                              ? "even with exact gaps fewer rows fall; enter a smaller P"
                                              : "even with exact gaps the row does not fall; 'mend' finds a "
                                                "change that saves it");
    if (status == DOM_INTERRUPTED && budget.sigma > 0 && !any)
        budget_partial(a, &budget, share, rows);
    if (status != DOM_OK)
        return row_status(query, problem, status);
    return answer_row(a,
                      ROW(cell_real(share), cell_bound(budget.sigma, DOMQ_NAN),
                          cell_bound(budget.low, DOMQ_NAN), cell_bound(budget.high, DOMQ_NAN),
                          cell_count(rows)),
                      any ? "even with errors as large as the largest gap more rows fall" : NULL);
}

/* ---- slip ---- */

static const struct column slip_columns[] = {
    {"motion", "", "friction that feet need while dominoes fall: the largest |R_x| / R_z", 0},
    {"theta", "rad", "tilt of the head at that moment", 0},
    {"domino", "", "the domino that needs it: 0 = head, 1, 2, ... its followers", 0},
    {"hit", "", "friction that they need in the instant of a hit: the largest ratio of impulses", 0},
    {"hit_domino", "", "the domino that needs it", 0},
    {"slips", "", "yes if a foot slips while dominoes fall, on the floor of 'effect floor'", 0},
    {"slips_hit", "", "yes if a foot slips in the instant of a hit on that floor", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_slip(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_floor f;
    const struct effect_state *floor = &query->scene->effect[DOM_EFFECT_floor];
    enum dom_status status = domq_cycle_floor(&query->scene->train, &query->scene->compute, &f);
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    bool slips = f.motion > floor->value[0], slips_hit = f.hit > floor->value[0];
    answer_row(a,
               ROW(cell_narrow(f.motion, 6), cell_bound(f.theta, DOMQ_NAN), cell_count((domq_real)f.domino),
                   cell_bound(f.hit, DOMQ_NAN), cell_count((domq_real)f.hit_domino),
                   floor->on ? cell_flag(slips) : cell_real(DOMQ_NAN),
                   floor->on ? cell_flag(slips_hit) : cell_real(DOMQ_NAN)),
               !isfinite(f.motion) || !isfinite(f.hit)
                   ? "a domino is lifted off the floor, which no friction prevents"
                   : NULL);
    if (floor->on)
        answer_say(a, "On a floor with a friction of %.4g %s while dominoes fall, and %s in a collision.",
                   (double)floor->value[0], slips ? "feet slip" : "no foot slips",
                   slips_hit ? "feet slip" : "no foot slips");
    if (floor->on && (slips || slips_hit))
        feet_matter(a, slips);
    if (!floor->on)
        answer_say(a, "'effect floor 0.5' sets the friction of the floor; 'fall' then checks a row.");
    return true;
}

const struct command study_commands[] = {
    {.name = "placement",
     .synonyms = "probability chance random risk precision",
     .argument = {{.name = "ROWS", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "the probability that all fall, and where rows stop",
     .help =
         "Sets up the row ROWS times (2000 if ROWS is left out), each gap with a random error: first enter "
         "'effect placement 1 mm'. Row number i is the same for the same 'seed', with any number of "
         "'threads'. ^C ends the study, whose answer is then that of the rows so far. With 'domino --shard "
         "2/7' the answer is the second of seven "
         "parts of the study: counts for blocks of 100 rows, which 'pool' adds up.",
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
             "digit for digit. Missing rows are reported; rows that are there twice and blocks of another "
             "study are errors.",
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
             "share are its 95 % interval. Random heights count too, with 'effect placement 1 mm 0.01'; "
             "its error of the gaps is not used. ^C ends the search with what it has found.",
     .example = "effect row 13; budget 0.9 200",
     .see = "placement mend",
     .principal = "sigma",
     ANSWER(budget)},
    {.name = "slip",
     .synonyms = "foot feet slide slippery ground",
     .train = true,
     .summary = "the friction of the floor with which no foot slips",
     .help = "Finds the largest friction that a foot needs while dominoes fall, over the whole cycle and all "
             "dominoes that move; and, apart, in the instant of a hit.",
     .example = "effect floor 0.5; slip",
     .see = "effect fall",
     .principal = "motion",
     ANSWER(slip)},
    {.name = NULL},
};
