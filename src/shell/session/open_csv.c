/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/open_csv.h"
#include "io/io.h"
#include "io/terminal.h"
#include "language/names.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Returns the path of a file beside the script that names it or, if it is not there, as it is named.  Returns
 * NULL if there is no memory; the caller frees the path. */
static char *path_beside(const struct means *means, const char *name)
{
    const char *slash = means->script && *name != '/' ? strrchr(means->script, '/') : NULL;
    char *path = NULL;
    if (slash && asprintf(&path, "%.*s%s", (int)(slash + 1 - means->script), means->script, name) < 0)
        return NULL;
    if (path && access(path, F_OK) == 0)
        return path;
    free(path);
    return strdup(name);
}

bool csv_end(struct csv_table *csv, struct problem *problem)
{
    char shown[NAMES_SHOWN];
    bool good = csv && *csv->file.problem.text == '\0';
    if (csv && !good) {
        const char *path = strlen(csv->path) < 256 ? csv->path : names_shown(csv->path, shown);
        problem_error(problem, "%s:%ld:%d: %s", path, csv->file.problem.at.line, csv->file.problem.at.column,
                      csv->file.problem.text);
    }
    csv_close(csv);
    return good;
}

struct csv_table *csv_named(const struct scene *scene, const struct means *means, const char *name,
                            bool standard, const struct csv_kind *kind, struct problem *problem)
{
    const volatile sig_atomic_t *interrupt = scene->compute.interrupt;
    char shown[NAMES_SHOWN];
    standard = standard && strcmp(name, "-") == 0;
    char *path = path_beside(means, name);
    FILE *in = !path ? NULL : standard ? io_stdin(interrupt) : io_read(path, interrupt);
    struct csv_table *csv = in ? csv_open(in, path, kind, terminal_decimal_comma()) : NULL;
    if (!csv)
        problem_error(problem, "cannot read '%s': %s", names_shown(name, shown), strerror(errno));
    if (in && !standard)
        fclose(in);
    if (!csv)
        free(path);
    else if (*csv->file.problem.text && !csv_end(csv, problem))
        csv = NULL;
    return csv;
}
