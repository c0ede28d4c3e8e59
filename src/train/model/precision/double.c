/* SPDX-License-Identifier: GPL-3.0-or-later */
#define KERNEL_NAME(name) name##_double
#include "precision/kernel.inc"

const struct kernel dom__kernel_double = KERNEL_TABLE;
const struct studies dom__studies = {row_study_begin, row_study, row_study_end};
