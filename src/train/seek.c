/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "train/train.h"
#include <float.h>
#include <math.h>
#include <stdbool.h>

struct spot seek_top(seek_value *at, void *context, double low, struct spot top, double high, double grain,
                     double enough)
{
    const double golden = 0.3819660112501051;
    enum { LEVEL = 8 }; /* after so many equal values the ground is level */
    int equal = 0;
    while (high - low > grain && !(top.value > enough) && equal < LEVEL) {
        const bool is_above = high - top.x > top.x - low;
        const double x = top.x + golden * ((is_above ? high : low) - top.x), value = at(x, context);
        equal += value == top.value;
        if (value > top.value) {
            *(is_above ? &low : &high) = top.x;
            top = (struct spot){x, value};
        } else {
            *(is_above ? &high : &low) = x;
        }
    }
    return top;
}

/* Takes secants. They are moved a little beyond the edge, so that both sides approach it, and give way to
 * bisection where three of them have not halved the interval. */
void seek_edge(seek_value *at, void *context, struct spot *good, struct spot *bad, double grain)
{
    struct spot last = *bad, before = *good;
    double width = fabs(bad->x - good->x);
    for (int k = 1; fabs(bad->x - good->x) > grain; k++) {
        const double middle = good->x + (bad->x - good->x) / 2,
                     part = last.value / (last.value - before.value);
        double x = isfinite(part) ? last.x + (before.x - last.x) * part : middle;
        const bool is_nearer_bad = fabs(bad->x - x) < fabs(good->x - x);
        x += copysign(fmax(0.4 * grain, 4 * DBL_EPSILON * fabs(x)),
                      is_nearer_bad ? good->x - bad->x : bad->x - good->x);
        if (!(fmin(good->x, bad->x) < x && x < fmax(good->x, bad->x)))
            x = middle;
        if (k % 3 == 0) {
            x = fabs(bad->x - good->x) > width / 2 ? middle : x;
            width = fabs(bad->x - good->x);
        }
        if (x == good->x || x == bad->x)
            break;
        before = last;
        last = (struct spot){x, at(x, context)};
        *(last.value >= 0 ? good : bad) = last;
    }
}
