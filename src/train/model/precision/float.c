/* SPDX-License-Identifier: GPL-3.0-or-later */
#define REAL_FLOAT
#define KERNEL_NAME(name) name##_float
#include "precision/kernel.inc"

const struct kernel domq__kernel_float = KERNEL_TABLE;
