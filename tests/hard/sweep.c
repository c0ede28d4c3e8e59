/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "sweep.h"

#include "../unit/support.h"
#include "workers.h"

double sweep_size(void)
{
    const char *text = getenv("SWEEP_SIZE");
    char *end;
    if (!text || !*text)
        return 1;
    double size = strtod(text, &end);
    if (*end || !(size > 0 && size <= 1)) {
        fprintf(stderr, "SWEEP_SIZE is a number above 0, up to 1, such as 0.05\n");
        exit(2);
    }
    return size;
}

/* ---- One point ---- */

struct point {
    const struct sweep *sweep;
    uint64_t seed;
    struct ref_input input;
    struct ref *ref;
    struct tally *tally;
    struct setup train;
    bool sharp;
};

/* Returns how many bits of the reference's results must be correct. */
static int digits_of(const struct sweep *sweep)
{
    return sweep->precision == IN_QUAD ? 120 : sweep->precision == IN_DOUBLE ? 60 : 44;
}

static bool one_in(struct point *point, int n)
{
    return n > 0 && random_unit(&point->seed) * n < 1;
}

static struct comparison comparison_of(const struct point *point, enum ref_quantity quantity,
                                       const struct answers *answers)
{
    return (struct comparison){.ref = point->ref,
                               .input = &point->input,
                               .quantity = quantity,
                               .got = answers->value[quantity],
                               .tol = (double)point->train.tol,
                               .unit = library_unit(point->sweep->precision),
                               .sharp = point->sharp};
}

static void compare(struct point *point, enum ref_quantity quantity, const struct answers *answers)
{
    struct comparison c = comparison_of(point, quantity, answers);
    tally_compare(&point->tally[quantity], &c);
}

static void mistake(struct point *point, enum ref_quantity quantity, const struct answers *answers,
                    const char *what)
{
    struct comparison c = comparison_of(point, quantity, answers);
    tally_mistake(&point->tally[quantity], &c, what);
}

static void compare_all(struct point *point, enum ref_quantity first, enum ref_quantity last,
                        const struct answers *answers)
{
    for (enum ref_quantity k = first; k <= last; k++)
        compare(point, k, answers);
}

/*
 * Returns true if this quantity, a difference of terms of the given size, is 0 within rounding and tolerance,
 * so that either sign is right. The scale takes a long time to compute, so an upper bound of the scale is
 * tried first: a million times the size, times the number of dominoes.
 */
static bool vanishes(const struct point *point, enum ref_quantity quantity, double size)
{
    const double allowed = (double)point->train.tol + 16 * library_unit(point->sweep->precision);
    const double value = fabs(ref_double(point->ref, quantity));
    return value <= allowed * size * 1e6 * (double)point->ref->n &&
           value <= allowed * ref_scale_up_to(point->ref, quantity, value / allowed);
}

static enum ref_quantity fuel_of(const struct point *point)
{
    return point->input.paper ? REF_FUEL_PAPER : REF_FUEL_EXACT;
}

static bool fuel_vanishes(const struct point *point)
{
    return vanishes(point, fuel_of(point), 1);
}

static bool margin_vanishes(const struct point *point)
{
    return vanishes(point, REF_MARGIN,
                    ref_double(point->ref, REF_KINETIC) + ref_double(point->ref, REF_BARRIER));
}

static bool positive(const struct point *point, enum ref_quantity quantity)
{
    return ref_double(point->ref, quantity) > 0;
}

/* Compares lever arms. In the limit where a follower detaches, results with and without lever arms are both
 * right. */
static void compare_arms(struct point *point, enum ref_quantity a, struct answers *answers)
{
    const double own = ref_double(point->ref, a);
    if (isnan(own) != isnan((double)answers->value[a])) {
        double size = isnan(own) ? fabs((double)answers->value[a]) : fabs(own);
        if (size >
            100 * ((double)point->train.tol + library_unit(point->sweep->precision)) * (double)point->input.s)
            mistake(point, a, answers, isnan(own) ? "lever arms of a detached follower" : "no lever arms");
        return;
    }
    compare_all(point, a, a + 1, answers);
}

