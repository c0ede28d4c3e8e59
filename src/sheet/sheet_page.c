/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes the pages of a sheet as text, or as a script for gnuplot. */
#include "answer/wrap.h"
#include "pictures/picture/picture.h"
#include "pictures/picture/show.h"
#include "sheet/sheet.h"
#include <string.h>

static const char title[] = "How fast do dominoes fall?",
                  person[] = "Name ____________________  Date ___________";

/* Copies the next cell of a line, and returns what follows it, or NULL after the last one. */
static const char *cell_next(const char *text, char cell[LINE_TEXT_MOST])
{
    const size_t length = strcspn(text, "|");
    snprintf(cell, LINE_TEXT_MOST, "%.*s", (int)length, text);
    return text[length] ? text + length + 1 : NULL;
}

static int cells_of(const char *text)
{
    int cells = 1;
    for (; (text = strchr(text, '|')) != NULL; text++)
        cells++;
    return cells;
}

/* ---- Text ---- */

enum { TEXT_COLUMNS = 79 };

static void cells_text(const char *text, FILE *out)
{
    char cell[LINE_TEXT_MOST];
    const int width = (TEXT_COLUMNS - 2) / cells_of(text) - 3;
    for (const char *rest = text; rest;) {
        rest = cell_next(rest, cell);
        fprintf(out, " %*s |", width, *cell ? cell : "______");
    }
    fputs("\n", out);
}

static void page_text(const struct page *page, FILE *out)
{
    for (int k = 0; k < page->lines; k++) {
        const struct line *line = &page->line[k];
        if (line->kind == LINE_CELLS) {
            cells_text(line->text, out);
            continue;
        }
        fputs(line->kind == LINE_HEADING ? "\n" : "", out);
        write_wrapped(out, line->text, 0, TEXT_COLUMNS);
        fputs("\n", out);
    }
}

/* ---- gnuplot, on A4 ---- */

enum {
    PAGE_HEIGHT = SHEET_WIDTH * 297 / 210,
    PAGE_TOP = PAGE_HEIGHT - 40,
    LEFT = 24,
    STEP = 19,
    BELOW = 30,
    LETTERS = 98,
    /* the height of the picture of the row; it becomes smaller only if the page then has room for all */
    HEIGHT_LEAST = 190,
    HEIGHT_MOST = 300,
    HEIGHT_SMALL = 240
};

/* A pen that writes lines from the top of a page to its bottom. */
struct pen {
    FILE *script; /* NULL if the pen only measures */
    double y;     /* dots from the bottom of the page */
};

static void label(const struct pen *pen, const char *text, size_t length, double x, double font, bool bold)
{
    if (!pen->script)
        return;
    fputs("set label ", pen->script);
    gnuplot_text_part(pen->script, text, length);
    fprintf(pen->script, " at screen %.6g,%.6g left font '%s,%g' noenhanced front\n", x / SHEET_WIDTH,
            pen->y / PAGE_HEIGHT, bold ? "sans:Bold" : "", font);
}

static void rule(const struct pen *pen, double x, double y, double to_x, double to_y)
{
    if (!pen->script)
        return;
    fprintf(pen->script,
            "set arrow from screen %.6g,%.6g to screen %.6g,%.6g nohead lc rgb '#808080' lw 0.7\n",
            x / SHEET_WIDTH, y / PAGE_HEIGHT, to_x / SHEET_WIDTH, to_y / PAGE_HEIGHT);
}

/* Returns true if a line of a table has an empty cell, which waits for handwriting. */
static bool has_blank(const char *text)
{
    return strstr(text, "||") || text[strlen(text) - 1] == '|';
}

/* Writes a line of a table, with room for handwriting. */
static void cells_draw(struct pen *pen, const char *text)
{
    enum { HIGH = 23, LOW = 16, ACROSS = SHEET_WIDTH - 2 * LEFT };
    char cell[LINE_TEXT_MOST];
    const double wide = (double)ACROSS / cells_of(text), top = pen->y + 15,
                 bottom = top - (has_blank(text) ? HIGH : LOW);
    const struct pen inside = {pen->script, bottom + 8};
    double x = LEFT;
    for (const char *rest = text; rest; x += wide) {
        rest = cell_next(rest, cell);
        label(&inside, cell, strlen(cell), x + 6, 12, false);
        rule(pen, x, top, x, bottom);
    }
    rule(pen, x, top, x, bottom);
    rule(pen, LEFT, top, x, top);
    rule(pen, LEFT, bottom, x, bottom);
    pen->y = bottom - 15;
}

