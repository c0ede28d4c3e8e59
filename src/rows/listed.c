/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The row of a scene: a plain row of the train, or a row of one's own, whose dominoes come from a file or
 * have been changed. The scene has a row of one's own in its slot. */
#include "answer/cell.h"
#include "language/names.h"
#include "language/quad.h"
#include "language/text.h"
#include "rows/rows.h"
#include "session/parameters.h"
#include <stdlib.h>
#include <string.h>

/* ---- The dominoes ---- */

static size_t row_planned(const struct scene *scene)
{
    return row_has_file(scene) ? row_of(scene)->file->count : (size_t)effect_value(scene, DOM_EFFECT_row, 0);
}

size_t scene_row_count(const struct scene *scene)
{
    return scene->slot && row_of(scene)->changes > 0 ? row_of(scene)->changes : row_planned(scene);
}

bool scene_has_masses(const struct scene *scene)
{
    return scene_has_mass(scene) || (row_has_file(scene) && row_of(scene)->file->has_masses);
}

/* Writes the dominoes of the file or of the train from which the dominoes of the row originate. Has the same
 * rounding errors as domq_row_of_train. */
static void origins_fill(const struct scene *scene, struct domq_domino *domino, size_t count)
{
    const struct listed_row *row = row_of(scene);
    const struct domq_train *t = &scene->train;
    const domq_real heavier = quad(pow)(t->r, t->q - 1);
    domq_real height = scene->scale.h, mass = 1;
    for (size_t k = 0, i = 0; k < count; k++) {
        const size_t origin = row->changes > 0 ? row->change[k].origin : k;
        for (; !row->file && i < origin; i++) {
            height *= t->r;
            mass *= heavier;
        }
        domino[k] = row->file ? row->file->domino[origin]
                              : (struct domq_domino){.height = height,
                                                     .thickness = t->d * height,
                                                     .gap = i > 0 ? t->s * height : 0,
                                                     .width = t->width * height,
                                                     .mass = mass};
    }
}

/* Gives a domino of the file or of the train its width and, if masses follow from volumes, its mass. */
static void domino_complete(const struct scene *scene, struct domq_domino *d)
{
    const struct row_file *file = row_of(scene)->file;
    const domq_real width = scene->length[SHARE_width].m;
    const bool has_width = d->width > 0;
    if (!has_width)
        d->width = width > 0 ? width : scene->train.width * d->height;
    if (file && file->from_volumes) /* with the width that the file gives, or with half the height */
        d->mass *= (has_width ? 1 : d->width / (d->height / 2)) * scene_filled(scene, d);
    else if (!file && scene_boxes_above(scene) > 0)
        d->mass = d->height * d->width * d->thickness * scene_filled(scene, d);
}

/* Applies the stored changes to a domino of the row. */
static void change_apply(const struct scene *scene, const struct changed_domino *change,
                         struct domq_domino *d)
{
    struct domq_domino to = change->to;
    for (enum row_measure m = 0; m < ROW_MEASURES; m++) {
        domq_real value = *row_measure_at(&to, m), *member = row_measure_at(d, m);
        if (isnan(value))
            continue;
        if (row_measure_is_size(m)) {
            /* Dominoes above a certain height can be boxes. With its new size, a solid domino may become a
             * box, or a box may become a solid domino. */
            d->mass *= value / *member / scene_filled(scene, d);
            *member = value;
            d->mass *= scene_filled(scene, d);
        } else
            *member = m == MEASURE_MASS ? *member * value : value;
    }
}

void scene_row_fill(const struct scene *scene, struct domq_domino *domino, size_t count)
{
    const struct listed_row *row = row_of(scene);
    if (!row) {
        train_row_fill(scene, domino, count);
        return;
    }
    struct domq_domino first;
    if (row->file)
        first = *row->file->domino;
    else
        domq_row_of_train(&scene->train, &scene->scale, 1, &first, 1);
    domino_complete(scene, &first);
    origins_fill(scene, domino, count);
    for (size_t k = 0; k < count; k++)
        domino_complete(scene, &domino[k]);
    if (!row->file || !row->file->has_masses)
        row_weigh(scene, &first, domino, count);
    for (size_t k = 0; k < count && row->changes > 0; k++)
        change_apply(scene, &row->change[k], &domino[k]);
    domino[0].gap = 0;
    /* If the masses are not known, m g h/2 of the first domino must be 1. A change may have altered it. */
    if (row->changes > 0 && !scene_has_masses(scene))
        row_weigh(scene, domino, domino, count);
}

bool problem_no_row(struct problem *problem)
{
    return problem_error(problem, "there is no row; first enter 'set row N' or 'set row FILE'");
}

