/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finite rows of any dominoes, compared with Newton's equations (direct.c), with the endless train, and by
 * the balance of energy. */
#include "run.h"
#include "support.h"
#include <float.h>

enum { MOST = ROW_MOST };

static const double g = 9.81;

/* ---- Against Newton's equations ---- */

enum { PLAIN, SLOPE_OR_WALLS, AIR, LEANS, RELEASED, EFFECTS };

/* Puts some rows on a slope and turns the dominoes of some rows into boxes. */
static void slope_or_walls(struct run *run, uint64_t *seed, int i)
{
    domq_real thinnest = run->domino[0].thickness;
    for (size_t k = 1; k < run->row.count; k++)
        thinnest = fmin((double)thinnest, (double)run->domino[k].thickness);
    if (i % 5 == 0)
        run->row.alpha = 0.05 * (2 * random_unit(seed) - 1);
    if (i % 3 == 0)
        run->row.walls = thinnest * (domq_real)(0.45 * random_unit(seed));
    for (size_t k = 0; i % 9 == 0 && k < run->row.count; k++)
        run->domino[k].width = run->domino[k].thickness * (1 + 3 * (domq_real)random_unit(seed));
    if (i % 6 == 0) /* small dominoes are solid */
        run->row.boxes_above = run->domino[run->row.count / 2].height;
}

/* Lets the first domino of a row begin at a tilt, if there is one between tipping over and the next domino.
 */
static void release(struct run *run, uint64_t *seed)
{
    const double gap = (double)(run->domino[1].gap / run->domino->height),
                 least = tips_at(run->domino) - (double)run->row.alpha, most = asin(fmin(gap, 1));
    if (run->row.count < 2 || most < least + 0.01)
        return;
    run->row.release = least + (most - least) * (0.01 + 0.98 * random_unit(seed));
    run->row.push = random_unit(seed) < 0.2 ? 3 * random_unit(seed) : 0;
}

static void effect_add(struct run *run, uint64_t *seed, int effect, int i)
{
    const double part = i % 3 == 0 ? 0.02 : i % 3 == 1 ? 0.4 : 0.9; /* of the largest possible lean */
    if (effect == SLOPE_OR_WALLS || (effect > SLOPE_OR_WALLS && i % 4 == 0))
        slope_or_walls(run, seed, i);
    if (effect == AIR || (effect == RELEASED && i % 7 == 0)) {
        run->row.air = random_log(seed, 0.1, 20);
        run->row.drag = i % 4 ? 0 : random_log(seed, 0.1, 10);
    }
    for (size_t k = 0; effect == AIR && k < run->row.count; k++) {
        run->domino[k].mass *= random_log(seed, 0.02, 2);
        run->domino[k].width = i % 2 ? run->domino[k].height * (domq_real)(0.2 + random_unit(seed)) : 0;
    }
    for (size_t k = 0; effect == LEANS && k < run->row.count; k++)
        run->domino[k].lean =
            (part * tips_at(&run->domino[k]) - fabs((double)run->row.alpha)) * (2 * random_unit(seed) - 1);
    if (effect == RELEASED)
        release(run, seed);
}

/* Checks that the weakest domino has the smallest margin / barrier, and that the verdict is exactly the same
 * without times. */
static void verdict_check(const struct run *run)
{
    const struct domq_verdict *whole = &run->verdict;
    struct domq_verdict v;
    domq_real least = INFINITY;
    size_t weakest = 0;
    for (size_t k = 0; k < run->falls; k++) {
        const struct domq_fall *f = &run->fall[k];
        domq_real spare = f->barrier > 0 ? f->margin / f->barrier : (domq_real)INFINITY;
        if (f->margin >= 0 && (weakest == 0 || spare < least)) {
            least = spare;
            weakest = k + 1;
        }
    }
    assert_int_equal(whole->weakest, weakest);
    assert_true((double)whole->spare == (double)least);
    assert_status(ask_row_run(&run->row, false, NULL, NULL, &v), DOM_OK);
    assert_true(v.end == whole->end && v.domino == whole->domino && v.short_by == whole->short_by &&
                v.weakest == weakest && v.spare == whole->spare && isnan((double)v.seconds));
}

