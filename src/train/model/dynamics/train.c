/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the public structures begin with: defaults, the properties of dom_real, rows with the proportions of a
 * train, and how far a domino may lean. */
#include "geometry/geometry.h"

#define DEFAULT(name, default_, lowest, highest, unit, meaning) .name = default_,

struct dom_train dom_train_default(void)
{
    return (struct dom_train){DOM_TRAIN_PARAMETERS(DEFAULT).fuel = DOM_FUEL_EXACT};
}

struct dom_scale dom_scale_default(void)
{
    return (struct dom_scale){DOM_SCALE_PARAMETERS(DEFAULT)};
}

struct dom_row dom_row_default(void)
{
    return (struct dom_row){.g = dom_scale_default().g, .push = DOM_NAN};
}

dom_real dom_train_reach(const struct dom_train *train)
{
    return reach_span(train->rho) / train->s;
}

/* The smallest tolerance of each precision is 4 to 10 times its epsilon. */
#define TENTH(power) (1 / (dom_real)(power)) /* `power` is a power of ten that a double holds exactly */

#if defined DOMF
static const struct dom_arithmetic arithmetic = {
    "float", "float", FLT_MANT_DIG, (double)FLT_EPSILON, TENTH(1e5F), TENTH(1e6F), 5};
#elif !defined DOMQ
static const struct dom_arithmetic arithmetic = {"double", "double", DBL_MANT_DIG, DBL_EPSILON, 1 / 1e12,
                                                 1 / 1e15, 10};
#elif defined DOMQ_REAL_FLOAT128
static const struct dom_arithmetic arithmetic = {
    "quad", "__float128", 113, 0x1p-112, TENTH(1e15) / 1e15, TENTH(1e15) / 1e18, 30};
#elif LDBL_MANT_DIG == 113
static const struct dom_arithmetic arithmetic = {
    "quad", "long double", 113, 0x1p-112, TENTH(1e15) / 1e15, TENTH(1e15) / 1e18, 30};
#elif LDBL_MANT_DIG > DBL_MANT_DIG
static const struct dom_arithmetic arithmetic = {
    "quad", "long double", LDBL_MANT_DIG, (double)LDBL_EPSILON, TENTH(1e17), TENTH(1e18), 17};
#else
static const struct dom_arithmetic arithmetic = {
    "quad", "none wider than double", 0, DBL_EPSILON, TENTH(1e12), TENTH(1e15), 10};
#endif

const struct dom_arithmetic *dom_arithmetic(void)
{
    return &arithmetic;
}

struct dom_compute dom_compute_default(void)
{
    return (struct dom_compute){.tol = arithmetic.tol_default};
}

void dom_row_of_train(const struct dom_train *train, const struct dom_scale *scale, dom_real mass,
                      struct dom_domino *domino, size_t count)
{
    const dom_real heavier = pow(train->r, train->q - 1);
    dom_real height = scale->h;
    for (size_t k = 0; k < count; k++, height *= train->r, mass *= heavier)
        domino[k] = (struct dom_domino){
            .height = height,
            .thickness = train->d * height,
            .gap = k == 0 ? 0 : train->s * height,
            .width = train->width * height,
            .mass = mass,
        };
}

void dom_lean_limits(const struct dom_domino *domino, dom_real alpha, dom_real rho, dom_real lean[2])
{
    dom_real radius = rho != 0 && domino->radius > 0 ? domino->radius : rho * domino->height;
    dom_real limit = atan((domino->thickness - 2 * radius) / domino->height);
    lean[0] = -limit - alpha;
    lean[1] = limit - alpha;
}
