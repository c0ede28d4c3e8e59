/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'change', 'place', 'remove' and 'insert'. */
#include "answer/cell.h"
#include "language/quad.h"
#include "rows/rows.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- change and place: parsing ---- */

struct change_parsed {
    struct row_change *change; /* the selected dominoes */
    struct item value;
    bool is_set;   /* an '=' precedes the value */
    bool has_sign; /* the value begins with a sign */
    bool is_share; /* the value ends with '%' */
};

/* Reads a number or a range, such as "4", "3-7", "3:7" or "3..7". If the text is anything else, returns false
 * and reads nothing. */
static bool range_read(struct reader *r, struct row_range *range)
{
    char *end;
    if (!isdigit((unsigned char)*r->at))
        return false;
    range->first = range->last = strtoul(r->at, &end, 10);
    const char *after = end + (strncmp(end, "..", 2) == 0 ? 2 : *end == '-' || *end == ':');
    if (after > end && isdigit((unsigned char)*after))
        range->last = strtoul(after, &end, 10);
    if (!isspace((unsigned char)*end) && *end != ',' && !command_ends(end))
        return false;
    r->at = end;
    return true;
}

bool change_parse_dominoes(struct reader *r, struct question *q)
{
    size_t most = 1;
    for (const char *at = r->at; *at; at++)
        most += *at == ',';
    struct change_parsed *parsed = q->parsed = reader_memory(r, sizeof *parsed);
    struct row_change *c = parsed ? reader_memory(r, sizeof *c + most * sizeof *c->range) : NULL;
    if (!c)
        return false;
    parsed->change = c;
    if (reader_takes(r, "all"))
        return true;
    for (;; r->at = skip_blanks(r->at + 1)) {
        struct row_range *range = &c->range[c->ranges++];
        reader_place(r, r->at);
        if (!range_read(r, range))
            return problem_error(r->problem, "this is no domino; write numbers as in 4,5 or 3-7, or 'all'");
        if (range->first > range->last)
            return problem_error(r->problem, "'%zu-%zu' names no dominoes; write the smaller number first",
                                 range->first, range->last);
        const char *next = skip_blanks(r->at);
        if (*next != ',')
            return true;
        r->at = next;
    }
}

bool change_parse_value(struct reader *r, struct question *q)
{
    static const struct argument value = {.name = "X", .kind = ARGUMENT_ANY};
    struct change_parsed *c = q->parsed;
    c->is_set = *r->at == '=';
    r->at = skip_blanks(r->at + c->is_set);
    const char *begin = r->at;
    reader_place(r, begin);
    c->has_sign = *begin == '+' || *begin == '-';
    if (!item_parse(r, &value, &c->value))
        return false;
    c->is_share = r->at > begin && r->at[-1] == '%';
    return true;
}

/* ---- change and place: binding ---- */

/* Checks the unit of the typed value X. Decides whether X replaces the old value, is added to it or
 * multiplies it. */
static bool value_bind(const struct change_parsed *parsed, const struct quantity *value,
                       struct row_change *change, struct problem *problem)
{
    const char *name = row_measure_names(NULL, (int)change->measure),
               *unit = rowfile_kind.column[change->measure].unit;
    const struct quantity wanted = expression_unit(unit);
    const bool is_relative = parsed->has_sign && !parsed->is_set, is_bare = quantity_is_number(*value);
    change->value = value->value;
    change->is_angle =
        change->measure == MEASURE_LEAN && quantity_alike(*value, (struct quantity){.angle = 1});
    if (parsed->is_share && is_bare) {
        change->how = CHANGE_TIMES;
        change->value += is_relative;
        return true;
    }
    if (!is_bare && !change->is_angle && !quantity_alike(*value, wanted))
        return problem_error(problem, "the %s is %s, not %s; enter a value such as '%s'", name,
                             expression_kind(wanted), expression_kind(*value), expression_example(wanted));
    if (is_relative && is_bare)
        return problem_error(problem,
                             "a change of the %s by %s needs a unit, as in '%+.4g %s'; to change the %s by a "
                             "percentage, write a percent sign, as in '+10 %%'",
                             name, quad_text(value->value, 10), (double)value->value, unit, name);
    change->how = is_relative ? CHANGE_BY : CHANGE_TO;
    return true;
}

