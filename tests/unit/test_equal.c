/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: rows */
/*
 * Long rows of equal dominoes, in which each head repeats the motion of the previous one. A row whose gaps
 * differ in their last digits, so that no head repeats another, must give the same results.
 */
#include "ask.h"
#include "support.h"

enum { COUNT = 420 };

struct falls {
    struct domq_domino domino[COUNT];
    struct domq_fall fall[COUNT];
    struct domq_verdict verdict;
    struct dom_work work;
    size_t seen;
    struct dom_floor floor[COUNT];
};

static bool keep(const struct domq_fall *fall, void *context)
{
    struct falls *f = context;
    f->fall[f->seen++] = *fall;
    return true;
}

struct kind {
    const char *name;
    double gap, mu, push;
    size_t other; /* the domino that is heavier; 0 for none */
};

static const struct kind KIND[] = {
    {.name = "plain", .gap = 0.02},
    {.name = "friction", .gap = 0.02, .mu = 0.2, .push = 5},
    {.name = "close", .gap = 0.003, .push = 20},
    {.name = "detach", .gap = 0.042, .push = 5},
    {.name = "one is heavier", .gap = 0.02, .other = 350},
    {.name = "the last is heavier", .gap = 0.02, .other = COUNT - 1},
};

/* Runs the row. Every second gap is larger by the fraction `off`. */
static void run(const struct kind *k, double off, struct falls *f)
{
    const struct domq_row row = {.domino = f->domino,
                                 .count = k->mu != 0 ? COUNT / 3 : COUNT,
                                 .g = 9.81,
                                 .push = k->push != 0 ? k->push : DOM_NAN,
                                 .mu = k->mu};
    struct any_compute compute = any_compute_default();
    compute.work = &f->work;
    f->seen = 0;
    f->work = (struct dom_work){0};
    for (size_t i = 0; i < COUNT; i++)
        f->domino[i] = (struct domq_domino){
            .height = 0.048, .thickness = 0.007, .gap = k->gap * (1 + off * (double)(i % 2)), .mass = 0.01};
    if (k->other)
        f->domino[k->other].mass *= 1.1;
    assert_status(any_row_run(&row, &compute, true, keep, f, &f->verdict), DOM_OK);
    struct row_setup setup = row_setup_default(f->domino, row.count, row.push);
    setup.mu = k->mu;
    assert_status(ask_row_floor(&setup, f->floor), DOM_OK);
}

/* Checks that two values agree. Both may be infinite, 0 or NaN. */
static void same(const char *name, domq_real a, domq_real b)
{
    if (a == b || (isnan((double)a) && isnan((double)b)))
        return;
    assert_near(name, a, (double)b, 1e-10);
}

TEST(heads_repeat)
{
    static struct falls equal, other;
    for (size_t i = 0; i < sizeof KIND / sizeof *KIND; i++) {
        const struct kind *k = &KIND[i];
        run(k, 0, &equal);
        run(k, 1e-14, &other);
        assert_int_equal(equal.seen, other.seen);
        if (equal.verdict.end != DOM_ROW_FALLS || other.verdict.end != DOM_ROW_FALLS)
            fail_msg("%s: domino %zu ends the row", k->name, equal.verdict.domino);
        assert_int_equal(equal.verdict.domino, other.verdict.domino);
        assert_near(k->name, equal.verdict.seconds, (double)other.verdict.seconds, 1e-10);
        same(k->name, equal.verdict.spare, other.verdict.spare);
        for (size_t j = 0; j < equal.seen; j++) {
            const struct domq_fall *a = &equal.fall[j], *b = &other.fall[j];
            if (a->domino != b->domino || a->moving != b->moving)
                fail_msg("%s: %zu moving %zu, %zu moving %zu", k->name, a->domino, a->moving, b->domino,
                         b->moving);
            same(k->name, a->omega, b->omega);
            same(k->name, a->kinetic, b->kinetic);
            same(k->name, a->lost, b->lost);
            same(k->name, a->duration, b->duration);
            same(k->name, a->theta, b->theta);
            same(k->name, a->time, b->time);
            const struct dom_floor *of = &equal.floor[j], *from = &other.floor[j];
            same("friction of the floor", of->motion, from->motion);
            same("friction of the floor in the hit", of->hit, from->hit);
            assert_true(of->domino == from->domino && of->hit_domino == from->hit_domino);
        }
        if (equal.work.passes > other.work.passes * 3 / 4)
            fail_msg("%s: no head repeats: %zu passes of %zu", k->name, equal.work.passes, other.work.passes);
    }
}
