/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The train itself, to scale, in characters or by gnuplot. */
#include "commands/drawing/draw_row.h"
#include "commands/tables.h"
#include "commands/walk.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "picture/picture.h"
#include "picture/scene.h"
#include <string.h>

/* ---- In characters ---- */

/* Characters: the scale at the left; ground, scale and words below; all; the most in a line. */
enum { TEXT_LEFT = 6, TEXT_BELOW = 6, CELLS = 40000, WIDTH_MOST = 200 };

struct canvas {
    char cell[CELLS];
    int width, height;
    double unit, left; /* of a column, in heights of the head; a row is two */
};

static void canvas_put(struct canvas *c, struct point p, char mark, bool over)
{
    int column = (int)quad(floor)((domq_real)((p.x - c->left) / c->unit));
    int row = c->height - 1 - (int)quad(floor)((domq_real)(p.y / (2 * c->unit)));
    if (column < 0 || column >= c->width || row < 0 || row >= c->height)
        return;
    char *cell = &c->cell[row * c->width + column];
    if (over || *cell == ' ')
        *cell = mark;
}

/* Points on a grid finer than the characters, over the face of the domino. */
static void canvas_fill(struct canvas *c, const struct drawn *k, double d, double top)
{
    char mark = "#0123456789"[k->number < 0 ? 0 : 1 + k->number % 10];
    /* Only the next one is ever taller than the picture, and it is upright. */
    double seen = k->height > top ? top / k->height : 1;
    int rows = (int)(3 * seen * k->height / c->unit) + 2, columns = (int)(3 * d * k->height / c->unit) + 2;
    const struct point *p = k->corner;
    for (int i = 0; i <= rows; i++)
        for (int j = 0; j <= columns; j++) {
            /* Not its very edges, which would make every domino a character wider. */
            double up = seen * (0.02 + 0.96 * i / rows), back = (j + 0.5) / (columns + 1);
            double x = p[0].x + up * (p[1].x - p[0].x) + back * (p[3].x - p[0].x);
            double y = p[0].y + up * (p[1].y - p[0].y) + back * (p[3].y - p[0].y);
            canvas_put(c, (struct point){x, y}, mark, false);
        }
}

static void canvas_make(struct canvas *c, const struct stage *scene, double d, int width, int height)
{
    c->width = width;
    c->height = height;
    memset(c->cell, ' ', sizeof c->cell);
    double quad = (scene->right - scene->left) / width, tall = scene->top / (2 * height);
    c->unit = quad > tall ? quad : tall;
    c->left = scene->right - c->unit * width;
    for (int k = 0; k < scene->count; k++)
        canvas_fill(c, &scene->domino[k], d, scene->top);
    for (int k = 0; k < scene->count; k++)
        if (scene->domino[k].touched && scene->domino[k].height > 4 * c->unit)
            canvas_put(c, scene->domino[k].contact, '@', true);
}

/* A mark each half height of the head, so far apart that their numbers do not meet. */
static double canvas_step(const struct canvas *c)
{
    double step = 0.5;
    while (step < 8 * c->unit)
        step *= 2;
    return step;
}

/* The ground with its marks, and their numbers below. */
static void canvas_ground(const struct canvas *c, FILE *out)
{
    enum { LAST = 16 }; /* a longer number continues after the last column */
    char ground[WIDTH_MOST], numbers[WIDTH_MOST + LAST];
    double step = canvas_step(c);
    memset(ground, '-', (size_t)c->width);
    memset(numbers, ' ', (size_t)c->width + 8);
    for (double k = (double)quad(ceil)((domq_real)(c->left / step)); k * step < c->left + c->unit * c->width;
         k++) {
        int at = (int)((k * step - c->left) / c->unit), from = at > 2 ? at - 2 : 0;
        char number[16];
        int n = snprintf(number, sizeof number, "%4.3g", k * step + 0.0); /* no -0 */
        if (at < 0 || at >= c->width)
            continue;
        ground[at] = '+';
        memcpy(numbers + from, number, (size_t)(n < 6 ? n : 6));
    }
    int end = c->width;
    while (end > 0 && numbers[end - 1] == ' ')
        end--;
    fprintf(out, "%*s%.*s\n%*s%.*s\n", TEXT_LEFT, "0 -", c->width, ground, TEXT_LEFT, "x [h]", end, numbers);
}