/* Stores the selected dominoes in given->bound. */
static struct row_change *dominoes_bind(const struct question *q, const struct query *query,
                                        struct arguments *given, struct problem *problem)
{
    const struct row_change *selected = ((const struct change_parsed *)q->parsed)->change;
    const size_t size = sizeof *selected + (size_t)selected->ranges * sizeof *selected->range;
    struct row_change *c = arguments_take(given, size, query, problem);
    if (c)
        memcpy(c, selected, size);
    return c;
}

bool change_bind(const struct question *q, const struct query *query, struct arguments *given,
                 struct problem *problem)
{
    const struct change_parsed *parsed = q->parsed;
    struct quantity value;
    domq_real number;
    struct row_change *c = dominoes_bind(q, query, given, problem);
    if (!c)
        return false;
    c->measure = q->count > 2 ? (enum row_measure)(int)given->number[1] : MEASURE_GAP;
    return item_bind(&parsed->value, q->text, query, &value, &number, problem) &&
           value_bind(parsed, &value, c, problem);
}

bool remove_bind(const struct question *q, const struct query *query, struct arguments *given,
                 struct problem *problem)
{
    return dominoes_bind(q, query, given, problem) != NULL;
}

/* Returns a measurement of a domino in m or kg. For a lean, this is how far the top is off plumb. If a domino
 * has no radius of its own, its radius is the radius of 'set edges'. */
static domq_real measure_now(const struct scene *scene, const struct domq_domino *domino,
                             enum row_measure measure)
{
    struct domq_domino d = *domino;
    return measure == MEASURE_LEAN                      ? lean_offset(&d)
           : measure == MEASURE_RADIUS && d.radius == 0 ? scene_edges(scene) * d.height
                                                        : *row_measure_at(&d, measure);
}

/* Computes the value that a measurement of domino k, counted from 0, has after a change. Stores the value in
 * *kept in the form of struct changed_domino: a mass as a factor, and a lean as an angle. If the domino
 * cannot have this value, sets *problem and returns false. */
static bool domino_change(const struct scene *scene, const struct row_change *change,
                          const struct scene_row *row, size_t k, domq_real *kept, struct problem *problem)
{
    const enum row_measure measure = change->measure;
    const bool is_lean = measure == MEASURE_LEAN, is_mass = measure == MEASURE_MASS;
    struct domq_domino d = row->domino[k], *domino = &d;
    domq_real *member = row_measure_at(domino, measure),
              now = is_lean && change->is_angle ? domino->lean : measure_now(scene, domino, measure),
              value = change->how == CHANGE_TO   ? change->value
                      : change->how == CHANGE_BY ? now + change->value
                                                 : now * change->value;
    const struct listed_row *listed = row_of(scene);
    const domq_real before = is_mass && listed && listed->changes > 0 ? listed->change[k].to.mass : DOMQ_NAN;
    char message[MISFIT_MESSAGE];
    if (!csv_fits(&rowfile_kind.column[measure], value, message))
        return problem_no_answer(problem, "domino %zu: %s", k + 1, message);
    if (is_lean && !change->is_angle)
        value = quad(asin)(quad_larger(quad_smaller(value / domino->height, 1), -1));
    if (row_measure_is_size(measure))
        domino->mass *= value / *member;
    *kept = !is_mass ? value : change->how == CHANGE_TIMES ? change->value : value / now;
    *kept *= isnan(before) ? 1 : before;
    *member = value;
    return (domino_misfit(domino, scene->train.alpha, message) == ROW_MEASURES &&
            csv_fits(&rowfile_kind.column[MEASURE_MASS], domino->mass, message)) ||
           problem_no_answer(problem, "domino %zu: %s", k + 1, message);
}

