/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'solve', which finds where an answer has a given value, or where a verdict changes. */
#include "language/quad.h"
#include "sweeps/sweeps.h"
#include <math.h>
#include <stdlib.h>

enum { ROOTS_MOST = 64 };

/* The values of spots are differences, answer - value, or NaN if there is no answer. */
struct scan {
    struct search search;
    struct line *line; /* of the search */
    struct root {
        double x;
        const char *branch;
    } root[ROOTS_MOST]; /* the roots found so far; at the end they are sorted by x */
    int roots;
    double jump;             /* an x at which the answer jumps past the given value */
    struct spot most, least; /* the highest and the lowest spot; NaN if there is none */
};

/* ---- Roots ---- */

static void root_add(struct scan *s, double x, const char *branch)
{
    for (int i = 0; i < s->roots; i++)
        if (fabs(s->root[i].x - x) <= 1e-9 * fabs(x))
            return;
    if (s->roots < ROOTS_MOST)
        s->root[s->roots++] = (struct root){x, branch};
}

/* Finds the root between two spots with values of opposite signs. If the answer jumps past the given value,
 * so that there is no root, stores the x of the jump. */
static void root_between(struct scan *s, struct spot a, struct spot b)
{
    const bool rises = b.value > a.value;
    const double rise = fabs(b.value - a.value), value = fabs((double)s->search.sweep->value.value),
                 scale = value > 0 ? value : s->most.value - s->least.value;
    struct spot good = rises ? b : a, bad = rises ? a : b;
    seek_edge(line_at, s->line, &good, &bad, 0);
    const struct spot root = good.value <= -bad.value ? good : bad;
    if (fabs(root.value) > 1e-6 * rise && fabs(root.value) > 1e-9 * scale)
        s->jump = root.x;
    else
        root_add(s, root.x, rises ? "rising" : "falling");
}

static double equal_at(double x, void *line)
{
    return line_at(x, line) == 0 ? 0 : -1;
}

/* Looks for a root between two neighbouring points. */
static void look_between(struct scan *s, struct spot a, struct spot b)
{
    struct spot *const end[] = {&a, &b};
    for (int i = 0; i < 2; i++) {
        struct spot hole = *end[i];
        if (isnan(hole.value) && !isnan(end[1 - i]->value)) { /* the answers end in between */
            *end[i] = *end[1 - i];
            s->line->level = -HUGE_VAL;
            seek_edge(line_above, s->line, end[i], &hole, 0);
            end[i]->value = line_at(end[i]->x, s->line);
        }
    }
    for (int i = 0; i < 2; i++) {
        /* If the answer equals the value in a whole interval, only the ends of the interval are roots. */
        struct spot equal = *end[i], other = *end[1 - i];
        if (equal.value == 0 && other.value != 0) {
            const bool rises = i == 0 ? other.value > 0 : other.value < 0;
            seek_edge(equal_at, s->line, &equal, &other, 0);
            root_add(s, equal.x, rises ? "rising" : "falling");
            return;
        }
    }
    if (a.value * b.value < 0)
        root_between(s, a, b);
}

/* Finds where the verdict changes between two points. Without an answer the verdict counts as false. */
static void verdict_between(struct scan *s, struct spot a, struct spot b)
{
    const bool holds = a.value > 0;
    struct spot good = holds ? a : b, bad = holds ? b : a;
    if (holds == (b.value > 0))
        return;
    seek_edge(line_at, s->line, &good, &bad, 0);
    root_add(s, good.x, holds ? "true up to here" : "true from here on");
}

static void spot_see(struct scan *s, struct spot spot)
{
    if (isnan(spot.value))
        return;
    s->most = spot.value <= s->most.value ? s->most : spot;
    s->least = spot.value >= s->least.value ? s->least : spot;
}

/* Near a maximum or a minimum, the answer may cross the value twice between two points, and then both points
 * are on the same side of the value. If m is the highest or the lowest of three points, climbs from there. If
 * this leads to the other side, there is a root on either side of that spot. */
static void look_around(struct scan *s, struct spot a, struct spot m, struct spot b)
{
    const double sign = m.value < 0 ? 1 : -1;
    const double height = sign * m.value, left = sign * a.value, right = sign * b.value;
    if (m.value == 0 || !(height >= left && height >= right) || (height == left && height == right))
        return;
    s->search.sign = sign;
    struct spot top = seek_top(line_at, s->line, a.x, (struct spot){m.x, height}, b.x, 1e-8 * (b.x - a.x), 0);
    s->search.sign = 1;
    top.value *= sign;
    spot_see(s, top);
    if (a.value * top.value < 0) {
        root_between(s, a, top);
        root_between(s, top, b);
    }
}

static int compare_roots(const void *one, const void *other)
{
    const double a = ((const struct root *)one)->x, b = ((const struct root *)other)->x;
    return a < b ? -1 : a > b;
}

