/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot fall, speed, gaps: what happens along the row, and how far its gaps may be off. */
#include "answer/measure.h"
#include "commands/plots/plots.h"
#include "commands/rows/falling.h"
#include "commands/rows/row_run.h"
#include "commands/walk.h"
#include "io/terminal.h"
#include <stdlib.h>

/* ---- Energy to spare ---- */

/* Returns the share of its barrier that a domino has more than it needs; NaN where the question is idle: the
 * first, tipped over its edge, has just what it needs. */
static double spare_of(const struct row_run *ran, size_t i)
{
    const struct domq_fall *f = &ran->fall[i];
    return row_run_tipped(ran, i) || !(f->barrier > 0) ? (double)NAN : (double)(f->margin / f->barrier);
}

/* Says in percent what the picture shows. */
static void fall_note(const struct row_run *ran, char *note, size_t size)
{
    const struct domq_verdict *v = &ran->verdict;
    const struct domq_fall *last = &ran->fall[ran->hits - 1];
    if (v->end == DOM_ROW_STOPS && last->barrier > 0 && isfinite(last->barrier))
        snprintf(note, size, "Domino %zu stops: it has %.40s of the energy that it needs.", v->domino,
                 measured(fall_share(last), "share", 3).text);
    else if (v->end != DOM_ROW_FALLS)
        snprintf(note, size, "The row ends at domino %zu: %s.", v->domino, dom_row_end_text(v->end));
    else if (v->weakest && isfinite(v->spare))
        snprintf(note, size, "%.40s. Domino %zu is the weakest: it has %.40s more than it needs.",
                 all_fall_words(ran->scene.row.count).text, v->weakest, measured(v->spare, "share", 3).text);
    else
        snprintf(note, size, "%.40s.", all_fall_words(ran->scene.row.count).text);
}

static bool fall_chart(const struct query *query, struct answer *a, struct problem *problem,
                       const struct row_run *ran)
{
    struct chart chart = chart_make();
    const struct domq_verdict *v = &ran->verdict;
    double least = HUGE_VAL, most = 0;
    for (size_t i = 0; i < ran->hits; i++) {
        double spare = 100 * spare_of(ran, i);
        least = spare > 0 && spare < least ? spare : least;
        most = isfinite(spare) && spare > most ? spare : most;
    }
    snprintf(chart.title, sizeof chart.title, "Energy to spare, domino by domino");
    snprintf(chart.x.label, sizeof chart.x.label, "domino");
    snprintf(chart.y.label, sizeof chart.y.label, "more than it needs, in %%");
    fall_note(ran, chart.note, sizeof chart.note);
    chart.x.whole = chart.y.logarithmic = true;
    chart.x.low = 0.4;
    chart.x.high = (double)ran->scene.row.count + 0.6;
    chart.y.low = least < HUGE_VAL ? pow(10, floor(log10(least / 2))) : 1;
    chart.y.high = fmax(1.6 * most, 100 * chart.y.low);
    struct chart_curve *spares = chart_curve(&chart, CHART_POINTS, INK_BLUE, 0, "%s", "");
    for (size_t i = 0; i < ran->hits; i++)
        chart_point(&chart, spares, (double)ran->fall[i].domino, 100 * spare_of(ran, i));
    struct chart_curve *idle = NULL;
    for (size_t i = 0; i < ran->hits; i++)
        if (ran->fall[i].domino > 1 && !(ran->fall[i].barrier > 0)) {
            idle = idle ? idle : chart_curve(&chart, CHART_POINTS, INK_GREY, 0, "needs no energy");
            chart_point(&chart, idle, (double)ran->fall[i].domino, chart.y.high);
        }
    if (v->weakest && v->weakest <= ran->hits && v->spare >= 0 && isfinite(v->spare)) {
        struct chart_curve *weak =
            chart_curve(&chart, CHART_POINTS, INK_RED, 0, "the weakest, domino %zu", v->weakest);
        chart_point(&chart, weak, (double)v->weakest, fmax(100 * (double)v->spare, chart.y.low));
    }
    if (v->end != DOM_ROW_FALLS) {
        struct chart_curve *end =
            chart_curve(&chart, CHART_POINTS, INK_TEXT, 0, "here it ends, domino %zu", v->domino);
        chart_point(&chart, end, (double)v->domino, chart.y.low);
    }
    return chart_show(&chart, a, query->scene->compute.interrupt, problem);
}

