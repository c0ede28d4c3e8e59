/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Writes answers into the files after '>' and '>>'. Each answer is written completely or not at all: the text
 * first goes to a draft, a temporary file without a name in the folder of the target.
 * - After '>', the draft is copied to a temporary file, which gets the name of the target in a single step,
 * by rename(2). Other hard links to the old file keep the old text. Only SIGKILL during the copy can leave a
 *   file ".domino.XXXXXX".
 * - After '>>', the target is locked, and the draft is copied to its end.
 */
#include "io/output.h"
#include "domino_quad.h"
#include "io/io.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

void output_flush(struct output *o)
{
    fflush(o->out);
    io_stdout_flush();
}

/* Opens the stream that receives the text: the draft or, for a device, a FIFO and standard output, the target
 * itself. */
static FILE *file_open(struct output *o)
{
    const struct target *t = &o->target;
    int file;
    if (t->exists && access(t->path, W_OK) != 0)
        return NULL;
    o->has_draft = !target_is_standard(t) && (!t->exists || S_ISREG(t->status.st_mode));
    if (o->has_draft) {
        file = io_temporary(t->folder, NULL);
        if (file < 0 && o->append && t->exists) /* the draft of an append may be in another folder */
            file = io_temporary(NULL, NULL);
        return file >= 0 ? fdopen(file, "w+") : NULL;
    }
    io_stdout_flush();
    file = target_is_standard(t) ? fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0)
                                 : io_open(t->path, O_WRONLY, 0, o->interrupt);
    return file >= 0 ? io_stream(file, "w", o->interrupt) : NULL;
}

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
static long repeated_header(const struct output *o)
{
    char first[OUTPUT_HEADER + 1], line[sizeof first + 4], last[sizeof line] = "";
    rewind(o->out);
    if (!o->is_header || !fgets(first, sizeof first, o->out) || !o->is_header(first))
        return 0;
    long length = (long)strlen(first);
    FILE *in = io_open_read(o->target.path, o->interrupt);
    for (bool begins = true, ends; in && fgets(line, sizeof line, in); begins = ends) {
        ends = strchr(line, '\n') != NULL;
        header_plain(line);
        if (begins && o->is_header(line))
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

/* Gives a new file the mode and the group of the old file and, for root, its owner. */
static bool mode_copy(const struct target *t, int file)
{
    mode_t mask = umask(0), mode = t->exists ? t->status.st_mode & 0777 : 0666 & ~mask;
    umask(mask);
    /* The owner is set before the mode, because setting it can clear bits of the mode. A mode for another
     * group must not open the file to this group. */
    if (t->exists && fchown(file, t->status.st_uid, t->status.st_gid) != 0 &&
        fchown(file, (uid_t)-1, t->status.st_gid) != 0)
        mode &= 0707;
    return fchmod(file, mode) == 0;
}

static bool draft_rename(const struct output *o)
{
    const struct target *t = &o->target;
    char *name = NULL;
    const int file = io_temporary(t->folder, &name);
    bool is_written = file >= 0 && draft_copy(o->out, 0, file) && mode_copy(t, file);
    is_written = (file < 0 || close(file) == 0) && is_written && rename(name, t->path) == 0;
    int reason = errno;
    if (name && !is_written)
        unlink(name);
    free(name);
    errno = reason;
    return is_written;
}

/* Opens and locks the target for '>>'. If another program has locked it, waits for up to 10 s. The lock keeps
 * out only programs that also use flock(2). Returns -1 on failure. */
static int append_open(const struct output *o)
{
    const struct timespec moment = {.tv_nsec = 10000000};
    int file = io_open(o->target.path, O_WRONLY | O_CREAT | O_APPEND, 0666, o->interrupt), tries = 1000;
    while (file >= 0 && flock(file, LOCK_EX | LOCK_NB) != 0 && (errno == EWOULDBLOCK || errno == EINTR))
        if (--tries == 0 || !io_wait(-1, false, &moment, o->interrupt)) {
            close(file);
            return -1;
        }
    return file;
}

/* If only part of the text can be appended, that part is removed. */
static bool draft_append(const struct output *o, int file)
{
    struct stat old;
    bool is_written = fstat(file, &old) == 0 &&
                      (!io_ends_in_line(o->target.path) || io_write(file, "\n", 1, NULL)) &&
                      draft_copy(o->out, repeated_header(o), file);
    int reason = errno;
    if (!is_written)
        (void)!ftruncate(file, old.st_size);
    bool is_closed = close(file) == 0;
    errno = is_written ? errno : reason;
    return is_written && is_closed;
}

/* Signals are delivered only while the function opens the target of '>>'. */
static bool draft_deliver(const struct output *o)
{
    const int file = o->append ? append_open(o) : -1;
    sigset_t before = io_block();
    bool is_written = !o->append ? draft_rename(o) : file >= 0 && draft_append(o, file);
    io_unblock(&before);
    return is_written;
}

const char *output_pop(struct output **top, bool keep)
{
    struct output *o = *top;
    *top = o->below;
    errno = 0;
    bool is_written = !ferror(o->out) && fflush(o->out) == 0;
    if (!is_written && dom_raised(o->interrupt))
        errno = ECANCELED;
    if (is_written && keep && o->has_draft)
        is_written = draft_deliver(o);
    int reason = o->error ? o->error : errno;
    if (fclose(o->out) != 0) {
        is_written = false;
        reason = reason ? reason : errno;
    }
    target_end(&o->target);
    free(o);
    return is_written ? NULL : target_error(reason);
}

const char *output_push(struct output **top, const char *path, bool append,
                        const volatile sig_atomic_t *interrupt)
{
    struct output *o = malloc(sizeof *o);
    if (!o)
        return strerror(ENOMEM);
    *o = (struct output){.below = *top, .path = path, .append = append, .interrupt = interrupt};
    const char *wrong = target_begin(&o->target, path, true, NULL);
    if (!wrong && !(o->out = file_open(o))) {
        wrong = strerror(errno);
        target_end(&o->target);
    }
    if (wrong)
        free(o);
    else
        *top = o;
    return wrong;
}
