/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'maximize' and 'minimize', which find the values of one or two parameters at which an answer
 * is largest or smallest. */
#include "io/terminal.h"
#include "language/quad.h"
#include "language/text.h"
#include "parallel/workers.h"
#include "session/parameters.h"
#include "sweeps/sweeps.h"
#include "train/falling.h"
#include "train/seek.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- The search ---- */

enum { POINTS = 241, POINTS_OF_TWO = 41 /* along each of two parameters */ };

struct peak {
    double x, value;  /* NaN if there is no value at all */
    double within;    /* the error of x is at most this; 0 for an end of the range */
    double off;       /* the error of the value is at most this */
    double low, high; /* the value is the same from `low` to `high`; without such a plateau, both are x */
    enum { PEAK_INSIDE, PEAK_AT_FROM, PEAK_AT_TO, PEAK_BEFORE_HOLE, PEAK_AFTER_HOLE } end;
};

struct hunt;

/* The search along one parameter. With two parameters, the value at a place of the first one is the largest
 * value along the second one. */
struct line {
    struct hunt *hunt;
    int axis;
    double from, to, grain; /* the range, and how accurately a place is found */
    bool whole;             /* only whole numbers are places */
    size_t count;
    struct spot point[POINTS]; /* evenly spaced */
    double level;              /* for line_above */
};

struct hunt {
    const struct varied *varied;
    struct probe probe;
    double sign;  /* minima are sought as maxima of the answer times -1 */
    double noise; /* the relative error of the answers */
    struct line line[VARIED_MOST];
    double place[VARIED_MOST];
    struct problem fault;  /* the last error in the question itself; its kind is PROBLEM_NONE before */
    bool is_wrong[POINTS]; /* the question itself turned out to be wrong at this point */
    size_t missing;        /* the number of points along the first parameter without an answer */
    struct peak peak[VARIED_MOST]; /* the result for each parameter */
    domq_real best;                /* the best answer, with its own sign */
    char reason[PROBLEM_TEXT / 2]; /* why the first of the missing answers is missing */
    char beyond[PROBLEM_TEXT / 2]; /* why there is no answer beyond the best place, or "" */
};

/* Returns the answer at h->place, or its negative for a minimum. */
static double ask(struct hunt *h)
{
    struct assigned assigned[VARIED_MOST];
    if (dom_raised(h->probe.query->scene->compute.interrupt))
        return (double)NAN;
    for (int i = 0; i < h->varied->count; i++)
        assigned[i] =
            (struct assigned){.parameter = h->varied->range[i].parameter, .value = (domq_real)h->place[i]};
    h->best = probe_ask(&h->probe, assigned, h->varied->count);
    if (h->probe.wrong)
        h->fault = h->probe.problem;
    return h->sign * (double)h->best;
}

static struct peak line_best(struct line *line, bool is_rough);

static double line_at(double x, void *context)
{
    struct line *l = context;
    l->hunt->place[l->axis] = l->whole ? round(x) : x;
    return l->axis + 1 < l->hunt->varied->count ? line_best(l + 1, true).value : ask(l->hunt);
}

static double line_above(double x, void *context)
{
    const struct line *l = context;
    return line_at(x, context) - l->level;
}

/* Returns the highest spot around point k, whose neighbours are not higher. */
static struct spot top_around(struct line *l, size_t k, double grain)
{
    struct spot top = l->point[k];
    const struct spot here = top;
    double bound[2] = {here.x, here.x};
    const bool is_outer = l->axis + 1 < l->hunt->varied->count;
    for (int side = 0; side < 2; side++) {
        if (side ? k + 1 == l->count : k == 0)
            continue;
        struct spot beside = l->point[side ? k + 1 : k - 1], last = here;
        if (isnan(beside.value)) { /* the values end before it */
            l->level = -HUGE_VAL;
            /* a value may change much near its end */
            seek_edge(line_above, l, &last, &beside, is_outer ? 1e-4 * l->grain : 0);
            beside = (struct spot){last.x, line_at(last.x, l)};
            top = beside.value > top.value ? beside : top;
        }
        bound[side] = beside.x;
    }
    top = seek_top(line_at, l, bound[0], top, bound[1], grain, HUGE_VAL);
    top.x = l->whole ? round(top.x) : top.x;
    return top;
}

