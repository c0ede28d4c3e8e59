/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A study of placement in parts.  The results of random rows are counts, which can be added: each part writes
 * counts for blocks of fixed row numbers, which do not depend on the number of parts.  'pool' reads all
 * blocks and gives the answer of 'placement'.
 */
#include "commands/rows/falling.h"
#include "commands/tables.h"
#include "interpreter/line.h"
#include "parallel/points.h"
#include "session/open_csv.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK_ROWS = 100 };

static const struct column block_columns[] = {
    {"sigma", "m", "standard deviation of every gap", 0},
    {"heights", "", "relative standard deviation of every height", 0},
    {"seed", "", "seed of the random rows", 0},
    {"scene", "", "checksum of the row and of all that decides how it falls", 8},
    {"dominoes", "", "number of dominoes in the row", 8},
    {"of", "", "number of rows in the whole study", 8},
    {"first", "", "number of the first row of this block, from 1", 8},
    {"rows", "", "number of rows in this block", 4},
    {"fall", "", "number of them that fall completely", 4},
    {"unknown", "", "number of them that the model cannot follow", 7},
    {"stops", "", "the others: domino at which they stop, and how many", 20},
    {NULL, NULL, NULL, 0},
};

/* ---- The answer ---- */

const struct column placement_columns[] = {
    {"sigma", "m", "standard deviation of every gap", 0},
    {"heights", "share", "relative standard deviation of every height", 0},
    {"rows", "", "number of rows that were set up", 0},
    {"fall", "", "number of them that fall completely", 0},
    {"probability", "share", "fall / rows", 0},
    {"low", "share", "95 % interval of the probability, from here ...", 0},
    {"high", "share", "... to here", 0},
    {"unknown", "", "rows that the model cannot follow; they widen the interval", 0},
    {"stops_most", "", "the domino at which most of the others stop", 0},
    {NULL, NULL, NULL, 0},
};

/* Prints where rows stop, the most frequent first. Returns the most frequent domino, or 0. */
static size_t stops_say(struct answer *a, const size_t *stops, size_t count, size_t others)
{
    enum { SHOWN = 5 };
    size_t first = 0;
    char text[200];
    int n = 0;
    bool *said = calloc(count, sizeof *said); /* without it the sentence is missing, which is not an error */
    for (size_t k = 0; k < count; k++)
        if (stops[k] > 0 && (first == 0 || stops[k] > stops[first - 1]))
            first = k + 1;
    for (int i = 0; said && i < SHOWN; i++) {
        size_t most = count;
        for (size_t k = 0; k < count; k++)
            if (!said[k] && stops[k] > 0 && (most == count || stops[k] > stops[most]))
                most = k;
        if (most == count)
            break;
        said[most] = true;
        n += snprintf(text + n, sizeof text - (size_t)n, "%s%zu (%.3g %%)", n ? ", " : "", most + 1,
                      100 * (double)stops[most] / (double)others);
    }
    if (n > 0)
        answer_say(a, "The others stop at domino %s.", text);
    free(said);
    return first;
}

void study_answer(struct answer *a, domq_real sigma, domq_real heights, const struct domq_study *study,
                  const size_t *stops, size_t count, const char *reason)
{
    size_t others = study->rows - study->fall - study->unknown;
    answer_say(a, "%zu of %zu rows fall. The probability is %s to %s, with 95 %% confidence.", study->fall,
               study->rows, measured((domq_real)study->low, "share", study->low > 0.99 ? 5 : 3).text,
               measured((domq_real)study->high, "share", study->high > 0.99 ? 5 : 3).text);
    size_t most = stops_say(a, stops, count, others);
    answer_row(a,
               ROW(cell_real(sigma), cell_real(heights), cell_count((domq_real)study->rows),
                   cell_count((domq_real)study->fall),
                   cell_bound((domq_real)study->fall / (domq_real)study->rows, DOMQ_NAN),
                   cell_bound((domq_real)study->low, DOMQ_NAN), cell_bound((domq_real)study->high, DOMQ_NAN),
                   cell_count((domq_real)study->unknown),
                   most ? cell_count((domq_real)most) : cell_real(DOMQ_NAN)),
               reason);
}

/* ---- Blocks ---- */

/* Adds a value to a checksum (FNV-1a of Fowler, Noll, Vo), which differs for studies of different rows. */
static void checksum_add(uint32_t *sum, domq_real value)
{
    unsigned char bytes[sizeof(double)];
    double near = (double)value;
    memcpy(bytes, &near, sizeof bytes);
    for (size_t i = 0; i < sizeof bytes; i++)
        *sum = (*sum ^ bytes[i]) * 16777619u;
}

