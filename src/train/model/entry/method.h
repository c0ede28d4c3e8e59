/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The methods for comparison. */
#ifndef DOM_METHOD_H
#define DOM_METHOD_H

#include "geometry/request.h"

/* The answers of a method; NULL where it has none. */
struct method {
    enum dom_status (*fuel_find)(const struct request *train, struct dom_fuels *fuels);
    enum dom_status (*launch_find)(const struct request *train, struct dom_launch *launch);
    enum dom_status (*barrier_find)(const struct request *train, struct dom_barrier *barrier);
    enum dom_status (*cycle_duration)(const struct request *train, dom_real *duration);
    enum dom_status (*limit_rmax)(const struct request *train, struct dom_limit *limit);
};

/* Finds a method. Only double has them: in float and quad, the status is DOM_NO_METHOD. */
#if defined DOMF || defined DOMQ
static inline enum dom_status method_find(enum dom_method method, const struct method **found)
{
    (void)method;
    (void)found;
    return DOM_NO_METHOD;
}
#else
extern const struct method method_gsl, method_paper;

static inline enum dom_status method_find(enum dom_method method, const struct method **found)
{
    *found = method == DOM_METHOD_GSL ? &method_gsl : &method_paper;
    return DOM_OK;
}
#endif

#endif