/* Returns how far the values that count as equal to that at x reach on one side. */
static double plateau_end(struct line *l, double x, int side)
{
    struct spot good = {x, 0}, bad = {side < 0 ? l->from : l->to, (double)NAN};
    bool is_end = true;
    for (size_t i = 0; i < l->count && is_end; i++) {
        const struct spot point = l->point[side < 0 ? l->count - 1 - i : i];
        if (side * (point.x - x) <= 0)
            continue;
        is_end = point.value >= l->level;
        *(is_end ? &good : &bad) = (struct spot){point.x, point.value - l->level};
    }
    if (is_end)
        return good.x;
    bool is_equal = good.x == x; /* the values become smaller before the next point */
    for (double by = l->grain; is_equal && by < side * (bad.x - x); by *= 2) {
        const struct spot next = {x + side * by, line_above(x + side * by, l)};
        is_equal = next.value >= 0;
        *(is_equal ? &good : &bad) = next;
    }
    seek_edge(line_above, l, &good, &bad, l->grain);
    return l->whole ? round(good.x) : good.x;
}

/* Finds out how exact a peak is, and what is around it. */
static void peak_measure(struct line *l, struct peak *p)
{
    const double noise = l->hunt->noise * fabs(p->value), range = l->to - l->from,
                 part = l->whole ? 0.5 : 0.05 * range / (double)(l->count - 1),
                 near = l->whole ? 1 : fmax(1e-9 * range, 2 * l->grain);
    l->level = p->value - noise;
    p->low = plateau_end(l, p->x, -1);
    p->high = plateau_end(l, p->x, 1);
    const bool is_plateau = p->high - p->low > part;
    const double off = fmax(l->grain, fmax(p->x - p->low, p->high - p->x));
    if (!is_plateau) {
        p->end = p->x - l->from < near / 2 ? PEAK_AT_FROM
                 : l->to - p->x < near / 2 ? PEAK_AT_TO
                                           : PEAK_INSIDE;
        p->low = p->high = p->x;
    }
    if (p->end == PEAK_INSIDE)
        p->end = p->high + near <= l->to && isnan(line_at(p->high + near, l))   ? PEAK_BEFORE_HOLE
                 : p->low - near >= l->from && isnan(line_at(p->low - near, l)) ? PEAK_AFTER_HOLE
                                                                                : PEAK_INSIDE;
    const double middle = l->whole ? floor((p->low + p->high) / 2) : (p->low + p->high) / 2;
    if (is_plateau && line_above(middle, l) >= 0)
        p->x = middle;
    p->off = noise;
    if (is_plateau || l->whole)
        return;
    if (p->end == PEAK_INSIDE) {
        p->within = off;
        for (int side = -1; side < 2; side += 2)
            p->off = fmax(p->off, noise + p->value - line_at(p->x + side * off, l));
    } else if (p->end != PEAK_AT_FROM && p->end != PEAK_AT_TO) {
        p->within = 1e-2 * l->grain; /* an edge is found more exactly */
    }
}

/* Finds the largest value. The search looks around each point whose neighbours are not larger. It can miss a
 * maximum that is narrower than the distance between two points. If `is_rough` is true, it finds only x and
 * value. After an interrupt, the result is of no use. */
static struct peak peak_find(struct line *l, bool is_rough)
{
    struct peak p = {.x = (double)NAN, .value = (double)NAN};
    for (size_t k = 0; k < l->count; k++) {
        const double left = k > 0 ? l->point[k - 1].value : (double)NAN, here = l->point[k].value,
                     right = k + 1 < l->count ? l->point[k + 1].value : (double)NAN;
        /* On a plateau, only its first and its last point have neighbours that may lead to a larger value. */
        if (isnan(here) || left > here || right > here || (left == here && right == here))
            continue;
        const struct spot top = top_around(l, k, is_rough ? 100 * l->grain : l->grain);
        if (!(top.value <= p.value)) {
            p.x = top.x;
            p.value = top.value;
        }
    }
    p.low = p.high = p.x;
    if (!isnan(p.x) && !is_rough)
        peak_measure(l, &p);
    return p;
}

/* Places the points of a line, and computes their values if `all` is true. */
static void points_place(struct line *l, bool all)
{
    const size_t most = l->hunt->varied->count == 2 ? POINTS_OF_TWO : POINTS;
    const double span = l->to - l->from;
    l->count = l->whole && span < (double)most ? (size_t)span + 1 : most;
    for (size_t k = 0; k < l->count; k++) {
        const double part = (double)k / (double)(l->count - 1),
                     x = k + 1 == l->count ? l->to : (1 - part) * l->from + part * l->to;
        l->point[k].x = l->whole ? round(x) : x;
        if (all)
            l->point[k].value = line_at(l->point[k].x, l);
    }
}

