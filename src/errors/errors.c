/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The errors of an answer. If 'errors' is on, an answer is computed twice: as the session asks, and with the
 * digits of quad precision. The error of a number is the difference, plus the rounding error of the number,
 * plus the uncertainty that the search for it has left (cell_uncertain). This is not a proof: if both
 * computations make the same mistake, the difference does not show it.
 */
#include "interpreter/question.h"
#include <stdlib.h>

/* The rows of the same answer in quad precision. */
struct reference {
    struct cell *cell; /* the cells of all rows */
    size_t columns;    /* the number of cells in a row */
    size_t rows, room;
    size_t compared; /* the number of rows to which the answer has been compared */
    /* True if nothing can be compared with these rows: the computation failed, or a part of it has only one
     * precision. */
    bool is_void;
};

/* Adds a row of the answer in quad precision. */
static void reference_add(const struct answer *a, struct cell *cells, size_t columns)
{
    struct reference *r = a->errors.context;
    if (r->rows == 0)
        r->columns = columns;
    if (r->rows == r->room && !r->is_void) {
        const size_t room = r->room ? 2 * r->room : 4;
        void *all = realloc(r->cell, room * r->columns * sizeof *r->cell);
        r->cell = all ? all : r->cell;
        r->room = all ? room : r->room;
        r->is_void = !all;
    }
    if (r->is_void || columns != r->columns) {
        r->is_void = true;
        return;
    }
    struct cell *row = r->cell + r->columns * r->rows++;
    memcpy(row, cells, columns * sizeof *cells);
    for (size_t i = 0; i < columns; i++)
        if (row[i].kind == CELL_WORD) { /* the word may be gone when it is compared */
            row[i].word = strdup(row[i].word);
            r->is_void = r->is_void || !row[i].word;
        }
}

static void reference_free(const struct reference *r)
{
    for (size_t i = 0; i < r->rows * r->columns; i++)
        if (r->cell[i].kind == CELL_WORD)
            free((char *)r->cell[i].word);
    free(r->cell);
}

/* Returns true if the two rows come to the same conclusions. */
static bool rows_agree(const struct cell *a, const struct cell *b, size_t columns)
{
    for (size_t i = 0; i < columns; i++) {
        if (a[i].kind == CELL_WORD && b[i].kind == CELL_WORD && strcmp(a[i].word, b[i].word) != 0)
            return false;
        const bool is_conclusion = a[i].kind == CELL_COUNT || a[i].kind == CELL_FLAG;
        if (is_conclusion && a[i].kind == b[i].kind && a[i].number != b[i].number)
            return false;
    }
    return true;
}

/* Sets the errors of the numbers in the next row of the answer. If a word, a count or a yes-or-no cell of
 * this row differs from the reference, no error of the row is known: the two computations have come to
 * different conclusions. */
static void reference_compare(const struct answer *a, struct cell *cells, size_t columns)
{
    struct reference *r = a->errors.context;
    const domq_real rounding = (domq_real)any_arithmetic(a->style.precision).epsilon;
    const bool has_row = !r->is_void && r->compared < r->rows && columns == r->columns;
    const struct cell *exact = has_row ? r->cell + r->columns * r->compared : NULL;
    r->compared++;
    if (exact && !rows_agree(cells, exact, columns))
        exact = NULL;
    for (size_t i = 0; i < columns; i++) {
        struct cell *cell = &cells[i];
        const bool is_unknown = !exact || exact[i].kind != CELL_REAL;
        const domq_real difference = is_unknown ? DOMQ_NAN : quad(fabs)(cell->number - exact[i].number);
        const bool shows_none = !cell->computed && (isnan(cell->error) || !(difference > 0));
        if (cell->kind != CELL_REAL || shows_none)
            continue;
        const domq_real uncertainty = isnan(cell->error) ? 0 : cell->error;
        cell->error = difference + rounding * quad(fabs)(cell->number) + uncertainty;
    }
}

/* Takes a row (answer.h, sink) and writes nothing. */
static void row_drop(struct answer *answer, const struct cell *cells, const char *reason)
{
    (void)answer, (void)cells, (void)reason;
}

