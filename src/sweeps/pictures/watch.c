/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'watch': arrow keys change a parameter, and a point moves along the answer's curve. Enter
 * stores the value in the session. */
#include "interpreter/command.h"
#include "io/terminal.h"
#include "pictures/plots/plots.h"
#include "session/session.h"
#include "sweeps/sweeps.h"
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
    STEPS = 200, /* number of small steps in the range */
    COARSE = 5   /* number of small steps between two points of the curve */
};

struct watch {
    const struct parameter *parameter;
    struct probe probe;
    double from, to;
    double curve[STEPS / COARSE + 1]; /* the answers along the curve, or NaN if there is no answer */
    double x;                         /* the value of the parameter at the moving point */
};

static double watch_x(const struct watch *w, int step)
{
    return w->from + (w->to - w->from) * step / STEPS;
}

/* Computes the curve and puts the point at the parameter's value. Fails if the curve has no points. */
static bool watch_begin(struct watch *w, struct problem *problem)
{
    int answers = 0;
    for (int i = 0; i <= STEPS / COARSE; i++) {
        w->curve[i] = (double)probe_at(&w->probe, (domq_real)watch_x(w, COARSE * i));
        answers += isfinite(w->curve[i]);
        if (w->probe.wrong || dom_raised(w->probe.query->scene->compute.interrupt))
            return probe_report(&w->probe, problem);
    }
    w->x = fmin(fmax((double)parameter_get(w->probe.query->state, w->parameter), w->from), w->to);
    return answers > 0 || probe_report(&w->probe, problem);
}

/* ---- The screen ---- */

static void watch_draw(struct watch *w, FILE *out)
{
    int width, height;
    struct chart chart = chart_make();
    double x = w->x, y = (double)probe_at(&w->probe, (domq_real)x);
    terminal_size(out, &width, &height);
    struct chart_curve *line = chart_curve(&chart, CHART_LINE, INK_BLUE, 0, "%s", "");
    for (int i = 0; i <= STEPS / COARSE; i++)
        chart_point(&chart, line, watch_x(w, COARSE * i), w->curve[i]);
    struct chart_curve *point = chart_curve(&chart, CHART_POINTS, INK_RED, 0, "%s", "");
    chart_point(&chart, point, x, y);
    chart.x.low = w->from;
    chart.x.high = w->to;
    snprintf(chart.x.label, sizeof chart.x.label, "%s", w->parameter->name);
    chart_prepare(&chart); /* an empty chart is shown if there are no points */
    fputs("\033[H\033[J", out);
    char answer[160];
    if (isfinite(y))
        snprintf(answer, sizeof answer, "%.60s = %.6g %s", w->probe.question->name, y,
                 expression_unit_text(w->probe.unit));
    else
        snprintf(answer, sizeof answer, "%.120s", w->probe.problem.text);
    fprintf(out, "%s = %.6g: %.*s\n", w->parameter->name, x, width > 24 ? width - 20 : 4, answer);
    if (height >= 8 && width >= 34) /* a smaller window has no room for a chart */
        chart_text(&chart, display_of(out), width - 1, height - 3, out);
    fputs(width >= 72 ? "left, right: large steps  up, down: small steps  Enter: keep it  q: quit"
                      : "arrows: move, Enter: keep, q: quit",
          out);
    fflush(out);
    chart_free(&chart);
}

/* Handles keys until a key, a signal or the end of the input ends the command. Returns true if the value is
 * to be kept. */
static bool watch_run(struct watch *w, FILE *out)
{
    static const int steps[] = {1, -1, COARSE, -COARSE}; /* up, down, right, left */
    int width = 0, height = 0, key = KEY_NONE,
        step = (int)lround(STEPS * (w->x - w->from) / (w->to - w->from));
    double shown = (double)NAN;
    while (key != '\n' && key != '\r' && key != KEY_END) {
        int across, down;
        terminal_size(out, &across, &down);
        if (across != width || down != height || w->x != shown)
            watch_draw(w, out);
        width = across;
        height = down;
        shown = w->x;
        key = screen_key(1);
        if (key >= KEY_UP && key <= KEY_LEFT) {
            step += steps[key - KEY_UP];
            step = step < 0 ? 0 : step > STEPS ? STEPS : step;
            w->x = watch_x(w, step);
        }
    }
    return key != KEY_END;
}

/* Checks that the session is interactive, and that the terminal can move its cursor. */
static bool watch_possible(const struct session *session, struct problem *problem)
{
    int width, height;
    const char *term = getenv("TERM");
    bool terminal = isatty(STDIN_FILENO) && terminal_size(session->output->out, &width, &height);
    return (session->source.prompt_width && terminal && term && strcmp(term, "dumb") != 0) ||
           problem_error(problem, "'watch' works only at the prompt of a terminal that can move its cursor; "
                                  "elsewhere 'sweep s 0.1 0.9 9 : rmax' lists the answers");
}

static bool run_watch(struct session *session, const struct arguments *given, struct answer *a,
                      struct problem *problem)
{
    const struct sweep *asked = given->bound;
    const struct axis *axis = asked->grid.axis;
    const struct query query = session_query(session);
    struct watch w = {.parameter = axis->parameter, .from = (double)axis->from, .to = (double)axis->to};
    w.probe = (struct probe){.query = &query,
                             .command = problem->command,
                             .question = asked->answer,
                             .parameter = axis->parameter};
    if (!watch_possible(session, problem))
        return false;
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    bool begun = watch_begin(&w, problem), is_kept = false;
    progress_end();
    FILE *screen = begun ? screen_begin(session->output->out) : NULL;
    if (screen) {
        is_kept = watch_run(&w, screen);
        screen_end();
    }
    gsl_set_error_handler(handler);
    domq_real value = w.x;
    if (is_kept && !parameter_set(&session->state, w.parameter, &value, 1, NULL, problem))
        return false;
    if (begun)
        answer_say(a, "%s %s %.6g", w.parameter->name,
                   is_kept ? "is now" : "stays as it was; the point was at", w.x);
    return begun;
}

static const struct command watch_commands[] = {
    {.name = "watch",
     .synonyms = "interactive slider live keys explore",
     A_RANGE_AND_ANSWER("NAME", range_parse_one, answer_parse_number),
     .summary = "vary a parameter with the arrow keys, and see ANSWER on a curve",
     .help =
         "An example is 'watch s 0.1 0.9 : rmax'. The left and right arrow keys make large steps, and the up "
         "and down keys make small ones. Enter keeps the value; q and ^C leave the parameter as it was.",
     .see = "solve sweep plot",
     .access.changes = true,
     .act = run_watch},
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"Exploring with the arrow keys", "sweeps", watch_commands},
    {NULL, NULL, NULL},
};

extern const struct plot sweep_plots[];

static const struct plot *const plots[] = {sweep_plots, NULL};

const struct feature sweeps_pictures_feature = {.name = "sweeps_pictures", .groups = groups, .plots = plots};
