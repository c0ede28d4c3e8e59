/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the values of a parameter at which an answer is equal to a given value. */
#include "interpreter/symbols.h"
#include "language/quad.h"
#include "sweeps/sweeps.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#include <stdlib.h>

/* ---- Probes ---- */

/* Runs the command and sets *value to 1 if its verdict is true, and to -1 if it is false. Fails if the
 * command has no verdict. */
static bool verdict_ask(const struct probe *p, const struct query *at, struct quantity *value,
                        struct problem *problem)
{
    const struct command *c = p->question->command;
    struct answer answer = {.style = state_style(at->state), .columns = c->columns, .rows = c->rows};
    if (!question_ask(p->question, at, &answer, problem))
        return false;
    *value = (struct quantity){.value = answer.verdict == ANSWER_YES ? 1 : -1};
    return answer.verdict != ANSWER_OPEN || problem_no_answer(problem, "the command has no verdict here");
}

domq_real probe_ask(struct probe *p, const struct assigned *assigned, int count)
{
    struct state point;
    struct query at;
    struct run_context run_context = *p->query->run_context;
    struct quantity answer = {.value = 0};
    problem_begin(&p->problem, p->command);
    bool put = query_with(p->query, assigned, count, &point, &at, &p->problem);
    at.run_context = &run_context;
    run_context.shard.parts = 0;
    run_context.seeks_yes = p->seeks_yes;
    point.settings.threads = 1;
    bool done = put && (p->verdict ? verdict_ask(p, &at, &answer, &p->problem)
                                   : question_measure(p->question, &at, &answer, p->unit_text, &p->problem));
    p->wrong = put && !done && p->problem.kind != PROBLEM_NO_ANSWER;
    if (!done)
        return DOMQ_NAN;
    p->unit = answer;
    return isfinite(answer.value) ? answer.value : DOMQ_NAN;
}

domq_real probe_at(struct probe *p, domq_real value)
{
    const struct assigned assigned = {.parameter = p->parameter, .value = value};
    return probe_ask(p, &assigned, p->parameter != NULL);
}

bool probe_report(const struct probe *p, struct problem *problem)
{
    if (dom_raised(p->query->scene->compute.interrupt))
        return problem_status(problem, p->query->scene, DOM_INTERRUPTED);
    *problem = p->problem;
    return false;
}

/* ---- Roots ---- */

static domq_real scan_at(struct scan *s, domq_real x)
{
    domq_real f = probe_at(&s->probe, x) - s->solve->value.value;
    if (isnan(f)) {
        if (!*s->no_answer)
            snprintf(s->no_answer, sizeof s->no_answer, "%.*s", (int)sizeof s->no_answer - 1,
                     s->probe.problem.text);
        return f;
    }
    if (s->answers == 0 || f > s->most.f)
        s->most = (struct scan_point){x, f};
    if (s->answers == 0 || f < s->least.f)
        s->least = (struct scan_point){x, f};
    s->answers++;
    return f;
}

static double scan_gsl(double x, void *context)
{
    return (double)scan_at(context, (domq_real)x);
}

static void root_add(struct scan *s, domq_real x, const char *branch)
{
    domq_real f = scan_at(s, x);
    for (int i = 0; i < s->roots; i++)
        if (quad(fabs)(s->root[i].x - x) <= (domq_real)1e-9 * quad(fabs)(x))
            return;
    if (s->roots < ROOTS_MOST)
        s->root[s->roots++] = (struct root){x, f + s->solve->value.value, branch};
}

/* Finds the root between two points at which f has opposite signs. If f jumps from one sign to the other and
 * has no root in between, stores the x of the jump. */
static void root_between(struct scan *s, struct scan_point a, struct scan_point b)
{
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    gsl_function f = {.function = scan_gsl, .params = s};
    double low = (double)a.x, high = (double)b.x;
    if (!solver || gsl_root_fsolver_set(solver, &f, low, high) != GSL_SUCCESS) {
        gsl_root_fsolver_free(solver);
        return;
    }
    for (int i = 0; i < 200 && gsl_root_test_interval(low, high, 0, 1e-15) == GSL_CONTINUE; i++) {
        if (gsl_root_fsolver_iterate(solver) != GSL_SUCCESS)
            break;
        low = gsl_root_fsolver_x_lower(solver);
        high = gsl_root_fsolver_x_upper(solver);
    }
    domq_real x = (domq_real)gsl_root_fsolver_root(solver);
    gsl_root_fsolver_free(solver);
    /* If the answer jumps past the value, the solver stops at the jump. The answer just beside a jump is not
     * close to the value, so x is not a root. */
    domq_real f_at_x = quad(fabs)(scan_at(s, x)), rise = quad(fabs)(b.f - a.f),
              scale = quad_larger(quad(fabs)(s->solve->value.value), s->most.f - s->least.f);
    if (f_at_x > (domq_real)1e-6 * rise && f_at_x > (domq_real)1e-9 * scale)
        s->jump = x;
    else
        root_add(s, x, b.f > a.f ? "rising" : "falling");
}

