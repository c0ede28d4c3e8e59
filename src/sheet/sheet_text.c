/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the sheet says. */
#include "language/quad.h"
#include "language/text.h"
#include "session/parameters.h"
#include "sheet/sheet.h"
#include <stdlib.h>
#include <string.h>

/* A length or a time with its unit. */
struct length {
    char text[32];
};

/* Returns a length with at most four digits, in the unit of the sheet. */
static struct length length_of(const struct class_row *class, double m)
{
    struct length length;
    snprintf(length.text, sizeof length.text, m < 1e4 * class->size ? "%.4g %s" : "%.0f %s", m / class->size,
             class->unit);
    return length;
}

/* A stopwatch shows hundredths of a second. They are too coarse for a time below 0.1 s. */
static struct length time_of(double seconds)
{
    struct length time;
    snprintf(time.text, sizeof time.text,
             seconds < 0.1   ? "%.2g s"
             : seconds < 100 ? "%.2f s"
                             : "%.0f s",
             seconds);
    return time;
}

/* Returns the time that the sheet shows, so that what is computed from times agrees with those on the paper.
 */
static double time_shown(double seconds)
{
    return strtod(time_of(seconds).text, NULL);
}

/* Returns the length of the row that the sheet shows, in m. */
static double length_shown(const struct class_row *class)
{
    return strtod(length_of(class, class->length).text, NULL) * class->size;
}

static struct length speed_of(const struct class_row *class, double speed)
{
    struct length text;
    snprintf(text.text, sizeof text.text, speed < 100 * class->size ? "%.3g %s/s" : "%.0f %s/s",
             speed / class->size, class->unit);
    return text;
}

static const struct domq_domino *domino_of(const struct class_row *class, size_t k)
{
    return &class->row.run.scene.domino[k];
}

static double degrees(domq_real angle)
{
    return (double)(angle * 180 / QUAD_PI);
}

/* "28 dominoes of 48 mm with gaps of 20 mm" */
static struct words row_words(const struct class_row *class, const struct trial *trial)
{
    struct words words;
    snprintf(words.text, sizeof words.text, "%zu dominoes of %s with gaps of %s", trial->dominoes,
             length_of(class, (double)domino_of(class, 0)->height).text, length_of(class, trial->gap).text);
    return words;
}

static bool has_push(const struct class_row *class)
{
    return !row_run_tipped(&class->row.run, 0);
}

/* ---- The page for pupils ---- */

static bool has_leans(const struct class_row *class)
{
    bool leans = false;
    for (size_t k = 0; k < class->trial[0].dominoes; k++)
        leans = leans || domino_of(class, k)->lean != 0;
    return leans;
}

/* Lists the dominoes if they differ, with the places of their front faces on a tape measure. */
static void dominoes_list(const struct class_row *class, FILE *out)
{
    enum { LISTED = 20 };
    const bool leans = has_leans(class);
    double at = 0;
    if (!class->query->scene->listed.domino && class->query->scene->train.r != 1)
        fprintf(out, "Each domino is %.4g times as large as the one before it ('set r 1' makes all equal).\n",
                (double)class->query->scene->train.r);
    fputs("Lay a tape measure along the row. Its 0 is at the back of domino 1. The front of a domino looks "
          "in the direction in which the row falls.\n",
          out);
    fprintf(out, "|domino|height|thickness|gap before it|its front is at%s\n",
            leans ? "|its top leans by" : "");
    for (size_t k = 0; k < class->trial[0].dominoes && k < LISTED; k++) {
        const struct domq_domino *d = domino_of(class, k);
        at += (double)(d->thickness + (k > 0 ? d->gap : 0));
        fprintf(out, "|%zu|%s|%s|%s|%s%s%s\n", k + 1, length_of(class, (double)d->height).text,
                length_of(class, (double)d->thickness).text,
                k > 0 ? length_of(class, (double)d->gap).text : "-", length_of(class, at).text,
                leans ? "|" : "", leans ? length_of(class, (double)lean_offset(d)).text : "");
    }
    if (class->trial[0].dominoes > LISTED)
        fputs("The other dominoes are in the file of the row ('row > FILE.csv' writes it).\n", out);
}

/* Says how the class starts the row. */
static void start_write(const struct class_row *class, FILE *out)
{
    const struct scene_row *scene = &class->row.run.scene;
    const double tilt = degrees(scene_row_tilt(scene)),
                 speed = 100 * (double)(scene->row.push * scene->domino->height);
    const char *clock = "and stop it when the last domino lies on the table.";
    char hold[120] = "";
    if (isinf(scene->row.release))
        snprintf(hold, sizeof hold, "Lean domino 1 against domino 2 (with a gap of %s, at %.3g degrees). ",
                 length_of(class, (double)scene->domino[1].gap).text, tilt);
    else if (scene->row.release > 0)
        snprintf(hold, sizeof hold, "Hold domino 1 at a tilt of %.3g degrees. ", tilt);
    if (!has_push(class))
        fprintf(
            out,
            "Tilt domino 1 slowly, until it tips over by itself. Start the clock when it hits domino 2, %s\n",
            clock);
    else if (speed > 0)
        fprintf(out,
                "%sPush the upper edge of domino 1 gently: it begins to move at about %.2g cm/s. Start the "
                "clock with the push, %s\n",
                hold, speed, clock);
    else
        fprintf(out, "%sStart the clock when you let it go, %s\n", hold, clock);
}

