/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "../unit/direct.h"
#include "bench.h"
#include <stdlib.h>
#include <string.h>

enum { QUESTIONS_MAX = 256, DOMINOES_MAX = 64, ROUNDS = 9 };

#define SECONDS_EACH 1.5 /* seconds that one contender may take for a table */
#define PATIENCE     0.3 /* seconds that the repetitions of one question may take */

static const char *const contender_name[CONTENDERS] = {
    [OURS] = "ours",   [GSL] = "GSL, nested", [PAPER] = "paper's recipe", [NEWTON] = "GSL, Newton's laws",
    [SCIPY] = "SciPy",
};

static struct coprocess scipy; /* its pid is 0 if SciPy is not installed */

/* ---- One answer ---- */

static double ask_row(const struct question *q, double tol, enum precision precision, struct dom_work *work)
{
    struct domq_domino domino[DOMINOES_MAX];
    struct domq_scale scale = domq_scale_default();
    struct domq_verdict verdict;
    ask_row_of_train(&q->train, &scale, 1, domino, q->dominoes);
    struct row_setup row = {.domino = domino,
                            .count = q->dominoes,
                            .g = scale.g,
                            .push = q->push,
                            .tol = tol,
                            .precision = precision,
                            .work = work};
    bool falls = ask_row_run(&row, true, NULL, NULL, &verdict) == DOM_OK && verdict.end == DOM_ROW_FALLS;
    return falls ? (double)verdict.seconds : NONE;
}

static double ask_newton(const struct question *q)
{
    struct domq_domino domino[DOMINOES_MAX];
    struct domq_scale scale = domq_scale_default();
    double height[DOMINOES_MAX], thickness[DOMINOES_MAX], width[DOMINOES_MAX], gap[DOMINOES_MAX],
        mass[DOMINOES_MAX];
    struct direct_hit hits[DOMINOES_MAX];
    struct direct_result result;
    ask_row_of_train(&q->train, &scale, 1, domino, q->dominoes);
    for (size_t i = 0; i < q->dominoes; i++) {
        height[i] = (double)domino[i].height;
        thickness[i] = (double)domino[i].thickness;
        width[i] = (double)domino[i].width;
        gap[i] = (double)domino[i].gap;
        mass[i] = (double)domino[i].mass;
    }
    struct direct_row row = {.n = q->dominoes,
                             .height = height,
                             .thickness = thickness,
                             .width = width,
                             .gap = gap,
                             .mass = mass,
                             .g = (double)scale.g,
                             .omega = q->push};
    return !direct_run(&row, hits, &result) && result.all_fall ? result.end_time : NONE;
}

static domq_real ask_train(const struct question *q, const struct setup *train)
{
    struct domq_limit limit = {.r_max = DOMQ_NAN};
    domq_real duration = DOMQ_NAN;
    if (q->task == DURATION)
        return ask_cycle_duration(train, &duration) == DOM_OK ? duration : DOMQ_NAN;
    return ask_limit_rmax(train, &limit) == DOM_OK ? limit.r_max : DOMQ_NAN;
}

domq_real ask_ours(const struct question *q, double tol, enum precision precision, struct dom_work *work)
{
    struct setup train = q->train;
    if (q->task == ROW)
        return ask_row(q, tol, precision, work);
    train.tol = tol;
    train.precision = precision;
    train.work = work;
    return ask_train(q, &train);
}

static bool ask_scipy(const struct question *q, double tol, double *seconds, double *value)
{
    static const char *const name[] = {[RMAX] = "rmax", [DURATION] = "duration", [ROW] = "row"};
    const struct setup *t = &q->train;
    struct domq_scale scale = domq_scale_default();
    char line[256];
    if (q->task == ROW)
        snprintf(line, sizeof line, "row %.17g %zu %.17g %.17g %.17g %.17g %.17g %.17g", tol, q->dominoes,
                 (double)t->r, (double)t->s, (double)t->d, (double)scale.h, (double)scale.g, q->push);
    else
        snprintf(line, sizeof line, "%s %.17g %.17g %.17g %.17g %.17g", name[q->task], tol, (double)t->s,
                 (double)t->r, (double)t->d, (double)t->q);
    return coprocess_ask(&scipy, line, seconds, value);
}

/* Asks all questions one after the other. Writes the values and returns the time. */
static double sweep(enum contender contender, const struct question *q, size_t n, double tol, double *value)
{
    static const enum dom_method method[CONTENDERS] = {
        [OURS] = DOM_METHOD_OURS, [GSL] = DOM_METHOD_GSL, [PAPER] = DOM_METHOD_PAPER};
    double begun = seconds_now(), total = 0, seconds;
    for (size_t i = 0; i < n; i++) {
        if (contender == SCIPY) {
            if (!ask_scipy(&q[i], tol, &seconds, &value[i]))
                return NAN;
            total += seconds;
        } else if (contender == NEWTON) {
            value[i] = ask_newton(&q[i]);
        } else if (q[i].task == ROW) {
            value[i] = ask_row(&q[i], tol, IN_DOUBLE, NULL);
        } else {
            struct setup train = q[i].train;
            train.tol = tol;
            train.method = method[contender];
            value[i] = (double)ask_train(&q[i], &train);
        }
    }
    return contender == SCIPY ? total : seconds_now() - begun;
}

/* ---- The tolerance with which a contender reaches the target ---- */

/* Finds the largest error within the target, counts the questions with larger errors, and finds the worst of
 * them. */
