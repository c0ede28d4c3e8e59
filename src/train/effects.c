/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'effects' and 'scene'. */
#include "interpreter/feature.h"
#include "language/text.h"
#include "train/falling.h"
#include "train/train.h"
#include "train/walk.h"
#include <stdlib.h>

/* ---- scene ---- */

static const struct column scene_columns[] = {
    {"part", "", "part of the computation", 9},
    {"dominoes", "", "the largest number of dominoes in the sums of this part", 8},
    {"why", "", "why this part is needed", 15},
    {"solved", "", "the equations and the method of this part", 40},
    {NULL, NULL, NULL, 0},
};

static void part_row(struct answer *a, const char *part, const char *solved, size_t dominoes, const char *why)
{
    answer_cells(a, cell_word(part), dominoes ? cell_count((domq_real)dominoes) : cell_real(DOMQ_NAN),
                 cell_word(why), cell_word(solved));
}

static bool has_errors(const struct scene *scene)
{
    bool any = false;
    for (int k = 0; k < EFFECT_COUNT; k++)
        any = any || (effect_is_random(k) && scene->effect[k].on);
    return any;
}

/* Adds a row for each part of the computation. The longest sum has `n` dominoes. */
static void parts_list(const struct query *query, struct answer *a, size_t n)
{
    const struct scene *scene = query->scene;
    const struct domq_effect *law = domq_law(&scene->train);
    const char *version = NULL, *motion_why, *motion;
    bool is_row = scene->effect[DOM_EFFECT_row].on, is_pushed = scene->effect[DOM_EFFECT_push].on,
         is_released = scene->effect[DOM_EFFECT_release].on, is_engine = scene_has_engine(scene),
         is_rounded = scene->train.rho != 0, has_losses = law->dissipates != NULL;
    char engine[96], loses[LOSSES_TEXT] = "";
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++)
        if (scene->effect[k].on && effect_at(k)->dissipates)
            text_add(loses, sizeof loses, "%s%s is on", *loses ? ", " : "", effect_at(k)->name);
    if (is_engine) /* the engine's library is loaded only for a scene that needs the engine */
        version = row_engine->version();
    snprintf(engine, sizeof engine, "rigid-body engine, Chipmunk %s, steps halved until nothing changes",
             version ? version : "7 (not installed)");
    motion_why = is_engine ? scene_engine_why(scene) : has_losses ? loses : "no losses";
    motion = is_engine               ? engine
             : !is_row || has_losses ? law->plan
                                     : "energy balance and collision, without integration";
    if (is_row)
        part_row(a, "start",
                 is_released ? domq_effect(DOM_EFFECT_release)->plan
                 : is_pushed ? domq_effect(DOM_EFFECT_push)->plan
                 : is_engine ? "domino 1 is tilted until it just tips over"
                             : "(9; b5): energy that domino 1 gains as it tips over",
                 1,
                 is_released ? "release is on"
                 : is_pushed ? "push is on"
                             : "no push");
    if (is_row && !is_engine)
        part_row(a, "row", domq_effect(DOM_EFFECT_row)->plan, n, "row is on");
    if (is_rounded && !is_engine)
        part_row(a, "geometry", domq_effect(DOM_EFFECT_edges)->plan, n, "edges is on");
    else if (!is_row)
        part_row(a, "geometry", "(12; b8) (14; b10) (31; A6) in closed form, without trigonometry", n,
                 "always");
    if (!is_row)
        part_row(a, "energy",
                 "H (19; c1) and J (20; c2), cut off where a bound on the remaining terms allows it", n,
                 "always");
    part_row(a, "motion", motion, n, motion_why);
    if (is_engine)
        return;
    if (is_row)
        part_row(a, "contact",
                 "signs of the forces: from a bound on the forces or, if the bound does not decide, from the "
                 "forces at four tilts",
                 n, "no contact may pull");
    else
        part_row(a, "barrier",
                 has_losses ? "roots of C, and omega^2 at each root"
                            : "roots of H', and H at each root (26; c8)",
                 n, "always");
    part_row(a, "time", "integral of 1/omega, by double-exponential quadrature", 0, "for times only");
    const bool has_placement = scene->effect[DOM_EFFECT_placement].on;
    if (is_row && has_errors(scene))
        part_row(a, has_placement ? "placement" : "errors", domq_effect(DOM_EFFECT_placement)->plan, 0,
                 has_placement ? "placement is on" : "errors are on");
    if (scene->effect[DOM_EFFECT_floor].on)
        part_row(a, "floor", domq_effect(DOM_EFFECT_floor)->plan, 0, "floor is on");
}

/* Adds to *work the work of finding out whether the train, or the whole row, falls. If the rigid-body engine
 * runs the row, adds nothing. Sets *dominoes to the number of dominoes in the row. */
static bool scene_work(const struct query *query, struct problem *problem, struct dom_work *work,
                       size_t *dominoes)
{
    const struct scene *scene = query->scene;
    struct any_compute compute = scene->compute;
    struct scene_row row;
    struct domq_verdict verdict;
    struct domq_barrier barrier;
    enum dom_status status = DOM_OK;
    compute.work = work;
    if (!scene->effect[DOM_EFFECT_row].on) {
        status = any_barrier_find(&scene->train, &compute, &barrier);
        return status == DOM_STOPS || status == DOM_NO_FUEL || status == DOM_LOCKS ||
               row_status(query, problem, status);
    }
    if (!scene_row_make(scene, &row, problem))
        return false;
    *dominoes = row.row.count;
    if (!row.row.engine)
        status = any_row_run(&row.row, &compute, false, NULL, NULL, &verdict);
    free(row.domino);
    return row_status(query, problem, status);
}