bool plot_fall(const struct query *query, struct answer *a, struct problem *problem)
{
    struct row_run ran;
    bool people = answer_for_people(a);
    if ((people && !picture_ready(a, problem)) || !row_run(query, problem, false, &ran))
        return false;
    if (scene_weighed(query->scene) && !people)
        columns_in_joules(a);
    for (size_t i = 0; i < ran.hits && !people; i++) {
        const struct domq_fall *f = &ran.fall[i];
        bool known = isfinite(f->barrier);
        answer_cells(a, cell_count((domq_real)f->domino), cell_real(f->kinetic),
                     cell_real(known ? f->barrier : DOMQ_NAN), cell_real(known ? f->margin : DOMQ_NAN),
                     cell_real((domq_real)spare_of(&ran, i)));
    }
    bool idle = people && ran.scene.row.count == 1 && isnan(spare_of(&ran, 0));
    if (idle)
        problem_no_answer(problem,
                          "the only domino is tipped over its edge, and needs no energy; 'effect row 5' "
                          "sets up five");
    bool shown = !people || (!idle && fall_chart(query, a, problem, &ran));
    row_run_free(&ran);
    return shown;
}

/* ---- Speed of the front ---- */

/* Returns the speed from the hit of a domino to that of the next; NaN where there is none. */
static double speed_of(const struct row_run *ran, size_t i)
{
    size_t next = ran->fall[i].domino; /* as an index */
    if (next >= ran->scene.row.count || i + 1 >= ran->hits)
        return (double)NAN;
    const struct domq_domino *d = &ran->scene.domino[next];
    return (double)((d->gap + d->thickness) / ran->fall[i].duration);
}

static double place_of(const struct row_run *ran, size_t i)
{
    domq_real place = 0;
    for (size_t k = 1; k < ran->fall[i].domino; k++)
        place += ran->scene.domino[k].gap + ran->scene.domino[k].thickness;
    return (double)place;
}

static bool speed_chart(const struct query *query, struct answer *a, struct problem *problem,
                        const struct row_run *ran)
{
    struct chart chart = chart_make();
    double last = (double)NAN;
    const struct axis_unit unit = measure_axis(place_of(ran, ran->hits - 1));
    snprintf(chart.title, sizeof chart.title, "Speed of the front along the row");
    snprintf(chart.x.label, sizeof chart.x.label, "distance from the first domino in %s", unit.name);
    snprintf(chart.y.label, sizeof chart.y.label, "speed in m/s");
    if (ran->verdict.end == DOM_ROW_FALLS && isfinite(ran->verdict.seconds))
        snprintf(chart.note, sizeof chart.note, "%.40s; the last lies after %.40s.",
                 all_fall_words(ran->scene.row.count).text, measured(ran->verdict.seconds, "s", 4).text);
    else
        snprintf(chart.note, sizeof chart.note, "The row ends at domino %zu: %s.", ran->verdict.domino,
                 dom_row_end_text(ran->verdict.end));
    enum { DOTS = 120 }; /* more of them would hide the curve */
    chart.x.low = chart.y.low = 0;
    struct chart_curve *front = chart_curve(&chart, CHART_STEPS, INK_BLUE, 0, "%s", "");
    struct chart_curve *hits =
        ran->hits <= DOTS ? chart_curve(&chart, CHART_POINTS, INK_TEXT, 0, "a domino is hit") : NULL;
    for (size_t i = 0; i < ran->hits; i++) {
        double speed = speed_of(ran, i), at = place_of(ran, i) / unit.size;
        chart_point(&chart, front, at, isnan(speed) ? last : speed);
        if (hits)
            chart_point(&chart, hits, at, speed);
        last = speed;
    }
    return chart_show(&chart, a, query->scene->compute.interrupt, problem);
}

bool plot_speed(const struct query *query, struct answer *a, struct problem *problem)
{
    struct row_run ran;
    bool people = answer_for_people(a);
    if ((people && !picture_ready(a, problem)) || !row_run(query, problem, true, &ran))
        return false;
    if (ran.timeless) {
        row_run_free(&ran);
        return row_status(query, problem, DOM_NO_MARGIN);
    }
    for (size_t i = 0; i < ran.hits && !people; i++)
        answer_cells(a, cell_count((domq_real)ran.fall[i].domino), cell_real((domq_real)place_of(&ran, i)),
                     cell_real((domq_real)speed_of(&ran, i)));
    bool runs = false;
    for (size_t i = 0; i < ran.hits && !runs; i++)
        runs = !isnan(speed_of(&ran, i));
    if (people && !runs)
        problem_no_answer(problem, ran.scene.row.count == 1
                                       ? "a front needs two dominoes; 'effect row 5' sets up five"
                                       : "the row ends before the front has a speed; 'fall' shows where, and "
                                         "'mend' finds what saves it");
    bool shown = !people || (runs && speed_chart(query, a, problem, &ran));
    row_run_free(&ran);
    return shown;
}

