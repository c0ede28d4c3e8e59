/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture/typeset.h"
#include "io/io.h"
#include "language/names.h"
#include "picture/picture.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PATH_TEXT = 256 };

bool typeset_ready(struct problem *problem)
{
    return program_exists("pdflatex") ||
           problem_error(problem, "a .pdf document needs pdflatex, which is not installed; run 'apt install "
                                  "texlive-latex-base', or write a .txt, .md or .tex file");
}

static const char *file_of(const char *folder, const char *extension, char path[PATH_TEXT])
{
    snprintf(path, PATH_TEXT, "%s/document%s", folder, extension);
    return path;
}

/* Runs pdflatex, which writes all its files into the folder, and copies the document to `out`. */
static bool run(const char *folder, FILE *tex, FILE *out, const volatile sig_atomic_t *interrupt,
                struct problem *problem)
{
    char source[PATH_TEXT], made[PATH_TEXT], option[PATH_TEXT + 32];
    snprintf(option, sizeof option, "-output-directory=%s", folder);
    char *const argv[] = {"pdflatex",
                          "-interaction=batchmode",
                          "-halt-on-error",
                          "-no-shell-escape",
                          option,
                          file_of(folder, ".tex", source) ? source : NULL,
                          NULL};
    FILE *written = fopen(source, "w"), *messages = io_temporary(NULL), *nothing = io_temporary(NULL),
         *document = NULL;
    bool done = written && messages && nothing;
    if (written) {
        io_copy(tex, written);
        done = !ferror(written) && done;
        done = fclose(written) == 0 && done;
    }
    if (!done)
        problem_error(problem, "cannot typeset: %s", strerror(errno ? errno : ENOSPC));
    done = done && program_run(argv, nothing, messages, "typeset it", interrupt, problem);
    if (done && !(document = fopen(file_of(folder, ".pdf", made), "r")))
        done = problem_error(problem, "pdflatex did not write a document: %s", strerror(errno));
    if (document)
        io_copy(document, out);
    FILE *const opened[] = {messages, nothing, document};
    for (int i = 0; i < 3; i++)
        if (opened[i])
            fclose(opened[i]);
    return done;
}

bool typeset(FILE *tex, FILE *out, const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    static const char *const extensions[] = {".tex", ".aux", ".log", ".pdf"};
    char folder[PATH_TEXT - 32], path[PATH_TEXT];
    int length = snprintf(folder, sizeof folder, "%s/domino-XXXXXX", io_temporary_folder());
    errno = ENAMETOOLONG;
    if (length >= (int)sizeof folder || !mkdtemp(folder)) {
        const int error = errno;
        return problem_error(problem, "cannot make a temporary folder in '%s': %s",
                             names_shown(io_temporary_folder()), strerror(error));
    }
    bool done = run(folder, tex, out, interrupt, problem);
    for (size_t i = 0; i < sizeof extensions / sizeof *extensions; i++)
        unlink(file_of(folder, extensions[i], path));
    rmdir(folder);
    return done;
}
