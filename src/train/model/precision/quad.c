/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The build defines DOMQ. */
#include "precision/kernel.inc"