static void setup_write(const struct class_row *class, FILE *out)
{
    const struct domq_domino *first = domino_of(class, 0);
    const struct effect_state *slope = &class->query->scene->effect[DOM_EFFECT_slope];
    fputs("# Set up\n", out);
    if (class->is_equal)
        fprintf(out,
                "%zu dominoes, each %s tall and %s thick, with gaps of %s. From the front of one domino to "
                "the front of the next it is %s.\n",
                class->trial[0].dominoes, length_of(class, (double)first->height).text,
                length_of(class, (double)first->thickness).text, length_of(class, class->trial[0].gap).text,
                length_of(class, class->trial[0].gap + (double)first->thickness).text);
    else
        dominoes_list(class, out);
    if (class->is_equal && has_leans(class))
        fputs("The dominoes lean; 'row' in the program lists by how much.\n", out);
    if (slope->on)
        fprintf(out, "The floor slopes %s, by %.4g degrees.\n",
                slope->value[0] > 0 ? "down in the direction of the fall" : "up in the direction of the fall",
                fabs(degrees(slope->value[0])));
    start_write(class, out);
}

static void measure_write(const struct class_row *class, FILE *out)
{
    fputs("# Measure\n", out);
    fputs("Guess first. The row will take _______ s.\n", out);
    fputs("Then let each row fall three times. Set it up anew each time.\n", out);
    if (!class->is_equal)
        fputs("|dominoes|trial 1 (s)|trial 2 (s)|trial 3 (s)|mean (s)\n", out);
    else
        fprintf(out, "|gap (%s)|dominoes|trial 1 (s)|trial 2 (s)|trial 3 (s)|mean (s)\n", class->unit);
    for (int k = 0; k < class->trials; k++) {
        char gap[32] = "";
        if (class->is_equal)
            snprintf(gap, sizeof gap, "%.4g|", class->trial[k].gap / class->size);
        fprintf(out, "|%s%zu||||\n", gap, class->trial[k].dominoes);
    }
}

static void questions_write(const struct class_row *class, FILE *out)
{
    int n = 1;
    fputs("# Questions\n", out);
    fprintf(out, "%d. The row is %s long. How fast does it fall, length divided by time? _______ %s/s\n", n++,
            length_of(class, class->length).text, class->unit);
    if (class->is_equal && class->trials > 1) {
        fprintf(out, "%d. Which gap gives the shortest time? _______\n", n++);
        if (class->trial[class->trials - 1].dominoes > class->trial[0].dominoes)
            fprintf(out, "%d. Does a row of twice as many dominoes take twice as long? Why, or why not?\n",
                    n++);
    }
    if (!class->is_equal)
        fprintf(out,
                "%d. Which domino would stop the row first, if it were a little taller or farther away? "
                "_______\n",
                n++);
    if (class->is_equal)
        fprintf(out,
                "%d. Would rougher dominoes make the row faster or slower? Try it with paper between them.\n",
                n++);
    fprintf(out, "%d. How far apart are your three times? Why do they differ?\n", n++);
}

void sheet_questions(const struct class_row *class, FILE *out)
{
    setup_write(class, out);
    measure_write(class, out);
    questions_write(class, out);
    fputs("# With the program\n", out);
    if (class->is_equal)
        fprintf(
            out,
            "Type the times into a file class.csv, each on a line, with commas. Its first line is: gap (%s), "
            "dominoes, time (s). In the session of this row, 'fit friction class.csv' finds the friction "
            "between your dominoes.\n",
            class->unit);
    else
        fputs(
            "Film the row, and type the times at which dominoes are hit into a file class.csv, each on a "
            "line. "
            "Its first line is: domino, time (s). In the session of this row, 'fit friction class.csv' finds "
            "the friction between your dominoes.\n",
            out);
}

/* ---- The answers ---- */

/* How fast the front of equal dominoes is at the end of the row. */
static struct words front_words(const struct class_row *class)
{
    const struct row_run *run = &class->row.run;
    const double pitch = class->trial[0].gap + (double)domino_of(class, 0)->thickness;
    struct words words = {""};
    if (run->hits > 2)
        snprintf(
            words.text, sizeof words.text, " At the end the front is faster: %s.",
            speed_of(class, pitch / (double)(run->fall[run->hits - 1].time - run->fall[run->hits - 2].time))
                .text);
    return words;
}

