/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Writes answers into the files after '>' and '>>'. Each answer is written completely or not at all: its text
 * stays in memory until the command has ended.
 * - After '>', the text goes to a temporary file, which gets the name of the target in a single step, by
 *   rename(2). Other hard links to the old file keep the old text. Only SIGKILL at this moment can leave a
 *   file ".domino.XXXXXX".
 * - After '>>', the target is locked, and the text is added at its end.
 */
#define _GNU_SOURCE /* asprintf, mkostemp */
#include "io/output.h"
#include "domino_quad.h"
#include "io/escape.h"
#include "io/io.h"
#include "io/terminal.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

char *output_reserved;
const char output_in_use[] = "this session is already writing to it; choose another file";

/* ---- Files ---- */

const char *output_target(const char *path, char **target, struct stat *status)
{
    struct stat link;
    *target = NULL;
    *status = (struct stat){.st_mode = 0};
    /* a person who reads a script must be able to see which file the script writes */
    if (escape_needed(path))
        return "the name contains control characters, or is not UTF-8; choose another name";
    /* The name itself is asked first: another program may create or remove the file between the two calls. */
    const bool is_link = lstat(path, &link) == 0 && S_ISLNK(link.st_mode);
    if (stat(path, status) == 0) {
        *target = realpath(path, NULL);
        if (!*target) /* the path of a pipe is a link to a name that does not exist */
            *target = strdup(path);
    } else if (errno == ENOENT && !is_link) { /* a link to a name that does not exist is not followed */
        const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
        char *folder = slash ? strndup(path, (size_t)(name - path)) : strdup("."),
             *real = folder ? realpath(folder, NULL) : NULL;
        if (real && asprintf(target, "%s/%s", real, name) < 0)
            *target = NULL;
        free(folder);
        free(real);
    }
    return *target ? NULL : strerror(errno);
}

bool output_is_standard(const struct stat *status)
{
    struct stat out;
    return status->st_mode && fstat(STDOUT_FILENO, &out) == 0 && out.st_dev == status->st_dev &&
           out.st_ino == status->st_ino;
}

/* ---- The output ---- */

void output_flush(struct output *o)
{
    fflush(o->out);
    io_stdout_flush();
}

char *output_folder(const struct output *o)
{
    const char *slash = o->is_regular ? strrchr(o->target, '/') : NULL;
    return slash ? strndup(o->target, (size_t)(slash - o->target) + (slash == o->target)) : NULL;
}

/* Opens the stream of an output whose target is known. Returns NULL, or the reason why there is none. */
static const char *output_open(struct output *o)
{
    const bool exists = o->status.st_mode, to_standard = output_is_standard(&o->status);
    o->is_regular = !to_standard && (!exists || S_ISREG(o->status.st_mode));
    bool is_used = o->is_regular && output_reserved && strcmp(output_reserved, o->target) == 0;
    for (const struct output *outer = o->below; outer && o->is_regular; outer = outer->below)
        is_used = is_used || (outer->target && strcmp(outer->target, o->target) == 0);
    if (is_used)
        return output_in_use;
    char *folder = output_folder(o);
    const bool is_allowed = (!exists || access(o->target, W_OK) == 0) &&
                            (!folder || (exists && o->append) || access(folder, W_OK) == 0);
    free(folder);
    if (!is_allowed)
        return strerror(errno);
    if (o->is_regular)
        o->out = io_memory(&o->text, &o->size);
    else { /* a device, a FIFO and standard output get the text as it is written */
        io_stdout_flush();
        const int file =
            to_standard ? fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0) : io_open(o->target, O_WRONLY, 0);
        o->out = file >= 0 ? io_stream(file, "w") : NULL;
    }
    return o->out ? NULL : strerror(errno);
}

static void output_free(struct output *o)
{
    free(o->target);
    free(o->text);
    free(o);
}

const char *output_push(struct output **top, const char *path, bool append)
{
    struct output *o = malloc(sizeof *o);
    if (!o)
        return strerror(ENOMEM);
    *o = (struct output){.below = *top, .path = path, .append = append};
    const char *wrong = output_target(path, &o->target, &o->status);
    wrong = wrong ? wrong : output_open(o);
    if (wrong)
        output_free(o);
    else
        *top = o;
    return wrong;
}

/* A csv answer that is appended to a file need not repeat the column names. If the first line of the text is
 * the same as the last header line in the target, returns the length of this line, which is then skipped.
 * Otherwise returns 0. */
