/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'mend', which finds the smallest change of a single gap that saves a row. */
#include "io/terminal.h"
#include "language/quad.h"
#include "rows/rows.h"
#include <stdlib.h>

const struct column mend_columns[] = {
    {"domino", "", "number of the domino after the gap", 6},
    {"gap", "m", "the present gap", 12},
    {"to", "m", "the nearest gap at which all dominoes fall", 12},
    {"until", "m", "all dominoes fall if the gap is between 'to' and 'until'", 12},
    {"change", "m", "to - gap", 12},
    {"relative", "share", "change / gap", 10},
    {NULL, NULL, NULL, 0},
};

void progress_count(size_t part, size_t of, void *context)
{
    (void)context;
    progress_show((double)part / (double)of);
}

void weakest_say(struct answer *a, const struct domq_verdict *v, bool as_detail)
{
    if (v->weakest > 0 && isfinite(v->spare))
        (as_detail ? answer_detail : answer_say)(
            a, "%s, domino %zu, %s.",
            v->end == DOM_ROW_FALLS ? "The weakest" : "The weakest of those that tip over", v->weakest,
            energy_words(v->spare + 1).text);
}

/* Returns true if the first domino does not tip over. In this case, a stronger push may save the row. */
static bool push_lacks(const struct domq_verdict *v)
{
    return v->end == DOM_ROW_LEANS || v->end == DOM_ROW_BACK || (v->end == DOM_ROW_STOPS && v->domino == 1);
}

/* Says what push the row needs. `push` is the weakest push that saves the row, or NaN if there is none. */
static void push_say(struct answer *a, const struct domq_verdict *v, double push)
{
    answer_say(a, v->end == DOM_ROW_LEANS
                      ? "The row needs a push: its first domino touches the second before it tips over."
                  : v->end == DOM_ROW_BACK
                      ? "The row needs a larger tilt or a stronger push: its first domino falls back."
                      : "The row needs a stronger push: its first domino does not tip over.");
    if (isnan(push))
        answer_say(a, "A push alone cannot save this row; enter 'set push 5', and then 'mend' again.");
    else
        answer_say(a, "With 'set push %.4g', all dominoes fall.", push);
}

/* ---- The gaps ---- */

/* Returns the nearest gap at which all dominoes fall. All dominoes also fall with the gaps up to the other
 * end of the window. */
static double gap_near(const struct dom_window *w)
{
    return w->now < w->low ? w->low : w->high;
}

static double gap_far(const struct dom_window *w)
{
    return w->now < w->low ? w->high : w->low;
}

static int by_change(const void *a, const void *b)
{
    const struct dom_window *x = a, *y = b;
    const double dx = fabs(gap_near(x) - x->now), dy = fabs(gap_near(y) - y->now);
    return dx < dy ? -1 : dx > dy;
}

/* ---- Answers ---- */

/* Returns the smallest change of the gap to whole millimetres at which all dominoes fall. If there is none,
 * returns the nearest gap at which they fall. */
static domq_real whole_gap(const struct dom_window *w)
{
    const bool wider = gap_far(w) > gap_near(w);
    const domq_real mm = (domq_real)1 / 1000, to = quad_decimal(gap_near(w)),
                    until = quad_decimal(gap_far(w)),
                    gap = mm * (wider ? quad(ceil)(to / mm) : quad(floor)(to / mm));
    return (wider ? gap <= until : gap >= until) && gap > 0 ? gap : to;
}

/* Prints the changes of single gaps that save the row, and says how to make the first one, the smallest. */
static void mends_answer(struct answer *a, const struct dom_window *w, size_t found, bool needs_push)
{
    const double to = gap_near(w);
    for (size_t i = 0; i < found; i++) {
        const double now = w[i].now, change = gap_near(&w[i]) - now;
        answer_cells(a, cell_count((domq_real)w[i].domino), cell_narrow(now, 7),
                     cell_narrow(gap_near(&w[i]), 7), cell_narrow(gap_far(&w[i]), 7), cell_narrow(change, 5),
                     cell_narrow(now > 0 ? change / now : DOM_NAN, 4));
    }
    const struct measured safe = measured(whole_gap(w), "m", 7);
    answer_say(a, "%s %s the gap before domino %zu from %s to %s: 'place %zu %s'.",
               needs_push ? "The smallest change, if the push stays as it is:" : "The smallest change:",
               to < w->now ? "narrow" : "widen", w->domino, measured(w->now, "m", 5).text, safe.text,
               w->domino, safe.text);
    answer_detail(a, "All dominoes fall if this gap is between %s and %s: 'place %zu %s' leaves a margin.",
                  measured(round_digits(quad_decimal(w->low), 4, true), "m", 7).text,
                  measured(round_digits(quad_decimal(w->high), 4, false), "m", 7).text, w->domino,
                  measured(to + (gap_far(w) - to) / 3, "m", 4).text);
}

bool run_mend(const struct query *query, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    struct double_row made;
    struct domq_verdict v;
    struct dom_window *w = NULL;
    size_t found = 0;
    double push = DOM_NAN;
    if (!scene_row_make(query->scene, &scene, problem))
        return false;
    const size_t count = scene.row.count;
    enum dom_status status = scene_row_in_double(&scene, &made);
    if (status == DOM_OK && !(w = calloc(count, sizeof *w)))
        status = DOM_NO_MEMORY;
    if (status == DOM_OK)
        status = any_row_run(&scene.row, &scene.compute, false, NULL, NULL, &v);
    const bool falls = status == DOM_OK && v.end == DOM_ROW_FALLS, people = answer_for_people(a),
               pushes = status == DOM_OK && push_lacks(&v) && people;
    if (pushes)
        status = dom_row_weakest_push(&made.row, &made.compute,
                                      dom_effect(DOM_EFFECT_push)->argument[0].highest, &push);
    if (status == DOM_OK && !falls)
        status = dom_row_windows(&made.row, &made.compute, DOM_WINDOW_GAP, progress_count, NULL, w);
    for (size_t i = 0; i + 1 < count && status == DOM_OK && !falls; i++)
        if (!isnan(w[i].low))
            w[found++] = w[i];
    if (found > 1)
        qsort(w, found, sizeof *w, by_change);
    if (status == DOM_OK && pushes)
        push_say(a, &v, push);
    if (found > 0)
        mends_answer(a, w, found, push_lacks(&v));
    else if (status == DOM_OK && !people)
        answer_row(a, (const struct cell[ANSWER_COLUMNS]){{.kind = CELL_NONE}},
                   falls ? "all fall" : "the search found no change of a single gap that saves this row");
    else if (falls)
        answer_say(a, "%s: no gap has to change.", all_fall_words(count).text);
    else if (status == DOM_OK && isnan(push)) /* a push that saves the row has been named above */
        answer_say(a,
                   "The search found no change of a single gap that saves this row; change several gaps, the "
                   "push, or the dominoes.%s",
                   query->scene->listed.domino
                       ? ""
                       : " 'why' says with which gaps or growth an endless train keeps falling.");
    if (falls)
        weakest_say(a, &v, false);
    free(w);
    free(made.domino);
    free(scene.domino);
    return row_status(query, problem, status);
}
