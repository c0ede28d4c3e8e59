/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The duration, by double-exponential quadrature of 1 / omega. The cycle is divided into smooth pieces. */
#include "reference.h"

#include <stdlib.h>

#define N MPFR_RNDN

struct integral {
    struct ref *ref;
    struct ref_sums sums;
    mpfr_t from, width; /* the beginning and the width of the piece */
    mpfr_t e, x, w, t;
    mpfr_t time; /* integral of 1 / omega */
    mpfr_t size; /* integral of (1 / omega) (K + |dH|) / (K - dH) */
};

#define INTEGRAL_ALL(k)                                                                                      \
    (k)->from, (k)->width, (k)->e, (k)->x, (k)->w, (k)->t, (k)->time, (k)->size, (mpfr_ptr)0

/* Computes the node x = from + width / (1 + e), e = exp(-pi sinh t); dx/dt = (x - from) pi cosh t e / (1 +
 * e). */
static void place_node(struct integral *k, double t)
{
    mpfr_set_d(k->t, t, N);
    mpfr_sinh_cosh(k->e, k->w, k->t, N);
    mpfr_const_pi(k->t, N);
    mpfr_mul(k->w, k->w, k->t, N);
    mpfr_mul(k->e, k->e, k->t, N);
    mpfr_neg(k->e, k->e, N);
    mpfr_exp(k->e, k->e, N);
    mpfr_add_ui(k->t, k->e, 1, N);
    mpfr_div(k->x, k->width, k->t, N);
    mpfr_div(k->e, k->e, k->t, N);
    mpfr_mul(k->w, k->w, k->x, N);
    mpfr_mul(k->w, k->w, k->e, N);
    mpfr_add(k->x, k->x, k->from, N);
}

static void add_node(struct integral *k, double t)
{
    mpfr_srcptr K = ref_value(k->ref, REF_KINETIC);
    place_node(k, t);
    ref_walk(k->ref, k->x, &k->sums);
    mpfr_sub(k->t, K, k->sums.dH, N);
    mpfr_div(k->x, k->sums.J, k->t, N);
    mpfr_sqrt(k->x, k->x, N);
    mpfr_mul(k->x, k->x, k->w, N);
    mpfr_add(k->time, k->time, k->x, N);
    mpfr_abs(k->e, k->sums.dH, N);
    mpfr_add(k->e, k->e, K, N);
    mpfr_div(k->e, k->e, k->t, N);
    mpfr_fma(k->size, k->x, k->e, k->size, N);
}

/* Adds all nodes j h on level 0, and only the odd nodes on finer levels. Nodes with a weight below 2^-digits
 * are left out. */
static void add_level(struct integral *k, mpfr_t *piece, int pieces, double digits, int level)
{
    const double h = ldexp(0.25, -level);
    const int last = (int)ceil(asinh(0.45 * digits) / h);
    for (int p = 0; p < pieces; p++) {
        mpfr_set(k->from, piece[p], N);
        mpfr_sub(k->width, piece[p + 1], piece[p], N);
        for (int j = -last; j <= last; j++)
            if (level == 0 || j % 2 != 0)
                add_node(k, j * h);
    }
}

/* Refines until there are enough digits. Every level doubles the number of digits. */
static void integrate(struct integral *k, mpfr_t *piece, int pieces, double digits)
{
    double change = 1;
    mpfr_t before, now;
    mpfr_inits2(k->ref->bits, before, now, (mpfr_ptr)0);
    mpfr_set_zero(k->time, 1);
    mpfr_set_zero(k->size, 1);
    for (int level = 0; level < 8 && change > exp2(-0.6 * digits); level++) {
        add_level(k, piece, pieces, digits, level);
        mpfr_div_2ui(now, k->time, (unsigned long)level + 2, N);
        mpfr_sub(k->t, now, before, N);
        mpfr_div(k->t, k->t, now, N);
        change = level ? fabs(mpfr_get_d(k->t, N)) : 1;
        mpfr_set(before, now, N);
        mpfr_div_2ui(k->e, k->size, (unsigned long)level + 2, N);
    }
    mpfr_set(k->time, now, N);
    mpfr_set(k->size, k->e, N);
    mpfr_clears(before, now, (mpfr_ptr)0);
}

enum { PIECES = 8 };

/* Finds the ends of the smooth pieces: the tilts where a follower detaches, and the maxima of H. */
static int cut_into_pieces(struct ref *ref, mpfr_t piece[PIECES + 1])
{
    long double node[SKETCH_NODES], end[PIECES];
    const struct sketch sketch = sketch_of(ref);
    const int n = sketch_nodes(&sketch, node);
    int ends = 0, pieces = 0;
    const long double leave = sketch_leaving(&sketch);
    for (int i = 0; i + 1 < n && ends < PIECES - 2; i++) {
        if (node[i] < leave && node[i + 1] >= leave && node[i + 1] < sketch.theta_c)
            end[ends++] = leave;
        long double lo = node[i], hi = node[i + 1];
        if (!(sketch_slope(&sketch, lo) > 0 && sketch_slope(&sketch, hi) <= 0))
            continue;
        for (int j = 0; j < 80; j++) {
            long double middle = (lo + hi) / 2;
            *(sketch_slope(&sketch, middle) > 0 ? &lo : &hi) = middle;
        }
        end[ends++] = hi;
    }
    for (int k = 0; k <= PIECES; k++)
        mpfr_init2(piece[k], ref->bits);
    mpfr_set_zero(piece[0], 1);
    for (int k = 0; k < ends; k++) {
        mpfr_set_ld(piece[pieces + 1], end[k], N);
        if (mpfr_greater_p(piece[pieces + 1], piece[pieces]))
            pieces++;
    }
    mpfr_set(piece[++pieces], ref->theta_c, N);
    return pieces;
}

void ref_find_duration(struct ref *ref)
{
    ref->known[REF_DURATION] = true;
    mpfr_set_nan(ref->value[REF_DURATION]);
    ref->duration_size = (double)NAN;
    if (!(mpfr_sgn(ref_value(ref, REF_MARGIN)) > 0))
        return;
    mpfr_t piece[PIECES + 1];
    struct integral k = {.ref = ref};
    ref_sums_init(&k.sums, ref->bits);
    mpfr_inits2(ref->bits, INTEGRAL_ALL(&k));
    int pieces = cut_into_pieces(ref, piece);
    integrate(&k, piece, pieces, ref->cut - 36);
    mpfr_set(ref->value[REF_DURATION], k.time, N);
    const double kappa = ref_scale(ref, REF_KINETIC) / fabs(ref_double(ref, REF_KINETIC));
    ref->duration_size = mpfr_get_d(k.size, N) / 2 * fmax(1, kappa);
    for (int j = 0; j <= PIECES; j++)
        mpfr_clear(piece[j]);
    mpfr_clears(INTEGRAL_ALL(&k));
    ref_sums_clear(&k.sums);
}