TEST(newton_agrees)
{
    static struct run run;
    static struct newton n;
    uint64_t seed = 61;
    int met[EFFECTS][DOM_ROW_BACK + 1] = {{0}}, dropped = 0, near = 0;
    for (int i = 0; i < 100 * EFFECTS; i++) {
        const int effect = i % EFFECTS;
        row_of_kind(&run, &seed, i % 4);
        effect_add(&run, &seed, effect, i / EFFECTS);
        assert_status(run_whole(&run), DOM_OK);
        newton_run(&run, &n);
        const struct domq_verdict *v = &run.verdict;
        met[effect][v->end]++;
        if (effect != RELEASED)
            verdict_check(&run);
        assert_int_equal(v->domino, run.falls);
        for (size_t k = 1; k < run.falls; k++)
            dropped += run.fall[k].moving <= run.fall[k - 1].moving;
        if (!run_is_clear(&run) || v->end == DOM_ROW_SKEWED) {
            near++;
            continue;
        }
        newton_compare(&run, &n);
        const struct domq_fall *f = &run.fall[run.falls - 1];
        assert_true(v->short_by == (v->end == DOM_ROW_STOPS ? -f->margin : 0));
        assert_int_equal(isnan((double)f->duration) && v->short_by > 0, v->end == DOM_ROW_STOPS);
    }
    for (int effect = 0; effect < EFFECTS; effect++) {
        print_message("# effect %d: %d fall, %d stop, %d miss, %d pass, %d part, %d lock\n", effect,
                      met[effect][DOM_ROW_FALLS], met[effect][DOM_ROW_STOPS], met[effect][DOM_ROW_MISSES],
                      met[effect][DOM_ROW_PASSES], met[effect][DOM_ROW_PARTS], met[effect][DOM_ROW_LOCKS]);
        assert_true(met[effect][DOM_ROW_FALLS] > 15 && met[effect][DOM_ROW_STOPS] > 15);
    }
    print_message("# %d near, %d drops\n", near, dropped);
    assert_true(dropped > 5 && near < 50);
}

/* Checks contacts that open: because masses differ much, a head moves ahead of its followers, or comes to
 * rest before them. */
TEST(contacts_open)
{
    static struct run run;
    static struct newton n;
    uint64_t seed = 67;
    int parted[2] = {0, 0};
    for (int i = 0; i < 6000; i++) {
        make_row(&run, 3 + (size_t)(i % 2), 0.3, 1, 0);
        for (size_t k = 0; k < run.row.count; k++) {
            struct domq_domino *d = &run.domino[k];
            d->height *= 0.95 + 0.1 * random_unit(&seed);
            d->thickness *= 0.4 + 1.2 * random_unit(&seed);
            d->gap *= 0.2 + 2 * random_unit(&seed);
            d->mass *= random_log(&seed, 0.1, 10);
        }
        run.row.push = random_log(&seed, 2, 60);
        assert_status(run_whole(&run), DOM_OK);
        if (run.verdict.end != DOM_ROW_PARTS)
            continue;
        newton_run(&run, &n);
        const bool slow = run.fall[run.falls - 1].margin < 0;
        assert_true(n.least_force < 0 && (slow || n.least_head == run.falls));
        parted[slow]++;
    }
    print_message("# %d rows part, %d of which would stop\n", parted[0] + parted[1], parted[1]);
    assert_true(parted[0] > 8 && parted[1] > 8);
}

/* ---- Against the endless train ---- */

/*
 * Checks that the motion of domino k, in units of domino k, converges to a cycle of the train. From one
 * domino to the next, an error of omega^2 is multiplied by (J(0) - 1) / (J(0) r^q) (22; c4), and the effect
 * of the missing part of the train by r^-q theta_1'(theta_inf). The larger of these factors is the rate of
 * convergence; friction makes it smaller. After 50 dominoes the error is the 50th power of the rate, or 1e-11
 * because of the tolerance of margins.
 */
