/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/terminal.h"
#include "pictures/picture/picture.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* How the inks look on a terminal: the escape code of the colour, or 0 for the default colour of text; and
 * the character that draws a curve without braille. */
static const struct {
    int code;
    char letter;
} inks[INKS] = {
    [INK_TEXT] = {0, '*'},    [INK_BLUE] = {34, 'o'},   [INK_RED] = {31, '#'}, [INK_GREEN] = {32, '+'},
    [INK_PURPLE] = {35, 'x'}, [INK_ORANGE] = {33, '%'}, [INK_SKY] = {36, '@'}, [INK_GREY] = {0, '.'},
};

struct display display_of(FILE *stream)
{
    static const char *const without_braille[] = {"dumb", "linux", "vt", "cons"};
    const char *term = getenv("TERM"), *no = getenv("NO_COLOR");
    if (!terminal_shows(stream) || !term)
        return (struct display){.braille = false};
    struct display display = {.braille = terminal_utf8(),
                              .colours = !(no && *no) && *term && strcmp(term, "dumb") != 0};
    for (size_t k = 0; k < sizeof without_braille / sizeof *without_braille; k++)
        display.braille &= strncmp(term, without_braille[k], strlen(without_braille[k])) != 0;
    return display;
}

bool canvas_make(struct canvas *c, struct display display, int width, int height)
{
    const size_t cells = (size_t)width * (size_t)height;
    *c = (struct canvas){.display = display,
                         .width = width,
                         .height = height,
                         .right = width,
                         .bottom = height,
                         .across = display.braille ? 2 : 1,
                         .down = display.braille ? 4 : 1};
    c->cell = calloc(cells ? cells : 1, sizeof *c->cell);
    return c->cell != NULL;
}

/* ---- Dots ---- */

void canvas_dot(struct canvas *c, int x, int y, enum ink ink)
{
    static const unsigned char dots[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
    const int column = x / c->across, row = y / c->down;
    if (x < 0 || y < 0 || column < c->left || column >= c->right || row < c->top || row >= c->bottom)
        return;
    struct canvas_cell *cell = &c->cell[row * c->width + column];
    cell->glyph[0] = '\0';
    cell->dots |= dots[y % c->down][x % c->across];
    cell->ink = (unsigned char)ink;
}

/* Returns true if a dot of a dashed line is drawn. `phase` is the position of the dot in the dash pattern. On
 * terminals without braille, all lines are unbroken. */
static bool dash_on(const struct canvas *c, int dash, int phase)
{
    static const struct {
        unsigned bits; /* one bit for each dot of the pattern, with the first dot in the lowest bit */
        int length;
    } dashes[DASHES] = {{1, 1}, {0x0f, 7}, {0x1, 3}, {0x11f, 11}, {0x3, 5}};
    const int k = dash % DASHES;
    return !c->display.braille || (dashes[k].bits >> phase % dashes[k].length & 1) != 0;
}

void canvas_line(struct canvas *c, double x0, double y0, double x1, double y1, enum ink ink, int dash,
                 int *phase)
{
    double dx = x1 - x0, dy = y1 - y0, length = fmax(fabs(dx), fabs(dy));
    if (!(fabs(x0) + fabs(y0) + length < 1e7)) /* far outside */
        return;
    int steps = (int)ceil(length);
    for (int i = 0; i <= steps; i++) {
        double part = steps ? (double)i / steps : 0;
        if (dash_on(c, dash, *phase))
            canvas_dot(c, (int)floor(x0 + part * dx), (int)floor(y0 + part * dy), ink);
        *phase += i < steps;
    }
}

/* Writes a braille character or, without braille, the character of the ink. Returns its length in bytes. */
static int dots_text(const struct canvas *c, unsigned dots, int ink, char glyph[GLYPH])
{
    if (!c->display.braille)
        return snprintf(glyph, GLYPH, "%c", inks[ink].letter);
    return snprintf(glyph, GLYPH, "\xe2%c%c", (int)(0xa0 | dots >> 6), (int)(0x80 | (dots & 0x3f)));
}

void canvas_sample(const struct canvas *c, enum ink ink, int dash, char sample[4 * GLYPH])
{
    for (int k = 0, used = 0; k < (c->display.braille ? 3 : 1); k++)
        used +=
            dots_text(c, (dash_on(c, dash, 2 * k) ? 0x04u : 0) | (dash_on(c, dash, 2 * k + 1) ? 0x20u : 0),
                      (int)ink, sample + used);
}

/* ---- Text ---- */

void canvas_text(struct canvas *c, int column, int row, const char *text, enum ink ink)
{
    for (size_t n; *text && row >= 0 && row < c->height; text += n, column++) {
        for (n = 1; ((unsigned char)text[n] & 0xc0) == 0x80;)
            n++;
        if (column < 0 || column >= c->width || n >= GLYPH)
            continue;
        struct canvas_cell *cell = &c->cell[row * c->width + column];
        *cell = (struct canvas_cell){.ink = (unsigned char)ink};
        memcpy(cell->glyph, text, n);
    }
}

void canvas_write(const struct canvas *c, FILE *out)
{
    for (int row = 0; row < c->height; row++) {
        const struct canvas_cell *cell = &c->cell[(size_t)row * (size_t)c->width];
        int blanks = 0, now = 0; /* blanks that are not written yet, and the colour of the terminal */
        for (int k = 0; k < c->width; k++, cell++) {
            char glyph[GLYPH];
            if (!cell->dots && (!*cell->glyph || strcmp(cell->glyph, " ") == 0)) {
                blanks++;
                continue;
            }
            fprintf(out, "%*s", blanks, "");
            blanks = 0;
            const int code = c->display.colours ? inks[cell->ink].code : 0;
            if (code != now)
                fprintf(out, "\033[%dm", code);
            now = code;
            if (!*cell->glyph)
                dots_text(c, cell->dots, cell->ink, glyph);
            fputs(*cell->glyph ? cell->glyph : glyph, out);
        }
        fputs(now ? "\033[0m\n" : "\n", out);
    }
}
