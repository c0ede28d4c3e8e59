/* SPDX-License-Identifier: GPL-3.0-or-later */
#define REAL_QUAD
#define KERNEL_NAME(name) name##_quad
#ifndef DOMQ /* results and error bounds are rounded to double when they leave this kernel */
#pragma GCC diagnostic ignored "-Wfloat-conversion"
#ifdef __clang__
#pragma GCC diagnostic ignored "-Wimplicit-float-conversion"
#endif
#endif
#include "precision/kernel.inc"

const struct kernel kernel_quad = KERNEL_TABLE;
