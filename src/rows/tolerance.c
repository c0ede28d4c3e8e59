/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'tolerance': how far the places, sizes and leans of single dominoes may deviate; and 'mend',
 * which finds the smallest change of a single gap that saves a row. */
#include "language/quad.h"
#include "parallel/progress.h"
#include "parallel/workers.h"
#include "rows/rows.h"
#include <stdlib.h>

const struct column tolerance_columns[] = {
    {"domino", "", "number of the domino, from 1", 6},
    {"place", "m", "the distance from the back of domino 1 to the back of this domino", 8},
    {"from", "m", "the smallest 'place' at which all dominoes fall, if no other domino is moved", 8},
    {"to", "m", "the largest 'place' at which all dominoes fall, if no other domino is moved", 8},
    {"gap", "m", "clear distance to the domino before it", 8},
    {"gap_low", "m", "the smallest gap at which all dominoes fall, if no other gap changes", 8},
    {"gap_high", "m", "the largest gap at which all dominoes fall, if no other gap changes", 8},
    {"height", "m", "height of the domino", 8},
    {"height_low", "m",
     "the smallest height at which all dominoes fall; the search ends at 1/100 of the present height", 10},
    {"height_high", "m",
     "the largest height at which all dominoes fall; the search ends at 4 times the present height", 11},
    {"thickness", "m", "thickness of the domino", 8},
    {"thickness_low", "m",
     "the smallest thickness at which all dominoes fall; the search ends at 1/100 of the present "
     "thickness, or where the domino cannot stand",
     10},
    {"thickness_high", "m",
     "the largest thickness at which all dominoes fall; the search ends at 4 times the present thickness",
     11},
    {"lean", "m", "how far the top of the domino is off plumb when it is set up", 8},
    {"lean_low", "m", "the smallest lean at which all dominoes fall (negative: backwards)", 8},
    {"lean_high", "m", "the largest lean at which all dominoes fall (negative: backwards)", 9},
    {"friction_low", "", "the smallest friction between dominoes at which all dominoes fall", 8},
    {"friction_high", "",
     "the largest friction between dominoes at which all dominoes fall; the search ends at a friction of "
     "2, or at 4 times the present friction if that is larger",
     8},
    {"first", "",
     "the properties in which this domino has the tightest limits of all dominoes: 'place', 'height' or "
     "'both'",
     6},
    {NULL, NULL, NULL, 0},
};

/* Returns the number of the domino whose value is closest to an end of its window, or 0 if there is no such
 * domino. If the row falls, this domino has the tightest limits. If the row does not fall, this domino needs
 * the smallest change to save the row. In a row that does not fall, dominoes with the value 0 are not
 * considered, for example dominoes that do not lean. */
static size_t least_room(const struct windows *w, enum dom_window_of kind)
{
    double least = DOM_NAN;
    size_t first = 0;
    for (size_t k = 0; k < w->count; k++) {
        const struct dom_window *of = &w->kind[kind][k];
        /* A difference in height or thickness is divided by the current value. */
        const double room = fabs(fmin(of->now - of->low, of->high - of->now)) /
                            (kind == DOM_WINDOW_HEIGHT || kind == DOM_WINDOW_THICKNESS ? of->now : 1);
        if (!isnan(room) && !(room >= least) && (w->falls || of->now != 0 || kind == DOM_WINDOW_FRICTION)) {
            least = room;
            first = k + 1;
        }
    }
    return first;
}

/* The search for all windows. Each kind of window is a task, and the tasks run in parallel. */
struct search {
    struct windows *windows;
    const struct double_row *made;
    enum dom_status status[WINDOW_KINDS];
};

/* Finds the windows of one kind. Leans are computed only in the model, and only with sharp edges. */
static void search_kind(size_t kind, void *context)
{
    struct search *s = context;
    const struct dom_row *row = &s->made->row;
    const bool from_second = kind == DOM_WINDOW_GAP || kind == DOM_WINDOW_PLACE,
               leans = !row->engine && row->rho == 0;
    s->status[kind] = DOM_OK;
    if (leans || kind != DOM_WINDOW_LEAN)
        s->status[kind] = dom_row_windows(row, &s->made->compute, (enum dom_window_of)kind, NULL, NULL,
                                          s->windows->kind[kind] + from_second);
}

