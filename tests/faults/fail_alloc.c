/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A preloaded library that makes allocations of a program fail: allocation number FAIL_AT, counted from 1,
 * and if FAIL_ON is set, all later allocations as well. FAIL_COUNT may name a file, to which the library
 * writes the number of allocations when the program ends.
 */
#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The allocation functions that the C library exports under other names. */
extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *old, size_t size);

static atomic_long made;
static long at; /* number of the allocation that fails; 0 if none fails */
static bool on;

__attribute__((constructor)) static void begin(void)
{
    const char *text = getenv("FAIL_AT");
    at = text ? atol(text) : 0;
    on = getenv("FAIL_ON") != NULL;
    made = 0;
}

__attribute__((destructor)) static void end(void)
{
    const char *name = getenv("FAIL_COUNT");
    char text[32];
    int file = name ? open(name, O_WRONLY | O_CREAT | O_TRUNC, 0600) : -1;
    if (file >= 0) {
        snprintf(text, sizeof text, "%ld\n", (long)made);
        (void)!write(file, text, strlen(text));
        close(file);
    }
}

static bool fails(void)
{
    long number = ++made;
    if (at == 0 || !(number == at || (on && number > at)))
        return false;
    errno = ENOMEM;
    return true;
}

void *malloc(size_t size)
{
    return fails() ? NULL : __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
    return fails() ? NULL : __libc_calloc(count, size);
}

void *realloc(void *old, size_t size)
{
    return fails() ? NULL : __libc_realloc(old, size);
}
