/* SPDX-License-Identifier: GPL-3.0-or-later */
/* tolerance: how far each domino of a row may be off, so that all still fall. */
#include "commands/rows/falling.h"
#include "commands/tables.h"
#include "io/terminal.h"
#include "language/quad.h"
#include <stdlib.h>

const struct column tolerance_columns[] = {
    {"domino", "", "its number, from 1", 6},
    {"place", "m", "from the back of domino 1 to its own back", 8},
    {"from", "m", "all fall with places from here ...", 8},
    {"to", "m", "... to here, if it alone moves", 8},
    {"gap", "m", "free distance to the domino before it", 8},
    {"gap_low", "m", "all fall with gaps from here ...", 8},
    {"gap_high", "m", "... to here, if all after it move along", 8},
    {"height", "m", "its height", 8},
    {"height_low", "m", "all fall with heights from here ...", 10},
    {"height_high", "m", "... to here; 4 times its height if the search ended there", 11},
    {"lean", "m", "what its top is off plumb when it is set up", 8},
    {"lean_low", "m", "all fall if its top is off from here ...", 8},
    {"lean_high", "m", "... to here; negative is backwards", 9},
    {"friction_low", "", "all fall with a friction between dominoes from here ...", 8},
    {"friction_high", "", "... to here; no more than 2, or 4 times the friction, is tried", 8},
    {"first", "", "what fails first at this domino, of all: place, height or both", 6},
    {NULL, NULL, NULL, 0},
};

/* The windows of a row; friction has one. */
struct windows {
    struct domq_window *place, *gap, *height; /* of domino k, from 0: [k]; place and gap from 1 */
    struct domq_window *lean;                 /* lengths, at its top */
    struct domq_window friction;
    size_t first_place, first_height, first_lean, saving_lean; /* numbers of the dominoes; 0: none */
    bool leans;                                                /* false: leans are not tried */
    bool slope; /* true: a domino that stands as it should is not plumb */
    bool falls;
};

struct pass {
    struct progress progress;
    int number;
};

enum { PASSES = 5 };

static void pass_progress(size_t done, size_t of, void *context)
{
    struct pass *p = context;
    progress_show(&p->progress, (p->number + (double)done / (double)of) / PASSES);
}

/* Returns how far the value is from the closer end of its window. */
static domq_real room(const struct domq_window *w)
{
    return quad_smaller(w->now - w->low, w->high - w->now);
}

/* Finds the domino that leans and that the smallest change of its lean lets fall, in a row that does not. */
static void saving_lean_find(struct windows *w, size_t count)
{
    domq_real change = DOMQ_NAN;
    for (size_t k = 0; k < count && w->leans && !w->falls; k++) {
        domq_real off = -room(&w->lean[k]); /* the value is outside */
        if (w->lean[k].now != 0 && off > 0 && !(off >= change)) {
            change = off;
            w->saving_lean = k + 1;
        }
    }
}

/* Finds the dominoes whose place, height and lean have the least room: lengths, shares of the height,
 * lengths. */
static void first_find(struct windows *w, size_t count)
{
    domq_real place = DOMQ_NAN, height = DOMQ_NAN, lean = DOMQ_NAN;
    for (size_t k = 0; k < count && w->falls; k++) {
        domq_real share = room(&w->height[k]) / w->height[k].now;
        if (!(share >= height)) {
            height = share;
            w->first_height = k + 1;
        }
        if (w->leans && !(room(&w->lean[k]) >= lean)) {
            lean = room(&w->lean[k]);
            w->first_lean = k + 1;
        }
        if (k > 0 && !(room(&w->place[k]) >= place)) {
            place = room(&w->place[k]);
            w->first_place = k + 1;
        }
    }
}

/* Returns true if the library knows rows in which a domino leans. */
static bool leans_are_known(const struct domq_row *row)
{
    return !row->engine && row->rho == 0;
}

/* Returns the window of the top of a domino from that of its lean. */
static struct domq_window top_of(const struct domq_window *lean, domq_real height)
{
    struct domq_window top = *lean;
    top.now = height * quad(sin)(lean->now);
    top.low = height * quad(sin)(lean->low);
    top.high = height * quad(sin)(lean->high);
    return top;
}

