/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'sheet', which writes a page for a class that times a row of equal dominoes, and a page with
 * the answers. */
#include "interpreter/command.h"
#include "io/io.h"
#include "language/names.h"
#include "language/quad.h"
#include "language/text.h"
#include "language/units.h"
#include "pictures/drawing/falling_row.h"
#include "session/parameters.h"
#include <stdlib.h>
#include <strings.h>

/* ---- The numbers ---- */

enum { TRIALS = 4 };

/* A row that the class can time. */
struct trial {
    double gap; /* in m */
    size_t dominoes;
    double seconds; /* NaN if the row does not fall to its end */
};

struct class_row {
    const struct query *query;
    struct falling_row row;
    const char *unit; /* the unit of lengths on the sheet, and its size in m */
    double size;
    struct trial trial[TRIALS]; /* the first one is the row of the session */
    int trials;
};

/* Runs a row like that of the session. */
static bool trial_run(const struct query *query, struct trial *trial, struct problem *problem)
{
    struct state state;
    struct query changed;
    struct row_run run;
    struct problem ignored = *problem;
    const struct assigned assigned[] = {
        {.parameter = parameter_find("s"), .length = {.m = (domq_real)trial->gap}},
        {.parameter = parameter_find("row"), .value = (domq_real)trial->dominoes},
    };
    trial->seconds = (double)NAN;
    /* A gap that the scene cannot have is not an error of the user: this trial is left out. */
    if (query_with(query, assigned, 2, &state, &changed, &ignored) &&
        row_run(&changed, &ignored, true, &run)) {
        if (run.verdict.end == DOM_ROW_FALLS)
            trial->seconds = (double)run.verdict.seconds;
        row_run_free(&run);
    }
    return !dom_raised(query->scene->compute.interrupt) ||
           problem_status(problem, query->scene, DOM_INTERRUPTED);
}

/* Returns a gap of two digits in the unit of the sheet, so that a class can measure it. */
static double gap_round(const struct class_row *class, double gap)
{
    const double digit = pow(10, floor(log10(gap / class->size)) - 1) * class->size;
    return digit * round(gap / digit);
}

/* Runs the row, rows with other gaps, and one with twice as many dominoes. Keeps those that fall. */
static bool class_make(struct class_row *class, struct problem *problem)
{
    const struct query *query = class->query;
    const struct scene *scene = query->scene;
    const struct row_run *run = &class->row.run;
    const size_t count = run->scene.row.count;
    if (count < 2 || scene->train.r != 1 || scene->slot)
        return problem_no_answer(problem, "a sheet needs a row of at least two dominoes, all equal, with "
                                          "equal gaps; 'plan' describes other rows");
    if (run->verdict.end != DOM_ROW_FALLS)
        return problem_no_answer(
            problem,
            "the row does not fall to its end, so nobody can time it: the fall ends at domino %zu of "
            "%zu; 'fall' shows why, and 'set push' or 'mend' may help",
            run->verdict.domino, count);
    if (!isfinite((double)run->verdict.seconds))
        return problem_no_answer(problem,
                                 "one domino almost stops, so the duration of the fall cannot be computed");
    /* The unit in which the user gave a length, or else one that suits the dominoes. */
    const char *typed =
        *scene->length[SHARE_s].unit ? scene->length[SHARE_s].unit : scene->length[SHARE_d].unit;
    const double tall = class->row.stage.top;
    const bool suits = *typed && tall < 2000 * (double)expression_unit(typed).value;
    class->unit = suits ? typed : tall < 0.2 ? "mm" : tall < 2 ? "cm" : "m";
    class->size = (double)expression_unit(class->unit).value;
    const struct trial first = {(double)run->scene.domino[1].gap, count, (double)run->verdict.seconds},
                       others[] = {{gap_round(class, 0.6 * first.gap), count, 0},
                                   {gap_round(class, 1.4 * first.gap), count, 0},
                                   {first.gap, 2 * count, 0}};
    bool good = true;
    class->trial[class->trials++] = first;
    for (int k = 0; k < TRIALS - 1 && good; k++) {
        class->trial[class->trials] = others[k];
        good = trial_run(query, &class->trial[class->trials], problem);
        class->trials += good && isfinite(class->trial[class->trials].seconds);
    }
    return good;
}

/* ---- Numbers as text ---- */

/* Returns a length with at most four digits, in the unit of the sheet. */
static struct words length_of(const struct class_row *class, double m)
{
    struct words length;
    snprintf(length.text, sizeof length.text, m < 1e4 * class->size ? "%.4g %s" : "%.0f %s", m / class->size,
             class->unit);
    return length;
}

