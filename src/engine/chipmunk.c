/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"
#include <dlfcn.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#if defined __GLIBC__ || defined __linux__
#include <stdio_ext.h>
#define STREAM_DROP __fpurge
#else
#define STREAM_DROP fpurge
#endif

/* Bytes to reserve. Chipmunk 7.0.3 needs at most 0.4 MB for a space and 4 kB for each box. */
enum { SPACE = 1 << 20, BOX = 1 << 14 };

static pthread_mutex_t room_lock = PTHREAD_MUTEX_INITIALIZER;
static size_t reserved; /* bytes reserved for all existing Chipmunk spaces */

bool chipmunk_reserve(size_t boxes)
{
    const size_t more = SPACE + BOX * boxes;
    pthread_mutex_lock(&room_lock);
    /* volatile, because gcc could otherwise remove a malloc whose result is only freed */
    void *volatile room = malloc(reserved + more);
    const bool found = room;
    free(room);
    if (found)
        reserved += more;
    pthread_mutex_unlock(&room_lock);
    return found;
}

void chipmunk_release(size_t boxes)
{
    pthread_mutex_lock(&room_lock);
    reserved -= SPACE + BOX * boxes;
    pthread_mutex_unlock(&room_lock);
}

/* ---- The library ---- */

static struct chipmunk functions;
static bool loaded;

/* ISO C cannot convert void * to a function pointer, so the bytes are copied. */
static bool find(void *library, const char *name, void *member)
{
    void *address = dlsym(library, name);
    memcpy(member, &address, sizeof address);
    return address;
}

/*
 * Creates the first space of the process. If the Chipmunk library was built with assertions, as in Debian,
 * this call prints the library's name and version to `stdout`, and there is no way to tell it not to. The
 * text stays in the buffer of `stdout`, and is dropped. Because `stdout` is locked, another thread that
 * prints waits, and loses nothing. In glibc, a line-buffered stream that was written to before, for
 * example by Readline, would still write the beginning of the text. `fseek` resets the stream, even though it
 * fails at a terminal. Afterwards `stdout` has the same buffering as at the start of a program.
 */
static void make_first(void)
{
    flockfile(stdout);
    fflush(stdout);
    setvbuf(stdout, NULL, _IOFBF, BUFSIZ);
    fseek(stdout, 0, SEEK_CUR);
    functions.cpSpaceFree(functions.cpSpaceNew());
    STREAM_DROP(stdout);
    setvbuf(stdout, NULL, isatty(STDOUT_FILENO) ? _IOLBF : _IOFBF, BUFSIZ);
    funlockfile(stdout);
}

static void load(void)
{
    /* The names of the library on Linux and FreeBSD, on macOS, and in Homebrew on macOS. */
    static const char *const names[] = {"libchipmunk.so.7", "libchipmunk.dylib",
                                        "/opt/homebrew/lib/libchipmunk.dylib"};
    void *library = NULL;
    for (size_t i = 0; i < sizeof names / sizeof *names && !library; i++)
        library = dlopen(names[i], RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return;
    loaded = true;
#define FIND(name) loaded = find(library, #name, &functions.name) && loaded;
    CHIPMUNK_FUNCTIONS(FIND)
#undef FIND
    const char *const *version = dlsym(library, "cpVersionString");
    snprintf(functions.version, sizeof functions.version, "%s", version ? *version : "7");
    if (loaded)
        make_first();
}

enum dom_status chipmunk_load(const struct chipmunk **found)
{
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    static bool tried;
    pthread_mutex_lock(&lock);
    /* Chipmunk crashes if an allocation fails. So the library is loaded only if there is enough memory for it
     * and for the space that make_first creates. */
    const bool room = tried || chipmunk_reserve(0);
    if (room && !tried) {
        load();
        chipmunk_release(0);
        tried = true;
    }
    pthread_mutex_unlock(&lock);
    *found = &functions;
    return !room ? DOM_NO_MEMORY : loaded ? DOM_OK : DOM_NO_METHOD;
}

enum dom_status engine_load(void)
{
    const struct chipmunk *cp;
    return chipmunk_load(&cp);
}

const char *engine_version(void)
{
    const struct chipmunk *cp;
    return chipmunk_load(&cp) == DOM_OK ? cp->version : NULL;
}