/* Finds all windows of the row; w->place is to be freed. */
static enum dom_status windows_find(const struct scene_row *scene, struct windows *w)
{
    struct pass pass = {{0, 0}, 0};
    const size_t count = scene->row.count;
    struct domq_verdict v;
    *w = (struct windows){.place = malloc(4 * count * sizeof *w->place)};
    if (!w->place)
        return DOM_NO_MEMORY;
    w->gap = w->place + count;
    w->height = w->gap + count;
    w->lean = w->height + count;
    w->leans = leans_are_known(&scene->row);
    w->slope = scene->row.alpha != 0;
    enum dom_status status = domq_row_run(&scene->row, &scene->compute, false, NULL, NULL, &v);
    w->falls = status == DOM_OK && v.end == DOM_ROW_FALLS;
    struct domq_window *const found[PASSES] = {w->place + 1, w->gap + 1, w->height, &w->friction, w->lean};
    static const enum dom_window_of of[PASSES] = {DOM_WINDOW_PLACE, DOM_WINDOW_GAP, DOM_WINDOW_HEIGHT,
                                                  DOM_WINDOW_FRICTION, DOM_WINDOW_PLUMB};
    for (; pass.number < PASSES - !w->leans && status == DOM_OK; pass.number++)
        status = domq_row_windows(&scene->row, &scene->compute, of[pass.number], pass_progress, &pass,
                                  found[pass.number]);
    progress_show(&pass.progress, 1);
    const struct domq_window none = {
        .now = DOMQ_NAN, .low = DOMQ_NAN, .high = DOMQ_NAN}; /* domino 1 has no gap */
    w->place[0] = w->gap[0] = none;
    for (size_t k = 0; k < count; k++)
        w->lean[k] = w->leans && status == DOM_OK ? top_of(&w->lean[k], scene->domino[k].height) : none;
    if (status == DOM_OK)
        first_find(w, count);
    if (status == DOM_OK)
        saving_lean_find(w, count);
    return status;
}

/* ---- For people: rounded inwards ---- */

/* Returns the window with ends that a person can read, at most a hundredth of it inside. */
static struct domq_window readable(const struct domq_window *w)
{
    struct domq_window r = *w;
    domq_real wide = w->high - w->low;
    if (!(wide > 0))
        return r;
    domq_real digit = quad(pow)(10, quad(floor)(quad(log10)(wide / 100)));
    r.low = quad(ceil)(w->low / digit) * digit;
    r.high = quad(floor)(w->high / digit) * digit;
    return r;
}

enum { DIGITS = 6 };

static struct measured length(domq_real value)
{
    return measured(value, "m", DIGITS);
}

/* What is measured is as exact as a tape measure. */
static struct measured now(domq_real value)
{
    return measured(value, "m", 4);
}

static void friction_say(struct answer *a, const struct windows *w)
{
    const struct domq_window f = readable(&w->friction);
    char low[WIDE_TEXT], high[WIDE_TEXT], now[WIDE_TEXT], from[WIDE_TEXT + 8] = "";
    quad_text(f.now, 4, now);
    quad_text(f.low, DIGITS, low);
    quad_text(f.high, DIGITS, high);
    if (f.low > 0)
        snprintf(from, sizeof from, "from %s ", low);
    if (isnan(f.low))
        answer_say(a, "No other friction between the dominoes saves this row; it is %s now.", now);
    else if (!w->falls)
        answer_say(a, "With a friction between the dominoes %sup to %s all would fall; it is %s now.", from,
                   high, now);
    else
        answer_say(a, "All fall with a friction between the dominoes %sup to %s%s; it is %s now.", from, high,
                   f.above == DOM_ROW_FALLS ? " (more is not tried)" : "", now);
}

/* What the top of a domino is off plumb, in words. */
struct off {
    char text[64];
};

static struct off off(domq_real value, struct measured (*shown)(domq_real))
{
    struct off o;
    const char *way = value < 0 ? " backwards" : value > 0 ? " forwards" : "";
    snprintf(o.text, sizeof o.text, "%.40s%s", shown(quad(fabs)(value)).text, way);
    return o;
}

/* Says how many windows of heights reach the tallest that is tried. */
static void highest_say(struct answer *a, const struct windows *w, size_t count)
{
    size_t open = 0;
    for (size_t k = 0; k < count; k++)
        open += w->falls && w->height[k].above == DOM_ROW_FALLS && w->height[k].high >= 4 * w->height[k].now;
    if (open > 0)
        answer_say(a, "%zu window%s of heights end%s at 4 times the height: taller ones are not tried.", open,
                   open == 1 ? "" : "s", open == 1 ? "s" : "");
}

/* Says where the model ends a window of heights and not the row: where it does not know the contact. */
static void passes_say(struct answer *a, const struct windows *w, const struct scene_row *scene)
{
    size_t passes = 0;
    for (size_t k = 0; k < scene->row.count && !scene->row.engine; k++)
        passes += w->height[k].below == DOM_ROW_PASSES || w->height[k].above == DOM_ROW_PASSES;
    if (passes > 0)
        answer_say(a,
                   "%zu window%s of heights end%s where the upper edge of a domino would pass above the next "
                   "one and its face strike that one: a contact that the model does not include, so the row "
                   "may fall beyond; 'set method engine' includes it.",
                   passes, passes == 1 ? "" : "s", passes == 1 ? "s" : "");
}

