/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Studies of many random rows: the commands 'placement' and 'budget'. */
#include "chance/chance.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

bool trials_make(const struct query *query, struct problem *problem, size_t rows, bool progress,
                 struct trials *t)
{
    if (!errors_check(query->scene, problem) || !scene_row_make(query->scene, &t->scene, problem))
        return false;
    const enum dom_status status = scene_row_in_double(&t->scene, &t->row);
    free(t->scene.domino);
    if (status != DOM_OK)
        return query_status(query, problem, status);
    t->pool = (struct task_pool){.threads = query->state->settings.threads,
                                 .progress = progress,
                                 .interrupt = query->scene->compute.interrupt};
    t->placement = (struct dom_placement){
        .seed = (unsigned long)query->scene->seed,
        .rows = rows,
        .parallel = workers_tasks,
        .pool = &t->pool,
    };
    t->has_errors = scene_errors(query->scene, t->placement.error);
    return true;
}

bool study_run(const struct query *query, struct problem *problem, size_t rows, struct dom_study *study,
               struct dom_random_error error[DOM_ERROR_COUNT])
{
    struct trials t;
    if (!trials_make(query, problem, rows, true, &t))
        return false;
    memcpy(error, t.placement.error, sizeof t.placement.error);
    const enum dom_status status =
        t.has_errors ? dom_placement_study(&t.row.row, &t.row.compute, &t.placement, study, NULL) : DOM_OK;
    free(t.row.domino);
    return row_status(query, problem, status);
}

bool problem_no_errors(struct problem *problem, const char *what)
{
    return problem_error(
        problem,
        "%s needs random errors; first enter 'set placement 1 mm', or another error, such as "
        "'set error_thickness 1 %%'",
        what);
}

struct words study_words(const struct dom_study *s)
{
    struct words words;
    snprintf(words.text, sizeof words.text, "%zu of %zu rows fall (%.40s to %.40s)", s->fall, s->rows,
             measured((domq_real)s->low, "share", s->low > 0.99 ? 5 : 3).text,
             measured((domq_real)s->high, "share", s->high > 0.99 ? 5 : 3).text);
    return words;
}

/* ---- placement ---- */