static struct peak line_best(struct line *l, bool is_rough)
{
    points_place(l, true);
    return peak_find(l, is_rough);
}

static void hunt_begin(struct hunt *h, const struct varied *varied, struct probe probe, bool is_minimum)
{
    h->varied = varied;
    h->probe = probe;
    h->sign = is_minimum ? -1 : 1;
    h->noise = fmax(4 * (double)probe.query->scene->compute.tol, 1e-15);
    for (int i = 0; i < varied->count; i++) {
        struct line *l = &h->line[i];
        *l = (struct line){.hunt = h,
                           .axis = i,
                           .from = (double)varied->range[i].from,
                           .to = (double)varied->range[i].to,
                           .whole = varied->range[i].parameter->value->whole};
        l->grain = l->whole ? 0.5 : (l->to - l->from) * (i == 0 && varied->count == 2 ? 2e-6 : 1e-10);
    }
}

/* A dom_task, which computes the answer at point k. Each task has its own copy of the search. */
static void point_task(size_t k, void *context)
{
    struct hunt *h = context;
    struct hunt mine = {.best = 0};
    hunt_begin(&mine, h->varied, h->probe, h->sign < 0);
    h->line->point[k].value = line_at(h->line->point[k].x, mine.line);
    h->is_wrong[k] = mine.fault.kind != PROBLEM_NONE;
}

/* Computes the answers along the first parameter in parallel. */
static bool points_ask(struct hunt *h, struct problem *problem)
{
    const struct scene *scene = h->probe.query->scene;
    struct task_pool pool = {.threads = h->probe.query->state->settings.threads,
                             .progress = true,
                             .interrupt = scene->compute.interrupt};
    struct line *l = h->line;
    points_place(l, false);
    const enum dom_status status = workers_tasks(l->count, point_task, h, &pool);
    progress_end();
    if (status != DOM_OK)
        return problem_status(problem, scene, status);
    for (size_t k = 0; k < l->count; k++) {
        const bool is_first = isnan(l->point[k].value) && h->missing++ == 0;
        if (!is_first && !h->is_wrong[k])
            continue;
        (void)line_at(l->point[k].x, l);
        if (h->is_wrong[k]) {
            *problem = h->fault;
            return false;
        }
        snprintf(h->reason, sizeof h->reason, "%.*s", (int)sizeof h->reason - 1, h->probe.problem.text);
    }
    return true;
}

/* If the best place is beside a hole along parameter i, stores why the hole has no answers. */
static void hole_ask(struct hunt *h, int i)
{
    const struct peak *p = &h->peak[i];
    const struct line *l = &h->line[i];
    const double by = l->whole ? 1 : 1e-6 * (l->to - l->from); /* nearer, the place may not be in the hole */
    if (p->end != PEAK_BEFORE_HOLE && p->end != PEAK_AFTER_HOLE)
        return;
    for (int k = 0; k < h->varied->count; k++)
        h->place[k] = h->peak[k].x;
    h->place[i] = p->end == PEAK_BEFORE_HOLE ? p->high + by : p->low - by;
    if (isnan(ask(h)))
        snprintf(h->beyond, sizeof h->beyond, "For a %s %s it has no answer: %.*s",
                 p->end == PEAK_BEFORE_HOLE ? "larger" : "smaller", h->varied->range[i].parameter->name,
                 (int)sizeof h->beyond - 64, h->probe.problem.text);
}

/* Finds the best place of the second parameter. It changes with the first one along the ridge of the best
 * answers, so the error of the first one adds to its own. */
static void second_find(struct hunt *h)
{
    struct peak *p = h->peak;
    const double step = fmax(1e-4 * (h->line[0].to - h->line[0].from), p[0].within);
    h->place[0] = p[0].x;
    p[1] = line_best(&h->line[1], false);
    h->place[0] = p[0].x + (p[0].x + step <= h->line[0].to ? step : -step);
    const struct peak beside = line_best(&h->line[1], true);
    if (isfinite(beside.x) && p[1].low == p[1].high)
        p[1].within = hypot(p[1].within, fabs(beside.x - p[1].x) / step * p[0].within);
}

