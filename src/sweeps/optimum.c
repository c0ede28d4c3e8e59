/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'maximize' and 'minimize', which find the values of one or two parameters at which an answer
 * is largest or smallest. */
#include "io/terminal.h"
#include "language/quad.h"
#include "language/text.h"
#include "parallel/workers.h"
#include "session/parameters.h"
#include "sweeps/peak.h"
#include "sweeps/sweeps.h"
#include "train/falling.h"
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- The question ---- */

enum { OPTIMUM_AXES = 2, OPTIMUM_POINTS = 41 /* along each of two parameters */ };

/* The arguments of a search, after binding. */
struct optimum {
    struct ranged range[OPTIMUM_AXES];
    int axes;
    const struct question *question;
    bool is_minimum;
};

struct optimum_parsed {
    struct ranged_parsed range[OPTIMUM_AXES];
    int axes;
    bool is_minimum;
    struct question question;
};

const char *optimum_names(const void *context, int k)
{
    (void)context;
    const struct parameter *p = session_parameters;
    while (p->name && (p->setting || p->words_only || p->of_precision ||
                       (p->from == p->to && !p->value->whole) || k-- > 0))
        p++;
    return p->name;
}

static bool names_parse(struct reader *r, struct question *q, bool is_minimum)
{
    struct optimum_parsed *o = q->parsed = reader_memory(r, sizeof *o);
    if (!o)
        return false;
    o->is_minimum = is_minimum;
    for (;;) {
        if (!ranged_parse(r, optimum_names, &o->range[o->axes++]))
            return false;
        if (o->axes == 2 && o->range[0].parameter == o->range[1].parameter)
            return problem_error(r->problem, "'%s' is named twice; name each parameter once",
                                 o->range[0].parameter->name);
        if (*r->at != ',')
            return ranges_end(r);
        if (o->axes == OPTIMUM_AXES)
            return problem_error(r->problem, "at most two parameters can be varied; 'set' gives the others a "
                                             "value");
        r->at = skip_blanks(r->at + 1);
        reader_place(r, r->at);
    }
}

bool maximize_parse(struct reader *r, struct question *q)
{
    return names_parse(r, q, false);
}

bool minimize_parse(struct reader *r, struct question *q)
{
    return names_parse(r, q, true);
}

bool optimum_parse_answer(struct reader *r, struct question *q)
{
    struct optimum_parsed *o = q->parsed;
    return colon_pass(r) && question_parse_any(r, &o->question, true);
}

bool optimum_bind(const struct question *q, const struct query *query, struct arguments *given,
                  struct problem *problem)
{
    const struct optimum_parsed *parsed = q->parsed;
    struct optimum *o = arguments_take(given, sizeof *o, query, problem);
    if (!o)
        return false;
    *o = (struct optimum){
        .axes = parsed->axes, .question = &parsed->question, .is_minimum = parsed->is_minimum};
    for (int i = 0; i < o->axes; i++)
        if (!ranged_bind(&parsed->range[i], q->text, query, &o->range[i], problem))
            return false;
    return true;
}

/* ---- The search ---- */

/* A search for the best answer. With two parameters, the answer for a value of the first one is the best
 * answer over the range of the second one. Values that are sought as minima have the opposite sign here. */
struct hunt {
    const struct optimum *optimum;
    struct probe probe;
    struct slope slope[OPTIMUM_AXES];
    double first;               /* the value of the first parameter, while the second one is varied */
    struct problem fault;       /* the last error in the question itself; its kind is PROBLEM_NONE before */
    double value[PEAK_POINTS];  /* the answers at the points along the first parameter */
    bool is_wrong[PEAK_POINTS]; /* the question itself turned out to be wrong at this point */
    size_t count, missing;      /* the number of these points, and of those without an answer */
    struct peak peak[OPTIMUM_AXES]; /* the result for each parameter */
    domq_real best;                 /* the best answer, with its own sign */
    domq_real off;                  /* its error is at most this */
    char reason[PROBLEM_TEXT / 2];  /* why the first of the missing answers is missing */
    char beyond[PROBLEM_TEXT / 2];  /* why there is no answer beyond the best place, or "" */
};

/* Returns the answer at a place, with its sign changed for a minimum. */
static double ask(struct hunt *h, const double place[OPTIMUM_AXES])
{
    struct assigned assigned[OPTIMUM_AXES];
    if (dom_raised(h->probe.query->scene->compute.interrupt))
        return (double)NAN;
    for (int i = 0; i < h->optimum->axes; i++)
        assigned[i] = (struct assigned){.parameter = h->optimum->range[i].parameter, .value = place[i]};
    h->best = probe_ask(&h->probe, assigned, h->optimum->axes);
    if (h->probe.wrong)
        h->fault = h->probe.problem;
    return (double)(h->optimum->is_minimum ? -h->best : h->best);
}