static void tolerance_say(struct answer *a, const struct windows *w, const struct scene_row *scene)
{
    const size_t count = scene->row.count;
    answer_say(a, "\nPlaces are measured from the back of domino 1 to the back of each. A window is of one "
                  "change, the rest of the row being as it is.");
    if (scene->row.engine)
        answer_say(a, "A rigid-body engine runs this row: ends of windows are good to about 1 %%, and at "
                      "values that it cannot decide a window ends.");
    if (!w->falls)
        answer_say(a, "The row does not fall now: a change into one of these windows saves it.");
    if (w->first_place) {
        const struct domq_window p = readable(&w->place[w->first_place - 1]);
        answer_say(a, "Place domino %zu between %s and %s: it has the least room of all, and is at %s now.",
                   w->first_place, length(p.low).text, length(p.high).text, now(p.now).text);
    }
    if (w->first_height) {
        const struct domq_window h = readable(&w->height[w->first_height - 1]);
        answer_say(a,
                   "Make domino %zu between %s and %s tall: its height has the least room%s; it is %s now.",
                   w->first_height, length(h.low).text, length(h.high).text, count > 1 ? " of all" : "",
                   now(h.now).text);
    }
    highest_say(a, w, count);
    passes_say(a, w, scene);
    if (w->first_lean) {
        const struct domq_window l = readable(&w->lean[w->first_lean - 1]);
        const char *all = count > 1 ? ", the least room of all" : "";
        if (l.now == 0)
            answer_say(a, "Set domino %zu up %s: its top may be off by %s backwards or %s forwards%s.",
                       w->first_lean, w->slope ? "square to the floor" : "plumb", length(0 - l.low).text,
                       length(l.high).text, all);
        else
            answer_say(a, "The top of domino %zu may be off by %s to %s%s; it is off by %s now.",
                       w->first_lean, off(l.low, length).text, off(l.high, length).text, all,
                       off(l.now, now).text);
    }
    if (w->saving_lean) {
        const struct domq_window l = readable(&w->lean[w->saving_lean - 1]);
        answer_say(a, "With the top of domino %zu off by %s to %s all would fall; it is off by %s now.",
                   w->saving_lean, off(l.low, length).text, off(l.high, length).text, off(l.now, now).text);
    }
    friction_say(a, w);
}

/* ---- The answer ---- */

/* Chooses what a person reads, and the units by the largest of each column. */
static void tolerance_columns_choose(struct answer *a, const struct windows *w, size_t count)
{
    domq_real place = 0, gap = 0, height = 0;
    if (answer_for_people(a)) {
        static const char *const left_out[] = {"place",    "gap",       "height",       "lean",
                                               "lean_low", "lean_high", "friction_low", "friction_high"};
        for (size_t i = 0; i < sizeof left_out / sizeof *left_out; i++)
            answer_leave_out(a, left_out[i]);
    }
    for (size_t k = 0; k < count; k++) { /* a NaN is never larger */
        place = w->place[k].high > place ? w->place[k].high : place;
        gap = w->gap[k].high > gap ? w->gap[k].high : gap;
        height = w->height[k].high > height ? w->height[k].high : height;
    }
    answer_largest(a, "from", place);
    answer_largest(a, "to", place);
    answer_largest(a, "gap_low", gap);
    answer_largest(a, "gap_high", gap);
    answer_largest(a, "height_low", height);
    answer_largest(a, "height_high", height);
}

static struct cell value(domq_real value)
{
    return cell_narrow(value, DIGITS);
}

static void tolerance_row(struct answer *a, const struct windows *w, size_t k)
{
    const struct domq_window p = w->place[k], g = w->gap[k], h = w->height[k], f = w->friction,
                             l = w->lean[k];
    bool place = w->first_place == k + 1, height = w->first_height == k + 1;
    struct cell first = cell_word(place && height ? "both" : place ? "place" : height ? "height" : "");
    if (answer_for_people(a)) {
        const struct domq_window q = readable(&p), i = readable(&g), j = readable(&h);
        answer_row(a,
                   ROW(cell_count((domq_real)k + 1), value(q.low), value(q.high), value(i.low), value(i.high),
                       value(j.low), value(j.high), first),
                   NULL);
    } else
        answer_row(a,
                   ROW(cell_count((domq_real)k + 1), value(p.now), value(p.low), value(p.high), value(g.now),
                       value(g.low), value(g.high), value(h.now), value(h.low), value(h.high), value(l.now),
                       value(l.low), value(l.high), value(f.low), value(f.high), first),
                   w->falls || !isnan(p.low) || !isnan(g.low) || !isnan(h.low) || !isnan(l.low)
                       ? NULL
                       : "no change of this domino alone saves the row");
}

bool run_tolerance(const struct query *query, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    struct windows w;
    if (!scene_row_make(query->scene, &scene, problem))
        return false;
    scene.row.floor = false;
    enum dom_status status = windows_find(&scene, &w);
    if (status == DOM_OK) {
        tolerance_columns_choose(a, &w, scene.row.count);
        for (size_t k = 0; k < scene.row.count && !answer_lost(a); k++)
            tolerance_row(a, &w, k);
        tolerance_say(a, &w, &scene);
    }
    free(w.place);
    free(scene.domino);
    return status == DOM_OK || row_status(query, problem, status);
}
