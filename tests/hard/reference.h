/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The model in hundreds of bits (MPFR), by other means than the library: plain angles with asin, sin and cos,
 * plain sums, differences of sums, with so many bits that cancellation does no harm. Inputs are exact.
 *
 * Units of error. The error of a computed F is compared with |F|, but not more strictly than its inputs
 * allow: with F_p the change of F when the input p changes by a fraction of itself, the scale is
 *
 *     max(|F|, sum over p of |p F_p|) = |F| max(1, kappa),
 *
 * and an error is counted in units of scale times the unit roundoff. This is defined where F is 0, too. The
 * inputs are s, r, d, q and the tilt, with one exception: r s close to 1 does not excuse a bad 1 - r s, which
 * can be computed exactly (fma); so a fraction of u = 1 - r s is changed instead, and r at constant u. A
 * difference of two large numbers (margin, omegasq) has their size in its scale.
 */
#ifndef HARD_REFERENCE_H
#define HARD_REFERENCE_H

#include "../unit/ask.h"
#include <mpfr.h>

#define REF_QUANTITIES(X)                                                                                    \
    X(THETA_C, "theta_c")                                                                                    \
    X(THETA_U, "theta_u")                                                                                    \
    X(THETA_INF, "theta_inf")                                                                                \
    X(THETA_F, "theta_f")                                                                                    \
    X(THETA_LEAVE, "theta_leave")                                                                            \
    X(THETA_1, "theta_1")                                                                                    \
    X(SLOPE, "slope")                                                                                        \
    X(ARM_A, "arm_a")                                                                                        \
    X(ARM_B, "arm_b")                                                                                        \
    X(LINK_THETA, "link.theta")                                                                              \
    X(LINK_SLOPE, "link.slope")                                                                              \
    X(LINK_ARM_A, "link.arm_a")                                                                              \
    X(LINK_ARM_B, "link.arm_b")                                                                              \
    X(LINK_WEIGHT, "link.weight")                                                                            \
    X(DH, "dH")                                                                                              \
    X(J, "J")                                                                                                \
    X(J0, "J0")                                                                                              \
    X(FUEL_EXACT, "fuel.exact")                                                                              \
    X(FUEL_PAPER, "fuel.paper")                                                                              \
    X(LAUNCH_OMEGASQ, "launch.omegasq")                                                                      \
    X(KINETIC, "kinetic")                                                                                    \
    X(THETA_M, "theta_m")                                                                                    \
    X(BARRIER, "barrier")                                                                                    \
    X(MARGIN, "margin")                                                                                      \
    X(OMEGASQ, "omegasq")                                                                                    \
    X(STOP, "stop")                                                                                          \
    X(DURATION, "duration")                                                                                  \
    X(R_MAX, "r_max")                                                                                        \
    X(PAIR, "pair")                                                                                          \
    X(BEST_S, "best.s")                                                                                      \
    X(BEST_R, "best.r_max")

enum ref_quantity {
#define REF_ENUM(NAME, name) REF_##NAME,
    REF_QUANTITIES(REF_ENUM)
#undef REF_ENUM
        REF_COUNT
};

const char *ref_name(enum ref_quantity quantity);

struct ref_input {
    domq_real s, r, d, q, tilt;
    bool paper; /* which fuel */
};

enum { REF_S, REF_R, REF_D, REF_Q, REF_TILT, REF_INPUTS };

/* Sums over the train at one tilt. */
struct ref_sums {
    mpfr_t dH, dH_prime, J; /* dH_prime: derivative by the tilt */
    mpfr_t dH_prime_size;   /* the same with all terms positive */
};

struct ref {
    mpfr_prec_t bits;
    double cut;      /* followers are followed until 2^-cut of the head's motion is left */
    size_t dominoes; /* the most dominoes; 2 for the pair */
    size_t link;     /* number of the domino for LINK_... */
    mpfr_t in[REF_INPUTS];
    bool paper;
    /* Geometry, and the train at tilt 0: known from the start. */
    mpfr_t L, u, rq, theta_c, theta_u, theta_inf, theta_f, theta_leave, h_f;
    mpfr_t T, fuel_exact, fuel_paper;
    bool detaches;
    size_t n;
    mpfr_t *h0; /* n energies */
    /* The values found up to now. */
    mpfr_t value[REF_COUNT];
    bool known[REF_COUNT];
    int at_end; /* where the barrier is: -1 at 0, 0 within, 1 at theta_c */
    /* How far rounding of the terms of H and H', not of the inputs, moves the answer. */
    double theta_m_size, stop_size, duration_size;
    struct ref *near[REF_INPUTS];
    double nearby[REF_INPUTS]; /* the fraction by which their input differs */
    const struct ref *centre;  /* the reference that this one is near */
};

/* Opens a reference with that many bits in all arithmetic. Aborts if more than ten million dominoes
 * matter. */
struct ref *ref_open(const struct ref_input *input, mpfr_prec_t bits, double cut);
/* Opens a reference with enough bits for `digits2` good bits of the answers at these inputs. */
struct ref *ref_open_for(const struct ref_input *input, int digits2);
/* Opens a reference for a train of two dominoes. */
struct ref *ref_open_pair(const struct ref_input *input, int digits2);
void ref_close(struct ref *ref);
/* Sets another tilt of the same train: cheaper than a new reference. */
void ref_tilt(struct ref *ref, domq_real tilt);
/* Sets another domino for LINK_.... */
void ref_link(struct ref *ref, size_t link);

/* Returns the value; NaN if it does not exist. */
mpfr_srcptr ref_value(struct ref *ref, enum ref_quantity quantity);
double ref_double(struct ref *ref, enum ref_quantity quantity);
/* Returns |got - value|. */
double ref_error(struct ref *ref, enum ref_quantity quantity, domq_real got);
/* Returns the scale: see above. */
double ref_scale(struct ref *ref, enum ref_quantity quantity);
/* Returns the scale, or something smaller that is still enough: every input costs one more reference. */
double ref_scale_up_to(struct ref *ref, enum ref_quantity quantity, double enough);
double ref_kappa(struct ref *ref, enum ref_quantity quantity);

/* Finds the geometry and the train at tilt 0, once the inputs are set. */
void ref_start(struct ref *ref);
/* Returns NULL for an input without any effect. */
struct ref *ref_near(struct ref *ref, int input);
void ref_sums_init(struct ref_sums *sums, mpfr_prec_t bits);
void ref_sums_clear(struct ref_sums *sums);
void ref_walk(struct ref *ref, mpfr_srcptr tilt, struct ref_sums *sums);
/* Finds REF_THETA_1 to REF_J. */
void ref_walk_at_tilt(struct ref *ref);
void ref_set_real(mpfr_t z, domq_real x);
void ref_find_barrier(struct ref *ref);
void ref_find_stop(struct ref *ref);
void ref_find_duration(struct ref *ref);
/* Returns |p dF/dp| with its sign: the change of the quantity over the fraction by which the input
 * changes. */
double ref_change(struct ref *ref, enum ref_quantity quantity, int input);

#endif