static double ask_only(double x, void *context)
{
    return ask(context, (const double[]){x, 0});
}

static double ask_second(double y, void *context)
{
    struct hunt *h = context;
    return ask(h, (const double[]){h->first, y});
}

/* Finds the best answer along the second parameter. */
static struct peak second_find(struct hunt *h, double first, bool is_rough)
{
    double value[OPTIMUM_POINTS];
    const struct slope *s = &h->slope[1];
    const size_t count = peak_points(s, OPTIMUM_POINTS);
    h->first = first;
    for (size_t k = 0; k < count; k++)
        value[k] = s->at(peak_point(s, count, k), s->context);
    return peak_find(s, value, count, is_rough);
}

static double ask_first(double x, void *context)
{
    return second_find(context, x, true).value;
}

static void hunt_prepare(struct hunt *h)
{
    const struct any_compute *compute = &h->probe.query->scene->compute;
    for (int i = 0; i < h->optimum->axes; i++) {
        const struct ranged *range = &h->optimum->range[i];
        h->slope[i] = (struct slope){.from = (double)range->from,
                                     .to = (double)range->to,
                                     .whole = range->parameter->value->whole,
                                     .at = i == 1                  ? ask_second
                                           : h->optimum->axes == 2 ? ask_first
                                                                   : ask_only,
                                     .context = h,
                                     .noise = fmax(4 * (double)compute->tol, 1e-15),
                                     .least = i == 0 && h->optimum->axes == 2 ? 2e-6 : 1e-10,
                                     .interrupt = compute->interrupt};
    }
}

/* A dom_task, which computes the answer at point k. Each task has its own copy of the search. */
static void point_task(size_t k, void *context)
{
    struct hunt *all = context, mine = {.optimum = all->optimum, .probe = all->probe};
    hunt_prepare(&mine);
    all->value[k] = mine.slope[0].at(peak_point(&mine.slope[0], all->count, k), &mine);
    all->is_wrong[k] = mine.fault.kind != PROBLEM_NONE;
}

