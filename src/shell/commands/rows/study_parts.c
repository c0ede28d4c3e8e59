/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A study of placement in parts.  The results of random rows are counts, which can be added: each part writes
 * counts for blocks of fixed row numbers, which do not depend on the number of parts.  'pool' reads all
 * blocks and gives the answer of 'placement'.
 */
#include "commands/rows/falling.h"
#include "commands/tables.h"
#include "interpreter/line.h"
#include "io/io.h"
#include "language/quad.h"
#include "language/text.h"
#include "parallel/points.h"
#include <errno.h>
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
enum { COMMON = FIRST, SAME_SIZE = 256 }; /* the fields before FIRST are the same in a study */

struct part {
    size_t first, rows;
};

struct pool {
    const struct query *query;
    struct problem *problem;
    const char *path; /* as messages show it */
    long line;
    char same[SAME_SIZE]; /* the common fields of the first block; "" before it is read */
    domq_real sigma, heights;
    struct domq_study study;
    size_t of, dominoes, *stops;
    struct part *part;
    size_t parts, room;
};

static bool wrong(const struct pool *p, const char *why)
{
    return problem_error(p->problem, "%s:%ld: %s", p->path, p->line, why);
}

/* Reads a count that is the whole text. */
static bool count_read(const char *text, size_t most, size_t *count)
{
    char *end;
    errno = 0;
    unsigned long long value = strtoull(text, &end, 10);
    *count = (size_t)value;
    return *text >= '0' && *text <= '9' && *end == '\0' && errno == 0 && value <= most;
}

static bool study_begin(struct pool *p, char *const *field, const char *same)
{
    char *ends[2];
    p->sigma = quad_read(field[SIGMA], &ends[0]);
    p->heights = quad_read(field[HEIGHTS], &ends[1]);
    if (*ends[0] || *ends[1] || !count_read(field[DOMINOES], COUNT_MAX, &p->dominoes) || p->dominoes == 0 ||
        !count_read(field[OF], COUNT_MAX, &p->of))
        return wrong(p, "this line is not a block of a study");
    snprintf(p->same, sizeof p->same, "%s", same);
    p->stops = calloc(p->dominoes, sizeof *p->stops);
    return p->stops || problem_status(p->problem, p->query->scene, DOM_NO_MEMORY);
}

/* Adds the counts of "5:12 6:3", and writes their sum. */
static bool stops_add(struct pool *p, char *text, size_t *sum)
{
    *sum = 0;
    for (char *rest = text, *word; (word = strsep(&rest, " ")) != NULL;) {
        size_t domino, count;
        char *colon = strchr(word, ':');
        if (*word == '\0')
            continue;
        if (colon)
            *colon = '\0';
        if (!colon || !count_read(word, p->dominoes, &domino) || domino == 0 ||
            !count_read(colon + 1, COUNT_MAX, &count))
            return false;
        p->stops[domino - 1] += count;
        *sum += count;
    }
    return true;
}

static bool part_add(struct pool *p, size_t first, size_t rows)
{
    if (p->parts == p->room) {
        p->room = 2 * p->room + 64;
        struct part *more = realloc(p->part, p->room * sizeof *more);
        if (!more)
            return problem_status(p->problem, p->query->scene, DOM_NO_MEMORY);
        p->part = more;
    }
    p->part[p->parts++] = (struct part){first, rows};
    return true;
}

