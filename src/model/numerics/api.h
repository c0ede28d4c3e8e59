/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The public API, as the library's own sources include it. Some sources are compiled with dom_real as double,
 * others with DOMQ defined, and the rest both ways. With DOMQ, lines such as "#define dom_train domq_train"
 * (domq_names.h) replace the names in domino.h with the names in domino_quad.h.
 */
#ifndef DOM_API_H
#define DOM_API_H

#if __has_include("domino_quad.h")
#include "domino_quad.h"
#else /* for tools that check a source file before the build has generated domq_names.h */
#include "domino.h"
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
