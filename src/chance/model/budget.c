/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds how large random errors may be if a row must fall with a given probability. */
#include "chance/model/draw.h"
#include "chance/model/interval.h"
#include <math.h>

enum { BUDGET_SEEN = 128 };

struct budget {
    const struct dom_row *row;
    const struct dom_compute *compute;
    const struct dom_placement *placement;
    /* the kind of error whose size is wanted, or DOM_ERROR_COUNT for all kinds together */
    enum dom_error_of kind;
    double widest; /* the largest sigma that is tried */
    /* bounds on sigma: enough rows fall at `lo`, too few at `hi` */
    double lo, hi;
    /* true during the search for sigma itself, false for the ends of its confidence interval */
    bool of_answer;
    /* A cache of the latest results. It saves time because the searches for sigma and for both ends of its
     * confidence interval begin with the same values of sigma. */
    struct {
        double sigma, share;
    } seen[BUDGET_SEEN];
    int answers;
};

/* Runs the random rows and stores in *share the fraction that falls. The errors of b->kind have the size
 * `sigma`. If b->kind is DOM_ERROR_COUNT, all errors are multiplied by `sigma`. The random numbers are the
 * same for every sigma, so that the fractions for two sigmas can be compared. */
static enum dom_status fall_share(struct budget *b, double sigma, double *share)
{
    for (int i = 0; i < b->answers && i < BUDGET_SEEN; i++)
        if (b->seen[i].sigma == sigma) {
            *share = b->seen[i].share;
            return DOM_OK;
        }
    struct dom_placement p = *b->placement;
    struct dom_study study = {.rows = p.rows};
    for (int k = 0; k < DOM_ERROR_COUNT; k++)
        if (b->kind == DOM_ERROR_COUNT)
            p.error[k].size *= sigma;
        else if (k == (int)b->kind)
            p.error[k].size = sigma;
    enum dom_status status = dom_placement_study(b->row, b->compute, &p, &study, NULL);
    *share = (double)study.fall / (double)study.rows;
    if (status == DOM_OK) {
        b->seen[b->answers % BUDGET_SEEN].sigma = sigma;
        b->seen[b->answers++ % BUDGET_SEEN].share = *share;
    }
    return status;
}

/* Records the bounds on sigma that are known so far. They are reported if the search is interrupted. */
static void known(struct budget *b, double lo, double hi)
{
    b->lo = b->of_answer ? lo : b->lo;
    b->hi = b->of_answer ? hi : b->hi;
}

/* Finds the largest sigma between `lo` and `hi` at which the requested share of the rows falls. At `lo`, this
 * share must fall, and at `hi`, it must not. The search is a bisection, which ends at a relative tolerance of
 * 1e-3. */
static enum dom_status sigma_between(struct budget *b, double share, double lo, double hi, double *sigma)
{
    const double none = 1e-9 * hi; /* errors this small are negligible in a real row */
    while (hi - lo > 1e-3 * hi && hi > none) {
        double at = 0.5 * (lo + hi), falls;
        enum dom_status status = fall_share(b, at, &falls);
        if (status != DOM_OK)
            return status;
        *(falls >= share ? &lo : &hi) = at;
        known(b, lo, hi);
    }
    *sigma = lo;
    known(b, lo, lo);
    return DOM_OK;
}

/* Finds the largest sigma at which the requested share of the rows falls. If this share falls even at
 * b->widest, sets *sigma to infinity. */
static enum dom_status sigma_at(struct budget *b, double share, double *sigma)
{
    double lo = 0, falls = 1;
    for (double hi = b->widest / 4096;; lo = hi, hi *= 2) {
        enum dom_status status = fall_share(b, hi, &falls);
        if (status != DOM_OK)
            return status;
        known(b, falls < share ? lo : hi, falls < share ? hi : HUGE_VAL);
        if (falls < share)
            return sigma_between(b, share, lo, hi, sigma);
        if (hi >= b->widest) {
            *sigma = HUGE_VAL;
            return DOM_OK;
        }
    }
}

/* Returns the largest sigma that is tried for a kind of error. The limits are described at
 * dom_placement_budget. */
static double size_most(const struct dom_row *row, enum dom_error_of kind)
{
    double widest = 0;
    for (size_t k = 1; k < row->count; k++)
        widest = fmax(widest, row->domino[k].gap);
    switch (kind) {
    case DOM_ERROR_gap:
    case DOM_ERROR_place:
        return widest;
    case DOM_ERROR_lean:
    case DOM_ERROR_slope:
        return row_steepest(row);
    case DOM_ERROR_push:
        return isnan(row->push) ? 0 : row->push;
    case DOM_ERROR_COUNT:
        return 64;
    default:
        return 1;
    }
}

enum dom_status dom_placement_budget(const struct dom_row *row, const struct dom_compute *compute,
                                     const struct dom_placement *p, enum dom_error_of kind, double share,
                                     struct dom_budget *budget)
{
    struct budget b = {
        .row = row, .compute = compute, .placement = p, .kind = kind, .hi = HUGE_VAL, .of_answer = true};
    double falls;
    if (!(share > 0 && share < 1))
        return DOM_BAD_PROBABILITY;
    if (kind > DOM_ERROR_COUNT)
        return DOM_BAD_ERROR;
    enum dom_status status = fall_share(&b, 0, &falls);
    if (status != DOM_OK || falls < share)
        return status != DOM_OK ? status : DOM_STOPS;
    b.widest = size_most(row, kind);
    double N = (double)p->rows, few = fmax(unlikely_count(share, N, false), 0),
           many = unlikely_count(share, N, true);
    struct dom_budget found = {.low = 0};
    status = sigma_at(&b, share, &found.sigma);
    b.of_answer = false;
    if (status == DOM_OK && many <= N)
        status = sigma_at(&b, many / N, &found.low);
    if (status == DOM_OK)
        status = sigma_at(&b, few / N, &found.high);
    if (status == DOM_INTERRUPTED && b.lo > 0)
        *budget = (struct dom_budget){.sigma = b.lo, .low = b.lo, .high = b.hi};
    if (status == DOM_OK)
        *budget = found;
    return status;
}
