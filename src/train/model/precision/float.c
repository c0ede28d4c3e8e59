/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The build defines DOMF. */
#include "precision/kernel.inc"
