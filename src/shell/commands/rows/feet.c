/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/rows/feet.h"
#include "language/quad.h"

struct feet feet_begin(const struct query *query)
{
    return (struct feet){.floor = query->scene->effect[DOM_EFFECT_floor].value[0]};
}

static void slip_add(struct slip *most, struct slip *first, struct slip slip, domq_real floor)
{
    if (slip.needs > most->needs)
        *most = slip;
    if (first->head == 0 && slip.needs > floor)
        *first = slip;
}

void feet_add(struct feet *feet, const struct domq_fall *f)
{
    slip_add(&feet->motion, &feet->motion_first, (struct slip){f->floor_motion, f->floor_domino, f->domino},
             feet->floor);
    slip_add(&feet->hit, &feet->hit_first, (struct slip){f->floor_hit, f->floor_hit_domino, f->domino},
             feet->floor);
}

enum { WHEN = 96 };

/* Writes which foot, and when: "of domino 2, while domino 3 falls". */
static const char *slip_when(const struct slip *slip, bool hit, char text[WHEN])
{
    int n = snprintf(text, WHEN, "of domino %zu, %s ", slip->domino, hit ? "when" : "while");
    if (slip->head == slip->domino)
        snprintf(text + n, (size_t)(WHEN - n), "it %s", hit ? "is hit" : "falls");
    else
        snprintf(text + n, (size_t)(WHEN - n), "domino %zu %s", slip->head, hit ? "is hit" : "falls");
    return text;
}

/* Prints what feet need, in motion or in collisions. */
static void slip_say(struct answer *a, const char *begin, const struct slip *most, const struct slip *first,
                     bool hit, domq_real floor)
{
    char when[WHEN], number[WIDE_TEXT];
    if (isfinite(most->needs))
        answer_say(a, "%s feet need a friction of up to %s: that %s.", begin,
                   quad_text(most->needs, 4, number), slip_when(most, hit, when));
    else
        answer_say(a, "%s the foot %s, is lifted off, which no friction prevents.", begin,
                   slip_when(most, hit, when));
    if (first->head == 0)
        answer_say(a, "None slips then on a floor with a friction of %.4g.", (double)floor);
    else if (isfinite(first->needs))
        answer_say(a,
                   "On a floor with a friction of %.4g the foot %s, is the first to slip then; it needs %s.",
                   (double)floor, slip_when(first, hit, when), quad_text(first->needs, 4, number));
}

void feet_matter(struct answer *a, bool in_motion)
{
    answer_say(
        a, in_motion
               ? "This answer is for feet that hold. Where feet slip while dominoes fall, a row can stop "
                 "sooner than it says."
               : "This answer is for feet that hold. A slip in the instant of a hit is no verdict: in a "
                 "rigid-body engine, a floor with a friction of 0.4 changes the largest growth by 3 %% at "
                 "most where dominoes have a friction of 0.2, and by a tenth where they have none.");
}

void feet_say(struct answer *a, const struct feet *feet, size_t count)
{
    if (feet->motion.head > 0)
        slip_say(a, "While dominoes fall,", &feet->motion, &feet->motion_first, false, feet->floor);
    if (feet->hit.head > 0)
        slip_say(a, "In the instant of a hit,", &feet->hit, &feet->hit_first, true, feet->floor);
    /* No other domino needs the foot of the last. */
    bool in_motion = feet->motion_first.head > 0 && feet->motion_first.head < count;
    if (in_motion || feet->hit_first.head > 0)
        feet_matter(a, in_motion);
    if (in_motion || feet->hit_first.head > 0)
        answer_say(a,
                   "'effect floor off; effect feet %.4g' runs the row on this floor, with feet that slip, in "
                   "a rigid-body engine.",
                   (double)feet->floor);
}