TEST(uniform_rows_become_the_train)
{
    static const struct {
        double s, r, q, mu, rho, air;
        bool radii; /* each domino has its radius */
    } some[] = {
        {0.4, 1.5, 4, 0, 0, 0, false},
        {0.3, 1, 3, 0, 0, 0, false},
        {0.2, 1.2, 3, 0, 0, 0, false},
        {0.6, 1.5, 4, 0, 0, 0, false},
        {0.4, 1.5, 4, 0.1, 0, 0, false},
        {0.3, 1, 3, 0.3, 0, 0, false},
        /* the top is beyond the tilt at which the follower detaches */
        {0.54, 1.85, 3, 0, 0, 0, false},
        /* solid dominoes in air */
        {0.4, 1.5, 4, 0, 0, 5, false},
        {0.3, 1.3, 4, 0, 0, 40, false},
        {0.6, 1.5, 4, 0, 0, 40, false},
        {0.4, 1.4, 4, 0, 0.02, 40, false},
        {0.4, 1.15, 3, 0, 0.02, 0, true},
        {0.4, 1.15, 3, 0.15, 0.02, 0, false},
    };
    for (size_t i = 0; i < sizeof some / sizeof *some; i++) {
        static struct run run;
        struct setup train = setup_default();
        struct domq_scale scale = domq_scale_default();
        struct domq_launch launch;
        struct domq_barrier barrier;
        domq_real duration;
        train.s = some[i].s;
        train.r = some[i].r;
        train.q = some[i].q;
        make_row(&run, MOST, some[i].s, some[i].r, some[i].mu);
        ask_row_of_train(&train, &scale, 0.01, run.domino, MOST);
        const struct domq_domino *first = run.domino;
        train.mu = some[i].mu;
        train.rho = some[i].rho;
        train.air = some[i].air * first->height * first->thickness * first->width / first->mass;
        run.row.air = some[i].air;
        run.row.rho = some[i].radii ? 0.001 : some[i].rho;
        for (size_t k = 0; some[i].radii && k < MOST; k++)
            run.domino[k].radius = train.rho * run.domino[k].height;
        assert_status(ask_launch_find(&train, &launch), DOM_OK);
        assert_status(ask_barrier_find(&train, &barrier), DOM_OK);
        assert_status(ask_cycle_duration(&train, &duration), DOM_OK);
        run.row.push = 5 * push_over(run.domino);
        assert_status(run_whole(&run), DOM_OK);
        assert_string_equal(dom_row_end_text(run.verdict.end), dom_row_end_text(DOM_ROW_FALLS));
        const struct domq_train t = setup_train(&train);
        const bool plain = train.rho == 0 && train.air == 0;
        double s = train.s, d = train.d, r = train.r, x_inf = sqrt(s * (s + 2 * d)),
               before = (double)INFINITY;
        double rate = pow(r, -(double)train.q) * fmax((double)(1 - 1 / launch.J0), fmax(0, 1 - r * x_inf));
        for (size_t k = 10; k + 1 < MOST; k++) {
            const struct domq_fall *f = &run.fall[k];
            const struct domq_domino *own = &run.domino[k];
            double unit = (double)(own->mass * own->height) * g / 2;
            scale.h = own->height;
            double tau = domq_scale_tau(&scale, &t);
            double off = fabs((double)f->kinetic / unit / (double)launch.kinetic - 1);
            if (plain && isfinite(before) && off > 1e-12 && !(off < 1.1 * rate * before))
                fail_msg("train %zu, domino %zu: off by %g, before by %g, rate %g", i, k + 1, off, before,
                         rate);
            before = off;
            if (k < MOST - 4)
                continue;
            double bound = plain ? 1e-11 + 10 * pow(rate, 50) : 1e-9;
            assert_near("omega", (double)f->omega * tau, sqrt((double)launch.omegasq), bound);
            assert_near("kinetic", (double)f->kinetic / unit, launch.kinetic, bound);
            assert_near("margin", (double)f->margin / unit, barrier.margin, 10 * bound);
            assert_near("duration", (double)f->duration / tau, duration, 10 * bound);
        }
    }
}

/* ---- Verdicts ---- */

static void check_end(struct run *run, enum dom_row_end end, size_t domino)
{
    assert_status(run_whole(run), DOM_OK);
    assert_string_equal(dom_row_end_text(run->verdict.end), dom_row_end_text(end));
    assert_int_equal(run->verdict.domino, domino);
    assert_int_equal(run->falls, domino);
    assert_true((run->verdict.short_by > 0) == (end == DOM_ROW_STOPS));
}