static void canvas_write(const struct canvas *c, FILE *out)
{
    double step = canvas_step(c) / 2;
    for (int row = 0; row < c->height; row++) {
        double low = 2 * c->unit * (c->height - 1 - row), high = low + 2 * c->unit;
        double mark = step * (double)quad(ceil)((domq_real)(low / step));
        const char *line = c->cell + (size_t)row * (size_t)c->width;
        int end = c->width;
        while (end > 0 && line[end - 1] == ' ')
            end--;
        if (mark > 0 && mark < high && row > 0)
            fprintf(out, "%4.3g -", mark);
        else
            fprintf(out, "%*s", row == 0 || end > 0 ? TEXT_LEFT : 0, row == 0 ? "z [h]" : "");
        fprintf(out, "%.*s\n", end, line);
    }
    canvas_ground(c, out);
}

enum { TITLE_SIZE = 256 };

/* "theta = 0.3 rad (17.19 deg), s = 0.4, r = 1.5, d = 0.1458, h = 48 mm, to scale"; the radius of rounded
 * edges takes the place of the last words. */
static const char *title_text(const struct query *query, domq_real theta, const char *letter,
                              char text[TITLE_SIZE])
{
    const struct domq_train *t = &query->scene->train;
    const struct walk *walk = walk_now(query);
    struct walk_units units = walk_units(query, walk ? walk->cycle : 1);
    char last[40] = "to scale";
    if (t->rho != 0)
        snprintf(last, sizeof last, "edges %.4g h", (double)t->rho);
    snprintf(text, TITLE_SIZE, "%s = %.4g rad (%.4g deg), s = %.4g, r = %.4g, d = %.4g, h = %.4g mm, %s",
             letter, (double)theta, (double)(theta * (180 / QUAD_PI)), (double)t->s, (double)t->r,
             (double)t->d, (double)(1000 * units.height), last);
    return text;
}

/* How tall the next one is, where the picture cuts it off. */
static const char *next_cut(const struct stage *scene, char text[32])
{
    double height = scene->domino[0].height;
    text[0] = '\0';
    if (height > scene->top)
        snprintf(text, 32, " (%.4g h tall)", height);
    return text;
}

enum { FORCES_MOST = 6 }; /* in characters: the others are hardly seen */

/* Returns true where the domino is touched at its hinge (r s = 1): no push there, however large, turns it. */
static bool force_lost(const struct drawn *k)
{
    return k->touched && !isfinite(k->of_own);
}

/* "0: 0.12, 1: 0.14". */
static void forces_write(const struct stage *scene, int width, FILE *out)
{
    char text[TITLE_SIZE];
    int at = snprintf(text, sizeof text, "contact forces, in weights of the one that is pushed:");
    for (int k = 1; k <= FORCES_MOST && k < scene->count && scene->domino[k].touched; k++) {
        char force[32] = "none is enough";
        if (!force_lost(&scene->domino[k]))
            snprintf(force, sizeof force, "%.3g", scene->domino[k].of_own);
        at += snprintf(text + at, sizeof text - (size_t)at, "%s %d: %s", k > 1 ? "," : "",
                       scene->domino[k].number, force);
    }
    output_wrapped(out, text, 0, width);
    putc('\n', out);
}

static void draw_text(const struct query *query, struct answer *a, domq_real theta, const struct stage *scene,
                      bool forces)
{
    static struct canvas canvas;
    char text[TITLE_SIZE], cut[32];
    FILE *out = a->out;
    int width, height;
    ticker_stop();
    picture_room(a, &width, &height);
    width = width < WIDTH_MOST ? width : WIDTH_MOST;
    canvas_make(&canvas, scene, (double)query->scene->train.d, width - TEXT_LEFT,
                height - TEXT_BELOW - forces);
    output_wrapped(out, title_text(query, theta, "theta", text), 0, width);
    putc('\n', out);
    canvas_write(&canvas, out);
    snprintf(text, sizeof text, "0: head; 1, 2, ...: its followers; #: the next%s; @: contact",
             next_cut(scene, cut));
    output_wrapped(out, text, 0, width);
    putc('\n', out);
    if (forces)
        forces_write(scene, width, out);
}

/* ---- By gnuplot ---- */

