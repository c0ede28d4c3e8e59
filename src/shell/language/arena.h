/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Memory that is freed at once: what a command line was parsed into lives until the line has run. The first
 * pieces come from a block inside the arena, so that most lines allocate nothing.
 */
#ifndef SHELL_ARENA_H
#define SHELL_ARENA_H

#include <stddef.h>

enum { ARENA_FIRST = 6144 };

struct arena {
    struct arena_block *block; /* the blocks on the heap, the last one first; NULL: none */
    size_t used, size;         /* of the last block, or of `first` */
    _Alignas(max_align_t) unsigned char first[ARENA_FIRST];
};

/* Begins an arena; `first` needs no initial value. */
static inline void arena_begin(struct arena *arena)
{
    arena->block = NULL;
    arena->used = 0;
    arena->size = ARENA_FIRST;
}

/* Returns so many bytes, all zero, aligned for any type; NULL: no memory. */
void *arena_take(struct arena *arena, size_t size);

/* Returns a copy of text of this length; NULL: no memory. */
char *arena_text(struct arena *arena, const char *text, size_t length);

/* Frees everything that was taken; the arena can be used again. */
void arena_free(struct arena *arena);

#endif
