/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The public API, as the library's own sources include it. A source can be compiled in two ways: with
 * dom_real as double, or with DOMQ defined. Some sources are compiled only in one of these ways, and the rest
 * in both. With DOMQ, the file domq_names.h replaces the names in domino.h with the names in domino_quad.h.
 * It does so with lines such as "#define dom_train domq_train".
 */
#ifndef DOM_API_H
#define DOM_API_H

#if __has_include("domino_quad.h")
#include "domino_quad.h"
#else /* for tools that check a source file before the build has generated domq_names.h */
#include "domino_row.h"
typedef long double domq_real;
#endif

#include <float.h>

#if !defined DOMQ
#define DOM_REAL_EPSILON DBL_EPSILON
#else
#include "domq_names.h"
#if defined DOMQ_REAL_FLOAT128
#define DOM_REAL_EPSILON 0x1p-112
#else
#define DOM_REAL_EPSILON LDBL_EPSILON
#endif
#endif

#endif
