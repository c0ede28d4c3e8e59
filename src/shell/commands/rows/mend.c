/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mend: the smallest change of one gap that saves a row. */
#include "commands/rows/falling.h"
#include "commands/tables.h"
#include "io/terminal.h"
#include "language/quad.h"
#include <stdlib.h>

const struct column mend_columns[] = {
    {"domino", "", "the gap is the one before this domino", 6},
    {"gap", "m", "the gap as it is", 12},
    {"to", "m", "the nearest gap with which all fall", 12},
    {"until", "m", "all fall with gaps from 'to' up to this one", 12},
    {"change", "m", "to - gap", 12},
    {"relative", "share", "change / gap", 10},
    {NULL, NULL, NULL, 0},
};

static void mend_progress(size_t done, size_t of, void *context)
{
    progress_show(context, (double)done / (double)of);
}

/* Returns true if the first domino does not tip over: no gap matters then. */
static bool push_lacks(const struct domq_verdict *v)
{
    return v->end == DOM_ROW_LEANS || (v->end == DOM_ROW_STOPS && v->domino == 1);
}

static enum dom_status push_say(struct answer *a, const struct scene_row *scene, const struct domq_verdict *v)
{
    domq_real push;
    enum dom_status status =
        domq_row_push(&scene->row, &scene->compute, domq_effect(DOM_EFFECT_push)->argument[0].highest, &push);
    if (status != DOM_OK)
        return status;
    answer_say(a, v->end == DOM_ROW_LEANS
                      ? "The row needs a push: its first domino touches the second before it tips over."
                      : "The row needs a stronger push: with this one its first domino does not tip over.");
    if (isnan(push))
        answer_say(a, "No push alone saves this row; enter 'effect push on', then 'mend' again.");
    else
        answer_say(a, "With 'effect push %.4g' all fall.", (double)push);
    return DOM_OK;
}

/* ---- Answers ---- */

static const char no_single_gap[] =
    "no change of a single gap saves this row; change several gaps, the push, or the dominoes";

/* Returns the end of a window, rounded into the window to four digits. */
static domq_real inwards(domq_real end, bool up)
{
    if (!(end > 0))
        return end;
    domq_real digit = quad(pow)(10, quad(floor)(quad(log10)(end)) - 3);
    return (up ? quad(ceil)(end / digit) : quad(floor)(end / digit)) * digit;
}

static void mend_say(struct answer *a, const struct domq_mend *m, size_t found, bool pushless)
{
    if (found == 0) {
        answer_say(a, "N%s.", no_single_gap + 1);
        return;
    }
    answer_say(a, "%s %s the gap before domino %zu by %s, from %s to %s.",
               pushless ? "Without another push, the smallest change:" : "The smallest change:",
               m->to < m->gap ? "narrow" : "widen", m->domino,
               measured(quad(fabs)(m->to - m->gap), "m", 3).text, measured(m->gap, "m", 5).text,
               measured(m->to, "m", 7).text);
    answer_say(a, "'place %zu %s' is just enough.", m->domino, measured(m->to, "m", 7).text);
    bool wider = m->until > m->to;
    domq_real until = inwards(m->until, !wider), room = m->to + (until - m->to) / 3;
    struct measured to = measured(m->to, "m", 7), end = measured(until, "m", 7);
    if (quad(fabs)(m->until - m->to) > (domq_real)1e-4 * m->to)
        answer_say(a, "All fall with gaps %s%s%s%s: 'place %zu %s' leaves room for errors of %s.",
                   until > 0 ? "between " : "up to ", until > 0 ? (wider ? to : end).text : "",
                   until > 0 ? " and " : "", (wider ? end : to).text, m->domino, measured(room, "m", 4).text,
                   measured(quad(fabs)(room - m->to), "m", 2).text);
}

bool run_mend(const struct query *query, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    struct domq_verdict v;
    struct domq_mend list[DOM_MENDS];
    struct progress progress = {0, 0};
    size_t found = 0;
    if (!scene_row_make(query->scene, &scene, problem))
        return false;
    scene.row.floor = false;
    enum dom_status status = domq_row_run(&scene.row, &scene.compute, false, NULL, NULL, &v);
    bool falls = status == DOM_OK && v.end == DOM_ROW_FALLS;
    if (status == DOM_OK && push_lacks(&v) && answer_for_people(a))
        status = push_say(a, &scene, &v);
    if (status == DOM_OK && !falls) {
        status = domq_row_mend(&scene.row, &scene.compute, mend_progress, &progress, list, &found);
        progress_show(&progress, 1);
    }
    for (size_t i = 0; i < found; i++) {
        domq_real change = list[i].to - list[i].gap;
        answer_cells(a, cell_count((domq_real)list[i].domino), cell_narrow(list[i].gap, 7),
                     cell_narrow(list[i].to, 7), cell_narrow(list[i].until, 7), cell_narrow(change, 5),
                     cell_narrow(list[i].gap > 0 ? change / list[i].gap : DOMQ_NAN, 4));
    }
    const struct cell none = cell_real(DOMQ_NAN);
    if (status == DOM_OK && found == 0 && !answer_for_people(a)) /* programs get the reason */
        answer_row(a, ROW(none, none, none, none, none, none), falls ? "all fall" : no_single_gap);
    else if (falls)
        verdict_say(a, &scene, &v, NULL, false);
    else if (status == DOM_OK)
        mend_say(a, list, found, push_lacks(&v));
    free(scene.domino);
    return status == DOM_OK || row_status(query, problem, status);
}