static size_t repeated_header(const struct output *o)
{
    char first[OUTPUT_HEADER], line[sizeof first], last[sizeof line] = "";
    const size_t length = strcspn(o->text, "\n");
    if (!o->is_header || length >= sizeof first)
        return 0;
    snprintf(first, sizeof first, "%.*s", (int)length, o->text);
    if (!o->is_header(first))
        return 0;
    FILE *in = io_open_read(o->target);
    for (bool begins = true, ends; in && fgets(line, sizeof line, in); begins = ends) {
        ends = strchr(line, '\n') != NULL;
        line[strcspn(line, "\n")] = '\0';
        if (begins && o->is_header(line))
            memcpy(last, line, sizeof last);
    }
    if (in)
        fclose(in);
    return strcmp(first, last) == 0 ? length + 1 : 0;
}

/* Gives a new file the mode and the group of the old file and, for root, its owner. */
static bool mode_copy(const struct stat *old, int file)
{
    mode_t mask = umask(0), mode = old->st_mode ? old->st_mode & 0777 : 0666 & ~mask;
    umask(mask);
    /* The owner is set before the mode, because setting it can clear bits of the mode. A mode for another
     * group must not open the file to this group. */
    if (old->st_mode && fchown(file, old->st_uid, old->st_gid) != 0 &&
        fchown(file, (uid_t)-1, old->st_gid) != 0)
        mode &= 0707;
    return fchmod(file, mode) == 0;
}

static bool text_rename(const struct output *o)
{
    char *name = NULL, *folder = output_folder(o);
    if (folder && asprintf(&name, "%s/.domino.XXXXXX", folder) < 0)
        name = NULL;
    const int file = name ? mkostemp(name, O_CLOEXEC) : -1;
    bool is_good = file >= 0 && io_write(file, o->text, o->size, NULL) && mode_copy(&o->status, file);
    is_good = (file < 0 || close(file) == 0) && is_good && rename(name, o->target) == 0;
    const int reason = errno;
    if (file >= 0 && !is_good)
        unlink(name);
    free(name);
    free(folder);
    errno = reason;
    return is_good;
}

/* Opens and locks the target for '>>'. If another program has locked it, waits for up to 10 s. The lock keeps
 * out only programs that also use flock(2). Returns -1 on failure. */
static int append_open(const struct output *o)
{
    const struct timespec moment = {.tv_nsec = 10000000};
    const double end = terminal_clock() + 10;
    int file = io_open(o->target, O_WRONLY | O_CREAT | O_APPEND, 0666);
    while (file >= 0 && flock(file, LOCK_EX | LOCK_NB) != 0 && (errno == EWOULDBLOCK || errno == EINTR))
        if (terminal_clock() > end || !io_wait(-1, false, &moment, io_interrupt)) {
            close(file);
            return -1;
        }
    return file;
}

/* If only part of the text can be appended, that part is removed. */
static bool text_append(const struct output *o, int file)
{
    struct stat old;
    const size_t from = repeated_header(o);
    const bool is_good = fstat(file, &old) == 0 &&
                         (!io_ends_in_line(o->target) || io_write(file, "\n", 1, NULL)) &&
                         io_write(file, o->text + from, o->size - from, NULL);
    const int reason = errno;
    if (!is_good)
        (void)!ftruncate(file, old.st_size);
    const bool is_closed = close(file) == 0;
    errno = is_good ? errno : reason;
    return is_good && is_closed;
}

const char *output_pop(struct output **top, bool keep)
{
    struct output *o = *top;
    *top = o->below;
    errno = 0;
    bool is_good = fflush(o->out) == 0 && !ferror(o->out);
    if (is_good && keep && o->is_regular) {
        if (!o->text) /* nothing was written */
            o->text = strdup("");
        /* Signals are delivered only while the target of '>>' is opened. */
        const int file = o->append && o->text ? append_open(o) : -1;
        const sigset_t before = io_block();
        is_good = o->text && (!o->append ? text_rename(o) : file >= 0 && text_append(o, file));
        io_unblock(&before);
    }
    const int reason = errno ? errno : ENOMEM;  /* the text did not fit into memory */
    const bool is_closed = fclose(o->out) == 0; /* if not, the stream knows the reason of its first failure */
    const char *wrong = !is_closed              ? strerror(errno)
                        : is_good               ? NULL
                        : reason == EWOULDBLOCK ? "another program has locked it"
                                                : strerror(reason);
    output_free(o);
    return wrong;
}