enum dom_status windows_find(const struct query *query, const struct scene_row *scene, struct windows *w)
{
    struct double_row made;
    struct dom_verdict v;
    struct search search = {.windows = w, .made = &made};
    struct task_pool pool = {.threads = query->state->settings.threads,
                             .progress = true,
                             .interrupt = query->scene->compute.interrupt};
    *w = (struct windows){.scene = scene, .count = scene->row.count};
    w->kind[0] = malloc(WINDOW_KINDS * w->count * sizeof **w->kind);
    if (!w->kind[0])
        return DOM_NO_MEMORY;
    for (int i = 1; i < WINDOW_KINDS; i++)
        w->kind[i] = w->kind[i - 1] + w->count;
    for (size_t i = 0; i < WINDOW_KINDS * w->count; i++)
        w->kind[0][i] = (struct dom_window){.now = DOM_NAN, .low = DOM_NAN, .high = DOM_NAN};
    enum dom_status status = scene_row_in_double(scene, &made);
    if (status == DOM_OK)
        status = dom_row_run(&made.row, &made.compute, false, NULL, NULL, &v);
    w->falls = status == DOM_OK && v.end == DOM_ROW_FALLS;
    if (status == DOM_OK)
        status = workers_tasks(WINDOW_KINDS, search_kind, &search, &pool);
    for (int kind = 0; kind < WINDOW_KINDS && status == DOM_OK; kind++)
        status = search.status[kind];
    for (size_t k = 0; k < w->count; k++) { /* from angles to distances by which the top is off plumb */
        struct dom_window *lean = &w->kind[DOM_WINDOW_LEAN][k];
        double *const angle[] = {&lean->now, &lean->low, &lean->high};
        for (int i = 0; i < 3; i++)
            *angle[i] = (double)scene->domino[k].height * sin(*angle[i]);
    }
    free(made.domino);
    for (int kind = 0; kind < WINDOW_KINDS && status == DOM_OK; kind++)
        w->critical[kind] = least_room(w, (enum dom_window_of)kind);
    return status;
}

/* ---- Sentences, with windows rounded inwards ---- */

/* Rounds both ends of a window, so that they are easier to read. The ends move inwards, so that every value
 * in the rounded window is allowed. Each end moves by at most a hundredth of the window's width. */
static struct dom_window readable(const struct dom_window *w)
{
    struct dom_window r = *w;
    const domq_real low = quad_decimal(w->low), high = quad_decimal(w->high), width = high - low;
    if (!(width > 0))
        return r;
    const domq_real digit = quad(pow)(10, quad(floor)(quad(log10)(width / 100)));
    r.low = (double)(quad(ceil)(low / digit) * digit);
    r.high = (double)(quad(floor)(high / digit) * digit);
    return r;
}

/* In sentences, limits have DIGITS digits. A current value was measured with a tape, so DIGITS_NOW digits are
 * enough for it. */
enum { DIGITS = 6, DIGITS_NOW = 4 };

static const char *const kind_names[] = {
    [DOM_WINDOW_PLACE] = "place", [DOM_WINDOW_GAP] = "gap",   [DOM_WINDOW_HEIGHT] = "height",
    [DOM_WINDOW_LEAN] = "lean",   [DOM_WINDOW_FRICTION] = "", [DOM_WINDOW_THICKNESS] = "thickness"};

/* Prints the window with the tightest limits or, if the row does not fall, the one that saves the row with
 * the smallest change, and the 'change' command that makes it. Leans and the friction are among the details.
 */