static bool is_selected(const struct row_change *change, size_t k)
{
    bool is_in = change->ranges == 0;
    for (int i = 0; i < change->ranges; i++)
        is_in = is_in || (change->range[i].first <= k && k <= change->range[i].last);
    return is_in;
}

/* Checks that all selected dominoes exist and, if `gaps` is true, that there is a gap before them. */
static bool dominoes_check(const struct row_change *change, size_t count, bool gaps, struct problem *problem)
{
    const size_t least = gaps ? 2 : 1;
    if (count < least)
        return problem_error(problem, "a row of one domino has no gap; enter 'set row N' with a larger N");
    for (int i = 0; i < change->ranges; i++) {
        const struct row_range *range = &change->range[i];
        const size_t wrong = range->first < least ? range->first : range->last;
        if (wrong >= least && wrong <= count)
            continue;
        return gaps ? problem_error(problem,
                                    "there is no gap before domino %zu; choose a domino from 2 to %zu", wrong,
                                    count)
                    : problem_error(problem, "there is no domino %zu; this row has %zu", wrong, count);
    }
    return true;
}

/* Gives the scene an edited row. */
static void edit_end(struct scene *scene, struct listed_row *next)
{
    slot_drop(scene->slot);
    scene->slot = &next->slot;
    scene_apply_lengths(scene);
}

/* ---- Change ---- */

/* Prints the old and the new measurement of the first domino that has changed, and the number of others. If
 * masses are not known, prints the factor by which the mass changes. */
static bool change_say(const struct query *query, struct answer *a, const struct row_change *change,
                       const struct scene_row *before, struct problem *problem)
{
    const enum row_measure measure = change->measure;
    const char *name = row_measure_names(NULL, (int)measure);
    struct scene_row after;
    size_t first = 0, changed = 0;
    char others[80] = "";
    if (!scene_row_list(&query->next->scene, &after, problem))
        return false;
    for (size_t k = after.row.count; k-- > (size_t)(measure == MEASURE_GAP);)
        if (is_selected(change, k + 1)) {
            first = k;
            changed++;
        }
    if (changed > 1)
        snprintf(others, sizeof others, "; %zu more changed, and 'row' lists all", changed - 1);
    const domq_real from = measure_now(query->scene, &before->domino[first], measure),
                    to = measure_now(&query->next->scene, &after.domino[first], measure);
    const struct measure unit =
        measure_of(rowfile_kind.column[measure].unit, quad_larger(quad(fabs)(from), quad(fabs)(to)));
    if (measure == MEASURE_MASS && !scene_has_masses(query->scene))
        answer_say(a, "domino %zu: mass %s times as large as before%s", first + 1,
                   quad_text(change->value, 6), others);
    else
        answer_say(a, "domino %zu: %s %s to %s %s%s", first + 1, name,
                   quad_text(measure_number(unit, from), 6), quad_text(measure_number(unit, to), 6),
                   unit.unit, others);
    if (measure == MEASURE_RADIUS && !query->next->scene.effect[DOM_EFFECT_edges].on)
        answer_say(a, "Radii have no effect until you enter 'set edges on'.");
    a->progress.wrote_text = true;
    free(after.domino);
    return true;
}

/* Changes one measurement of all selected dominoes. If the measurement is a size, the domino keeps its
 * density. */