/* Searches the whole range. Fails if there is no answer at all, or only one. */
static bool hunt_run(struct hunt *h, struct problem *problem)
{
    const struct scene *scene = h->probe.query->scene;
    const struct varied *v = h->varied;
    char ranges[192] = "";
    bool is_constant = true;
    if (!points_ask(h, problem))
        return false;
    h->peak[0] = peak_find(h->line, false);
    const bool is_found = isfinite(h->peak[0].x);
    if (is_found && v->count == 2)
        second_find(h);
    for (int i = 0; i < v->count && is_found; i++) {
        hole_ask(h, i);
        is_constant = is_constant && h->peak[i].low <= h->line[i].from && h->peak[i].high >= h->line[i].to;
    }
    for (int i = 0; i < v->count; i++)
        h->place[i] = h->peak[i].x;
    if (is_found)
        (void)ask(h); /* h->best is the answer of this place */
    if (dom_raised(scene->compute.interrupt))
        return problem_status(problem, scene, DOM_INTERRUPTED);
    for (int i = 0; i < v->count; i++)
        text_add(ranges, sizeof ranges, "%s%s = %s .. %s", i ? " and " : "", v->range[i].parameter->name,
                 quad_text(v->range[i].from, 10), quad_text(v->range[i].to, 10));
    if (!is_found)
        return problem_no_answer(problem, "%s has no answer for any %s: %s", v->question->name, ranges,
                                 h->reason);
    return !is_constant ||
           problem_no_answer(problem,
                             "%s does not depend on %s%s%s: it is %s everywhere in %s; "
                             "'sensitivity' shows what it depends on",
                             v->question->name, v->range[0].parameter->name, v->count == 2 ? " and " : "",
                             v->count == 2 ? v->range[1].parameter->name : "", quad_text(h->best, 10),
                             ranges);
}

/* ---- The answer ---- */

const struct column optimum_columns[] = {
    {"parameter", "", "the parameter that is varied", 9},
    {"value", "", "its best value, in the unit of 'show'", 0},
    {"within", "", "by how much this value may be off; 0 at an end of the range", 0},
    {"low", "", "the lowest value with the same answer, if there is a range of such values", 0},
    {"high", "", "the highest value with the same answer", 0},
    {"end", "",
     "'from' or 'to' if the value is at this end of the range, 'hole' if there are no answers beyond it", 6},
    {"answer", "", "the best answer", 0},
    {"answer_within", "", "by how much the answer may be off", 0},
    {"unit", "", "the unit of the answer", 10},
    {NULL, NULL, NULL, 0},
};

/* Returns how many digits of a number are right, from 1 to the digits of the session. */
static int digits_right(const struct hunt *h, double x, double within)
{
    const double most = (double)h->probe.query->state->settings.style.digits;
    return (int)(!(within > 0) || x == 0 ? most : fmin(most, fmax(1, floor(log10(fabs(x) / within)))));
}

/* Writes a number with its unit, angles in the session's unit. */
static void number_write(const struct hunt *h, domq_real value, const char *unit, int digits, char *text,
                         size_t size)
{
    const struct answer_style style = state_style(h->probe.query->state);
    if (strncmp(unit, "rad", 3) == 0)
        text_add(text, size, "%s %s%s", quad_text(style_angle(&style, value), digits),
                 style_angle_unit(&style), unit + 3);
    else
        text_add(text, size, "%s", measured(value, unit, digits).text);
}

/* Writes a value of a parameter with its unit. A share of the height is followed by the length. */
static void place_write(const struct hunt *h, int i, domq_real value, int digits, char *text, size_t size)
{
    const char *unit = h->varied->range[i].parameter->value->unit;
    domq_real height = h->probe.query->scene->scale.h;
    if (strcmp(unit, "h") != 0) {
        number_write(h, value, unit, digits, text, size);
        return;
    }
    for (int k = 0; k < h->varied->count; k++)
        if (strcmp(h->varied->range[k].parameter->name, "h") == 0)
            height = (domq_real)h->peak[k].x;
    text_add(text, size, "%s (%s)", quad_text(value, digits),
             measured(value * height, "m", digits < 4 ? digits : 4).text);
}

