#include "src/cli/help_pages.hpp"

namespace rubicon::cli::pages {

const std::string_view kOverviewBegin =
    R"(rubicon - can these machines build this, how long does it take, where does it fail?

usage: rubicon COMMAND ...

)";

const std::string_view kOverviewEnd = R"(
  --version                      print the version

Files: NAME.robot describes a machine, NAME.motion its behaviour, NAME.plan what is to be built,
NAME.study what is tried with a plan.
Exit codes: 0 fine; 1 the plan cannot be done as a whole, a test failed or a result has faults; 2 the input or the call
is wrong; 3 an internal fault.

try: rubicon run taskplans/unit.plan
)";

const std::string_view kCheck =
    R"(rubicon check - find every mistake in robots, behaviours and plans

usage: rubicon check [--robot FILE] [--set NAME=VALUE]... [--format text|json] FILE...

Reads each FILE (.robot, .motion, .plan or .study) and reports all its mistakes in one run: where, what was expected, what was
found, what to do. A plan checks its robots, a robot its behaviours. A behaviour on its own gets only the checks that
need no robot; name one with --robot and it gets them all. Of a plan it also says what is in each other at the beginning.

  --robot FILE     the robot that the .motion files are for
  --set NAME=VALUE another value for a parameter of the plan: --set bays=6 --set "pitch=4.2 m"
  --format text    file:line:column: level: message, with the line and a caret, on standard error (the default)
  --format json    an array for editors, on standard output: one object a file, its diagnostics in the shape of the
                   Language Server Protocol

Exit code: 0 no errors (warnings and notes may be printed), 2 errors.

