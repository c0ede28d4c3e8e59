/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads tables in csv files: the rows, measurements and studies that other features take from files. */
#include "interpreter/feature.h"

const struct feature tables_feature = {.name = "tables"};
