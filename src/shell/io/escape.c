/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* fputs_unlocked */
#include "io/escape.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { PLANE = 0x10000 };

/* Decodes the first character of a string in UTF-8 (RFC 3629). Returns the length of this character in bytes.
 * If the string does not begin with a valid character, returns 0. */
static size_t utf8_next(const char *text, uint32_t *code)
{
    const unsigned char *c = (const unsigned char *)text;
    /* least[n] is the smallest code point whose UTF-8 encoding has n bytes. */
    static const uint32_t least[] = {0, 0, 0x80, 0x800, PLANE};
    size_t length = *c < 0x80 ? 1 : *c >> 5 == 6 ? 2 : *c >> 4 == 14 ? 3 : *c >> 3 == 30 ? 4 : 0;
    *code = length == 1 ? *c : length ? *c & (0x7fu >> length) : 0;
    for (size_t i = 1; i < length; i++) {
        if (c[i] >> 6 != 2) /* a continuation byte is missing; the text may even end here */
            return 0;
        *code = *code << 6 | (c[i] & 0x3fu);
    }
    bool is_surrogate = *code >= 0xd800 && *code <= 0xdfff;
    return length && *code >= least[length] && *code <= 0x10ffff && !is_surrogate ? length : 0;
}

bool escape_is_utf8(const char *text)
{
    uint32_t code;
    for (size_t n = 1; *text && n > 0; text += n)
        n = utf8_next(text, &code);
    return *text == '\0';
}

/* Returns true if a character is invisible or can change how other text is shown. Such characters are control
 * characters, separators of lines and paragraphs, invisible format characters, tags, and codes that are not
 * characters. Returns false for the joiners U+200C and U+200D, because some scripts need them. */
static bool is_hidden(uint32_t code)
{
    static const struct {
        uint32_t first, last;
    } hidden[] = {
        {0x00, 0x1f},     {0x7f, 0x9f},       {0xad, 0xad},       {0x61c, 0x61c},
        {0x180e, 0x180e}, {0x200b, 0x200b},   {0x200e, 0x200f},   {0x2028, 0x202e},
        {0x2060, 0x206f}, {0xfdd0, 0xfdef},   {0xfeff, 0xfeff},   {0xfff0, 0xfffb},
        {0xfffe, 0xffff}, {0x1bca0, 0x1bca3}, {0x1d173, 0x1d17a}, {0xe0000, 0xe0fff},
    };
    bool found = (code & 0xfffe) == 0xfffe; /* the last two codes of every Unicode plane are not characters */
    for (size_t i = 0; i < sizeof hidden / sizeof *hidden && code >= hidden[i].first; i++)
        found = found || code <= hidden[i].last;
    return found;
}

size_t escape_next(const char *text, bool json, char piece[ESCAPE_PIECE])
{
    uint32_t code;
    size_t length = utf8_next(text, &code);
    if (length == 0)
        snprintf(piece, ESCAPE_PIECE, json ? "\\ufffd" : "\\x%02x", (unsigned)(unsigned char)*text);
    else if (json && (*text == '"' || *text == '\\'))
        snprintf(piece, ESCAPE_PIECE, "\\%c", *text);
    else if (!is_hidden(code)) {
        memcpy(piece, text, length);
        piece[length] = '\0';
    } else if (json && code >= PLANE) /* a pair of surrogates */
        snprintf(piece, ESCAPE_PIECE, "\\u%04x\\u%04x", (unsigned)(0xd800 + ((code - PLANE) >> 10)),
                 (unsigned)(0xdc00 + (code & 0x3ff)));
    else {
        const char *format = code < 0x80 && !json ? "\\x%02x" : code < PLANE ? "\\u%04x" : "\\u{%x}";
        snprintf(piece, ESCAPE_PIECE, format, (unsigned)code);
    }
    return length ? length : 1;
}

bool escape_needed(const char *text)
{
    uint32_t code;
    for (size_t length;; text += length) {
        while (*text >= ' ' && *text <= '~') /* a fast path, because nearly all text is ASCII */
            text++;
        if (*text == '\0')
            return false;
        if ((length = utf8_next(text, &code)) == 0 || is_hidden(code))
            return true;
    }
}

const char *escape_text(const char *text, char *shown, size_t size)
{
    static const char more[] = "...";
    char piece[ESCAPE_PIECE];
    size_t n = 0, last = 0; /* the length of the longest prefix that leaves room for "..." */
    for (;;) {
        while (*text >= ' ' && *text <= '~' && n + sizeof more < size)
            shown[n++] = *text++;
        last = n + sizeof more <= size ? n : last;
        if (*text == '\0')
            break;
        text += escape_next(text, false, piece);
        size_t length = strlen(piece);
        if (n + length >= size) {
            memcpy(shown + last, more, sizeof more);
            return shown;
        }
        memcpy(shown + n, piece, length);
        n += length;
    }
    shown[n] = '\0';
    return shown;
}

char *escape_copy(const char *text)
{
    size_t size = strlen(text) * ESCAPE_PIECE + 16;
    char *copy = malloc(size);
    if (copy)
        escape_text(text, copy, size);
    return copy;
}

void escape_json(FILE *out, const char *text)
{
    char piece[ESCAPE_PIECE];
    putc('"', out);
    while (*text) {
        text += escape_next(text, true, piece);
        fputs_unlocked(piece, out);
    }
    putc('"', out);
}
