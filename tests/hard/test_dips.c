/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * r_max of trains whose margin has a dip of a given depth, on both sides of zero. The margins at single
 * growths are those of the library, which test_sweep and other tests compare with sums in many bits, with
 * Newton's law and with tables: here only the searches are tested.
 */
#include "../unit/support.h"
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

static bool is_sharp(const struct scene *at)
{
    return at->mu == 0 && at->rho == 0;
}

static struct setup train_of(const struct scene *at, domq_real s, enum precision precision)
{
    struct setup train = setup_default();
    train.s = s;
    train.d = at->d;
    train.q = at->q;
    train.rho = at->rho;
    train.mu = at->mu;
    train.precision = precision;
    train.tol = any_arithmetic(precision).tol_default;
    return train;
}

typedef domq_real curve(domq_real x, const void *context);

/* Returns the minimum of a function between lo and hi, by golden section to a relative width, and where it
 * is. */
static domq_real lowest(curve *f, const void *context, domq_real lo, domq_real hi, double width,
                        domq_real *at)
{
    const domq_real part = (domq_real)0.6180339887498948482L;
    domq_real a = hi - part * (hi - lo), b = lo + part * (hi - lo), at_a = f(a, context),
              at_b = f(b, context);
    while (hi - lo > (domq_real)width * hi) {
        const bool left = at_a < at_b;
        *(left ? &hi : &lo) = left ? b : a;
        *(left ? &b : &a) = left ? a : b;
        *(left ? &at_b : &at_a) = left ? at_a : at_b;
        *(left ? &a : &b) = left ? hi - part * (hi - lo) : lo + part * (hi - lo);
        *(left ? &at_a : &at_b) = f(left ? a : b, context);
    }
    *at = at_a < at_b ? a : b;
    return at_a < at_b ? at_a : at_b;
}

/* Returns (K - B) / K of a train at another growth, or -1 if it cannot start. */
static domq_real share_at_growth(domq_real r, const void *context)
{
    struct domq_barrier barrier;
    struct setup train = *(const struct setup *)context;
    train.r = r;
    const enum dom_status status = ask_barrier_find(&train, &barrier);
    return status == DOM_OK || status == DOM_STOPS ? barrier.margin / barrier.kinetic : -1;
}

/* Returns the train whose margins tell how deep a dip is. */
static struct setup fine_train(const struct scene *at, domq_real s)
{
    struct setup train = train_of(at, s, IN_QUAD);
    train.tol = is_sharp(at) ? any_arithmetic(IN_QUAD).tol_floor : (domq_real)1e-22;
    return train;
}

/* Returns the depth of the dip: the minimum of (K - B) / K near at->r. */
static domq_real depth(const struct scene *at, domq_real s, domq_real *r)
{
    const struct setup train = fine_train(at, s);
    return lowest(share_at_growth, &train, (domq_real)at->r * 0.985, (domq_real)at->r * 1.015,
                  is_sharp(at) ? 1e-16 : 1e-11, r);
}

/* Returns the first root, which is below the minimum at r. */
static domq_real root_before(const struct scene *at, domq_real s, domq_real r)
{
    const struct setup train = fine_train(at, s);
    domq_real lo = (domq_real)at->r * 0.985, hi = r;
    for (int k = 0; k < 110 && hi - lo > 0; k++) {
        const domq_real middle = (lo + hi) / 2;
        *(share_at_growth(middle, &train) >= 0 ? &lo : &hi) = middle;
    }
    return lo;
}

struct dips {
    int trains, open, wrong;
};

static void check(const struct scene *at, domq_real s, enum precision precision, struct dips *tally)
{
    const struct setup train = train_of(at, s, precision);
    struct domq_limit limit;
    domq_real r;
    const domq_real deep = depth(at, s, &r);
    const enum dom_status status = ask_limit_rmax(&train, &limit);
    const double least = precision == IN_QUAD && at->mu == 0 ? 1e-31 : 1e-16;
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
        const double own = (double)root * 1e-15 +
                           (is_sharp(at) ? 1e-31 / (at->d * at->d) : 1e-16) * (double)((r - root) / -deep);
        wrong = !(fabs((double)off) <= (double)limit.uncertainty + own) ||
                !(limit.uncertainty < 1e-5 * (double)root);
        if (wrong)
            print_error("root %.20Lg ", (long double)root);
    } else {
        wrong = !(limit.r_max > r * (domq_real)1.015);
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
        const bool sharp = is_sharp(at);
        domq_real slope, s = touching(at, &slope);
        for (int k = 6; k <= (sharp ? 28 : 15); k += step)
            for (int side = -1; side <= 1; side += 2) {
                const domq_real there = s + (domq_real)(side * pow(10, -k)) / slope;
                if (k <= 15)
                    check(at, (double)there, IN_DOUBLE, &tally);
                check(at, there, IN_QUAD, &tally);
            }
    }
    print_message("# %d dips, %d of them open\n", tally.trains, tally.open);
    assert_int_equal(tally.wrong, 0);
}

/* Just below the reach, the margin of thin dominoes dips and rises again between two samples of the search.
 * Each r is the growth of such a dip, at which the train stops. */
