/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An arena hands out pieces of memory and frees all of them at once. A parsed command lives in an arena until
 * the command has run. `struct arena arena = {.block = NULL}` is an empty arena. */
#pragma once

#include <stddef.h>

struct arena {
    struct arena_block *block; /* a linked list, whose first block is the current one */
    size_t used, size;         /* the number of bytes used in the current block, and the size of this block */
};

/* Returns zeroed memory that is aligned for any type, or NULL if memory runs out. */
void *arena_take(struct arena *arena, size_t size);

/* Returns a NUL-terminated copy of the first `length` bytes of a string, or NULL if memory runs out. */
char *arena_text(struct arena *arena, const char *text, size_t length);

/* Frees all memory of the arena. The arena is then empty and can be used again. */
void arena_free(struct arena *arena);