examples:
  rubicon check taskplans/unit.plan
  rubicon check --robot robots/tower_crane/tower_crane.robot lift.motion
  rubicon check --format json robots/*/*.robot
)";

const std::string_view kRun =
    R"(rubicon run - simulate a plan

usage: rubicon run PLAN [--format table|json|csv] [--trace FILE] [--trace-detail full|steps|tasks|none]
                        [--out DIR [--compress]] [--set NAME=VALUE]... [--sample SEED[:RUN]]

Checks the plan, then simulates it: tasks start when their links, robots, crews and shifts allow, several machines move in
one timeline, and every motion step is tested over the whole volume it sweeps, with the load, also against what other
machines sweep at the time. Prints a table of the tasks (robot, crew, start, duration, of it motion and crew work, time
waited, steps tried and accepted, result), the process time, the use and cost of robots and crews, and the critical
chain. A task that cannot be done is rejected with the reason and undone; what depends on it is reported as not
reached; the rest goes on. A plan with a network of cells (policy grid) has no tasks: its agents get their ways, and the sum of
their ticks, its ratio to the bound that no ways can be below, and the last tick are printed; or, if the network has jobs, how many
they deliver in an hour, how long a job takes, and what they wait. Nor has one with policy charts: the
chart of each robot is printed, when it is at which node, and again after each report; nor one with policy tarry or fraenkel: the
walk of each robot that explores the network is printed.

  --format FORMAT        table (the default), json or csv, on standard output; times in seconds
  --trace FILE           write what happened, one JSON object a line (docs/trace.md); - is standard output; packed if the name
                         ends in .gz
  --trace-detail DETAIL  steps (the default: everything that happened), full (what guides searched through as well, and
                         where robots may not stand there: the page shows it), tasks (no single attempts), none (header and
                         results only)
  --out DIR              write schedule.csv, schedule.json, trace.jsonl and report.html, the page that shows it all, into DIR; of a
                         network of cells ways.json and ways.csv, of one with jobs jobs.json, jobs.csv and agents.csv, of charts
                         charts.json, charts.csv, charts.svg and report.html, of an exploration walk.json and walk.csv
  --compress             write trace.jsonl.gz there, packed to a tenth or less; every command reads it as it is
  --set NAME=VALUE       another value for a parameter of the plan: --set bays=6 --set "pitch=4.2 m"; the trace keeps it
  --sample SEED[:RUN]    draw the durations that are not certain, such as triangular(2 min, 3 min, 7 min), instead of taking
                         their means, the days that the weather takes, and when machines break down; the same seed and run
                         (a whole number, 0 if it is left out) draw the same

Files appear whole or not at all, and the files of --out all at once: a stop at any moment leaves the old result or the
new one. What an older result left in DIR goes, whatever kind of result it was; all other files stay. Where one of them has
the name of a file of the new result, the command says so and runs nothing. Paths in what is written are relative to the
folder of the plan.
What the command does not execute is refused at its place before anything runs.

Exit code: 0 every task was done (a short plan: its motion is at its goal; cells: all have ways; charts: all
robots come to their goals), 1 otherwise, 2 the input is wrong.

examples:
  rubicon run taskplans/unit.plan
  rubicon run taskplans/unit.plan --format csv > unit.csv
  rubicon run site.plan --trace trace.jsonl
)";

const std::string_view kStudy =
    R"(rubicon study - run many variants of a plan and compare their time, cost and risk

usage: rubicon study STUDY [--out DIR [--resume] [--films]] [--jobs N] [--format table|json|csv]

Runs the plan of a study (NAME.study, docs/studies.md) with every combination of the values that it varies, each as often
as it says, with the durations drawn that are not certain. Run number 7 of each variant has the same draws, so that
variants are compared draw by draw. Prints what the study asks for: means and quantiles, the tasks that are critical, the
durations that drive the time, what was rejected and how often, and the variant that its rule chooses. A run in which
anything is rejected never finishes: it counts in quantiles, and a variant with such runs is not chosen unless the rule
allows it.

  --out DIR        write study.json, variants.csv, runs.csv, drivers.csv, progress.csv and study.html, the page that shows it
                   all, into DIR; what an older result left there goes, all other files stay (see rubicon help run)
  --films          run again what is worth looking at, each into DIR/films/..., and link study.html to the animations: of the variant
                   that is chosen the runs at the quantiles of the process time, of the others of the Pareto front that at the median
  --resume         go on where a study that was stopped had come to; its runs are kept in DIR/study.progress
  --jobs N         threads; by default as many as there are processors; the result is the same
  --format FORMAT  table (the default), json or csv (a row a variant), on standard output; times in seconds

Any single run can be made again: rubicon run PLAN --set NAME=VALUE --sample SEED:RUN.

Started by MPI (mpirun -n 8 rubicon study STUDY) the ranks share the runs, each with one thread unless --jobs says more;
the result is the same. Rank 0 alone writes and prints.

Exit code: 0 the study was made, and its rule, if it has one, chose a variant; 1 it chose none, or no variant can run;
2 the input is wrong.

examples:
  rubicon study taskplans/studies/crews.study
  rubicon study taskplans/studies/crews.study --out crews --jobs 4
)";

const std::string_view kWhy =
    R"(rubicon why - say why a task failed, took long or came late

usage: rubicon why PLAN|RESULT|TRACE TASK [--advise] [--format text|json] [--set NAME=VALUE]...

For a rejected task: what blocked it first, at which step and by which line of the script, where the robot stood, and
what the script tried instead and how each try ended. For any task: what it waited for on its way, and the chain of
waits back to the beginning of the plan that made it begin when it did. RESULT is the folder of rubicon run --out:
nothing is simulated again. A PLAN is run first.

  --advise         of a PLAN also what would help: another order of two tasks where something was in the way or a robot
                   or crew was waited for, a start when others have gone, another robot, a waypoint above the goal. At
                   most 12 changes are tried, each by running the changed plan; what was not tried is named
  --format FORMAT  text (the default) or json, on standard output; times in seconds
  --set NAME=VALUE another value for a parameter of the PLAN

Exit code: 0 the story is printed, 2 there is no such task or the input is wrong.

examples:
  rubicon why taskplans/unit.plan set_west_1
  rubicon run site.plan --out result; rubicon why result set_7
  rubicon why result set_7 --format json
  rubicon why site.plan set_7 --advise
)";

const std::string_view kGuides =
    R"(rubicon guides - compare all kinds of guides on the motions of one task

usage: rubicon guides PLAN [TASK] [--seeds N] [--ompl NAME,...] [--format table|csv|json] [--set NAME=VALUE]...
       rubicon guides PLAN [TASK] --exact [--dt S] [--format table|csv|json] [--set NAME=VALUE]...
       rubicon guides PLAN [TASK] --svg FILE [--kind KIND] [--axes P,Q[,R]] [--at VALUE] [--set NAME=VALUE]...
       rubicon guides PLAN [TASK] --page FILE --axes P,Q,R [--kind KIND] [--set NAME=VALUE]...
       rubicon guides PLAN [TASK] --chart FILE [--kind KIND] [--set NAME=VALUE]...

Runs the plan up to the task. Where a motion of it begins, each kind of guide plans a way to its first goal, once for
each seed from 1 to N, on the site as it stands then; nothing is moved by that. A guide that the task names stands for its
kind, with its clauses. Planners of OMPL are there if the task names them, or --ompl does. TASK may be left out where only
one task moves; of a short plan it is the plan's name.

The table has, of all tries, how many found a way, and the medians of nodes, checks (legs and configurations tested) and
milliseconds, these also as 95th percentile; of the ways found the medians of roughness, length and motion time
(docs/guides.md).

Of a task that covers an area it reports what its way over the area does: how much of it is covered, the length beside its
lower bound, turns, metres inside holes and outside (docs/coverage.md). Nothing is run. Where guides lead from strip to
strip their comparison follows in the table.

  --exact          instead, travel without a map (docs/travel.md): from where the machine starts to the x and y that the
                   task goes to, by Bug1, Bug2, VisBug-21, Pledge, Simple, Tangent and ACE, in the plan view of the site
                   as it is at the beginning; the machine is the disc that holds it however it is turned. What moves
                   keeps its timetable, whatever is in its way
  --dt S           in slices of so many seconds, 0.25 if not given
  --svg FILE       instead, draws the configurations that two parameters span where the first motion of the task begins:
                   where the robot may not stand, what was tried, the way; of potential its field and the minima in it.
                   Of a task that covers an area, without --kind and --axes, each step of the method that found its way,
                   beside the table. - is standard output, with nothing else on it
  --chart FILE     instead, draws the parameters of the robot over time on that way: as they are driven, and as each would
                   be by itself at its full speed
  --kind KIND      of which kind of guide, as rrt_connect or "ompl RRTConnect"; the first that the task names if not given
  --axes P,Q       of which two parameters; the first two that the guide searches if not given. The others stand in the
                   picture as they do when the motion begins
  --at VALUE       of a third parameter in --axes its value in the picture, m or degrees
  --page FILE      instead, the same with a slider for the third parameter in --axes, as one HTML file: what is forbidden
                   at each of 25 or so values of its range, and a ring where the way has that value
  --seeds N        tries of each kind, 10 if not given
  --ompl NAME,...  these planners of OMPL too, by their names there: --ompl RRTConnect,BITstar
  --format FORMAT  table (the default), csv or json (each try by itself), on standard output
  --set NAME=VALUE another value for a parameter of the PLAN

Exit code: 0, also where no way was found; 2 the plan has no such task, or the motion never begins.

examples:
  rubicon guides examples/13_guides/site.plan reach --seeds 50
  rubicon guides taskplans/unit.plan set_west_1 --format csv
  rubicon guides taskplans/pour.plan pour --svg build/pour.svg
  rubicon guides examples/13_guides/site.plan reach --svg build/reach.svg --kind potential
  rubicon guides taskplans/trench.plan to_truck_1 --page build/joints.html --axes boom.phi,stick.phi,theta
)";

const std::string_view kFlow =
    R"(rubicon flow - report what became of the components, and the stock of storage places

usage: rubicon flow PLAN|RESULT|TRACE [--format table|csv|json] [--set NAME=VALUE]...

Of each component: the storage place where it stands at first and at the end, how often it was lifted, how long it
lay before that (waited), how long and how far it hung on a machine (the way of the middle of the box round it), and
how many steps with it were refused. Of each storage place (storage yard box(...); in the plan): what came and went,
the greatest stock and when, and how long components lay there. Of each vehicle of a fleet: how long it was held, moved
and waited for other machines, and how far it came; and of each node of its network how often, how long and how many at
a time waited there. What happened counts; rejected tasks do not.

  --format FORMAT  table (the default); csv, a line for each component; json, with the stock over time
  --set NAME=VALUE another value for a parameter of the PLAN

Times in the table are hours, minutes and seconds, in CSV and JSON seconds; distances are metres. The result needs a
trace of every step.

Exit code: 0; 2 the input cannot be read, or has no trace of every step.

examples:
  rubicon flow taskplans/unit.plan
  rubicon flow result --format json
)";

const std::string_view kLayout =
    R"(rubicon layout - lay rows and lanes out in a hall, the best of many ways

usage: rubicon layout PLAN --module "LENGTH x DEPTH [x HEIGHT]" [--spacing LENGTH] [--format table|csv|json]
       rubicon layout PLAN --module SIZE --out FILE [--choose N] [--spacing LENGTH] [--format table|csv|json]

PLAN describes a hall: one area (its outline; columns and shafts are in the way), and one network with the gates as nodes
and no lanes. The first class of the network is for aisles, the second, if there is one, for cross aisles and gates; their
width is that of a lane. Modules (racks, stacks) stand in rows back to back, an aisle beside each row. Tried are rows along
x and along y; aisles with a lane one way, with a shared lane and with two lanes; none, one and two cross aisles beside
those at the walls; and many places for the first aisle. All of it is the same on every machine.

The table has each layout that no other beats in all of three: modules that every gate reaches, the mean trip (from a gate to a
module and from there to a gate, each pair as often), and the trips in an hour that the busiest node lets through (time to
load not counted). One is left out that is hardly another choice: the table has one with as many modules or more that is at most
0.5 % worse in both others. Beside them, how it is laid out, and the metres of its lanes. The most modules stand first.

  --module SIZE    a module: along its aisle, across it, and its height (2 m if not given)
  --spacing LENGTH from node to node in an aisle at least; the width of the widest lane if not given. Not less than a vehicle is long
  --out FILE       write the plan with the layout in it: nodes and lanes in its network, each module a shape of the site,
                   and, if the plan has a fleet and no tasks, up to 20 trips from the gates to modules
  --choose N       which layout of the table; 1 if not given
  --format FORMAT  table (the default), csv or json (with places of modules, nodes and lanes), on standard output

Exit code: 0; 1 no layout fits; 2 the plan cannot be read, or has no such area and network.

examples:
  rubicon layout taskplans/hall.plan --module "2.7 m x 1.1 m"
  rubicon layout taskplans/hall.plan --module "2.7 m x 1.1 m x 2 m" --choose 2 --out build/hall.plan
)";

const std::string_view kReport =
    R"(rubicon report - make the page that shows a result

usage: rubicon report RESULT [--out FILE]

RESULT is the folder that rubicon run --out wrote, or a trace. Makes one HTML file that a browser opens without network:
the site in three dimensions with everything that moved, step by step if the trace has the steps, the Gantt chart, the
tables, and why something failed. Nothing is simulated again. rubicon run --out makes the same page.

  --out FILE   the page to write (default: report.html in the folder); - is standard output; a trace alone needs it

Prints the path of the page. Exit code: 0 it is written, 2 the result cannot be read, or this build has no page.

examples:
  rubicon run taskplans/unit.plan --out unit; rubicon report unit
  rubicon run site.plan --trace trace.jsonl; rubicon report trace.jsonl --out site.html
)";

const std::string_view kDebug =
    R"(rubicon debug - step through the behaviour of machines, forward and back

usage: rubicon debug PLAN|RESULT|TRACE [TASK] [-x COMMANDS]... [--batch] [--set NAME=VALUE]...

Shows a behaviour at work: the line of the script, what it tried and how that ended (accepted, or refused by what), its
loops, variables and configuration, the motion, the load and the time; one step after the other, forward and back, with
breakpoints at lines, at refusals and at what meets what. RESULT is the folder of rubicon run --out: nothing is simulated
again. A PLAN is run first. Without TASK all tasks follow one another in the order in which they begin.

Commands are read from standard input; 'help' lists them all, docs/debug.md shows them at work. Where the input is no
terminal each command is shown before its answer.

  -x, --command COMMANDS  do these first; ';' separates them
  --batch                 end after them
  --set NAME=VALUE        another value for a parameter of the PLAN

Exit code: 0 fine, 2 there is no such task, the trace has no steps or the input is wrong.

examples:
  rubicon debug taskplans/two_cranes.plan set_wall_4
  rubicon run site.plan --out result; rubicon debug result set_7
  rubicon debug result set_7 --command "break hit; continue; where; print" --batch
)";

const std::string_view kTest =
    R"(rubicon test - run golden cases and compare them with what is expected

usage: rubicon test DIR... [--filter TEXT] [--update] [--jobs N] [--junit FILE]

A case is a folder with site.plan and expected.json; DIR is a case or a folder of cases (at any depth). Each plan is run
and what happened is compared with expected.json: every attempt (accepted or not, and the configuration to 1e-6), loops,
assignments, choices, the end and its counts. A difference is shown with the lines round it; of tasks, times and costs in a
line for each task.

  --filter TEXT    only cases whose path contains TEXT
  --update         write expected.json and expected.trace (for people) from what happened, instead of comparing
  --jobs N         how many cases run at once (default: as many as there are processors); the output is the same
  --junit FILE     write the results as JUnit XML

Exit code: 0 all cases agree, 1 a case differs, 2 there is no case or a file is wrong.

examples:
  rubicon test tests/language
  rubicon test examples --filter crane
  rubicon test my_cases/new_case --update
)";

const std::string_view kVerify =
    R"(rubicon verify - replay a result by other means and look for contact, gaps and broken links

usage: rubicon verify RESULT [--format text|json]

RESULT is the folder that rubicon run --out wrote, or a trace of a run with all its steps. The result is replayed by a
second, simpler and slower method, which shares nothing with the one that made it: whether the clock has gaps, whether
each step is one that the robot's rules allow, whether anything meets anything at any moment, where loads are taken and put
down, whether a robot or crew is in two places at once, shifts, links, whether the schedules agree, and whether
report.html was made of them. The ways of a network of cells (ways.json, or what rubicon run --format json printed of it) are
walked tick by tick: walls, starts, goals, two in one cell, two through each other, and the sums; of jobs (jobs.json) also who
takes which, where each is picked up and delivered, and who is late. Charts (charts.json) are worked
out again from lengths and speeds: ways, conflicts at nodes, head-on meetings, closed lanes; walks (walk.json) are walked. What is
checked, how and how exactly: docs/verify.md.

  --format text    one line if all is well, else one line a fault, at most 50: file:line: task, time: what (the default)
  --format json    one object with all faults

Exit code: 0 no fault, 1 faults, 2 the result cannot be read.

examples:
  rubicon run taskplans/unit.plan --out unit && rubicon verify unit
  rubicon run site.plan --trace trace.jsonl && rubicon verify trace.jsonl --format json
)";

const std::string_view kFmt = R"(rubicon fmt - write files in the one canonical form

usage: rubicon fmt [--check] FILE...
       rubicon fmt [--kind motion|robot|plan|study] -

Rewrites .robot, .motion and .plan files in place: indentation, spaces, line breaks. Comments stay. A file with errors
is left alone and its errors are printed. Writing it twice changes nothing. Links, modes and owners stay as they are.

  --check        change nothing; name the files that would change and exit with 1
  -              read standard input, write standard output
  --kind KIND    what standard input is (default: motion)

Exit code: 0 fine, 1 --check found a file that would change, 2 a file has errors.

examples:
  rubicon fmt robots/tower_crane/*.robot
  rubicon fmt --check taskplans/*.plan
  rubicon fmt - < lift.motion
)";

const std::string_view kImport =
    R"(rubicon import - make a plan of a schedule, of a building model, or of both; floors of a model or a drawing; a robot file of a URDF; or a plan of a map of cells

usage: rubicon import SCHEDULE [--level] [--baseline] [--out PLAN]
       rubicon import MODEL... [--schedule SCHEDULE --match FILE [--level] [--baseline]] [--unit mm|cm|m] [--up y|z] [--out PLAN]
       rubicon import MODEL.ifc... --area STOREY [--tolerance LENGTH] [--out PLAN]
       rubicon import DRAWING.dxf [--area] [--layer PART=NAME]... [--unit mm|cm|m] [--tolerance LENGTH] [--height LENGTH] [--out PLAN]
       rubicon import MACHINE.urdf|MACHINE.xacro [--package NAME=FOLDER]... [--arg NAME=VALUE]... [--tool LINK] [--out ROBOT]
       rubicon import FILE.map [FILE.scen] [--out PLAN]

SCHEDULE is Microsoft Project XML (in Project: save as XML) or a Primavera XER file; its content decides which. Tasks become
crew work (takes), milestones take no time, resources become crews, links keep their type and lag, calendars their week
and days off; headings become remarks. What a plan has no word for is carried along in its import block, for the way back
with rubicon export. What was not understood, and where the plan goes by less than the schedule says, is listed as
warnings: docs/commands/import.md says what each means.

MODEL is an IFC file (2x3, 4 or 4.3), glTF, Collada, OBJ, STL or PLY, in the folder of the plan or below. Every element
becomes a component that stands where the model has it. With a schedule and a match file, which says what belongs to
which task and who lifts it, the elements wait in a stock area and the tasks put them into place; elements and tasks
without partner are listed. Beside PLAN a table PLAN_elements.csv says what became of each element:
docs/import_building.md.

With --area the plan holds the floor instead, as an area: of the slabs of a STOREY ("01*" will do) of IFC models, with their
openings, the columns and walls that stand through it, and the beams below; or of a DRAWING, an ASCII DXF file whose lines stand
on layers called outline, shafts, columns and beams. Lines that miss each other by no more than the tolerance are joined; where
others do not close, the error names the place and the line of the file: docs/import_area.md.

MACHINE is a robot description (URDF), or a xacro file that makes one. Links become bodies, joints their parameters with
limits and speeds; a mimic joint becomes a derived parameter. The shapes are those of <collision>, else of <visual>; meshes
are copied into the folder ROBOT_meshes beside the robot file. What was assumed, mended or not taken over is listed. No file is
read outside of the folder of MACHINE and of its packages: docs/machines_from_urdf.md.

FILE.map is a map of the MovingAI benchmarks, FILE.scen one of its scenarios. The plan has a network with policy grid: agents
that are points move from cell to cell, one a tick. The files stay where they are, and the plan names them from its folder:
docs/fleets.md.

  --out FILE           write the plan or the robot there instead of standard output
  --schedule SCHEDULE  the schedule whose tasks put the model up
  --match FILE         what of the model belongs to which task
  --level              tasks wait until enough of their resources are free; without, links and calendars alone decide,
                       as in Project and Primavera; how many tasks wait, and how long at most, is said
  --baseline           tasks say when the schedule has them (baseline) and their deadlines (due); a run is then compared with that
  --unit UNIT          mm, cm or m: what the numbers of OBJ, STL and PLY files are, and of a drawing that does not say it
  --up AXIS            y or z: which axis of the model points up, where it does not say so rightly
  --area STOREY        the floor of this storey as an area; of a drawing --area alone
  --layer PART=NAME    which layer has the outline, shafts, columns or beams; * and ? stand for letters
  --tolerance LENGTH   gaps that are closed: 5 mm in a drawing, 20 mm between slabs
  --height LENGTH      of the floor of a drawing: 0 m
  --package NAME=FOLDER  where package://NAME/... of a machine lies; without, the nearest folder above MACHINE that has the file
  --arg NAME=VALUE     an argument of the xacro file
  --tool LINK          the link whose frame is the tool; without, the last of the longest chain

Exit code: 0 there is a plan or robot (warnings may be printed), 2 a file cannot be read or is refused, or the match file is wrong.

examples:
  rubicon import planning.xml --out building.plan
  rubicon import planning.xer --out building.plan && rubicon check building.plan
  rubicon import walls.ifc floors.ifc --out building.plan
  rubicon import walls.ifc floors.ifc --schedule planning.xml --match building.match --out building.plan
  rubicon import floors.ifc columns.ifc --area "01*" --out deck.plan
  rubicon import floor.dxf --area --layer outline=SLAB --height 3m --out deck.plan
  rubicon import excavator.xacro --package excavator_description=.. --arg bucket=wide --out excavator.robot
  rubicon import warehouse.map warehouse.scen --out warehouse.plan && rubicon run warehouse.plan
)";

const std::string_view kExport =
    R"(rubicon export - write a plan or a result for other programs

usage: rubicon export RESULT [--gltf FILE [--speed-up N]] [--svg FILE] [--mspdi FILE] [--csv FILE]
       rubicon export PLAN --mspdi FILE [--set NAME=VALUE]...

RESULT is the folder that rubicon run --out wrote. PLAN is checked and written as it is planned: its tasks, links, crews,
robots and calendars; a plan that came from rubicon import gives back all that was read, also what a plan has no word
for, and what was changed in the plan since then holds. Of a result the schedule has the dates of the run. What a
schedule has no word for (motions, zones, priorities) is listed as warnings.

  --gltf FILE    the site, machines and components with all that happened as one animation, in glTF 2.0: binary if the
                 name ends in .glb, else one text; needs a trace with all steps
  --speed-up N   the animation shows N seconds of the plan in one of its own; without it so many that it lasts a minute,
                 as on the report page, but never fewer than 1: a plan of 20 s takes 20 s
  --svg FILE     a Gantt chart: what each machine and crew did, tasks, the critical path, shifts, what was not done
  --mspdi FILE   the schedule as Microsoft Project XML
  --csv FILE     the table of tasks, as rubicon run --format csv gives it
  --set NAME=VALUE  another value for a parameter of the PLAN

Several files can be written at once; - is standard output, for one of them.

Exit code: 0 the files are written (warnings may be printed), 2 the plan or the result is wrong or a file cannot be
written.

examples:
  rubicon run site.plan --out site && rubicon export site --gltf site.glb --svg site.svg
  rubicon export building.plan --mspdi building.xml
  rubicon import planning.xer --out p.plan && rubicon export p.plan --mspdi planning.xml
)";

const std::string_view kHelp = R"(rubicon help - print a page of help

usage: rubicon help [COMMAND]
       rubicon help functions
       rubicon help --man | --completion bash

  functions            the functions of behaviours, one a line
  --man                the manual page, in roff
  --completion SHELL   a script that lets the shell (bash) complete commands, options and files

examples:
  rubicon help
  rubicon help run
  rubicon help functions
  source <(rubicon help --completion bash)
)";

}  // namespace rubicon::cli::pages
