/* SPDX-License-Identifier: GPL-3.0-or-later */
#define REAL_QUAD
#define KERNEL_NAME(name) name##_quad
#include "precision/kernel.inc"

const struct kernel domq__kernel_quad = KERNEL_TABLE;