/* Draws the push on the back of a domino, perpendicular to the back, with its number at the free end. */
static void script_arrow(FILE *script, const struct drawn *k, double length)
{
    double cosine = k->corner[1].y / k->height, sine = (k->corner[1].x - k->corner[0].x) / k->height;
    struct point from = along(k->contact, -length * k->height, cosine, -sine);
    fprintf(script,
            "set arrow from %.7g,%.7g to %.7g,%.7g head filled size graph 0.012,20 lw 2.5 lc rgb '#c00000' "
            "front\n",
            from.x, from.y, k->contact.x, k->contact.y);
    if (k->height > 0.25)
        fprintf(script, "set label '%.3g' at %.7g,%.7g right offset char -0.3,0.5 tc rgb '#c00000' front\n",
                k->of_own, from.x, from.y);
}

static void script_arrows(FILE *script, const struct stage *scene)
{
    double largest = 0;
    for (int k = 1; k < scene->count; k++)
        if (isfinite(scene->domino[k].of_own) && scene->domino[k].of_own > largest)
            largest = scene->domino[k].of_own;
    for (int k = 1; k < scene->count; k++)
        if (scene->domino[k].height > 0.1 && scene->domino[k].of_own > 0 && !force_lost(&scene->domino[k]))
            script_arrow(script, &scene->domino[k], 0.4 * scene->domino[k].of_own / largest);
}

static bool draw_file(const struct query *query, struct answer *a, struct problem *problem, domq_real theta,
                      const struct stage *scene, bool forces)
{
    char text[TITLE_SIZE], cut[32];
    struct picture picture;
    if (!picture_begin(a, problem, &picture))
        return false;
    FILE *out = picture.script;
    script_axes(out, scene->left, scene->right, scene->top);
    fprintf(out, "set title \"%s\\n0: head; 1, 2, ...: its followers; grey: the next%s; dots: contacts%s\"\n",
            title_text(query, theta, picture.theta, text), next_cut(scene, cut),
            forces ? "\\narrows: the push at a contact, in weights of the domino that is pushed" : "");
    for (int k = scene->count - 1; k >= 0; k--)
        script_domino(out, &scene->domino[k], (struct place){1, 0},
                      scene->domino[k].height * (double)query->scene->train.d > 0.025 * scene->top
                          ? scene->left
                          : (double)INFINITY);
    if (forces)
        script_arrows(out, scene);
    fprintf(out, "plot NaN\n");
    return picture_end(query, problem, &picture, true);
}

static const struct column draw_columns[] = {
    {"i", "", "number of the domino: 0 is the head, -1 the next", 5},
    {"height", "h", "its height, h being that of the head", 0},
    {"x", "h", "its hinge, the lower front edge", 0},
    {"theta", "rad", "its tilt", 0},
    {"top_front_x", "h", "its corners: top in front", 0},
    {"top_front_z", "h", "height of that above the ground", 0},
    {"top_back_x", "h", "top at the back", 0},
    {"top_back_z", "h", "height of that", 0},
    {"foot_back_x", "h", "foot at the back", 0},
    {"foot_back_z", "h", "height of that", 0},
    {"contact_x", "h", "where its follower touches its back face", 0},
    {"contact_z", "h", "height of that", 0},
    {"force", "m g", "the push there, square to the face, m of the head", 0},
    {"of_own", "m g", "the same, m of this domino", 0},
    {NULL, NULL, NULL, 0},
};

static struct cell cell_double(double value)
{
    return cell_real((domq_real)value);
}

static void draw_rows(struct answer *answer, const struct stage *scene, enum dom_status forces)
{
    answer->style.errors = 0; /* a picture needs no bounds */
    for (int n = 0; n < scene->count; n++) {
        const struct drawn shown = drawn_for_people(&scene->domino[n]), *k = &shown;
        const struct point *p = k->corner;
        answer_row(
            answer,
            ROW(cell_count((domq_real)k->number), cell_double(k->height), cell_double(k->foot),
                cell_double(k->theta), cell_double(p[1].x), cell_double(p[1].y), cell_double(p[2].x),
                cell_double(p[2].y), cell_double(p[3].x), cell_double(p[3].y), cell_double(k->contact.x),
                cell_double(k->contact.y), cell_double(k->force), cell_double(k->of_own)),
            !force_lost(k)     ? NULL
            : forces == DOM_OK ? "the contact is at the hinge: no push, however large, turns this domino"
                               : dom_status_text(forces));
    }
}

