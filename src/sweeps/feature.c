/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/command.h"
#include "sweeps/sweeps.h"

/* The list is empty, because the columns depend on the arguments. */
static const struct column sweep_answers[] = {{NULL, NULL, NULL, 0}};

static const struct command sweep_commands[] = {
    {.name = "sweep",
     .synonyms = "loop batch table scan grid",
     .argument =
         {{.name = "GRID", .kind = ARGUMENT_GRID, .parse = sweep_parse_grid},
          {.name = ": ANSWER", .kind = ARGUMENT_COMMAND, .parse = sweep_parse_answers, .bind = sweep_bind}},
     .summary = "the answers of a command over a grid of parameter values",
     .help = "GRID names parameters or effects, each followed by its values. NAME FROM TO N stands for N "
             "values in equal steps, and NAME FROM TO N log for N values with equal ratios. NAME VALUE, "
             "VALUE, ... lists the values. The first parameter changes slowest. ANSWER is a command or an "
             "expression, evaluated at each point, as in 'sweep s 0.1 0.9 9 : count 112 0.9*rmax'. Several "
             "answers, separated by commas, have a column each: 'sweep r 1 2 9 : barrier.margin, fuel, rmax "
             "with q hollow'. Every line of the output begins with the values of the parameters, even if the "
             "answer at a point has several lines. If a point has no answer, csv and json give the reason. "
             "The parameters of the session do not change. Points are computed on all cores, unless 'set "
             "threads' gives another number of threads. The output does not depend on this number.",
     .example = "sweep s 0.1 0.5 3 q hollow, solid : rmax",
     .see = "curve set effects",
     .columns = sweep_answers,
     .sweep.refusal = "name all parameters in one grid, as in 'sweep s 0.1 0.5 3 q hollow, solid : rmax'",
     .rows = true,
     .run = run_sweep},
    {.name = "curve",
     .synonyms = "graph figure table",
     .train = true,
     .argument = {{.name = "FROM", .kind = ARGUMENT_VALUE_OF, .parameter = "s"},
                  {.name = "TO", .kind = ARGUMENT_VALUE_OF, .parameter = "s"},
                  {.name = "N", .kind = ARGUMENT_COUNT, .bind = curve_bind}},
     .summary = "the largest growth at N separations from FROM to TO",
     .example = "set q hollow; curve 0.1 0.9 5",
     .see = "rmax pair best",
     .rows = true,
     .columns = growths_columns,
     .run = run_sweep},
    {.name = "solve",
     .precision = PRECISION_AS_SET,
     A_RANGE_AND_ANSWER("NAME", range_parse_one, answer_parse_value),
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
    {.name = "maximize",
     .synonyms = "optimize optimise maximise maximum best largest highest fastest longest greatest",
     A_RANGE_AND_ANSWER("X", range_parse_two, answer_parse_number),
     .summary = "the values of one or two parameters at which ANSWER is largest",
     .help =
         "'maximize s : duration.speed' finds the gap at which the dominoes fall fastest. X is one or two "
         "parameters, and a range may follow each name: 'maximize s 0.1 0.9, r 1 2 : rmax - r' or "
         "'maximize s from 0.1 to 0.9 : rmax'. ANSWER is a command, or an expression with the names of "
         "commands. The search tries 241 values of the parameter, or 41 times 41 values of two, and follows "
         "each maximum between them. It can miss a maximum that is narrower than one step. Values without an "
         "answer are left out. If ANSWER uses 'count', its row must fall. If the answer stays the same over "
         "a range, as a whole number does, the range is printed. Only reliable digits are printed; the "
         "column 'within' of 'details' says how far a value may be off. The parameters of the session do "
         "not change.",
     .example = "maximize s : duration.speed",
     .see = "minimize solve sweep",
     .sweep.refusal = "it already varies a parameter",
     .rows = true,
     .brief = "",
     .columns = optimum_columns,
     .run = run_maximize},
    {.name = "minimize",
     .synonyms = "optimize optimise minimise minimum best smallest lowest fewest shortest slowest least",
     A_RANGE_AND_ANSWER("X", range_parse_two, answer_parse_number),
     .summary = "the values of one or two parameters at which ANSWER is smallest",
     .help = "'minimize' works like 'maximize', which 'help maximize' describes.",
     .example = "minimize r : count(20 m)",
     .see = "maximize solve sweep",
     .sweep.refusal = "it already varies a parameter",
     .rows = true,
     .brief = "",
     .columns = optimum_columns,
     .run = run_minimize},
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
         "session on standard input goes on. COMMAND is a command with a verdict, such as barrier, or a "
         "condition, as in 'assert rmax(0.4) < 1.7'.",
     .example = "set r 1.6; assert barrier",
     .see = "verdict design barrier count",
     .sweep.refusal = "it is about one scene",
     .access.runs = true,
     .run = run_assert},
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"Any answer over a grid", "sweeps", sweep_commands},
    {NULL, NULL, NULL},
};

const struct feature sweeps_feature = {.name = "sweeps", .groups = groups};
