/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "naive.h"

#include <math.h>

/* More dominoes than in any real row. */
enum { DOMINOES = 1000 };

struct naive {
    double s, r, d, q, L, theta_c, x_f, x_last;
    int dominoes;
    bool paper;
};

struct sums {
    double H, slope, J; /* slope of H */
};

static struct naive naive_train(double s, double r, double d, double q, bool paper, int dominoes)
{
    struct naive k = {.s = s, .r = r, .d = d, .q = q, .L = s + d, .paper = paper, .dominoes = dominoes};
    k.theta_c = asin(r * s);
    if (1 / (r * r) < k.L * k.L - d * d) /* (41; A17), (42; A18), (40; A16) */
        k.x_f = (1 / (r * r) + k.L * k.L - d * d) / (2 / r * k.L);
    else
        k.x_f = sin(acos(d / k.L));
    k.x_last = 1 / (r * r) < k.L * k.L - d * d ? k.x_f : 1;
    return k;
}

/* Adds up (19; c1), (20; c2) with the scheme (30; A5), (31; A6), (34; A10); ends as soon as x exceeds x_f. */
static struct sums naive_sums(const struct naive *k, double theta)
{
    struct sums sums = {0, 0, 0};
    double x = sin(theta), y = cos(theta), slope = 1;
    for (int i = 0; i < k->dominoes && x <= k->x_last; i++) {
        double w = pow(k->r, -k->q * i);
        if (w < 1e-17)
            break;
        sums.H += w * (y + k->d * x);
        sums.slope += w * slope * (k->d * y - x);
        sums.J += w * pow(k->r, -i) * slope * slope;
        double X = k->r * (k->L * y - k->d), Y = sqrt(1 - X * X), x0 = x;
        slope *= (Y / k->r - k->L * x) / (Y / k->r);
        x = Y * x + X * y;
        y = Y * y - X * x0;
    }
    return sums;
}

static double naive_energy_change(const struct naive *k, double theta)
{
    return naive_sums(k, theta).H - naive_sums(k, 0).H;
}

static double naive_fuel(const struct naive *k, bool paper)
{
    double theta_f = asin(k->x_f);
    return paper ? 1 - cos(theta_f) - k->d * sin(theta_f) : -naive_energy_change(k, k->theta_c);
}

/* Returns the launch by (24; c6), for the pair by (9; b5) and (15; b11). */
static double naive_launch(const struct naive *k)
{
    if (k->dominoes == 2) {
        double w = sqrt(1 + k->d * k->d) - (cos(k->theta_c) + k->d * sin(k->theta_c)),
               I = pow(k->r, -k->q - 1);
        return k->r * w * (I / (1 + I)) * (I / (1 + I));
    }
    double J = naive_sums(k, 0).J, P = naive_fuel(k, k->paper);
    return P > 0 ? P * (J - 1) / (J * (pow(k->r, k->q) * J - J + 1)) : (double)NAN;
}

/* Raises theta until H decreases: then theta is beyond the maximum. */
static double naive_top(const struct naive *k)
{
    const double step = k->theta_c / 1000;
    double theta = 0;
    for (double H = naive_sums(k, 0).H; theta < k->theta_c; theta += step) {
        double next = naive_sums(k, theta + step).H;
        if (!(next > H))
            break;
        H = next;
    }
    double lo = fmax(0, theta - step), hi = fmin(k->theta_c, theta + step);
    if (naive_sums(k, lo).slope <= 0)
        return lo;
    if (naive_sums(k, hi).slope >= 0)
        return hi;
    for (int i = 0; i < 60; i++) {
        double middle = (lo + hi) / 2;
        *(naive_sums(k, middle).slope > 0 ? &lo : &hi) = middle;
    }
    return lo;
}

static double naive_kinetic(const struct naive *k)
{
    double J = k->dominoes == 2 ? 1 + pow(k->r, -k->q - 1) : naive_sums(k, 0).J;
    return J * naive_launch(k);
}

static double naive_margin(const struct naive *k)
{
    return naive_kinetic(k) - naive_energy_change(k, naive_top(k));
}