TEST(a_dip_close_to_the_reach_is_seen)
{
    static const struct scene close[] = {
        {0.00058319685379602413, 1.496225472401489, 0, 0, 0.006426525, 155.2},
        {0.00076321139066404589, 1.4934010668498015, 0, 0, 0.0075800289993315315, 131.474397838},
        {0.00051698020712347375, 1.3747552345991327, 0, 0, 0.0038322329287496502, 260.13385428},
        {0.00010074699714384886, 1.8741295298117646, 0, 0, 0.0069475911580184858, 143.733965511},
        {0.00013673941252387379, 1.5419841257526361, 0, 0, 0.0029746117817103547, 335.711511936},
    };
    for (size_t i = 0; i < sizeof close / sizeof *close; i++) {
        const struct setup fine = fine_train(&close[i], close[i].s);
        assert_true(share_at_growth(close[i].r, &fine) < 0);
        for (enum precision precision = IN_DOUBLE; precision <= IN_QUAD; precision++) {
            const struct setup train = train_of(&close[i], close[i].s, precision);
            struct domq_limit limit;
            assert_int_equal(ask_limit_rmax(&train, &limit), DOM_OK);
            assert_true(limit.r_max < close[i].r);
            assert_true(share_at_growth(limit.r_max * (1 - (domq_real)1e-9), &fine) > 0);
            assert_true(share_at_growth(limit.r_max * (1 + (domq_real)1e-9), &fine) < 0);
        }
    }
}

/* ---- The best separation ---- */

/*
 * Returns the smallest margin at growths up to train->r, dips included, or a negative margin at one of them.
 * The growths differ by 4 %; near the reach they are evenly spaced in sqrt(1 - r s), because the margin
 * changes rapidly there.
 */
static double spare(const struct setup *train)
{
    enum { NEAR = 60, MOST = 400 };
    const double s = (double)train->s, R = (double)train->r, from = fmin(R, 0.6 / s),
                 x = sqrt(fmax(1 - from * s, 0)), x_R = sqrt(fmax(1 - R * s, 0));
    double r[MOST], f[MOST], least = R * s < 1 ? (double)share_at_growth(R, train) : -1;
    int n = 1;
    domq_real at;
    r[0] = 1;
    for (double next = 1.04; next < from && n < MOST - NEAR - 1; next *= 1.04)
        r[n++] = next;
    for (int k = 0; k < NEAR; k++) {
        const double u = x + (x_R - x) * k / NEAR;
        if ((1 - u * u) / s > 1)
            r[n++] = (1 - u * u) / s;
    }
    r[n++] = R;
    for (int k = 0; k < n && least > 0; k++) {
        f[k] = (double)share_at_growth(r[k], train);
        least = fmin(least, f[k]);
        if (k > 1 && f[k - 1] < f[k - 2] && f[k - 1] <= f[k])
            least = fmin(least, (double)lowest(share_at_growth, train, r[k - 2], r[k], 1e-6, &at));
    }
    return least;
}

static domq_real lack_at_separation(domq_real s, const void *context)
{
    struct setup train = *(const struct setup *)context;
    train.s = s;
    return -(domq_real)spare(&train);
}

/* Returns the largest spare of all separations: samples, and golden sections around the three largest. */
static double most_spare(const struct setup *train, double *where)
{
    enum { SAMPLES = 1000, TOPS = 3 };
    static double at[SAMPLES];
    const double ratio = 0.99;
    double most = -1;
    for (int k = 0; k < SAMPLES; k++)
        at[k] = -(double)lack_at_separation(pow(ratio, k), train);
    for (int pass = 0; pass < TOPS; pass++) {
        int top = 0;
        for (int k = 1; k < SAMPLES; k++)
            if (at[k] > at[top] && at[k] >= at[k - 1] && (k + 1 == SAMPLES || at[k] >= at[k + 1]))
                top = k;
        domq_real s;
        const double lack = (double)lowest(lack_at_separation, train, pow(ratio, top + 1),
                                           fmin(pow(ratio, top - 1), 1), 1e-8, &s);
        if (-lack > most) {
            most = -lack;
            *where = (double)s;
        }
        at[top] = -1;
    }
    return most;
}

/*
 * Checks that no separation allows a growth that is larger by 1e-8, and that the best train goes on. For thin
 * dominoes the growths differ by more, because sums in double are less certain: by 1e-6 at d = 1e-3.
 */
TEST(no_separation_is_better)
{
    uint64_t seed = 53;
    int found = 0, wrong = 0;
    const int pairs = (int)ceil(150 * sweep_size());
    for (int i = 0; i < pairs; i++) {
        struct setup train = setup_default();
        struct domq_best best = {.s = 0};
        train.d = random_log(&seed, 1e-3, 0.6);
        train.q = random_log(&seed, 0.3, 6);
        const enum dom_status status = ask_limit_best(&train, &best);
        const double by = 1e-8 + 1e-12 / pow((double)train.d, 2);
        double where = 0;
        train.r = (status == DOM_OK ? best.r_max : 1) * (1 + by);
        const double more = most_spare(&train, &where);
        bool bad = (status != DOM_OK && status != DOM_NO_GROWTH) || more > 0;
        found += status == DOM_OK;
        train.r = best.r_max * (1 - by);
        if (status == DOM_OK)
            bad = bad || lack_at_separation(best.s, &train) > by;
        if (bad && ++wrong)
            print_error("d %.17g q %.17g: %s, s %.15g r %.15g +- %.2g; better by %.3g near s %.15g\n",
                        (double)train.d, (double)train.q, dom_status_text(status), (double)best.s,
                        (double)best.r_max, (double)best.r_uncertainty, more, where);
    }
    print_message("# %d of %d have a best separation, %d wrong\n", found, pairs, wrong);
    assert_true(wrong == 0 && found * 3 > pairs);
}
