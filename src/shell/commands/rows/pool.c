/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Studies of random errors of placement that are computed in parts. A study counts how many random rows fall,
 * and such counts can be added. Each part of a study writes the counts for some blocks of 100 rows. The
 * command pool reads the blocks of all parts, adds them up, and prints the answer that 'placement' would have
 * printed.
 */
#include "commands/rows/rows.h"
#include "parallel/points.h"
#include "session/rowfile.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- The answer of a study ---- */

const struct column placement_columns[] = {
    {"sigma", "m", "standard deviation of every gap", 0},
    {"heights", "share", "relative standard deviation of every height", 0},
    {"rows", "", "the number of rows that were set up", 0},
    {"fall", "", "the number of rows that fall completely", 0},
    {"probability", "share", "fall / rows", 0},
    {"low", "share", "the lower end of the 95 % interval of the probability", 0},
    {"high", "share", "the upper end of this interval", 0},
    {"unknown", "", "the number of rows that the model cannot follow, which widen the interval", 0},
    {"stops_most", "", "the domino at which most of the other rows stop", 0},
    {NULL, NULL, NULL, 0},
};

/*
 * Steps through the dominoes at which rows stop, from the most frequent to the least frequent one. Returns
 * the index of the domino after `last`, or of the first domino if `last` is count. Returns count after the
 * last domino.
 */
static size_t stop_next(const size_t *stops, size_t count, size_t last)
{
    size_t next = count;
    for (size_t k = 0; k < count; k++) {
        bool is_after = last == count || stops[k] < stops[last] || (k > last && stops[k] == stops[last]);
        if (stops[k] > 0 && is_after && (next == count || stops[k] > stops[next]))
            next = k;
    }
    return next;
}

void study_answer(struct answer *a, domq_real sigma, domq_real heights, const struct domq_study *study,
                  const size_t *stops, size_t count, const char *reason)
{
    enum { SHOWN = 5 };
    const size_t others = study->rows - study->fall - study->unknown, most = stop_next(stops, count, count);
    char text[200] = "";
    size_t k = most;
    for (int i = 0, n = 0; i < SHOWN && k < count; i++, k = stop_next(stops, count, k))
        n += snprintf(text + n, sizeof text - (size_t)n, "%s%zu (%.3g %%)", n ? ", " : "", k + 1,
                      100 * (double)stops[k] / (double)others);
    answer_say(a, "%zu of %zu rows fall. The probability is %s to %s, with 95 %% confidence.", study->fall,
               study->rows, measured((domq_real)study->low, "share", study->low > 0.99 ? 5 : 3).text,
               measured((domq_real)study->high, "share", study->high > 0.99 ? 5 : 3).text);
    if (*text)
        answer_say(a, "The others stop at domino %s.", text);
    answer_row(a,
               ROW(cell_real(sigma), cell_real(heights), cell_count((domq_real)study->rows),
                   cell_count((domq_real)study->fall),
                   cell_bound((domq_real)study->fall / (domq_real)study->rows, DOMQ_NAN),
                   cell_bound((domq_real)study->low, DOMQ_NAN), cell_bound((domq_real)study->high, DOMQ_NAN),
                   cell_count((domq_real)study->unknown),
                   most < count ? cell_count((domq_real)most + 1) : cell_real(DOMQ_NAN)),
               reason);
}

/* ---- Writing blocks ---- */

enum { BLOCK_ROWS = 100, STOPS_TEXT = BLOCK_ROWS * 16 };

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

/* Adds a value to a checksum (FNV-1a of Fowler, Noll and Vo). */
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

/* The data of a worker thread. Only the status differs between workers. */
struct blocks {
    const struct scene_row *scene;
    const struct domq_placement *placement; /* the parameters of the whole study */
    char checksum[16];
    struct answer answer;
    enum dom_status status;
};

/* Writes how many rows stop at each domino, for example "5:12 6:3" if 12 rows stop at domino 5 and 3 at
 * domino 6. */
static void stops_text(const size_t *stops, size_t count, char text[STOPS_TEXT])
{
    int n = 0;
    text[0] = '\0';
    for (size_t k = 0; k < count; k++)
        if (stops[k] > 0)
            n += snprintf(text + n, (size_t)(STOPS_TEXT - n), "%s%zu:%zu", n ? " " : "", k + 1, stops[k]);
}