/* Writes "every s from 0.4 to 0.6" for a plateau. */
static void plateau_write(const struct hunt *h, int i, char *text, size_t size)
{
    const struct peak *p = &h->peak[i];
    const domq_real nearly = 1e-12; /* 1.45 must not be rounded down to 1.449 */
    domq_real from = (domq_real)p->low, to = (domq_real)p->high;
    const domq_real up = round_digits(from * (1 - nearly), 4, true),
                    down = round_digits(to * (1 + nearly), 4, false);
    if (!h->line[i].whole && up <= down) { /* otherwise the range is narrower than its rounding */
        from = up;
        to = down;
    }
    text_add(text, size, "every %s from ", h->varied->range[i].parameter->name);
    place_write(h, i, from, 10, text, size);
    text_add(text, size, " to ");
    place_write(h, i, to, 10, text, size);
}

static void best_say(const struct hunt *h, struct answer *a, double off)
{
    const struct varied *v = h->varied;
    char best[CELL_TEXT] = "", where[1024] = "", same[1024] = "";
    number_write(h, quad(fabs)(h->best) > (domq_real)off ? h->best : 0, h->probe.unit_text,
                 digits_right(h, (double)h->best, off), best, sizeof best);
    for (int i = 0; i < v->count; i++) {
        const struct peak *p = &h->peak[i];
        const bool is_range = p->low < p->high;
        const char *name = v->range[i].parameter->name;
        text_add(where, sizeof where, "%s", i ? " and " : is_range && v->count == 1 ? "for " : "at ");
        if (is_range && v->count == 1) {
            plateau_write(h, i, where, sizeof where);
            continue;
        }
        text_add(where, sizeof where, "%s = ", name);
        place_write(h, i, (domq_real)p->x, digits_right(h, p->x, p->within), where, sizeof where);
        if (p->end == PEAK_AT_FROM || p->end == PEAK_AT_TO)
            text_add(where, sizeof where, ", the %s value that was tried%s",
                     p->end == PEAK_AT_FROM ? "smallest" : "largest", i + 1 < v->count ? "," : "");
        if (!is_range)
            continue;
        text_add(same, sizeof same, *same ? ", and for " : "It is the same for ");
        plateau_write(h, i, same, sizeof same);
        text_add(same, sizeof same, " at this %s", v->range[1 - i].parameter->name);
    }
    answer_say(a, "%s is %s, %s, %s.", v->question->name, h->sign < 0 ? "smallest" : "largest", best, where);
    if (*same)
        answer_say(a, "%s.", same);
    if (*h->beyond)
        answer_say(a, "%s.", h->beyond);
    else if (h->missing > 0)
        answer_say(a, "%zu of the %zu values of %s that were tried gave no answer; 'details' says why.",
                   h->missing, h->line->count, v->range->parameter->name);
    if (h->missing > 0)
        answer_detail(a, "The first of the %zu values of %s without an answer: %s.", h->missing,
                      v->range->parameter->name, h->reason);
}

static bool optimum_answer(const struct query *query, struct answer *a, struct problem *problem,
                           bool is_minimum)
{
    static const char *const ends[] = {[PEAK_INSIDE] = "inside",
                                       [PEAK_AT_FROM] = "from",
                                       [PEAK_AT_TO] = "to",
                                       [PEAK_BEFORE_HOLE] = "hole",
                                       [PEAK_AFTER_HOLE] = "hole"};
    const struct varied *v = query->given->bound;
    struct hunt *h = calloc(1, sizeof *h);
    if (!h)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    hunt_begin(h, v,
               (struct probe){
                   .query = query, .command = problem->command, .question = v->question, .seeks_yes = true},
               is_minimum);
    const bool done = hunt_run(h, problem);
    const double off = fmax(h->peak[0].off, h->peak[1].off);
    if (done)
        best_say(h, a, off);
    for (int i = 0; i < v->count && done && !answer_lost(a); i++) {
        const struct peak *p = &h->peak[i];
        answer_cells(a, cell_word(v->range[i].parameter->name), cell_real((domq_real)p->x),
                     cell_real((domq_real)p->within), cell_real((domq_real)p->low),
                     cell_real((domq_real)p->high), cell_word(ends[p->end]), cell_real(h->best),
                     cell_real((domq_real)off), cell_word(*h->probe.unit_text ? h->probe.unit_text : "-"));
    }
    free(h);
    return done;
}

bool run_maximize(const struct query *query, struct answer *a, struct problem *problem)
{
    return optimum_answer(query, a, problem, false);
}

bool run_minimize(const struct query *query, struct answer *a, struct problem *problem)
{
    return optimum_answer(query, a, problem, true);
}