/* Searches the whole range. */
static bool scan_run(struct scan *s, struct problem *problem)
{
    const bool is_verdict = s->search.sweep->verdict;
    const struct spot *p = s->line->point;
    if (!search_points(&s->search, problem))
        return false;
    for (size_t k = 0; k < s->line->count; k++)
        spot_see(s, p[k]);
    for (size_t k = 1; k < s->line->count; k++)
        (is_verdict ? verdict_between : look_between)(s, p[k - 1], p[k]);
    for (size_t k = 1; k + 1 < s->line->count && !is_verdict; k++)
        if (!isnan(p[k].value))
            look_around(s, p[k - 1], p[k], p[k + 1]);
    qsort(s->root, (size_t)s->roots, sizeof *s->root, compare_roots);
    const struct scene *scene = s->search.probe.query->scene;
    return !dom_raised(scene->compute.interrupt) || problem_status(problem, scene, DOM_INTERRUPTED);
}

/* ---- The answer ---- */

const struct column solve_columns[] = {
    {"value", "", "the value of the parameter", 0},
    {"answer", "", "the answer at this value of the parameter; for a verdict, 1 means true", 0},
    {"branch", "",
     "whether the answer rises or falls with the parameter; for a verdict, on which side it is true", 15},
    {NULL, NULL, NULL, 0},
};

static void no_root_text(const struct scan *s, char *text, size_t size)
{
    const struct sweep *v = s->search.sweep;
    const char *name = v->grid.axis->parameter->name, *question = v->answer->name,
               *holds = v->answer->command->holds, *value = quad_text(v->value.value, 10);
    const bool below = s->most.value < 0; /* the answer is below the wanted value in the whole range */
    const struct spot *nearest = below ? &s->most : &s->least;
    char range[RANGES_TEXT];
    search_ranges(&s->search, range);
    if (isnan(s->most.value))
        snprintf(text, size, "%s has no answer for any %s: %s", question, range, s->search.reason);
    else if (v->verdict && s->most.value > 0)
        snprintf(text, size, "%s: %s for every %s", question, holds, range);
    else if (v->verdict)
        snprintf(text, size, "%s: for no %s is it true that %s", question, range, holds);
    else if (below || s->least.value > 0)
        snprintf(text, size, "%s is never %s for %s: the %s value is %s, at %s = %s", question, value, range,
                 below ? "largest" : "smallest", quad_text(quad_decimal(nearest->value) + v->value.value, 10),
                 name, quad_text(quad_decimal(nearest->x), 10));
    else
        snprintf(text, size, "%s is never %s for %s: it jumps over this value at %s = %s", question, value,
                 range, name, quad_text(quad_decimal(s->jump), 10));
}

/* Checks that the answer has the unit of the value, and is not constant. */
static bool scan_check(struct scan *s, struct problem *problem)
{
    const struct sweep *v = s->search.sweep;
    if (v->verdict || isnan(s->most.value))
        return true;
    (void)probe_at(&s->search.probe, quad_decimal(s->most.x));
    const struct quantity unit = s->search.probe.unit;
    const domq_real highest = (domq_real)s->most.value + v->value.value, size = quad(fabs)(highest),
                    tol = s->search.probe.query->scene->compute.tol,
                    change = (domq_real)(s->most.value - s->least.value);
    if (!quantity_is_number(v->value) && !quantity_alike(unit, v->value))
        return problem_error(problem, "%s is %s, but VALUE is %s", v->answer->name, expression_kind(unit),
                             expression_kind(v->value));
    return s->search.missing + 1 >= s->line->count || change > (domq_real)1e-12 * size + 10 * tol * size ||
           search_constant(&s->search, highest, problem);
}

static void scan_answer(struct scan *s, struct answer *a)
{
    char reason[1024];
    answer_columns(a, solve_columns)[0].unit = s->search.sweep->grid.axis->parameter->value->unit;
    for (int i = 0; i < s->roots; i++)
        answer_announce(a, "value", quad_decimal(s->root[i].x));
    for (int i = 0; i < s->roots && !answer_lost(a); i++) {
        const domq_real x = quad_decimal(s->root[i].x);
        answer_cells(a, cell_computed(x), cell_computed(probe_at(&s->search.probe, x)),
                     cell_word(s->root[i].branch));
    }
    if (s->roots > 0)
        return;
    no_root_text(s, reason, sizeof reason);
    if (answer_for_people(a))
        answer_say(a, "%s.", reason);
    else
        answer_row(a, ROW(cell_real(DOMQ_NAN), cell_real(DOMQ_NAN), cell_word("none")), reason);
}

bool run_solve(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct sweep *v = query->given->bound;
    struct scan *s = calloc(1, sizeof *s);
    if (!s)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    search_begin(&s->search, v,
                 (struct probe){.query = query,
                                .command = problem->command,
                                .question = v->answer,
                                .parameter = v->grid.axis->parameter,
                                .verdict = v->verdict},
                 1);
    s->line = s->search.line;
    s->most.value = s->least.value = (double)NAN;
    bool done = scan_run(s, problem) && scan_check(s, problem);
    if (done)
        scan_answer(s, a);
    free(s);
    return done;
}
