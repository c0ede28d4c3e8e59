/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/format.h"

#define FORMAT_POINTER(name) &format_##name,
const struct format *const formats[] = {FORMATS(FORMAT_POINTER)};
