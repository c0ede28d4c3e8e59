/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Intervals that carry their derivatives with respect to the growth r. */
#ifndef DOM_PROOF_DUAL_H
#define DOM_PROOF_DUAL_H

#include "proof/model/span.h"

/* A number that depends on r: bounds on its value, and on its derivative with respect to r. */
struct dual {
    struct span value, by_r;
};

/* Returns a number that does not depend on r. */
static inline struct dual dual_of(struct span a)
{
    return (struct dual){a, {0, 0}};
}

static inline struct dual dual_add(struct dual a, struct dual b)
{
    return (struct dual){span_add(a.value, b.value), span_add(a.by_r, b.by_r)};
}

static inline struct dual dual_sub(struct dual a, struct dual b)
{
    return (struct dual){span_sub(a.value, b.value), span_sub(a.by_r, b.by_r)};
}

/* Returns k a, for k >= 0. */
static inline struct dual dual_scale(struct dual k, struct dual a)
{
    return (struct dual){span_scale(k.value, a.value),
                         span_add(span_scale(k.value, a.by_r), span_mul(k.by_r, a.value))};
}

/* Returns a / k, for k > 0. */
static inline struct dual dual_over(struct dual a, struct dual k)
{
    const struct span ratio = span_over(a.value, k.value);
    return (struct dual){ratio, span_over(span_sub(a.by_r, span_mul(ratio, k.by_r)), k.value)};
}

#endif
