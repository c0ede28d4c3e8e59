/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/picture/paper.h"
#include "answer/wrap.h"
#include "io/io.h"
#include "io/terminal.h"
#include "pictures/picture/picture.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- The document ---- */

/* In a closed document, each line ends with a NUL byte, and an empty line ends the document. */
bool paper_open(struct paper *p)
{
    *p = (struct paper){.text = NULL};
    p->out = io_memory(&p->text, &p->size);
    return p->out != NULL;
}

bool paper_close(struct paper *p)
{
    putc('\n', p->out);
    const bool is_good = fclose(p->out) == 0;
    p->out = NULL;
    for (size_t k = 0; k < p->size && is_good; k++)
        if (p->text[k] == '\n')
            p->text[k] = '\0';
    return is_good;
}

void paper_free(struct paper *p)
{
    if (p->out)
        fclose(p->out);
    free(p->text);
}

static const char *line_after(const char *line)
{
    return line + strlen(line) + 1;
}

/* ---- Tables ---- */

enum { COLUMNS = 10, CELL = 48 };

struct table {
    const char *head, *end; /* the first row, and the line after the last row */
    int columns;
    int width[COLUMNS]; /* the number of characters of the longest cell */
    bool has_blanks;    /* some cells are for handwriting */
};

struct cell_text {
    char text[CELL];
    bool is_bold, is_blank;
};

/* Reads the next cell of a row. Returns the end of the cell: a '|', or the end of the row. */
static const char *cell_read(const char *at, struct cell_text *cell)
{
    size_t length = strcspn(++at, "|");
    const char *end = at + length;
    *cell = (struct cell_text){.is_bold = length > 0 && end[-1] == '!', .is_blank = length == 0};
    snprintf(cell->text, CELL, "%.*s", (int)length - cell->is_bold, cell->is_blank ? "" : at);
    return end;
}

static struct table table_read(const char *line)
{
    static const int blank = 6; /* the width of a cell for handwriting */
    struct table t = {.head = line};
    struct cell_text cell;
    for (; *line == '|'; line = line_after(line))
        for (int k = 0; *line == '|' && k < COLUMNS; k++) {
            line = cell_read(line, &cell);
            const int width = cell.is_blank ? blank : utf8_columns(cell.text);
            t.width[k] = width > t.width[k] ? width : t.width[k];
            t.columns = k + 1 > t.columns ? k + 1 : t.columns;
            t.has_blanks = t.has_blanks || cell.is_blank;
        }
    t.end = line;
    return t;
}

/* ---- As text ---- */

enum { TEXT_COLUMNS = 79 };

static const char *table_write(const char *line, FILE *out)
{
    const struct table t = table_read(line);
    struct cell_text cell;
    for (; line != t.end; line = line_after(line)) {
        for (int k = 0; *line; k++) {
            line = cell_read(line, &cell);
            fprintf(out, "%*s%s", t.width[k] + (k > 0), cell.is_blank ? "______" : cell.text,
                    cell.is_bold ? "!" : " ");
        }
        putc('\n', out);
    }
    return t.end;
}

void paper_write(const struct paper *p, FILE *out)
{
    for (const char *line = p->text; *line;) {
        if (*line == '|') {
            line = table_write(line, out);
            continue;
        }
        if (*line == '\f') {
            putc(terminal_shows(out) ? '\n' : '\f', out);
        } else {
            const bool is_heading = *line == '#';
            fputs(is_heading ? "\n" : "", out);
            write_wrapped(out, is_heading ? line + 2 : line, 0, TEXT_COLUMNS);
            putc('\n', out);
        }
        line = line_after(line);
    }
}

/* ---- By gnuplot ---- */

