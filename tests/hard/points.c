/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "sweep.h"

#include "../unit/support.h"

/* Returns a random number between lo and hi, all of whose bits are random. */
static domq_real random_real(uint64_t *seed, double lo, double hi, enum precision precision)
{
    double x = random_log(seed, lo, hi);
    return rounded_to(precision, (domq_real)x * (1 + (domq_real)(random_unit(seed) * 0x1p-52)));
}

/* Returns a random growth, often one close to the reach, where 1 - r s is small. If 1 - r s is about d^2 and
 * the head is thin, its followers slow down near the maximum of H. */
static domq_real random_growth(uint64_t *seed, domq_real s, domq_real d, enum precision precision)
{
    const double finest = precision == IN_FLOAT ? 1e-7 : precision == IN_DOUBLE ? 1e-15 : 1e-30;
    const double reach = 1 / (double)s, kind = random_unit(seed);
    if (kind < 0.06) {
        double u = (double)(d * d) * random_log(seed, 1e-5, 1e3);
        return rounded_to(precision, (1 - (domq_real)fmin(fmax(u, finest / 20), 0.5)) / s);
    }
    if (kind < 0.3)
        return rounded_to(precision, (1 - random_real(seed, finest, 0.5, precision)) / s);
    if (kind < 0.55)
        return 1 + random_real(seed, 1e-12, fmax(1e-11, reach - 1), precision);
    if (kind < 0.9)
        return rounded_to(precision, (domq_real)pow(reach, random_unit(seed)));
    return kind < 0.95 ? 1 : rounded_to(precision, 1 / s);
}

static struct ref_input random_input(uint64_t *seed, enum precision precision)
{
    struct ref_input input;
    input.s = random_real(seed, 1e-6, 1, precision);
    input.d = random_real(seed, 1e-8, 3, precision);
    const double kind = random_unit(seed);
    input.q = kind < 0.33 ? 3 : kind < 0.66 ? 4 : random_real(seed, 0.3, 10, precision);
    input.r = rounded_to(precision, random_growth(seed, input.s, input.d, precision));
    input.r = input.r < 1 ? 1 : input.r;
    input.paper = random_unit(seed) < 0.3;
    input.tilt = 0;
    return input;
}

domq_real point_tilt(uint64_t *seed, domq_real theta_c, enum precision precision)
{
    const double kind = random_unit(seed);
    domq_real tilt;
    if (kind < 0.06)
        return kind < 0.03 ? 0 : theta_c;
    if (kind < 0.3)
        tilt = theta_c * random_real(seed, 1e-16, 1, precision);
    else if (kind < 0.5)
        tilt = theta_c * (1 - random_real(seed, 1e-16, 1, precision));
    else
        tilt = theta_c * (domq_real)random_unit(seed);
    tilt = rounded_to(precision, tilt);
    return tilt > theta_c ? theta_c : tilt;
}

/* Returns true if too many dominoes contribute more than 2^-100. Most points must be quick, but a few may
 * take a long time. */
static bool too_long(const struct ref_input *input, uint64_t *seed, enum precision precision)
{
    const double s = (double)input->s, r = (double)input->r, q = (double)input->q;
    const double rate = q * log(r) + r * sqrt(s * (s + 2 * (double)input->d)), kind = random_unit(seed);
    const double most = kind < 0.96 ? 200 : kind < 0.998 ? 2000 : 10000;
    /* In float, the smallest energies are about r^-(2q+1). Even their last bits must not be below 2^-126. */
    return 70 / rate > most || (precision == IN_FLOAT && (2 * q + 1) * log2(r) > 126 - 24);
}

struct ref_input point_random(uint64_t *seed, enum precision precision)
{
    struct ref_input input;
    do
        input = random_input(seed, precision);
    while (too_long(&input, seed, precision));
    return input;
}

bool point_can_grow(const struct ref_input *input, bool pair, enum precision precision)
{
    const double s = (double)input->s, d = (double)input->d, q = (double)input->q;
    const bool underflows_at_reach = precision == IN_FLOAT && -(2 * q + 1) * log2(s) > 126 - 24;
    return (pair || 70 / sqrt(s * (s + 2 * d)) < 400) && !underflows_at_reach;
}
