/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kinds of random error, and the commands 'placement' and 'budget' about rows with them. To add a kind,
 * add it to DOM_ERRORS, describe it here, and apply it to a row in model/draw.c. */
#include "chance/chance.h"
#include "interpreter/command.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

/* A kind of random error. Errors in gaps and heights belong to the effect 'placement', which stands with the
 * gaps; every other kind has an effect of its own. */
struct error_kind {
    const char *name, *unit;    /* as in DOM_ERRORS */
    struct parameter parameter; /* the effect as a parameter; not used for heights */
    struct domq_effect effect;
};
/* The numbers of their effects. */
static int error_number[DOM_ERROR_COUNT];

static const char *const distributions[] = {"normal", "uniform", NULL};

/* What the kinds with an effect of their own have in common. `usual_` and `most_` are the usual and the
 * largest size; `to_` is the largest size that 'solve' tries; `needs_` enters the effect that this one needs,
 * and `rows_` is the number of rows in the example. The engine takes a thousand times as long as the model.
 */
#define SIZED(kind, unit_, usual_, most_, to_, needs_, rows_)                                                \
    .name = #kind, .unit = unit_, .parameter.effect = &error_kinds[DOM_ERROR_##kind].effect,                 \
    .parameter.number = &error_number[DOM_ERROR_##kind], .parameter.is_minor = true, .parameter.to = to_,    \
    .parameter.example = "set row on; " needs_ "set error_" #kind " on; placement " rows_,                   \
    .effect.name = "error_" #kind,                                                                           \
    .effect.source = "pseudo-random numbers from GSL: the generators taus2 and mrg",                         \
    .effect.argument[0].name = "SIZE", .effect.argument[0].unit = unit_,                                     \
    .effect.argument[0].usual = (domq_real)(usual_), .effect.argument[0].highest = (domq_real)(most_),       \
    .effect.argument[1] = {                                                                                  \
        .name = "LIMITS",                                                                                    \
        .unit = "",                                                                                          \
        .meaning = "distribution of the error: normal with the standard deviation SIZE, or uniform from "    \
                   "-SIZE to SIZE",                                                                          \
        .highest = 1,                                                                                        \
        .optional = true,                                                                                    \
        .words = distributions}

static const char placement_help[] =
    "The row is set up many times. Each gap has a normally distributed error with the standard deviation "
    "SIGMA, which is a length, and each height has a relative error with the standard deviation HEIGHTS. "
    "If LIMITS is 'uniform', SIGMA and HEIGHTS are limits, and all errors within them are equally likely. "
    "Dominoes that would overlap are moved until they touch. 'placement' counts how often all dominoes "
    "fall, gives the exact 95 % interval of Clopper and Pearson, and reports where rows stop. 'budget' "
    "finds the SIGMA at which a given share of the rows falls. With the same 'seed', row number i is "
    "always the same, with any number of 'threads'. Other errors have separate effects: error_place, "
    "error_thickness, error_mass, error_lean and error_radius for each domino, and error_friction, "
    "error_slope, error_floor and error_push for the whole row.";

/* The last one stands for "all": its value is a factor, without a unit. */
static const struct error_kind error_kinds[DOM_ERROR_COUNT + 1] = {
    /* 'placement' has the errors of gaps and of heights */
    [DOM_ERROR_gap] =
        {.name = "gap",
         .unit = "m",
         .parameter = {.effect = &error_kinds[DOM_ERROR_gap].effect,
                       .number = &error_number[DOM_ERROR_gap],
                       .example =
                           "set row 13; set placement 2 mm; placement 500; set placement off; set row off",
                       .to = 0.1},
         .effect =
             {
                 .name = "placement",
                 .synonyms =
                     "probability chance errors precision accuracy error_gap error_height gaps heights",
                 .adds = "random errors in the gaps, and in the heights if HEIGHTS is given",
                 .help = placement_help,
                 .source = "C. J. Clopper and E. S. Pearson, Biometrika 26, 404 (1934), for the interval; "
                           "pseudo-random numbers from GSL",
                 .argument = {{.name = "SIGMA",
                               .unit = "m",
                               .meaning = "standard deviation of every gap",
                               .lowest = 0,
                               .highest = (domq_real)1e9,
                               .usual = (domq_real)1 / 1000},
                              {.name = "HEIGHTS",
                               .unit = "",
                               .meaning = "relative standard deviation of every height",
                               .lowest = 0,
                               .highest = 1,
                               .usual = 0,
                               .optional = true},
                              {.name = "LIMITS",
                               .unit = "",
                               .meaning = "distribution of the errors: normal, or uniform within limits",
                               .lowest = 0,
                               .highest = 1,
                               .usual = 0,
                               .optional = true,
                               .words = distributions}},
             }},
    [DOM_ERROR_height] = {.name = "height", .unit = ""},
    [DOM_ERROR_place] = {SIZED(place, "m", 0.001, 1e9, 0.1, "", "500"), .effect.synonyms = "position tape",
                         .effect.adds = "random errors in the positions of dominoes",
                         .effect.argument[0].meaning = "error in each position",
                         .effect.help =
                             "Each domino after the first is out of position by a separate random error. An "
                             "error moves only one domino, as if all positions had been measured with one "
                             "tape. In 'set placement', by contrast, an error in a gap moves all dominoes "
                             "after it. Dominoes that would overlap are moved until they touch."},
    [DOM_ERROR_thickness] =
        {SIZED(thickness, "", 0.01, 1, 0.5, "", "500"), .effect.synonyms = "thick boards",
         .effect.adds = "random errors in the thicknesses of dominoes",
         .effect.argument[0].meaning = "error in each thickness, as a fraction of the thickness",
         .effect.help = "Each domino is thicker or thinner by a separate random error, given as a fraction "
                        "of its thickness, such as 0.01 or 1 %. Gaps and the density do not change, so a "
                        "thicker domino is heavier. No domino becomes thinner than twice the thickness of "
                        "the walls, twice the radius of the edges, or 1/100 of its intended thickness."},
    [DOM_ERROR_mass] = {SIZED(mass, "", 0.05, 1, 1, "", "500"), .effect.synonyms = "weight density",
                        .effect.adds = "random errors in the masses of dominoes",
                        .effect.argument[0].meaning = "error in each mass, as a fraction of the mass",
                        .effect.help = "Each domino is heavier or lighter by a separate random error, given "
                                       "as a fraction of its mass."},
    [DOM_ERROR_lean] =
        {SIZED(lean, "rad", 0.005, 1.5, 0.14, "", "500"), .effect.synonyms = "plumb upright tilted",
         .effect.adds = "dominoes that are off plumb by random angles",
         .effect.argument[0].meaning = "error in each lean",
         .effect.help = "Each domino leans forwards or backwards by a separate random angle, as if its floor "
                        "or its foot were not flat. When it falls, it turns about its front edge. A domino "
                        "that would fall over by itself gets the largest lean at which it still stands. This "
                        "effect cannot be combined with rounded edges or with the rigid-body engine."},
    [DOM_ERROR_radius] = {SIZED(radius, "", 0.1, 1, 1, "set edges on; ", "500"),
                          .effect.synonyms = "rounding bevels",
                          .effect.adds = "random errors in the radii of rounded edges",
                          .effect.argument[0].meaning = "error in each radius, as a fraction of the radius",
                          .effect.needs = 1U << DOM_EFFECT_edges,
                          .effect.help =
                              "The radius of the edges of each domino has a separate random error, given as "
                              "a fraction of the radius. A radius is at most half of the thickness."},
    [DOM_ERROR_friction] = {SIZED(friction, "", 0.05, 100, 0.5, "", "500"), .effect.synonyms = "unknown",
                            .effect.adds = "an unknown friction between dominoes, the same for all",
                            .effect.argument[0].meaning = "error in the friction coefficient",
                            .effect.help =
                                "The friction between dominoes is never known precisely. One error is drawn "
                                "for each row. It is added to the coefficient of 'set friction', for all "
                                "dominoes of the row. If the sum is negative, the coefficient is 0."},
    [DOM_ERROR_slope] = {SIZED(slope, "rad", 0.005, 1.5, 0.14, "", "500"), .effect.synonyms = "level uneven",
                         .effect.adds = "a floor that is off level by a random angle",
                         .effect.argument[0].meaning = "error in the slope of the floor",
                         .effect.help =
                             "One angle is drawn for each row and added to the angle of 'set slope'. A floor "
                             "is never so steep that a domino falls over by itself."},
    [DOM_ERROR_floor] = {SIZED(floor, "", 0.05, 100, 0.5, "set feet on; ", "5"),
                         .effect.synonyms = "unknown slippery",
                         .effect.adds = "an unknown friction of the floor, the same for all dominoes",
                         .effect.argument[0].meaning = "error in the friction coefficient of the floor",
                         .parameter.needs = "feet", .parameter.by_engine = true,
                         .effect.help =
                             "One error is drawn for each row and added to the friction coefficient of the "
                             "floor, which 'set feet' sets. If the sum is negative, the coefficient is 0."},
    [DOM_ERROR_push] = {SIZED(push, "rad/s", 0.5, 1e6, 5, "set push on; ", "500"),
                        .effect.synonyms = "finger", .effect.adds = "a push whose strength varies at random",
                        .effect.argument[0].meaning = "error in the angular velocity of the first domino",
                        .effect.needs = 1U << DOM_EFFECT_push,
                        .effect.help = "One error is drawn for each row and added to the speed of 'set "
                                       "push'. If the sum is negative, the speed is 0."},
    [DOM_ERROR_COUNT] = {.name = "all", .unit = ""},
};

/* A names_list (see names.h) of the kinds, with "all" as its last name. */
static const char *error_names(const void *context, int k)
{
    (void)context;
    return k <= DOM_ERROR_COUNT ? error_kinds[k].name : NULL;
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

/* Returns the number of the effect that describes a kind of random error. */
static int error_effect(int kind)
{
    return error_number[kind == DOM_ERROR_height ? DOM_ERROR_gap : kind];
}

bool scene_errors(const struct scene *scene, struct dom_random_error error[DOM_ERROR_COUNT])
{
    bool any = false;
    for (int k = 0; k < DOM_ERROR_COUNT; k++) {
        const int effect = error_effect(k);
        const struct effect_state *state = &scene->effect[effect];
        const bool placed = effect == error_number[DOM_ERROR_gap];
        const domq_real size = state->value[k == DOM_ERROR_height], limits = state->value[placed ? 2 : 1];
        error[k] = (struct dom_random_error){.size = state->on ? (double)size : 0,
                                             .uniform = state->on && limits != 0};
        any = any || state->on;
    }
    return any;
}

bool errors_check(const struct scene *scene, struct problem *problem)
{
    if (!scene->effect[error_number[DOM_ERROR_lean]].on)
        return true;
    if (scene_engine(scene))
        return problem_error(problem,
                             "'set error_lean' cannot be combined with the rigid-body engine, which runs "
                             "this row because %s; first enter 'set error_lean off'",
                             scene_engine(scene));
    return scene->train.rho == 0 ||
           problem_error(problem, "'set error_lean' cannot be combined with rounded edges; first enter "
                                  "'set edges off', or 'set error_lean off'");
}

const char *errors_text(const struct dom_random_error *error, bool for_people, char text[ERRORS_TEXT])
{
    text[0] = '\0';
    for (int k = 0, n = 0; k < DOM_ERROR_COUNT; k++) {
        const char *unit = error_kinds[k].unit;
        const bool is_added = k == DOM_ERROR_friction || k == DOM_ERROR_floor;
        char size[CELL_TEXT];
        if (!(error[k].size > 0))
            continue;
        if (!for_people)
            snprintf(size, sizeof size, "%s%s%s", quad_text((domq_real)error[k].size, 10), *unit ? " " : "",
                     unit);
        else if (strcmp(unit, "rad") == 0)
            snprintf(size, sizeof size, "%s", measured(error[k].size * (180 / QUAD_PI), "deg", 3).text);
        else
            snprintf(size, sizeof size, "%s",
                     measured(error[k].size, *unit || is_added ? unit : "share", 3).text);
        n += snprintf(text + n, (size_t)(ERRORS_TEXT - n), "%s%s %s%s", n ? ", " : "", error_kinds[k].name,
                      size,
                      !error[k].uniform ? ""
                      : for_people      ? " at most"
                                        : " uniform");
    }
    return text;
}

/* ---- Studies ---- */

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
            answer_say(a, "The other rows stop most often at domino %zu (%.3g %% of them).", most + 1,
                       100 * (double)stops[most] / (double)others);
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
    const bool all = kind == DOM_ERROR_COUNT;
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
                   error_kinds[kind].name, measured(size, *unit ? unit : "share", 2).text,
                   at.error[kind].uniform ? "limits of uniform errors" : "one standard deviation",
                   study_words(&study).text);
    return DOM_OK;
}

/* Returns true if the scene can have errors of this kind. Otherwise reports the problem. */
static bool budget_check(const struct query *query, const struct trials *t, enum dom_error_of kind,
                         struct problem *problem)
{
    struct scene with = *query->scene; /* this copy shares the dominoes of query->scene */
    if (kind == DOM_ERROR_COUNT)
        return t->has_errors || problem_no_errors(problem, "'all'");
    const int effect = error_effect((int)kind);
    if (!effect_check_needs(query->scene, effect, problem))
        return false;
    effect_put(&with, effect, effect_at(effect)->argument[0].usual, NULL);
    return errors_check(&with, problem);
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
    const bool good = budget_check(query, &t, of, problem);
    enum dom_status status =
        good ? dom_placement_budget(&t.row.row, &t.row.compute, &t.placement, of, (double)share, &b) : DOM_OK;
    const bool any = !isfinite(b.sigma);
    if (good && status == DOM_OK && !any && answer_for_people(a))
        status = budget_say(a, &t, of, b.sigma);
    free(t.row.domino);
    if (status == DOM_STOPS)
        return problem_no_answer(
            problem,
            "even without %s%s, fewer rows fall than P asks for; enter a smaller P, make "
            "the other errors smaller or, if there are none, try 'mend'",
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
