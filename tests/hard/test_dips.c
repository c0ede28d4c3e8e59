/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: proof */
/*
 * r_max of trains whose margin has a dip of a given depth, on both sides of zero. The separation at which the
 * dip touches 0 comes from a minimization of the margin by plain sums, which share no code with the model.
 */
#include "../unit/support.h"
#include "domino_proof.h"
#include "plain.h"
#include "sweep.h"

struct scene {
    double d, q, rho, mu, s, r; /* r_max jumps at s, and the dip is at r */
};

static const struct scene scenes[] = {
    {0.254524, 0.474363, 0, 0, 0.119202042, 4.46689},
    {0.0244133, 0.653582, 0, 0, 0.00735522243724, 5.22211},
    {0.0016585772691508735, 0.84128950999683272, 0, 0, 0.0007904185218329231, 16.01510219},
    {0.12773775370585011, 0.67238449435099856, 0, 0, 0.055906539782145763, 9.519301739},
    {0.22373795343230674, 0.69380355920198367, 0, 0, 0.13227114600415679, 4.403084767},
    {0.082457764072550802, 0.60035705876465428, 0, 0, 0.024667433946930831, 6.262129298},
    {0.15622093930854777, 0.64742926209836527, 0.010775842012546572, 0, 0.059502663130984824, 8.493397434},
    {0.27334726204119109, 0.54460422910635375, 0.012051470181822238, 0, 0.13410886401245503, 4.013587643},
    {0.2, 0.65, 0, 0.1, 0.1306, 4.56},
};

static domq_real share(const struct scene *at, domq_real s, domq_real r)
{
    if (at->mu > 0)
        return plain_share_rubbing((long double)s, at->d, at->q, at->mu, (long double)r);
    if (at->rho > 0)
        return plain_share_rounded((long double)s, at->d, at->q, at->rho, (long double)r);
    return plain_share(s, at->d, at->q, r);
}

/* Returns the depth of the dip: the minimum of (K - B) / K near at->r. */
static domq_real depth(const struct scene *at, domq_real s, domq_real *r)
{
    const domq_real part = (domq_real)0.6180339887498948482L;
    const double width = at->mu > 0 || at->rho > 0 ? 1e-11 : 1e-16;
    domq_real lo = (domq_real)at->r * 0.985, hi = (domq_real)at->r * 1.015, a = hi - part * (hi - lo),
              b = lo + part * (hi - lo), at_a = share(at, s, a), at_b = share(at, s, b);
    while (hi - lo > (domq_real)width * hi)
        if (at_a < at_b) {
            hi = b;
            b = a;
            at_b = at_a;
            a = hi - part * (hi - lo);
            at_a = share(at, s, a);
        } else {
            lo = a;
            a = b;
            at_a = at_b;
            b = lo + part * (hi - lo);
            at_b = share(at, s, b);
        }
    *r = at_a < at_b ? a : b;
    return at_a < at_b ? at_a : at_b;
}

/* Returns the first root, which is below the minimum at r. */
static domq_real root_before(const struct scene *at, domq_real s, domq_real r)
{
    domq_real lo = (domq_real)at->r * 0.985, hi = r;
    for (int k = 0; k < 110 && hi - lo > 0; k++) {
        const domq_real middle = (lo + hi) / 2;
        *(share(at, s, middle) >= 0 ? &lo : &hi) = middle;
    }
    return lo;
}

struct dips {
    int trains, open, wrong, proved;
};

