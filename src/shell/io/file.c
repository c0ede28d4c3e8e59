/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Writes answers into the files after '>' and '>>'. Each answer is written completely or not at all.
 * - The text first goes to a draft: a file without a name in the folder of the target, which vanishes if the
 *   program is killed. A file system without such files (NFS) gets a draft with a name, ".domino.XXXXXX".
 * - After '>', the draft gets the name of the target in a single step, by rename(2). Other hard links to the
 *   old file keep the old text. Only a program that is killed between naming and renaming the draft, two
 *   system calls apart, leaves a file ".domino.XXXXXX".
 * - After '>>', the target is locked, and the draft is copied to its end.
 */
#define _GNU_SOURCE /* asprintf, mkostemp */
#include "domino_quad.h"
#include "io/io.h"
#include "io/output.h"
#include "io/system.h"
#include "io/target.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct file {
    /* must be the first member, so that a pointer to it is also a pointer to struct file */
    struct output output;
    struct target target;
    bool has_draft; /* false if `out` is the target itself, which may be a device or a FIFO */
    char *draft;    /* the name of the draft, or NULL if it has none */
    const volatile sig_atomic_t *interrupt;
};

/* Opens the draft in the folder of the target. The draft for '>>' needs no name, so it may also be in the
 * usual folder for temporary files, if the target exists. */
static FILE *draft_open(struct file *f)
{
    const struct target *t = &f->target;
    char *folder = strndup(t->path, (size_t)(strrchr(t->path, '/') + 1 - t->path));
    if (!folder)
        return NULL;
    int file = f->output.append ? -1 : system_unnamed(folder);
    FILE *draft = file >= 0 ? fdopen(file, "w+") : f->output.append ? io_temporary(folder) : NULL;
    if (!draft && f->output.append && t->exists)
        draft = io_temporary(NULL);
    if (!draft && !f->output.append && asprintf(&f->draft, "%s.domino.XXXXXX", folder) >= 0) {
        file = mkostemp(f->draft, O_CLOEXEC);
        draft = file >= 0 ? fdopen(file, "w+") : NULL;
    }
    int reason = errno;
    free(folder);
    errno = reason;
    return draft;
}

/* Opens the stream that receives the text: the draft or, for a device, a FIFO and standard output, the target
 * itself. */
static FILE *file_open(struct file *f, const char *path)
{
    const struct target *t = &f->target;
    int file;
    if (t->exists && access(path, W_OK) != 0)
        return NULL;
    f->has_draft = !t->exists || S_ISREG(t->status.st_mode);
    if (target_is_standard(t)) {
        f->has_draft = false;
        io_stdout_flush();
        file = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
    } else if (f->has_draft)
        return draft_open(f);
    else
        file = io_open(path, O_WRONLY, 0, f->interrupt);
    return file >= 0 ? io_stream(file, "w", f->interrupt) : NULL;
}

/* ---- '>' ---- */

/* Gives the draft the mode, the group and, for root, the owner of the old file, and then its name. Signals
 * are blocked, so that only SIGKILL can come between the two names. */
static bool draft_rename(struct file *f)
{
    const struct target *t = &f->target;
    const int file = fileno(f->output.out), folder = (int)(strrchr(t->path, '/') - t->path);
    mode_t mask = umask(0), mode = t->exists ? t->status.st_mode & 0777 : 0666 & ~mask;
    umask(mask);
    /* The owner is set before the mode, because setting it can clear bits of the mode. A mode for another
     * group must not open the file to this group. */
    if (t->exists && fchown(file, t->status.st_uid, t->status.st_gid) != 0 &&
        fchown(file, (uid_t)-1, t->status.st_gid) != 0)
        mode &= 0707;
    sigset_t before = io_block();
    bool is_named = fchmod(file, mode) == 0;
    for (unsigned n = (unsigned)getpid(), tries = 0; is_named && !f->draft && tries < 100; n += 4999, tries++)
        if (asprintf(&f->draft, "%.*s/.domino.%06x", folder, t->path, n & 0xffffffu) < 0)
            f->draft = NULL;
        else if (!system_name(file, f->draft)) {
            is_named = errno == EEXIST;
            free(f->draft);
            f->draft = NULL;
        }
    bool is_written = is_named && f->draft && rename(f->draft, t->path) == 0;
    int reason = errno;
    if (is_written) {
        free(f->draft);
        f->draft = NULL;
    }
    io_unblock(&before);
    errno = reason;
    return is_written;
}

