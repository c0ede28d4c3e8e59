/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'design', which finds a row with a given safety and a last domino of a given height. */
#include "answer/format.h"
#include "language/quad.h"
#include "planning/designs.h"
#include "planning/planning.h"
#include "rows/row_edit.h"
#include "rows/rows.h"
#include "train/falling.h"
#include <stdlib.h>

/* ---- What would make a wish possible ---- */

/* Returns the push in rad/s above which the first domino is thrown off the floor. */
static double push_most(const struct dom_wish *wish)
{
    return sqrt(2 * wish->g / wish->first);
}

/* Converts a push to the speed of the first domino's upper edge, which is easier to imagine. */
static struct measured push_speed(const struct dom_wish *wish, double push)
{
    return measured(push * wish->first, "m/s", 2);
}

/* Reports that the search failed, and what may help. Returns false. */
static bool search_failed(const struct scene *scene, const struct dom_design *d, struct problem *problem)
{
    const struct domq_train *t = &scene->train;
    const char *with = t->rho > 0 && t->mu > 0 ? "with friction and rounded edges "
                       : t->rho > 0            ? "with rounded edges "
                       : t->mu > 0             ? "with friction "
                                               : "";
    const char *off = t->rho > 0 ? ", or 'set edges off'" : t->mu > 0 ? ", or 'set friction off'" : "";
    return problem_no_answer(problem,
                             "no row was found: %sthe search failed at s = %.2g; try another thickness%s",
                             with, d->needs, off);
}

/* Explains why no row fulfils the wish and says what the user can change. */
static void infeasible_text(const struct query *query, const struct dom_wish *wish,
                            const struct dom_limits *limits, const struct dom_design *d, char text[REASON])
{
    const struct measured safety = measured(wish->safety, "", 6);
    const bool has_boards = limits && limits->boards > 0, has_grid = limits && limits->grid > 0;
    if (d->limit == DOM_DESIGN_HALL)
        snprintf(
            text, REASON,
            "infeasible: the shortest row %swith a safety of %s and %s is %s m long, including its fallen "
            "last domino; 'hall %s m' is long enough",
            limits ? "found " : "", safety.text,
            !limits      ? "dominoes of the same proportions"
            : has_boards ? "these boards"
                         : "this grid",
            measured(d->needs, "", 4).text,
            measured(round_digits(quad_decimal(d->needs), 4, true), "", 4).text);
    else if (d->limit == DOM_DESIGN_START && d->needs > push_most(wish))
        snprintf(
            text, REASON,
            "infeasible: a safety of %s at the second domino needs a push of %s at the top of domino 1, but "
            "a push above %s lifts this domino off the floor; enter a smaller safety",
            safety.text, push_speed(wish, d->needs).text, push_speed(wish, push_most(wish)).text);
    else if (d->limit == DOM_DESIGN_START && isfinite(d->needs)) {
        const struct measured push = measured(round_digits(quad_decimal(d->needs), 3, true), "", 3);
        snprintf(text, REASON,
                 "infeasible: the start is too weak for a safety of %s at the second domino; domino 1 needs "
                 "a push of %.40s rad/s (%.40s at its top); first enter 'set push %.40s'",
                 safety.text, push.text, push_speed(wish, d->needs).text, push.text);
    } else if (d->limit == DOM_DESIGN_START && limits)
        snprintf(text, REASON,
                 "infeasible: no row with a safety of %s was found %s%s; enter a smaller safety, %s%s, or "
                 "another height of domino 1 with 'set h'",
                 safety.text, has_boards ? "with these boards" : "on this grid",
                 has_boards && has_grid ? " on this grid" : "", has_boards ? "other boards" : "a finer grid",
                 has_boards && has_grid ? ", a finer grid" : "");
    else if (d->limit == DOM_DESIGN_START)
        snprintf(
            text, REASON,
            "infeasible: the start is too weak for a safety of %s, and no push that was tried is enough; try "
            "a smaller safety",
            safety.text);
    else if (d->limit == DOM_DESIGN_ENGINE)
        snprintf(
            text, REASON,
            "infeasible: rows with a safety of %s fall in the model with hinged feet, but no row that was "
            "tried falls in the rigid-body engine (used because %s); a stronger push ('set push') or another "
            "thickness may help",
            safety.text, scene_engine_why(query->scene));
    else if (d->needs > 1)
        snprintf(text, REASON,
                 "infeasible: no growth gives a safety of %s here; a safety below %s is possible",
                 safety.text, measured(round_digits(quad_decimal(d->needs), 4, false), "", 4).text);
    else
        snprintf(text, REASON, "infeasible: not even equal dominoes keep falling here, whatever the gap%s",
                 query->scene->train.mu > 0 ? "; enter a smaller friction" : "");
}

