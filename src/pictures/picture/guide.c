/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/picture/guide.h"
#include "answer/wrap.h"
#include "pictures/picture/picture.h"
#include <math.h>
#include <string.h>

static int columns_of(const struct guide_table *table)
{
    int count = 0;
    while (count < GUIDE_COLUMNS && table->head[count])
        count++;
    return count;
}

static size_t column_width(const struct guide_table *table, int column)
{
    size_t width = strlen(table->head[column]);
    for (size_t i = 0; i < table->count; i++) {
        size_t length = strlen(table->line[i].cell[column]);
        width = length > width ? length : width;
    }
    return width;
}

void guide_text(const struct guide_table *table, struct answer *a)
{
    const int columns = columns_of(table);
    FILE *out = a->out;
    answer_say(a, "\n%s", table->title);
    answer_say(a, "%s", table->note);
    for (size_t i = 0; i <= table->count; i++) {
        const struct guide_line *line = i > 0 ? &table->line[i - 1] : NULL;
        for (int k = 0; k < columns; k++) {
            const bool is_bold = line && line->bold[k];
            fprintf(out, "%*s%s", (int)column_width(table, k) + (k > 0),
                    line ? line->cell[k] : table->head[k], is_bold ? "!" : " ");
        }
        putc('\n', out);
    }
}

/* ---- By gnuplot ---- */

/* Lengths in dots. A page is SHEET_WIDTH dots wide. */
enum {
    PAGE = 905, /* the height of an A4 page */
    SIDE = 30,  /* the margin that a printer needs */
    TITLE = 30, /* the height of the title above the caption */
    LINE = 15,  /* the height of a line of a table */
    SPACE = 12, /* the space above a table */
    SIZE = 11,  /* the font size of a table */
    DRAWING_LEAST = 190,
    DRAWING_MOST = 400,
    DOMINOES_LEAST = 110, /* a drawing is not made smaller than this, not counting the text around it */
    NOTE = 108            /* the width of the note above a table, in characters */
};

struct page {
    FILE *script;
    const struct guide *guide;
    struct sheet sheet;
    double y;    /* the distance of the next line from the top of the page */
    int number;  /* from 1 */
    bool is_cut; /* the guide is cut into A4 pages; otherwise it is one long page */
};

static void text_put(const struct page *p, double x, const char *align, int size, bool bold, const char *text)
{
    fputs("set label ", p->script);
    gnuplot_text(p->script, text);
    fprintf(p->script, " at screen %.6g,%.6g %s font 'sans%s,%d' noenhanced front\n", x / SHEET_WIDTH,
            1 - p->y / p->sheet.height, align, bold ? ":Bold" : "", size);
}

/* Draws the page and prepares gnuplot for the next one. The first page contains the stage. */
static void page_end(struct page *p)
{
    if (p->number == 1)
        stage_script(p->guide->stage, &p->sheet, p->script);
    else
        fprintf(p->script, "plot NaN\n");
    fprintf(p->script, "reset\nset encoding utf8\nunset border\nunset tics\nunset key\nset xrange [0:1]\nset "
                       "yrange [0:1]\n");
    p->number++;
    p->y = SIDE;
}

static void page_begin(struct page *p)
{
    char head[160];
    page_end(p);
    snprintf(head, sizeof head, "%.120s%spage %d", p->guide->title ? p->guide->title : "",
             p->guide->title ? ", " : "", p->number);
    text_put(p, SIDE, "left", SIZE, false, head);
    p->y += LINE + SPACE;
}

/* Returns true if the page has no room for something of this height. */
static bool page_is_full(const struct page *p, double height)
{
    return p->is_cut && p->y + height > PAGE - SIDE;
}

static void head_put(struct page *p, const struct guide_table *table, const double *right)
{
    for (int k = 0; k < columns_of(table); k++)
        text_put(p, right[k], "right", SIZE, true, table->head[k]);
    p->y += LINE;
}

/* Writes a note in lines, if `p` is not NULL. Returns the number of lines. */
static int note_put(struct page *p, const char *note)
{
    int lines = 0;
    char line[2 * NOTE];
    for (size_t n; *note; note += n + strspn(note + n, " "), lines++) {
        n = line_break(note, NOTE);
        if (!p)
            continue;
        snprintf(line, sizeof line, "%.*s", (int)n, note);
        text_put(p, SIDE, "left", SIZE - 1, false, line);
        p->y += LINE;
    }
    return lines;
}

static double table_height(const struct guide_table *table)
{
    return LINE * (double)(table->count + 2 + (size_t)note_put(NULL, table->note)) + 2 * SPACE + 4;
}

