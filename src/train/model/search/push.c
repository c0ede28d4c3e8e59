/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the weakest push with which all dominoes of a row fall. */
#include "search/trial.h"

/* ---- A push ---- */

#define PUSH_TOL 1e-5

static bool falls_pushed(struct trial *t, double push)
{
    t->row.push = push;
    return trial_falls(t);
}

/*
 * Returns the angular velocity omega that is just enough to tip the first domino over its edge, if the domino
 * is a solid block with sharp edges that stands upright on a level floor. The kinetic energy must lift the
 * centre of mass to its highest point above the edge:
 *
 *     I omega^2 / 2 = m g (sqrt(h^2 + d^2) - h) / 2.
 *
 * Here I is the moment of inertia about the edge, m is the mass, h is the height, and d is the thickness.
 */
static double push_over_edge(const struct dom_row *row)
{
    double h = row->domino[0].height, d = row->domino[0].thickness, reach = sqrt(h * h + d * d);
    return sqrt(3 * row->g * d * d / ((reach + h) * reach * reach));
}

enum dom_status dom_row_weakest_push(const struct dom_row *row, const struct dom_compute *compute,
                                     double strongest, double *push)
{
    struct trial t = trial_of(row, compute);
    if (!(strongest > 0 && strongest < HUGE_VAL))
        return DOM_BAD_PUSH;
    bool falls = trial_falls(&t);
    double found = falls ? row->push : DOM_NAN;
    if (t.status == DOM_OK && !falls) {
        double bad = isnan(row->push) ? 0 : row->push, good = fmax(push_over_edge(row), bad) / 2;
        do {
            good = fmin(2 * good, strongest);
            falls = falls_pushed(&t, good);
            bad = falls ? bad : good;
        } while (!falls && good < strongest && t.status == DOM_OK);
        if (falls && bad < good) {
            good = trial_edge(&t, falls_pushed, good, &bad, 0, PUSH_TOL);
            /* round up, so that the push is still strong enough */
            const double digit = digit_of(good, 3), rounded = multiple_of(ceil(good / digit), digit);
            found = falls_pushed(&t, rounded) ? rounded : good;
        }
    }
    if (t.status == DOM_OK)
        *push = found;
    return t.status;
}