/* ---- The answer ---- */

static bool wish_check(struct problem *problem, const struct dom_wish *w, domq_real grid)
{
    if (!grid_check(grid, w->first, problem))
        return false;
    if (!(w->height > w->first))
        return problem_no_answer(problem,
                                 "H = %s is not more than the height of the first domino, h = %s; enter a "
                                 "larger H, or a smaller h with 'set h'",
                                 measured(w->height, "m", 6).text, measured(w->first, "m", 6).text);
    if (!(w->safety > 1))
        return problem_no_answer(problem,
                                 "the safety must be more than 1, not %s: at a safety of 1 a domino barely "
                                 "falls; 'safety 2' is usual",
                                 quad_text(w->safety, 10));
    return w->hall > w->height ||
           problem_no_answer(problem,
                             "a hall of %s has no room for the last domino, which is %s long when it has "
                             "fallen; enter a longer hall or a smaller H",
                             measured(w->hall, "m", 6).text, measured(w->height, "m", 6).text);
}

/* Reports that the walls do not fit into the first domino or, if only taller dominoes are boxes, into the
 * smallest box. Also says how to make boxes only of dominoes that are thick enough. Returns false. */
static bool thin_box(const struct scene *scene, struct problem *problem)
{
    const domq_real walls = scene_walls(scene), d = scene->train.d, above = scene_boxes_above(scene),
                    height = above > scene->scale.h ? above : scene->scale.h;
    const int cm = (int)ceil((double)(100 * 2 * walls / d) + 0.5);
    char which[192] = "the first domino";
    if (above > 0)
        snprintf(which, sizeof which, "a domino of %s", measured(height, "m", 4).text);
    return problem_no_answer(problem,
                             "walls of %s do not fit into %s, which is %s thick; enter 'set "
                             "walls %s %d cm', and only dominoes taller than %d cm are boxes",
                             measured(walls, "m", 4).text, which, measured(d * height, "m", 4).text,
                             measured(walls, "m", 4).text, cm, cm);
}

/* If the scene runs rows in the rigid-body engine, the design must also fall there. */
static bool design_find(const struct query *query, struct dom_wish *wish, const struct dom_limits *limits,
                        struct scene_engine *engine, struct dom_design *d, struct problem *problem)
{
    struct scene with_row = *query->scene;
    with_row.effect[DOM_EFFECT_row].on = true;
    if (scene_has_engine(&with_row)) {
        if (!row_engine->make(&with_row, 1, engine, problem))
            return false;
        wish->engine = &engine->engine;
    }
    const struct dom_train train = train_in_double(&query->scene->train);
    const struct dom_compute compute = compute_in_double(&query->scene->compute);
    const enum dom_status status = limits ? dom_design_fit(&train, wish, limits, &compute, d)
                                          : dom_design_find(&train, wish, &compute, d);
    if (status == DOM_NO_ROOM)
        return thin_box(query->scene, problem);
    if (status == DOM_NO_AIR)
        return problem_no_answer(problem,
                                 "%s, and a design begins with one; enter 'set air off', design the row, and "
                                 "then 'set air on; fall'",
                                 dom_status_text(status));
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    if (d->limit == DOM_DESIGN_FAILED)
        return search_failed(query->scene, d, problem);
    /* Check now that the engine can run a row of this length. */
    return !wish->engine || row_engine->make(&with_row, d->steps + 1, engine, problem);
}

