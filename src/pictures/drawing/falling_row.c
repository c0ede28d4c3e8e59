/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/drawing/falling_row.h"
#include "interpreter/question.h"
#include "language/quad.h"
#include "language/text.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- The row on its stage ---- */

static bool end_seen(const struct dom_moment *moment, void *context)
{
    *(double *)context = moment->time;
    return true;
}

/* Returns the tilt in rad of the first domino before the fall. */
static domq_real row_tilt(const struct scene_row *row)
{
    domq_real touch;
    if (isnan(row->row.push) || !(row->row.release > 0))
        return row->domino->lean;
    if (any_row_touch(&row->row, &row->compute, &touch) != DOM_OK)
        return 0;
    return quad_smaller(row->row.release, touch);
}

void falling_row_pose(struct falling_row *row, const struct dom_moment *moment)
{
    const struct domq_row *r = &row->run.scene.row;
    const struct domq_verdict *v = &row->run.verdict;
    const size_t stops = v->end != DOM_ROW_FALLS ? v->domino : 0, head = moment ? moment->head : 0,
                 weakest = row->dominoes > 1 && isfinite(v->spare) ? v->weakest : 0;
    double at = 0, rho = (double)r->rho;
    for (size_t k = 0; k < row->stage.count; k++) {
        const struct domq_domino *domino = &row->run.scene.domino[k];
        double lean = k == 0 ? (double)row_tilt(&row->run.scene) : (double)domino->lean,
               tilt = moment ? moment->tilt[k] : lean, height = (double)domino->height;
        at += k > 0 ? (double)domino->gap : 0;
        row->stage.domino[k] =
            (struct drawn){.number = k >= row->dominoes ? NUMBER_TOWER : (int)k + 1,
                           .part = k + 1 == stops     ? ENDS
                                   : k + 1 == weakest ? WEAKEST
                                   : k + 1 == head    ? HEAD
                                   : tilt > lean      ? FALLS
                                                      : STANDS,
                           .height = height,
                           .thickness = (double)domino->thickness,
                           .theta = tilt,
                           .radius = rho != 0 && domino->radius > 0 ? (double)domino->radius : rho * height,
                           .foot = at + (moment ? row->slid[k] : 0) + (double)domino->thickness};
        at += (double)domino->thickness;
        drawn_corners(&row->stage.domino[k]);
    }
}

void falling_row_reach(struct falling_row *row, bool lying)
{
    row->stage.right = 0;
    for (size_t k = 0; k < row->stage.count; k++) {
        const struct drawn *d = &row->stage.domino[k];
        row->stage.right = fmax(row->stage.right, d->foot + (lying ? d->height : 0));
    }
}

double falling_row_extreme(const struct falling_row *row, size_t count, bool tallest)
{
    double extreme = row->stage.domino[0].height;
    for (size_t k = 1; k < count; k++)
        extreme = (tallest ? fmax : fmin)(extreme, row->stage.domino[k].height);
    return extreme;
}

bool falling_row_make(const struct query *query, struct problem *problem, bool has_tower,
                      struct falling_row *row)
{
    const double ever = HUGE_VAL;
    *row = (struct falling_row){.end = (double)NAN, .has_tower = has_tower};
    if (!row_run(query, problem, true, &row->run))
        return false;
    size_t count = row->run.scene.row.count;
    row->slid = calloc(count, sizeof *row->slid);
    row->stage.domino = calloc(count, sizeof *row->stage.domino);
    row->stage.count = count;
    enum dom_status status = row->stage.domino && row->slid ? DOM_OK : DOM_NO_MEMORY;
    row->dominoes = count - has_tower;
    row->stage.ruler = "tape measure from the back of domino 1";
    if (status == DOM_OK && !row->run.timeless)
        status = falling_row_watch(row, &ever, 1, end_seen, &row->end);
    if (status != DOM_OK && status != DOM_NO_MARGIN) {
        falling_row_free(row);
        return row_status(query, problem, status);
    }
    falling_row_pose(row, NULL);
    falling_row_reach(row, false);
    row->stage.top = falling_row_extreme(row, count, true);
    return true;
}

