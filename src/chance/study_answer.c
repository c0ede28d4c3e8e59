/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a study of random rows and prints its answer. */
#include "chance/chance.h"
#include "language/text.h"
#include <stdlib.h>

const struct column placement_columns[] = {
    {"sigma", "m", "standard deviation of the errors in the gaps; for uniform errors, the largest error", 0},
    {"heights", "share",
     "standard deviation of relative errors in the heights; for uniform errors, the largest error", 0},
    {"rows", "", "the number of rows that were set up", 0},
    {"fall", "", "the number of rows that fall completely", 0},
    {"probability", "share", "fall / rows", 0},
    {"low", "share", "the lower end of the 95 % interval of the probability", 0},
    {"high", "share", "the upper end of the 95 % interval of the probability", 0},
    {"unknown", "", "the number of rows that the model cannot decide; they widen the interval", 0},
    {"stops_most", "", "the domino at which rows stop most often", 0},
    {"errors", "", "all errors of the rows, each with its size", 0},
    {"costs_most", "", "the error that makes the most rows fail, if there are several errors", 0},
    {"without", "share",
     "the share of the rows that would fall without the kind of error named in 'costs_most'", 0},
    {"stops_there", "", "the domino at which the kind of error named in 'costs_most' stops the most rows", 0},
    {NULL, NULL, NULL, 0},
};

size_t *study_stops(const struct study *study, int kind)
{
    return study->stops + ((size_t)kind + 1) * study->dominoes;
}

enum dom_status study_run_with_causes(const struct dom_row *row, const struct dom_compute *compute,
                                      const struct dom_placement *p, struct study *study)
{
    int on = 0;
    *study = (struct study){.sigma = p->error[DOM_ERROR_gap].size,
                            .heights = p->error[DOM_ERROR_height].size,
                            .dominoes = row->count};
    errors_text(p->error, false, study->errors);
    for (int k = 0; k < DOM_ERROR_COUNT; k++) {
        study->is_on[k] = p->error[k].size > 0;
        on += study->is_on[k];
    }
    study->causes = on > 1;
    study->stops = calloc((1 + DOM_ERROR_COUNT) * row->count, sizeof *study->stops);
    if (!study->stops)
        return DOM_NO_MEMORY;
    return study->causes ? dom_placement_causes(row, compute, p, &study->result, study->without, study->stops)
                         : dom_placement_study(row, compute, p, &study->result, study->stops);
}

/* Iterates over the positive numbers in number[0 .. count - 1], from the largest to the smallest. Each call
 * takes the index of the previous number and returns the index of the next one, or `count` at the end. In the
 * first call, `last` is `count`. */
static size_t most_next(const size_t *number, size_t count, size_t last)
{
    size_t next = count;
    for (size_t k = 0; k < count; k++) {
        bool is_after = last == count || number[k] < number[last] || (k > last && number[k] == number[last]);
        if (number[k] > 0 && is_after && (next == count || number[k] > number[next]))
            next = k;
    }
    return next;
}

/* Iterates over the kinds of error, from the most to the least harmful. The more rows would fall without a
 * kind of error, the more harmful it is. Each call takes the previous kind and returns the next one, or
 * DOM_ERROR_COUNT at the end. In the first call, `last` is DOM_ERROR_COUNT. */
static int cause_next(const struct study *s, int last)
{
    size_t cost[DOM_ERROR_COUNT]; /* 0 for a kind of error that is off */
    for (int k = 0; k < DOM_ERROR_COUNT; k++)
        cost[k] = s->causes && s->is_on[k] ? s->without[k] + 1 : 0;
    return (int)most_next(cost, DOM_ERROR_COUNT, (size_t)last);
}

/* Returns the domino at which this kind of error stops the most rows, or 0. */
static size_t cause_stops(const struct study *s, int kind)
{
    const size_t most = most_next(study_stops(s, kind), s->dominoes, s->dominoes);
    return most < s->dominoes ? most + 1 : 0;
}

/* Prints, for each kind of error, how many rows would fall without it. */
static void causes_say(struct answer *a, const struct study *s)
{
    const int worst = cause_next(s, DOM_ERROR_COUNT);
    char others[600] = "", stops[80] = "";
    if (worst == DOM_ERROR_COUNT)
        return;
    const bool is_plural = worst < DOM_ERROR_friction;
    const char *it = is_plural ? "them" : "it";
    const size_t domino = cause_stops(s, worst);
    for (int k = cause_next(s, worst); k < DOM_ERROR_COUNT; k = cause_next(s, k))
        text_add(others, sizeof others, *others ? "; without %s, %zu" : "Without %s, %zu would fall",
                 error_kinds[k].cause, s->without[k]);
    if (domino > 0)
        snprintf(stops, sizeof stops, "; because of %s, rows stop most often at domino %zu", it, domino);
    if (s->without[worst] > s->result.fall) {
        answer_say(a, "Of all errors, %s stop%s the most rows: without %s, %zu of %zu rows would fall.",
                   error_kinds[worst].cause, is_plural ? "" : "s", it, s->without[worst], s->result.rows);
        answer_detail(a, "%s%s%s.", others, *others ? "" : "No other error is on", stops);
    } else
        answer_detail(a, "Leaving out any single kind of error would not make more of these rows fall.");
}

void study_answer(struct answer *a, const struct study *s, const char *reason)
{
    enum { SHOWN = 2 };
    const struct dom_study *study = &s->result;
    const size_t count = s->dominoes, others = study->rows - study->fall - study->unknown,
                 most = most_next(s->stops, count, count);
    const int worst = cause_next(s, DOM_ERROR_COUNT);
    const bool costs = worst < DOM_ERROR_COUNT && s->without[worst] > study->fall;
    char text[200] = "";
    size_t k = most;
    for (int i = 0; i < SHOWN && k < count; i++, k = most_next(s->stops, count, k))
        text_add(text, sizeof text, "%s%zu (%.3g %%)", i ? ", " : "", k + 1,
                 100 * (double)s->stops[k] / (double)others);
    answer_say(a, "%zu of %zu rows fall. The probability is %s to %s, with 95 %% confidence.", study->fall,
               study->rows, measured((domq_real)study->low, "share", study->low > 0.99 ? 5 : 3).text,
               measured((domq_real)study->high, "share", study->high > 0.99 ? 5 : 3).text);
    if (*text)
        answer_say(a, "The other rows stop at domino %s.", text);
    const size_t there = costs ? cause_stops(s, worst) : 0;
    answer_row(a,
               ROW(cell_real((domq_real)s->sigma), cell_real((domq_real)s->heights),
                   cell_count((domq_real)study->rows), cell_count((domq_real)study->fall),
                   cell_computed((domq_real)study->fall / (domq_real)study->rows),
                   cell_computed((domq_real)study->low), cell_computed((domq_real)study->high),
                   cell_count((domq_real)study->unknown),
                   most < count ? cell_count((domq_real)most + 1) : cell_real(DOMQ_NAN), cell_word(s->errors),
                   cell_word(costs ? error_kinds[worst].name : ""),
                   costs ? cell_computed((domq_real)s->without[worst] / (domq_real)study->rows)
                         : cell_real(DOMQ_NAN),
                   there > 0 ? cell_count((domq_real)there) : cell_real(DOMQ_NAN)),
               reason);
    causes_say(a, s);
}