/* Lengths in dots. A page is SHEET_WIDTH dots wide. */
enum {
    PAGE = SHEET_WIDTH * 297 / 210, /* the height of an A4 page */
    SIDE = 26,                      /* the margin that a printer needs */
    TITLE = 26,                     /* the height of the title above the caption */
    LINE = 16,
    ROW = 15,      /* the height of a row of a table */
    ROW_HIGH = 23, /* the height of a row with room for handwriting */
    SPACE = 8,     /* the space above a heading, and around a table */
    SIZE = 11,     /* font size */
    LETTERS = 100, /* the maximum number of characters on a line of text */
    ACROSS = SHEET_WIDTH - 2 * SIDE,
    HEIGHT_LEAST = 190,
    DRAWING_LEAST = 110, /* a drawing is not made lower than this, not counting the text around it */
    DRAWING_MOST = 400
};

/* Writes a document on pages, from the top to the bottom. */
struct pen {
    FILE *script; /* NULL if the pen only measures */
    const char *title;
    const struct stage *stage; /* for the first page */
    struct sheet sheet;
    double y;      /* the distance of the next line from the top of the page */
    double bottom; /* where the page ends */
    int page;      /* number of the page, from 1 */
};

static void text_put(const struct pen *p, double x, const char *align, int size, bool bold, const char *text,
                     size_t length)
{
    if (!p->script)
        return;
    fputs("set label ", p->script);
    gnuplot_text_part(p->script, text, length);
    fprintf(p->script, " at screen %.6g,%.6g %s font 'sans%s,%d' noenhanced front\n", x / SHEET_WIDTH,
            1 - p->y / p->sheet.height, align, bold ? ":Bold" : "", size);
}

/* Draws a box around a cell whose right end is at x. */
static void box_put(const struct pen *p, double x, double wide)
{
    if (p->script)
        fprintf(p->script,
                "set object rectangle from screen %.6g,%.6g to screen %.6g,%.6g fs empty border lc rgb "
                "'#808080'\n",
                (x - wide) / SHEET_WIDTH, 1 - (p->y - ROW_HIGH / 2.0) / p->sheet.height, x / SHEET_WIDTH,
                1 - (p->y + ROW_HIGH / 2.0) / p->sheet.height);
}

/* Draws the page, and prepares gnuplot for the next one. */
static void page_end(struct pen *p)
{
    if (p->page++ == 1)
        stage_script(p->stage, &p->sheet, p->script);
    else
        fputs("plot NaN notitle\n", p->script);
    fputs("reset\nset encoding utf8\nunset border\nunset tics\nunset key\nset xrange [0:1]\nset yrange "
          "[0:1]\n",
          p->script);
    p->y = SIDE;
}

static void page_begin(struct pen *p)
{
    char head[160];
    page_end(p);
    snprintf(head, sizeof head, "%.120s%spage %d", p->title ? p->title : "", p->title ? ", " : "", p->page);
    text_put(p, SIDE, "left", SIZE, false, head, strlen(head));
    p->y += LINE + SPACE;
}

/* Returns true if something of this height does not fit on the page. */
static bool is_full(const struct pen *p, double height)
{
    return p->y + height > p->bottom;
}

static void row_draw(struct pen *p, const struct table *t, const char *line, bool is_head, double letter)
{
    struct cell_text cell;
    double right = SIDE;
    for (int k = 0; *line; k++) {
        const double wide = letter * (t->width[k] + (k > 0 || t->has_blanks ? 2 : 0));
        right += wide;
        line = cell_read(line, &cell);
        text_put(p, right - (t->has_blanks ? letter : 0), "right", SIZE, is_head || cell.is_bold, cell.text,
                 strlen(cell.text));
        if (t->has_blanks)
            box_put(p, right, wide);
    }
    p->y += t->has_blanks ? ROW_HIGH : ROW;
}

static const char *table_draw(struct pen *p, const char *line)
{
    const struct table t = table_read(line);
    double letters = 0;
    for (int k = 0; k < t.columns; k++)
        letters += t.width[k] + 2;
    const double letter = t.has_blanks ? ACROSS / letters : fmin(0.87 * SIZE, ACROSS / letters);
    p->y += SPACE;
    for (; line != t.end; line = line_after(line)) {
        if (is_full(p, ROW_HIGH) && p->script) {
            page_begin(p);
            if (line != t.head)
                row_draw(p, &t, t.head, true, letter);
        }
        row_draw(p, &t, line, line == t.head, letter);
    }
    p->y += SPACE;
    return t.end;
}

