/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Descriptions of all effects: first the effects of the library, then those that features of the program
 * describe (effect_kinds.h). To add an effect of the model, follow src/train/model/dynamics/README.md. */
#ifndef SHELL_EFFECT_LIST_H
#define SHELL_EFFECT_LIST_H

#include "language/names.h"
#include "session/effect_kinds.h"
#include <math.h>

/* Values of an effect that stand for the words "off" and "on". EFFECT_ON turns an effect on with its usual
 * values. If the effect is already on, its values do not change. */
#define EFFECT_OFF ((domq_real)-HUGE_VAL)
#define EFFECT_ON  ((domq_real)HUGE_VAL)

/* The word 'touch' for the value of the effect 'release', and its number: the domino leans against the next
 * one, which it touches before it lies flat. */
#define RELEASE_TOUCH_WORD "touch"
#define RELEASE_TOUCH      ((domq_real)1.5707963267948966)

/* Returns the description of effect number k, counted from 0, or NULL if this build lacks the effect.
 * effect_use sets it. */
void effect_use(int k, const struct domq_effect *effect);
const struct domq_effect *effect_at(int k);

/* Returns the usage of an effect, such as "friction MU". The text lives until the end of the caller's
 * block. */
enum { EFFECT_USAGE = 64 };
#define effect_usage(effect) effect_usage_write(effect, (char[EFFECT_USAGE]){""})
const char *effect_usage_write(int effect, char usage[EFFECT_USAGE]);

#endif