/* Computes the answers along the first parameter. */
static bool points_ask(struct hunt *h, struct problem *problem)
{
    const struct scene *scene = h->probe.query->scene;
    struct task_pool pool = {.threads = h->probe.query->state->settings.threads,
                             .progress = true,
                             .interrupt = scene->compute.interrupt};
    h->count = peak_points(&h->slope[0], h->optimum->axes == 2 ? OPTIMUM_POINTS : PEAK_POINTS);
    const enum dom_status status = workers_tasks(h->count, point_task, h, &pool);
    progress_end();
    if (status != DOM_OK)
        return problem_status(problem, scene, status);
    for (size_t k = 0; k < h->count; k++) {
        const bool is_first = isnan(h->value[k]) && h->missing++ == 0;
        if (!is_first && !h->is_wrong[k])
            continue;
        (void)h->slope[0].at(peak_point(&h->slope[0], h->count, k), h);
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
    const enum peak_end end = h->peak[i].end;
    const double range = h->slope[i].to - h->slope[i].from,
                 by = h->slope[i].whole ? 1 : 1e-6 * range; /* nearer, the place may not be in the hole */
    double place[] = {h->peak[0].x, h->peak[1].x};
    if (end != PEAK_BEFORE_HOLE && end != PEAK_AFTER_HOLE)
        return;
    place[i] = end == PEAK_BEFORE_HOLE ? h->peak[i].high + by : h->peak[i].low - by;
    if (isnan(ask(h, place)))
        snprintf(h->beyond, sizeof h->beyond, "For a %s %s it has no answer: %.*s",
                 end == PEAK_BEFORE_HOLE ? "larger" : "smaller", h->optimum->range[i].parameter->name,
                 (int)sizeof h->beyond - 64, h->probe.problem.text);
}

/* The second parameter changes with the first one along the ridge of the best answers, so the error of the
 * first one adds to its own. */
static void errors_add(struct hunt *h)
{
    struct peak *p = h->peak;
    const double step = fmax(1e-4 * (h->slope[0].to - h->slope[0].from), p[0].within);
    const double x = p[0].x + (p[0].x + step <= h->slope[0].to ? step : -step);
    const struct peak beside = second_find(h, x, true);
    if (isfinite(beside.x) && p[1].low == p[1].high)
        p[1].within = hypot(p[1].within, fabs(beside.x - p[1].x) / step * p[0].within);
}

static bool hunt_run(struct hunt *h, struct problem *problem)
{
    const struct scene *scene = h->probe.query->scene;
    hunt_prepare(h);
    if (!points_ask(h, problem))
        return false;
    h->peak[0] = peak_find(&h->slope[0], h->value, h->count, false);
    if (h->optimum->axes == 2 && isfinite(h->peak[0].x)) {
        h->peak[1] = second_find(h, h->peak[0].x, false);
        errors_add(h);
    }
    if (isfinite(h->peak[0].x)) {
        for (int i = 0; i < h->optimum->axes; i++)
            hole_ask(h, i);
        (void)ask(h, (const double[]){h->peak[0].x, h->peak[1].x}); /* h->best is the answer of this place */
        h->off = fmax(h->peak[0].off, h->peak[1].off);
    }
    return !dom_raised(scene->compute.interrupt) || problem_status(problem, scene, DOM_INTERRUPTED);
}

/* ---- What is not an optimum ---- */

/* Writes the ranges, as in "s = 0.02 .. 1 and r = 1 .. 4". */
static void ranges_write(const struct optimum *o, char *text, size_t size)
{
    *text = '\0';
    for (int i = 0; i < o->axes; i++)
        text_add(text, size, "%s%s = %s .. %s", i ? " and " : "", o->range[i].parameter->name,
                 quad_text(o->range[i].from, 10), quad_text(o->range[i].to, 10));
}

/* Fails if there is no answer at all, or only one. */
static bool hunt_check(const struct hunt *h, struct problem *problem)
{
    const struct optimum *o = h->optimum;
    char ranges[192], names[64];
    bool is_constant = true;
    for (int i = 0; i < o->axes; i++)
        is_constant = is_constant && h->peak[i].low <= h->slope[i].from && h->peak[i].high >= h->slope[i].to;
    ranges_write(o, ranges, sizeof ranges);
    snprintf(names, sizeof names, "%.24s%s%.24s", o->range[0].parameter->name, o->axes == 2 ? " and " : "",
             o->axes == 2 ? o->range[1].parameter->name : "");
    if (isnan(h->peak[0].x))
        return problem_no_answer(problem, "%s has no answer for any %s: %s", o->question->name, ranges,
                                 h->reason);
    return !is_constant || problem_no_answer(problem,
                                             "%s does not depend on %s: it is %s everywhere in %s; "
                                             "'sensitivity' shows what it depends on",
                                             o->question->name, names, quad_text(h->best, 10), ranges);
}

/* Searches the whole range. The caller frees *hunt. On failure, sets *problem and returns NULL. */
static struct hunt *optimum_find(const struct optimum *optimum, const struct query *query,
                                 struct problem *problem)
{
    struct hunt *h = calloc(1, sizeof *h);
    if (!h) {
        problem_status(problem, query->scene, DOM_NO_MEMORY);
        return NULL;
    }
    h->optimum = optimum;
    h->probe = (struct probe){
        .query = query, .command = problem->command, .question = optimum->question, .seeks_yes = true};
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    const bool done = hunt_run(h, problem) && hunt_check(h, problem);
    gsl_set_error_handler(handler);
    if (done)
        return h;
    free(h);
    return NULL;
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

enum { PLACE = 2 * CELL_TEXT + 64 };

/* Writes a value of a parameter with its unit. A share of the height is followed by the length. */
static void place_write(const struct hunt *h, int i, domq_real value, int digits, char text[PLACE])
{
    const struct query *query = h->probe.query;
    const struct answer_style style = state_style(query->state);
    const char *unit = h->optimum->range[i].parameter->value->unit;
    if (strcmp(unit, "h") == 0) {
        domq_real height = query->scene->scale.h;
        for (int k = 0; k < h->optimum->axes; k++)
            if (strcmp(h->optimum->range[k].parameter->name, "h") == 0)
                height = h->peak[k].x;
        snprintf(text, PLACE, "%s (%s)", quad_text(value, digits),
                 measured(value * height, "m", digits < 4 ? digits : 4).text);
    } else if (strncmp(unit, "rad", 3) == 0) {
        snprintf(text, PLACE, "%s %s%s", quad_text(style_angle(&style, value), digits),
                 style_angle_unit(&style), unit + 3);
    } else {
        snprintf(text, PLACE, "%s", measured(value, unit, digits).text);
    }
}

/* Returns how many digits of a number are right, from 1 to the digits of the session. */
static int digits_right(const struct hunt *h, double x, double within)
{
    const int most = (int)h->probe.query->state->settings.style.digits;
    if (!(within > 0) || x == 0)
        return most;
    const double digits = floor(log10(fabs(x) / within));
    return digits < 1 ? 1 : digits < most ? (int)digits : most;
}

/* Writes "s = 0.63056 (3.0267 cm)", or "every s from 0.4 to 0.6" for a plateau. */
static void parameter_write(const struct hunt *h, int i, bool is_range, char *text, size_t size)
{
    const struct peak *p = &h->peak[i];
    const char *name = h->optimum->range[i].parameter->name;
    char place[PLACE], high[PLACE];
    const bool whole = h->slope[i].whole;
    const domq_real nearly = 1e-12; /* 1.45 must not be rounded down to 1.449 */
    if (!is_range) {
        place_write(h, i, p->x, digits_right(h, p->x, p->within), place);
        text_add(text, size, "%s = %s", name, place);
        return;
    }
    domq_real from = whole ? p->low : round_digits((domq_real)p->low * (1 - nearly), 4, true),
              to = whole ? p->high : round_digits((domq_real)p->high * (1 + nearly), 4, false);
    if (!(from <= to)) { /* the range is narrower than its rounding */
        from = p->low;
        to = p->high;
    }
    place_write(h, i, from, 10, place);
    place_write(h, i, to, 10, high);
    text_add(text, size, "every %s from %s to %s", name, place, high);
}

static void best_say(const struct hunt *h, struct answer *a)
{
    const struct optimum *o = h->optimum;
    const domq_real best_value = quad(fabs)(h->best) > h->off ? h->best : 0;
    char best[CELL_TEXT], where[1024] = "", same[1024] = "";
    const int digits = digits_right(h, (double)h->best, (double)h->off);
    if (strcmp(h->probe.unit_text, "rad") == 0)
        snprintf(best, sizeof best, "%s %s", quad_text(style_angle(&a->style, best_value), digits),
                 style_angle_unit(&a->style));
    else
        snprintf(best, sizeof best, "%s", measured(best_value, h->probe.unit_text, digits).text);
    for (int i = 0; i < o->axes; i++) {
        const struct peak *p = &h->peak[i];
        const bool is_range = p->low < p->high;
        text_add(where, sizeof where, i ? " and " : "");
        parameter_write(h, i, is_range && o->axes == 1, where, sizeof where);
        if (p->end == PEAK_AT_FROM || p->end == PEAK_AT_TO)
            text_add(where, sizeof where, ", the %s value that was tried%s",
                     p->end == PEAK_AT_FROM ? "smallest" : "largest", i + 1 < o->axes ? "," : "");
        if (!is_range || o->axes == 1)
            continue;
        text_add(same, sizeof same, *same ? ", and for " : "It is the same for ");
        parameter_write(h, i, true, same, sizeof same);
        text_add(same, sizeof same, " at this %s", o->range[1 - i].parameter->name);
    }
    answer_say(a, "%s is %s, %s, %s %s.", o->question->name, o->is_minimum ? "smallest" : "largest", best,
               o->axes == 1 && h->peak[0].low < h->peak[0].high ? "for" : "at", where);
    if (*same)
        answer_say(a, "%s.", same);
}

static void missing_say(const struct hunt *h, struct answer *a)
{
    char missing[256];
    snprintf(missing, sizeof missing, "%zu of the %zu values of %s that were tried gave no answer",
             h->missing, h->count, h->optimum->range[0].parameter->name);
    if (*h->beyond)
        answer_say(a, "%s.", h->beyond);
    else if (h->missing > 0)
        answer_say(a, "%s; 'details' says why.", missing);
    if (h->missing > 0)
        answer_detail(a, "The first of the %zu values of %s without an answer: %s.", h->missing,
                      h->optimum->range[0].parameter->name, h->reason);
}

bool run_optimum(const struct query *query, struct answer *a, struct problem *problem)
{
    static const char *const ends[] = {[PEAK_INSIDE] = "inside",
                                       [PEAK_AT_FROM] = "from",
                                       [PEAK_AT_TO] = "to",
                                       [PEAK_BEFORE_HOLE] = "hole",
                                       [PEAK_AFTER_HOLE] = "hole"};
    const struct optimum *o = query->given->bound;
    struct hunt *h = optimum_find(o, query, problem);
    if (!h)
        return false;
    best_say(h, a);
    missing_say(h, a);
    for (int i = 0; i < o->axes && !answer_lost(a); i++) {
        const struct peak *p = &h->peak[i];
        answer_cells(a, cell_word(o->range[i].parameter->name), cell_real(p->x), cell_real(p->within),
                     cell_real(p->low), cell_real(p->high), cell_word(ends[p->end]), cell_real(h->best),
                     cell_real(h->off), cell_word(*h->probe.unit_text ? h->probe.unit_text : "-"));
    }
    free(h);
    return true;
}