static void check(const struct scene *at, domq_real s, enum precision precision, bool proof,
                  struct dips *tally)
{
    struct setup train = setup_default();
    struct domq_limit limit;
    domq_real r;
    train.s = s;
    train.d = at->d;
    train.q = at->q;
    train.rho = at->rho;
    train.mu = at->mu;
    train.precision = precision;
    train.tol = any_arithmetic(precision).tol_default;
    const domq_real deep = depth(at, s, &r);
    const enum dom_status status = ask_limit_rmax(&train, &limit);
    const double least = precision == IN_QUAD && at->mu == 0 ? 1e-31 : 1e-16;
    const bool sharp = at->mu == 0 && at->rho == 0;
    bool wrong = false;
    tally->trains++;
    if (status == DOM_OPEN) {
        tally->open++;
        wrong = fabs((double)deep) > least || !(fabs((double)(limit.open / r) - 1) < 1e-6);
    } else if (status != DOM_OK) {
        wrong = true;
    } else if (deep < 0) {
        const domq_real root = root_before(at, s, r), off = limit.r_max - root;
        /* the slope of the margin at the root is about 2 deep / (r - root) */
        const double own =
            (double)root * 1e-15 + (sharp ? 1e-31 / (at->d * at->d) : 1e-16) * (double)((r - root) / -deep);
        wrong = !(fabs((double)off) <= (double)limit.uncertainty + own) ||
                !(limit.uncertainty < 1e-5 * (double)root);
        if (wrong)
            print_error("root %.20Lg ", (long double)root);
    } else {
        wrong = !(limit.r_max > r * (domq_real)1.015);
    }
    if (proof) {
        struct dom_train same = dom_train_default();
        same.s = (double)s;
        same.d = at->d;
        same.q = at->q;
        struct dom_proof proved;
        assert_status(dom_prove_rmax(&same, NULL, &proved), DOM_OK);
        tally->proved += proved.ends == DOM_PROVED_BARRIER;
        if (status == DOM_OK && proved.ends != DOM_PROVED_NONE &&
            (proved.low > (double)limit.r_max * (1 + 1e-14) ||
             proved.high < (double)limit.r_max * (1 - 1e-14)))
            wrong = true;
        if (wrong)
            print_error("proved %.17g to %.17g ", proved.low, proved.high);
    }
    if (wrong) {
        tally->wrong++;
        print_error(
            "precision %d: %s r_max %.20Lg +- %.2g open %.17g, depth %.6g at %.17g: s %.36Lg d %.17g q "
            "%.17g rho %.17g mu %.17g\n",
            (int)precision, dom_status_text(status), (long double)limit.r_max, (double)limit.uncertainty,
            (double)limit.open, (double)deep, (double)r, (long double)s, at->d, at->q, at->rho, at->mu);
    }
}

/* Returns the separation at which the dip touches 0, and the change of its depth with s. */
static domq_real touching(const struct scene *at, domq_real *slope)
{
    domq_real s[2] = {at->s, (domq_real)at->s * (1 + (domq_real)1e-5)}, r,
              f[2] = {depth(at, s[0], &r), depth(at, s[1], &r)};
    *slope = (f[1] - f[0]) / (s[1] - s[0]);
    for (int k = 0; k < 8 && f[1] != f[0]; k++) {
        const domq_real next = s[1] - f[1] * (s[1] - s[0]) / (f[1] - f[0]);
        s[0] = s[1];
        f[0] = f[1];
        s[1] = next;
        f[1] = depth(at, next, &r);
        if (fabs((double)((s[1] - s[0]) / s[1])) < 1e-30)
            break;
    }
    return s[1];
}

TEST(the_depth_of_a_dip_decides)
{
    struct dips tally = {0};
    const bool brief = sweep_size() < 1;
    const int step = brief ? 5 : 4;
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i += brief ? 3 : 1) {
        const struct scene *at = &scenes[i];
        const bool sharp = at->mu == 0 && at->rho == 0;
        domq_real slope, s = touching(at, &slope);
        for (int k = 6; k <= (sharp ? 28 : 15); k += step)
            for (int side = -1; side <= 1; side += 2) {
                const domq_real there = s + (domq_real)(side * pow(10, -k)) / slope;
                if (k <= 15)
                    check(at, (double)there, IN_DOUBLE, sharp && k <= (brief ? 6 : 10), &tally);
                check(at, there, IN_QUAD, false, &tally);
            }
    }
    print_message("# %d dips, %d of them open, %d proved\n", tally.trains, tally.open, tally.proved);
    assert_int_equal(tally.wrong, 0);
}

/* ---- The best separation ---- */

struct top {
    double s, r;
};

/* Closes in on the largest r_max between two separations. */
static struct top close_in(double d, double q, struct top top, double lo, double hi, double least)
{
    for (int zoom = 0; zoom < 9; zoom++) {
        const double width = (hi - lo) / 10;
        for (int i = 0; i <= 12; i++) {
            const double s = lo + (hi - lo) * i / 12, r = plain_rmax(s, d, q, 1.05);
            if (r > top.r)
                top = (struct top){s, r};
        }
        if (zoom == 1 && top.r < least)
            break;
        lo = fmax(top.s - width, 1e-7);
        hi = fmin(top.s + width, 1);
    }
    return top;
}

/* Finds the best separation by a dense search, which refines the three highest samples. */
static struct top dense_best(double d, double q)
{
    enum { MOST = 260, TOPS = 3 };
    struct top at[MOST], best = {0, 0};
    int n = 0, lower = 0;
    for (double s = 1; n < MOST && s > 1e-6 && lower < 60; s *= 0.95, n++) {
        at[n] = (struct top){s, plain_rmax(s, d, q, 1.05)};
        lower = at[n].r > best.r ? 0 : lower + (best.r > 1);
        best = at[n].r > best.r ? at[n] : best;
    }
    for (int pass = 0; pass < TOPS; pass++) {
        int top = -1;
        for (int k = 0; k < n; k++)
            if (at[k].r > 0 && (top < 0 || at[k].r > at[top].r) && (k == 0 || at[k].r >= at[k - 1].r) &&
                (k + 1 == n || at[k].r >= at[k + 1].r))
                top = k;
        if (top < 0)
            break;
        const struct top found = close_in(d, q, at[top], at[top].s * 0.95, fmin(at[top].s / 0.95, 1),
                                          pass == 0 ? 0 : best.r * 0.98);
        best = found.r > best.r ? found : best;
        at[top].r = -1;
    }
    return best;
}