static void line_draw(struct pen *pen, const struct page *page, int k)
{
    const struct line *line = &page->line[k];
    const bool heading = line->kind == LINE_HEADING || line->kind == LINE_TITLE;
    const char *text = line->text;
    if (line->kind == LINE_CELLS) {
        if (k == 0 || page->line[k - 1].kind != LINE_CELLS)
            pen->y -= 8; /* before a table */
        cells_draw(pen, text);
        return;
    }
    pen->y -= heading ? 10 : 0;
    for (size_t n; *text; text += n + (text[n] == ' ' || text[n] == '\n')) {
        n = line_break(text, LETTERS);
        label(pen, text, n, LEFT, line->kind == LINE_TITLE ? 17 : heading ? 14 : 12, heading);
        pen->y -= STEP + (heading ? 3 : 0);
    }
}

/* Returns the line after the part of the page that begins at line k: the next heading, or the end. */
static int part_end(const struct page *page, int k)
{
    do
        k++;
    while (k < page->lines && page->line[k].kind != LINE_HEADING);
    return k;
}

/* Returns how far lines `from` to `to` - 1 reach down, from one line of text to another. */
static double lines_height(const struct page *page, int from, int to)
{
    struct pen pen = {NULL, 0};
    for (int k = from; k < to; k++)
        line_draw(&pen, page, k);
    return -pen.y - STEP;
}

/* Returns true if lines `from` to `to` - 1 fit between y, in dots from the bottom, and the end of the paper.
 */
static bool lines_fit(const struct page *page, int from, int to, double y)
{
    return y - lines_height(page, from, to) >= BELOW;
}

/* Writes the lines of a page from line k, below pen->y. Returns the first line for which the paper has no
 * room, or which begins a part that would be torn here, but not on the next paper. */
static int page_fill(struct pen *pen, const struct page *page, int k)
{
    for (; k < page->lines && lines_fit(page, k, k + 1, pen->y); k++) {
        const int end = part_end(page, k);
        if (page->line[k].kind == LINE_HEADING && !lines_fit(page, k, end, pen->y) &&
            lines_fit(page, k, end, PAGE_TOP))
            break;
        line_draw(pen, page, k);
    }
    return k;
}

/* Writes the lines of a page from line k on paper of their own. */
static void page_draw(struct pen *pen, const struct page *page, int k)
{
    while (k < page->lines) {
        fputs("reset\nunset border\nunset tics\nunset key\nset xrange [0:1]\nset yrange [0:1]\n",
              pen->script);
        pen->y = PAGE_TOP;
        k = page_fill(pen, page, k);
        fputs("plot NaN notitle\n", pen->script);
    }
}

/* Puts the picture of the row at the top of the paper. */
static struct sheet picture_place(const struct stage *stage, double most)
{
    struct sheet sheet = sheet_of(stage, HEIGHT_LEAST, most);
    sheet.below += PAGE_HEIGHT - sheet.height;
    sheet.height = PAGE_HEIGHT;
    sheet.head = 12;
    sheet.indent = LEFT;
    return sheet;
}

static void pages_draw(const struct class_row *class, const struct page pages[2], FILE *script)
{
    const struct stage *stage = &class->row.stage;
    enum { UNDER = 55 }; /* the numbers and the name of the axis */
    const double lowest = lines_height(&pages[0], 0, pages[0].lines) + BELOW + UNDER;
    struct sheet sheet = picture_place(stage, HEIGHT_MOST);
    const double small = HEIGHT_MOST - fmax(lowest - sheet.below, 0);
    if (small >= HEIGHT_SMALL)
        sheet = picture_place(stage, small);
    struct pen pen = {.script = script, .y = sheet.below - UNDER};
    const int rest = page_fill(&pen, &pages[0], 0);
    stage_script(stage, &sheet, script); /* ends the paper */
    page_draw(&pen, &pages[0], rest);
    page_draw(&pen, &pages[1], 0);
}

static bool sheet_draw(struct class_row *class, const struct page pages[2], const struct answer *a,
                       struct problem *problem)
{
    static const char terminal[] = "pdfcairo size 21cm,29.7cm font 'sans,14' fontscale 0.66 enhanced";
    struct picture picture = {.script = a->out};
    const bool is_script = extension_of(a->path)->is_script;
    if (is_script)
        script_head(a, terminal);
    else if (!picture_begin(&picture, a->out, terminal, class->query->scene->compute.interrupt, problem))
        return false;
    pages_draw(class, pages, picture.script);
    return is_script || picture_end(&picture, true, problem);
}

bool sheet_write(struct class_row *class, const struct page pages[2], const struct answer *a,
                 struct problem *problem)
{
    for (size_t k = 0; k < class->row.stage.count; k++)
        class->row.stage.domino[k].part = STANDS; /* which domino is the weakest is a question */
    snprintf(class->row.stage.caption, CAPTION, "%s\n%s\nThe row, to scale:", title, person);
    if (a->path && extension_of(a->path)->terminal)
        return sheet_draw(class, pages, a, problem);
    if (!stage_show(&class->row.stage, a, class->query->scene->compute.interrupt, problem))
        return false;
    page_text(&pages[0], a->out);
    fputs(a->path ? "\f" : "\n", a->out);
    page_text(&pages[1], a->out);
    return true;
}