static void judge(struct result *result, const struct question *q, size_t n, const double *value,
                  const double *truth, double target)
{
    result->error = result->worst = 0;
    result->missed = 0;
    for (size_t i = 0; i < n; i++) {
        double error = fabs(value[i] / truth[i] - 1);
        if (!(error <= target)) {
            result->missed++;
            if (!(error <= result->worst))
                result->missed_s = (double)q[i].train.s;
            result->worst = fmax(result->worst, error);
        } else if (error > result->error) {
            result->error = error;
        }
    }
}

/* Finds the largest tolerance with which a contender reaches the target. For our own library, this is the
 * target itself. */
static void calibrate(enum contender contender, const struct question *q, size_t n, double target,
                      const double *truth, struct result *result)
{
    double value[QUESTIONS_MAX];
    double finest = (double)any_arithmetic(IN_DOUBLE).tol_floor;
    double loosest = fmin((q->task == RMAX ? 1e2 : 1e6) * target, 1e-2);
    if (contender == NEWTON) /* the tolerance of this contender cannot be set */
        loosest = 1e-13;
    for (double tol = contender == OURS ? target : loosest;; tol /= 10) {
        struct result now = {.tol = tol, .seconds = sweep(contender, q, n, tol, value)};
        if (!(now.seconds > 0))
            return;
        judge(&now, q, n, value, truth, target);
        now.compared = true;
        /* A large error is due to the method if a finer tolerance does not halve it. */
        bool method = result->compared && now.missed == result->missed && now.worst > 1e3 * target &&
                      now.worst > result->worst / 2;
        if (!result->compared || now.missed < result->missed)
            *result = now;
        if (now.missed == 0 || method || contender == OURS || tol <= fmax(target / 10, finest))
            return;
    }
}

static void table_print(const struct result result[CONTENDERS], size_t n, double scale)
{
    double ours = result[OURS].seconds;
    printf("  %-20s %8s %9s %13s %9s  %s\n", "", "tol", "error", "time, us", "ratio", "");
    for (enum contender contender = OURS; contender < CONTENDERS; contender++) {
        const struct result *r = &result[contender];
        if (!r->compared)
            continue;
        printf("  %-20s %8.0e %9.1e %13.2f %9.4g", contender_name[contender], r->tol, r->error,
               1e6 * r->seconds * scale, r->seconds / ours);
        if (r->missed > 0)
            printf("  misses %zu of %zu, at s = %.4g by %.0e", r->missed, n, r->missed_s, r->worst);
        putchar('\n');
    }
}

void compare(const char *title, const struct question *question, size_t n, double target, unsigned contender,
             double scale, struct result result[CONTENDERS])
{
    double truth[QUESTIONS_MAX], value[QUESTIONS_MAX];
    enum precision finest = any_arithmetic(IN_QUAD).bits ? IN_QUAD : IN_DOUBLE;
    for (size_t i = 0; i < n; i++)
        truth[i] = (double)ask_ours(&question[i], finest == IN_QUAD ? 1e-18 : 1e-15, finest, NULL);
    for (enum contender w = OURS; w < CONTENDERS; w++) {
        result[w] = (struct result){.compared = false};
        if ((contender & 1U << w) && (w != SCIPY || scipy.pid > 0))
            calibrate(w, question, n, target, truth, &result[w]);
    }
    for (int round = 0; round < ROUNDS; round++)
        for (enum contender w = OURS; w < CONTENDERS; w++) {
            struct result *r = &result[w];
            if (!r->compared || round * r->seconds > SECONDS_EACH)
                continue;
            double seconds = sweep(w, question, n, r->tol, value);
            r->seconds = seconds < r->seconds ? seconds : r->seconds;
        }
    for (enum contender w = OURS; w < CONTENDERS; w++)
        result[w].seconds /= (double)n;
    printf("\n%s\n", title);
    table_print(result, n, scale);
    fflush(stdout);
}

double contender_seconds(enum contender contender, const struct question *question, double tol)
{
    enum { TIMES = 3 };
    double value, least = NONE, spent = 0;
    if (contender == SCIPY && scipy.pid <= 0)
        return NONE;
    for (int k = 0; k < TIMES && spent < PATIENCE; k++) {
        double seconds = sweep(contender, question, 1, tol, &value);
        spent += seconds;
        if (!isfinite(seconds) || !isfinite(value))
            return NONE;
        least = fmin(least, seconds);
    }
    return least;
}

void rmax_questions(struct question *question, size_t n, double lo, double hi)
{
    size_t half = n / 2;
    for (size_t i = 0; i < n; i++) {
        struct setup train = setup_default();
        train.q = i < half ? 3 : 4;
        train.s = lo + (hi - lo) * (double)(i % half) / (double)(half - 1);
        question[i] = (struct question){.task = RMAX, .train = train};
    }
}

/* ---- SciPy ---- */

void contenders_start(void)
{
    /* one of the two may lack SciPy */
    static const char *const interpreters[] = {"python3", "/usr/bin/python3"};
    const struct question first = {.task = RMAX, .train = setup_default()};
    double seconds, value;
    for (int i = 0; i < 2; i++) {
        const char *const argv[] = {interpreters[i], "tests/bench/train_scipy.py", NULL};
        if (coprocess_start(&scipy, argv) && ask_scipy(&first, 1e-3, &seconds, &value))
            return;
        coprocess_end(&scipy);
        scipy.pid = 0;
    }
    puts("SciPy is not installed: no comparison with it ('make deps bench' installs it)");
}

void contenders_end(void)
{
    coprocess_end(&scipy);
}
