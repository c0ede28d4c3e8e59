/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands design, plan and improve. */
#include "interpreter/command.h"
#include "planning/planning.h"

static const struct command design_commands[] = {
    {.name = "design",
     .precision = PRECISION_DOUBLE,
     .argument = {{.name = "H", .kind = ARGUMENT_HEIGHT},
                  {.name = "WISHES",
                   .kind = ARGUMENT_GRID,
                   .optional = true,
                   .parse = wishes_parse,
                   .bind = wishes_bind,
                   .choices = design_wishes}},
     .summary = "a safe row whose last domino is H tall",
     .help =
         "'design' finds a gap and a growth such that every domino after the first has at least 'safety' "
         "times the energy that it needs. This is true both in the endless train and in the row. The first "
         "domino, friction, slope and push come from the scene.\n\n"
         "WISHES can come in any order. 'safety 2' is the default. 'hall 20 m' is the greatest length "
         "of the row, including its fallen last domino. The row has as few dominoes as possible. "
         "'boards 9, 12, 15 mm' are the thicknesses to choose from; with 'set walls 12 mm 30 cm', a box "
         "can have any thickness. 'grid 1 mm' makes all gaps, heights and thicknesses multiples of 1 "
         "mm, except the first domino, the height H and the thicknesses of boards. The row still has "
         "the required safety. 'falls 99 %' adds dominoes until random rows with the errors of the "
         "scene fall with this probability; the lower end of its 95 % interval counts. 'improve sizes' "
         "then makes the row more likely to fall.\n\n"
         "The row becomes the session's row; 'design ... > "
         "hall.csv' writes a file for 'set row hall.csv'.",
     .example = "set q hollow; set friction 0.3; design 8 m",
     .see = "placement improve plan verdict row",
     .principal = "steps",
     .holds = "a row meets the wishes",
     .access.changes = true,
     .brief = "",
     ANSWER(design)},
    {.name = "plan",
     .precision = PRECISION_DOUBLE,
     .synonyms = "guide print sheet cut list boards tape workshop hall build",
     .argument = {{.name = "title TITLE", .kind = ARGUMENT_WORDS, .optional = true, .parse = plan_parse}},
     .summary = "a guide for building the row: sizes, boards, places",
     .help =
         "For the hall, the guide lists the places of the dominoes on a tape measure. For the workshop, it "
         "lists their sizes and the boards to cut. Beside each place, each height and each thickness, it "
         "shows the limits between which all dominoes fall, as 'tolerance' finds them. With errors such as "
         "'set placement 2 mm', the guide shows how likely the row is to fall. 'plan title \"The hall\" > "
         "hall.pdf' draws the guide on A4 pages. It shows the row to scale. "
         "As .svg or .png, the guide is one long page. csv and json have the numbers, in m.",
     .example = "set row 5; plan",
     .see = "row tolerance placement draw",
     .sweep.refusal = "it is a text",
     .writes = WRITES_PICTURES,
     .rows = true,
     .brief = "",
     ANSWER(plan)},
    {.name = "improve",
     .precision = PRECISION_DOUBLE,
     .synonyms = "optimise optimize best robust reliable",
     .argument = {{.name = "WISHES",
                   .kind = ARGUMENT_GRID,
                   .optional = true,
                   .parse = wishes_parse,
                   .bind = wishes_bind,
                   .choices = improve_wishes}},
     .summary = "change the row to make it more likely to fall",
     .help =
         "'improve' changes the gaps of the row to make it more likely to fall in spite of the random "
         "errors of the scene. First enter 'set placement 3 mm', or other errors. WISHES can come in any "
         "order. 'sizes' also changes the sizes of all dominoes between the first and the last; their "
         "proportions stay fixed. 'hall 20 m' is the greatest length of the row, including its fallen last "
         "domino; the default is the present length. 'boards 9, 12, 15 mm' are the thicknesses to choose "
         "from; with 'set walls 12 mm 30 cm', a box can have any thickness. "
         "'grid 1 mm' makes all gaps, and the heights and thicknesses "
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
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"Planning a row", "planning", design_commands},
    {NULL, NULL, NULL},
};

const struct feature planning_feature = {.name = "planning", .groups = groups};
