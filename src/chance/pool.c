/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes a study of random rows in parts, for example on several computers. Each part writes counts for
 * blocks of 100 rows. The command 'pool' reads the blocks of all parts and adds the counts. It then prints
 * the answer that 'placement' would have printed for the whole study. */
#include "chance/chance.h"
#include "parallel/workers.h"
#include "tables/csv.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- Writing blocks ---- */

enum {
    BLOCK_ROWS = 100,
    STOPS_TEXT = BLOCK_ROWS * 16,
    WITHOUT_TEXT = DOM_ERROR_COUNT * (BLOCK_ROWS * 32 + 32)
};

static const struct column block_columns[] = {
    {"sigma", "m", "standard deviation of the errors in the gaps; for uniform errors, the largest error", 0},
    {"heights", "",
     "standard deviation of relative errors in the heights; for uniform errors, the largest error", 0},
    {"seed", "", "seed of the random rows", 0},
    {"scene", "", "checksum of the row and of everything that decides how it falls", 8},
    {"dominoes", "", "number of dominoes in the row", 8},
    {"of", "", "number of rows in the whole study", 8},
    {"first", "", "number of the first row of this block, from 1", 8},
    {"rows", "", "number of rows in this block", 4},
    {"fall", "", "number of rows in this block that fall completely", 4},
    {"unknown", "", "number of rows in this block that the model cannot decide", 7},
    {"stops", "", "each domino at which rows stop, with the number of rows that stop there", 20},
    {"errors", "", "the errors of the rows", 20},
    {"without", "", "for each error: how many rows fall without the error, and where they stop with it", 20},
    {NULL, NULL, NULL, 0},
};

/* Adds numbers to a checksum (FNV-1a of Fowler, Noll and Vo). */
static void checksum_add(uint32_t *sum, const void *numbers, size_t size)
{
    const unsigned char *bytes = numbers;
    for (size_t i = 0; i < size; i++)
        *sum = (*sum ^ bytes[i]) * 16777619u;
}

static uint32_t row_checksum(const struct double_row *made)
{
    const struct dom_row *row = &made->row;
    uint32_t sum = 2166136261u;
#define VALUE(name, member, status) row->member,
    const double all[] = {row->g,
                          row->boxes_above,
                          isnan(row->push) ? -1 : row->push,
                          row->release,
                          DOM_DYNAMICS(VALUE) made->compute.tol,
                          IN_DOUBLE};
#undef VALUE
    checksum_add(&sum, all, sizeof all);
    if (row->engine) {
        const struct scene_engine *engine = row->engine->context;
        checksum_add(&sum, (const double[]){engine->feet, engine->bounce}, 2 * sizeof(double));
    }
    checksum_add(&sum, row->domino, row->count * sizeof *row->domino);
    return sum;
}

/* The data of a worker thread. The copies of different workers differ only in `status`. */
struct blocks {
    const struct double_row *row;
    const struct dom_placement *placement; /* the parameters of the whole study */
    char checksum[16];
    struct answer answer;
    enum dom_status status;
};

/* Writes how many rows stop at each domino. For example, "5:12 6:3" means that 12 rows stop at domino 5, and
 * 3 rows at domino 6. Each entry begins with the prefix. Returns the length of the text. */
static int stops_text(const size_t *stops, size_t count, const char *prefix, char *text, int size)
{
    int n = 0;
    text[0] = '\0';
    for (size_t k = 0; k < count; k++)
        if (stops[k] > 0)
            n += snprintf(text + n, (size_t)(size - n), "%s%s%zu:%zu", n ? " " : "", prefix, k + 1, stops[k]);
    return n;
}

/* Writes how many rows fall if one kind of error is left out. For example, "gap:98 gap@5:1" means: without
 * errors in the gaps, 98 rows fall. With these errors, 1 of the 98 rows stops at domino 5. */
static void without_text(const struct study *study, char text[WITHOUT_TEXT])
{
    text[0] = '\0';
    for (int k = 0, n = 0; k < DOM_ERROR_COUNT && study->causes; k++) {
        char prefix[32];
        if (!study->is_on[k])
            continue;
        snprintf(prefix, sizeof prefix, " %s@", error_kinds[k].name);
        n += snprintf(text + n, (size_t)(WITHOUT_TEXT - n), "%s%s:%zu", n ? " " : "", error_kinds[k].name,
                      study->without[k]);
        n += stops_text(study_stops(study, k), study->dominoes, prefix, text + n, WITHOUT_TEXT - n);
    }
}

