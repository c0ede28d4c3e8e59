/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/planning/scan.h"
#include "language/quad.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 241, HALVINGS = 60 };

static domq_real scan_at(struct scan *s, domq_real x)
{
    domq_real f = probe_at(&s->probe, x) - s->solve->value.value;
    if (isnan(f)) {
        if (!*s->none)
            snprintf(s->none, sizeof s->none, "%.*s", (int)sizeof s->none - 1, s->probe.problem.text);
        return f;
    }
    if (s->answers == 0 || f > s->most.f)
        s->most = (struct point){x, f};
    if (s->answers == 0 || f < s->least.f)
        s->least = (struct point){x, f};
    s->answers++;
    return f;
}

static double scan_gsl(double x, void *context)
{
    return (double)scan_at(context, (domq_real)x);
}

/* Returns the size of numbers that count as 0 beside the answer. */
static domq_real scale_of(const struct scan *s)
{
    return quad_larger(quad(fabs)(s->solve->value.value), s->most.f - s->least.f);
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

/* Finds the root between two points of different sign, with Brent's method of GSL. */
static void root_between(struct scan *s, struct point a, struct point b)
{
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    gsl_function f = {.function = scan_gsl, .params = s};
    double lo = (double)a.x, hi = (double)b.x;
    if (!solver || gsl_root_fsolver_set(solver, &f, lo, hi) != GSL_SUCCESS) {
        gsl_root_fsolver_free(solver);
        return;
    }
    for (int i = 0; i < 200 && gsl_root_test_interval(lo, hi, 0, 1e-15) == GSL_CONTINUE; i++) {
        if (gsl_root_fsolver_iterate(solver) != GSL_SUCCESS)
            break;
        lo = gsl_root_fsolver_x_lower(solver);
        hi = gsl_root_fsolver_x_upper(solver);
    }
    domq_real x = (domq_real)gsl_root_fsolver_root(solver);
    gsl_root_fsolver_free(solver);
    /* At a jump the answer passes the value, and is far from it on both sides. */
    domq_real near = quad(fabs)(scan_at(s, x)), slope = quad(fabs)(b.f - a.f);
    if (near > (domq_real)1e-6 * slope && near > (domq_real)1e-9 * scale_of(s)) {
        s->jumps++;
        s->jump = x;
    } else
        root_add(s, x, b.f > a.f ? "rising" : "falling");
}

/* Finds where a verdict changes between two points, or where answers end: halves down. */
static domq_real edge_between(struct scan *s, domq_real good, domq_real bad, bool (*is_good)(domq_real f))
{
    for (int i = 0; i < HALVINGS; i++) {
        domq_real middle = (good + bad) / 2;
        *(is_good(scan_at(s, middle)) ? &good : &bad) = middle;
    }
    return good;
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

/* Looks between two neighbours for a value that the answer takes. */
static void pair_look(struct scan *s, struct point a, struct point b)
{
    if (isnan(a.f) && isnan(b.f))
        return;
    if (s->solve->verdict) { /* no answer does not hold */
        if (holds(a.f) != holds(b.f))
            root_add(s, edge_between(s, holds(a.f) ? a.x : b.x, holds(a.f) ? b.x : a.x, holds),
                     holds(a.f) ? "true up to here" : "true from here on");
        return;
    }
    if (isnan(a.f) || isnan(b.f)) {
        struct point end = {.x = edge_between(s, isnan(a.f) ? b.x : a.x, isnan(a.f) ? a.x : b.x, exists)};
        end.f = scan_at(s, end.x);
        *(isnan(a.f) ? &a : &b) = end;
    }
    if (a.f == 0 && b.f == 0) /* inside of a step, whose ends are found */
        return;
    if (a.f == 0)
        root_add(s, edge_between(s, a.x, b.x, is_zero), b.f > a.f ? "rising" : "falling");
    else if (b.f == 0)
        root_add(s, edge_between(s, b.x, a.x, is_zero), b.f > a.f ? "rising" : "falling");
    else if ((a.f < 0) != (b.f < 0))
        root_between(s, a, b);
}

/* Looks at the top or bottom around the middle one of three points, which may reach the value between them.
 */
static void top_look(struct scan *s, struct point a, struct point m, struct point b)
{
    const domq_real part = (domq_real)0.3819660112501051;
    bool flat = m.f == a.f && m.f == b.f;
    bool top = !flat && m.f < 0 && m.f >= a.f && m.f >= b.f,
         bottom = !flat && m.f > 0 && m.f <= a.f && m.f <= b.f;
    for (int i = 0; (top || bottom) && i < 40; i++) {
        bool left = m.x - a.x > b.x - m.x;
        struct point n = {.x = left ? m.x - part * (m.x - a.x) : m.x + part * (b.x - m.x)};
        n.f = scan_at(s, n.x);
        if (isnan(n.f))
            return;
        if ((n.f < 0) != (m.f < 0)) {
            root_between(s, left ? a : m, n);
            root_between(s, n, left ? m : b);
            return;
        }
        bool better = top ? n.f > m.f : n.f < m.f;
        if (better) {
            *(left ? &b : &a) = m;
            m = n;
        } else
            *(left ? &a : &b) = n;
    }
}

bool scan_run(struct scan *s)
{
    static const domq_real last = POINTS - 1;
    struct point *p = malloc(POINTS * sizeof *p);
    bool done = p != NULL;
    for (int k = 0; k < POINTS && done; k++) {
        domq_real share = k / last;
        p[k].x = k == POINTS - 1 ? s->solve->to : (1 - share) * s->solve->from + share * s->solve->to;
        p[k].f = scan_at(s, p[k].x);
        done = !s->probe.wrong && !dom_raised(s->probe.query->scene->compute.interrupt);
    }
    for (int k = 1; k < POINTS && done; k++)
        pair_look(s, p[k - 1], p[k]);
    for (int k = 1; k + 1 < POINTS && done && !s->solve->verdict; k++)
        if (!isnan(p[k - 1].f) && !isnan(p[k].f) && !isnan(p[k + 1].f))
            top_look(s, p[k - 1], p[k], p[k + 1]);
    free(p);
    return done && !dom_raised(s->probe.query->scene->compute.interrupt);
}
