/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Opens and closes references. A reference can open others, in which one input is slightly changed. */
#include "reference.h"

#include <stdlib.h>

#define N MPFR_RNDN

/* Difference quotients change an input by this fraction, which is far below the scale of every feature of the
 * model. */
static const double nearness = 0x1p-60;

/* Converts a number by way of doubles, because not every MPFR and not every compiler has __float128. */
void ref_set_real(mpfr_t z, domq_real x)
{
    mpfr_set_d(z, (double)x, N);
    for (int part = 0; part < 3 && mpfr_number_p(z); part++) {
        x -= (domq_real)(double)x;
        mpfr_add_d(z, z, (double)x, N);
    }
}

#define REF_ALL(p)                                                                                           \
    (p)->L, (p)->u, (p)->rq, (p)->theta_c, (p)->theta_u, (p)->theta_inf, (p)->theta_f, (p)->theta_leave,     \
        (p)->h_f, (p)->T, (p)->fuel_exact, (p)->fuel_paper, (mpfr_ptr)0

static struct ref *ref_new(mpfr_prec_t bits, double cut)
{
    struct ref *ref = calloc(1, sizeof *ref);
    if (!ref)
        abort();
    ref->bits = bits;
    ref->cut = cut;
    ref->dominoes = (size_t)-1;
    mpfr_inits2(bits, REF_ALL(ref));
    for (int k = 0; k < REF_INPUTS; k++)
        mpfr_init2(ref->in[k], bits);
    for (int k = 0; k < REF_COUNT; k++)
        mpfr_init2(ref->value[k], bits);
    return ref;
}

static struct ref *open_limited(const struct ref_input *input, mpfr_prec_t bits, double cut, size_t dominoes)
{
    struct ref *ref = ref_new(bits, cut);
    ref_set_real(ref->in[REF_S], input->s);
    ref_set_real(ref->in[REF_R], input->r);
    ref_set_real(ref->in[REF_D], input->d);
    ref_set_real(ref->in[REF_Q], input->q);
    ref_set_real(ref->in[REF_TILT], input->tilt);
    ref->paper = input->paper;
    ref->dominoes = dominoes;
    ref_start(ref);
    return ref;
}

struct ref *ref_open(const struct ref_input *input, mpfr_prec_t bits, double cut)
{
    return open_limited(input, bits, cut, (size_t)-1);
}

/*
 * Returns the number of bits with which to compute, so that enough are left after cancellation. More bits are
 * lost for small tilts and thin dominoes, since h(theta) - 1 is about d theta. Near r s = 1, bits are lost
 * because theta_leave approaches 0 like the square root of (1 - r s) / r^2.
 */
static mpfr_prec_t bits_for(const struct ref_input *input, int digits2)
{
    const double u = fabs((double)(1 - input->r * input->s));
    double lost = 2 * log2((double)input->r) - log2(fmax(u, 0x1p-120));
    if (input->tilt > 0 && input->tilt < 1)
        lost -= log2((double)input->tilt);
    if (input->d < 1)
        lost -= 2 * log2((double)input->d);
    return (mpfr_prec_t)(64 * ceil((digits2 + 70 + lost) / 64));
}

struct ref *ref_open_for(const struct ref_input *input, int digits2)
{
    return ref_open(input, bits_for(input, digits2), digits2 + 40);
}

struct ref *ref_open_pair(const struct ref_input *input, int digits2)
{
    return open_limited(input, bits_for(input, digits2), digits2 + 40, 2);
}

static void close_near(struct ref *ref)
{
    for (int k = 0; k < REF_INPUTS; k++) {
        if (ref->near[k])
            ref_close(ref->near[k]);
        ref->near[k] = NULL;
    }
}

void ref_close(struct ref *ref)
{
    close_near(ref);
    for (size_t i = 0; i < ref->n; i++)
        mpfr_clear(ref->h0[i]);
    for (int k = 0; k < REF_COUNT; k++)
        mpfr_clear(ref->value[k]);
    for (int k = 0; k < REF_INPUTS; k++)
        mpfr_clear(ref->in[k]);
    mpfr_clears(REF_ALL(ref));
    free(ref->h0);
    free(ref);
}

/* ---- Inputs nearby ---- */

/* Returns a reference with one input changed by the fraction e. For s, the changed number is 1 - r s or r s,
 * whichever is smaller. */
static struct ref *changed(const struct ref *ref, int input, double e)
{
    struct ref *near = ref_new(ref->bits, ref->cut);
    mpfr_t f;
    mpfr_init2(f, ref->bits);
    near->centre = ref;
    near->dominoes = ref->dominoes;
    near->link = ref->link;
    near->paper = ref->paper;
    for (int k = 0; k < REF_INPUTS; k++)
        mpfr_set(near->in[k], ref->in[k], N);
    mpfr_set_d(f, e, N);
    if (input == REF_S) {
        mpfr_ui_sub(near->u, 1, ref->u, N);
        mpfr_div(near->u, ref->u, near->u, N);
        if (mpfr_cmp_ui(near->u, 1) < 0)
            mpfr_mul(f, f, near->u, N);
    }
    mpfr_add_ui(f, f, 1, N);
    mpfr_mul(near->in[input], near->in[input], f, N);
    if (input == REF_R)
        mpfr_div(near->in[REF_S], near->in[REF_S], f, N);
    mpfr_clear(f);
    ref_start(near);
    return near;
}

/* Returns a nearby reference. Returns NULL if the input has no effect, that is, for 1 - r s = 0 and for a
 * tilt of 0. */
struct ref *ref_near(struct ref *ref, int input)
{
    bool fixed = (input == REF_S && mpfr_sgn(ref->u) <= 0) || mpfr_zero_p(ref->in[input]);
    if (!ref->near[input] && !fixed) {
        ref->nearby[input] = nearness;
        ref->near[input] = changed(ref, input, nearness);
        /* Changes the input in the other direction if followers detach in only one of the two references. */
        if (ref->near[input]->detaches != ref->detaches) {
            ref_close(ref->near[input]);
            ref->nearby[input] = -nearness;
            ref->near[input] = changed(ref, input, -nearness);
        }
    }
    return ref->near[input];
}

void ref_link(struct ref *ref, size_t link)
{
    ref->link = link;
    /* the values that depend on the tilt */
    close_near(ref);
    for (int k = REF_THETA_1; k <= REF_J; k++)
        ref->known[k] = false;
    ref->known[REF_OMEGASQ] = false;
}