/* ---- Windows of the gaps ---- */

static void gaps_progress(size_t done, size_t of, void *context)
{
    progress_show(context, (double)done / (double)of);
}

/* Says which gap must be kept most precisely, or which change saves the row. */
static void gaps_note(const struct domq_window *w, size_t count, bool falls, char *note, size_t size)
{
    size_t tight = count;
    double least = HUGE_VAL;
    for (size_t i = 0; i < count; i++) {
        double room =
            (double)(falls ? fmin((double)(w[i].now - w[i].low), (double)(w[i].high - w[i].now))
                           : fmin(fabs((double)(w[i].low - w[i].now)), fabs((double)(w[i].high - w[i].now))));
        if (room < least) {
            least = room;
            tight = i;
        }
    }
    if (tight == count) {
        snprintf(note, size, "The row does not fall, and no change of a single gap saves it.");
        return;
    }
    const struct domq_window *t = &w[tight];
    if (falls)
        snprintf(note, size,
                 "The tightest: the gap before domino %zu, %.30s, may be %.30s narrower or %.30s wider.",
                 t->domino, measured(t->now, "m", 3).text, measured(t->now - t->low, "m", 3).text,
                 measured(t->high - t->now, "m", 3).text);
    else
        snprintf(note, size,
                 "The row does not fall as planned. It does with %.30s to %.30s before domino %zu.",
                 measured(t->low, "m", 3).text, measured(t->high, "m", 3).text, t->domino);
}

static bool gaps_chart(const struct query *query, struct answer *a, struct problem *problem,
                       const struct domq_window *w, size_t count)
{
    struct chart chart = chart_make();
    double longest = 0, widest = 0, narrowest = HUGE_VAL, lowest = HUGE_VAL;
    bool falls = false;
    for (size_t i = 0; i < count; i++) {
        double gap = (double)w[i].now;
        longest = fmax(longest, fmax(gap, isnan((double)w[i].high) ? 0 : (double)w[i].high));
        widest = fmax(widest, gap);
        narrowest = gap > 0 ? fmin(narrowest, gap) : narrowest;
        lowest = w[i].low > 0 ? fmin(lowest, (double)w[i].low) : lowest;
        falls = falls || (w[i].low <= w[i].now && w[i].now <= w[i].high);
    }
    const struct axis_unit unit = measure_axis(longest);
    snprintf(chart.title, sizeof chart.title, "How far each gap may be off, the others being as planned");
    snprintf(chart.x.label, sizeof chart.x.label, "gap before domino");
    snprintf(chart.y.label, sizeof chart.y.label, "gap in %s", unit.name);
    gaps_note(w, count, falls, chart.note, sizeof chart.note);
    chart.x.whole = true;
    chart.y.logarithmic = widest > 3 * narrowest;
    chart.y.low = chart.y.logarithmic ? fmin(lowest, narrowest) / unit.size / 1.5 : 0;
    struct chart_curve *range = chart_curve(&chart, CHART_RANGES, INK_BLUE, 0, "all fall");
    struct chart_curve *planned = chart_curve(&chart, CHART_POINTS, INK_TEXT, 0, "planned");
    for (size_t i = 0; i < count; i++) {
        double x = (double)w[i].domino;
        chart_range(&chart, range, x, (double)NAN, fmax((double)w[i].low / unit.size, chart.y.low),
                    (double)w[i].high / unit.size);
        chart_point(&chart, planned, x, fmax((double)w[i].now / unit.size, chart.y.low));
    }
    return chart_show(&chart, a, query->scene->compute.interrupt, problem);
}

bool plot_gaps(const struct query *query, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    struct progress progress = {0, 0};
    bool people = answer_for_people(a), done = false;
    if ((people && !picture_ready(a, problem)) || !scene_row_make(query->scene, &scene, problem))
        return false;
    size_t count = scene.row.count - 1;
    struct domq_window *w = calloc(count ? count : 1, sizeof *w);
    enum dom_status status =
        w ? domq_row_windows(&scene.row, &scene.compute, DOM_WINDOW_GAP, gaps_progress, &progress, w)
          : DOM_NO_MEMORY;
    progress_show(&progress, 1);
    if (status != DOM_OK)
        row_status(query, problem, status);
    else if (count == 0)
        problem_no_answer(problem, "a row of one domino has no gap");
    else
        done = !people || gaps_chart(query, a, problem, w, count);
    for (size_t i = 0; i < count && done && !people; i++)
        answer_cells(a, cell_count((domq_real)w[i].domino), cell_real(w[i].now), cell_real(w[i].low),
                     cell_real(w[i].high), cell_flag(w[i].others));
    free(scene.domino);
    free(w);
    return done;
}