static bool block_add(struct pool *p, char *line)
{
    char *field[FIELDS], *rest = line, same[SAME_SIZE];
    int n = 0;
    while (n < FIELDS && rest)
        field[n++] = strsep(&rest, ",");
    if (n < FIELDS || rest)
        return wrong(
            p,
            "this line is not a block of a study; 'domino --shard I/N' with 'set output csv' writes blocks");
    snprintf(same, sizeof same, "%s,%s,%s,%s,%s,%s", field[0], field[1], field[2], field[3], field[4],
             field[5]);
    if (!*p->same && !study_begin(p, field, same))
        return false;
    if (strcmp(same, p->same) != 0)
        return wrong(p, "this block is of another study: sigma, heights, seed, row or number of rows differ");
    size_t first, rows, fall, unknown, stopped;
    if (!count_read(field[FIRST], p->of, &first) || !count_read(field[ROWS], BLOCK_ROWS, &rows) ||
        first == 0 || rows > p->of - first + 1 || !count_read(field[FALL], rows, &fall) ||
        !count_read(field[UNKNOWN], rows, &unknown) || !stops_add(p, field[STOPS], &stopped) ||
        fall + unknown + stopped != rows)
        return wrong(p, "the counts of this block do not add up to its number of rows");
    p->study.rows += rows;
    p->study.fall += fall;
    p->study.unknown += unknown;
    return part_add(p, first, rows);
}

static bool pool_read(struct pool *p, FILE *in)
{
    char head[SAME_SIZE] = "", *text = NULL;
    size_t size = 0;
    ssize_t length;
    bool good = true;
    for (const struct column *c = block_columns; c->key; c++) {
        size_t used = strlen(head);
        snprintf(head + used, sizeof head - used, "%s%s", used ? "," : "", c->key);
    }
    while (good && (length = text_read(&text, &size, in)) != -1) {
        p->line++;
        if (length > TEXT_MOST)
            good = wrong(p, "the line is too long for a block of a study");
        text[strcspn(text, "\r\n")] = '\0';
        /* Parts are concatenated in any order, each with the first line. */
        if (good && *text && strcmp(text, head) != 0)
            good = block_add(p, text);
    }
    free(text);
    if (!good)
        return false;
    if (ferror(in))
        return problem_error(p->problem, "cannot read any further in '%s': %s", p->path, strerror(errno));
    return p->parts > 0 ||
           problem_error(
               p->problem,
               "'%s' has no blocks of a study; 'domino --shard I/N' with 'set output csv' writes them",
               p->path);
}

static int by_first(const void *a, const void *b)
{
    const struct part *x = a, *y = b;
    return x->first < y->first ? -1 : x->first > y->first;
}

/* Writes which rows are missing, "" for none. Reports an error if a row is there twice. */
static bool parts_check(struct pool *p, char *missing, size_t size)
{
    size_t next = 1;
    missing[0] = '\0';
    qsort(p->part, p->parts, sizeof *p->part, by_first);
    for (size_t i = 0; i <= p->parts; i++) {
        size_t first = i < p->parts ? p->part[i].first : p->of + 1;
        if (first < next)
            return problem_error(p->problem, "row %zu of the study is in '%s' twice; leave one part out",
                                 first, p->path);
        if (first > next && !*missing)
            snprintf(missing, size, "%zu of the %zu rows are missing, the first is number %zu",
                     p->of - p->study.rows, p->of, next);
        next = i < p->parts ? first + p->part[i].rows : next;
    }
    return true;
}

bool run_pool(const struct query *query, struct answer *a, struct problem *problem)
{
    char missing[128], shown[NAMES_SHOWN];
    struct pool p = {.query = query, .problem = problem, .path = query->given->word[0]};
    bool standard = strcmp(p.path, "-") == 0;
    const volatile sig_atomic_t *interrupt = query->scene->compute.interrupt;
    FILE *in = standard ? io_stdin(interrupt) : io_read(p.path, interrupt);
    if (!in)
        return problem_error(problem, "cannot read '%s': %s", names_shown(p.path, shown), strerror(errno));
    p.path = names_shown(p.path, shown); /* used in messages only from here on */
    bool good = pool_read(&p, in) && p.part && parts_check(&p, missing, sizeof missing);
    if (good) {
        enum dom_status status = domq_study_interval(&p.study);
        if (status == DOM_OK)
            study_answer(a, p.sigma, p.heights, &p.study, p.stops, p.dominoes, *missing ? missing : NULL);
        good = status == DOM_OK || problem_status(problem, query->scene, status);
    }
    if (!standard)
        fclose(in);
    free(p.stops);
    free(p.part);
    return good;
}