/* Returns omega^2 by (21; c3). */
static double naive_omegasq(const struct naive *k, double theta)
{
    return (naive_kinetic(k) - naive_energy_change(k, theta)) / naive_sums(k, theta).J;
}

static double naive_duration(const struct naive *k)
{
    enum { STEPS = 2000 };
    double sum = 0;
    for (int i = 0; i <= STEPS; i++) {
        double weight = i == 0 || i == STEPS ? 1 : i % 2 ? 4 : 2;
        sum += weight / sqrt(naive_omegasq(k, k->theta_c * i / STEPS));
    }
    return sum * k->theta_c / STEPS / 3;
}

static double naive_stop(const struct naive *k)
{
    double lo = 0, hi = k->theta_c / 1000;
    while (hi < k->theta_c && naive_omegasq(k, hi) > 0) {
        lo = hi;
        hi += k->theta_c / 1000;
    }
    for (int i = 0; i < 60; i++) {
        double middle = (lo + hi) / 2;
        *(naive_omegasq(k, middle) > 0 ? &lo : &hi) = middle;
    }
    return lo;
}

/* Raises r until the margin is negative; the boundary is between the last two. */
static double naive_growth(struct naive k)
{
    double lo = 1, hi;
    for (hi = 1.01; hi < 1 / k.s; hi += 0.01) {
        k = naive_train(k.s, hi, k.d, k.q, k.paper, k.dominoes);
        if (!(naive_margin(&k) >= 0))
            break;
        lo = hi;
    }
    if (hi >= 1 / k.s)
        return 1 / k.s;
    for (int i = 0; i < 60; i++) {
        double middle = (lo + hi) / 2;
        k = naive_train(k.s, middle, k.d, k.q, k.paper, k.dominoes);
        *(naive_margin(&k) >= 0 ? &lo : &hi) = middle;
    }
    return lo;
}

double naive_value(const struct ref_input *input, enum ref_quantity quantity)
{
    const double tilt = (double)input->tilt;
    const struct naive k = naive_train((double)input->s, (double)input->r, (double)input->d, (double)input->q,
                                       input->paper, quantity == REF_PAIR ? 2 : DOMINOES);
    const double X = k.r * (k.L * cos(tilt) - k.d), Y = sqrt(1 - X * X);
    switch (quantity) {
    case REF_THETA_C:
        return k.theta_c;
    case REF_THETA_F:
        return asin(k.x_f);
    case REF_THETA_INF:
        return acos(k.d / k.L);
    case REF_THETA_LEAVE:
        return acos((k.L * k.L + k.d * k.d - 1 / (k.r * k.r)) / (2 * k.d * k.L));
    case REF_THETA_1:
        return tilt + asin(X);
    case REF_SLOPE:
        return (Y / k.r - k.L * sin(tilt)) / (Y / k.r);
    case REF_ARM_A:
        return Y / k.r - k.L * sin(tilt);
    case REF_ARM_B:
        return Y / k.r;
    case REF_DH:
        return naive_energy_change(&k, tilt);
    case REF_J:
        return naive_sums(&k, tilt).J;
    case REF_J0:
        return naive_sums(&k, 0).J;
    case REF_FUEL_EXACT:
        return naive_fuel(&k, false);
    case REF_FUEL_PAPER:
        return naive_fuel(&k, true);
    case REF_LAUNCH_OMEGASQ:
        return naive_launch(&k);
    case REF_KINETIC:
        return naive_kinetic(&k);
    case REF_THETA_M:
        return naive_top(&k);
    case REF_BARRIER:
        return naive_energy_change(&k, naive_top(&k));
    case REF_MARGIN:
        return naive_margin(&k);
    case REF_OMEGASQ:
        return naive_omegasq(&k, tilt);
    case REF_STOP:
        return naive_stop(&k);
    case REF_DURATION:
        return naive_duration(&k);
    case REF_R_MAX:
    case REF_PAIR:
        return naive_growth(k);
    default:
        return (double)NAN;
    }
}