static bool block_write(void *own, size_t block, FILE *out)
{
    struct blocks *b = own;
    const size_t count = b->scene->row.count, all = b->placement->rows;
    struct domq_study study;
    struct domq_placement p = *b->placement;
    char text[STOPS_TEXT];
    size_t *stops = calloc(count, sizeof *stops);
    p.first = block * BLOCK_ROWS;
    p.rows = all - p.first < BLOCK_ROWS ? all - p.first : BLOCK_ROWS;
    p.parallel = NULL; /* the rows of a block are not computed in parallel, because whole blocks are */
    b->status =
        stops ? domq_placement_study(&b->scene->row, &b->scene->compute, &p, &study, stops) : DOM_NO_MEMORY;
    if (b->status == DOM_OK) {
        struct answer a = answer_part(&b->answer, out, block == 0);
        stops_text(stops, count, text);
        answer_cells(&a, cell_real(p.sigma), cell_real(p.heights), cell_count((domq_real)p.seed),
                     cell_word(b->checksum), cell_count((domq_real)count), cell_count((domq_real)all),
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
    struct blocks b = {.scene = scene, .placement = placement};
    bool by_point;
    snprintf(b.checksum, sizeof b.checksum, "x%08x", (unsigned)scene_checksum(&scene->row, &scene->compute));
    a->columns = block_columns;
    a->rows = true;
    a->style.errors = false; /* counts are exact, and have no error bounds */
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
    .headless = true, /* sorting the lines may have moved the column names away from the first line */
    .rows_most = COUNT_MAX,
    .item = "block",
    .items = "blocks of a study",
    .names = "sigma, heights, seed, scene, dominoes, of, first, rows, fall, unknown, stops: " BLOCKS,
};

struct block {
    size_t first, rows;
    struct csv_place at;
};

struct pool {
    domq_real common[FIRST]; /* the values that must be the same in all blocks of a study */
    const char *checksum;
    struct domq_study study;
    size_t dominoes, *stops;
    struct block *block;
    size_t blocks;
};

static bool pool_begin(struct pool *p, struct csv_table *csv)
{
    memcpy(p->common, csv->value, sizeof p->common);
    p->checksum = csv_cell(csv, SCENE).text;
    p->dominoes = (size_t)csv->value[DOMINOES];
    p->stops = calloc(p->dominoes, sizeof *p->stops);
    return p->stops || csv_wrong(&csv->file, csv->row.at, "out of memory");
}

/* Parses a text such as "5:12 6:3", adds its counts to p->stops, and sets *sum to their sum. Returns false if
 * the text is wrong. */
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
    if (!p->stops && !pool_begin(p, csv))
        return false;
    bool same = strcmp(csv_cell(csv, SCENE).text, p->checksum) == 0;
    for (int k = 0; k < FIRST; k++)
        same = same && (k == SCENE || value[k] == p->common[k]);
    if (!same)
        return csv_wrong(
            &csv->file, csv->row.at,
            "this block is of another study: sigma, heights, seed, row or number of rows differ");
    size_t first = (size_t)value[FIRST], rows = (size_t)value[ROWS], fall = (size_t)value[FALL],
           unknown = (size_t)value[UNKNOWN], stopped;
    if (first + rows - 1 > (size_t)value[OF] || !stops_add(p, csv_cell(csv, STOPS).text, &stopped) ||
        fall + unknown + stopped != rows)
        return csv_wrong(&csv->file, csv->row.at,
                         "the counts of this block do not add up to its number of rows");
    p->study.rows += rows;
    p->study.fall += fall;
    p->study.unknown += unknown;
    struct block *more = realloc(p->block, (p->blocks + 1) * sizeof *more);
    if (!more)
        return csv_wrong(&csv->file, csv->row.at, "out of memory");
    p->block = more;
    p->block[p->blocks++] = (struct block){first, rows, csv->row.at};
    return true;
}

static int compare_first(const void *a, const void *b)
{
    const struct block *x = a, *y = b;
    return x->first < y->first ? -1 : x->first > y->first;
}

/* Writes how many rows of the study are missing, or "" if none is. Returns false with a problem if the file
 * has a row twice. */
static bool blocks_check(struct pool *p, struct csv_table *csv, char *missing, size_t size)
{
    const size_t all = (size_t)p->common[OF];
    size_t next = 1;
    missing[0] = '\0';
    qsort(p->block, p->blocks, sizeof *p->block, compare_first);
    for (size_t i = 0; i <= p->blocks; i++) {
        const struct block end = {.first = all + 1}, *b = i < p->blocks ? &p->block[i] : &end;
        if (b->first < next)
            return csv_wrong(&csv->file, b->at,
                             "row %zu of the study is in the file twice; leave one part out", b->first);
        if (b->first > next && !*missing)
            snprintf(missing, size, "%zu of the %zu rows are missing, the first is number %zu",
                     all - p->study.rows, all, next);
        next = b->first + b->rows;
    }
    return true;
}

bool run_pool(const struct query *query, struct answer *a, struct problem *problem)
{
    char missing[128];
    struct pool p = {.blocks = 0};
    struct csv_table *csv =
        csv_named(query->scene, query->means, query->given->word[0], true, &pool_kind, problem);
    while (csv && csv_next(csv) && block_add(&p, csv))
        ;
    bool good = p.block && !*csv->file.problem.text && blocks_check(&p, csv, missing, sizeof missing);
    good = csv_end(csv, problem) && good;
    enum dom_status status = good ? domq_study_interval(&p.study) : DOM_OK;
    if (good && status == DOM_OK)
        study_answer(a, p.common[SIGMA], p.common[HEIGHTS], &p.study, p.stops, p.dominoes,
                     *missing ? missing : NULL);
    free(p.stops);
    free(p.block);
    return good && (status == DOM_OK || problem_status(problem, query->scene, status));
}