TEST(ends)
{
    static struct run run;
    make_row(&run, 5, 0.4, 1, 0);
    check_end(&run, DOM_ROW_FALLS, 5);
    run.domino[3].gap = run.domino[2].height * (1 + 1e-9);
    check_end(&run, DOM_ROW_MISSES, 3);
    make_row(&run, 5, 0.4, 1, 0);
    run.domino[3].height *= sqrt(1 - 0.16) * (1 - 1e-9); /* the tip arrives at the height h cos theta_c */
    check_end(&run, DOM_ROW_PASSES, 3);
    make_row(&run, 5, 0.4, 1, 0);
    run.domino[3].height *= sqrt(1 - 0.16) * (1 + 1e-9);
    assert_status(run_whole(&run), DOM_OK);
    assert_true(run.verdict.domino > 3);
    make_row(&run, 5, 0.4, 2, 0);
    run.row.push = 1.01 * push_over(run.domino);
    check_end(&run, DOM_ROW_STOPS, 2);
    /* DOM_ROW_LEANS: a domino touches the next before it tips over if sin theta_c <= sin theta_u = d / sqrt(1
     * + d^2). */
    double d = 7.0 / 48, touches = d / hypot(1, d);
    for (int side = -1; side <= 1; side += 2) {
        make_row(&run, 2, touches * (1 + side * 1e-9), 1, 0);
        run.row.push = DOMQ_NAN;
        assert_status(run_whole(&run), DOM_OK);
        assert_int_equal(run.verdict.end, side < 0 ? DOM_ROW_LEANS : DOM_ROW_STOPS);
    }
    /* When the domino falls from its edge, the centre comes down by this height. */
    make_row(&run, 2, 0.4, 1, 0);
    run.row.push = DOMQ_NAN;
    assert_status(run_whole(&run), DOM_OK);
    double falls = (hypot(1, d) - sqrt(1 - 0.16) - d * 0.4) * (double)run.domino[0].height / 2;
    assert_near("of the tip", run.fall[1].kinetic + run.fall[1].lost, (double)run.domino[0].mass * g * falls,
                1e-13);
    /* The row locks if mu d is more than the height of the collision, h cos theta_c. */
    for (int side = -1; side <= 1; side += 2) {
        make_row(&run, 3, 0.4, 1, sqrt(1 - 0.16) / d * (1 + side * 1e-6));
        run.row.push = 30 * push_over(run.domino);
        assert_status(run_whole(&run), DOM_OK);
        assert_int_equal(run.verdict.end == DOM_ROW_LOCKS, side > 0);
        assert_int_equal(run.verdict.domino, side > 0 ? 1 : 2);
    }
    make_row(&run, 1, 0.4, 1, 0);
    check_end(&run, DOM_ROW_FALLS, 1);
    assert_true(run.verdict.weakest == 1 && run.verdict.seconds == run.fall[0].duration);
    run.row.push = DOMQ_NAN;
    check_end(&run, DOM_ROW_FALLS, 1);
}

static bool twice(const struct domq_fall *fall, void *context)
{
    (void)fall;
    return ++*(int *)context < 2;
}

TEST(visits_end_early)
{
    static struct run run;
    int visits = 0;
    make_row(&run, 20, 0.4, 1, 0);
    run.row.domino = run.domino;
    assert_status(ask_row_run(&run.row, true, twice, &visits, &run.verdict), DOM_OK);
    assert_int_equal(visits, 2);
    assert_true(run.verdict.domino == 2 && run.verdict.end == DOM_ROW_FALLS);
    assert_status(ask_row_run(&run.row, true, NULL, NULL, &run.verdict), DOM_OK);
    assert_int_equal(run.verdict.domino, 20);
}

static bool is_finite(const struct domq_fall *f, void *context)
{
    double sum = 1 / ((double)f->omega + 1) + (double)f->theta + (double)f->theta_m;
    *(bool *)context &= isfinite(sum) && !isnan((double)(f->kinetic + f->margin + f->barrier + f->lost));
    return true;
}

/* Checks rows of any size. The result agrees with quad and has no NaN, or is an error. */
static void sizes(enum precision precision, double s, double r, double h, double mass, size_t count,
                  bool answered)
{
    struct domq_domino *domino = calloc(count, sizeof *domino);
    struct setup train = setup_default();
    struct domq_scale scale = domq_scale_default();
    struct domq_verdict v, wide;
    bool fine = true;
    assert_non_null(domino);
    train.s = s;
    train.r = r;
    scale.h = h;
    ask_row_of_train(&train, &scale, mass, domino, count);
    struct row_setup row = {.domino = domino, .count = count, .g = g, .tol = 1e-5, .precision = precision};
    row.push = 3 * sqrt(3 * g * (hypot(1, 7.0 / 48) - 1) / (1 + pow(7.0 / 48, 2)) / h);
    enum dom_status status = ask_row_run(&row, true, is_finite, &fine, &v);
    row.precision = IN_QUAD;
    enum dom_status of_wide = ask_row_run(&row, true, NULL, NULL, &wide);
    free(domino);
    if (answered || status == DOM_OK) {
        assert_status(status, DOM_OK);
        assert_status(of_wide, DOM_OK);
        assert_true(fine);
        assert_string_equal(dom_row_end_text(v.end), dom_row_end_text(wide.end));
        assert_int_equal(v.domino, wide.domino);
    }
}

