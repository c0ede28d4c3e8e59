/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "language/names.h"
#include "language/units.h"
#include "pictures/picture/paper.h"
#include "sheet/sheet.h"
#include <strings.h>

static const struct column sheet_columns[] = {
    {"gap", "m", "the gap between neighbouring dominoes; empty if the gaps differ", 0},
    {"dominoes", "", "the number of dominoes", 0},
    {"seconds", "s", "how long the row takes to fall, as 'fall' measures it", 0},
    {NULL, NULL, NULL, 0},
};

/* Returns a gap of two digits in the unit of the sheet, so that a class can measure it. */
static double gap_round(const struct class_row *class, double gap)
{
    const double digit = pow(10, floor(log10(gap / class->size)) - 1) * class->size;
    return digit * round(gap / digit);
}

/* Runs a row like that of the session. If it does not fall, trial->seconds is NaN. */
static bool trial_run(const struct query *query, struct trial *trial, domq_real friction,
                      struct problem *problem)
{
    struct state state;
    struct query changed;
    struct row_run run;
    struct problem ignored = *problem;
    const struct assigned assigned[] = {
        {.parameter = parameter_find("s"), .length = {.m = (domq_real)trial->gap}},
        {.parameter = parameter_find("row"), .value = (domq_real)trial->dominoes},
        {.parameter = parameter_find("friction"), .value = friction},
    };
    trial->seconds = (double)NAN;
    /* A gap or a friction that the scene cannot have is not an error of the user: this trial is left out. */
    if (query_with(query, assigned, friction > 0 ? 3 : 2, &state, &changed, &ignored) &&
        row_run(&changed, &ignored, true, &run)) {
        if (run.verdict.end == DOM_ROW_FALLS)
            trial->seconds = (double)run.verdict.seconds;
        row_run_free(&run);
    }
    return !dom_raised(query->scene->compute.interrupt) ||
           problem_status(problem, query->scene, DOM_INTERRUPTED);
}

/* Runs rows with other gaps, and one with twice as many dominoes. Keeps those that fall. */
static bool trials_run(struct class_row *class, struct problem *problem)
{
    const struct query *query = class->query;
    const struct trial first = class->trial[0];
    const struct trial others[] = {{gap_round(class, 0.6 * first.gap), first.dominoes, 0},
                                   {gap_round(class, 1.4 * first.gap), first.dominoes, 0},
                                   {first.gap, 2 * first.dominoes, 0}};
    bool good = true;
    for (int k = 0; k < TRIALS - 1 && good; k++) {
        struct trial *trial = &class->trial[class->trials];
        *trial = others[k];
        good = trial_run(query, trial, 0, problem);
        class->trials += good && isfinite(trial->seconds);
    }
    const struct effect_state *friction = &query->scene->effect[DOM_EFFECT_friction];
    class->rough = first;
    class->friction = (friction->on ? (double)friction->value[0] : 0) + 0.2;
    return good && trial_run(query, &class->rough, (domq_real) class->friction, problem);
}

/* Chooses the unit in which the user gave a length, or else one that suits the largest domino. */
static void unit_choose(struct class_row *class)
{
    const struct scene *scene = class->query->scene;
    const char *typed =
        *scene->length[SHARE_s].unit ? scene->length[SHARE_s].unit : scene->length[SHARE_d].unit;
    const double tallest = class->row.stage.top;
    const bool suits =
        *typed && !scene->listed.domino && tallest < 2000 * (double)expression_unit(typed).value;
    class->unit = suits ? typed : tallest < 0.2 ? "mm" : tallest < 2 ? "cm" : "m";
    class->size = (double)expression_unit(class->unit).value;
}

static bool class_make(struct class_row *class, struct problem *problem)
{
    const struct scene *scene = class->query->scene;
    const struct row_run *run = &class->row.run;
    const size_t count = run->scene.row.count;
    if (count < 2)
        return problem_no_answer(problem, "a sheet needs a row of at least two dominoes");
    if (run->verdict.end != DOM_ROW_FALLS)
        return problem_no_answer(
            problem,
            "the row does not fall to its end, so nobody can time it: the fall ends at domino %zu of "
            "%zu; 'fall' shows why, and 'set push' or 'mend' may help",
            run->verdict.domino, count);
    if (!isfinite((double)run->verdict.seconds))
        return problem_no_answer(problem,
                                 "one domino almost stops, so the duration of the fall cannot be computed");
    unit_choose(class);
    class->is_equal = scene->train.r == 1 && !scene->listed.domino && scene->listed.changes == 0;
    class->length = class->row.stage.right;
    class->trial[class->trials++] =
        (struct trial){class->is_equal ? (double)run->scene.domino[1].gap : (double)NAN, count,
                       (double)run->verdict.seconds};
    class->rough.seconds = (double)NAN;
    return !class->is_equal || trials_run(class, problem);
}

/* Writes the picture of the row and both pages to the destination of the answer. */
static bool sheet_write(struct class_row *class, struct answer *a, struct problem *problem)
{
    static const char title[] = "How fast do dominoes fall?";
    const volatile sig_atomic_t *interrupt = class->query->scene->compute.interrupt;
    struct stage *stage = &class->row.stage;
    struct paper paper;
    bool good = paper_open(&paper);
    if (good) {
        sheet_questions(class, paper.out);
        fputs("\f\n", paper.out);
        sheet_answers(class, paper.out);
        good = paper_close(&paper);
    }
    for (size_t k = 0; k < stage->count; k++)
        stage->domino[k].part = STANDS; /* which domino is the weakest is a question */
    snprintf(stage->caption, CAPTION, "Name ____________________  Date ___________\nThe row, to scale:");
    if (!good) {
        problem_status(problem, class->query->scene, DOM_NO_MEMORY);
    } else if (a->path && extension_of(a->path)->terminal) {
        good = paper_draw(&paper, title, stage, a, interrupt, problem);
    } else {
        fprintf(a->out, "%s\n", title);
        good = stage_show(stage, a, interrupt, problem);
        paper_write(&paper, a->out);
    }
    paper_free(&paper);
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
    if (!picture_ready(a, problem) || !falling_row_make(query, problem, false, &class.row))
        return false;
    bool good = class_make(&class, problem);
    if (good && answer_for_people(a)) {
        good = sheet_write(&class, a, problem);
    } else {
        for (int k = 0; k < class.trials && good; k++)
            answer_row(a,
                       ROW(cell_real((domq_real) class.trial[k].gap),
                           cell_count((domq_real) class.trial[k].dominoes),
                           cell_narrow((domq_real) class.trial[k].seconds, 4)),
                       NULL);
    }
    falling_row_free(&class.row);
    return good;
}

static const struct command sheet_commands[] = {
    {.name = "sheet",
     .synonyms = "class school pupil teacher worksheet print measure experiment page pdf",
     .summary = "a page for a class that times the row, and a page with the answers",
     .help = "The first page has the row to scale, what to set up, blanks for measurements, and questions. "
             "The second page has the answers, with the times to expect. If all dominoes and gaps are equal, "
             "the class also times rows with other gaps and with twice as many dominoes, and 'fit' reads the "
             "table. 'sheet > class.pdf' makes two pages for the printer (with gnuplot). The name of the "
             "file can also end in .gp, for a script, or in .txt. In the terminal the sheet is text. csv and "
             "json have the rows and the times.",
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