static bool run_draw(const struct query *query, struct answer *a, struct problem *problem)
{
    static struct stage scene;
    static const struct draw_what nothing;
    const struct draw_what *what = query->given->own ? query->given->own : &nothing;
    bool of_row = what->at != ROW_STANDS || !(what->train || what->forces || what->tilted);
    if (what->at != ROW_STANDS && !query->scene->effect[DOM_EFFECT_row].on) {
        problem->place = query->given->column[0];
        return problem_error(problem, "'draw at' shows a moment of a row; first enter 'effect row N', for "
                                      "example 'effect row 10'");
    }
    if (of_row && query->scene->effect[DOM_EFFECT_row].on)
        return draw_row(query, a, problem, what);
    a->of_row = what->train; /* it was asked for */
    /* Without T the train is drawn where the walk has it, to the walk's own, finer tolerance. */
    const struct walk *walk = what->tilted ? NULL : walk_now(query);
    const struct domq_compute *compute = walk ? &walk->compute : &query->scene->compute;
    domq_real theta = walk ? walk->theta : what->theta;
    bool people = answer_for_people(a);
    if (!walk && !picture_comes_to(query, problem, theta))
        return false;
    enum dom_status status = stage_make(&query->scene->train, compute, theta, 0, &scene);
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    /* Data has forces where there are any; the margin may be too small for them. */
    if (what->forces || !people)
        status = scene_forces(&query->scene->train, compute, theta, &scene);
    if (status != DOM_OK && what->forces)
        return problem_status(problem, query->scene, status);
    if (!people)
        draw_rows(a, &scene, status);
    else if (picture_is_text(a))
        draw_text(query, a, theta, &scene, what->forces);
    else
        return draw_file(query, a, problem, theta, &scene, what->forces);
    return true;
}

const struct command draw_commands[] = {
    {.name = "draw",
     .synonyms = "picture image drawing figure svg png pdf show",
     .train = true,
     .argument = {{.name = "WHAT",
                   .kind = ARGUMENT_WORDS,
                   .optional = true,
                   .parse = draw_parse,
                   .bind = draw_bind,
                   .choices = draw_names}},
     .summary = "the row, or the train, to scale; at a moment, with forces",
     .help =
         "'draw' draws the row as it is set up, with the weakest domino and the one that stops it. "
         "'draw at 2.5 s', 'draw at domino 8' (when it is hit) and 'draw at end' show the row as it "
         "falls; a domino that has detached is shown as it was then. Without a row, or with 'draw "
         "train', it is the endless train: at a tilt, 'draw 0.3', or else where 'step' and 'goto' "
         "have led, or at the launch; 'draw 0.3 forces' and 'draw forces' add the contact forces. "
         "The terminal gets characters; the ending of a file says how 'draw > row.svg' draws: .svg, .png, "
         ".pdf (with gnuplot) or .txt. csv and json hold the corners, in m for a row, and contacts and "
         "forces of a train.",
     .equation = "(12; b8) (27; A2)",
     .example = "draw 0.3",
     .see = "chain animate plot row fall",
     .unswept = "it draws",
     .draws = true,
     .rows = true,
     ANSWER(draw)},
    {.name = "animate",
     .synonyms = "picture image film movie video gif",
     .train = true,
     .argument = {{.name = "FILE", .kind = ARGUMENT_FILE},
                  {.name = "HOW",
                   .kind = ARGUMENT_WORDS,
                   .optional = true,
                   .parse = film_parse,
                   .bind = film_bind,
                   .choices = film_names}},
     .summary = "the row, or cycles of the train, as they run in time, into FILE",
     .help =
         "'animate row.gif' shows the row from the push until the last domino lies, or until it stops, in "
         "real time and with a clock. 'speed 0.5' runs it half as fast, 'rate 20' with 20 frames in a "
         "second. Where sizes differ by more than 30 the view follows the front and grows with it. "
         "Without a row, or with 'animate train.gif train', N cycles of the endless train: each lasts "
         "sqrt(r) times as long as the one before, and is r times larger, so that at most 9 can be seen "
         "together at r = 1.5; 'animate train.gif train 4'. Files end in .gif, or in .webm or .mp4 where "
         "ffmpeg is "
         "installed. It needs gnuplot; in csv and json the times and tilts of the frames come instead.",
     .example = NULL,
     .see = "draw duration",
     .unswept = "it draws",
     .draws = true,
     .rows = true,
     .files = true,
     ANSWER(animate)},
    {.name = NULL},
};
