/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The public API, as the library's own sources include it. The sources of trains and rows are compiled once
 * for each precision: with DOMF defined for float, with DOMQ for quad, and with neither for double. With
 * DOMQ, the file domq_names.h replaces the names in domino.h with the names in domino_quad.h, by lines such
 * as "#define dom_train domq_train", and likewise with DOMF.
 */
#pragma once

#if __has_include("domino_quad.h")
#include "domino_float.h"
#include "domino_quad.h"
#else /* for tools that check a source file before the build has generated these headers */
#include "domino_row.h"
typedef long double domq_real;
#endif

#if defined DOMF
#include "domf_names.h"
#elif defined DOMQ
#include "domq_names.h"
#endif

/* Returns true if a member is set that this version of the library does not have. */
#define IS_NEWER(given)                                                                                      \
    ((given)->later[0] != 0 || (given)->later[1] != 0 || (given)->later[2] != 0 || (given)->later[3] != 0)
_Static_assert(DOM_LATER == 4, "IS_NEWER");

static inline struct dom_compute compute_or_default(const struct dom_compute *compute)
{
    return compute ? *compute : dom_compute_default();
}
