/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Linear differential equations, as Chebyshev series on panels. */
#include "numerics/numerics.h"
#include <stdlib.h>
#include <string.h>

/* The number of nodes of a panel: at most N, and fewer in double for an equation, whose p and c are less
 * smooth than an integrand. */
enum { N = LINEAR_ORDER, N_EQUATION = REAL_BITS <= 64 && LINEAR_ORDER > 24 ? 24 : LINEAR_ORDER, N_ROUGH = 7 };

/* Returns the sum of the first n terms of a Chebyshev series at x, by Clenshaw's recurrence. */
static real series_at(const real *series, int n, real x)
{
    real b = 0, before = 0;
    for (int k = n - 1; k > 0; k--) {
        real next = 2 * x * b - before + series[k];
        before = b;
        b = next;
    }
    return x * b - before + series[0];
}

/*
 * Finds the series of a function from n values at the Chebyshev nodes of the first kind, and integrates it.
 * The integral equals `start` at the left end of the panel, whose width is 2 half. Its series has one term
 * more. *error receives its error, estimated from the last three terms of the function.
 *
 * Returns false if the function has not converged: if these terms exceed the tolerance. They never get
 * smaller than `noise`, the error of the values, and a few rounding errors. So a tolerance below this level
 * is raised to it.
 */
static bool series_integrate(const real *node, const real *value, int n, real half, real start, real tol,
                             real noise, real *integral, real *error)
{
    real series[N + 2] = {0}, size = 0, at_left = 0;
    for (int j = 0; j < n; j++) {
        real x = node[j], T = 1, before = x; /* `before` is T_(k-1), and T_-1 = T_1 = x */
        for (int k = 0; k < n; k++) {
            series[k] += value[j] * 2 / (real)n * T;
            real next = 2 * x * T - before;
            before = T;
            T = next;
        }
    }
    series[0] /= 2;
    for (int k = 0; k < n; k++)
        size = fmax(size, fabs(series[k]));
    const real last = fmax(fabs(series[n - 1]), fmax(fabs(series[n - 2]), fabs(series[n - 3])));
    for (int k = 1; k <= n; k++) {
        real below = k == 1 ? 2 * series[0] : series[k - 1];
        integral[k] = half * (below - series[k + 1]) / (2 * (real)k);
        at_left += k % 2 ? -integral[k] : integral[k];
    }
    integral[0] = start - at_left;
    *error = half * last;
    return last <= fmax(fmax(tol, 2 * (real)n * REAL_EPSILON) * size, noise);
}

/*
 * Computes one panel, from n <= N nodes. ln_G and v are the solution at the left end of the panel. Returns
 * false if the panel is too wide for its series to converge. If f fails, also returns false, and sets *status
 * to NUM_NOT_FINITE.
 */
static bool panel_make(num_linear_function *f, void *context, const real *node, int n, real ln_G, real v,
                       real tol, struct num_panel *panel, struct num_linear *s, enum num_status *status)
{
    const real half = (panel->hi - panel->lo) / 2, middle = panel->lo + half;
    real p[N], c[N], p_noise = 0, c_noise = 0, shrunk = 1, ln_G_error = 0, v_error;
    panel->terms = n + 1;
    for (int j = 0; j < n; j++) {
        struct num_rate rate = {0};
        if (!f(middle + half * node[j], context, &rate) || !isfinite(rate.p) || !isfinite(rate.c)) {
            *status = NUM_NOT_FINITE;
            return false;
        }
        p[j] = rate.p;
        c[j] = rate.c;
        p_noise = fmax(p_noise, rate.p_noise);
        c_noise = fmax(c_noise, rate.c_noise);
    }
    if (s->integral)
        memset(panel->ln_G, 0, sizeof panel->ln_G);
    else {
        /* The solution contains exp(ln G). So where ln G hardly changes, an absolute tolerance is enough. */
        if (!series_integrate(node, p, n, half, ln_G, tol, fmax(p_noise, tol / half), panel->ln_G,
                              &ln_G_error))
            return false;
        shrunk = 0;
        for (int j = 0; j < n; j++) {
            const real by = exp(-series_at(panel->ln_G, n + 1, node[j]));
            c[j] *= by; /* c / G */
            shrunk = fmax(shrunk, by);
        }
    }
    if (!series_integrate(node, c, n, half, v, tol, c_noise * shrunk, panel->v, &v_error))
        return false;
    s->ln_G_error += ln_G_error;
    s->v_error += v_error;
    return true;
}

