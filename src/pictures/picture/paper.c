/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/io.h"
#include "io/terminal.h"
#include "pictures/picture/picture.h"
#include "pictures/picture/stage.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- As text ---- */

enum { TEXT_COLUMNS = 79, CELLS = 10, CELL_SIZE = 64 };

/* What a line of a document is. The layout can begin each line with one of these characters. */
enum { HEADING = '#', TABLE_HEAD = '|', OTHER = ' ' };

/* Reads the next cell of a row. Returns the end of the cell: a '|', or the end of the row. */
static const char *cell_read(const char *at, char cell[CELL_SIZE])
{
    const int length = (int)strcspn(at + 1, "|\n");
    /* A cell that matters has a '!' behind it. */
    snprintf(cell, CELL_SIZE, "%.*s%s", length ? length : 6, length ? at + 1 : "______",
             at[length] == '!' ? "" : " ");
    return at + 1 + length;
}

/* Writes a table whose columns are as wide as their longest cells. Returns the line after its last row. */
static const char *table_write(const char *line, bool has_marks, FILE *out)
{
    int width[CELLS] = {0};
    char cell[CELL_SIZE];
    for (const char *at = line; *at == '|'; at++)
        for (int k = 0; *at == '|' && k < CELLS; k++) {
            at = cell_read(at, cell);
            const int wide = utf8_columns(cell);
            width[k] = wide > width[k] ? wide : width[k];
        }
    for (char mark = TABLE_HEAD; *line == '|'; line++, mark = OTHER) {
        if (has_marks)
            putc(mark, out);
        for (int k = 0; *line == '|' && k < CELLS; k++) {
            line = cell_read(line, cell);
            fprintf(out, "%*s%s", width[k] - utf8_columns(cell) + (k > 0), "", cell);
        }
        putc('\n', out);
    }
    return line;
}

/* Writes a document as lines of text. With marks, the lines are those of a page. */
static void layout_write(const char *paper, bool has_marks, FILE *out)
{
    for (const char *line = paper; *line;) {
        if (*line == '|') {
            line = table_write(line, has_marks, out);
            continue;
        }
        const bool is_heading = *line == '#', is_page = *line == '\f';
        const char *text = is_heading ? line + 2 : line;
        fputs(is_heading && !has_marks ? "\n" : "", out);
        for (size_t n; *text != '\n'; text += n + (text[n] == ' ')) {
            n = line_break(text, TEXT_COLUMNS);
            if (has_marks && !is_page)
                putc(is_heading ? HEADING : OTHER, out);
            fprintf(out, "%.*s\n", is_page && terminal_shows(out) ? 0 : (int)n, text);
        }
        line = text + 1;
    }
}

void paper_write(const char *paper, FILE *out)
{
    layout_write(paper, false, out);
}

/* ---- By gnuplot ---- */

/* Lengths in dots. A page is PICTURE_WIDTH dots wide. */
enum {
    PAGE = PICTURE_WIDTH * 297 / 210, /* the height of an A4 page */
    SIDE = 26,                        /* the margin that a printer needs */
    TITLE = 26,                       /* the height of the title above the caption */
    LINE = 15,                        /* the height of a line, and of a line with room for handwriting */
    LINE_HIGH = 23,
    SPACE = 10, /* the space above a heading and above a table */
    HEIGHT_LEAST = 190,
    DRAWING_LEAST = 110, /* a drawing is not made lower than this, not counting the text around it */
    DRAWING_MOST = 400
};
#define LETTERS "monospace,12"

/* Writes a document on pages, from the top to the bottom. */
struct pen {
    FILE *script;
    const char *title;
    const struct stage *stage; /* for the first page */
    struct sheet sheet;
    double y;      /* the distance of the next line from the top of the page */
    double bottom; /* where the page ends */
    int page;      /* number of the page, from 1 */
};

static double line_height(const char *line)
{
    const char *blank = strstr(line, "__"), *end = strchr(line, '\n');
    return (*line == OTHER ? 0 : SPACE) + (blank && blank < end ? LINE_HIGH : LINE);
}

