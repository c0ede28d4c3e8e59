/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mend: the smallest change of one gap that lets all fall. */
#include "commands/mend.h"
#include "commands/falling.h"
#include "io/terminal.h"
#include "language/quad.h"
#include <stdlib.h>

const struct column mend_columns[] = {
    {"domino", "", "before which the gap is changed", 6},
    {"gap", "m", "as it is", 12},
    {"to", "m", "the nearest one with which all fall", 12},
    {"until", "m", "how far one can go on, and all still fall", 12},
    {"change", "m", "to - gap", 12},
    {"relative", "", "change over gap", 10},
    {NULL, NULL, NULL, 0},
};

struct mend {
    struct scene_row *scene;
    size_t k; /* from 0 */
    enum dom_status status;
};

static bool falls_with(struct mend *m, domq_real gap)
{
    struct domq_verdict v = {.end = DOM_ROW_STOPS};
    domq_real kept = m->scene->domino[m->k].gap;
    m->scene->domino[m->k].gap = gap;
    if (m->status == DOM_OK)
        m->status = domq_row_run(&m->scene->row, &m->scene->compute, false, NULL, NULL, &v);
    m->scene->domino[m->k].gap = kept;
    return m->status == DOM_OK && v.end == DOM_ROW_FALLS;
}

/* One gap with which all fall, and how far one can go on from it, away from the one that is. */
struct mended {
    size_t k;
    domq_real gap, to, until;
};

/* Digits of an answer that is typed again. */
#define MEND_DIGITS ((domq_real)1e-6)

/* Between one that falls and one that does not: the last that falls, of few digits. */
static domq_real mend_edge(struct mend *m, domq_real good, domq_real bad)
{
    domq_real digit = quad(pow)(10, quad(floor)(quad(log10)(quad_larger(good, bad)))) * MEND_DIGITS;
    while (m->status == DOM_OK && quad(fabs)(good - bad) > digit / 8) {
        domq_real middle = (good + bad) / 2;
        *(falls_with(m, middle) ? &good : &bad) = middle;
    }
    /* Rounded away from the one that does not fall. */
    domq_real rounded = (good > bad ? quad(ceil)(good / digit) : quad(floor)(good / digit)) * digit;
    return falls_with(m, rounded) ? rounded : good;
}

enum { MEND_STEPS = 40 };

/* First close by, then farther and farther: what is small should be found. */
static domq_real mend_step(domq_real gap, domq_real end, int i)
{
    domq_real part = (domq_real)i / MEND_STEPS;
    return gap + (end - gap) * part * part * part;
}

/* The nearest gap on the way to `end` with which all fall; false where none was found. */
static bool mend_towards(struct mend *m, domq_real end, struct mended *mended)
{
    domq_real gap = m->scene->domino[m->k].gap, bad = gap, good = gap;
    int i = 1;
    while (i <= MEND_STEPS && m->status == DOM_OK && !falls_with(m, good = mend_step(gap, end, i))) {
        bad = good;
        i++;
    }
    if (i > MEND_STEPS || m->status != DOM_OK)
        return false;
    *mended = (struct mended){.k = m->k, .gap = gap, .to = mend_edge(m, good, bad), .until = end};
    for (i++; i <= MEND_STEPS && m->status == DOM_OK; i++) {
        bad = mend_step(gap, end, i);
        if (!falls_with(m, bad)) {
            mended->until = mend_edge(m, good, bad);
            break;
        }
        good = bad;
    }
    return m->status == DOM_OK;
}

static int by_change(const void *a, const void *b)
{
    const struct mended *x = a, *y = b;
    domq_real dx = quad(fabs)(x->to - x->gap), dy = quad(fabs)(y->to - y->gap);
    return dx < dy ? -1 : dx > dy;
}

/* A row forgets what happened so many dominoes ago: their gaps do not save it. */
enum { MEND_BACK = 30 };

/*
 * Gaps up to the one behind the domino where it ends: what lies farther does not matter to that.  Where that
 * one is too wide to be reached over, it alone does.
 */
static enum dom_status mend_search(struct scene_row *scene, const struct domq_verdict *v, struct mended *list,
                                   size_t *found)
{
    struct progress progress = {0, 0};
    size_t last = v->domino < scene->row.count ? v->domino : scene->row.count - 1, first = 1;
    if (v->end == DOM_ROW_MISSES)
        first = last;
    else if (last > MEND_BACK)
        first = last - MEND_BACK;
    *found = 0;
    for (size_t k = first; k <= last && last > 0; k++) {
        struct mend m = {.scene = scene, .k = k};
        struct mended closer, wider;
        bool in = mend_towards(&m, 0, &closer), out = mend_towards(&m, scene->domino[k - 1].height, &wider);
        if (m.status != DOM_OK) {
            progress_show(&progress, 1);
            return m.status;
        }
        if (in || out)
            list[(*found)++] = !in || (out && by_change(&wider, &closer) < 0) ? wider : closer;
        progress_show(&progress, (double)(k - first + 1) / (double)(last - first + 1));
    }
    progress_show(&progress, 1);
    qsort(list, *found, sizeof *list, by_change);
    return DOM_OK;
}

/* ---- A push that is missing ---- */

static bool falls_pushed(struct scene_row *scene, domq_real push, enum dom_status *status)
{
    struct domq_verdict v = {.end = DOM_ROW_STOPS};
    struct domq_row pushed = scene->row;
    pushed.push = push;
    if (*status == DOM_OK)
        *status = domq_row_run(&pushed, &scene->compute, false, NULL, NULL, &v);
    return *status == DOM_OK && v.end == DOM_ROW_FALLS;
}

