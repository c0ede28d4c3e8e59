/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Writes answers into the files after '>' and '>>'. Each answer is written completely or not at all: the text
 * first goes to a draft, a temporary file without a name in the folder of the target.
 * - After '>', the draft is copied to a temporary file, which gets the name of the target in a single step,
 *   by rename(2). Other hard links to the old file keep the old text. Only SIGKILL during the copy can leave
 * a file ".domino.XXXXXX".
 * - After '>>', the target is locked, and the draft is copied to its end.
 * The log gets a copy of all that goes to standard output.
 */
#include "io/output.h"
#include "domino_quad.h"
#include "io/escape.h"
#include "io/io.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

/* ---- The files that the session is writing ---- */

static struct target *targets;

/* Sets the members of a target. Returns false and sets errno on failure. */
static bool target_resolve(struct target *t, const char *path)
{
    struct stat link;
    t->exists = stat(path, &t->status) == 0;
    if (!t->exists && errno != ENOENT)
        return false;
    t->path = realpath(path, NULL);
    /* The path of a pipe is a link to a name that does not exist. No other such link is followed. */
    if (!t->path && errno == ENOENT && (t->exists || lstat(path, &link) != 0))
        t->path = strdup(path);
    if (!t->path)
        return false;
    const char *slash = strrchr(t->path, '/');
    t->name = slash ? slash + 1 : t->path;
    t->folder = slash ? strndup(t->path, (size_t)(t->name - t->path)) : strdup("./");
    return t->folder && stat(t->folder, &t->below) == 0;
}

static bool is_same_file(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

static bool is_standard(const struct target *t)
{
    struct stat out;
    return t->exists && fstat(STDOUT_FILENO, &out) == 0 && is_same_file(&out, &t->status);
}

/* Returns true if the session is already writing the file, perhaps under another name. */
static bool is_written(const struct target *t, const struct target *except)
{
    struct stat now;
    for (const struct target *other = targets; other; other = other->next)
        if (other != except &&
            ((strcmp(other->name, t->name) == 0 && is_same_file(&other->below, &t->below)) ||
             (t->exists && stat(other->path, &now) == 0 && is_same_file(&now, &t->status))))
            return true;
    return false;
}

static void target_end(struct target *t)
{
    struct target **at = &targets;
    while (*at != t)
        at = &(*at)->next;
    *at = t->next;
    free(t->path);
    free(t->folder);
}

/*
 * Registers a file that will be written. Returns NULL, or a message on failure. Apart from system errors,
 * registering fails in these cases:
 * - The path contains characters that have to be escaped.
 * - The file is standard output, and `may_be_standard` is false.
 * - The session is already writing the file for another target. This is allowed, however, if the other
 *   target is `except` (which may be NULL), or if the file is a device or a FIFO.
 */
static const char *target_begin(struct target *t, const char *path, bool may_be_standard,
                                const struct target *except)
{
    /* a person who reads a script must be able to see which file the script writes */
    if (escape_needed(path))
        return "the name contains control characters, or is not UTF-8; choose another name";
    *t = (struct target){.next = targets};
    const char *wrong = target_resolve(t, path) ? NULL : strerror(errno);
    const bool is_shared = t->exists && !S_ISREG(t->status.st_mode); /* a device may have several writers */
    if (!wrong && ((!may_be_standard && is_standard(t)) || (!is_shared && is_written(t, except))))
        wrong = "this session is already writing to it; choose another file";
    targets = t;
    if (wrong)
        target_end(t);
    return wrong;
}

/* ---- The output ---- */

void output_flush(struct output *o)
{
    fflush(o->out);
    io_stdout_flush();
}

const char *output_push(struct output **top, const char *path, bool append,
                        const volatile sig_atomic_t *interrupt)
{
    struct output *o = malloc(sizeof *o);
    if (!o)
        return strerror(ENOMEM);
    *o = (struct output){.below = *top, .path = path, .append = append, .interrupt = interrupt, .draft = -1};
    struct target *t = &o->target;
    const char *wrong = target_begin(t, path, true, NULL);
    if (wrong) {
        free(o);
        return wrong;
    }
    int file = -1;
    if (t->exists && access(t->path, W_OK) != 0)
        file = -1;
    else if (is_standard(t) || (t->exists && !S_ISREG(t->status.st_mode))) {
        /* A device, a FIFO and standard output get the text itself. */
        io_stdout_flush();
        file = is_standard(t) ? fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0)
                              : io_open(t->path, O_WRONLY, 0, interrupt);
    } else {
        file = io_temporary(t->folder, NULL);
        if (file < 0 && append && t->exists) /* the draft of an append may be in another folder */
            file = io_temporary(NULL, NULL);
        o->draft = file;
    }
    o->out = file >= 0 ? io_stream(file, "w", interrupt) : NULL;
    if (o->out) {
        *top = o;
        return NULL;
    }
    wrong = strerror(errno);
    target_end(t);
    free(o);
    return wrong;
}

/* A csv answer that is appended to a file need not repeat the column names. If the first line of the text is
 * the same as the last header line in the target, returns the length of this line, which is then skipped.
 * Otherwise returns 0. */