static bool block_write(void *context, size_t block, FILE *out)
{
    struct blocks *b = context;
    const size_t all = b->placement->rows;
    struct dom_placement p = *b->placement;
    struct study study;
    char stops[STOPS_TEXT], errors[ERRORS_TEXT], *without = malloc(WITHOUT_TEXT);
    p.first = block * BLOCK_ROWS;
    p.rows = all - p.first < BLOCK_ROWS ? all - p.first : BLOCK_ROWS;
    p.parallel = NULL; /* the rows of a block use one thread, because blocks are computed in parallel */
    b->status = study_run_with_causes(&b->row->row, &b->row->compute, &p, &study);
    if (!without)
        b->status = DOM_NO_MEMORY;
    if (b->status == DOM_OK) {
        struct answer a = answer_part(&b->answer, out, block);
        stops_text(study.stops, study.dominoes, "", stops, STOPS_TEXT);
        without_text(&study, without);
        answer_cells(&a, cell_real((domq_real)study.sigma), cell_real((domq_real)study.heights),
                     cell_count((domq_real)p.seed), cell_word(b->checksum),
                     cell_count((domq_real)study.dominoes), cell_count((domq_real)all),
                     cell_count((domq_real)p.first + 1), cell_count((domq_real)p.rows),
                     cell_count((domq_real)study.result.fall), cell_count((domq_real)study.result.unknown),
                     cell_word(stops), cell_word(errors_text(p.error, false, errors)), cell_word(without));
    }
    free(study.stops);
    free(without);
    return b->status == DOM_OK;
}

bool study_blocks(const struct query *query, struct answer *a, struct problem *problem,
                  const struct double_row *row, const struct dom_placement *placement)
{
    struct blocks b = {.row = row, .placement = placement};
    bool by_point;
    snprintf(b.checksum, sizeof b.checksum, "x%08x", (unsigned)row_checksum(row));
    a->columns = block_columns;
    a->rows = true;
    a->style.errors = false; /* counts are exact and have no errors */
    answer_plan(a, NULL);
    b.answer = *a;
    const struct workers workers = {.points = (placement->rows + BLOCK_ROWS - 1) / BLOCK_ROWS,
                                    .point = block_write,
                                    .context = &b,
                                    .size = sizeof b};
    return points_answer(query, problem, a, workers, &by_point) ||
           (by_point && row_status(query, problem, b.status));
}

/* ---- Reading blocks ---- */

enum {
    SIGMA,
    HEIGHTS,
    SEED,
    SCENE,
    DOMINOES,
    OF,
    FIRST,
    ROWS,
    FALL,
    UNKNOWN,
    STOPS,
    ERRORS,
    WITHOUT,
    FIELDS
};

_Static_assert((int)FIELDS <= (int)CSV_COLUMNS_MOST,
               "a csv table must have room for every column of a block");

#define BLOCKS "'domino --shard I/N' with 'set output csv' writes blocks of a study"
#define NUMBER CSV_REQUIRED, "", "none", "", BLOCKS, 0
#define COUNT  CSV_REQUIRED | CSV_WHOLE, "", "none", "", BLOCKS
#define TEXT   CSV_REQUIRED, NULL, NULL, NULL, BLOCKS, 0, 0, NULL

static const struct csv_column pool_columns[FIELDS] = {
    {"sigma", NUMBER, 1e9, "0 .. 1e9 m"},
    {"heights", NUMBER, 1, "0 .. 1"},
    {"seed", NUMBER, 1e38, "0 .. 1e38"},
    {"scene", TEXT},
    {"dominoes", COUNT, 1, COUNT_MAX, "1 .. 10000000"},
    {"of", COUNT, 1, COUNT_MAX, "1 .. 10000000"},
    {"first", COUNT, 1, COUNT_MAX, "1 .. 10000000"},
    {"rows", COUNT, 1, BLOCK_ROWS, "1 .. 100"},
    {"fall", COUNT, 0, BLOCK_ROWS, "0 .. 100"},
    {"unknown", COUNT, 0, BLOCK_ROWS, "0 .. 100"},
    {"stops", TEXT},
    {"errors", TEXT},
    {"without", TEXT},
};

static const struct csv_kind pool_kind = {
    .column = pool_columns,
    .columns = FIELDS,
    .rows_most = COUNT_MAX,
    .item = "block",
    .items = "blocks of a study",
    .names = "sigma, heights, seed, scene, dominoes, of, first, rows, fall, unknown, stops, errors, "
             "without: " BLOCKS,
};

struct pool {
    domq_real common[FIRST]; /* the values that must be the same in all blocks of a study */
    const char *checksum, *errors;
    struct study study;
    bool *seen; /* for each row of the study, whether it was in a block */
};

static bool pool_begin(struct pool *p, struct csv_table *csv)
{
    memcpy(p->common, csv->value, sizeof p->common);
    p->checksum = csv_cell(csv, SCENE).text;
    p->errors = csv_cell(csv, ERRORS).text;
    p->study = (struct study){.sigma = (double)p->common[SIGMA],
                              .heights = (double)p->common[HEIGHTS],
                              .dominoes = (size_t)csv->value[DOMINOES]};
    snprintf(p->study.errors, sizeof p->study.errors, "%s", p->errors);
    p->study.stops = calloc((1 + DOM_ERROR_COUNT) * p->study.dominoes, sizeof *p->study.stops);
    p->seen = calloc((size_t)csv->value[OF], sizeof *p->seen);
    return (p->study.stops && p->seen) || csv_wrong(&csv->file, csv->row.at, "out of memory");
}