static uint32_t scene_checksum(const struct domq_row *row, const struct domq_compute *compute)
{
    uint32_t sum = 2166136261u;
#define VALUE(name, member, status) row->member,
    const domq_real all[] = {row->g, isnan(row->push) ? -1 : row->push, DOM_DYNAMICS(VALUE) compute->tol,
                             (domq_real)compute->precision};
#undef VALUE
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        checksum_add(&sum, all[i]);
    for (size_t k = 0; k < row->count; k++) {
        checksum_add(&sum, row->domino[k].height);
        checksum_add(&sum, row->domino[k].thickness);
        checksum_add(&sum, row->domino[k].gap);
        checksum_add(&sum, row->domino[k].mass);
    }
    return sum;
}

/* The data of a worker; the first six members are the same for all. */
struct blocks {
    const struct domq_row *row;
    const struct domq_compute *compute;
    const struct domq_placement *placement; /* the whole study */
    char scene[16];
    const struct column *columns;
    struct answer answer;
    enum dom_status status;
};

/* Writes where rows stop, and how many: "5:12 6:3". */
static void stops_text(const size_t *stops, size_t count, char text[BLOCK_ROWS * 16])
{
    int n = 0;
    text[0] = '\0';
    for (size_t k = 0; k < count; k++)
        if (stops[k] > 0)
            n +=
                snprintf(text + n, (size_t)(BLOCK_ROWS * 16 - n), "%s%zu:%zu", n ? " " : "", k + 1, stops[k]);
}

static bool block_point(void *own, size_t block, FILE *out)
{
    struct blocks *b = own;
    struct domq_study study;
    struct domq_placement p = *b->placement;
    char text[BLOCK_ROWS * 16];
    size_t *stops = calloc(b->row->count, sizeof *stops), all = p.rows;
    p.first = block * BLOCK_ROWS;
    p.rows = all - p.first < BLOCK_ROWS ? all - p.first : BLOCK_ROWS;
    p.parallel = NULL; /* the blocks run in parallel already */
    b->status = stops ? domq_placement_study(b->row, b->compute, &p, &study, stops) : DOM_NO_MEMORY;
    if (b->status == DOM_OK) {
        struct answer a = answer_part(&b->answer, out, block == 0);
        stops_text(stops, b->row->count, text);
        answer_cells(&a, cell_real(p.sigma), cell_real(p.heights), cell_count((domq_real)p.seed),
                     cell_word(b->scene), cell_count((domq_real)b->row->count), cell_count((domq_real)all),
                     cell_count((domq_real)p.first + 1), cell_count((domq_real)p.rows),
                     cell_count((domq_real)study.fall), cell_count((domq_real)study.unknown),
                     cell_word(text));
    }
    free(stops);
    return b->status == DOM_OK;
}

bool study_blocks(const struct query *query, struct answer *a, struct problem *problem,
                  const struct scene_row *scene, const struct domq_placement *placement)
{
    struct blocks b = {.row = &scene->row, .compute = &scene->compute, .placement = placement};
    bool by_point;
    snprintf(b.scene, sizeof b.scene, "x%08x", (unsigned)scene_checksum(&scene->row, &scene->compute));
    a->columns = block_columns;
    a->rows = true;
    a->style.errors = false; /* counts have no errors */
    answer_plan(a, NULL);
    b.answer = *a;
    const struct points points = {.total = (placement->rows + BLOCK_ROWS - 1) / BLOCK_ROWS,
                                  .point = block_point,
                                  .own = &b,
                                  .size = sizeof b};
    return points_answer(query, problem, a, &points, &by_point) ||
           (by_point && row_status(query, problem, b.status));
}

/* ---- Pooling ---- */

enum { SIGMA, HEIGHTS, SEED, SCENE, DOMINOES, OF, FIRST, ROWS, FALL, UNKNOWN, STOPS, FIELDS };

#define BLOCKS "'domino --shard I/N' with 'set output csv' writes blocks of a study"
#define NUMBER CSV_REQUIRED, "", "none", "", BLOCKS, 0
#define COUNT  CSV_REQUIRED | CSV_WHOLE, "", "none", "", BLOCKS
#define TEXT   CSV_REQUIRED, NULL, NULL, NULL, BLOCKS, 0, 0, NULL

static const struct csv_column pool_columns[FIELDS] = {
    {"sigma", NULL, NUMBER, 1e9, "0 or more, up to 1e9 m"},
    {"heights", NULL, NUMBER, 1, "0 .. 1"},
    {"seed", NULL, NUMBER, 1e38, "0 or more, up to 1e38"},
    {"scene", NULL, TEXT},
    {"dominoes", NULL, COUNT, 1, COUNT_MAX, "1 .. 10000000"},
    {"of", NULL, COUNT, 1, COUNT_MAX, "1 .. 10000000"},
    {"first", NULL, COUNT, 1, COUNT_MAX, "1 .. 10000000"},
    {"rows", NULL, COUNT, 1, BLOCK_ROWS, "1 .. 100"},
    {"fall", NULL, COUNT, 0, BLOCK_ROWS, "0 .. 100"},
    {"unknown", NULL, COUNT, 0, BLOCK_ROWS, "0 .. 100"},
    {"stops", NULL, TEXT},
};

