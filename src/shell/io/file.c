/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Files after '>' and '>>', written whole or not at all.  The text goes into a temporary file without a name,
 * of which nothing is left however the program ends.  In the end it is copied: into a new file that takes the
 * place of the old one, or into the file itself, which is locked meanwhile.
 */
#include "io/file.h"
#include "domino_quad.h"
#include "io/escape.h"
#include "io/io.h"
#include "io/output.h"
#include "io/standard.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct file {
    struct output output; /* first: a pointer to one is a pointer to the other */
    struct target target;
    bool held; /* the stream is the temporary file; else the text goes to a device or FIFO as it comes */
    const volatile sig_atomic_t *interrupt;
};

/* ---- Targets ---- */

/* The latest first. */
static struct target *targets;

/* Returns a path without the links that its last name is: realpath() follows none that points at nothing.
 * NULL with errno. */
static char *real_path(const char *path)
{
    char *real = realpath(path, NULL), *at = !real && errno == ENOENT ? strdup(path) : NULL;
    char target[PATH_MAX];
    for (ssize_t n; at && (n = readlink(at, target, sizeof target - 1)) >= 0;) {
        target[n] = '\0';
        char *slash = strrchr(at, '/'), *next;
        int folder = slash && *target != '/' ? (int)(slash + 1 - at) : 0;
        if (asprintf(&next, "%.*s%s", folder, at, target) < 0)
            next = NULL;
        free(at);
        at = next;
    }
    return real ? real : at;
}

/* Returns true if an open target is the file of the other one. */
static bool is_same(const struct target *open, const struct target *t)
{
    struct stat now;
    return strcmp(open->path, t->path) == 0 ||
           (t->exists && stat(open->path, &now) == 0 && now.st_dev == t->status.st_dev &&
            now.st_ino == t->status.st_ino);
}

bool target_is_standard(const struct target *t)
{
    struct stat out;
    return t->exists && fstat(STDOUT_FILENO, &out) == 0 && out.st_dev == t->status.st_dev &&
           out.st_ino == t->status.st_ino;
}

const char *target_begin(struct target *t, const char *path, bool may_be_standard,
                         const struct target *except)
{
    if (escape_needed(path)) /* what a script asks for must be what its reader sees */
        return "the name has control characters, or is not UTF-8; no such file is written";
    *t = (struct target){.path = real_path(path), .next = targets};
    if (!t->path)
        return strerror(errno);
    t->exists = stat(path, &t->status) == 0;
    bool written = !may_be_standard && target_is_standard(t);
    bool regular = !t->exists || S_ISREG(t->status.st_mode);
    for (const struct target *o = targets; o && regular && !written; o = o->next)
        written = o != except && is_same(o, t);
    if (written) {
        free(t->path);
        return "this session is writing it already; choose another file";
    }
    targets = t;
    return NULL;
}

void target_end(struct target *t)
{
    struct target **at = &targets;
    while (*at != t)
        at = &(*at)->next;
    *at = t->next;
    free(t->path);
}

/* ---- The beginning ---- */

/* Opens a temporary file in the folder of the file, or where temporary files are; NULL with errno if a new
 * file may not be made in that folder. */
static FILE *text_open(const struct target *t)
{
    const char *slash = t->path ? strrchr(t->path, '/') : NULL;
    char *folder = slash ? strndup(t->path, (size_t)(slash + 1 - t->path)) : strdup(".");
    FILE *text = folder ? io_temporary(folder) : NULL;
    free(folder);
    return text || !t->exists ? text : io_temporary(NULL);
}

/* Opens the stream of the level.  NULL with errno. */
static FILE *file_open(struct file *f, const char *path)
{
    const struct target *t = &f->target;
    if (t->exists && access(path, W_OK) != 0)
        return NULL;
    if (target_is_standard(t)) {
        standard_flush();
        return fdopen(fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0), "a");
    }
    f->held = !t->exists || S_ISREG(t->status.st_mode);
    if (f->held)
        return text_open(t);
    int file = io_open(path, O_WRONLY, 0, f->interrupt);
    return file >= 0 ? io_stream(file, "w", f->interrupt) : NULL;
}

/* ---- The end ---- */

/* Returns how many bytes of the text are a line that names columns and is the last such line of the file:
 * rows that are appended go on below it. */
static long head_again(const struct file *f)
{
    char first[OUTPUT_HEAD + 1], line[sizeof first], last[sizeof first] = "";
    bool (*is_head)(const char *) = f->output.is_head;
    rewind(f->output.out);
    if (!is_head || !fgets(first, sizeof first, f->output.out) || !is_head(first))
        return 0;
    FILE *in = io_read(f->target.path, f->interrupt);
    for (bool begins = true; in && fgets(line, sizeof line, in); begins = strchr(line, '\n') != NULL)
        if (begins && is_head(line))
            memcpy(last, line, sizeof last);
    if (in)
        fclose(in);
    return strcmp(first, last) == 0 ? (long)strlen(first) : 0;
}

