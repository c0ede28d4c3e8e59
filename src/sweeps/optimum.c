/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'maximize' and 'minimize', which find the values of one or two parameters at which an answer
 * is largest or smallest. */
#include "language/quad.h"
#include "language/text.h"
#include "sweeps/sweeps.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct peak {
    double x, value;  /* NaN if there is no value at all */
    double within;    /* the error of x is at most this; 0 for an end of the range */
    double off;       /* the error of the value is at most this */
    double low, high; /* the value is the same from `low` to `high`; without such a plateau, both are x */
    enum { PEAK_INSIDE, PEAK_AT_FROM, PEAK_AT_TO, PEAK_BEFORE_HOLE, PEAK_AFTER_HOLE } end;
};

struct hunt {
    struct search search;
    struct peak peak[SEARCHED_MOST]; /* the result for each parameter */
    char beyond[PROBLEM_TEXT / 2];   /* why there is no answer beyond the best place, or "" */
};

/* ---- The search ---- */

/* Returns the highest spot around point k, whose neighbours are not higher. */
static struct spot top_around(struct line *l, size_t k, double grain)
{
    struct spot top = l->point[k];
    const struct spot here = top;
    double bound[2] = {here.x, here.x};
    const bool is_outer = l->axis + 1 < l->search->sweep->grid.axes;
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
    const double tol = (double)l->search->probe.query->scene->compute.tol,
                 noise = fmax(4 * tol, 1e-15) * fabs(p->value), range = l->to - l->from,
                 part = l->whole ? 0.5 : 0.05 * range / (double)(l->count - 1),
                 near = l->whole ? 1 : fmax(1e-9 * range, 2 * l->grain);
    l->level = p->value - noise;
    p->low = plateau_end(l, p->x, -1);
    p->high = plateau_end(l, p->x, 1);
    p->off = noise;
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
    if (is_plateau || l->whole || p->end == PEAK_AT_FROM || p->end == PEAK_AT_TO)
        return;
    p->within = p->end == PEAK_INSIDE ? off : 1e-2 * l->grain; /* an edge is found more exactly */
    for (int side = -1; side < 2 && p->end == PEAK_INSIDE; side += 2)
        p->off = fmax(p->off, noise + p->value - line_at(p->x + side * off, l));
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

static struct peak line_best(struct line *l, bool is_rough)
{
    line_place(l);
    for (size_t k = 0; k < l->count; k++)
        l->point[k].value = line_at(l->point[k].x, l);
    return peak_find(l, is_rough);
}

static double best_along(struct line *second)
{
    return line_best(second, true).value;
}

/* Finds the best place of the second parameter. It changes with the first one along the ridge of the best
 * answers, so the error of the first one adds to its own. */
static void second_find(struct hunt *h)
{
    struct peak *p = h->peak;
    struct search *s = &h->search;
    const double step = fmax(1e-4 * (s->line[0].to - s->line[0].from), p[0].within);
    s->place[0] = p[0].x;
    p[1] = line_best(&s->line[1], false);
    s->place[0] = p[0].x + (p[0].x + step <= s->line[0].to ? step : -step);
    const struct peak beside = line_best(&s->line[1], true);
    if (isfinite(beside.x) && p[1].low == p[1].high)
        p[1].within = hypot(p[1].within, fabs(beside.x - p[1].x) / step * p[0].within);
}

/* Asks for the answer at the best place or, if `by` is not 0, beside it along parameter i. */
static double best_ask(struct hunt *h, int i, double by)
{
    for (int k = 0; k < h->search.sweep->grid.axes; k++)
        h->search.place[k] = h->peak[k].x;
    if (by != 0)
        h->search.place[i] = (by > 0 ? h->peak[i].high : h->peak[i].low) + by;
    return search_ask(&h->search);
}

/* Searches the whole range. Fails if there is no answer at all, or only one. */
static bool hunt_run(struct hunt *h, struct problem *problem)
{
    struct search *s = &h->search;
    const struct scene *scene = s->probe.query->scene;
    bool is_constant = true;
    if (!search_points(s, problem))
        return false;
    h->peak[0] = peak_find(s->line, false);
    const bool is_found = isfinite(h->peak[0].x);
    if (is_found && s->sweep->grid.axes == 2)
        second_find(h);
    for (int i = 0; i < s->sweep->grid.axes && is_found; i++) {
        const struct peak *p = &h->peak[i];
        const struct line *l = &s->line[i];
        const bool is_before = p->end == PEAK_BEFORE_HOLE, is_after = p->end == PEAK_AFTER_HOLE;
        /* nearer, the place may not be in the hole */
        const double by = l->whole ? 1 : 1e-6 * (l->to - l->from);
        if ((is_before || is_after) && isnan(best_ask(h, i, is_before ? by : -by)))
            snprintf(h->beyond, sizeof h->beyond, "For a %s %s it has no answer: %.*s",
                     is_before ? "larger" : "smaller", s->sweep->grid.axis[i].parameter->name,
                     (int)sizeof h->beyond - 64, s->probe.problem.text);
        is_constant = is_constant && p->low <= l->from && p->high >= l->to;
    }
    if (is_found)
        (void)best_ask(h, 0, 0); /* leaves the best answer in search.answer */
    if (dom_raised(scene->compute.interrupt))
        return problem_status(problem, scene, DOM_INTERRUPTED);
    char ranges[RANGES_TEXT];
    if (!is_found)
        return problem_no_answer(problem, "%s has no answer for any %s: %s", s->sweep->answer->name,
                                 search_ranges(s, ranges), s->reason);
    return !is_constant || search_constant(s, s->answer, problem);
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

/* Adds a number with its unit to a text, with the digits that are right: from 1 to those of the session.
 * Angles are in the session's unit. A share of the height is followed by the length, unless the height is
 * varied, too. */
static void number_add(const struct hunt *h, domq_real value, double within, const char *unit, char *text,
                       size_t size)
{
    const struct query *query = h->search.probe.query;
    const struct answer_style style = state_style(query->state);
    const double most = (double)query->state->settings.style.digits;
    const struct axis *axis = h->search.sweep->grid.axis;
    const struct parameter *height = parameter_find("h");
    const bool is_exact = !(within > 0) || value == 0;
    const int digits =
        (int)(is_exact ? most : fmin(most, fmax(1, floor(log10(fabs((double)value) / within)))));
    if (strncmp(unit, "rad", 3) == 0)
        text_add(text, size, "%s %s%s", quad_text(style_angle(&style, value), digits),
                 style_angle_unit(&style), unit + 3);
    else if (strcmp(unit, "h") != 0)
        text_add(text, size, "%s", measured(value, unit, digits).text);
    else if (axis[0].parameter == height || axis[1].parameter == height)
        text_add(text, size, "%s", quad_text(value, digits));
    else
        text_add(text, size, "%s (%s)", quad_text(value, digits),
                 measured(value * query->scene->scale.h, "m", digits < 4 ? digits : 4).text);
}

/* Adds "every s from 0.4 to 0.6" for a plateau. */
static void plateau_add(const struct hunt *h, int i, char *text, size_t size)
{
    const struct peak *p = &h->peak[i];
    const struct parameter *parameter = h->search.sweep->grid.axis[i].parameter;
    const domq_real nearly = 1e-12; /* 1.45 must not be rounded down to 1.449 */
    domq_real from = (domq_real)p->low, to = (domq_real)p->high;
    const domq_real up = round_digits(from * (1 - nearly), 4, true),
                    down = round_digits(to * (1 + nearly), 4, false);
    if (!h->search.line[i].whole && up <= down) { /* otherwise the range is narrower than its rounding */
        from = up;
        to = down;
    }
    text_add(text, size, "every %s from ", parameter->name);
    number_add(h, from, 0, parameter->value->unit, text, size);
    text_add(text, size, " to ");
    number_add(h, to, 0, parameter->value->unit, text, size);
}

static void best_say(const struct hunt *h, struct answer *a, double off)
{
    const struct search *s = &h->search;
    const struct sweep *v = s->sweep;
    const char *name = v->grid.axis->parameter->name;
    char best[CELL_TEXT] = "", where[1024] = "", same[1024] = "";
    number_add(h, quad(fabs)(s->answer) > (domq_real)off ? s->answer : 0, off, s->probe.unit_text, best,
               sizeof best);
    for (int i = 0; i < v->grid.axes; i++) {
        const struct peak *p = &h->peak[i];
        const struct parameter *parameter = v->grid.axis[i].parameter;
        const bool is_range = p->low < p->high;
        if (is_range && v->grid.axes == 1) {
            text_add(where, sizeof where, "for ");
            plateau_add(h, i, where, sizeof where);
            continue;
        }
        text_add(where, sizeof where, "%s %s = ", i ? " and" : "at", parameter->name);
        number_add(h, (domq_real)p->x, p->within, parameter->value->unit, where, sizeof where);
        if (p->end == PEAK_AT_FROM || p->end == PEAK_AT_TO)
            text_add(where, sizeof where, ", the %s value that was tried%s",
                     p->end == PEAK_AT_FROM ? "smallest" : "largest", i + 1 < v->grid.axes ? "," : "");
        if (!is_range)
            continue;
        text_add(same, sizeof same, *same ? ", and for " : "It is the same for ");
        plateau_add(h, i, same, sizeof same);
        text_add(same, sizeof same, " at this %s", v->grid.axis[1 - i].parameter->name);
    }
    answer_say(a, "%s is %s, %s, %s.", v->answer->name, s->sign < 0 ? "smallest" : "largest", best, where);
    if (*same)
        answer_say(a, "%s.", same);
    if (*h->beyond)
        answer_say(a, "%s.", h->beyond);
    else if (s->missing > 0)
        answer_say(a, "%zu of the %zu values of %s that were tried gave no answer; 'details' says why.",
                   s->missing, s->line->count, name);
    if (s->missing > 0)
        answer_detail(a, "The first of the %zu values of %s without an answer: %s.", s->missing, name,
                      s->reason);
}

static bool optimum_answer(const struct query *query, struct answer *a, struct problem *problem, double sign)
{
    static const char *const ends[] = {[PEAK_INSIDE] = "inside",
                                       [PEAK_AT_FROM] = "from",
                                       [PEAK_AT_TO] = "to",
                                       [PEAK_BEFORE_HOLE] = "hole",
                                       [PEAK_AFTER_HOLE] = "hole"};
    const struct sweep *v = query->given->bound;
    struct hunt *h = calloc(1, sizeof *h);
    if (!h)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    struct search *s = &h->search;
    s->along = best_along;
    search_begin(
        s, v,
        (struct probe){.query = query, .command = problem->command, .question = v->answer, .seeks_yes = true},
        sign);
    const bool done = hunt_run(h, problem);
    const double off = fmax(h->peak[0].off, h->peak[1].off);
    if (done)
        best_say(h, a, off);
    for (int i = 0; i < v->grid.axes && done && !answer_lost(a); i++) {
        const struct peak *p = &h->peak[i];
        answer_cells(a, cell_word(v->grid.axis[i].parameter->name), cell_real((domq_real)p->x),
                     cell_real((domq_real)p->within), cell_real((domq_real)p->low),
                     cell_real((domq_real)p->high), cell_word(ends[p->end]), cell_real(s->answer),
                     cell_real((domq_real)off), cell_word(*s->probe.unit_text ? s->probe.unit_text : "-"));
    }
    free(h);
    return done;
}

bool run_maximize(const struct query *query, struct answer *a, struct problem *problem)
{
    return optimum_answer(query, a, problem, 1);
}

bool run_minimize(const struct query *query, struct answer *a, struct problem *problem)
{
    return optimum_answer(query, a, problem, -1);
}
