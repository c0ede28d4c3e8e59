/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/arena.h"
#include <stdlib.h>
#include <string.h>

struct arena_block {
    struct arena_block *before;
    _Alignas(max_align_t) unsigned char bytes[];
};

enum { BLOCK = 1000 }; /* the size of a block; malloc is fastest for blocks of up to 1 KB */

void *arena_take(struct arena *arena, size_t size)
{
    const size_t align = _Alignof(max_align_t);
    size = (size + align - 1) / align * align;
    if (!arena->block || size > arena->size - arena->used) {
        size_t room = size > BLOCK ? size : BLOCK;
        struct arena_block *block = malloc(sizeof *block + room);
        if (!block)
            return NULL;
        block->before = arena->block;
        arena->block = block;
        arena->used = 0;
        arena->size = room;
    }
    unsigned char *bytes = arena->block->bytes + arena->used;
    arena->used += size;
    return memset(bytes, 0, size);
}

char *arena_text(struct arena *arena, const char *text, size_t length)
{
    char *copy = arena_take(arena, length + 1);
    return copy ? memcpy(copy, text, length) : NULL;
}

void arena_free(struct arena *arena)
{
    while (arena->block) {
        struct arena_block *before = arena->block->before;
        free(arena->block);
        arena->block = before;
    }
    *arena = (struct arena){.block = NULL};
}
