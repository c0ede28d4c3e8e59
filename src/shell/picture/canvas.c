/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture/canvas.h"
#include "io/terminal.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- Colours ---- */

static const struct {
    const char *colour; /* in files, and where a terminal has all colours; NULL: that of text */
    int of_256, of_8;   /* the nearest that others have; -1: that of text */
    char letter;        /* of a curve, without braille */
} inks[INKS] = {
    [INK_TEXT] = {"#000000", -1, -1, '*'},    [INK_BLUE] = {"#0072b2", 32, 34, 'o'},
    [INK_RED] = {"#d55e00", 166, 31, '#'},    [INK_GREEN] = {"#009e73", 36, 32, '+'},
    [INK_PURPLE] = {"#cc79a7", 175, 35, 'x'}, [INK_ORANGE] = {"#e69f00", 214, 33, '%'},
    [INK_SKY] = {"#56b4e9", 74, 36, '@'},     [INK_GREY] = {"#777777", 245, -1, '.'},
};

const char *ink_colour(enum ink ink)
{
    return inks[ink].colour;
}

void shade_colour(double shade, int rgb[3])
{
    static const unsigned char viridis[][3] = {{68, 1, 84},    {71, 44, 122},  {59, 81, 139},
                                               {44, 113, 142}, {33, 144, 141}, {39, 173, 129},
                                               {92, 200, 99},  {170, 220, 50}, {253, 231, 37}};
    enum { STEPS = sizeof viridis / sizeof *viridis - 1 };
    double at = fmin(fmax(shade, 0), 1) * STEPS;
    int k = at >= STEPS ? STEPS - 1 : (int)at;
    for (int i = 0; i < 3; i++)
        rgb[i] = (int)lround(viridis[k][i] + (at - k) * (viridis[k + 1][i] - viridis[k][i]));
}

static bool begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

struct look look_of(FILE *stream)
{
    const char *term = getenv("TERM"), *all = getenv("COLORTERM");
    struct look look = {.colours = COLOURS_NONE};
    if (!isatty(fileno(stream)) || !term)
        return look;
    /* The fonts of these have no braille. */
    bool letters =
        begins(term, "dumb") || begins(term, "linux") || begins(term, "vt") || begins(term, "cons");
    look.braille = terminal_utf8() && !letters;
    if (terminal_colour(stream))
        look.colours = all && (strcmp(all, "truecolor") == 0 || strcmp(all, "24bit") == 0)    ? COLOURS_ALL
                       : strstr(term, "256") || strstr(term, "kitty") || strstr(term, "foot") ? COLOURS_256
                                                                                              : COLOURS_8;
    return look;
}

/* ---- Dots ---- */

bool canvas_make(struct canvas *c, struct look look, int width, int height)
{
    *c = (struct canvas){.look = look,
                         .width = width,
                         .height = height,
                         .across = look.braille ? 2 : 1,
                         .down = look.braille ? 4 : 1};
    size_t cells = (size_t)width * (size_t)height;
    c->cell = calloc(cells ? cells : 1, sizeof *c->cell);
    for (size_t i = 0; c->cell && i < cells; i++)
        c->cell[i].upper = c->cell[i].lower = -1;
    return c->cell != NULL;
}

void canvas_free(struct canvas *c)
{
    free(c->cell);
}

static struct canvas_cell *cell_at(const struct canvas *c, int column, int row)
{
    bool inside = column >= 0 && column < c->width && row >= 0 && row < c->height;
    return inside ? &c->cell[(size_t)row * (size_t)c->width + (size_t)column] : NULL;
}