static void table_put(struct page *p, const struct guide_table *table)
{
    const int columns = columns_of(table);
    const double wide = SHEET_WIDTH - 2 * SIDE, letter = 0.58 * SIZE;
    double right[GUIDE_COLUMNS] = {0}, letters = 0;
    for (int k = 0; k < columns; k++)
        letters += (double)column_width(table, k) + 2;
    const double each = fmin(1.5 * letter, wide / letters);
    for (int k = 0; k < columns; k++)
        right[k] = (k > 0 ? right[k - 1] : SIDE) + each * ((double)column_width(table, k) + (k > 0 ? 2 : 0));
    /* A table is broken only if it is longer than a page. */
    if (page_is_full(p, fmin(table_height(table), PAGE / 2.0)))
        page_begin(p);
    p->y += SPACE;
    text_put(p, SIDE, "left", SIZE + 2, true, table->title);
    p->y += LINE + 2;
    (void)note_put(p, table->note);
    p->y += 2;
    head_put(p, table, right);
    for (size_t i = 0; i < table->count; i++) {
        if (page_is_full(p, LINE)) {
            page_begin(p);
            head_put(p, table, right);
        }
        for (int k = 0; k < columns; k++)
            if (*table->line[i].cell[k])
                text_put(p, right[k], "right", SIZE, table->line[i].bold[k], table->line[i].cell[k]);
        p->y += LINE;
    }
    p->y += SPACE;
}

/* Sets up the first page with a drawing of at most `most` dots. The tables begin below the drawing. */
static struct page page_with(const struct guide *guide, bool is_cut, double most)
{
    struct page p = {.guide = guide, .number = 1, .is_cut = is_cut};
    struct sheet *v = &p.sheet;
    *v = sheet_of(guide->stage, DRAWING_LEAST, most);
    const double drawing = v->height - v->above - v->below;
    double lines = 0;
    for (int i = 0; i < guide->tables; i++)
        lines += table_height(&guide->table[i]);
    v->indent = SIDE;
    v->head = SIDE / 2.0 + (guide->title ? TITLE : 0);
    v->above += v->head;
    p.y = v->above + drawing + v->below;
    v->height = is_cut ? PAGE : ceil(p.y + lines + SIDE);
    v->below = v->height - v->above - drawing;
    return p;
}

/* Sets up the first page. The drawing becomes smaller if one more table then fits below it. */
static struct page page_first(const struct guide *guide, bool is_cut)
{
    const struct page p = page_with(guide, is_cut, DRAWING_MOST);
    const double drawing = p.sheet.height - p.sheet.above - p.sheet.below;
    double excess = p.y - (PAGE - SIDE), shrink = 0;
    for (int i = 0; i < guide->tables; i++) {
        excess += table_height(&guide->table[i]);
        shrink = excess > 0 && drawing - excess >= DOMINOES_LEAST ? excess : shrink;
    }
    return is_cut && shrink > 0 ? page_with(guide, is_cut, DRAWING_MOST - shrink) : p;
}

static void guide_script(const struct guide *guide, struct page *p, FILE *script)
{
    const double below = p->y;
    p->script = script;
    p->y = SIDE;
    if (guide->title)
        text_put(p, SIDE, "left", 18, true, guide->title);
    p->y = below;
    for (int i = 0; i < guide->tables; i++)
        table_put(p, &guide->table[i]);
    page_end(p);
}

/* The font is smaller than for 'draw', since a guide has margins. */
static void guide_terminal(const struct sheet *v, const char *extension, char *terminal, size_t size)
{
    if (strcmp(extension, ".pdf") == 0)
        snprintf(terminal, size, "pdfcairo size 21cm,29.7cm font 'sans,14' fontscale 0.68 enhanced");
    else if (strcmp(extension, ".png") == 0)
        snprintf(terminal, size, "pngcairo size %.0f,%.0f font 'sans,14' fontscale 1.25 linewidth 2 enhanced",
                 2 * v->width, 2 * v->height);
    else
        snprintf(
            terminal, size,
            "svg size %.0f,%.0f dynamic font 'sans-serif,14' fontscale 0.86 background rgb 'white' enhanced",
            v->width, v->height);
}

bool guide_show(const struct guide *guide, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem)
{
    const struct extension *extension = extension_of(a->path);
    const bool is_pdf = extension->is_script || strcmp(extension->text, ".pdf") == 0;
    struct page p = page_first(guide, is_pdf);
    struct picture picture;
    char terminal[160];
    guide_terminal(&p.sheet, extension->is_script ? ".pdf" : extension->text, terminal, sizeof terminal);
    if (extension->is_script) {
        script_head(a, terminal);
        guide_script(guide, &p, a->out);
        return true;
    }
    if (!picture_begin(&picture, a->out, terminal, interrupt, problem))
        return false;
    guide_script(guide, &p, picture.script);
    return picture_end(&picture, true, problem);
}