static void window_say(struct answer *a, const struct windows *w, enum dom_window_of kind)
{
    const size_t k = w->critical[kind];
    if (k == 0)
        return;
    const struct dom_window of = readable(&w->kind[kind][k - 1]);
    const bool is_detail = kind == DOM_WINDOW_LEAN || kind == DOM_WINDOW_FRICTION;
    const char *unit = kind == DOM_WINDOW_FRICTION ? "" : "m";
    char what[64] = "friction between the dominoes";
    if (!w->falls && !is_detail) {
        const double near = of.now < of.low ? of.low : of.high, far = of.now < of.low ? of.high : of.low;
        answer_say(a, "'change %zu %s %s' saves the row.", k, kind_names[kind],
                   measured(near + (far - near) / 3, "m", 4).text);
        return;
    }
    if (kind != DOM_WINDOW_FRICTION)
        snprintf(what, sizeof what, "%s of domino %zu", kind_names[kind], k);
    (is_detail ? answer_detail
               : answer_say)(a,
                             !w->falls ? "The row would fall if the %s were %s to %s; it is %s now."
                             : w->count > 1 && kind != DOM_WINDOW_FRICTION
                                 ? "The %s has the tightest limits: %s to %s; it is %s now."
                                 : "The %s may be %s to %s; it is %s now.",
                             what, measured(of.low, unit, DIGITS).text, measured(of.high, unit, DIGITS).text,
                             measured(of.now, unit, DIGITS_NOW).text);
}

static void tolerance_say(struct answer *a, const struct windows *w)
{
    answer_detail(a,
                  "\nA window is a range of values, for example of the height of a domino. All dominoes "
                  "fall with any value in this range, as long as nothing else in the row changes. Places "
                  "are measured from the back of domino 1 to the back of each domino. A lean is how far the "
                  "top is off plumb; a negative one is backwards.");
    if (w->scene->row.engine)
        answer_detail(a, "A rigid-body engine runs this row. The ends of windows are accurate to about 1 %%, "
                         "and a window also ends where the engine reaches no verdict.");
    if (!w->falls)
        answer_say(a, w->critical[DOM_WINDOW_GAP] || w->critical[DOM_WINDOW_HEIGHT] ||
                              w->critical[DOM_WINDOW_THICKNESS]
                          ? "The row does not fall as it is; a change of one value can save it."
                          : "The row does not fall as it is, and no change of one gap, height or thickness "
                            "was found that saves it; 'mend' says what else to try.");
    window_say(a, w, w->falls ? DOM_WINDOW_PLACE : DOM_WINDOW_GAP);
    window_say(a, w, DOM_WINDOW_HEIGHT);
    window_say(a, w, DOM_WINDOW_THICKNESS);
    window_say(a, w, DOM_WINDOW_LEAN);
    window_say(a, w, DOM_WINDOW_FRICTION);
}

/* ---- The answer ---- */

/* The kinds of windows, in the order of the columns. Each kind has three columns. */
static const enum dom_window_of column_kinds[] = {DOM_WINDOW_PLACE, DOM_WINDOW_GAP, DOM_WINDOW_HEIGHT,
                                                  DOM_WINDOW_THICKNESS, DOM_WINDOW_LEAN};
enum { COLUMN_KINDS = sizeof column_kinds / sizeof *column_kinds };

static void columns_choose(struct answer *a, const struct windows *w)
{
    if (answer_for_people(a)) /* sentences describe these windows, so the columns are left out */
        answer_leave_out(a, "place gap height lean lean_low lean_high friction_low friction_high "
                            "thickness thickness_low thickness_high");
    for (size_t k = 0; k < w->count; k++)
        for (int i = 0; i < COLUMN_KINDS; i++) { /* both ends of a window get the same unit */
            const double high = w->kind[column_kinds[i]][k].high;
            answer_announce(a, tolerance_columns[3 * i + 2].key, high);
            answer_announce(a, tolerance_columns[3 * i + 3].key, high);
        }
}

static void tolerance_row(struct answer *a, const struct windows *w, size_t k)
{
    const bool place = w->falls && w->critical[DOM_WINDOW_PLACE] == k + 1,
               height = w->falls && w->critical[DOM_WINDOW_HEIGHT] == k + 1;
    const struct dom_window *friction = w->kind[DOM_WINDOW_FRICTION];
    struct cell cells[ANSWER_COLUMNS] = {cell_count((domq_real)k + 1)}, *cell = cells + 1;
    bool saves = w->falls;
    for (int i = 0; i < COLUMN_KINDS; i++) {
        const struct dom_window *of = &w->kind[column_kinds[i]][k];
        const struct dom_window shown = answer_for_people(a) ? readable(of) : *of;
        saves = saves || !isnan(of->low);
        *cell++ = cell_narrow(quad_decimal(shown.now), DIGITS);
        *cell++ = cell_narrow(shown.low, DIGITS);
        *cell++ = cell_narrow(shown.high, DIGITS);
    }
    *cell++ = cell_narrow(friction->low, DIGITS);
    *cell++ = cell_narrow(friction->high, DIGITS);
    *cell++ = cell_word(place && height ? "both" : place ? "place" : height ? "height" : "");
    answer_row(a, cells,
               saves || answer_for_people(a)
                   ? NULL
                   : "the search found no change of this domino alone that saves the row");
}

