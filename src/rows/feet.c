/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The friction that the floor needs so that no foot slips. The commands 'slip', 'fall' and 'verdict' print
 * it. */
#include "language/quad.h"
#include "rows/rows.h"

const char foot_lifted[] = "a domino is lifted off the floor, and no friction can prevent this";

struct feet feet_begin(const struct query *query)
{
    return (struct feet){.floor = query->scene->effect[DOM_EFFECT_floor].value[0]};
}

static void needs_add(struct needs *n, struct slip slip, domq_real floor)
{
    if (slip.needs > n->most.needs)
        n->most = slip;
    if (n->first.head == 0 && slip.needs > floor)
        n->first = slip;
}

void feet_add(struct feet *feet, const struct domq_fall *f)
{
    needs_add(&feet->motion, (struct slip){f->floor_motion, f->floor_domino, f->domino}, feet->floor);
    needs_add(&feet->hit, (struct slip){f->floor_hit, f->floor_hit_domino, f->domino}, feet->floor);
}

/* Returns a phrase such as "while domino 3 falls" or "when domino 3 is hit". If the foot that needs friction
 * is that of domino 3 itself, the phrase says "this domino". */
static struct words slip_words(const struct slip *slip, bool hit)
{
    struct words words;
    char head[40] = "this domino";
    if (slip->head != slip->domino)
        snprintf(head, sizeof head, "domino %zu", slip->head);
    snprintf(words.text, sizeof words.text, "%s %s %s", hit ? "when" : "while", head,
             hit ? "is hit" : "falls");
    return words;
}

static void needs_say(struct answer *a, const struct needs *n, bool hit, domq_real floor)
{
    const struct slip *most = &n->most, *first = &n->first;
    if (most->head == 0)
        return;
    if (isfinite(most->needs))
        answer_say(a, "%s feet need a friction coefficient of up to %s (the foot of domino %zu, %s).",
                   hit ? "At the moment of a hit," : "While dominoes fall,",
                   measured(most->needs, "", 4).text, most->domino, slip_words(most, hit).text);
    else
        answer_say(a, "The foot of domino %zu is lifted off the floor %s, and no friction can prevent this.",
                   most->domino, slip_words(most, hit).text);
    if (first->head == 0)
        answer_say(a, "On a floor with a friction coefficient of %.4g, no foot slips %s.", (double)floor,
                   hit ? "at a hit" : "while dominoes fall");
    else if (isfinite(first->needs))
        answer_say(a,
                   "On a floor with a friction coefficient of %.4g, the foot of domino %zu slips first (it "
                   "needs %s %s).",
                   (double)floor, first->domino, measured(first->needs, "", 4).text,
                   slip_words(first, hit).text);
}

/* Prints how slipping feet affect the answer. If `in_motion` is false, feet slip only in a collision. */
static void slip_matters_say(struct answer *a, bool in_motion)
{
    answer_say(
        a,
        in_motion
            ? "This answer assumes that feet do not slip. If feet slip while dominoes fall, a row can stop "
              "sooner than this answer says."
            : "This answer assumes that feet do not slip. A slip at the moment of a hit matters little. In "
              "tests with a rigid-body engine, feet could slip on a floor with a friction coefficient of "
              "0.4. This changed the largest growth by at most 3 %% if the coefficient between the dominoes "
              "was 0.2, and by about a tenth if there was no friction between them.");
}

void feet_say(struct answer *a, const struct feet *feet, size_t count)
{
    needs_say(a, &feet->motion, false, feet->floor);
    needs_say(a, &feet->hit, true, feet->floor);
    /* While the last domino falls, a slip does not matter. */
    bool in_motion = feet->motion.first.head > 0 && feet->motion.first.head < count;
    if (!in_motion && feet->hit.first.head == 0)
        return;
    slip_matters_say(a, in_motion);
    answer_say(a,
               "Enter 'set floor off; set feet %.4g' to run the row on this floor in a rigid-body "
               "engine, where feet can slip.",
               (double)feet->floor);
}

/* ---- slip ---- */

const struct column slip_columns[] = {
    {"motion", "",
     "the friction that the floor needs so that no foot slips while dominoes fall: the largest |R_x| / R_z",
     0},
    {"theta", "rad", "the tilt of the head at which a foot needs this friction", 0},
    {"domino", "", "the domino whose foot needs this friction: 0 = head, 1, 2, ... its followers", 0},
    {"hit", "",
     "the friction that the floor needs so that no foot slips in a collision: the largest ratio of impulses",
     0},
    {"hit_domino", "", "the domino whose foot needs this friction in a collision", 0},
    {"slips", "",
     "yes if a foot slips on the floor of 'set floor' while dominoes fall; empty without this effect", 0},
    {"slips_hit", "",
     "yes if a foot slips on the floor of 'set floor' in a collision; empty without this effect", 0},
    {NULL, NULL, NULL, 0},
};

bool run_slip(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_floor f;
    const struct effect_state *floor = &query->scene->effect[DOM_EFFECT_floor];
    const enum dom_status status = any_cycle_floor(&query->scene->train, &query->scene->compute, &f);
    if (status == DOM_NO_AIR && query->scene->effect[DOM_EFFECT_row].on)
        return problem_no_answer(problem, "%s; about the row: 'set floor 0.4; fall'",
                                 dom_status_text(status));
    if (!query_status(query, problem, status))
        return false;
    bool slips = f.motion > floor->value[0], slips_hit = f.hit > floor->value[0];
    answer_row(a,
               ROW(cell_narrow(f.motion, 6), cell_computed(f.theta), cell_count((domq_real)f.domino),
                   cell_computed(f.hit), cell_count((domq_real)f.hit_domino),
                   floor->on ? cell_flag(slips) : cell_real(DOMQ_NAN),
                   floor->on ? cell_flag(slips_hit) : cell_real(DOMQ_NAN)),
               isfinite(f.motion) && isfinite(f.hit) ? NULL : foot_lifted);
    if (!floor->on)
        answer_say(a, "'set floor 0.5' sets the friction of the floor to 0.5; 'fall' then shows whether "
                      "any foot slips.");
    else
        answer_say(
            a,
            "On a floor with a friction coefficient of %.4g, %s while dominoes fall, and %s in a collision.",
            (double)floor->value[0], slips ? "feet slip" : "no foot slips",
            slips_hit ? "feet slip" : "no foot slips");
    if (floor->on && (slips || slips_hit))
        slip_matters_say(a, slips);
    return true;
}