/* ---- '>>' ---- */

/* Removes what does not distinguish two heads of a csv file: the byte order mark, quotes, and the line end.
 */
static void header_plain(char *line)
{
    char *to = line;
    for (const char *from = strncmp(line, "\xef\xbb\xbf", 3) == 0 ? line + 3 : line; *from; from++)
        if (!strchr("\"\r\n", *from))
            *to++ = *from;
    *to = '\0';
}

/* A csv answer that is appended to a file need not repeat the column names. If the first line of the text is
 * the same as the last header line in the target, returns the length of this line, which is then skipped.
 * Otherwise returns 0. */
static long repeated_header(const struct file *f)
{
    char first[OUTPUT_HEADER + 1], line[sizeof first + 4], last[sizeof line] = "";
    bool (*is_header)(const char *) = f->output.is_header;
    rewind(f->output.out);
    if (!is_header || !fgets(first, sizeof first, f->output.out) || !is_header(first))
        return 0;
    long length = (long)strlen(first);
    FILE *in = io_open_read(f->target.path, f->interrupt);
    for (bool begins = true, ends; in && fgets(line, sizeof line, in); begins = ends) {
        ends = strchr(line, '\n') != NULL;
        header_plain(line);
        if (begins && is_header(line))
            memcpy(last, line, sizeof last);
    }
    if (in)
        fclose(in);
    header_plain(first);
    return strcmp(first, last) == 0 ? length : 0;
}

/* Copies the draft, beginning at the offset `from`, to the end of an open file. */
static bool draft_copy(FILE *draft, long from, int to)
{
    char block[4096];
    size_t n;
    fseek(draft, from, SEEK_SET);
    while ((n = fread(block, 1, sizeof block, draft)) > 0)
        if (!io_write(to, block, n, NULL))
            return false;
    return !ferror(draft);
}

/* Appends the draft to the target. Signals are delivered only while the function opens the target and waits
 * for the lock. If only part of the text could be appended, that part is removed. */
static bool draft_append(const struct file *f)
{
    enum { SECONDS = 10 };
    const char *path = f->target.path;
    struct stat old;
    int file = io_open(path, O_WRONLY | O_CREAT | O_APPEND, 0666, f->interrupt);
    if (file >= 0 && !io_lock(file, SECONDS, f->interrupt)) {
        close(file);
        file = -1;
    }
    if (file < 0)
        return false;
    sigset_t before = io_block();
    bool is_written = fstat(file, &old) == 0 && (!io_ends_in_line(path) || io_write(file, "\n", 1, NULL)) &&
                      draft_copy(f->output.out, repeated_header(f), file);
    int reason = errno;
    if (!is_written)
        (void)!ftruncate(file, old.st_size);
    bool is_closed = close(file) == 0;
    io_unblock(&before);
    errno = is_written ? errno : reason;
    return is_written && is_closed;
}

/* ---- The level ---- */

static const char *file_pop(struct output *o, bool keep)
{
    struct file *f = (struct file *)o;
    errno = 0;
    bool is_written = !ferror(o->out) && fflush(o->out) == 0;
    if (!is_written && dom_raised(f->interrupt))
        errno = ECANCELED;
    if (is_written && keep && f->has_draft)
        is_written = o->append ? draft_append(f) : draft_rename(f);
    int reason = o->error ? o->error : errno;
    if (fclose(o->out) != 0) {
        is_written = false;
        reason = reason ? reason : errno;
    }
    if (f->draft)
        unlink(f->draft);
    free(f->draft);
    target_end(&f->target);
    return is_written ? NULL : target_error(reason);
}

const char *file_push(struct output **top, const char *path, bool append,
                      const volatile sig_atomic_t *interrupt)
{
    struct file *f = malloc(sizeof *f);
    if (!f)
        return strerror(ENOMEM);
    *f = (struct file){.output = {.kind = OUTPUT_FILE, .path = path, .append = append, .pop = file_pop},
                       .interrupt = interrupt};
    const char *wrong = target_begin(&f->target, path, true, NULL);
    if (!wrong && !(f->output.out = file_open(f, path))) {
        wrong = strerror(errno);
        free(f->draft);
        target_end(&f->target);
    }
    if (wrong)
        free(f);
    else
        output_push(top, &f->output);
    return wrong;
}
