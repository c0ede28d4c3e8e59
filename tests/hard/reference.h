/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The model in hundreds of bits (MPFR), computed in other ways than in the library: with angles, asin, sin
 * and cos, with plain sums and differences of sums, and with so many bits that cancellation does no harm.
 * Inputs are exact.
 *
 * Units of error. The error of a computed F is compared with |F|, but not more strictly than the inputs of F
 * allow. If F_p is the derivative of F with respect to the input p, the scale is
 *
 *     max(|F|, sum over p of |p F_p|) = |F| max(1, kappa),
 *
 * and an error is counted in units of scale times the unit roundoff. This definition also works where F is 0.
 * The inputs are s, r, d, q and the tilt, with one exception: an r s close to 1 does not excuse an inaccurate
 * 1 - r s, which an fma computes exactly. So u = 1 - r s takes the place of s, and r is changed at constant
 * u. The scale of a difference of two large numbers, such as the margin and omegasq, includes the size of
 * these numbers.
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
    bool paper; /* true for the paper's fuel */
};

enum { REF_S, REF_R, REF_D, REF_Q, REF_TILT, REF_INPUTS };

/* Sums over the train at one tilt. */
struct ref_sums {
    mpfr_t dH, dH_prime, J; /* dH_prime is the derivative of dH with respect to the tilt */
    mpfr_t dH_prime_size;   /* the sum of the absolute values of the terms of dH_prime */
};

struct ref {
    mpfr_prec_t bits;
    double cut;      /* the chain ends where only 2^-cut of the head's motion is left */
    size_t dominoes; /* the largest number of dominoes; 2 for the pair */
    size_t link;     /* number of the domino for LINK_... */
    mpfr_t in[REF_INPUTS];
    bool paper;
    /* The geometry and the train at tilt 0, which ref_start computes. */
    mpfr_t L, u, rq, theta_c, theta_u, theta_inf, theta_f, theta_leave, h_f;
    mpfr_t T, fuel_exact, fuel_paper;
    bool detaches;
    size_t n;
    mpfr_t *h0; /* n energies */
    /* The values found so far. */
    mpfr_t value[REF_COUNT];
    bool known[REF_COUNT];
    int at_end; /* where the barrier is: -1 at the tilt 0, 1 at theta_c, 0 in between */
    /* How far rounding errors in the terms of H and H' move these values. Errors of the inputs are not
     * included. */
    double theta_m_size, stop_size, duration_size;
    struct ref *near[REF_INPUTS];
    double nearby[REF_INPUTS]; /* the fraction by which the input of the nearby reference differs */
    const struct ref *centre;  /* the reference of which an input was changed, or NULL */
};

/* Opens a reference that computes with `bits` bits. Aborts if more than ten million dominoes matter. */
struct ref *ref_open(const struct ref_input *input, mpfr_prec_t bits, double cut);
/* Opens a reference with enough bits for results with `digits2` correct bits. */
struct ref *ref_open_for(const struct ref_input *input, int digits2);
/* Opens a reference for a train of two dominoes. */
struct ref *ref_open_pair(const struct ref_input *input, int digits2);
void ref_close(struct ref *ref);
/* Sets the domino for the LINK_... quantities. */
void ref_link(struct ref *ref, size_t link);

/* Returns the value of a quantity, or NaN if the value does not exist. */
mpfr_srcptr ref_value(struct ref *ref, enum ref_quantity quantity);
double ref_double(struct ref *ref, enum ref_quantity quantity);
/* Returns |got - value|. */
double ref_error(struct ref *ref, enum ref_quantity quantity, domq_real got);
/* Returns the scale that is defined above. */
double ref_scale(struct ref *ref, enum ref_quantity quantity);
/* Returns the scale, or a lower bound of the scale that is at least `enough`. This saves work, since every
 * input takes one more reference. */
double ref_scale_up_to(struct ref *ref, enum ref_quantity quantity, double enough);

/* Finds the geometry and the train at tilt 0. The inputs must be set. */
void ref_start(struct ref *ref);
/* Returns a reference with one input slightly changed, or NULL if this input has no effect. */
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
/* Returns p dF/dp: the change of the quantity F divided by the fraction by which the input p changes. */
double ref_change(struct ref *ref, enum ref_quantity quantity, int input);

/* ---- Whether a growth is a limit, that is, whether its margin is 0 ---- */

/*
 * Returns the difference between r and the growth at which the margin is 0, to first order, and finds the
 * scale of this error. Returns NaN if there is no margin.
 */
double growth_error(const struct ref_input *input, bool pair, int digits2, domq_real r, double *scale);

/* Returns the distance from r to the growth at which the margin is 0, for a margin that is too curved for
 * growth_error. Tries the brackets r +- delta, r +- 4 delta, r +- 16 delta and so on, and then bisects. */
double growth_distance(const struct ref_input *input, bool pair, int digits2, domq_real r, double delta);

/* Returns the margin divided by K + B, or NaN if there is no fuel. */
double growth_margin(const struct ref_input *input, bool pair, int digits2, domq_real r);

/*
 * ---- The model in long double, computed quickly by plain formulas (sketch.c) ----
 *
 * It only finds where to search, for instance how many maxima H has and near which tilts, and never supplies
 * a result.
 */

enum { SKETCH_NODES = 256 };

struct sketch {
    long double s, r, d, L, theta_c, theta_f, theta_leave, rq, cut;
    bool detaches;
    size_t dominoes;
};

struct sketch sketch_of(const struct ref *ref);
/* Returns dH / d tilt. */
long double sketch_slope(const struct sketch *sketch, long double tilt);
/* Returns H(tilt) - H(0). */
long double sketch_energy_change(const struct sketch *sketch, long double tilt);
/* Finds tilts from 0 to theta_c in increasing order, which are dense where H may change fast. Returns the
 * number of these tilts. */
int sketch_nodes(const struct sketch *sketch, long double node[SKETCH_NODES]);
/* Returns the tilt of the head at which a follower detaches, because the tilt of its leader passes
 * theta_leave. */
long double sketch_leaving(const struct sketch *sketch);

#endif