void falling_row_free(struct falling_row *row)
{
    row_run_free(&row->run);
    free(row->stage.domino);
    free(row->slid);
}

double falling_row_hit(const struct falling_row *row, size_t k)
{
    return k == 0 ? 0 : k < row->run.hits ? (double)row->run.fall[k].time : (double)NAN;
}

enum dom_status falling_row_watch(const struct falling_row *row, const double *times, size_t count,
                                  dom_moment_visit *visit, void *context)
{
    struct double_row made;
    struct dom_verdict verdict;
    if (!double_row_make(&row->run.scene.row, &row->run.scene.compute, &made))
        return DOM_NO_MEMORY;
    const enum dom_status status =
        made.row.engine
            ? row->run.report.watch(&made.row, &made.compute, times, count, visit, context, row->slid)
            : dom_row_watch(&made.row, &made.compute, times, count, visit, context, &verdict);
    free(made.domino);
    return status;
}

/* ---- The tower ---- */

/* Turns the last domino of the row into the tower: a domino of this height, with the proportions of the
 * others. The gap before it is s times its height, as for every domino. */
static bool tower_stand(struct tower *tower, size_t dominoes, domq_real height, struct problem *problem)
{
    struct scene *scene = &tower->state.scene;
    const struct domq_train *train = &scene->train;
    tower->row = row_edit(scene, problem);
    if (!tower->row)
        return false;
    scene->slot = &tower->row->slot;
    struct domq_domino *change = &tower->row->change[dominoes].to;
    change->height = height;
    change->thickness = train->d * height;
    change->width = train->width * height;
    change->gap = train->s * height;
    /* A change of the three sizes gives the mass of a solid domino, for which q = 4. */
    if (!(scene_walls(scene) > 0))
        change->mass =
            quad(pow)(height / scene->scale.h / quad(pow)(train->r, (domq_real)dominoes), train->q - 4);
    return true;
}

bool tower_make(const struct query *query, struct tower *tower, struct problem *problem)
{
    /* Indices of the first columns in the answer of 'count'. */
    enum { COUNT_HEIGHT, COUNT_GROWTH, COUNT_DOMINOES };
    const struct last_answer *ans = query->ans;
    *tower = (struct tower){.row = NULL};
    if (!ans->command || ans->command->run != run_count)
        return problem_error(problem,
                             "'tower' works only if the last answer was a count; first enter 'count 112 m'");
    if (ans->with)
        return problem_error(problem, "the last count was made 'with' settings that the session does not "
                                      "have; first set them, and count again");
    const domq_real dominoes = ans->cells[COUNT_DOMINOES].number,
                    most = domq_effect(DOM_EFFECT_row)->argument[0].highest;
    if (!isfinite(dominoes) || dominoes < 1 || dominoes >= most)
        return problem_no_answer(problem, "there is no row to draw: the last 'count' %s",
                                 dominoes == 0         ? "needs no dominoes"
                                 : !isfinite(dominoes) ? "does not reach its height"
                                                       : "needs more dominoes than a row can have");
    const struct assigned assigned[] = {
        {.parameter = parameter_find("r"), .value = ans->cells[COUNT_GROWTH].number},
        {.parameter = parameter_find("row"), .value = dominoes + 1}};
    return query_with(query, assigned, 2, &tower->state, &tower->query, problem) &&
           tower_stand(tower, (size_t)dominoes, ans->cells[COUNT_HEIGHT].number, problem);
}

void tower_free(struct tower *tower)
{
    if (tower->row)
        slot_drop(&tower->row->slot);
}

/* ---- Sentences ---- */

const char *falling_row_start(const struct falling_row *row)
{
    return row_run_tipped(&row->run, 0) ? "first hit" : row->run.scene.row.release > 0 ? "release" : "push";
}