/* Prints how safe the design is. */
static void design_say(const struct query *query, struct answer *a, const struct dom_wish *wish,
                       const struct dom_design *d, const struct designed_row *plan)
{
    char growth[160] = "", weakest[CELL_TEXT + 120] = "";
    if (d->weakest > 0)
        snprintf(weakest, sizeof weakest, " The weakest, domino %zu, %s%s.", d->weakest,
                 energy_words(d->row).text, wish->engine ? " in the model, which treats feet as hinges" : "");
    if (!plan->is_improved && !plan->limits)
        snprintf(growth, sizeof growth,
                 ", each %.4g times as large as the one before, with gaps of %.4g times the height", d->r,
                 d->s);
    const struct scene *scene = query->scene;
    char boxes[192] = "dominoes";
    if (scene_boxes_above(scene) > 0)
        snprintf(boxes, sizeof boxes, "dominoes, those above %s hollow",
                 measured(scene_boxes_above(scene), "m", 4).text);
    else
        snprintf(boxes, sizeof boxes, "%s", dominoes_words(scene->train.q, "dominoes").text);
    answer_say(a, "%zu %s%s; the last is %s tall, and the row %s long.%s", plan->count, boxes, growth,
               measured(wish->height, "m", 4).text, measured(d->length, "m", 4).text, weakest);
    if (wish->engine)
        answer_detail(a, "All dominoes also fall in the rigid-body engine, which is used because %s.",
                      scene_engine_why(query->scene));
}

/* Says what the design replaces in the session, as in ", in place of the row from hall.csv". If there was no
 * row, these are a separation and a growth that the user has set. */
enum { REPLACED = EFFECT_SETTING + 64 };
static void replaced_write(const struct scene *before, char text[REPLACED])
{
    const struct domq_train usual = domq_train_default();
    const struct typed_length *gap = &before->length[SHARE_s];
    const bool has_s = gap->m > 0 || before->train.s != usual.s, has_r = before->train.r != usual.r;
    const char *place = ", in place of ";
    if (before->effect[DOM_EFFECT_row].on)
        snprintf(text, REPLACED, "%sthe row %s %s%s", place, before->listed.domino ? "from" : "of",
                 effect_setting(before, DOM_EFFECT_row), row_unsaved(before) ? ", with its changes" : "");
    else if (has_s)
        text_add(text, REPLACED, "%ss = %s", place,
                 gap->m > 0 ? length_write(gap->m, gap->unit, (char[LENGTH_TEXT]){""})
                            : quad_text(before->train.s, 6));
    if (!before->effect[DOM_EFFECT_row].on && has_r)
        text_add(text, REPLACED, "%sr = %s", has_s ? " and " : place, quad_text(before->train.r, 6));
}

static bool design_keep(const struct query *query, struct problem *problem, const struct dom_design *d,
                        const struct designed_row *plan)
{
    const domq_real count = (domq_real)d->steps + 1, s = quad_decimal(d->s),
                    r = design_growth(query->scene, plan);
    struct state *next = query->next;
    return !next ||
           (parameter_set(next, parameter_find("row"), &count, 1, NULL, problem) &&
            parameter_set(next, parameter_find("s"), &s, 1, NULL, problem) &&
            parameter_set(next, parameter_find("r"), &r, 1, NULL, problem) &&
            (!plan->limits || scene_row_set(&next->scene, plan->domino, plan->count, true, problem)));
}

/* Improves the session's row, which is the design, and copies the improved row to the plan. */
static bool design_improve(const struct query *query, const struct wishes *w, struct answer *a,
                           struct designed_row *plan, struct dom_design *d, struct dom_study *study,
                           struct problem *problem)
{
    struct query of_row = *query;
    struct improved found;
    struct scene_row row;
    of_row.scene = &query->next->scene;
    struct wishes wishes = *w;
    wishes.sizes = true;
    if (!improve_row(&of_row, &wishes, a, &found, problem) ||
        !scene_row_list(&query->next->scene, &row, problem))
        return false;
    free(plan->domino);
    plan->domino = row.domino;
    d->feet += found.length - d->length;
    d->length = found.length;
    if (found.study[1].rows >= study->rows || found.changed > 0)
        *study = found.study[1];
    plan->is_improved = found.changed > 0;
    if (plan->is_improved) { /* these numbers are not known for the improved row */
        d->row = d->train = d->seconds = DOM_NAN;
        d->weakest = 0;
    }
    return true;
}