static void times_write(const struct class_row *class, FILE *out)
{
    const struct trial *first = class->trial, *last = &class->trial[class->trials - 1];
    int fastest = 0, n = 1;
    bool is_narrowest = true;
    fputs("# The times to expect\n", out);
    for (int k = 0; k < class->trials && class->is_equal; k++) {
        fprintf(out, "%s: %s\n", row_words(class, &class->trial[k]).text,
                time_of(class->trial[k].seconds).text);
        if (class->trial[k].dominoes == first->dominoes &&
            class->trial[k].seconds < class->trial[fastest].seconds)
            fastest = k;
    }
    for (int k = 0; k < class->trials; k++)
        is_narrowest = is_narrowest && class->trial[fastest].gap <= class->trial[k].gap;
    if (!class->is_equal)
        fprintf(out, "The %zu dominoes: %s\n", first->dominoes, time_of(first->seconds).text);
    fprintf(out, "The clock runs from %s until the last domino lies on the floor.\n",
            !has_push(class)                    ? "the hit of domino 1 on domino 2"
            : class->row.run.scene.row.push > 0 ? "the push"
                                                : "the release");
    fputs("# Answers\n", out);
    fprintf(out, "%d. %s / %s = %s.%s\n", n++, length_of(class, class->length).text,
            time_of(first->seconds).text,
            speed_of(class, length_shown(class) / time_shown(first->seconds)).text,
            class->is_equal ? front_words(class).text : "");
    if (class->is_equal && class->trials > 1) {
        fprintf(out, "%d. %s.%s\n", n++, length_of(class, class->trial[fastest].gap).text,
                is_narrowest ? " But this row is also the shortest one: compare the speeds, too." : "");
        if (last->dominoes > first->dominoes)
            fprintf(out,
                    "%d. It takes %.2f times as long. The start is slow, and there is only one start; later "
                    "the front has a constant speed.\n",
                    n++, time_shown(last->seconds) / time_shown(first->seconds));
    }
    if (!class->is_equal && class->row.run.verdict.weakest > 0)
        fprintf(out, "%d. Domino %zu: it has the least energy to spare.\n", n++,
                class->row.run.verdict.weakest);
    else if (!class->is_equal)
        fprintf(out, "%d. The program does not know the energies of this row.\n", n++);
    if (class->is_equal && isfinite(class->rough.seconds))
        fprintf(out, "%d. Slower: with a friction coefficient of %.2g the row would take %s.\n", n++,
                class->friction, time_of(class->rough.seconds).text);
    else if (class->is_equal)
        fprintf(out,
                "%d. Slower: with a friction coefficient of %.2g the row would not even fall to its end.\n",
                n++, class->friction);
    fprintf(
        out,
        "%d. A hand with a stopwatch is wrong by about 0.1 s; and no row is set up twice in the same way.\n",
        n++);
}

/* Lists the effects with which the program computed the times. */
static void effects_write(const struct class_row *class, FILE *out)
{
    const struct scene *scene = class->query->scene;
    char text[300] = "";
    bool random = false;
    for (int k = 0; k < EFFECT_COUNT; k++) {
        if (!scene->effect[k].on || k == DOM_EFFECT_row)
            continue;
        random = random || effect_is_random(k);
        const char *name = effect_at(k)->name;
        const enum share share = parameter_find(name)->share;
        text_add(text, sizeof text, "%s%s ", *text ? ", " : "", name);
        const bool touches = k == DOM_EFFECT_release && isinf(class->row.run.scene.row.release);
        if (strcmp(effect_at(k)->argument[0].unit, "rad") == 0 && !touches)
            text_add(text, sizeof text, "%.4g deg", degrees(scene->effect[k].value[0]));
        else if (share != SHARE_push && scene->length[share].m > 0)
            text_add(text, sizeof text, "%s", length_of(class, (double)scene->length[share].m).text);
        else
            text_add(text, sizeof text, "%s", effect_setting(scene, k));
    }
    fputs("# What the program assumes\n", out);
    if (*text)
        fprintf(out, "The settings of the session: %s.\n", text);
    else
        fputs("No friction, no air, sharp edges, and a level floor.\n", out);
    if (!scene->effect[DOM_EFFECT_friction].on)
        fputs("Real dominoes rub against each other, and a real row is slower. 'fit' finds how much.\n", out);
    if (random)
        fputs("The times are those of the row without random errors.\n", out);
    fprintf(out, "g = %.5g m/s^2\n", (double)class->row.run.scene.row.g);
}

void sheet_answers(const struct class_row *class, FILE *out)
{
    fputs("# How fast do dominoes fall? The answers\n", out);
    times_write(class, out);
    effects_write(class, out);
}