KERNEL void num_linear_free(struct num_linear *s)
{
    free(s->panel);
    s->panel = NULL;
}

KERNEL enum num_status num_linear_solve(num_linear_function *f, void *context, real lo, real hi, real tol,
                                        struct num_linear *s)
{
    real node[N], width = hi - lo, ln_G = 0, v = 0;
    const int n = isinf(tol) ? N_ROUGH : s->integral ? N : N_EQUATION;
    bool halved = false;
    enum num_status status = NUM_OK;
    if (!s->panel && !(s->panel = malloc(LINEAR_PANELS * sizeof *s->panel)))
        return NUM_NO_MEMORY;
    for (int j = 0; j < n; j++)
        node[j] = cos(PI * ((real)j + (real)0.5) / (real)n);
    if (s->panels > 0)
        num_linear_at(s, lo, &ln_G, &v);
    else
        s->ln_G_error = s->v_error = 0;
    while (lo < hi) {
        if (s->panels == LINEAR_PANELS)
            return NUM_NOT_CONVERGED;
        struct num_panel *panel = &s->panel[s->panels];
        panel->lo = lo;
        /* A small remainder of [lo, hi] is added to the last panel. */
        panel->hi = lo + (real)1.25 * width >= hi ? hi : lo + width;
        if (panel_make(f, context, node, n, ln_G, v, tol, panel, s, &status)) {
            s->panels++;
            width = (halved ? 1 : 2) * (panel->hi - lo); /* twice as wide would fail again */
            halved = false;
            lo = panel->hi;
            num_linear_at(s, lo, &ln_G, &v);
        } else {
            width = (panel->hi - lo) / 2;
            halved = true;
            if (status != NUM_OK || !(lo + width / 4 > lo))
                return status != NUM_OK ? status : NUM_NOT_CONVERGED;
        }
    }
    return NUM_OK;
}

static int panel_of(const struct num_linear *s, real x)
{
    int k = s->panels - 1;
    while (k > 0 && x < s->panel[k].lo)
        k--;
    return k;
}

KERNEL void num_linear_at(const struct num_linear *s, real x, real *ln_G, real *v)
{
    const struct num_panel *panel = &s->panel[panel_of(s, x)];
    real u = (x - panel->lo - (panel->hi - x)) / (panel->hi - panel->lo);
    u = fmin(fmax(u, -1), 1);
    if (ln_G)
        *ln_G = series_at(panel->ln_G, panel->terms, u);
    *v = series_at(panel->v, panel->terms, u);
}

/* Returns the series at x minus the series at x - by. The recurrence for T_k(x) - T_k(x - by) avoids
 * cancellation. */
static real series_moved(const real *series, int n, real x, real by)
{
    real y = x - by, T = 1, T_next = y, moved = 0, moved_next = by, sum = 0;
    for (int k = 1; k < n; k++) {
        sum += series[k] * moved_next;
        real T_then = 2 * y * T_next - T, moved_then = 2 * x * moved_next + 2 * by * T_next - moved;
        T = T_next;
        T_next = T_then;
        moved = moved_next;
        moved_next = moved_then;
    }
    return sum;
}

KERNEL real num_linear_moved(const struct num_linear *s, real x, real by)
{
    /* From the start of the solution on, whole panels are added. If rounding errors of `by` were carried from
     * panel to panel, they would count where v changes fastest. */
    const bool whole = by == x - s->panel[0].lo;
    real sum = 0;
    for (int k = panel_of(s, x); by > 0 && k >= 0; k--) {
        const struct num_panel *panel = &s->panel[k];
        real width = panel->hi - panel->lo, part = x - panel->lo;
        part = whole ? part : k == 0 ? by : fmin(by, part);
        real u = fmin(fmax((x - panel->lo - (panel->hi - x)) / width, -1), 1);
        sum += series_moved(panel->v, panel->terms, u, 2 * part / width);
        by = whole ? by : by - part;
        x = panel->lo;
    }
    return sum;
}