bool scene_row_list(const struct scene *scene, struct scene_row *row, struct problem *problem)
{
    row->row.count = scene_row_count(scene);
    if (row->row.count == 0)
        return problem_no_row(problem);
    row->domino = malloc(row->row.count * sizeof *row->domino);
    if (!row->domino)
        return problem_status(problem, scene, DOM_NO_MEMORY);
    scene_row_fill(scene, row->domino, row->row.count);
    return true;
}

bool scene_row_make(const struct scene *scene, struct scene_row *row, struct problem *problem)
{
    char message[LEAN_MESSAGE];
    if (!scene_row_list(scene, row, problem))
        return false;
    for (size_t k = 0; k < row->row.count && scene->slot && scene->train.rho == 0; k++)
        if (row->domino[k].lean != 0 && !lean_stands(&row->domino[k], scene->train.alpha, message)) {
            free(row->domino);
            return problem_no_answer(problem, "domino %zu: %s", k + 1, message);
        }
    return row_prepare(scene, scene_has_masses(scene), row, problem);
}

/* ---- The slot ---- */

static void row_free(struct slot *slot)
{
    rowfile_drop(((struct listed_row *)slot)->file);
    free(slot);
}

static domq_real first_height(const struct scene *scene)
{
    struct domq_domino first;
    scene_row_fill(scene, &first, 1);
    return first.height;
}

static const char *file_name(const struct row_file *file)
{
    const char *slash = strrchr(file->path, '/');
    return slash ? slash + 1 : file->path;
}

static void setting_write(const struct scene *scene, char text[PARAMETER_SETTING])
{
    const size_t count = scene_row_count(scene), planned = row_planned(scene);
    if (row_has_file(scene))
        snprintf(text, PARAMETER_SETTING, "%s", file_name(row_of(scene)->file));
    else
        snprintf(text, PARAMETER_SETTING, "%zu", planned);
    if (count != planned)
        text_add(text, PARAMETER_SETTING, ", now %zu", count);
    else if (row_of(scene)->changes > 0)
        text_add(text, PARAMETER_SETTING, ", changed");
}

static void kept_write(const struct scene *scene, const struct parameter *p, char text[PROBLEM_TEXT])
{
    const struct listed_row *row = row_of(scene);
    const bool is_width = p->share == SHARE_width, is_size = names_index("s r d h", ' ', p->name) >= 0;
    size_t kept = 0; /* gaps that were changed individually and so no longer follow from s */
    for (size_t k = 0; k < row->changes && p->share == SHARE_s; k++)
        kept += isnan(row->change[k].to.gap) ? 0 : 1;
    *text = '\0';
    if (row->file && (is_size || (is_width && row->file->domino->width > 0)))
        snprintf(text, PROBLEM_TEXT, "%s does not change the row, whose %s come from %s%s.", p->name,
                 is_width ? "widths" : "dominoes", file_name(row->file),
                 is_width ? "" : "; 'set row N' makes a row from s, r, d and h");
    else if (kept > 0)
        snprintf(text, PROBLEM_TEXT,
                 "s does not change the gaps that 'change', 'place' or 'improve' has set (%zu of %zu); "
                 "'set row N' makes a row from s and r.",
                 kept, row->changes - 1);
}

/* Writes the commands that remove and insert dominoes. Dominoes are removed from the end of the row, so that
 * the numbers of those before them stay the same. */
static void origins_save(const struct listed_row *row, size_t planned, FILE *out)
{
    for (size_t k = row->changes, end = planned; end > 0;) {
        const size_t last = k > 0 ? row->change[k - 1].origin + 1 : 0; /* the last domino that is left */
        if (last + 1 < end)
            fprintf(out, "remove %zu-%zu\n", last + 1, end);
        else if (last < end)
            fprintf(out, "remove %zu\n", end);
        end = last > 0 ? last - 1 : 0;
        while (k > 0 && row->change[k - 1].origin + 1 == last)
            k--;
    }
    for (size_t k = 1; k < row->changes; k++)
        if (row->change[k].origin == row->change[k - 1].origin)
            fprintf(out, "insert %zu\n", k);
}

/* Writes the command that reads the file. If the file is below the directory of the script, its path is
 * written relative to the script. The script and the file can then be moved together. */
static bool file_save(const char *path, const char *folder, FILE *out, struct problem *problem)
{
    /* What follows a control character might be read as another command. */
    for (const char *c = path; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f)
            return problem_error(
                problem,
                "cannot save: the name of the row's file, '%s', contains a control character; "
                "rename the file, or enter 'set row off'",
                names_shown(path));
    const size_t size = folder ? strlen(folder) : 0;
    const bool below = size > 0 && strncmp(path, folder, size) == 0 && path[size] == '/';
    fputs(below ? "set row \"." : "set row \"", out);
    for (const char *c = below ? path + size : path; *c; c++)
        fputs(*c == '"' ? "\"\"" : (char[]){*c, '\0'}, out);
    fputs("\"\n", out);
    return true;
}