static off_t repeated_header(const struct output *o)
{
    char first[OUTPUT_HEADER + 1] = "", line[sizeof first], last[sizeof line] = "";
    if (!o->is_header || pread(o->draft, first, sizeof first - 1, 0) <= 0)
        return 0;
    const size_t length = strcspn(first, "\n") + 1;
    first[length - 1] = '\0';
    if (!o->is_header(first))
        return 0;
    FILE *in = io_open_read(o->target.path, o->interrupt);
    for (bool begins = true, ends; in && fgets(line, sizeof line, in); begins = ends) {
        ends = strchr(line, '\n') != NULL;
        line[strcspn(line, "\n")] = '\0';
        if (begins && o->is_header(line))
            memcpy(last, line, sizeof last);
    }
    if (in)
        fclose(in);
    return strcmp(first, last) == 0 ? (off_t)length : 0;
}

/* Copies the draft, beginning at the offset `from`, to the end of an open file. */
static bool draft_copy(const struct output *o, off_t from, int to)
{
    char block[4096];
    ssize_t n;
    for (; (n = pread(o->draft, block, sizeof block, from)) > 0; from += n)
        if (!io_write(to, block, (size_t)n, NULL))
            return false;
    return n == 0;
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
    char *name = NULL;
    const int file = io_temporary(o->target.folder, &name);
    bool is_good = file >= 0 && draft_copy(o, 0, file) && mode_copy(&o->target, file);
    is_good = (file < 0 || close(file) == 0) && is_good && rename(name, o->target.path) == 0;
    const int reason = errno;
    if (name && !is_good)
        unlink(name);
    free(name);
    errno = reason;
    return is_good;
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
    const bool is_good = fstat(file, &old) == 0 &&
                         (!io_ends_in_line(o->target.path) || io_write(file, "\n", 1, NULL)) &&
                         draft_copy(o, repeated_header(o), file);
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
    if (is_good && keep && o->draft >= 0) {
        /* Signals are delivered only while the target of '>>' is opened. */
        const int file = o->append ? append_open(o) : -1;
        const sigset_t before = io_block();
        is_good = !o->append ? draft_rename(o) : file >= 0 && draft_append(o, file);
        io_unblock(&before);
    }
    const int reason = errno;
    const bool is_closed = fclose(o->out) == 0; /* if not, the stream knows the reason of its first failure */
    const char *wrong = !is_closed              ? strerror(errno)
                        : is_good               ? NULL
                        : reason == EWOULDBLOCK ? "another program has locked it"
                                                : strerror(reason);
    target_end(&o->target);
    free(o);
    return wrong;
}

/* ---- The log ---- */

static struct log {
    struct target target;
    FILE *file;
    bool in_line;     /* the last line in the file is incomplete so far */
    bool in_sequence; /* the last character belongs to a control sequence: ESC, '[', numbers and a letter */
    const char *waiting; /* commands that have not been written yet, or NULL */
    int waiting_length;
} * current; /* NULL if there is no log */

static void commands_write(bool failed)
{
    if (current->waiting)
        fprintf(current->file, "%s%.*s\n", failed ? "# " : "", current->waiting_length, current->waiting);
    current->waiting = NULL;
}

/* Writes text without the control sequences of a terminal. Each line becomes a comment, so that the log can
 * be run as a script. */
static void log_copy(const char *bytes, size_t count)
{
    struct log *l = current;
    commands_write(false);
    for (const char *c = bytes; c < bytes + count; c++) {
        const bool is_control = l->in_sequence || *c == '\033' || *c == '\r';
        l->in_sequence = *c == '\033' || (l->in_sequence && (*c < '@' || *c == '['));
        if (is_control)
            continue;
        if (!l->in_line && *c != '\n')
            fputs("# ", l->file);
        l->in_line = *c != '\n';
        putc(*c, l->file);
    }
}

const char *log_begin(const char *path, const volatile sig_atomic_t *interrupt)
{
    struct log *l = malloc(sizeof *l);
    if (!l)
        return strerror(ENOMEM);
    *l = (struct log){.waiting = NULL};
    const char *wrong = target_begin(&l->target, path, false, current ? &current->target : NULL);
    if (!wrong) {
        io_stdout_flush(); /* the answers before this command do not belong in the log */
        if (current)
            fflush(current->file);
        l->in_line = io_ends_in_line(path);
        const int file = io_open(path, O_WRONLY | O_CREAT | O_APPEND, 0666, interrupt);
        l->file = file < 0 ? NULL : io_stream(file, "a", interrupt);
        wrong = l->file ? NULL : strerror(errno);
        if (wrong)
            target_end(&l->target);
    }
    if (wrong) {
        free(l);
        return wrong;
    }
    log_end();
    fprintf(l->file, "%s# A log of domino " DOM_VERSION ": 'source' it to run its commands again.\n",
            l->in_line ? "\n" : "");
    l->in_line = false;
    current = l;
    io_copy = log_copy;
    return NULL;
}

const char *log_flush(void)
{
    if (!current)
        return NULL;
    io_stdout_flush();
    commands_write(false);
    return fflush(current->file) == 0 && !ferror(current->file) ? NULL : log_end();
}

const char *log_end(void)
{
    if (!current)
        return NULL;
    io_stdout_flush();
    commands_write(false);
    const char *wrong = fclose(current->file) == 0 ? NULL : strerror(errno);
    target_end(&current->target);
    free(current);
    current = NULL;
    io_copy = NULL;
    return wrong;
}

void log_commands(const char *commands, size_t length, bool at_once)
{
    if (!current)
        return;
    io_stdout_flush();
    current->waiting = commands;
    current->waiting_length = (int)length;
    if (at_once)
        commands_write(false);
}

void log_message(const char *text, bool failed)
{
    if (!current)
        return;
    commands_write(failed);
    fprintf(current->file, "# %s\n", text);
}