static struct dom_limits design_limits(const struct query *query, const struct wishes *w)
{
    return (struct dom_limits){.sizes = true,
                               .q = (double)query->scene->train.q,
                               .hall = (double)w->hall,
                               .heaviest = HUGE_VAL,
                               .grid = (double)w->grid,
                               .board = w->board,
                               .boards = w->boards};
}

/* Writes why there is no design. If the answer should go to a file, this is an error. */
static bool design_none(struct answer *a, const struct dom_design *d, const char *reason, bool file,
                        struct problem *problem)
{
    if (file)
        return problem_no_answer(problem, "%s", reason);
    answer_say(a, "%s.", reason);
    if (!answer_for_people(a))
        design_row(a, NULL, d, NULL, reason);
    return true;
}

/* Prints the answer. If the command can change the session, first makes the design the row of the session. If
 * the user asked for a probability, this row is also improved. */
static bool design_answer(const struct query *query, const struct wishes *w, struct answer *a,
                          const struct dom_wish *wish, struct designed_row *plan, struct dom_design *d,
                          struct dom_study *study, struct problem *problem)
{
    const bool file = a->path && !a->style.format->for_people, keeps = a->out && !a->sink.take && query->next;
    char replaced[REPLACED] = "";
    if (keeps)
        replaced_write(&query->next->scene, replaced);
    if ((keeps && !design_keep(query, problem, d, plan)) ||
        (keeps && w->probability > 0 && !design_improve(query, w, a, plan, d, study, problem)))
        return false;
    struct query of_row = *query;
    struct answer list = {.out = answer_rest(a), .style = a->style};
    of_row.scene = keeps ? &query->next->scene : NULL;
    if (file && keeps)
        return row_list(&of_row, 0, a, problem);
    design_row(a, plan, d, study,
               isinf(d->row) ? "no domino after the first needs energy to fall over, so no safety is known"
                             : NULL);
    if (answer_for_people(a))
        design_say(query, a, wish, d, plan);
    answer_detail(a, "%s", "");
    if (list.out && keeps && !row_list(&of_row, 0, &list, problem))
        return false;
    if (keeps)
        answer_say(a, "The session now has this row%s: 'row' lists it, 'fall' runs it, 'undo' takes it back.",
                   replaced);
    return true;
}

bool run_design(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct wishes *w = query->given->bound ? query->given->bound : &usual_wishes;
    const bool file = a->path && !a->style.format->for_people, is_random = w->probability > 0;
    struct dom_wish wish = {.first = (double)query->scene->scale.h,
                            .height = (double)query->given->number[0],
                            .safety = (double)w->safety,
                            .hall = (double)w->hall,
                            .g = (double)query->scene->scale.g,
                            .push = (double)scene_push(query->scene, query->scene->scale.h),
                            .release = (double)scene_release(query->scene),
                            .least = w->least,
                            .walls = (double)scene_walls(query->scene),
                            .boxes_above = (double)scene_boxes_above(query->scene)};
    const struct dom_limits sizes = design_limits(query, w),
                            *limits = w->grid > 0 || w->boards > 0 ? &sizes : NULL;
    struct dom_design d;
    struct dom_study study = {.rows = 0};
    struct designed_row plan;
    char reason[REASON];
    struct scene_engine engine;
    design_columns_choose(a, is_random);
    if (!wish_check(problem, &wish, w->grid) ||
        !(is_random ? design_falls(query, a, &wish, limits, w->probability, &d, &study, reason, problem)
                    : design_find(query, &wish, limits, &engine, &d, problem)))
        return false;
    answer_set_verdict(a, d.limit == DOM_DESIGN_FITS);
    if (d.limit != DOM_DESIGN_FITS && !is_random)
        infeasible_text(query, &wish, limits, &d, reason);
    if (d.limit != DOM_DESIGN_FITS)
        return design_none(a, &d, reason, file, problem);
    if (!designed_make(query, problem, &wish, limits, &d, &plan))
        return false;
    const bool good = design_answer(query, w, a, &wish, &plan, &d, &study, problem);
    free(plan.domino);
    return good;
}