/* Parses an entry DOMINO:COUNT, such as "5:12", and adds COUNT to the rows that stop at DOMINO. Moves *text
 * past the entry. Returns COUNT, or 0 if the entry is wrong. */
static size_t stop_add(const char **text, size_t *stops, size_t dominoes)
{
    unsigned long domino, count;
    int length;
    if (sscanf(*text, "%lu:%lu%n", &domino, &count, &length) != 2 || domino == 0 || domino > dominoes ||
        count > BLOCK_ROWS)
        return 0;
    stops[domino - 1] += count;
    *text += length + (int)strspn(*text + length, " ");
    return count;
}

/* Parses a string written by stops_text and adds its counts to p->study.stops. *sum receives their total. */
static bool stops_add(struct pool *p, const char *text, size_t *sum)
{
    for (*sum = 0; *text;) {
        const size_t count = stop_add(&text, p->study.stops, p->study.dominoes);
        if (count == 0)
            return false;
        *sum += count;
    }
    return true;
}

/* Parses a string written by without_text and adds its counts to p->study. */
static bool without_add(struct pool *p, const char *text)
{
    struct study *study = &p->study;
    while (*text) {
        char name[16], mark;
        int length;
        unsigned long count;
        const int kind = sscanf(text, "%15[a-z]%c%n", name, &mark, &length) == 2
                             ? names_exact(error_names, NULL, name)
                             : -1;
        if (kind < 0 || kind >= DOM_ERROR_COUNT)
            return false;
        text += length;
        if (mark == '@') {
            if (stop_add(&text, study_stops(study, kind), study->dominoes) == 0)
                return false;
            continue;
        }
        if (mark != ':' || sscanf(text, "%lu%n", &count, &length) != 1 || count > BLOCK_ROWS)
            return false;
        study->without[kind] += count;
        study->is_on[kind] = study->causes = true;
        text += length + (int)strspn(text + length, " ");
    }
    return true;
}

static bool block_add(struct pool *p, struct csv_table *csv)
{
    const domq_real *value = csv->value;
    if (!p->study.stops && !pool_begin(p, csv))
        return false;
    bool same = strcmp(csv_cell(csv, SCENE).text, p->checksum) == 0 &&
                strcmp(csv_cell(csv, ERRORS).text, p->errors) == 0;
    for (int k = 0; k < FIRST; k++)
        same = same && (k == SCENE || value[k] == p->common[k]);
    if (!same)
        return csv_wrong(
            &csv->file, csv->row.at,
            "this block belongs to another study: it differs in errors, seed, row or number of rows");
    size_t first = (size_t)value[FIRST], rows = (size_t)value[ROWS], fall = (size_t)value[FALL],
           unknown = (size_t)value[UNKNOWN], stopped;
    if (first + rows - 1 > (size_t)value[OF] || !stops_add(p, csv_cell(csv, STOPS).text, &stopped) ||
        !without_add(p, csv_cell(csv, WITHOUT).text) || fall + unknown + stopped != rows)
        return csv_wrong(&csv->file, csv->row.at,
                         "the counts of this block do not add up to its number of rows");
    p->study.result.rows += rows;
    p->study.result.fall += fall;
    p->study.result.unknown += unknown;
    for (size_t i = first - 1; i < first - 1 + rows; i++) {
        if (p->seen[i])
            return csv_wrong(&csv->file, csv->row.at,
                             "row %zu of the study is in the file twice; include each part of the study "
                             "only once",
                             i + 1);
        p->seen[i] = true;
    }
    return true;
}

bool run_pool(const struct query *query, struct answer *a, struct problem *problem)
{
    char missing[128] = "";
    struct pool p = {.seen = NULL};
    struct csv_table *csv =
        csv_named(query->scene, query->run_context, query->given->word[0], true, &pool_kind, problem);
    while (csv && csv_next(csv) && block_add(&p, csv))
        ;
    const bool good = csv_end(csv, problem) && p.seen;
    const size_t all = (size_t)p.common[OF], rows = p.study.result.rows;
    size_t first = 0;
    while (good && rows < all && p.seen[first])
        first++;
    if (good && rows < all)
        snprintf(missing, sizeof missing,
                 "%zu of the %zu rows are missing; the first missing row is number %zu", all - rows, all,
                 first + 1);
    enum dom_status status = good ? dom_study_interval(&p.study.result) : DOM_OK;
    if (good && status == DOM_OK)
        study_answer(a, &p.study, *missing ? missing : NULL);
    free(p.study.stops);
    free(p.seen);
    return good && query_status(query, problem, status);
}