/* Copies the text from a place on into an open file, from its current place; false with errno. */
static bool text_copy(FILE *text, long from, int to)
{
    char block[4096];
    size_t n;
    fseek(text, from, SEEK_SET);
    while ((n = fread(block, 1, sizeof block, text)) > 0)
        if (!io_write(to, block, n))
            return false;
    return !ferror(text);
}

/*
 * Copies the text into the file, or appends it.  If there is no room, the file stays as it was: room is taken
 * before the first byte is written over, and rows that were appended only in part are removed.
 */
static bool file_fill(const struct file *f, int file)
{
    const struct output *o = &f->output;
    struct stat old, text;
    if (fstat(file, &old) != 0 || fstat(fileno(o->out), &text) != 0)
        return false;
    int reason = o->append || text.st_size == 0 ? 0 : posix_fallocate(file, 0, text.st_size);
    bool room = reason == 0 || reason == EINVAL || reason == EOPNOTSUPP;
    bool whole = room && text_copy(o->out, o->append ? head_again(f) : 0, file);
    reason = room ? errno : reason;
    if (!(whole && o->append) && ftruncate(file, whole ? text.st_size : old.st_size) != 0 && whole)
        return false;
    errno = reason;
    return whole;
}

/* Makes a new file beside the one whose place it is to take, with its group and mode.  -1 where that may not
 * be. */
static int beside(const struct target *t, char **name)
{
    const struct stat *now = t->exists ? &t->status : NULL;
    mode_t mask = umask(0);
    umask(mask);
    /* The name begins as that of the file, and is short enough wherever that is. */
    enum { SHOWN = 100 };
    const char *slash = strrchr(t->path, '/'), *last = slash ? slash + 1 : t->path;
    size_t length = strlen(last);
    for (length = length < SHOWN ? length : SHOWN; ((unsigned char)last[length] & 0xc0) == 0x80;)
        length--; /* no character of UTF-8 is cut */
    int all = (int)(last - t->path) + (int)length;
    int file = asprintf(name, "%.*s.XXXXXX", all, t->path) < 0 ? -1 : mkostemp(*name, O_CLOEXEC);
    /* The group first: its change takes away bits of the mode. */
    if (file < 0 || ((!now || fchown(file, (uid_t)-1, now->st_gid) == 0) &&
                     fchmod(file, now ? now->st_mode & 0777 : 0666 & ~mask) == 0))
        return file;
    close(file);
    unlink(*name);
    return -1;
}

/* Opens the file itself, and locks it against other programs that append to it.  -1 with errno. */
static int file_lock(const struct file *f)
{
    enum { SECONDS = 10 };
    int flags = O_WRONLY | O_CREAT | (f->output.append ? O_APPEND : 0);
    int file = io_open(f->target.path, flags, 0666, f->interrupt);
    if (file < 0 || io_lock(file, SECONDS, f->interrupt))
        return file;
    int reason = errno;
    close(file);
    errno = reason;
    return -1;
}

/* Writes the text into the file, which no signal leaves half done.  False with errno. */
static bool file_commit(const struct file *f)
{
    const struct target *t = &f->target;
    /* A file with several names, or of another owner, keeps its place. */
    bool keeps = f->output.append || (t->exists && (t->status.st_nlink > 1 || t->status.st_uid != geteuid()));
    char *name = NULL;
    sigset_t before = io_block();
    int file = keeps ? -1 : beside(t, &name);
    bool moves = file >= 0;
    if (keeps || (!moves && t->exists)) {
        io_unblock(&before);
        file = file_lock(f);
        before = io_block();
    }
    bool whole = file >= 0 && file_fill(f, file);
    int reason = errno;
    if (file >= 0 && close(file) != 0 && whole) {
        whole = false;
        reason = errno;
    }
    if (moves && whole && rename(name, t->path) != 0) {
        whole = false;
        reason = errno;
    }
    if (moves && !whole)
        unlink(name);
    io_unblock(&before);
    free(name);
    errno = reason;
    return whole;
}

static const char *file_pop(struct output *o, bool keep)
{
    struct file *f = (struct file *)o;
    errno = 0;
    bool whole = !ferror(o->out) && fflush(o->out) == 0;
    if (!whole && dom_raised(f->interrupt))
        errno = ECANCELED;
    if (whole && keep && f->held)
        whole = file_commit(f);
    int reason = o->error ? o->error : errno;
    if (fclose(o->out) != 0 && whole) {
        whole = false;
        reason = errno;
    }
    target_end(&f->target);
    return whole                   ? NULL
           : reason == EWOULDBLOCK ? "another program has locked it"
           : reason                ? strerror(reason)
                                   : "the device is full, or not there any more";
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