static bool exists(domq_real f)
{
    return !isnan(f);
}

static bool is_zero(domq_real f)
{
    return f == 0;
}

static bool holds(domq_real f)
{
    return f > 0;
}

/* Finds by bisection where is_good changes from true, at x = good, to false, at x = bad. Returns an x at
 * which is_good is true, as close as possible to the change. */
static domq_real edge_between(struct scan *s, domq_real good, domq_real bad, bool (*is_good)(domq_real f))
{
    enum { HALVINGS = 60 };
    for (int i = 0; i < HALVINGS; i++) {
        domq_real middle = (good + bad) / 2;
        *(is_good(scan_at(s, middle)) ? &good : &bad) = middle;
    }
    return good;
}

/* Looks for a root between two neighbouring points of the grid. */
static void look_between(struct scan *s, struct scan_point a, struct scan_point b)
{
    if (isnan(a.f) && isnan(b.f))
        return;
    if (s->solve->verdict) { /* a point without a verdict counts as a point where the verdict is false */
        if (holds(a.f) != holds(b.f))
            root_add(s, edge_between(s, holds(a.f) ? a.x : b.x, holds(a.f) ? b.x : a.x, holds),
                     holds(a.f) ? "true up to here" : "true from here on");
        return;
    }
    if (isnan(a.f) || isnan(b.f)) {
        struct scan_point end = {.x =
                                     edge_between(s, isnan(a.f) ? b.x : a.x, isnan(a.f) ? a.x : b.x, exists)};
        end.f = scan_at(s, end.x);
        *(isnan(a.f) ? &a : &b) = end;
    }
    /* If the answer equals the value in a whole interval, only the ends of the interval are roots. */
    if (a.f == 0 && b.f == 0)
        return;
    if (a.f == 0)
        root_add(s, edge_between(s, a.x, b.x, is_zero), b.f > a.f ? "rising" : "falling");
    else if (b.f == 0)
        root_add(s, edge_between(s, b.x, a.x, is_zero), b.f > a.f ? "rising" : "falling");
    else if ((a.f < 0) != (b.f < 0))
        root_between(s, a, b);
}

/* Near a maximum or a minimum, the answer may cross the value twice between two points of the grid, and then
 * both points are on the same side of the value. If m is the highest or the lowest of three points, a
 * golden-section search looks for a point on the other side of the value. If it finds one, there is a root to
 * the left of this point, and another one to the right. */
static void look_around(struct scan *s, struct scan_point a, struct scan_point m, struct scan_point b)
{
    const domq_real golden = (domq_real)0.3819660112501051;
    bool flat = m.f == a.f && m.f == b.f;
    bool maximum = !flat && m.f < 0 && m.f >= a.f && m.f >= b.f,
         minimum = !flat && m.f > 0 && m.f <= a.f && m.f <= b.f;
    for (int i = 0; (maximum || minimum) && i < 40; i++) {
        bool left = m.x - a.x > b.x - m.x;
        struct scan_point n = {.x = left ? m.x - golden * (m.x - a.x) : m.x + golden * (b.x - m.x)};
        n.f = scan_at(s, n.x);
        if (isnan(n.f))
            return;
        if ((n.f < 0) != (m.f < 0)) {
            root_between(s, left ? a : m, n);
            root_between(s, n, left ? m : b);
            return;
        }
        if (maximum ? n.f > m.f : n.f < m.f) {
            *(left ? &b : &a) = m;
            m = n;
        } else
            *(left ? &a : &b) = n;
    }
}

static int compare_roots(const void *one, const void *other)
{
    domq_real a = ((const struct root *)one)->x, b = ((const struct root *)other)->x;
    return a < b ? -1 : a > b;
}

bool scan_run(struct scan *s)
{
    struct scan_point *p = s->point;
    const volatile sig_atomic_t *interrupt = s->probe.query->scene->compute.interrupt;
    for (int k = 0; k < SCAN_POINTS; k++) {
        domq_real share = (domq_real)k / (SCAN_POINTS - 1);
        p[k].x = k == SCAN_POINTS - 1 ? s->solve->to : (1 - share) * s->solve->from + share * s->solve->to;
        p[k].f = scan_at(s, p[k].x);
        if (s->probe.wrong || dom_raised(interrupt))
            return false;
    }
    for (int k = 1; k < SCAN_POINTS; k++)
        look_between(s, p[k - 1], p[k]);
    for (int k = 1; k + 1 < SCAN_POINTS && !s->solve->verdict; k++)
        if (!isnan(p[k - 1].f) && !isnan(p[k].f) && !isnan(p[k + 1].f))
            look_around(s, p[k - 1], p[k], p[k + 1]);
    qsort(s->root, (size_t)s->roots, sizeof *s->root, compare_roots);
    return !dom_raised(interrupt);
}