/* Returns r_max of plain_rmax with the digits of the widest type. */
static double polished(struct top top, double d, double q)
{
    if (top.r * top.s > 1 - 1e-9)
        return top.r;
    return (double)plain_root(top.s, d, q, top.r * (1 - 1e-8), top.r * (1 + 1e-8));
}

TEST(best_against_a_dense_search)
{
    uint64_t seed = 52;
    int found = 0, wrong = 0;
    const int pairs = 2; /* 5 s each */
    for (int i = 0; i < pairs; i++) {
        struct dom_train train = dom_train_default();
        struct dom_best best = {.s = 0};
        struct dom_barrier barrier;
        train.d = random_log(&seed, 1e-4, 0.6);
        train.q = random_log(&seed, 0.3, 6);
        const enum dom_status status = dom_limit_best(&train, NULL, &best);
        const struct top own = dense_best(train.d, train.q);
        const double most = own.r > 1 ? polished(own, train.d, train.q) : own.r;
        bool bad = status == DOM_OK ? most > best.r_max + fmax(1e-9 * best.r_max, best.r_uncertainty)
                                    : own.r > 1 + 1e-9;
        if (status == DOM_OK) { /* this train goes on: at the growth itself, and in every dip before it */
            found++;
            train.s = best.s;
            train.r = best.r_max - best.r_uncertainty;
            bad = bad || dom_barrier_find(&train, NULL, &barrier) != DOM_OK;
            /* plain_rmax knows its root in double only */
            bad = bad || plain_rmax(best.s, train.d, train.q, 1.02) < train.r * (1 - 1e-9);
        }
        if (bad && ++wrong)
            print_error("d %.17g q %.17g: %s, s %.15g r %.15g +- %.2g; dense s %.15g r %.15g\n", train.d,
                        train.q, dom_status_text(status), best.s, best.r_max, best.r_uncertainty, own.s,
                        most);
    }
    print_message("# %d best separations, %d wrong\n", found, wrong);
    assert_true(wrong == 0 && found * 2 > pairs);
}

/* Returns the smallest margin between two growths, by golden section. */
static double dip_between(double s, double d, double q, double lo, double hi)
{
    const double part = 0.6180339887498949;
    double a = hi - part * (hi - lo), b = lo + part * (hi - lo), at_a = plain_share_double(s, d, q, a),
           at_b = plain_share_double(s, d, q, b);
    for (int k = 0; k < 24; k++) {
        const bool left = at_a < at_b;
        *(left ? &hi : &lo) = left ? b : a;
        *(left ? &b : &a) = left ? a : b;
        *(left ? &at_b : &at_a) = left ? at_a : at_b;
        *(left ? &a : &b) = left ? hi - part * (hi - lo) : lo + part * (hi - lo);
        *(left ? &at_a : &at_b) = plain_share_double(s, d, q, left ? a : b);
    }
    return fmin(at_a, at_b);
}

/*
 * Returns the smallest margin at growths up to R, dips included, or a negative margin at one of them. The
 * growths differ by 4 %; near the reach they are evenly spaced in sqrt(1 - r s), because the margin changes
 * rapidly there.
 */
static double spare_at(double s, double d, double q, double R)
{
    enum { NEAR = 60, MOST = 400 };
    double r[MOST], f[MOST], least = R * s < 1 ? plain_share_double(s, d, q, R) : -1;
    const double from = fmin(R, 0.6 / s), x = sqrt(fmax(1 - from * s, 0)), x_R = sqrt(fmax(1 - R * s, 0));
    int n = 1;
    r[0] = 1;
    for (double at = 1.04; at < from && n < MOST - NEAR - 1; at *= 1.04)
        r[n++] = at;
    for (int k = 0; k < NEAR; k++) {
        const double u = x + (x_R - x) * k / NEAR;
        if ((1 - u * u) / s > 1)
            r[n++] = (1 - u * u) / s;
    }
    r[n++] = R;
    for (int k = 0; k < n && least > 0; k++) {
        f[k] = plain_share_double(s, d, q, r[k]);
        least = fmin(least, f[k]);
        if (k > 1 && f[k - 1] < f[k - 2] && f[k - 1] <= f[k])
            least = fmin(least, dip_between(s, d, q, r[k - 2], r[k]));
    }
    return least;
}

