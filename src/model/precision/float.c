/* SPDX-License-Identifier: GPL-3.0-or-later */
#define REAL_FLOAT
#include "precision/kernel.inc"

const struct kernel kernel_float = KERNEL_TABLE;