/* Writes the parts of the computation into `parts`. Adds a sentence to the details of `a`. */
static bool scene_write(const struct query *query, struct answer *parts, struct answer *a,
                        struct problem *problem)
{
    struct dom_work work = {0};
    size_t count = 0;
    const struct domq_train *t = &query->scene->train;
    bool is_row = query->scene->effect[DOM_EFFECT_row].on, is_engine = scene_has_engine(query->scene);
    char on[256] = "";
    if (!scene_work(query, problem, &work, &count))
        return false;
    for (int k = 0; k < EFFECT_COUNT; k++)
        if (query->scene->effect[k].on && k != DOM_EFFECT_row)
            text_add(on, sizeof on, "%s%s %s", *on ? ", " : " with ", effect_at(k)->name,
                     effect_setting(query->scene, k));
    if (is_row)
        answer_say(parts, "A row of %zu domino%s%s.", count, count == 1 ? "" : "es", on);
    else
        answer_say(parts, "An endless train, s = %.6g, r = %.6g, d = %.6g, q = %.6g%s.", (double)t->s,
                   (double)t->r, (double)t->d, (double)t->q, on);
    parts_list(query, parts, is_engine ? count : work.longest);
    if (!is_engine)
        answer_detail(a, "The verdict takes %zu passes along the %s at tol = %g in %s precision.",
                      work.passes, is_row ? "row" : "train", (double)query->scene->compute.tol,
                      any_arithmetic(query->scene->compute.precision).name);
    return true;
}

static bool run_scene(const struct query *query, struct answer *a, struct problem *problem)
{
    return scene_write(query, a, a, problem);
}

/* ---- effects ---- */

static const char *method_of(int effect)
{
    bool loses = effect_at(effect)->dissipates;
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++)
        loses = loses || ((effect_at(effect)->needs >> k & 1) != 0 && effect_at(k)->dissipates);
    return effect >= DOM_EFFECT_COUNT ? "engine" : loses ? "motion" : "balance";
}

static const struct column effects_columns[] = {
    {"effect", "", "name of the effect", 9},
    {"state", "", "off, or the values of the effect", 12},
    {"method", "", "the quickest method that includes the effect: balance, motion or engine", 8},
    {"adds", "", "what the effect adds to the paper's model", 40},
    {"source", "", "source of the mathematics", 20},
    {NULL, NULL, NULL, 0},
};

static bool run_effects(const struct query *query, struct answer *a, struct problem *problem)
{
    struct answer parts = {.style = a->style, .columns = scene_columns, .rows = true};
    for (int k = 0; k < EFFECT_ENGINE_END; k++)
        if (effect_exists(k))
            column_fit(&answer_columns(a, a->columns)[1], effect_setting(query->scene, k));
    for (int k = 0; k < EFFECT_COUNT && !answer_lost(a); k++)
        /* there are many kinds of random errors, so only those that are on are listed */
        if (effect_exists(k) && (k < EFFECT_ENGINE_END || query->scene->effect[k].on))
            answer_cells(a, cell_word(effect_at(k)->name), cell_word(effect_setting(query->scene, k)),
                         cell_word(method_of(k)), cell_word(effect_at(k)->adds),
                         cell_word(effect_at(k)->source));
    answer_say(a, "An effect that is off costs nothing. This scene is computed by %s.",
               scene_has_engine(query->scene)               ? "the rigid-body engine"
               : domq_law(&query->scene->train)->dissipates ? "the equation of motion"
                                                            : "the energy balance");
    answer_detail(a, "%s", "");
    parts.out = answer_rest(a);
    struct problem missing = {.kind = PROBLEM_NONE};
    if (parts.out && !scene_write(query, &parts, a, &missing)) {
        if (dom_raised(query->scene->compute.interrupt))
            return query_status(query, problem, DOM_INTERRUPTED);
        answer_say(a, "This scene has no answer yet: %s.", missing.text);
    }
    return true;
}

const struct command effect_commands[] = {
    {.name = "effects",
     .synonyms = "list switch scene",
     .summary = "what effects there are, which are on, and what each adds",
     .help = "Effects decide which of three methods finds the motion, from the quickest to the slowest: the "
             "energy balance; the equation of motion, if there is friction; or a rigid-body engine, for "
             "feet that slip and dominoes that bounce, which runs rows only. An effect that is off costs no "
             "computing time. 'details' shows the parts of the computation, and the sources.",
     .example = "set friction 0.2; effects; set friction off",
     .see = "effects cost",
     .rows = true,
     .brief = "effect state adds",
     ANSWER(effects)},
    {.name = "scene",
     .synonyms = "setup settings list",
     .summary = "the row or train with its effects, and how its answers are computed",
     .example = "scene; set friction 0.2; scene; set friction off",
     .see = "set effects",
     .typed.is_hidden = true,
     .rows = true,
     .brief = "*",
     ANSWER(scene)},
    {.name = NULL},
};
