/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerics/interrupt.h"
#include "numerics/api.h"

bool dom_interrupted(const volatile sig_atomic_t *flag)
{
    return dom_raised(flag);
}
