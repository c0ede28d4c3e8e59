/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'save', which writes a session as a script. */
#include "interpreter/command.h"
#include "io/output.h"
#include "language/quad.h"
#include "session/parameters.h"
#include <stdlib.h>
#include <sys/stat.h>

/* Writes the commands that set all parameters to their current values, each after those that decide whether
 * it is accepted. `folder` is the directory of the script, or NULL. */
static bool parameters_save(const struct state *state, const char *folder, FILE *out, struct problem *problem)
{
    /* Effects that are off come first. An effect cannot be turned off while another effect needs it, so those
     * that need others, and not just a row, are the first. Effects that are on come last. A parameter that
     * takes only words, such as 'precision', comes before those that take numbers, because the range of tol
     * depends on the precision. */
    const unsigned alone = 1U << DOM_EFFECT_row;
    for (int rank = 0; rank <= 5; rank++)
        for (const struct parameter *p = session_parameters; p->name; p++) {
            const int at = !p->effect                              ? (p->words_only ? p->setting ? 2 : 3 : 4)
                           : state->scene.effect[p->which].on      ? 5
                           : p->needs || p->effect->needs & ~alone ? 0
                                                                   : 1;
            if (at == rank && !effect_slot(state, p))
                fprintf(out, "set %s %s\n", p->name, parameter_setting(state, p, WIDE_DIGITS));
            else if (at == rank && !state->scene.slot->kind->save(&state->scene, folder, out, problem))
                return false;
        }
    return true;
}

/* Returns true if 'save' may write to this path. A script must not replace a picture, a table or the file of
 * the row. */
static bool save_allowed(const struct scene *scene, const char *path, struct problem *problem)
{
    const struct extension *extension = extension_of(path);
    const char *shown = names_shown(path), *row = scene->slot ? scene->slot->file : NULL;
    struct stat file, row_file;
    if (extension->kind >= EXTENSION_DATA)
        return problem_error(problem,
                             "'%s' is the name of a %s, but 'save' writes a script; use a name such as "
                             "session.dom%s",
                             shown, extension->kind == EXTENSION_DATA ? "data file" : "picture",
                             extension->kind == EXTENSION_DATA ? ", or write the row with 'row > FILE'" : "");
    if (row && stat(path, &file) == 0 && stat(row, &row_file) == 0 && S_ISREG(file.st_mode) &&
        file.st_dev == row_file.st_dev && file.st_ino == row_file.st_ino)
        return problem_error(problem,
                             "'%s' has the dominoes of the row, and 'save' would replace them by a script; "
                             "use another name, such as session.dom",
                             shown);
    return true;
}

static bool run_save(const struct query *query, struct answer *a, struct problem *problem)
{
    struct output *file = NULL;
    const char *path = query->given->word[0];
    const struct variables *variables = &query->state->variables;
    (void)a;
    if (!save_allowed(query->scene, path, problem))
        return false;
    const char *wrong = output_push(&file, path, false);
    if (!wrong) {
        char *folder = output_folder(file);
        fprintf(file->out, "# A session of domino " DOM_VERSION
                           "; run it with 'source', 'domino -f' or, to stay, 'domino -i'.\n");
        const bool good = parameters_save(query->state, folder, file->out, problem);
        free(folder);
        for (size_t i = 0; i < variables->count; i++) {
            const struct variable *v = &variables->list[i];
            char number[WIDE_TEXT], unit[UNIT_TEXT];
            if (v->body)
                fprintf(file->out, "let %s = %s\n", variable_head(v), v->body);
            else
                fprintf(file->out, "let %s = %s%s%s\n", v->name,
                        quad_exact(v->value.value, WIDE_DIGITS, number),
                        *unit_write(v->value, "*", unit) ? " " : "", unit);
        }
        wrong = output_pop(&file, good);
        if (!good)
            return false;
    }
    return !wrong || problem_error(problem, "cannot write '%s': %s", names_shown(path), wrong);
}

static const struct command save_commands[] = {
    {.name = "save",
     .synonyms = "script store export keep file",
     .argument = {{.name = "FILE", .kind = ARGUMENT_FILE}},
     .summary = "write the parameters into FILE, for 'source'",
     .help = "FILE also records the effects that are on, the name of the row's file, the dimensions of the "
             "row that have been changed, and what 'let' has defined. 'domino -i FILE' runs it and stays.",
     .see = "source",
     .writes = WRITES_SCRIPTS,
     .access.files = true,
     .run = run_save},
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"A script of the session", "scripts", save_commands},
    {NULL, NULL, NULL},
};

const struct feature save_feature = {.name = "save", .groups = groups};