static void check_train(struct point *point, struct answers *answers)
{
    library_ask(&point->train, 0, REF_THETA_C, answers);
    /* In the limit of (41; A17), both formulas give the same theta_f. */
    if (answers->detaches != point->ref->detaches) {
        double rr = 1 / (double)(point->input.r * point->input.r);
        double room = (double)(point->input.s * (point->input.s + 2 * point->input.d));
        if (!(fabs(rr / room - 1) <= 32 * library_unit(point->sweep->precision)))
            mistake(point, REF_THETA_LEAVE, answers, "detaches");
        compare_all(point, REF_THETA_C, REF_THETA_F, answers);
    } else {
        compare_all(point, REF_THETA_C, REF_THETA_LEAVE, answers);
    }
    library_ask(&point->train, 0, REF_FUEL_EXACT, answers);
    compare_all(point, REF_FUEL_EXACT, REF_FUEL_PAPER, answers);
    library_ask(&point->train, 0, REF_LAUNCH_OMEGASQ, answers);
    enum dom_status status = answers->status[REF_LAUNCH_OMEGASQ];
    enum ref_quantity fuel = fuel_of(point);
    if (!fuel_vanishes(point)) {
        if (status != (positive(point, fuel) ? DOM_OK : DOM_NO_FUEL))
            mistake(point, REF_LAUNCH_OMEGASQ, answers, dom_status_text(status));
        else
            compare_all(point, REF_LAUNCH_OMEGASQ, REF_KINETIC, answers);
    }
}

/* Checks omega^2. DOM_STOPS is right only if the head stops before this tilt. */
static void check_omegasq(struct point *point, bool look_closer, struct answers *answers)
{
    library_ask(&point->train, point->input.tilt, REF_OMEGASQ, answers);
    enum dom_status status = answers->status[REF_OMEGASQ];
    if (fuel_vanishes(point))
        return;
    if (!positive(point, fuel_of(point))) {
        if (status != DOM_NO_FUEL)
            mistake(point, REF_OMEGASQ, answers, dom_status_text(status));
        return;
    }
    if (status == DOM_OK)
        compare(point, REF_OMEGASQ, answers);
    else if (status != DOM_STOPS)
        mistake(point, REF_OMEGASQ, answers, dom_status_text(status));
    else if (look_closer && positive(point, REF_OMEGASQ) && !vanishes(point, REF_OMEGASQ, 1) &&
             !margin_vanishes(point) && !(ref_double(point->ref, REF_STOP) < (double)point->input.tilt))
        mistake(point, REF_OMEGASQ, answers, "DOM_STOPS, but the train does not stop");
}

static void check_tilt(struct point *point, bool look_closer, struct answers *answers)
{
    library_ask(&point->train, point->input.tilt, REF_THETA_1, answers);
    compare_all(point, REF_THETA_1, REF_SLOPE, answers);
    compare_arms(point, REF_ARM_A, answers);
    library_ask(&point->train, point->input.tilt, REF_DH, answers);
    compare_all(point, REF_DH, REF_J0, answers);
    check_omegasq(point, look_closer, answers);
    /* Choose a random domino, or the last one if the train has fewer. */
    library_link(&point->train, point->input.tilt, (size_t)random_log(&point->seed, 1, 400), answers);
    if (point->ref->link != answers->link)
        ref_link(point->ref, answers->link);
    compare_all(point, REF_LINK_THETA, REF_LINK_SLOPE, answers);
    compare_arms(point, REF_LINK_ARM_A, answers);
    compare(point, REF_LINK_WEIGHT, answers);
}

/* Returns true if H is as high at theta as at theta_m, although the two tilts differ. Either of two equal
 * maxima is right. */
static bool as_high(struct point *point, domq_real theta)
{
    struct ref_input there = point->input;
    there.tilt = theta;
    struct ref *ref = ref_open(&there, point->ref->bits, point->ref->cut);
    double lower = ref_double(point->ref, REF_BARRIER) - ref_double(ref, REF_DH);
    double allowed = (double)point->train.tol + 16 * library_unit(point->sweep->precision);
    bool far = fabs((double)theta - ref_double(point->ref, REF_THETA_M)) > 1e-3 * (double)theta;
    ref_close(ref);
    return far && lower <= allowed * ref_scale(point->ref, REF_BARRIER);
}