static const struct csv_kind pool_kind = {
    .column = pool_columns,
    .columns = FIELDS,
    .headless = true, /* parts may be sorted */
    .rows_most = COUNT_MAX,
    .item = "block",
    .items = "blocks of a study",
    .names = "sigma, heights, seed, scene, dominoes, of, first, rows, fall, unknown, stops: " BLOCKS,
};

struct part {
    size_t first, rows;
    struct csv_place at;
};

struct pool {
    domq_real common[FIRST]; /* the numbers of the study, from its first block */
    const char *scene;
    struct domq_study study;
    size_t of, dominoes, *stops;
    struct part *part;
    size_t parts;
};

static bool study_begin(struct pool *p, struct csv_table *csv)
{
    memcpy(p->common, csv->value, sizeof p->common);
    p->scene = csv_cell(csv, SCENE).text;
    p->of = (size_t)csv->value[OF];
    p->dominoes = (size_t)csv->value[DOMINOES];
    p->stops = calloc(p->dominoes, sizeof *p->stops);
    return p->stops || csv_wrong(&csv->file, csv->row.at, "out of memory");
}

/* Adds the counts of "5:12 6:3", and writes their sum. */
static bool stops_add(struct pool *p, const char *text, size_t *sum)
{
    for (*sum = 0; *text;) {
        unsigned long domino, count;
        int length;
        if (sscanf(text, "%lu:%lu%n", &domino, &count, &length) != 2 || domino == 0 || domino > p->dominoes ||
            count > BLOCK_ROWS)
            return false;
        p->stops[domino - 1] += count;
        *sum += count;
        text += length;
    }
    return true;
}

static bool block_add(struct pool *p, struct csv_table *csv)
{
    const domq_real *value = csv->value;
    bool same = p->stops || study_begin(p, csv);
    if (!same)
        return false;
    for (int k = 0; k < FIRST; k++)
        same = same && (k == SCENE ? strcmp(csv_cell(csv, k).text, p->scene) == 0 : value[k] == p->common[k]);
    if (!same)
        return csv_wrong(
            &csv->file, csv->row.at,
            "this block is of another study: sigma, heights, seed, row or number of rows differ");
    size_t first = (size_t)value[FIRST], rows = (size_t)value[ROWS], fall = (size_t)value[FALL],
           unknown = (size_t)value[UNKNOWN], stopped;
    if (first + rows - 1 > p->of || !stops_add(p, csv_cell(csv, STOPS).text, &stopped) ||
        fall + unknown + stopped != rows)
        return csv_wrong(&csv->file, csv->row.at,
                         "the counts of this block do not add up to its number of rows");
    p->study.rows += rows;
    p->study.fall += fall;
    p->study.unknown += unknown;
    struct part *more = realloc(p->part, (p->parts + 1) * sizeof *more);
    if (!more)
        return csv_wrong(&csv->file, csv->row.at, "out of memory");
    p->part = more;
    p->part[p->parts++] = (struct part){first, rows, csv->row.at};
    return true;
}

static int by_first(const void *a, const void *b)
{
    const struct part *x = a, *y = b;
    return x->first < y->first ? -1 : x->first > y->first;
}

/* Writes which rows are missing, "" for none.  Returns false if a row is there twice. */
static bool parts_check(struct pool *p, struct csv_table *csv, char *missing, size_t size)
{
    size_t next = 1;
    missing[0] = '\0';
    qsort(p->part, p->parts, sizeof *p->part, by_first);
    for (size_t i = 0; i <= p->parts; i++) {
        size_t first = i < p->parts ? p->part[i].first : p->of + 1;
        if (first < next)
            return csv_wrong(&csv->file, p->part[i].at,
                             "row %zu of the study is in the file twice; leave one part out", first);
        if (first > next && !*missing)
            snprintf(missing, size, "%zu of the %zu rows are missing, the first is number %zu",
                     p->of - p->study.rows, p->of, next);
        next = i < p->parts ? first + p->part[i].rows : next;
    }
    return true;
}

bool run_pool(const struct query *query, struct answer *a, struct problem *problem)
{
    char missing[128];
    struct pool p = {.part = NULL};
    struct csv_table *csv =
        csv_named(query->scene, query->means, query->given->word[0], true, &pool_kind, problem);
    while (csv && csv_next(csv) && block_add(&p, csv))
        ;
    bool good = p.part && !*csv->file.problem.text && parts_check(&p, csv, missing, sizeof missing);
    good = csv_end(csv, problem) && good;
    enum dom_status status = good ? domq_study_interval(&p.study) : DOM_OK;
    if (good && status == DOM_OK)
        study_answer(a, p.common[SIGMA], p.common[HEIGHTS], &p.study, p.stops, p.dominoes,
                     *missing ? missing : NULL);
    free(p.stops);
    free(p.part);
    return good && (status == DOM_OK || problem_status(problem, query->scene, status));
}