/* What turns the first over its edge: m g (sqrt(h^2 + d^2) - h) / 2 = I omega^2 / 2. */
static domq_real push_over_edge(const struct scene_row *scene)
{
    domq_real h = scene->domino[0].height, d = scene->domino[0].thickness, reach = quad(sqrt)(h * h + d * d);
    return quad(sqrt)(3 * scene->row.g * d * d / ((reach + h) * reach * reach));
}

/* Rounded up, so that it is still enough. */
static domq_real few_digits(domq_real value)
{
    domq_real digit = quad(pow)(10, quad(floor)(quad(log10)(value)) - 3);
    return quad(ceil)(value / digit) * digit;
}

/* The weakest push found with which all fall, of four digits; NaN where none up to the strongest does. */
static domq_real push_missing(struct scene_row *scene, enum dom_status *status)
{
    const domq_real strongest = domq_effect(DOM_EFFECT_push)->argument[0].highest;
    domq_real bad = isnan(scene->row.push) ? 0 : scene->row.push,
              good = quad_larger(push_over_edge(scene), bad) / 2;
    do {
        good = quad_smaller(2 * good, strongest);
        if (falls_pushed(scene, good, status))
            break;
        bad = good;
    } while (good < strongest && *status == DOM_OK);
    if (!(bad < good))
        return DOMQ_NAN;
    while (good - bad > good * (domq_real)1e-4 && *status == DOM_OK) {
        domq_real middle = (good + bad) / 2;
        *(falls_pushed(scene, middle, status) ? &good : &bad) = middle;
    }
    domq_real rounded = few_digits(good);
    return falls_pushed(scene, rounded, status) ? rounded : good;
}

/* Is it the start that has too little, before any gap comes to matter? */
static bool push_lacks(const struct domq_verdict *v)
{
    return v->end == DOM_ROW_LEANS || (v->end == DOM_ROW_STOPS && v->domino == 1);
}

static enum dom_status push_say(struct answer *a, struct scene_row *scene, const struct domq_verdict *v)
{
    enum dom_status status = DOM_OK;
    domq_real push = push_missing(scene, &status);
    if (status != DOM_OK)
        return status;
    answer_say(a, v->end == DOM_ROW_LEANS
                      ? "A push is missing: the first domino touches the second before it is over its edge."
                      : "A stronger push is missing: this one does not turn the first domino over its edge.");
    if (isnan(push))
        answer_say(a, "No push alone lets all fall: push it all the same, then ask 'mend' again.");
    else
        answer_say(a, "With %.4g rad/s all fall: 'effect push %.4g'.", (double)push, (double)push);
    return DOM_OK;
}

/* ---- Answers ---- */

static const char no_single_gap[] =
    "no change of a single gap lets all fall: change several, the push, or the dominoes";

static void mend_say(struct answer *a, const struct mended *m, size_t found, bool pushless)
{
    if (found == 0) {
        answer_say(a, "N%s.", no_single_gap + 1);
        return;
    }
    answer_say(a, "%s %s the gap before domino %zu by %.3g mm, from %.5g mm to %.7g mm.",
               pushless ? "Without another push the smallest change:" : "The smallest change:",
               m->to < m->gap ? "narrow" : "widen", m->k + 1, (double)(1000 * quad(fabs)(m->to - m->gap)),
               (double)(1000 * m->gap), (double)(1000 * m->to));
    answer_say(a, "'place %zu %.7g' does it, just so.", m->k + 1, (double)m->to);
    double room = (double)(m->to + (m->until - m->to) / 3);
    if (quad(fabs)(m->until - m->to) > (domq_real)1e-4 * m->to)
        answer_say(a, "All fall up to %.7g mm: 'place %zu %.6g' leaves room for errors.",
                   (double)(1000 * m->until), m->k + 1, room);
}

bool mend_run(struct session *session, const struct call *call)
{
    struct scene_row scene;
    struct domq_verdict v;
    struct answer *a = call->answer;
    size_t found = 0;
    if (!scene_row_make(session, &scene))
        return false;
    scene.row.floor = false;
    struct mended *list = calloc(scene.row.count, sizeof *list);
    enum dom_status status =
        list ? domq_row_run(&scene.row, &scene.compute, false, NULL, NULL, &v) : DOM_NO_MEMORY;
    bool falls = status == DOM_OK && v.end == DOM_ROW_FALLS;
    if (status == DOM_OK && push_lacks(&v) && answer_for_people(a))
        status = push_say(a, &scene, &v);
    if (status == DOM_OK && !falls)
        status = mend_search(&scene, &v, list, &found);
    for (size_t i = 0; status == DOM_OK && i < found; i++)
        answer_row(a,
                   ROW(cell_count((domq_real)list[i].k + 1), cell_narrow(list[i].gap, 7),
                       cell_narrow(list[i].to, 7), cell_narrow(list[i].until, 7),
                       cell_narrow(list[i].to - list[i].gap, 5),
                       cell_narrow(list[i].gap > 0 ? (list[i].to - list[i].gap) / list[i].gap : DOMQ_NAN, 4)),
                   NULL);
    const struct cell none = cell_real(DOMQ_NAN);
    if (status == DOM_OK && found == 0 && !answer_for_people(a)) /* programs want to know which */
        answer_row(a, ROW(none, none, none, none, none, none), falls ? "all fall" : no_single_gap);
    else if (falls)
        verdict_say(session, a, &scene, &v, false);
    else if (status == DOM_OK)
        mend_say(a, list, found, push_lacks(&v));
    free(list);
    free(scene.domino);
    return status == DOM_OK || row_status(session, status);
}