static void check_barrier(struct point *point, struct answers *answers)
{
    library_ask(&point->train, 0, REF_BARRIER, answers);
    enum dom_status status = answers->status[REF_BARRIER];
    if (!as_high(point, answers->value[REF_THETA_M]))
        compare(point, REF_THETA_M, answers);
    compare(point, REF_BARRIER, answers);
    if (fuel_vanishes(point))
        return;
    if (positive(point, fuel_of(point)))
        compare(point, REF_MARGIN, answers);
    if (!positive(point, fuel_of(point)) ? status != DOM_NO_FUEL
        : margin_vanishes(point)         ? status != DOM_OK && status != DOM_STOPS
                                         : status != (positive(point, REF_MARGIN) ? DOM_OK : DOM_STOPS))
        mistake(point, REF_MARGIN, answers, dom_status_text(status));
}

static void check_stop(struct point *point, struct answers *answers)
{
    if (fuel_vanishes(point) || !positive(point, fuel_of(point)) || margin_vanishes(point))
        return;
    /* The kinetic energy and the tilt of the stop may be so small that more bits are needed. */
    struct ref *ref = point->ref;
    struct ref_input there = point->input;
    there.tilt = isnan((double)answers->value[REF_STOP]) ? 0 : answers->value[REF_STOP];
    point->ref = ref_open_for(&there, digits_of(point->sweep));
    if (answers->status[REF_STOP] != DOM_OK)
        mistake(point, REF_STOP, answers, dom_status_text(answers->status[REF_STOP]));
    else
        compare(point, REF_STOP, answers);
    ref_close(point->ref);
    point->ref = ref;
}

/* Checks the duration, which need not exist if the margin is 0 within rounding errors. */
static void check_duration(struct point *point, struct answers *answers)
{
    if (fuel_vanishes(point) || margin_vanishes(point) || !positive(point, REF_MARGIN))
        return;
    library_ask(&point->train, 0, REF_DURATION, answers);
    if (answers->status[REF_DURATION] == DOM_OK)
        compare(point, REF_DURATION, answers);
    else
        mistake(point, REF_DURATION, answers, dom_status_text(answers->status[REF_DURATION]));
}

/* ---- Limits of growth ---- */

static void check_growth(struct point *point, enum ref_quantity quantity, struct answers *answers)
{
    const bool pair = quantity == REF_PAIR;
    const int digits2 = digits_of(point->sweep);
    struct comparison c = comparison_of(point, quantity, answers);
    library_ask(&point->train, 0, quantity, answers);
    c.ref = NULL;
    c.got = answers->value[quantity];
    c.want = (double)c.got;
    c.scale = c.want;
    if (answers->status[quantity] != DOM_OK) {
        tally_mistake(&point->tally[quantity], &c, dom_status_text(answers->status[quantity]));
    } else if (answers->ends == DOM_END_NONE) {
        if (!pair && growth_margin(&point->input, false, digits2, 1) > 1e-6)
            tally_mistake(&point->tally[quantity], &c, "no growth, but equal dominoes keep falling");
    } else if (answers->ends == DOM_END_BARRIER) {
        const double delta = (double)c.got * library_unit(point->sweep->precision);
        c.error = growth_error(&point->input, pair, digits2, c.got, &c.scale);
        if (!(fabs(c.error) <= TALLY_UNITS * delta))
            c.error = growth_distance(&point->input, pair, digits2, c.got, delta);
        c.want -= c.error;
        tally_compare(&point->tally[quantity], &c);
    } else {
        domq_real reach = 1 / point->input.s;
        c.error = (double)(c.got - reach);
        c.want = (double)reach;
        tally_compare(&point->tally[quantity], &c);
        if (growth_margin(&point->input, pair, digits2, reach * (1 - (domq_real)1e-6)) < 0)
            tally_mistake(&point->tally[quantity], &c, "it stops before the reach");
    }
}

/* ---- All points ---- */

static bool asked(int asks, int what)
{
    return (asks & what) == what;
}