/* Checks long rows, tall ones, and rows in which m h^2 or h^2 is beyond the range of the precision. */
TEST(rows_of_any_size)
{
    sizes(IN_DOUBLE, 0.3, 1, 0.048, 0.01, 10000, true);
    sizes(IN_DOUBLE, 0.3, 2, 0.048, 0.01, 100, true);
    sizes(IN_DOUBLE, 0.4, 1.5, 0.048, 0.01, 100, true); /* the last domino is taller than the Earth */
    sizes(IN_DOUBLE, 5e-4, 1e3, 0.048, 0.01, 2000, false);
    sizes(IN_FLOAT, 0.4, 1.5, 0.048, 0.01, 40, true);
    sizes(IN_FLOAT, 0.4, 1.5, 0.048, 0.01, 52, false); /* the last domino is only 45000 km tall */
    sizes(IN_DOUBLE, 0.3, 1, 1e160, 1, 20, false);
    sizes(IN_DOUBLE, 0.3, 1, 1e-170, 1, 20, false);
    sizes(IN_DOUBLE, 0.3, 1, 1e100, 1e300, 20, false);
    sizes(IN_DOUBLE, 0.3, 1, 1e-100, 1e-250, 20, false);
}

/* Checks that a domino of almost no weight does not end a sum, since the dominoes after it are heavy. */
TEST(light_dominoes_end_no_sum)
{
    static struct run rough, fine;
    uint64_t seed = 65;
    int checked = 0;
    for (int i = 0; i < 200; i++) {
        row_of_kind(&rough, &seed, 0);
        if (rough.row.count < 4)
            continue;
        for (size_t k = 1; k + 1 < rough.row.count; k += 3)
            rough.domino[k].mass *= 1e-9;
        fine = rough;
        rough.row.tol = 1e-6;
        assert_status(run_whole(&rough), DOM_OK);
        assert_status(run_whole(&fine), DOM_OK);
        for (size_t k = 0; k < rough.falls && k < fine.falls; k++) {
            const struct domq_fall *a = &rough.fall[k], *b = &fine.fall[k];
            if (!(fabs((double)b->margin) > 1e-2 * (double)b->kinetic))
                break;
            assert_near("kinetic", a->kinetic, b->kinetic, 1e-3);
            assert_near("barrier", a->barrier, b->barrier, 1e-3);
            checked += k > 2;
        }
    }
    assert_true(checked > 200);
}

/* Checks that the precisions agree. The allowed difference of a domino is inversely proportional to the
 * smallest margin before it, since a small margin amplifies errors. */
TEST(precisions_agree)
{
    static struct run run[3];
    uint64_t seed = 64;
    for (int i = 0; i < 12; i++) {
        row_of_kind(&run[0], &seed, i % 4);
        run[0].row.count = run[0].row.count < 8 ? run[0].row.count : 8;
        for (size_t k = 0; k < run[0].row.count; k++) { /* numbers that a float represents exactly */
            struct domq_domino *d = &run[0].domino[k];
            *d = (struct domq_domino){
                (float)d->height, (float)d->thickness, (float)d->gap, (float)d->mass, 0, 0, 0};
        }
        run[0].row.push = (float)run[0].row.push;
        run[0].row.mu = (float)run[0].row.mu;
        run[0].row.g = 9.8125;
        run[0].row.air = i % 3 == 0 ? 5 : 0;
        run[0].row.rho = i % 4 == 0 ? 0x1p-6 : 0;
        for (int p = IN_QUAD; p >= IN_FLOAT; p--) {
            run[p] = run[0];
            run[p].row.precision = (enum precision)p;
            run[p].row.tol = p == IN_QUAD ? 1e-16 : (double)any_arithmetic(run[p].row.precision).tol_default;
            assert_status(run_whole(&run[p]), DOM_OK);
            assert_int_equal(run[p].verdict.end, run[IN_QUAD].verdict.end);
            assert_int_equal(run[p].verdict.domino, run[IN_QUAD].verdict.domino);
            double bound = p == IN_FLOAT ? 1e-4 : 1e-11, spare = 1;
            for (size_t k = 0; k < run[p].falls; k++) {
                const struct domq_fall *f = &run[p].fall[k], *wide = &run[IN_QUAD].fall[k];
                assert_near("kinetic", f->kinetic, wide->kinetic, bound / spare);
                assert_near("omega", f->omega, wide->omega, bound / spare);
                assert_near("theta", f->theta, wide->theta, bound / spare);
                spare = fmin(spare, fabs((double)(wide->margin / wide->kinetic)));
                if (!isnan((double)wide->duration))
                    assert_near("duration", f->duration, wide->duration, bound / spare);
            }
        }
    }
}
