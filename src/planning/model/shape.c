/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "planning/model/shape.h"
#include "numerics/real.h"
#include "rows/model/boxes.h"
#include "search/search.h"
#include <string.h>

/* Limits of a gap, as fractions of the height of the domino before it. */
#define LEAST (1.0 / 1000)
#define MOST  (98.0 / 100)

/* If a row is too long for the hall, its gaps are narrowed. To avoid a kink, the narrowing sets in gradually,
 * a little before the row fills the hall. The larger this exponent, the more abruptly the narrowing sets in.
 * If the row exactly fills the hall, its gaps are multiplied by 2^(-1 / SHARP). */
#define SHARP 64.0

/* A height is multiplied or divided by at most this factor. */
#define FARTHEST 4.0

/* Two lengths count as equal if their relative difference is at most this, because of rounding errors. */
#define SAME 1e-9

enum dom_status limits_check(const struct dom_limits *l)
{
    enum dom_status status = !(l->q > 0 && l->q < HUGE_VAL)          ? DOM_BAD_Q
                             : !(l->hall > 0)                        ? DOM_BAD_HALL
                             : !(l->grid >= 0 && l->grid < HUGE_VAL) ? DOM_BAD_GAP
                                                                     : DOM_OK;
    for (size_t i = 0; i < l->boards && status == DOM_OK; i++)
        status = l->board[i] > 0 && l->board[i] < HUGE_VAL ? DOM_OK : DOM_BAD_THICKNESS;
    return status;
}

/* Returns the number of dominoes whose sizes may change: those from index 1 on. */
static size_t sizes_of(const struct shape *s)
{
    return s->limits->sizes && s->row->count > 2 ? s->row->count - 2 : 0;
}

size_t shape_begin(const struct shape *s, double *x)
{
    const struct dom_domino *d = s->row->domino;
    const size_t gaps = s->row->count - 1, sizes = sizes_of(s);
    for (size_t k = 0; k < gaps + sizes; k++)
        x[k] = k < gaps ? log(fmax(d[k + 1].gap / d[k].height, LEAST)) : 0;
    return gaps + sizes;
}

/* Sets the height and the thickness of a domino. Its mass, its width and the radius of its edges change
 * accordingly. */
static void resize(const struct shape *s, struct dom_domino *d, double height, double thickness)
{
    const struct dom_domino before = *d;
    const double x = height / d->height, slimmer = thickness / d->thickness / x, q = s->limits->q;
    d->width *= x;
    d->radius *= x;
    d->height = height;
    d->thickness = thickness;
    /* The mass of a solid domino (q = 4) is proportional to its thickness. The mass of a domino with thin
     * walls (q = 3) hardly depends on its thickness. */
    d->mass *= wood_factor(s->row, &before, d, pow(x, q - 1) * pow(slimmer, q - 3));
}

/* Returns the multiple of the grid nearest to a length, but at least one grid step. */
static double on_grid(const struct shape *s, double length)
{
    const double grid = s->limits->grid;
    return grid > 0 ? multiple_of(fmax(floor(length / grid + 0.5), 1), grid) : length;
}

/* Returns the thickness that a domino gets if `thickness` is wanted: that of the closest board, if it must be
 * made from a board. If boxes_above of the row is > 0, boxes may have any thickness. */
static double board_near(const struct shape *s, double height, double thickness, bool final)
{
    const struct dom_limits *l = s->limits;
    const bool is_free = l->boards == 0 || (s->row->boxes_above > 0 && walls_of(s->row, height) > 0);
    double near = is_free ? thickness : l->board[0];
    for (size_t i = 1; i < l->boards && !is_free; i++)
        near = fabs(l->board[i] - thickness) < fabs(near - thickness) ? l->board[i] : near;
    return is_free && final ? on_grid(s, near) : near;
}

/* Rounds all gaps to the grid. If each gap were rounded alone, the rounding errors could add up. So before a
 * gap is rounded, the rounding error of the earlier gaps is added to it. */
static void gaps_round(const struct shape *s, struct dom_domino *d)
{
    const double grid = s->limits->grid;
    double exact = 0, rounded = 0;
    for (size_t k = 1; k < s->row->count && grid > 0; k++) {
        exact += d[k].gap;
        d[k].gap = multiple_of(fmax(floor((exact - rounded) / grid + 0.5), 0), grid);
        rounded += d[k].gap;
    }
}

bool shape_dominoes(const struct shape *s, const double *x, bool final, struct dom_domino *d)
{
    const size_t count = s->row->count;
    const struct dom_domino *given = s->row->domino;
    double room = s->limits->hall - given[count - 1].height - s->limits->grid, sum = 0, larger = 0;
    memcpy(d, given, count * sizeof *d);
    for (size_t k = 1; k <= sizes_of(s); k++) {
        larger += x[count - 2 + k];
        const double wish = given[k].height * exp(fmin(fmax(larger, -log(FARTHEST)), log(FARTHEST))),
                     height = final ? on_grid(s, wish) : wish;
        resize(s, &d[k], height, board_near(s, height, given[k].thickness / given[k].height * height, final));
    }
    for (size_t k = 0; k < count; k++)
        room -= d[k].thickness;
    for (size_t k = 1; k < count; k++) {
        d[k].gap = fmin(fmax(exp(x[k - 1]), LEAST), MOST) * d[k - 1].height;
        sum += d[k].gap;
    }
    if (room <= 0 && count > 1)
        return false;
    /* This is min(1, room / sum) without the kink, so that the minimizer can follow the limit. */
    const double narrower = isinf(room) ? 1 : pow(1 + pow(sum / room, SHARP), -1 / SHARP);
    for (size_t k = 1; k < count; k++)
        d[k].gap *= narrower;
    if (final)
        gaps_round(s, d);
    return true;
}

void shape_round(const struct shape *s, size_t count, struct dom_domino *d)
{
    for (size_t k = 1; k < count; k++) {
        const double height = k + 1 < s->row->count ? on_grid(s, d[k].height) : d[k].height;
        resize(s, &d[k], height, board_near(s, height, d[k].thickness * (height / d[k].height), true));
    }
    gaps_round(s, d);
}

static bool is_near(double a, double b)
{
    return fabs(a - b) <= SAME * fabs(b);
}

bool shape_keeps(const struct shape *s, const struct dom_domino *d, struct dom_domino *rounded)
{
    const size_t count = s->row->count;
    double length = d[count - 1].height;
    bool keeps = true;
    memcpy(rounded, d, count * sizeof *d);
    shape_round(s, 1 + sizes_of(s), rounded);
    for (size_t k = 0; k < count; k++) {
        length += d[k].gap + d[k].thickness;
        keeps = keeps && is_near(d[k].height, rounded[k].height) &&
                is_near(d[k].thickness, rounded[k].thickness) && is_near(d[k].gap, rounded[k].gap);
    }
    return keeps && length <= s->limits->hall * (1 + SAME);
}
