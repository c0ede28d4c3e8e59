/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of the commands design, solve, watch, sensitivity, fit and assert. */
#include "commands/drawing/plan.h"
#include "commands/fit/fit.h"
#include "commands/planning/planning.h"
#include "commands/tables.h"

const struct command design_commands[] = {
    {.name = "design",
     .argument = {{.name = "H", .kind = ARGUMENT_HEIGHT},
                  {.name = "WISHES",
                   .kind = ARGUMENT_GRID,
                   .optional = true,
                   .parse = design_parse,
                   .bind = wishes_bind,
                   .choices = design_wishes}},
     .summary = "a row whose last domino is H tall, with safety",
     .help = "Finds the gaps and the growth with which each cycle has at least 'safety' times the energy "
             "that it needs, both in the endless train and at each domino of the row after the first. The "
             "first domino, its h, d and q, friction, slope and push are those of the scene. WISHES are "
             "'safety 2' (if left out), 'hall 20 m', the most that the row with its last domino fallen may "
             "measure, and 'minimise dominoes' (if left out), 'minimise length' or 'minimise mass', in any "
             "order. The fewest dominoes weigh least. If the rigid-body engine runs rows ('effect feet', "
             "'effect bounce', 'set method engine'), all dominoes of the row also fall in the engine, while "
             "'safety' is that of the model, in which feet are hinges. The row becomes the session's; "
             "'design ... > hall.csv' writes it, for 'effect row hall.csv'.",
     .example = "set q hollow; effect friction 0.3; design 8 m",
     .see = "verdict fall row assert solve",
     .principal = "steps",
     .holds = "a row fits the wishes",
     .changes = true,
     ANSWER(design)},
    {.name = "plan",
     .synonyms = "guide print sheet cut list boards tape workshop hall build",
     .argument = {{.name = "TITLE", .kind = ARGUMENT_WORDS, .optional = true, .parse = plan_parse}},
     .summary = "a guide for building the row: sizes, boards, places",
     .help =
         "For the hall, the places of the dominoes on a tape; for the workshop, their sizes and the boards "
         "to "
         "cut; each with the values between which all fall, as 'tolerance' finds them. If errors are on, "
         "such "
         "as 'effect placement 2 mm', the guide says how likely the row falls. 'plan title \"The hall\" > "
         "hall.pdf' draws it on pages of A4, with the row to scale and a person of 1.75 m beside it; .svg "
         "and "
         ".png are one long page. csv and json have the numbers, in m.",
     .example = "effect row 5; plan",
     .see = "row tolerance placement draw",
     .unswept = "it is a text",
     .writes = WRITES_PICTURES,
     .rows = true,
     ANSWER(plan)},
    {.name = "improve",
     .synonyms = "optimise optimize best robust reliable",
     .argument = {{.name = "WISHES",
                   .kind = ARGUMENT_GRID,
                   .optional = true,
                   .parse = improve_parse,
                   .bind = wishes_bind,
                   .choices = improve_wishes}},
     .summary = "change the row so that it most likely falls",
     .help =
         "Changes the gaps of the row so that it most likely falls under the random errors of the scene: "
         "first "
         "enter 'effect placement 3 mm', or other errors. WISHES, in any order, are: 'sizes' to change the "
         "sizes of all dominoes but the first and the last, too, in their proportions; 'hall 20 m', the most "
         "that the row with its last domino fallen may measure (as long as it is now, if left out); 'boards "
         "9, "
         "12, 15 mm', the thicknesses to choose from; 'mass 50 kg', the most that a domino may weigh; and "
         "'grid 1 mm' for measures in whole mm. A domino that becomes twice as large gets 2^(q-1) times the "
         "mass. The search uses random rows, and other rows show the probability before and after. A row is "
         "never replaced by a worse one. ^C ends the search with the best row so far. 'undo' takes the "
         "changes back. If the rigid-body engine runs rows, the search runs the model, and the engine runs "
         "the rows that show the probability.",
     .example = "effect row 8; effect friction 0.2; set r 1.3; set s 0.5; effect placement 3 mm; improve",
     .see = "placement budget design change row",
     .principal = "probability",
     .changes = true,
     ANSWER(improve)},
    {.name = "solve",
     .argument =
         {{.name = "NAME", .kind = ARGUMENT_GRID, .parse = solve_parse_parameter, .choices = solve_names},
          {.name = ": ANSWER",
           .kind = ARGUMENT_COMMAND,
           .parse = solve_parse_answer,
           .bind = solve_bind,
           .choices = question_names}},
     .summary = "where an answer takes a value, along a parameter",
     .help =
         "The form is 'solve NAME : ANSWER = VALUE', as in 'solve d : rmax = 5/3'. Finds the values of the "
         "parameter NAME at which ANSWER has this VALUE, and whether ANSWER rises or falls there. ANSWER is "
         "a command, or an expression with commands as names: 'solve s : rmax(s) - pair(s) = 0.1'. A range "
         "may follow the name: 'solve d 0.05 0.3 : rmax = 5/3'. Without '= VALUE', and with a command that "
         "'assert' takes, 'solve' finds where its verdict changes: 'solve friction : verdict'. The search "
         "tries 241 values and looks between them; it can miss a dip that is narrower than their distance.",
     .example = "solve d : rmax = 5/3; solve friction : barrier",
     .see = "sensitivity sweep assert",
     .unswept = "it varies a parameter itself",
     .rows = true,
     ANSWER(solve)},
    {.name = "watch",
     .synonyms = "interactive slider live keys explore",
     .argument =
         {{.name = "NAME", .kind = ARGUMENT_GRID, .parse = solve_parse_parameter, .choices = solve_names},
          {.name = ": ANSWER",
           .kind = ARGUMENT_COMMAND,
           .parse = watch_parse_answer,
           .bind = solve_bind,
           .choices = question_names}},
     .summary = "keys change a parameter; its answer follows on a curve",
     .help = "For example 'watch s 0.1 0.9 : rmax'. The left and right arrows take large steps, up and down "
             "small ones. Enter keeps the value; q and ^C leave the parameter as it was.",
     .see = "solve sweep plot",
     .changes = true,
     .act = run_watch},
    {.name = "sensitivity",
     .argument = {{.name = "COMMAND",
                   .kind = ARGUMENT_COMMAND,
                   .parse = sensitivity_parse,
                   .choices = question_names}},
     .summary = "how much each parameter changes the number of COMMAND",
     .help = "Makes each parameter of the model smaller and larger by 1 %, or by 0.01 for friction and 1 "
             "degree for slope, even if these are off. Answers with the change of the number in percent, the "
             "largest first. COMMAND may have arguments and a key, 'sensitivity rmax 0.3', 'sensitivity "
             "barrier.margin', or be an expression, 'sensitivity h*r^10'.",
     .example = "effect friction 0.2; sensitivity rmax",
     .see = "solve sweep",
     .unswept = "it varies the parameters itself",
     .rows = true,
     ANSWER(sensitivity)},
    {.name = "fit",
     .synonyms = "measured camera video tracker regression estimate calibrate",
     .argument = {{.name = "NAME", .kind = ARGUMENT_GRID, .parse = fit_parse, .choices = fit_names},
                  {.name = "FILE", .kind = ARGUMENT_FILE},
                  {.name = "FPS", .kind = ARGUMENT_NUMBER, .optional = true}},
     .summary = "the parameters that explain measurements best",
     .help = "NAME is a parameter or an effect, or up to four of them with commas between them, as in "
             "'friction, push'. FILE is csv, of one of three kinds. With the columns 'domino' and "
             "'time (s)' or 'frame' it says when each domino of the row is hit, as a camera shows it. "
             "With 'time (s)' or 'frame', 'angle (deg)' and, unless it is the first, 'domino' it says "
             "how a domino turns. With 'gap (mm)' and 'speed (m/s)' each line is the speed of one row "
             "of equal dominoes. FPS is the number of frames in a second, unless a column 'rate' has "
             "it. A column 'run' numbers several runs, each with its own clock; a column 'gap (mm)' "
             "gives the gap of each run; a column 'error' gives standard errors. The dominoes are "
             "those of 'effect row', or else all have the growth r. Finds the values with the least "
             "sum of squared residuals, each divided by its error, and their standard deviations and "
             "correlations. 'plot fit ...' draws what was measured against what the best values give, as "
             "does 'fit ... > fit.svg' (or .png, .pdf).",
     .see = "plot solve duration fall sensitivity",
     .files = true,
     .rows = true,
     ANSWER(fit),
     .picture = picture_fit},
    {.name = "assert",
     .argument = {{.name = "COMMAND",
                   .kind = ARGUMENT_COMMAND,
                   .of = "command with a verdict",
                   .parse = assert_parse,
                   .choices = assert_names}},
     .summary = "an error unless the verdict of COMMAND is true",
     .help = "Runs the command, and gives an error if its answer is no: the row does not fall, or no row "
             "meets the wishes. A script then ends at once with exit status 1; standard input goes on. "
             "COMMAND is verdict, fall, design, barrier, count or prove; or it is a condition, as in 'assert "
             "rmax(0.4) < 1.7'.",
     .example = "effect row 5; assert verdict",
     .see = "verdict design barrier count",
     .unswept = "it is about one scene",
     .runs = true,
     .run = run_assert},
    {.name = NULL},
};