/* Returns the height of the part that begins at *line, and moves *line to its end. */
static double part_height(const char **line)
{
    double height = 0;
    do {
        height += line_height(*line);
        *line = strchr(*line, '\n') + 1;
    } while (**line && **line != '\f' && **line != HEADING);
    return height;
}

static void line_put(const struct pen *p, const char *text, size_t length, const char *font)
{
    fputs("set label ", p->script);
    gnuplot_text_part(p->script, text, length);
    fprintf(p->script, " at screen %.6g,%.6g left font '%s' front\n", (double)SIDE / PICTURE_WIDTH,
            1 - p->y / p->sheet.height, font);
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
    line_put(p, head, strlen(head), LETTERS);
    p->y += LINE + SPACE;
}

static void document_draw(struct pen *p, const char *line)
{
    const char *head = NULL; /* the head of the current table, which each page repeats */
    for (; *line; line = strchr(line, '\n') + 1) {
        if (*line == '\f') {
            page_begin(p);
            continue;
        }
        head = *line == TABLE_HEAD ? line : *line == HEADING ? NULL : head;
        const char *end = line;
        /* A long part may begin on the lower half of a page. */
        const double height = *line == HEADING ? fmin(part_height(&end), PAGE / 2.0) : line_height(line);
        const bool is_full = p->y + height > p->bottom;
        if (is_full)
            page_begin(p);
        for (const char *next = is_full && head ? head : line; next; next = next == line ? NULL : line) {
            p->y += line_height(next);
            line_put(p, next + 1, strcspn(next + 1, "\n"), *next == OTHER ? LETTERS : "monospace:Bold,12");
        }
    }
    page_end(p);
}

/* Sets up the first page, with the document below the drawing. The drawing becomes smaller if one more part
 * then fits below it. */
static struct pen pen_first(const char *title, const struct stage *stage, const char *line, bool is_cut)
{
    const double head = SIDE / 2.0 + (title ? TITLE : 0);
    struct sheet sheet = sheet_of(stage, HEIGHT_LEAST, DRAWING_MOST);
    const double drawing = sheet.height - sheet.above - sheet.below;
    double excess = sheet.height + head - (PAGE - SIDE), shrink = 0;
    while (*line && *line != '\f') {
        excess += part_height(&line);
        shrink = excess > 0 && drawing - excess >= DRAWING_LEAST ? excess : shrink;
    }
    if (is_cut && shrink > 0)
        sheet = sheet_of(stage, HEIGHT_LEAST, sheet.height - shrink);
    struct pen p = {.title = title, .stage = stage, .page = 1, .y = sheet.height + head};
    p.bottom = is_cut ? PAGE - SIDE : HUGE_VAL;
    sheet.indent = SIDE;
    sheet.head = head;
    sheet.above += head;
    sheet.height = is_cut ? PAGE : ceil(excess + PAGE);
    sheet.below += sheet.height - p.y;
    p.sheet = sheet;
    return p;
}

bool paper_draw(const char *paper, const char *title, const struct stage *stage, const struct answer *a,
                struct problem *problem)
{
    enum { A4_WIDE = 21 /* cm */ };
    const bool is_cut = strcmp(extension_of(a->path)->terminal, "pdfcairo") == 0;
    char *text = NULL;
    size_t size;
    FILE *lines = io_memory(&text, &size);
    if (lines)
        layout_write(paper, true, lines);
    if (!lines || fclose(lines) != 0 || !text) {
        free(text);
        return problem_error(problem, "%s", dom_status_text(DOM_NO_MEMORY));
    }
    struct pen p = pen_first(title, stage, text, is_cut);
    struct picture picture;
    bool good = picture_begin(&picture, a, p.sheet.height, A4_WIDE, 0, problem);
    if (good) {
        p.script = picture.script;
        if (title) {
            struct pen top = p;
            top.y = SIDE;
            line_put(&top, title, strlen(title), "sans:Bold,18");
        }
        document_draw(&p, text);
        good = picture_end(&picture, true, problem);
    }
    free(text);
    return good;
}
