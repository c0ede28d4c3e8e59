/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/effect_list.h"
#include "language/text.h"
#include <stdio.h>

static const struct domq_effect *effects[EFFECT_COUNT];

void effect_use(int k, const struct domq_effect *effect)
{
    effects[k] = effect;
}

const struct domq_effect *effect_at(int k)
{
    return k < DOM_EFFECT_COUNT ? domq_effect((enum dom_effect_name)k) : effects[k];
}

const char *effect_usage_write(int effect, char usage[EFFECT_USAGE])
{
    const struct domq_effect *e = effect_at(effect);
    snprintf(usage, EFFECT_USAGE, "%s", e->name);
    for (int i = 0; i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++)
        text_add(usage, EFFECT_USAGE,
                 e->argument[i].optional  ? " [%s]"
                 : e->argument[i].or_file ? " %s|FILE"
                                          : " %s",
                 e->argument[i].name);
    return usage;
}