bool run_change(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct row_change *change = query->given->bound;
    struct scene_row row;
    if (!query->next)
        return true;
    struct scene *scene = &query->next->scene;
    if (!scene_row_list(scene, &row, problem))
        return false;
    const bool gaps = change->measure == MEASURE_GAP;
    bool good = dominoes_check(change, row.row.count, gaps, problem);
    if (good && change->measure == MEASURE_MASS && change->how != CHANGE_TIMES && !scene_has_masses(scene))
        good = problem_error(problem, "the masses of this row are not known; enter the mass of its first "
                                      "domino with 'set mass', or a relative change such as '+10 %%'");
    struct listed_row *next = good ? row_edit(scene, problem) : NULL;
    good = next;
    for (size_t k = gaps; k < row.row.count && good; k++)
        if (is_selected(change, k + 1))
            good = domino_change(scene, change, &row, k, row_measure_at(&next->change[k].to, change->measure),
                                 problem) &&
                   (!dom_raised(scene->compute.interrupt) || problem_status(problem, scene, DOM_INTERRUPTED));
    if (good)
        edit_end(scene, next);
    else if (next)
        slot_drop(&next->slot);
    if (good && answer_for_people(a) && !query->run_context->sourced)
        good = change_say(query, a, change, &row, problem);
    free(row.domino);
    return good;
}

/* ---- Replace ---- */

/* The measurements of a domino that are lengths. The width is the last one. */
static const enum row_measure lengths[] = {MEASURE_GAP, MEASURE_HEIGHT, MEASURE_THICKNESS, MEASURE_RADIUS,
                                           MEASURE_WIDTH};
enum { LENGTHS = sizeof lengths / sizeof *lengths };

static bool is_near(domq_real a, domq_real b)
{
    return quad(fabs)(a - b) <= (domq_real)1e-12 * quad(fabs)(b);
}

/* Sets the sizes of a domino, or multiplies its mass so that its ratio to the first mass is that of `to`. */
static void domino_set(struct changed_domino *change, const struct domq_domino *now, struct domq_domino to,
                       bool sizes, domq_real masses)
{
    struct domq_domino from = *now;
    const domq_real times = to.mass / now->mass * masses;
    for (int i = 0; i < LENGTHS - !sizes && !(masses > 0); i++) {
        const domq_real value = *row_measure_at(&to, lengths[i]);
        if (!is_near(*row_measure_at(&from, lengths[i]), value))
            *row_measure_at(&change->to, lengths[i]) = value;
    }
    if (masses > 0 && !is_near(times, 1))
        change->to.mass = (isnan(change->to.mass) ? 1 : change->to.mass) * times;
}

bool scene_row_set(struct scene *scene, const struct domq_domino *to, size_t count, bool sizes,
                   struct problem *problem)
{
    bool good = true;
    /* A change of size also changes the mass, because a domino keeps its density. So masses come second. */
    for (int masses = 0; masses <= (int)sizes && good; masses++) {
        struct scene_row now;
        struct listed_row *next;
        if (!scene_row_list(scene, &now, problem))
            return false;
        next = row_edit(scene, problem);
        good = next;
        for (size_t k = 0; k < count && good; k++)
            domino_set(&next->change[k], &now.domino[k], to[k], sizes,
                       masses ? now.domino[0].mass / to[0].mass : 0);
        free(now.domino);
        if (good)
            edit_end(scene, next);
    }
    return good;
}

/* ---- Remove and insert ---- */

/* Removes the selected dominoes. The gaps before the other dominoes stay the same. */
bool run_remove(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct row_change *change = query->given->bound;
    struct listed_row *next;
    size_t kept = 0;
    if (!query->next)
        return true;
    struct scene *scene = &query->next->scene;
    const size_t count = scene_row_count(scene);
    if (count == 0)
        return problem_no_row(problem);
    if (!dominoes_check(change, count, false, problem) || !(next = row_edit(scene, problem)))
        return false;
    for (size_t k = 0; k < count; k++)
        if (!is_selected(change, k + 1))
            next->change[kept++] = next->change[k];
    next->changes = kept;
    next->change->to.gap = DOMQ_NAN;
    if (kept == 0) {
        slot_drop(&next->slot);
        return problem_error(problem, "a row has at least one domino; 'set row off' removes the row");
    }
    edit_end(scene, next);
    if (answer_for_people(a) && !query->run_context->sourced)
        answer_say(a, "%zu domino%s removed; the row has %zu.", count - kept, count - kept == 1 ? "" : "es",
                   kept);
    a->progress.wrote_text = answer_for_people(a);
    return true;
}

