/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/picture/canvas.h"
#include "io/terminal.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- Colours ---- */

static const struct {
    int rgb;
    /* the escape code of the nearest of 8 colours, or 0 for the default colour of text */
    int of_8;
    char letter; /* the character that draws a curve on a terminal without braille */
} inks[INKS] = {
    [INK_TEXT] = {0, 0, '*'},          [INK_BLUE] = {0x0072b2, 34, 'o'},   [INK_RED] = {0xd55e00, 31, '#'},
    [INK_GREEN] = {0x009e73, 32, '+'}, [INK_PURPLE] = {0xcc79a7, 35, 'x'}, [INK_ORANGE] = {0xe69f00, 33, '%'},
    [INK_SKY] = {0x56b4e9, 36, '@'},   [INK_GREY] = {0x777777, 0, '.'},
};

int ink_colour(enum ink ink)
{
    return inks[ink].rgb;
}

int shade_colour(double shade)
{
    static const unsigned char viridis[][3] = {{68, 1, 84},    {71, 44, 122},  {59, 81, 139},
                                               {44, 113, 142}, {33, 144, 141}, {39, 173, 129},
                                               {92, 200, 99},  {170, 220, 50}, {253, 231, 37}};
    enum { STEPS = sizeof viridis / sizeof *viridis - 1 };
    double at = fmin(fmax(shade, 0), 1) * STEPS;
    int k = at >= STEPS ? STEPS - 1 : (int)at, rgb = 0;
    for (int i = 0; i < 3; i++)
        rgb = rgb << 8 | (int)lround(viridis[k][i] + (at - k) * (viridis[k + 1][i] - viridis[k][i]));
    return rgb;
}

struct display display_of(FILE *stream)
{
    static const char *const without_braille[] = {"dumb", "linux", "vt", "cons"};
    const char *term = getenv("TERM");
    struct display display = {.colours = COLOURS_NONE};
    if (!terminal_shows(stream) || !term)
        return display;
    display.braille = terminal_utf8();
    for (size_t k = 0; k < sizeof without_braille / sizeof *without_braille; k++)
        display.braille =
            display.braille && strncmp(term, without_braille[k], strlen(without_braille[k])) != 0;
    if (terminal_colour(stream))
        display.colours =
            strstr(term, "256") || strstr(term, "kitty") || strstr(term, "foot") ? COLOURS_256 : COLOURS_8;
    return display;
}

double ruler_step(double least)
{
    double ten = pow(10, floor(log10(least)));
    return least <= ten ? ten : least <= 2 * ten ? 2 * ten : least <= 5 * ten ? 5 * ten : 10 * ten;
}

/* ---- Dots ---- */

bool canvas_make(struct canvas *c, struct display display, int width, int height)
{
    *c = (struct canvas){.display = display,
                         .width = width,
                         .height = height,
                         .across = display.braille ? 2 : 1,
                         .down = display.braille ? 4 : 1};
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
    static const char *const blocks[] = {"░", "▒", "▓", "█"}, *const letters[] = {".", ":", "-", "=", "+",
                                                                                  "*", "#", "%", "@"};
    struct canvas_cell *cell = cell_at(c, column, row);
    double mean = isnan(upper) ? lower : isnan(lower) ? upper : (upper + lower) / 2;
    const int shade = isnan(mean) ? -1 : (int)(255 * mean + 0.5);
    if (!cell)
        return;
    /* A shade is normally a colour. If the terminal has too few colours, or no half blocks, a character
     * stands for the shade. */
    if (!c->display.braille || c->display.colours < COLOURS_256)
        canvas_text(c, column, row,
                    shade < 0            ? " "
                    : c->display.braille ? blocks[shade * 4 / 256]
                                         : letters[shade * 9 / 256],
                    INK_TEXT);
    else
        *cell = (struct canvas_cell){.upper = isnan(upper) ? -1 : shade_colour(upper),
                                     .lower = isnan(lower) ? -1 : shade_colour(lower)};
}

/* ---- Writing ---- */

enum ground { GROUND_FRONT = 38, GROUND_BACK = 48 };

/* Writes the escape sequence for a colour. A negative `rgb` stands for the default colour of the terminal. */
static void colour_write(enum ground ground, int rgb, FILE *out)
{
    int red = rgb >> 16, green = rgb >> 8 & 255, blue = rgb & 255;
    if (rgb < 0)
        fprintf(out, "\033[%dm", ground + 1);
    else /* the palette has a cube of 6 x 6 x 6 colours */
        fprintf(out, "\033[%d;5;%dm", ground,
                16 + 36 * ((red + 25) / 51) + 6 * ((green + 25) / 51) + (blue + 25) / 51);
}

static void ink_write(const struct canvas *c, enum ink ink, FILE *out)
{
    if (c->display.colours == COLOURS_NONE)
        return;
    fputs("\033[0m", out);
    if (c->display.colours == COLOURS_8 && inks[ink].of_8)
        fprintf(out, "\033[%dm", inks[ink].of_8);
    else if (c->display.colours > COLOURS_8 && ink != INK_TEXT)
        colour_write(GROUND_FRONT, inks[ink].rgb, out);
}

static bool is_shaded(const struct canvas_cell *cell)
{
    return cell->upper >= 0 || cell->lower >= 0;
}

static bool is_blank(const struct canvas_cell *cell)
{
    return !cell->dots && !is_shaded(cell) && (cell->glyph[0] == '\0' || strcmp(cell->glyph, " ") == 0);
}

bool canvas_blank(const struct canvas *c, int column, int row)
{
    const struct canvas_cell *cell = cell_at(c, column, row);
    return !cell || is_blank(cell);
}

/* Writes a cell. `now` is the ink that the terminal uses before the cell is written. Returns the ink that it
 * uses afterwards. */
static enum ink cell_write(const struct canvas *c, const struct canvas_cell *cell, enum ink now, FILE *out)
{
    char glyph[GLYPH];
    if (is_shaded(cell)) {
        colour_write(GROUND_FRONT, cell->upper < 0 ? cell->lower : cell->upper, out);
        colour_write(GROUND_BACK, cell->upper < 0 ? -1 : cell->lower, out);
        fputs(cell->upper < 0 ? "▄\033[0m" : "▀\033[0m", out);
        return INK_TEXT;
    }
    if (is_blank(cell)) {
        putc(' ', out);
        return now;
    }
    if (cell->ink != now)
        ink_write(c, (enum ink)cell->ink, out);
    if (!cell->glyph[0])
        dots_text(c, cell->dots, cell->ink, glyph);
    fputs(cell->glyph[0] ? cell->glyph : glyph, out);
    return (enum ink)cell->ink;
}

void canvas_write(const struct canvas *c, int from, FILE *out)
{
    for (int row = from; row < c->height; row++) {
        const struct canvas_cell *cell = &c->cell[(size_t)row * (size_t)c->width];
        int end = c->width;
        enum ink now = INK_TEXT;
        while (end > 0 && is_blank(&cell[end - 1]))
            end--;
        for (int k = 0; k < end; k++)
            now = cell_write(c, &cell[k], now, out);
        if (now != INK_TEXT)
            ink_write(c, INK_TEXT, out);
        putc('\n', out);
    }
}