static bool row_save(const struct scene *scene, const char *folder, FILE *out, struct problem *problem)
{
    const struct listed_row *row = row_of(scene);
    char number[WIDE_TEXT];
    if (!row->file)
        fprintf(out, "set row %zu\n", row_planned(scene));
    else if (!file_save(row->file->path, folder, out, problem))
        return false;
    if (row->changes > 0)
        origins_save(row, row_planned(scene), out);
    for (size_t k = 0; k < row->changes; k++) {
        struct domq_domino to = row->change[k].to;
        for (enum row_measure m = 0; m < ROW_MEASURES; m++) {
            const domq_real value = *row_measure_at(&to, m);
            if (isnan(value))
                continue;
            /* A lean needs the '=', because it can be negative. Without the '=', 'change' would add a
             * negative value to the current lean. */
            fprintf(out, "change %zu %s %s%s %s\n", k + 1, row_measure_names(NULL, (int)m),
                    m == MEASURE_LEAN ? "= " : "",
                    quad_exact(m == MEASURE_MASS ? 100 * value : value, WIDE_DIGITS, number),
                    m == MEASURE_LEAN   ? "rad"
                    : m == MEASURE_MASS ? "%"
                                        : "m");
        }
    }
    return true;
}

struct listed_row *row_new(struct row_file *file, size_t room)
{
    static const struct slot_kind kind = {.effect = DOM_EFFECT_row,
                                          .free = row_free,
                                          .height = first_height,
                                          .setting = setting_write,
                                          .kept = kept_write,
                                          .save = row_save};
    struct listed_row *row = malloc(sizeof *row + room * sizeof *row->change);
    if (!row)
        return NULL;
    *row = (struct listed_row){
        .slot = {.kind = &kind, .holders = 1, .size = room, .file = file ? file->path : NULL}, .file = file};
    if (file) {
        file->holders++;
        row->slot.size += file->count;
    }
    return row;
}

struct listed_row *row_edit(const struct scene *scene, struct problem *problem)
{
    const struct listed_row *now = row_of(scene);
    const size_t count = scene_row_count(scene);
    struct listed_row *next = row_new(now ? now->file : NULL, count + 1);
    if (!next) {
        (void)problem_status(problem, scene, DOM_NO_MEMORY);
        return NULL;
    }
    next->changes = count;
    for (size_t k = 0; k < count; k++) {
        next->change[k].origin = k;
        for (enum row_measure m = 0; m < ROW_MEASURES; m++)
            *row_measure_at(&next->change[k].to, m) = DOMQ_NAN;
        if (now && now->changes > 0)
            next->change[k] = now->change[k];
    }
    return next;
}

bool rowfile_load(struct scene *scene, const char *name, const struct run_context *run_context,
                  struct problem *problem)
{
    if (run_context->safe)
        return problem_error(problem,
                             "'set row %s' reads a file, which a safe session cannot do; use 'set row N'",
                             names_shown(name));
    struct csv_table *csv = csv_named(run_context, name, &rowfile_kind, problem);
    if (!csv)
        return false;
    struct row_file *file = rowfile_read(csv, scene->train.alpha);
    bool rounded = false;
    for (size_t k = 0; file && k < file->count; k++)
        rounded = rounded || file->domino[k].radius > 0;
    if (rounded && !scene->effect[DOM_EFFECT_edges].on)
        run_context_note(run_context, "%s:%ld: the radii have no effect until you enter 'set edges on'",
                         csv->path, csv->head.at.line);
    if (file && *csv->unused)
        run_context_note(run_context, "%s:%ld: ignored columns: %s; recognized columns: %s", csv->path,
                         csv->head.at.line, csv->unused, csv->kind->names);
    /* 'save' needs an absolute path, since its script may be in another directory. */
    if (file)
        file->path = realpath(csv->path, NULL);
    /* A pipe has no absolute path. */
    if (file && !file->path) {
        file->path = csv->path;
        csv->path = NULL;
    }
    struct listed_row *row = file ? row_new(file, 0) : NULL;
    rowfile_drop(file);
    if (!csv_end(csv, problem))
        return false;
    if (!row)
        return problem_status(problem, scene, DOM_NO_MEMORY);
    slot_drop(scene->slot);
    scene->slot = &row->slot;
    scene->effect[DOM_EFFECT_row] = (struct effect_state){.on = true};
    scene_apply_lengths(scene);
    return true;
}