/* Computes an answer in quad precision. */
static void reference_compute(const struct command *c, const struct query *query, const struct answer *answer,
                              struct reference *reference)
{
    struct state state;
    struct query exact;
    struct problem ignored;
    struct domq_angles angles;
    struct arguments given = *query->given;
    struct answer a = *answer;
    const struct domq_arithmetic quad = any_arithmetic(IN_QUAD);
    problem_begin(&ignored, c->name);
    reference->is_void = quad.bits == 0 || !query_with(query, NULL, 0, &state, &exact, &ignored);
    if (reference->is_void)
        return;
    /* If the session computes in quad precision, too, the reference must have another tolerance, so that the
     * sums and the iterations end elsewhere. */
    struct any_compute *compute = &state.scene.compute;
    compute->tol = compute->precision != IN_QUAD || compute->tol > 100 * quad.tol_default ? quad.tol_default
                   : compute->tol >= 100 * quad.tol_floor                                 ? compute->tol / 100
                                                          : compute->tol * 100;
    compute->precision = IN_QUAD;
    state.settings.style.errors = 0;
    state.settings.threads = 1; /* the rows come in order */
    /* A tilt that the session has rounded up to theta_c must not exceed theta_c in quad precision. */
    for (int i = 0; i < given.count; i++) {
        const enum argument_kind kind = c->argument[i].kind;
        if ((kind == ARGUMENT_TILT || kind == ARGUMENT_PLACE) &&
            any_angles_find(&state.scene.train, compute, &angles) == DOM_OK)
            given.number[i] = quad_smaller(given.number[i], angles.theta_c);
    }
    exact.given = &given;
    exact.reference = reference;
    a.sink.take = row_drop;
    a.errors.see = reference_add;
    a.errors.context = reference;
    a.details.brief = NULL;
    a.details.rest = NULL;
    a.kept = NULL;
    a.style.errors = 0;
    reference->is_void = !c->run(&exact, &a, &ignored) || reference->is_void;
}

static bool compute(const struct command *c, const struct query *query, struct answer *answer,
                    struct problem *problem)
{
    /* The engine computes in double precision only. */
    const bool has_errors = c->precision == PRECISION_AS_SET && (c->train || !scene_engine(query->scene));
    if (query->reference && !(has_errors && query->scene->compute.precision == IN_QUAD))
        query->reference->is_void = true;
    if (!has_errors || !query->state->settings.style.errors || (!answer->out && !answer->sink.take))
        return command_answer(c, query, answer, problem);
    struct reference reference = {.is_void = false};
    reference_compute(c, query, answer, &reference);
    answer->errors.see = reference_compare;
    answer->errors.context = &reference;
    const bool done = command_answer(c, query, answer, problem);
    answer->errors.see = NULL;
    reference_free(&reference);
    return done;
}

static const struct parameter errors = {
    .name = "errors",
    .offset = offsetof(struct state, settings.style.errors),
    .meaning = "whether each number is followed by its difference from a computation with 30 digits",
    .value = (const struct domq_effect_argument[]){{.name = "errors", .unit = ""}},
    .synonyms = "accuracy uncertainty precision difference",
    .words = (const struct word[]){{"off", 0}, {"on", 1}, {NULL, 0}},
    .words_only = true,
    .setting = true,
    .help =
        "Each answer is computed a second time, with 30 digits. A number in a table is then followed by +/- "
        "and its error, and an answer in words has its table, too. The error is the difference between the "
        "two computations, plus the rounding error of the number and the digits that are not printed. This "
        "is no"
        " proof: a mistake that both computations make does not show. No error is shown if the two come to "
        "different conclusions, and where only double precision is available, as in studies of many rows. "
        "While errors are on, 'digits' affects only numbers without an error. In csv and json the error has "
        "a column or key of its own, named KEY_error."};

const struct feature errors_feature = {
    .name = "errors", .parameters = (const struct parameter *const[]){&errors, NULL}, .compute = compute};