/* A stopwatch shows hundredths of a second. They are too coarse for a time below 0.1 s. */
static struct words time_of(double seconds)
{
    struct words time;
    snprintf(time.text, sizeof time.text,
             seconds < 0.1   ? "%.2g s"
             : seconds < 100 ? "%.2f s"
                             : "%.0f s",
             seconds);
    return time;
}

/* Returns the number in a text of the sheet, so that what is computed from it agrees with the paper. */
static double shown(struct words text)
{
    return strtod(text.text, NULL);
}

/* ---- The pages ---- */

/* What the class sets up and measures, and the times to expect. The table is the file that 'fit' reads. */
static void trials_write(const struct class_row *class, FILE *page, FILE *answers)
{
    const struct trial *first = class->trial;
    const struct row_run *run = &class->row.run;
    const struct domq_domino *d = run->scene.domino;
    const struct effect_state *slope = &class->query->scene->effect[DOM_EFFECT_slope];
    const struct words tall = length_of(class, (double)d->height);
    char start[SENTENCE];
    fprintf(page,
            "# Set up\n%zu dominoes, each %s tall and %s thick, with gaps of %s. From the front of one "
            "domino to the front of the next it is %s.\n",
            first->dominoes, tall.text, length_of(class, (double)d->thickness).text,
            length_of(class, first->gap).text, length_of(class, first->gap + (double)d->thickness).text);
    if (slope->on)
        fprintf(page, "The floor slopes %s the direction of the fall, by %.4g degrees.\n",
                slope->value[0] > 0 ? "down in" : "up in", fabs((double)(slope->value[0] * 180 / QUAD_PI)));
    falling_row_begin(&class->row, start);
    fprintf(page,
            "%s Start the clock at the %s, and stop it when the last domino lies on the table.\n# "
            "Measure\nGuess first. The row will take _______ s.\nThen let each row fall three times. Set "
            "it up anew each time.\n|gap (%s)|dominoes|trial 1 (s)|trial 2 (s)|trial 3 (s)|mean (s)\n",
            start, falling_row_start(&class->row), class->unit);
    fprintf(answers, "# The times to expect\n");
    for (const struct trial *t = first; t < first + class->trials; t++) {
        fprintf(page, "|%.4g|%zu||||\n", t->gap / class->size, t->dominoes);
        fprintf(answers, "%zu dominoes of %s with gaps of %s: %s\n", t->dominoes, tall.text,
                length_of(class, t->gap).text, time_of(t->seconds).text);
    }
    fprintf(answers, "The clock runs from the %s until the last domino lies on the floor.\n",
            falling_row_start(&class->row));
}

/* Writes the questions beside their answers. */
static void questions_write(const struct class_row *class, FILE *page, FILE *answers)
{
    const struct trial *first = class->trial, *last = first + class->trials - 1, *fastest = first;
    const struct words length = length_of(class, class->row.stage.right), time = time_of(first->seconds);
    const double speed = shown(length) / shown(time);
    int n = 1;
    for (const struct trial *t = first; t <= last; t++)
        fastest = t->dominoes == first->dominoes && t->seconds < fastest->seconds ? t : fastest;
    fprintf(page,
            "# Questions\n%d. The row is %s long. How fast does it fall, length divided by time? _______ "
            "%s/s\n",
            n, length.text, class->unit);
    fprintf(answers,
            speed < 100 ? "# Answers\n%d. %s / %s = %.3g %s/s." : "# Answers\n%d. %s / %s = %.0f %s/s.", n,
            length.text, time.text, speed, class->unit);
    if (class->trials > 1) {
        fprintf(page, "%d. Which gap gives the shortest time? _______\n", ++n);
        fprintf(answers, "\n%d. %s. But rows differ in length: compare the speeds, too.", n,
                length_of(class, fastest->gap).text);
    }
    if (last->dominoes > first->dominoes) {
        fprintf(page, "%d. Does a row of twice as many dominoes take twice as long? Why, or why not?\n", ++n);
        fprintf(answers,
                "\n%d. It takes %.2f times as long. The start is slow, and there is only one start; later "
                "the front has a constant speed.",
                n, shown(time_of(last->seconds)) / shown(time));
    }
    fprintf(
        page,
        "%d. Would rougher dominoes make the row faster or slower? Try it with paper between them.\n"
        "%d. How far apart are your three times? Why do they differ?\n"
        "# With the program\nType the times into a file class.csv, each on a line, with commas. Its first "
        "line is: gap (%s), dominoes, time (s). In the session of this row, 'fit friction class.csv' "
        "finds the friction between your dominoes.\n",
        n + 1, n + 2, class->unit);
    fprintf(answers,
            "\n%d. Slower: friction between the dominoes takes energy from the row.\n%d. A hand with a "
            "stopwatch is wrong by about 0.1 s; and no row is set up twice in the same way.\n"
            "# What the program assumes\nThe settings of the session, which 'show' lists, without random "
            "errors. %s\n"
            "g = %.5g m/s^2\n",
            n + 1, n + 2,
            class->query->scene->effect[DOM_EFFECT_friction].on
                ? ""
                : "There is no friction. Real dominoes rub against each other, and a real row is slower. "
                  "'fit' finds "
                  "how much.",
            (double)class->row.run.scene.row.g);
}

