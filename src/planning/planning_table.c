/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of the commands design, plan, improve, solve, watch, sensitivity, fit and assert. */
#include "commands/tables.h"
#include "fit/fit.h"
#include "planning/plan.h"
#include "planning/planning.h"

const struct command design_commands[] = {
    {.name = "design",
     .argument = {{.name = "H", .kind = ARGUMENT_HEIGHT},
                  {.name = "WISHES",
                   .kind = ARGUMENT_GRID,
                   .optional = true,
                   .parse = design_parse,
                   .bind = wishes_bind,
                   .choices = design_wishes}},
     .summary = "a safe row whose last domino is H tall",
     .help =
         "'design' finds a gap and a growth such that every domino after the first has at least 'safety' "
         "times the energy that it needs. This is true both in the endless train and in the row. The first "
         "domino, friction, slope and push come from the scene.\n\n"
         "WISHES can come in any order. 'safety 2' is "
         "the default. 'hall 20 m' is the greatest length of the row, including its fallen last domino. "
         "'minimise dominoes' is the default. 'minimise mass' finds the same row, because fewer dominoes "
         "also have less mass. 'minimise length' finds the shortest row. 'boards 9, 12, 15 mm' are the "
         "thicknesses to choose from; with 'set walls 12 mm 30 cm', a box can have any thickness. 'grid 1 "
         "mm' makes all gaps, heights and thicknesses multiples of 1 mm, except the first domino, the height "
         "H and the thicknesses of boards. The row still has the required safety.\n\n"
         "'design 8 m falls 99 %' "
         "finds how few dominoes are enough for the row to fall with this probability. It takes the random "
         "errors of the scene into account, such as 'set placement 3 mm'. The lower end of the 95 % "
         "interval must reach this probability. A table shows the results for fewer and for more dominoes; "
         "then the row is improved, as with 'improve sizes'.\n\n"
         "If the rigid-body engine runs rows ('set "
         "feet', 'set bounce', 'set method engine'), the row also falls in the engine. 'safety' still "
         "refers to the model, which treats feet as hinges.\n\n"
         "The row becomes the session's row; 'design ... > "
         "hall.csv' writes a file for 'set row hall.csv'.",
     .example = "set q hollow; set friction 0.3; design 8 m",
     .see = "verdict fall row assert solve",
     .principal = "steps",
     .holds = "a row meets the wishes",
     .access.changes = true,
     .brief = "",
     ANSWER(design)},
    {.name = "plan",
     .synonyms = "guide print sheet cut list boards tape workshop hall build",
     .argument = {{.name = "title TITLE", .kind = ARGUMENT_WORDS, .optional = true, .parse = plan_parse}},
     .summary = "a guide for building the row: sizes, boards, places",
     .help =
         "For the hall, the guide lists the places of the dominoes on a tape measure. For the workshop, it "
         "lists their sizes and the boards to cut. Beside each place, each height and each thickness, it "
         "shows the limits between which all dominoes fall, as 'tolerance' finds them. With errors such as "
         "'set placement 2 mm', the guide shows how likely the row is to fall. 'plan title \"The hall\" > "
         "hall.pdf' draws the guide on A4 pages. It shows the row to scale, beside a person 1.75 m tall. "
         "As .svg or .png, the guide is one long page. csv and json have the numbers, in m.",
     .example = "set row 5; plan",
     .see = "row tolerance placement draw",
     .sweep.refusal = "it is a text",
     .writes = WRITES_PICTURES,
     .rows = true,
     .brief = "",
     ANSWER(plan)},
    {.name = "improve",
     .synonyms = "optimise optimize best robust reliable",
     .argument = {{.name = "WISHES",
                   .kind = ARGUMENT_GRID,
                   .optional = true,
                   .parse = improve_parse,
                   .bind = wishes_bind,
                   .choices = improve_wishes}},
     .summary = "change the row to make it more likely to fall",
     .help =
         "'improve' changes the gaps of the row to make it more likely to fall in spite of the random "
         "errors of the scene. First enter 'set placement 3 mm', or other errors. WISHES can come in any "
         "order. 'sizes' also changes the sizes of all dominoes between the first and the last; their "
         "proportions stay fixed. 'hall 20 m' is the greatest length of the row, including its fallen last "
         "domino; the default is the present length. 'boards 9, 12, 15 mm' are the thicknesses to choose "
         "from; with 'set walls 12 mm 30 cm', a box can have any thickness. 'mass 50 kg' is the greatest "
         "mass that a changed domino may have. 'grid 1 mm' makes all gaps, and the heights and thicknesses "
         "that change, multiples of 1 mm. A domino that becomes twice as large gets 2^(q-1) times the mass. "
         "The search uses random rows; the probabilities before and after the changes come from other "
         "random rows. A row within these limits is never replaced by a worse one. ^C ends the search with "
         "the best row so far. 'undo' reverts the changes. If the rigid-body engine runs rows, the search "
         "still uses the model, and the probabilities come from the engine.",
     .example = "set row 8; set friction 0.2; set r 1.3; set s 0.5; set placement 3 mm; improve",
     .see = "placement budget design change row",
     .principal = "probability",
     .access.changes = true,
     .brief = "",
     ANSWER(improve)},
    {.name = "solve",
     .has_errors = true,
     .argument =
         {{.name = "NAME", .kind = ARGUMENT_GRID, .parse = solve_parse_parameter, .choices = solve_names},
          {.name = ": ANSWER",
           .kind = ARGUMENT_COMMAND,
           .parse = solve_parse_answer,
           .bind = solve_bind,
           .choices = question_names}},
     .summary = "the values of a parameter at which ANSWER has a given value",
     .help = "'solve d : rmax = 5/3' is an example of 'solve NAME : ANSWER = VALUE'. It finds the values of "
             "the parameter NAME at which ANSWER has this VALUE, and whether ANSWER rises or falls there. "
             "ANSWER is a command, or an expression with the names of commands: 'solve s : rmax(s) - "
             "pair(s) = 0.1'. A range may follow the name: 'solve d 0.05 0.3 : rmax = 5/3'. If '= VALUE' is "
             "left out, ANSWER must be a command that 'assert' accepts, and 'solve' finds where its verdict "
             "changes: 'solve friction : verdict'. The search tries 241 values and looks between them; it "
             "can miss a dip that is narrower than one step.",
     .example = "solve d : rmax = 5/3; solve friction : barrier",
     .see = "sensitivity sweep assert",
     .sweep.refusal = "it already varies a parameter",
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
     .summary = "vary a parameter with the arrow keys, and see ANSWER on a curve",
     .help =
         "An example is 'watch s 0.1 0.9 : rmax'. The left and right arrow keys make large steps, and the up "
         "and down keys make small ones. Enter keeps the value; q and ^C leave the parameter as it was.",
     .see = "solve sweep plot",
     .access.changes = true,
     .act = run_watch},
    {.name = "sensitivity",
     .argument = {{.name = "COMMAND",
                   .kind = ARGUMENT_COMMAND,
                   .parse = sensitivity_parse,
                   .choices = question_names}},
     .summary = "how much each parameter changes the answer of COMMAND",
     .help =
         "'sensitivity' decreases and increases each parameter of the model by 1 %. It changes friction and "
         "edges by 0.01 and slope by 1 degree, even if they are off. The answer shows by what percentage "
         "the result of COMMAND changes, with the largest change first. COMMAND may have arguments and a "
         "key, as in 'sensitivity rmax 0.3' and 'sensitivity barrier.margin', or be an expression, as in "
         "'sensitivity h*r^10'.",
     .example = "set friction 0.2; sensitivity rmax",
     .see = "solve sweep",
     .sweep.refusal = "it already varies the parameters",
     .rows = true,
     ANSWER(sensitivity)},
    {.name = "fit",
     .synonyms = "measured camera video tracker regression estimate calibrate",
     .argument = {{.name = "NAME", .kind = ARGUMENT_GRID, .parse = fit_parse, .choices = fit_names},
                  {.name = "FILE", .kind = ARGUMENT_FILE},
                  {.name = "FPS", .kind = ARGUMENT_NUMBER, .optional = true}},
     .summary = "the parameters that explain measurements best",
     .help = "NAME is a parameter or an effect, or up to four of them with commas between them, as in "
             "'friction, push'. FILE is a csv file of one of three kinds. The columns 'domino' and 'time "
             "(s)' (or 'frame') say when each domino of the row is hit, as a camera shows it. The columns "
             "'time (s)' (or 'frame') and 'angle (deg)' say how domino 1 turns; a column 'domino' can name "
             "another domino. In a file with 'gap (mm)' and 'speed (m/s)', each line has the speed of one "
             "row of equal dominoes. FPS is the number of frames per second; a column 'rate' can give this "
             "number instead. A column 'run' numbers several runs, each with its own clock. A column 'gap "
             "(mm)' gives the gap of each run, and a column 'error' gives the standard errors. 'set row' "
             "sets the dominoes; without this effect, their growth is r. Each residual is divided by "
             "its error, and 'fit' finds the values with the smallest sum of squares. It also finds their "
             "standard deviations and correlations. 'plot fit ...' and 'fit ... > fit.svg' (or .png, .pdf) "
             "draw the measurements against the fitted values.",
     .see = "plot solve duration fall sensitivity",
     .access.files = true,
     .rows = true,
     ANSWER(fit),
     .picture = picture_fit},
    {.name = "assert",
     .argument = {{.name = "COMMAND",
                   .kind = ARGUMENT_COMMAND,
                   .noun = "command with a verdict",
                   .parse = assert_parse,
                   .choices = assert_names}},
     .summary = "report an error unless COMMAND answers yes or the comparison is true",
     .help =
         "'assert' runs the command, and reports an error if its verdict is no: for example, if the row does "
         "not fall, or if no row meets the wishes. A script then ends at once with exit status 1; a "
         "session on standard input goes on. COMMAND is verdict, fall, design, barrier, count or prove, "
         "or a condition, as in 'assert rmax(0.4) < 1.7'.",
     .example = "set row 5; assert verdict",
     .see = "verdict design barrier count",
     .sweep.refusal = "it is about one scene",
     .access.runs = true,
     .run = run_assert},
    {.name = NULL},
};
