/* SPDX-License-Identifier: GPL-3.0-or-later */
#define REAL_QUAD
#include "numerics/edge.h"
#include "numerics/real.h"

dom_real edge_find(edge_test *test, void *context, dom_real good, dom_real bad, dom_real absolute,
                   dom_real relative)
{
    while (fabs(good - bad) > absolute + relative * good) {
        dom_real middle = (good + bad) / 2;
        if (middle == good || middle == bad)
            break;
        *(test(middle, context) ? &good : &bad) = middle;
    }
    return good;
}