void canvas_dot(struct canvas *c, int x, int y, enum ink ink)
{
    static const unsigned char dots[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
    struct canvas_cell *cell = x < 0 || y < 0 ? NULL : cell_at(c, x / c->across, y / c->down);
    if (!cell)
        return;
    cell->glyph[0] = '\0';
    cell->dots |= dots[y % c->down][x % c->across];
    cell->ink = (unsigned char)ink;
}

/* Dots on and off, from the first on; letters are apart by themselves. */
static bool dash_on(const struct canvas *c, int dash, int phase)
{
    static const struct {
        unsigned bits;
        int length;
    } dashes[DASHES] = {{1, 1}, {0x0f, 7}, {0x1, 3}, {0x11f, 11}, {0x3, 5}};
    const int k = dash % DASHES;
    return !c->look.braille || (dashes[k].bits >> phase % dashes[k].length & 1) != 0;
}

void canvas_line(struct canvas *c, double x0, double y0, double x1, double y1, enum ink ink, int dash,
                 int *phase)
{
    double dx = x1 - x0, dy = y1 - y0, length = fmax(fabs(dx), fabs(dy));
    if (!(length < 1e5))
        return;
    int steps = (int)ceil(length);
    for (int i = 0; i <= steps; i++) {
        double part = steps ? (double)i / steps : 0;
        if (dash_on(c, dash, *phase))
            canvas_dot(c, (int)floor(x0 + part * dx), (int)floor(y0 + part * dy), ink);
        *phase += i < steps;
    }
}

/* Writes the character of a code point below 0x10000, in UTF-8. */
static void glyph_of(unsigned code, char glyph[GLYPH])
{
    if (code < 0x80)
        snprintf(glyph, GLYPH, "%c", (int)code);
    else
        snprintf(glyph, GLYPH, "%c%c%c", (int)(0xe0 | code >> 12), (int)(0x80 | (code >> 6 & 0x3f)),
                 (int)(0x80 | (code & 0x3f)));
}

static const char *cell_glyph(const struct canvas *c, const struct canvas_cell *cell, char glyph[GLYPH])
{
    if (cell->glyph[0] || !cell->dots)
        return cell->glyph[0] ? cell->glyph : " ";
    glyph_of(c->look.braille ? 0x2800u + cell->dots : (unsigned)inks[cell->ink].letter, glyph);
    return glyph;
}

const char *canvas_sample(const struct canvas *c, enum ink ink, int dash, char sample[4 * GLYPH])
{
    enum { CELLS = 3 };
    sample[0] = '\0';
    if (!c->look.braille) {
        snprintf(sample, (size_t)4 * GLYPH, "%c", inks[ink].letter);
        return sample;
    }
    size_t used = 0;
    for (int k = 0; k < CELLS; k++) {
        char glyph[GLYPH];
        unsigned dots = (dash_on(c, dash, 2 * k) ? 0x04u : 0) | (dash_on(c, dash, 2 * k + 1) ? 0x20u : 0);
        glyph_of(0x2800u + dots, glyph);
        used += (size_t)snprintf(sample + used, (size_t)4 * GLYPH - used, "%s", glyph);
    }
    return sample;
}

/* ---- Text and shades ---- */

void canvas_text(struct canvas *c, int column, int row, const char *text, enum ink ink)
{
    while (*text) {
        size_t n = 1;
        while (((unsigned char)text[n] & 0xc0) == 0x80)
            n++;
        struct canvas_cell *cell = cell_at(c, column++, row);
        if (cell && n < GLYPH) {
            *cell = (struct canvas_cell){.ink = (unsigned char)ink, .upper = -1, .lower = -1};
            memcpy(cell->glyph, text, n);
        }
        text += n;
    }
}

void canvas_shade(struct canvas *c, int column, int row, double upper, double lower)
{
    struct canvas_cell *cell = cell_at(c, column, row);
    if (!cell)
        return;
    *cell = (struct canvas_cell){.upper = (short)(isnan(upper) ? -1 : lround(255 * upper)),
                                 .lower = (short)(isnan(lower) ? -1 : lround(255 * lower))};
}

static const char *shade_sequence(const struct canvas *c, bool ground, int shade, char text[32])
{
    int rgb[3];
    if (shade < 0)
        return ground ? "\033[49m" : "\033[39m";
    shade_colour(shade / 255.0, rgb);
    if (c->look.colours == COLOURS_ALL)
        snprintf(text, 32, "\033[%d;2;%d;%d;%dm", ground ? 48 : 38, rgb[0], rgb[1], rgb[2]);
    else
        snprintf(text, 32, "\033[%d;5;%dm", ground ? 48 : 38,
                 16 + 36 * ((rgb[0] + 25) / 51) + 6 * ((rgb[1] + 25) / 51) + (rgb[2] + 25) / 51);
    return text;
}

/* Without many colours a shade is a letter, the darker the more. */
static const char *shade_letter(const struct canvas *c, const struct canvas_cell *cell)
{
    static const char *const blocks[] = {"░", "▒", "▓", "█"}, *const letters[] = {".", ":", "-", "=", "+",
                                                                                  "*", "#", "%", "@"};
    int shade = cell->upper < 0   ? cell->lower
                : cell->lower < 0 ? cell->upper
                                  : (cell->upper + cell->lower) / 2;
    return shade < 0 ? " " : c->look.braille ? blocks[shade * 4 / 256] : letters[shade * 9 / 256];
}

/* ---- Writing ---- */

static void shade_write(const struct canvas *c, const struct canvas_cell *cell, FILE *out)
{
    char text[32];
    if (!c->look.braille || c->look.colours < COLOURS_256) {
        fputs(shade_letter(c, cell), out);
        return;
    }
    fputs(shade_sequence(c, false, cell->upper < 0 ? cell->lower : cell->upper, text), out);
    fputs(shade_sequence(c, true, cell->upper < 0 ? -1 : cell->lower, text), out);
    fputs(cell->upper < 0 ? "▄\033[0m" : "▀\033[0m", out);
}

static void ink_write(const struct canvas *c, enum ink ink, FILE *out)
{
    int rgb[3];
    if (c->look.colours == COLOURS_NONE)
        return;
    if (inks[ink].of_256 < 0)
        fputs("\033[0m", out);
    else if (c->look.colours == COLOURS_ALL && sscanf(inks[ink].colour, "#%2x%2x%2x", (unsigned *)&rgb[0],
                                                      (unsigned *)&rgb[1], (unsigned *)&rgb[2]) == 3)
        fprintf(out, "\033[38;2;%d;%d;%dm", rgb[0], rgb[1], rgb[2]);
    else if (c->look.colours >= COLOURS_256)
        fprintf(out, "\033[38;5;%dm", inks[ink].of_256);
    else if (inks[ink].of_8 >= 0)
        fprintf(out, "\033[%dm", inks[ink].of_8);
}

static bool shaded(const struct canvas_cell *cell)
{
    return cell->upper >= 0 || cell->lower >= 0;
}

static bool blank(const struct canvas_cell *cell)
{
    return !cell->dots && !shaded(cell) && (cell->glyph[0] == '\0' || strcmp(cell->glyph, " ") == 0);
}

bool canvas_blank(const struct canvas *c, int column, int row)
{
    const struct canvas_cell *cell = cell_at(c, column, row);
    return !cell || blank(cell);
}

void canvas_write(const struct canvas *c, int from, FILE *out)
{
    for (int row = from; row < c->height; row++) {
        const struct canvas_cell *cell = &c->cell[(size_t)row * (size_t)c->width];
        int end = c->width;
        enum ink now = INK_TEXT;
        while (end > 0 && blank(&cell[end - 1]))
            end--;
        for (int k = 0; k < end; k++) {
            char glyph[GLYPH];
            if (shaded(&cell[k])) {
                shade_write(c, &cell[k], out);
                now = INK_TEXT;
                continue;
            }
            if (!blank(&cell[k]) && cell[k].ink != now) {
                now = (enum ink)cell[k].ink;
                fputs(now != INK_TEXT && c->look.colours != COLOURS_NONE ? "\033[0m" : "", out);
                ink_write(c, now, out);
            }
            fputs(cell_glyph(c, &cell[k], glyph), out);
        }
        if (now != INK_TEXT && c->look.colours != COLOURS_NONE)
            fputs("\033[0m", out);
        putc('\n', out);
    }
}