/* ---- The command ---- */

/* Returns both pages as a paper, with the answers on the second one, or NULL if memory runs out. */
static char *pages_make(const struct class_row *class, const char *title)
{
    char *text = NULL, *paper = NULL;
    size_t length, size;
    FILE *answers = io_memory(&text, &length), *page = io_memory(&paper, &size);
    if (answers && page) {
        trials_write(class, page, answers);
        questions_write(class, page, answers);
    }
    bool good = answers && fclose(answers) == 0 && page;
    if (good)
        fprintf(page, "\f\n# %s The answers\n%s", title, text);
    good = page && fclose(page) == 0 && good;
    free(text);
    if (!good)
        free(paper);
    return good ? paper : NULL;
}

/* Writes the picture of the row and both pages to the destination of the answer. */
static bool sheet_write(struct class_row *class, struct answer *a, struct problem *problem)
{
    static const char title[] = "How fast do dominoes fall?";
    struct stage *stage = &class->row.stage;
    char *paper = pages_make(class, title);
    bool good = paper || problem_status(problem, class->query->scene, DOM_NO_MEMORY);
    for (size_t k = 0; k < stage->count; k++)
        stage->domino[k].part = STANDS; /* which domino is the weakest is a question */
    snprintf(stage->caption, CAPTION, "Name ____________________  Date ___________\nThe row, to scale:");
    if (good && picture_is_filed(a)) {
        good = paper_draw(paper, title, stage, a, problem);
    } else if (good) {
        fprintf(a->out, "%s\n", title);
        good = stage_show(stage, a, problem);
        paper_write(paper, a->out);
    }
    free(paper);
    return good;
}

static bool run_sheet(const struct query *query, struct answer *a, struct problem *problem)
{
    struct class_row class = {.query = query};
    const char *ending = a->path ? extension_of(a->path)->text : NULL;
    if (!query->scene->effect[DOM_EFFECT_row].on)
        return problem_error(problem, "a sheet needs a row; first enter, for example, 'set r 1; set s 20 "
                                      "mm; set push 3; set row 28'");
    if (ending && (strcasecmp(ending, ".svg") == 0 || strcasecmp(ending, ".png") == 0))
        return problem_error(
            problem, "a sheet has two pages, which a picture such as '%s' cannot have; use .pdf, .gp or .txt",
            names_shown(a->path));
    if (!falling_row_make(query, problem, false, &class.row))
        return false;
    bool good = class_make(&class, problem);
    if (good && answer_for_people(a))
        good = sheet_write(&class, a, problem);
    else
        for (int k = 0; k < class.trials && good; k++)
            answer_cells(a, cell_real((domq_real) class.trial[k].gap),
                         cell_count((domq_real) class.trial[k].dominoes),
                         cell_narrow((domq_real) class.trial[k].seconds, 4));
    falling_row_free(&class.row);
    return good;
}

static const struct column sheet_columns[] = {
    {"gap", "m", "the gap between neighbouring dominoes", 0},
    {"dominoes", "", "the number of dominoes", 0},
    {"seconds", "s", "how long the row takes to fall, as 'fall' measures it", 0},
    {NULL, NULL, NULL, 0},
};

static const struct command sheet_commands[] = {
    {.name = "sheet",
     .synonyms = "class school pupil teacher worksheet print measure experiment page pdf",
     .summary = "a page for a class that times the row, and a page with the answers",
     .help = "The first page has the row to scale, what to set up, blanks for measurements, and questions. "
             "The second page has the answers, with the times to expect. The dominoes and gaps must be "
             "equal. The class also times rows with other gaps and with twice as many dominoes, and 'fit' "
             "reads the times. 'sheet > class.pdf' makes two pages for the printer (with gnuplot). The name "
             "of the file can also end in .gp, for a script, or in .txt. In the terminal the sheet is text. "
             "csv and json have the rows and the times.",
     .example = NULL,
     .see = "fit draw fall row",
     .sweep.refusal = "it draws",
     .writes = WRITES_PICTURES,
     .rows = true,
     ANSWER(sheet)},
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"For a class", "pictures", sheet_commands},
    {NULL, NULL, NULL},
};

const struct feature sheet_feature = {.name = "sheet", .groups = groups};
