/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "planning/model/shape.h"
#include "numerics/decimal.h"
#include "numerics/real.h"
#include "rows/model/boxes.h"
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

/* Because of rounding errors, a value still counts as allowed if it exceeds its limit by at most this
 * factor. */
#define ROUNDED (1 + 1e-9)

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

static bool has_size(const struct shape *s, size_t k)
{
    return s->limits->sizes && k > 0 && k + 1 < s->row->count;
}

size_t shape_variables(const struct shape *s)
{
    const size_t gaps = s->row->count - 1;
    return s->limits->sizes && gaps > 1 ? 2 * gaps : gaps;
}

void shape_begin(const struct shape *s, double *x)
{
    const struct dom_domino *d = s->row->domino;
    const size_t gaps = s->row->count - 1;
    for (size_t k = 1; k <= gaps; k++) {
        x[k - 1] = log(fmax(d[k].gap / d[k - 1].height, LEAST));
        if (shape_variables(s) > gaps)
            x[gaps + k - 1] = log(d[k].height / d[k - 1].height);
    }
}

/* The last domino must keep its height, but the growths in the variables may lead to another height. Returns
 * the number that must be subtracted from the logarithm of each growth to correct this. */
static double growth_excess(const struct shape *s, const double *growth)
{
    const struct dom_domino *d = s->row->domino;
    const size_t gaps = s->row->count - 1;
    double sum = 0;
    for (size_t k = 0; k < gaps; k++)
        sum += growth[k];
    return (sum - log(d[gaps].height / d[0].height)) / (double)gaps;
}

void shape_resize(const struct shape *s, struct dom_domino *d, double height, double thickness)
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

/* Returns true if a domino of this height must be as thick as one of the boards. If boxes_above of the row is
 * > 0, boxes may have any thickness. */
static bool is_from_board(const struct shape *s, double height)
{
    const bool is_box = s->row->boxes_above > 0 && walls_of(s->row, height) > 0;
    return s->limits->boards > 0 && !is_box;
}

/* Returns the thickness that a domino gets if `thickness` is wanted. If the domino must be made from a board,
 * this is the thickness of the board that is closest to `thickness`. If not, it is `thickness`, rounded to
 * the grid if `final` is true. */
static double board_near(const struct shape *s, double height, double thickness, bool final)
{
    const struct dom_limits *l = s->limits;
    if (!is_from_board(s, height))
        return final ? on_grid(s, thickness) : thickness;
    double near = l->board[0];
    for (size_t i = 1; i < l->boards; i++)
        if (fabs(l->board[i] - thickness) < fabs(near - thickness))
            near = l->board[i];
    return near;
}

/* Sets the height of domino k. */
static void size_set(const struct shape *s, size_t k, double height, bool final, struct dom_domino *d)
{
    const struct dom_domino *given = &s->row->domino[k];
    height = fmin(fmax(height, given->height / FARTHEST), given->height * FARTHEST);
    height = final ? on_grid(s, height) : height;
    *d = *given;
    shape_resize(s, d, height, board_near(s, height, given->thickness / given->height * height, final));
}

/* Rounds all gaps to the grid. If each gap were rounded alone, the rounding errors could add up. So before a
 * gap is rounded, the rounding error of the earlier gaps is added to it. */
static void gaps_round(const struct shape *s, struct dom_domino *d)
{
    const double grid = s->limits->grid;
    double exact = 0, rounded = 0;
    for (size_t k = 1; k < s->row->count; k++) {
        exact += d[k].gap;
        d[k].gap = multiple_of(fmax(floor((exact - rounded) / grid + 0.5), 0), grid);
        rounded += d[k].gap;
    }
}

bool shape_dominoes(const struct shape *s, const double *x, bool final, struct dom_domino *d)
{
    const size_t count = s->row->count, gaps = count - 1;
    const double grid = s->limits->grid;
    double room = s->limits->hall - s->row->domino[count - 1].height - grid, sum = 0;
    memcpy(d, s->row->domino, count * sizeof *d);
    const double excess = has_size(s, 1) ? growth_excess(s, x + gaps) : 0;
    double height = d[0].height;
    for (size_t k = 1; has_size(s, k); k++) {
        height *= exp(x[gaps + k - 1] - excess);
        size_set(s, k, height, final, &d[k]);
    }
    for (size_t k = 0; k < count; k++)
        room -= d[k].thickness;
    for (size_t k = 1; k < count; k++) {
        d[k].gap = fmin(fmax(exp(x[k - 1]), LEAST), MOST) * d[k - 1].height;
        sum += d[k].gap;
    }
    if (room <= 0 && gaps > 0)
        return false;
    /* This is min(1, room / sum) without the kink, so that the minimizer can follow the limit. */
    const double narrower = isinf(room) ? 1 : pow(1 + pow(sum / room, SHARP), -1 / SHARP);
    for (size_t k = 1; k < count; k++)
        d[k].gap *= narrower;
    if (final && grid > 0)
        gaps_round(s, d);
    return true;
}

static bool is_on_grid(const struct shape *s, double length)
{
    const double grid = s->limits->grid, cells = grid > 0 ? length / grid : 0;
    return fabs(cells - floor(cells + 0.5)) < 1e-6;
}

/* Returns true if the height and the thickness of a domino are within the limits. */
static bool size_keeps(const struct shape *s, const struct dom_domino *d)
{
    const struct dom_limits *l = s->limits;
    const bool from_board = is_from_board(s, d->height);
    bool sold = !from_board && is_on_grid(s, d->thickness);
    for (size_t i = 0; from_board && i < l->boards; i++)
        sold = sold || fabs(d->thickness / l->board[i] - 1) < ROUNDED - 1;
    return sold && is_on_grid(s, d->height);
}

bool shape_keeps(const struct shape *s, const struct dom_domino *d)
{
    const size_t count = s->row->count;
    double length = d[count - 1].height;
    for (size_t k = 0; k < count; k++) {
        length += d[k].gap + d[k].thickness;
        if ((has_size(s, k) && !size_keeps(s, &d[k])) || (k > 0 && !is_on_grid(s, d[k].gap)))
            return false;
    }
    return length <= s->limits->hall * ROUNDED;
}

void shape_round(const struct shape *s, struct dom_domino *d)
{
    const size_t count = s->row->count;
    for (size_t k = 1; k < count; k++) {
        const double height = k + 1 < count ? on_grid(s, d[k].height) : d[k].height,
                     thickness = d[k].thickness * (height / d[k].height);
        shape_resize(s, &d[k], height, board_near(s, height, thickness, true));
    }
    if (s->limits->grid > 0)
        gaps_round(s, d);
}