static const char *text_draw(struct pen *p, const char *line)
{
    const bool is_heading = *line == '#';
    p->y += is_heading ? SPACE : 0;
    for (const char *text = is_heading ? line + 2 : line; *text;) {
        const size_t n = line_break(text, LETTERS);
        if (is_full(p, LINE) && p->script)
            page_begin(p);
        text_put(p, SIDE, "left", is_heading ? SIZE + 2 : SIZE, is_heading, text, n);
        p->y += is_heading ? LINE + 3 : LINE;
        text += n + (text[n] == ' ');
    }
    return line_after(line);
}

static const char *block_draw(struct pen *p, const char *line)
{
    return *line == '|' ? table_draw(p, line) : text_draw(p, line);
}

/* Returns the height of the part of the document that begins here. It ends before the next heading. */
static double part_height(const char *line, const char **end)
{
    struct pen pen = {.script = NULL};
    do
        line = block_draw(&pen, line);
    while (*line && *line != '#' && *line != '\f');
    *end = line;
    return pen.y;
}

static void document_draw(struct pen *p, const char *line)
{
    const char *end;
    while (*line)
        if (*line == '\f') {
            page_begin(p);
            line = line_after(line);
        } else {
            /* A long part may begin on the lower half of a page. */
            if (*line == '#' && is_full(p, fmin(part_height(line, &end), PAGE / 2.0)))
                page_begin(p);
            line = block_draw(p, line);
        }
    page_end(p);
}

/* Sets up the first page with a drawing of at most `most` dots. The document begins below the drawing. */
static struct pen pen_with(const char *title, const struct stage *stage, double most)
{
    struct pen p = {.title = title, .stage = stage, .page = 1, .sheet = sheet_of(stage, HEIGHT_LEAST, most)};
    p.sheet.indent = SIDE;
    p.sheet.head = SIDE / 2.0 + (title ? TITLE : 0);
    p.sheet.above += p.sheet.head;
    p.sheet.height += p.sheet.head;
    p.y = p.sheet.height;
    return p;
}

/* Sets up the first page. The drawing becomes smaller if one more part then fits below it. */
static struct pen pen_first(const char *title, const struct stage *stage, const char *line, bool is_cut)
{
    struct pen p = pen_with(title, stage, DRAWING_MOST);
    const double drawing = p.sheet.height - p.sheet.above - p.sheet.below;
    double excess = p.y - (PAGE - SIDE), shrink = 0;
    for (; *line && *line != '\f';) {
        excess += part_height(line, &line);
        shrink = excess > 0 && drawing - excess >= DRAWING_LEAST ? excess : shrink;
    }
    if (is_cut && shrink > 0)
        p = pen_with(title, stage, p.sheet.height - p.sheet.head - shrink);
    p.bottom = is_cut ? PAGE - SIDE : HUGE_VAL;
    const double height = is_cut ? PAGE : ceil(excess + PAGE);
    p.sheet.below += height - p.sheet.height;
    p.sheet.height = height;
    return p;
}

bool paper_draw(const struct paper *paper, const char *title, const struct stage *stage,
                const struct answer *a, const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    const struct extension *extension = extension_of(a->path);
    const bool is_cut = strcmp(extension->terminal, "pdfcairo") == 0;
    struct pen p = pen_first(title, stage, paper->text, is_cut);
    struct picture picture;
    char terminal[TERMINAL_TEXT];
    sheet_terminal(&p.sheet, extension->terminal, true, terminal);
    if (!picture_begin(&picture, a, terminal, interrupt, problem))
        return false;
    p.script = picture.script;
    if (title) {
        struct pen top = p;
        top.y = SIDE;
        text_put(&top, SIDE, "left", 18, true, title, strlen(title));
    }
    document_draw(&p, paper->text);
    return picture_end(&picture, true, problem);
}
