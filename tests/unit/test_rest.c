/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: proof */
/* The bounds for remainders of sums in proofs, compared with the sums of the omitted terms. */
#include "proof/model/chain.c"
#include "proof/model/power.c"
#include "proof/model/rest.c"
#include "support.h"

/* Sums over domino n and all later ones. struct rest has a bound for each of these sums. */
struct tail {
    double drops, slides, tilts, shift;
};

static double middle(struct span of)
{
    return (of.lo + of.hi) / 2;
}

static struct tail tail_sum(const struct growth *g, struct domino domino, double power, int n)
{
    struct tail sum = {.shift = 0};
    double per_domino = middle(g->weight), q = middle(g->shape->q), r = middle(g->r);
    double last = middle(tilt_height(g->shape, chain_last(g).v));
    for (int i = n; i < n + 3000 && power > 1e-30; i++, power *= per_domino) {
        double rises = fabs(middle(tilt_rise(g->shape, domino.v)));
        sum.drops += q / r * i * power * (middle(tilt_height(g->shape, domino.v)) - last);
        sum.slides += power * rises * middle(domino.shift);
        sum.tilts += power * rises * middle(domino.slope);
        sum.shift = fmax(sum.shift, middle(domino.shift));
        struct contact contact = chain_contact(g, domino.v);
        struct domino next = chain_next(g, &domino, &contact);
        domino = (struct domino){span_of(middle(next.v)), span_of(middle(next.slope)),
                                 span_of(middle(next.shift))};
    }
    return sum;
}

TEST(bounds_hold)
{
    uint64_t seed = 31;
    int kinds[2] = {0, 0};
    double closest = 0;
    for (int i = 0; i < 400; i++) {
        double s = 0.03 + 0.7 * random_unit(&seed), d = 0.05 + 0.3 * random_unit(&seed);
        double r = 1.01 + (fmin(0.95 / s, 2.5) - 1.01) * random_unit(&seed);
        struct shape shape = shape_make(s, d, 2 + 2 * random_unit(&seed));
        struct growth g = growth_make(&shape, r, r);
        struct domino domino = {span_of(middle(chain_hit(&g)) * random_unit(&seed)), {1, 1}, {0, 0}};
        double power = 1;
        int n = 0;
        /* The bounds hold beyond theta_u, where h decreases along the chain. */
        for (; n < 40 && (n < 2 || domino.v.lo < shape.v_top.hi); n++, power *= middle(g.weight)) {
            struct contact contact = chain_contact(&g, domino.v);
            domino = chain_next(&g, &domino, &contact);
        }
        struct contact contact = chain_contact(&g, domino.v);
        double fall = tilt_height(&shape, domino.v).hi - tilt_height(&shape, chain_last(&g).v).lo;
        struct rest rest = rest_find(&g, &domino, &contact, power, fall, n);
        struct tail sum = tail_sum(&g, domino, power, n);
        const double slack = 1e-9;
        assert_true(sum.drops <= rest.drops * (1 + slack) + 1e-12);
        assert_true(sum.slides <= rest.slides * (1 + slack) + 1e-12);
        assert_true(sum.tilts <= rest.tilts * (1 + slack) + 1e-12);
        assert_true(sum.shift <= rest.shift * (1 + slack) + 1e-12);
        kinds[g.detaches_never]++;
        if (sum.drops > 1e-6)
            closest = fmax(closest, sum.drops / rest.drops);
    }
    print_message("# %d trains in which followers detach, %d in which none does; the closest bound is %.3g "
                  "of its sum\n",
                  kinds[0], kinds[1], 1 / closest);
    assert_true(kinds[0] > 50 && kinds[1] > 50 && closest > 0.3);
}
