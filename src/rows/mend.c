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

/* Sets *push to the weakest push that saves the row, or to NaN if there is none. */
static enum dom_status push_say(struct answer *a, const struct double_row *made, const struct domq_verdict *v,
                                double *push)
{
    enum dom_status status = dom_row_weakest_push(&made->row, &made->compute,
                                                  dom_effect(DOM_EFFECT_push)->argument[0].highest, push);
    if (status != DOM_OK)
        return status;
    answer_say(a, v->end == DOM_ROW_LEANS
                      ? "The row needs a push: its first domino touches the second before it tips over."
                  : v->end == DOM_ROW_BACK
                      ? "The row needs a larger tilt or a stronger push: its first domino falls back."
                      : "The row needs a stronger push: its first domino does not tip over.");
    if (isnan(*push))
        answer_say(a, "A push alone cannot save this row; enter 'set push 5', and then 'mend' again.");
    else
        answer_say(a, "With 'set push %.4g', all dominoes fall.", *push);
    return DOM_OK;
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

/* Finds the windows of all gaps. Moves the gaps that save the row to the front, the one with the smallest
 * change first, and stores their number in *found. The caller frees *list. */
static enum dom_status mends_find(const struct double_row *made, struct dom_window **list, size_t *found)
{
    const size_t gaps = made->row.count - 1;
    struct dom_window *w = *list = calloc(gaps + 1, sizeof *w);
    const enum dom_status status =
        w ? dom_row_windows(&made->row, &made->compute, DOM_WINDOW_GAP, progress_count, NULL, w)
          : DOM_NO_MEMORY;
    for (size_t i = 0; i < gaps && status == DOM_OK; i++)
        if (!isnan(w[i].low))
            w[(*found)++] = w[i];
    if (status == DOM_OK && *found > 1)
        qsort(w, *found, sizeof *w, by_change);
    return status;
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

static void mend_say(struct answer *a, const struct dom_window *w, bool needs_push)
{
    const double to = gap_near(w);
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

/* Prints a table of the changes that were found and says how to make the smallest one. */
static void mends_answer(struct answer *a, const struct dom_window *list, size_t found,
                         const struct domq_verdict *v, size_t count, bool has_push)
{
    static const char no_single_gap[] =
        "the search found no change of a single gap that saves this row; change several gaps, the push, or "
        "the dominoes";
    const bool falls = v->end == DOM_ROW_FALLS;
    for (size_t i = 0; i < found; i++) {
        const double now = list[i].now, to = gap_near(&list[i]);
        answer_cells(a, cell_count((domq_real)list[i].domino), cell_narrow(now, 7), cell_narrow(to, 7),
                     cell_narrow(gap_far(&list[i]), 7), cell_narrow(to - now, 5),
                     cell_narrow(now > 0 ? (to - now) / now : DOM_NAN, 4));
    }
    if (found > 0)
        mend_say(a, list, push_lacks(v));
    else if (!answer_for_people(a))
        answer_row(a, (const struct cell[ANSWER_COLUMNS]){{.kind = CELL_NONE}},
                   falls ? "all fall" : no_single_gap);
    else if (falls)
        answer_say(a, "%s: no gap has to change.", all_fall_words(count).text);
    else if (!has_push) /* a push that saves the row has been named above */
        answer_say(a, "T%s.", no_single_gap + 1);
    if (falls)
        weakest_say(a, v, false);
}

bool run_mend(const struct query *query, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    struct double_row made;
    struct domq_verdict v;
    struct dom_window *list = NULL;
    size_t found = 0;
    double push = DOM_NAN;
    if (!scene_row_make(query->scene, &scene, problem))
        return false;
    enum dom_status status = scene_row_in_double(&scene, &made);
    if (status == DOM_OK)
        status = any_row_run(&scene.row, &scene.compute, false, NULL, NULL, &v);
    if (status == DOM_OK && push_lacks(&v) && answer_for_people(a))
        status = push_say(a, &made, &v, &push);
    if (status == DOM_OK && v.end != DOM_ROW_FALLS)
        status = mends_find(&made, &list, &found);
    if (status == DOM_OK)
        mends_answer(a, list, found, &v, scene.row.count, !isnan(push));
    if (status == DOM_OK && found == 0 && v.end != DOM_ROW_FALLS && isnan(push) &&
        !query->scene->listed.domino)
        answer_say(a, "'why' says with which gaps or growth an endless train keeps falling.");
    free(list);
    free(made.domino);
    free(scene.domino);
    return row_status(query, problem, status);
}