/* A names_list (see names.h) of the sizes that 'insert' sets. */
const char *insert_sizes(const void *context, int k)
{
    (void)context;
    return k == 0 ? "height" : NULL;
}

/* Multiplies all lengths of the domino *d, and its gap, by `times`. The density stays the same. If a value is
 * then not allowed, sets *problem and returns false. */
static bool domino_enlarge(struct changed_domino *change, struct domq_domino *d, domq_real times,
                           struct problem *problem)
{
    char message[MISFIT_MESSAGE];
    bool good = true;
    d->mass *= times * times * times;
    for (int i = 0; i < LENGTHS && good; i++) {
        domq_real *value = row_measure_at(d, lengths[i]);
        *value *= times;
        if (*value > 0) /* without a radius of its own, a domino has that of 'set edges' */
            *row_measure_at(&change->to, lengths[i]) = *value;
        good = csv_fits(&rowfile_kind.column[lengths[i]], *value, message);
    }
    return (good && csv_fits(&rowfile_kind.column[MEASURE_MASS], d->mass, message)) ||
           problem_no_answer(problem, "the new domino: %s", message);
}

/* Inserts a copy of the domino that has the number k, or of the last one. The copy gets this number and, if a
 * height is given, all its sizes and the gap before it in proportion. */
bool run_insert(const struct query *query, struct answer *a, struct problem *problem)
{
    const size_t most = (size_t)domq_effect(DOM_EFFECT_row)->argument[0].highest,
                 k = (size_t)query->given->number[0], at = k - 1;
    struct scene_row row;
    struct listed_row *next;
    if (query->given->count == 2)
        return problem_error(problem, "the height is missing; enter, for example, 'insert %zu height 30 cm'",
                             k);
    if (!query->next)
        return true;
    struct scene *scene = &query->next->scene;
    if (!scene_row_list(scene, &row, problem))
        return false;
    const size_t count = row.row.count, like = k <= count ? k - 1 : count - 1;
    struct domq_domino copied = row.domino[like];
    const domq_real times = query->given->count > 2 ? query->given->number[2] / copied.height : 1;
    /* A new second domino, or one that moves to the second place, has no gap of its own if it is a copy of
     * the first. It gets a gap in proportion to the next one. */
    const domq_real gap =
        row.domino->height * (count > 1 ? row.domino[1].gap / row.domino[1].height : scene->train.s);
    free(row.domino);
    if (k > count + 1)
        return problem_error(
            problem,
            "there is no place %zu in this row of %zu domino%s; 'insert %zu' adds one at its "
            "end",
            k, count, count == 1 ? "" : "es", count + 1);
    if (count >= most)
        return problem_error(problem, "a row has at most %zu dominoes", most);
    if (!(next = row_edit(scene, problem)))
        return false;
    struct changed_domino *const to = next->change; /* it has room for one more */
    memmove(&to[at + 1], &to[at], (count - at) * sizeof *to);
    to[at] = to[like];
    if (like == 0 && to[at].origin == 0)
        to[1].to.gap = at == 1 ? gap * times : gap;
    if (times != 1 && !domino_enlarge(&to[at], &copied, times, problem)) {
        slot_drop(&next->slot);
        return false;
    }
    to->to.gap = DOMQ_NAN;
    next->changes = count + 1;
    edit_end(scene, next);
    if (answer_for_people(a) && !query->run_context->sourced)
        answer_say(a, "domino %zu: %s tall and %s thick; the row has %zu.", k,
                   measured(copied.height, "m", 4).text, measured(copied.thickness, "m", 4).text, count + 1);
    a->progress.wrote_text = answer_for_people(a);
    return true;
}
