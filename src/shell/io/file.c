/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Writes answers into the files after '>' and '>>'. Each answer is written completely or not at all.
 * - At first, the text goes to a temporary file without a name. If the program is killed, this file vanishes.
 * - After '>', the text is then copied into a new file in the folder of the target. This new file is called
 *   the replacement. It is renamed to the target, so the target changes in a single step.
 * - After '>>', the target is locked, and the text is appended to it.
 * - If the target has several hard links or belongs to another user, renaming would break the links or change
 *   the owner. Such a target is locked and overwritten in place. A target is also overwritten in place if the
 *   replacement cannot be created.
 */
#define _GNU_SOURCE /* asprintf, mkostemp */
#include "domino_quad.h"
#include "io/io.h"
#include "io/output.h"
#include "io/system.h"
#include "io/target.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct file {
    /* must be the first member, so that a pointer to it is also a pointer to struct file */
    struct output output;
    struct target target;
    /* `out` is a temporary file; false if it is the target itself, which may be a device or a FIFO */
    bool is_held;
    const volatile sig_atomic_t *interrupt;
};

/* Opens the temporary file in the folder of the target. If the target exists, but no file can be created in
 * its folder, opens the temporary file in the usual folder for such files. */
static FILE *held_open(const struct target *t)
{
    char *folder = strndup(t->path, (size_t)(strrchr(t->path, '/') + 1 - t->path));
    FILE *held = folder ? io_temporary(folder) : NULL;
    free(folder);
    return held || !t->exists ? held : io_temporary(NULL);
}

/* Opens the stream that receives the text. If the target is a device, a FIFO or standard output, the stream
 * writes directly to the target. Otherwise, the stream writes to a temporary file. */
static FILE *file_open(struct file *f, const char *path)
{
    const struct target *t = &f->target;
    if (t->exists && access(path, W_OK) != 0)
        return NULL;
    if (target_is_standard(t)) {
        io_stdout_flush();
        return fdopen(fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0), "a");
    }
    f->is_held = !t->exists || S_ISREG(t->status.st_mode);
    if (f->is_held)
        return held_open(t);
    int file = io_open(path, O_WRONLY, 0, f->interrupt);
    return file >= 0 ? io_stream(file, "w", f->interrupt) : NULL;
}

/* ---- The end ---- */

/* A csv answer that is appended to a file need not repeat the column names. If the first line of the text is
 * the same as the last header line in the target, returns the length of this line, which is then skipped.
 * Otherwise returns 0. */
static long repeated_header(const struct file *f)
{
    char first[OUTPUT_HEADER + 1], line[sizeof first], last[sizeof first] = "";
    bool (*is_header)(const char *) = f->output.is_header;
    rewind(f->output.out);
    if (!is_header || !fgets(first, sizeof first, f->output.out) || !is_header(first))
        return 0;
    FILE *in = io_open_read(f->target.path, f->interrupt);
    for (bool begins = true; in && fgets(line, sizeof line, in); begins = strchr(line, '\n') != NULL)
        if (begins && is_header(line))
            memcpy(last, line, sizeof last);
    if (in)
        fclose(in);
    return strcmp(first, last) == 0 ? (long)strlen(first) : 0;
}

/* Copies the text, beginning at the offset `from`, into an open file. Sets errno on failure. */
static bool text_copy(FILE *text, long from, int to)
{
    char block[4096];
    size_t n;
    fseek(text, from, SEEK_SET);
    while ((n = fread(block, 1, sizeof block, text)) > 0)
        if (!io_write(to, block, n, NULL))
            return false;
    return !ferror(text);
}

/* Overwrites an open file with the text or, after '>>', appends the text to it. Then closes the file. If the
 * disk is full, the file keeps its old contents, provided that the file system can reserve space. Sets errno
 * on failure. */
static bool file_fill(const struct file *f, int file)
{
    const struct output *o = &f->output;
    struct stat old, text;
    fstat(file, &old);
    fstat(fileno(o->out), &text);
    /* Space is reserved before the first byte is overwritten. */
    errno = o->append ? 0 : system_reserve(file, 0, text.st_size);
    bool is_copied = errno == 0 && text_copy(o->out, o->append ? repeated_header(f) : 0, file);
    int reason = errno;
    /* If only part of the text could be appended, that part is removed. */
    bool is_cut = (is_copied && o->append) || ftruncate(file, is_copied ? text.st_size : old.st_size) == 0;
    bool is_closed = close(file) == 0;
    errno = is_copied ? errno : reason;
    return is_copied && is_cut && is_closed;
}

enum { REPLACEMENT = PATH_MAX + 32 };

/* Creates the replacement. It gets the group and the mode of the target, if the target exists. Returns -1 if
 * the replacement cannot be created, or if its group or mode cannot be set. */
static int replacement_open(const struct target *t, char name[REPLACEMENT])
{
    mode_t mask = umask(0);
    umask(mask);
    int folder = (int)(strrchr(t->path, '/') - t->path);
    snprintf(name, REPLACEMENT, "%.*s/.domino.XXXXXX", folder, t->path);
    int file = mkostemp(name, O_CLOEXEC);
    /* The group is set before the mode, because setting the group can clear bits of the mode. */
    if (file >= 0 && (!t->exists || fchown(file, (uid_t)-1, t->status.st_gid) == 0) &&
        fchmod(file, t->exists ? t->status.st_mode & 0777 : 0666 & ~mask) == 0)
        return file;
    if (file >= 0) {
        close(file);
        unlink(name);
    }
    *name = '\0';
    return -1;
}

/* Opens and locks the target itself, to append to it or to overwrite it in place. Returns -1 and sets errno
 * on failure. */
static int file_lock(const struct file *f)
{
    enum { SECONDS = 10 };
    int flags = O_WRONLY | O_CREAT | (f->output.append ? O_APPEND : 0);
    int file = io_open(f->target.path, flags, 0666, f->interrupt);
    if (file < 0 || io_lock(file, SECONDS, f->interrupt))
        return file;
    close(file);
    return -1;
}

/* Writes the text into the target. Signals are blocked, so that they cannot interrupt the writing halfway.
 * They are delivered only while the function opens the target and waits for the lock. Sets errno on
 * failure. */
static bool file_commit(const struct file *f)
{
    const struct target *t = &f->target;
    bool in_place =
        f->output.append || (t->exists && (t->status.st_nlink > 1 || t->status.st_uid != geteuid()));
    char replacement[REPLACEMENT] = "";
    sigset_t before = io_block();
    int file = in_place ? -1 : replacement_open(t, replacement);
    if (file < 0 && (in_place || t->exists)) {
        io_unblock(&before);
        file = file_lock(f);
        before = io_block();
    }
    bool is_written = file >= 0 && file_fill(f, file) && (!*replacement || rename(replacement, t->path) == 0);
    int reason = errno;
    if (*replacement && !is_written)
        unlink(replacement);
    io_unblock(&before);
    errno = reason;
    return is_written;
}

static const char *file_pop(struct output *o, bool keep)
{
    struct file *f = (struct file *)o;
    errno = 0;
    bool is_written = !ferror(o->out) && fflush(o->out) == 0;
    if (!is_written && dom_raised(f->interrupt))
        errno = ECANCELED;
    if (is_written && keep && f->is_held)
        is_written = file_commit(f);
    int reason = o->error ? o->error : errno;
    if (fclose(o->out) != 0 && is_written) {
        is_written = false;
        reason = errno;
    }
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
        target_end(&f->target);
    }
    if (wrong)
        free(f);
    else
        output_push(top, &f->output);
    return wrong;
}