static void check_at_tolerance(struct point *point, int asks)
{
    struct answers answers;
    library_nothing(&answers);
    if (asked(asks, TILT)) {
        check_train(point, &answers);
        check_tilt(point, asked(asks, TOP), &answers);
    }
    if (asked(asks, TOP)) {
        check_barrier(point, &answers);
        check_stop(point, &answers);
    }
    if (asked(asks, TIME))
        check_duration(point, &answers);
    if (asked(asks, GROWTH))
        check_growth(point, REF_R_MAX, &answers);
    if (asked(asks, PAIR))
        check_growth(point, REF_PAIR, &answers);
}

/* Checks a growth at the reach. The rounded r = 1/s counts as the reach, and any larger r does not. */
static bool check_reach(struct point *point, const struct answers *answers)
{
    bool reaches = mpfr_sgn(point->ref->u) >= 0 ||
                   point->input.r == rounded_to(point->sweep->precision, 1 / point->input.s);
    enum dom_status status = answers->status[REF_THETA_C];
    if (status != (reaches ? DOM_OK : DOM_OUT_OF_REACH))
        mistake(point, REF_THETA_C, answers, dom_status_text(status));
    return reaches && status == DOM_OK;
}

static void check_point(struct point *point)
{
    const struct sweep *sweep = point->sweep;
    const double floor = (double)any_arithmetic(sweep->precision).tol_floor;
    struct answers answers;
    int asks = TILT;
    asks |= one_in(point, sweep->barriers) ? TOP : 0;
    asks |= one_in(point, sweep->durations) ? TIME : 0;
    if (one_in(point, sweep->growths) && point_can_grow(&point->input, false, sweep->precision))
        asks |= GROWTH;
    if (one_in(point, sweep->pairs) && point_can_grow(&point->input, true, sweep->precision))
        asks |= PAIR;
    library_nothing(&answers);
    point->train = library_train(&point->input, sweep->precision);
    library_ask(&point->train, 0, REF_THETA_C, &answers);
    if (answers.status[REF_THETA_C] == DOM_OK)
        point->input.tilt = point_tilt(&point->seed, answers.value[REF_THETA_C], sweep->precision);
    point->ref = ref_open_for(&point->input, digits_of(sweep));
    if (check_reach(point, &answers)) {
        point->sharp = true;
        check_at_tolerance(point, asks);
        point->sharp = false;
        point->train.tol = (domq_real)random_log(&point->seed, floor * 1.0001, fmax(1e-3, 10 * floor));
        check_at_tolerance(point, asks);
    }
    ref_close(point->ref);
}

void sweep_check(const struct ref_input *input, enum precision precision, int asks,
                 struct tally tally[REF_COUNT])
{
    const struct sweep sweep = {.precision = precision};
    struct point point = {.sweep = &sweep,
                          .input = *input,
                          .tally = tally,
                          .train = library_train(input, precision),
                          .sharp = true};
    point.ref = ref_open_for(input, digits_of(&sweep));
    check_at_tolerance(&point, asks);
    ref_close(point.ref);
}

struct share {
    const struct sweep *sweep;
    struct tally (*tally)[REF_COUNT]; /* one for each job */
    int jobs;
};

/* Runs a part of the sweep. Every point has its own seed, so that the points do not depend on the workers. */
static long sweep_part(int job, void *context)
{
    const struct share *share = context;
    const struct sweep *sweep = share->sweep;
    long points = 0;
    for (int k = job; k < sweep->points; k += share->jobs, points++) {
        struct point point = {
            .sweep = sweep, .seed = sweep->seed + (uint64_t)k * 1000003U, .tally = share->tally[job]};
        point.input = point_random(&point.seed, sweep->precision);
        check_point(&point);
    }
    return points;
}

long sweep_run(const struct sweep *sweep, struct tally tally[REF_COUNT])
{
    struct share share = {.sweep = sweep, .jobs = 40};
    const size_t size = (size_t)share.jobs * sizeof *share.tally;
    share.tally = workers_share(size);
    long points = workers_run(share.jobs, sweep_part, &share);
    memset(tally, 0, REF_COUNT * sizeof *tally);
    for (int k = 0; k < share.jobs; k++)
        for (int q = 0; q < REF_COUNT; q++)
            tally_merge(&tally[q], &share.tally[k][q]);
    workers_unshare(share.tally, size);
    return points;
}