void falling_row_begin(const struct falling_row *row, char text[SENTENCE])
{
    const struct scene_row *scene = &row->run.scene;
    const domq_real release = scene->row.release, push = scene->row.push;
    if (isnan(push))
        snprintf(text, SENTENCE, "Tip domino 1 until it falls by itself.");
    else if (release > 0)
        snprintf(text, SENTENCE, "%s domino 1 %s and %s.", isinf(release) ? "Lean" : "Hold",
                 isinf(release) ? "against domino 2" : release_words(release).text,
                 push > 0 ? "push it" : "let it go");
    else
        snprintf(text, SENTENCE, "Push domino 1 so that its top moves at %s.",
                 measured(push * scene->domino[0].height, "m/s", 3).text);
}

static struct words domino_words(const struct falling_row *row, size_t number)
{
    struct words words;
    if (number > row->dominoes)
        snprintf(words.text, sizeof words.text, "the tower");
    else
        snprintf(words.text, sizeof words.text, "domino %zu", number);
    return words;
}

void falling_row_summary(const struct falling_row *row, char text[SENTENCE])
{
    struct measured least = measured((domq_real)falling_row_extreme(row, row->dominoes, false), "m", 3),
                    most = measured((domq_real)falling_row_extreme(row, row->dominoes, true), "m", 3);
    bool equal = strcmp(least.text, most.text) == 0;
    snprintf(text, SENTENCE, "%zu domino%s, %.60s%s%.60s tall", row->dominoes, row->dominoes == 1 ? "" : "es",
             least.text, equal ? "" : " to ", equal ? "" : most.text);
    if (row->has_tower)
        text_add(text, SENTENCE, "; a tower of %.40s",
                 measured(row->run.scene.domino[row->dominoes].height, "m", 4).text);
}

void falling_row_verdict(const struct falling_row *row, char text[SENTENCE])
{
    const struct domq_verdict *v = &row->run.verdict;
    const size_t end = v->domino;
    double share = v->end == DOM_ROW_STOPS && end <= row->run.hits
                       ? (double)fall_share(&row->run.fall[end - 1])
                       : (double)NAN;
    if (v->end == DOM_ROW_FALLS && isfinite(row->end) && row->stage.count > 1)
        snprintf(text, SENTENCE, "%.40s%s lies flat %.40s after the %s.", all_fall_words(row->dominoes).text,
                 row->has_tower ? ", and so does the tower: it" : ": the last one",
                 measured((domq_real)row->end, "s", 3).text, falling_row_start(row));
    else if (v->end == DOM_ROW_FALLS)
        snprintf(text, SENTENCE, "%.40s.", all_fall_words(row->dominoes).text);
    else if (share < 1)
        snprintf(text, SENTENCE, "%.40s stops the row: it %.150s.", domino_words(row, end).text,
                 energy_words((domq_real)share).text);
    else
        snprintf(text, SENTENCE, "The fall ends at %.40s: %s.", domino_words(row, end).text,
                 dom_row_end_text(v->end));
    *text = (char)toupper((unsigned char)*text);
}

void falling_row_weakest(const struct falling_row *row, char text[SENTENCE])
{
    const struct domq_verdict *v = &row->run.verdict;
    text[0] = '\0';
    if (v->weakest > 0 && row->stage.domino[v->weakest - 1].part == WEAKEST)
        snprintf(text, SENTENCE, "Weakest%s: %.40s, which %.150s.",
                 v->end == DOM_ROW_FALLS ? "" : " of the dominoes that fall",
                 domino_words(row, v->weakest).text, energy_words(v->spare + 1).text);
}

void falling_row_moment(const struct falling_row *row, const struct dom_moment *m, char text[SENTENCE])
{
    const bool over = m->time >= row->end;
    const size_t after = row->stage.count - m->head;
    snprintf(text, SENTENCE, "%.3f s after the %s: ", m->time, falling_row_start(row));
    if (over && row->run.verdict.end == DOM_ROW_FALLS) {
        text_add(text, SENTENCE, "all have fallen.");
        return;
    }
    text_add(text, SENTENCE, "%s%.40s%s", over ? "the fall ends at " : "", domino_words(row, m->head).text,
             over ? "" : " falls");
    if (after > 0)
        text_add(text, SENTENCE, "; %zu domino%s still stand%s", after, after == 1 ? "" : "es",
                 after == 1 ? "s" : "");
    text_add(text, SENTENCE, ".");
}
