/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/format.h"

const struct format *format_at(unsigned number)
{
#define FORMAT_POINTER(name) &format_##name,
    static const struct format *const formats[] = {FORMATS(FORMAT_POINTER)};
#undef FORMAT_POINTER
    return formats[number];
}