bool run_tolerance(const struct query *query, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    struct windows w;
    if (!scene_row_make(query->scene, &scene, problem))
        return false;
    enum dom_status status = windows_find(query, &scene, &w);
    if (status == DOM_OK) {
        columns_choose(a, &w);
        for (size_t k = 0; k < w.count && !answer_lost(a); k++)
            tolerance_row(a, &w, k);
        tolerance_say(a, &w);
    }
    free(w.kind[0]);
    free(scene.domino);
    return row_status(query, problem, status);
}

/* ---- mend ---- */

const struct column mend_columns[] = {
    {"domino", "", "number of the domino after the gap", 6},
    {"gap", "m", "the present gap", 12},
    {"to", "m", "the nearest gap at which all dominoes fall", 12},
    {"until", "m", "all dominoes fall if the gap is between 'to' and 'until'", 12},
    {"change", "m", "to - gap", 12},
    {"relative", "share", "change / gap", 10},
    {NULL, NULL, NULL, 0},
};

/* A firm push, divided by the weakest push that tips the first domino over. */
#define PUSH_FIRM 1.2

void progress_count(size_t part, size_t of, void *context)
{
    (void)context;
    progress_show((double)part / (double)of);
}

/* Returns true if the first domino does not tip over. In this case, a stronger push may save the row. */
static bool push_lacks(const struct domq_verdict *v)
{
    return v->end == DOM_ROW_LEANS || v->end == DOM_ROW_BACK || (v->end == DOM_ROW_STOPS && v->domino == 1);
}

/* Says what push the row needs. `push` is the weakest push that saves the row, or NaN if there is none.
 * `tips` is the weakest push with which the first domino tips over, or NaN. */
static void push_say(struct answer *a, const struct domq_verdict *v, double push, double tips)
{
    answer_say(a, v->end == DOM_ROW_LEANS
                      ? "The row needs a push: its first domino touches the second before it tips over."
                  : v->end == DOM_ROW_BACK
                      ? "The row needs a larger tilt or a stronger push: its first domino falls back."
                      : "The row needs a stronger push: its first domino does not tip over.");
    if (!isnan(push))
        answer_say(a, "With 'set push %.4g', all dominoes fall.", push);
    else if (isnan(tips))
        answer_say(a, "No push can save this row: it would lift the first domino off the floor.");
    else
        answer_say(a,
                   "A push alone cannot save this row: it would lift the first domino off the floor. Enter "
                   "'set push %.2g', and then 'mend' again.",
                   PUSH_FIRM * tips);
}

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
    double push = DOM_NAN, tips = DOM_NAN;
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
        status = push_find(&made.row, &made.compute, &push);
    if (status == DOM_OK && pushes && isnan(push)) {
        struct dom_row first = made.row;
        first.count = 1;
        first.push =
            fmax(first.push, 0); /* without any push, a single domino falls from where it tips over */
        status = push_find(&first, &made.compute, &tips);
    }
    if (status == DOM_OK && !falls)
        status = dom_row_windows(&made.row, &made.compute, DOM_WINDOW_GAP, progress_count, NULL, w);
    for (size_t i = 0; i + 1 < count && status == DOM_OK && !falls; i++)
        if (!isnan(w[i].low))
            w[found++] = w[i];
    if (found > 1)
        qsort(w, found, sizeof *w, by_change);
    if (status == DOM_OK && pushes)
        push_say(a, &v, push, tips);
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
                   row_has_file(query->scene)
                       ? ""
                       : " 'why' says with which gaps or growth an endless train keeps falling.");
    if (falls)
        weakest_say(a, &v, false);
    free(w);
    free(made.domino);
    free(scene.domino);
    return row_status(query, problem, status);
}
