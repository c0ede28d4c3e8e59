/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The arithmetic of the kernels. `real` is the floating-point type. The functions of <math.h> that are listed
 * below take and return `real`, as with <tgmath.h>. The same source is compiled for each precision
 * (precision/). `real` is the same type as dom_real.
 */
#pragma once

#include "numerics/api.h"
#include <float.h>
#include <math.h>
#include <stdint.h>

/* Marks functions of the kernels. Each precision has its own static copy. */
#define KERNEL static __attribute__((unused))
/* Marks functions of the kernel that models of features call, too (src/rows/model/windows.c and others),
 * which exist in double only. */
#if defined DOMF || defined DOMQ
#define KERNEL_SHARED KERNEL
#else
#define KERNEL_SHARED
#endif
/* Marks functions that are called in the loops along a train. They are inlined, since a call would cost as
 * much as the arithmetic. In quad they are not inlined, since every operation is a function call anyway. */
#ifdef DOMQ
#define KERNEL_LOOP KERNEL
#else
#define KERNEL_LOOP static inline __attribute__((always_inline, unused))
#endif

#if defined DOMF
typedef float real;
#define REAL_BITS  FLT_MANT_DIG
#define REAL_MIN   FLT_MIN
#define MATH(name) name##f
#elif !defined DOMQ
typedef double real;
#define REAL_BITS DBL_MANT_DIG
#define REAL_MIN  DBL_MIN
#elif defined DOMQ_REAL_FLOAT128
/* glibc has these functions for every compiler, but declares them only for gcc. */
typedef domq_real real_one(domq_real), real_two(domq_real, domq_real);
extern real_one sqrtf128, cbrtf128, fabsf128, sinf128, cosf128, tanf128, asinf128, atanf128, asinhf128,
    expf128, expm1f128, logf128, log1pf128, floorf128, ceilf128, roundf128;
extern real_two hypotf128, atan2f128, powf128;
extern domq_real fmaf128(domq_real, domq_real, domq_real);
typedef domq_real real;
#define REAL_BITS  113
#define REAL_MIN   ((real)0x1p-16382L)
#define MATH(name) name##f128
#else
typedef domq_real real;
#define REAL_BITS  LDBL_MANT_DIG
#define REAL_MIN   LDBL_MIN
#define MATH(name) name##l
#endif

/* Twice the unit roundoff: the distance from 1 to the next larger number. */
#define REAL_EPSILON ((real)1 / ((uint64_t)1 << ((REAL_BITS - 1) / 2)) / ((uint64_t)1 << (REAL_BITS / 2)))

/* The unit roundoff: the largest relative error of one operation. */
#define ROUNDOFF (REAL_EPSILON / 2)
#define REAL_NAN ((real)NAN)
/* Pi as a sum of doubles, correct to 49 digits. */
#define PI ((real)3.141592653589793116 + (real)1.2246467991473532072e-16 - (real)2.9947698097183396659e-33)

#ifndef MATH
#define MATH(name) name
#else
#define sqrt(x)      MATH(sqrt)(x)
#define cbrt(x)      MATH(cbrt)(x)
#define fabs(x)      MATH(fabs)(x)
#define sin(x)       MATH(sin)(x)
#define cos(x)       MATH(cos)(x)
#define asin(x)      MATH(asin)(x)
#define atan(x)      MATH(atan)(x)
#define asinh(x)     MATH(asinh)(x)
#define exp(x)       MATH(exp)(x)
#define expm1(x)     MATH(expm1)(x)
#define log(x)       MATH(log)(x)
#define log1p(x)     MATH(log1p)(x)
#define floor(x)     MATH(floor)(x)
#define tan(x)       MATH(tan)(x)
#define ceil(x)      MATH(ceil)(x)
#define round(x)     MATH(round)(x)
#define hypot(x, y)  MATH(hypot)(x, y)
#define atan2(y, x)  MATH(atan2)(y, x)
#define pow(x, y)    MATH(pow)(x, y)
#define fma(x, y, z) MATH(fma)(x, y, z)
#endif

/* C's fmax must handle NaN, which costs a function call. Unlike fmax, these two functions return b if a or b
 * is NaN. */
KERNEL inline real real_larger(real a, real b)
{
    return a > b ? a : b;
}

KERNEL inline real real_smaller(real a, real b)
{
    return a < b ? a : b;
}

#undef fmax
#undef fmin
#define fmax(x, y) real_larger(x, y)
#define fmin(x, y) real_smaller(x, y)