/* Returns the largest spare_at of all separations: samples, and golden sections around the three largest. */
static double most_spare(double d, double q, double R, double *where)
{
    enum { SAMPLES = 1000, TOPS = 3 };
    static double at[SAMPLES];
    const double ratio = 0.99, part = 0.6180339887498949;
    double most = -1;
    for (int k = 0; k < SAMPLES; k++)
        at[k] = spare_at(pow(ratio, k), d, q, R);
    for (int pass = 0; pass < TOPS; pass++) {
        int top = 0;
        for (int k = 1; k < SAMPLES; k++)
            if (at[k] > at[top] && at[k] >= at[k - 1] && (k + 1 == SAMPLES || at[k] >= at[k + 1]))
                top = k;
        double lo = pow(ratio, top + 1), hi = fmin(pow(ratio, top - 1), 1), best = at[top];
        double a = hi - part * (hi - lo), b = lo + part * (hi - lo), at_a = spare_at(a, d, q, R),
               at_b = spare_at(b, d, q, R);
        while (hi - lo > 1e-8 * hi && best <= 0) {
            const bool left = at_a > at_b;
            *(left ? &hi : &lo) = left ? b : a;
            *(left ? &b : &a) = left ? a : b;
            *(left ? &at_b : &at_a) = left ? at_a : at_b;
            *(left ? &a : &b) = left ? hi - part * (hi - lo) : lo + part * (hi - lo);
            *(left ? &at_a : &at_b) = spare_at(left ? a : b, d, q, R);
            best = fmax(best, fmax(at_a, at_b));
        }
        if (best > most) {
            most = best;
            *where = (lo + hi) / 2;
        }
        at[top] = -1;
    }
    return most;
}

/*
 * Checks that no separation allows a growth that is larger by 1e-8, and that the best train goes on. For thin
 * dominoes the growths differ by more, because sums in double are less certain: by 1e-6 at d = 1e-3. For even
 * thinner dominoes this search would be the weaker witness.
 */
TEST(no_separation_is_better)
{
    uint64_t seed = 53;
    int found = 0, wrong = 0;
    const int pairs = (int)ceil(150 * sweep_size());
    for (int i = 0; i < pairs; i++) {
        struct dom_train train = dom_train_default();
        struct dom_best best = {.s = 0};
        train.d = random_log(&seed, 1e-3, 0.6);
        train.q = random_log(&seed, 0.3, 6);
        const enum dom_status status = dom_limit_best(&train, NULL, &best);
        const double by = 1e-8 + 1e-12 / (train.d * train.d),
                     R = (status == DOM_OK ? best.r_max : 1) * (1 + by);
        double where = 0;
        const double spare = most_spare(train.d, train.q, R, &where);
        bool bad = (status != DOM_OK && status != DOM_NO_GROWTH) || spare > 0;
        found += status == DOM_OK;
        if (status == DOM_OK)
            bad = bad || spare_at(best.s, train.d, train.q, best.r_max * (1 - by)) < -by;
        if (bad && ++wrong)
            print_error("d %.17g q %.17g: %s, s %.15g r %.15g +- %.2g; better by %.3g near s %.15g\n",
                        train.d, train.q, dom_status_text(status), best.s, best.r_max, best.r_uncertainty,
                        spare, where);
    }
    print_message("# %d of %d have a best separation, %d wrong\n", found, pairs, wrong);
    assert_true(wrong == 0 && found * 3 > pairs);
}

/* Checks trains close to the separation at which a dip touches 0. The side of it decides. */
TEST(trains_beside_a_jump)
{
    enum { TRAINS = 100, SCENES = 3 };
    uint64_t seed = 7;
    int wrong = 0, stop = 0;
    const int trains = (int)ceil(TRAINS * sweep_size());
    for (int k = 0; k < (sweep_size() < 1 ? 1 : SCENES); k++) {
        const struct scene *at = &scenes[k];
        domq_real slope, r;
        const domq_real s = touching(at, &slope);
        depth(at, s, &r);
        for (int i = 0; i < trains; i++) {
            struct dom_train train = dom_train_default();
            struct dom_limit limit;
            const double by = random_log(&seed, 1e-15, 1e-4) * (random_unit(&seed) < 0.5 ? -1 : 1);
            train.d = at->d;
            train.q = at->q;
            train.s = (double)s * (1 + by);
            /* rounded to a double, the separation may be on the other side */
            const bool stops = ((domq_real)train.s - s) * slope < 0;
            const enum dom_status status = dom_limit_rmax(&train, NULL, &limit);
            stop += stops;
            if ((status != DOM_OK || stops != (limit.r_max < (double)r * 1.015)) && ++wrong)
                print_error("s %.17g d %.17g q %.17g: %s, r_max %.15g, off by %.3g\n", train.s, train.d,
                            train.q, dom_status_text(status), limit.r_max, (double)(train.s - s));
        }
    }
    print_message("# %d trains stop in the dip\n", stop);
    assert_true(wrong == 0 && stop > 0);
}