static const struct column placement_columns[] = {
    {"sigma", "m", "standard deviation of the errors in the gaps; for uniform errors, the largest error", 0},
    {"heights", "share",
     "standard deviation of relative errors in the heights; for uniform errors, the largest error", 0},
    {"rows", "", "the number of rows that were set up", 0},
    {"fall", "", "the number of rows that fall completely", 0},
    {"probability", "share", "fall / rows", 0},
    {"low", "share", "the lower end of the 95 % interval of the probability", 0},
    {"high", "share", "the upper end of the 95 % interval of the probability", 0},
    {"unknown", "", "the number of rows that the model cannot decide; they widen the interval", 0},
    {"stops_most", "", "the domino at which rows stop most often", 0},
    {"errors", "", "all errors of the rows, each with its size", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_placement(const struct query *query, struct answer *a, struct problem *problem)
{
    struct trials t;
    struct dom_study s = {.rows = 0};
    char partial[80], errors[ERRORS_TEXT];
    const size_t rows = query->given->count > 0 ? (size_t)query->given->number[0] : 2000;
    if (!trials_make(query, problem, rows, true, &t))
        return false;
    const size_t count = t.row.row.count;
    size_t *stops = calloc(count, sizeof *stops), most = 0; /* how many rows stop at each domino */
    const enum dom_status status =
        !stops         ? DOM_NO_MEMORY
        : t.has_errors ? dom_placement_study(&t.row.row, &t.row.compute, &t.placement, &s, stops)
                       : DOM_OK;
    /* Within a sweep, an interrupted study has no answer. */
    const bool interrupted = status == DOM_INTERRUPTED && s.rows > 0 && !a->sink.take;
    snprintf(partial, sizeof partial, "interrupted after %zu of %zu rows", s.rows, rows);
    if (s.rows > 0 && (status == DOM_OK || interrupted)) {
        const size_t others = s.rows - s.fall - s.unknown;
        for (size_t k = 1; k < count; k++)
            most = stops[k] > stops[most] ? k : most;
        answer_say(a, "%s, with 95 %% confidence.", study_words(&s).text);
        if (others > 0)
            answer_say(a, "The %srows stop most often at domino %zu (%.3g %% of them).",
                       others < s.rows ? "other " : "", most + 1, 100 * (double)stops[most] / (double)others);
        answer_row(a,
                   ROW(cell_real((domq_real)t.placement.error[DOM_ERROR_gap].size),
                       cell_real((domq_real)t.placement.error[DOM_ERROR_height].size),
                       cell_count((domq_real)s.rows), cell_count((domq_real)s.fall),
                       cell_computed((domq_real)s.fall / (domq_real)s.rows), cell_computed((domq_real)s.low),
                       cell_computed((domq_real)s.high), cell_count((domq_real)s.unknown),
                       others > 0 ? cell_count((domq_real)most + 1) : cell_real(DOMQ_NAN),
                       cell_word(errors_text(t.placement.error, false, errors))),
                   interrupted ? partial : NULL);
    }
    free(stops);
    free(t.row.domino);
    return t.has_errors || status != DOM_OK ? row_status(query, problem, status)
                                            : problem_no_errors(problem, "this command");
}

/* ---- budget ---- */

static const struct column budget_columns[] = {
    {"probability", "share", "the share of the rows that fall completely", 0},
    {"sigma", "m", "the largest errors in the gaps at which the share 'probability' of the rows falls", 0},
    {"low", "m", "the lower end of the 95 % interval of sigma", 0},
    {"high", "m", "the upper end of the 95 % interval of sigma; more rows narrow the interval", 0},
    {"rows", "", "the number of rows that were set up at each sigma", 0},
    {"scaled", "", "the kind of error whose size is sigma; 'all' if sigma multiplies all errors", 0},
    {NULL, NULL, NULL, 0},
};

/* Prints the largest error that the row may have, rounded down to two digits, which is safe: more rows fall
 * with a smaller error. Runs rows with this error and prints how many of them fall. */
static enum dom_status budget_say(struct answer *a, const struct trials *t, enum dom_error_of kind,
                                  double sigma)
{
    struct dom_placement at = t->placement;
    struct dom_study study;
    const domq_real size = round_digits((domq_real)sigma * (1 + (domq_real)1e-12), 2, false);
    const bool all = kind == DOM_ERROR_COUNT,
               is_added = kind == DOM_ERROR_friction || kind == DOM_ERROR_floor;
    const char *unit = error_kinds[kind].unit;
    for (int k = 0; k < DOM_ERROR_COUNT; k++)
        if (all)
            at.error[k].size *= (double)size;
        else if (k == (int)kind)
            at.error[k].size = (double)size;
    const enum dom_status status = dom_placement_study(&t->row.row, &t->row.compute, &at, &study, NULL);
    if (status != DOM_OK)
        return status;
    if (all)
        answer_say(a, "All errors may be %s times as large as they are now: then %s, with 95 %% confidence.",
                   measured(size, "", 2).text, study_words(&study).text);
    else
        answer_say(a, "The error of the %s may be %s (%s): then %s, with 95 %% confidence.",
                   error_kinds[kind].name, measured(size, *unit || is_added ? unit : "share", 2).text,
                   at.error[kind].uniform ? "limits of uniform errors" : "one standard deviation",
                   study_words(&study).text);
    return DOM_OK;
}

static bool run_budget(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct arguments *given = query->given;
    struct trials t;
    struct dom_budget b = {.sigma = 0};
    const domq_real share = given->number[0];
    const enum dom_error_of of = given->count > 2 ? (enum dom_error_of)given->number[2] : DOM_ERROR_gap;
    const struct error_kind *kind = &error_kinds[of];
    if (!(share > 0 && share < 1))
        return problem_error(problem,
                             "P = %s is out of range; P is a probability between 0 and 1, such as 0.9",
                             quad_text(share, 10));
    /* No progress is shown, because the number of studies is not known in advance. */
    if (!trials_make(query, problem, given->count > 1 ? (size_t)given->number[1] : 1000, false, &t))
        return false;
    struct scene with = *query->scene; /* with errors of this kind; shares the dominoes of query->scene */
    bool good = of == DOM_ERROR_COUNT ? t.has_errors || problem_no_errors(problem, "'all'")
                                      : effect_check_needs(query->scene, error_effect((int)of), problem);
    if (good && of != DOM_ERROR_COUNT) {
        effect_put(&with, error_effect((int)of), kind->effect.argument[0].usual, NULL);
        good = errors_check(&with, problem);
    }
    enum dom_status status =
        good ? dom_placement_budget(&t.row.row, &t.row.compute, &t.placement, of, (double)share, &b) : DOM_OK;
    const bool any = !isfinite(b.sigma);
    if (good && status == DOM_OK && !any && answer_for_people(a))
        status = budget_say(a, &t, of, b.sigma);
    free(t.row.domino);
    if (status == DOM_STOPS)
        return problem_no_answer(
            problem,
            "even without %s%s, fewer rows fall than P asks for; if 'verdict' says that the row stops, try "
            "'mend'; otherwise enter a smaller P, or make the other errors smaller",
            of < DOM_ERROR_COUNT ? "an error in the " : "any error", of < DOM_ERROR_COUNT ? kind->name : "");
    if (!good || status != DOM_OK)
        return good && row_status(query, problem, status);
    for (int i = 1; i < 4 && *kind->unit != 'm'; i++)
        answer_describe(a, budget_columns[i].key, kind->unit, NULL);
    if (of != DOM_ERROR_gap)
        answer_describe(a, "sigma", NULL,
                        "the largest error, or factor for all errors, at which the share 'probability' of "
                        "the rows falls");
    return answer_row(a,
                      ROW(cell_real(share), cell_narrow((domq_real)b.sigma, 0),
                          cell_narrow((domq_real)b.low, 0), cell_narrow((domq_real)b.high, 0),
                          cell_count((domq_real)t.placement.rows), cell_word(kind->name)),
                      any ? "more rows fall than P asks for, even with the largest errors that are tried"
                          : NULL);
}

static const struct parameter seed = {
    .name = "seed",
    .offset = offsetof(struct state, scene.seed),
    .meaning = "seed of the random numbers: the same seed gives the same random rows",
    .value = (const struct domq_effect_argument[]){{.name = "seed",
                                                    .unit = "",
                                                    .highest = (domq_real)4294967295.0,
                                                    .usual = SEED_DEFAULT,
                                                    .whole = true}},
    .synonyms = "random chance"};

/* A names_list (see names.h) of the kinds, with "all" as its last name. */
static const char *error_names(const void *context, int k)
{
    (void)context;
    return k <= DOM_ERROR_COUNT ? error_kinds[k].name : NULL;
}

static const struct command study_commands[] = {
    {.name = "placement",
     .precision = PRECISION_DOUBLE,
     .synonyms = "probability chance random risk precision",
     .argument = {{.name = "ROWS", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "the probability that the whole row falls, and where rows stop",
     .help = "Sets up the row ROWS times (2000 if ROWS is left out), with the random errors of the scene. "
             "First turn on at least one kind of error: 'set placement 1 mm' for errors in the gaps or, "
             "for example, 'set error_thickness 1 %' or 'set error_friction 0.05'. To see how much an error "
             "matters, turn it off: the random numbers of the other errors stay the same. With the same "
             "'seed', row number i is always the same, whatever the number of 'threads'. ^C ends the study, "
             "and the answer then covers only the rows that have been run.",
     .example = "set row 13; set placement 3 mm; set error_thickness 5 %; placement 500",
     .see = "budget effects",
     .principal = "probability",
     .brief = "",
     ANSWER(placement)},
    {.name = "budget",
     .precision = PRECISION_DOUBLE,
     .synonyms = "probability chance random precision spacing tolerance",
     .argument =
         {{.name = "P", .kind = ARGUMENT_ANY, .noun = "share"},
          {.name = "ROWS", .kind = ARGUMENT_COUNT, .optional = true},
          {.name = "E", .kind = ARGUMENT_CHOICE, .noun = "error", .choices = error_names, .optional = true}},
     .summary = "how precise gaps (or property E) must be for rows to fall with probability P",
     .help = "Finds how large the errors in the gaps may be for the share P of the rows to fall. The answer "
             "is sigma with its 95 % interval. Sigma is the standard deviation of these errors or, if they "
             "are uniform, their limit. Each sigma is tried on ROWS random rows (1000 if ROWS is left out), "
             "with the same random numbers. All other errors of the scene stay as they are. 'budget 0.95 "
             "1000 thickness' finds the size of another error in the same way. 'budget 0.95 1000 all' finds "
             "the factor by which all errors of the scene may be multiplied.",
     .example = "set row 13; budget 0.9 200; budget 90 % 200 thickness",
     .see = "placement mend",
     .principal = "sigma",
     .brief = "",
     ANSWER(budget)},
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"Rows with random errors", "chances", study_commands},
    {NULL, NULL, NULL},
};

#define KIND(kind) &error_kinds[DOM_ERROR_##kind].parameter
const struct feature chance_feature = {
    .name = "chance",
    .groups = groups,
    .parameters = (const struct parameter *const[]){&seed, KIND(gap), KIND(place), KIND(thickness),
                                                    KIND(mass), KIND(lean), KIND(radius), KIND(friction),
                                                    KIND(slope), KIND(floor), KIND(push), NULL}};
