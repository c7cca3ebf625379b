"""The real command, as users call it: help, exit codes, streams, formats."""

import json
import os
import re
import stat
import subprocess
import tempfile
import unittest

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
COMMANDS = ("check", "run", "test", "verify", "import", "export", "fmt", "why", "report", "debug", "help")

GANTRY = """robot gantry {
  body trolley {
    param x step(1) range(-10, 60);
    param y step(1) range(-30, 30);
    frame trans(x, y, 0);
    shape box(-0.4, -0.4, 0, 0.4, 0.4, 1);
  }
  tool trolley;
  behaviour "b.motion";
}
"""
PLAN = """plan p {
  robot "gantry.robot";
  component wall { shape box(5, -9, 0, 6, 9, 1); }
  start x 0;
  goal x 3;
}
"""


def rubicon(*arguments, cwd=ROOT, **options):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=120, cwd=cwd, **options)


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write("gantry.robot", GANTRY)
        self.write("b.motion", "chain { move_to(x, goal(x)) };\n")
        self.plan = self.write("site.plan", PLAN)

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def read(self, name):
        with open(os.path.join(self.folder, name), encoding="utf-8") as file:
            return file.read()


class Beginning(Case):
    def test_check_and_run_say_what_is_in_each_other_and_how_deep(self):
        plan = self.write("full.plan", """plan p {
  robot g "gantry.robot" { start x 0, y 0; }
  component a { shape box(20, 0, 0, 22, 1, 1); }
  component b { shape box(21.97, 0, 0, 24, 1, 1); }
  component c { shape box(30, 0, 0, 32, 1, 1); }
  component anchor { shape box(31, 0.4, 0.4, 31.1, 0.5, 0.5); fixed to c; }
  touching a c;
  within anchor c;
  task t { by g; go x 3, y 0; }
}
""")
        for command in ("check", "run"):
            result = rubicon(command, plan)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("full.plan:4:13: warning: at the beginning b is 30 mm deep in a\n", result.stderr)
            self.assertIn("touching a b;", result.stderr)
            self.assertIn("full.plan:7:3: warning: the two do not overlap at the beginning\n", result.stderr)
            self.assertEqual(result.stderr.count(": warning: "), 2, result.stderr)
        trace = os.path.join(self.folder, "trace.jsonl")
        self.assertEqual(rubicon("run", plan, "--trace", trace).returncode, 0)
        with open(trace, encoding="utf-8") as file:
            beginning = json.loads(file.readline())["beginning"]
        self.assertEqual([(each["first"], each["second"]) for each in beginning["overlaps"]], [("a", "b")])
        self.assertAlmostEqual(beginning["overlaps"][0]["depth"], 0.03, places=4)
        self.assertEqual(beginning["waived"], [["a", "c"], ["anchor", "c"]])


class Help(Case):
    def test_every_command_has_a_page_with_an_example(self):
        overview = rubicon().stdout
        self.assertEqual(rubicon("help").stdout, overview)
        self.assertEqual(rubicon("--help").stdout, overview)
        for command in COMMANDS:
            page = rubicon("help", command)
            self.assertEqual(page.returncode, 0)
            self.assertEqual(page.stdout, rubicon(command, "--help").stdout)
            self.assertIn("example", page.stdout)
            self.assertIn(f"  {command} ", overview)

    def test_the_docs_carry_the_same_text(self):
        for command in COMMANDS:
            with open(os.path.join(ROOT, "docs", "commands", command + ".md"), encoding="utf-8") as file:
                self.assertIn(rubicon("help", command).stdout, file.read())

    def test_the_manual_page_is_what_the_command_prints(self):
        with open(os.path.join(ROOT, "docs", "man", "rubicon.1"), encoding="utf-8") as file:
            manual = file.read()
        self.assertEqual(rubicon("help", "--man").stdout, manual)
        for command in COMMANDS:
            self.assertIn(f"\n.SS {command}\n", manual)

    def test_pages_and_completion_know_the_same_options(self):
        script = rubicon("help", "--completion", "bash").stdout
        for command in COMMANDS:
            told = set(re.findall(r"^  (?:-\w, )?(--[\w-]+)", rubicon("help", command).stdout, re.M))
            known = set(re.search(rf'^    {command}\) words="(.*)" ;;$', script, re.M).group(1).split())
            self.assertEqual(told | {"--help"}, known, command)

    def test_the_shell_completes(self):
        script = rubicon("help", "--completion", "bash").stdout
        for words, expected in ((["rubicon", "ver"], "verify"), (["rubicon", "run", "--trace-d"], "--trace-detail"),
                                (["rubicon", "help", "ex"], "export"),
                                (["rubicon", "help", "fu"], "functions")):
            call = f'COMP_WORDS=({" ".join(words)}); COMP_CWORD={len(words) - 1}; _rubicon; echo "${{COMPREPLY[*]}}"'
            result = subprocess.run(["bash", "-c", script + call], capture_output=True, text=True, check=True)
            self.assertEqual(result.stdout, expected + "\n")

    def test_the_shell_completes_names_with_spaces(self):
        script = rubicon("help", "--completion", "bash").stdout
        for name in ("my hall.plan", "my *.plan"):
            self.write(name, "")
        call = 'COMP_WORDS=(rubicon run my); COMP_CWORD=2; _rubicon; printf "%s\\n" "${COMPREPLY[@]}"'
        result = subprocess.run(["bash", "-c", script + call], capture_output=True, text=True, check=True, cwd=self.folder)
        self.assertEqual(sorted(result.stdout.splitlines()), ["my *.plan", "my hall.plan"])

    def test_help_lists_the_functions_of_the_language(self):
        page = rubicon("help", "functions")
        self.assertEqual(page.returncode, 0)
        self.assertRegex(page.stdout, r"(?m)^  min\(p, v\) +the smaller of v and the value of p now$")
        self.assertRegex(page.stdout, r"(?m)^  time\(\) +seconds since the motion began$")
        self.assertTrue(all(len(line) <= 120 for line in page.stdout.splitlines()))

    def test_wrong_calls_exit_with_2_and_a_hint(self):
        for arguments in (["nonsense"], ["run"], ["check"], ["run", "a.plan", "--format", "xml"], ["help", "me"],
                          ["check", "--speed", "x.robot"]):
            result = rubicon(*arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertIn("rubicon help", result.stderr, arguments)
            self.assertEqual(result.stdout, "")

    def test_unknown_commands_and_options_come_with_a_suggestion(self):
        for arguments, expected in ((["rnu", "x.plan"], "unknown command 'rnu'; did you mean run?"),
                                    (["help", "chek"], "there is no command 'chek'; did you mean check?"),
                                    (["paint"], "unknown command 'paint'\n"),
                                    (["run", "x.plan", "--ouput", "d"], "unknown option '--ouput' of run; did you mean --out?"),
                                    (["run", "x.plan", "--fromat=csv"], "unknown option '--fromat' of run; did you mean --format?"),
                                    (["why", "x.plan", "t", "--colour"], "unknown option '--colour' of why\n")):
            result = rubicon(*arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertIn(f"rubicon: error: {expected}", result.stderr, arguments)
            self.assertIn("rubicon help", result.stderr, arguments)

    def test_a_file_that_is_not_there_comes_with_a_suggestion(self):
        result = rubicon("run", self.plan.replace(".plan", "s.plan"))
        self.assertEqual(result.returncode, 2)
        self.assertIn(f'there is no such file; did you mean "{os.path.basename(self.plan)}"?', result.stderr)
        luffer = self.write("luffer.robot", "robot l { body b { param x step(1); } behaviour { chain {move_to(x, goal(x))}; } }\n")
        self.assertTrue(luffer)
        wrong = self.write("wrong.plan", 'plan p { robot r "lufer.robot"; task t { by r; go x 1; } }\n')
        self.assertIn('there is no such file; did you mean "luffer.robot"?', rubicon("check", wrong).stderr)
        os.mkdir(os.path.join(self.folder, "machines"))
        lost = self.write("lost.plan", 'plan p { robot r "machine/luffer.robot"; task t { by r; go x 1; } }\n')
        self.assertIn('there is no folder "machine"; did you mean "machines"?', rubicon("check", lost).stderr)
        far = self.write("far.plan", 'plan p { robot r "nothing_like_it.robot"; task t { by r; go x 1; } }\n')
        self.assertRegex(rubicon("check", far).stderr, "there is no such file\n")

    def test_version(self):
        self.assertRegex(rubicon("--version").stdout, r"^rubicon \d+\.\d+\.\d+\n$")


class Check(Case):
    def test_is_quiet_when_all_is_well(self):
        result = rubicon("check", self.plan)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def test_prints_the_line_and_a_caret_without_colour_in_a_pipe(self):
        script = self.write("bad.motion", "chain {moveto(x, 3)};\n")
        result = rubicon("check", script)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stdout, "")
        self.assertEqual(result.stderr,
                         f"{script}:1:8: error: unknown command 'moveto'; did you mean move_to?\n"
                         "  chain {moveto(x, 3)};\n"
                         "         ^~~~~~\n"
                         "1 error\n")

    def test_columns_count_code_points(self):
        script = self.write("bad.motion", "\ufeffvar(\u03b8) = 1; /* \U0001F3D7 */\tmoveto(x, 3);\n")
        self.assertIn(":1:21: error: unknown command", rubicon("check", script).stderr)

    def test_json_is_shaped_for_editors(self):
        script = self.write("bad.motion", "/* \U0001F3D7 */ moveto(x, 3);\n")
        result = rubicon("check", "--format", "json", script)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stderr, "")
        document = json.loads(result.stdout)
        self.assertEqual(document[0]["uri"], script)
        one = document[0]["diagnostics"][0]
        # UTF-16 columns from 0: the crane sign is two units
        self.assertEqual(one["range"]["start"], {"line": 0, "character": 9})
        self.assertEqual((one["severity"], one["code"], one["source"]), (1, "S05", "rubicon"))
        # A file without mistakes has an object too, so that an editor clears its marks.
        clean = json.loads(rubicon("check", "--format", "json", self.plan).stdout)
        self.assertIn(self.plan, [each["uri"] for each in clean])
        self.assertEqual([each["diagnostics"] for each in clean], [[]] * len(clean))

    def test_a_plan_checks_its_robots_and_they_their_scripts(self):
        self.write("b.motion", "chain { move_to(q, goal(x)) };\n")
        result = rubicon("check", self.plan)
        self.assertEqual(result.returncode, 2)
        self.assertIn("b.motion:1:", result.stderr)

    def test_a_script_alone_gets_only_the_checks_that_need_no_robot(self):
        script = self.write("lone.motion", "chain { move_to(phi, goal(phi)) };\n")
        self.assertEqual(rubicon("check", script).returncode, 0)
        result = rubicon("check", "--robot", os.path.join(self.folder, "gantry.robot"), script)
        self.assertEqual(result.returncode, 2)
        self.assertIn("has no control parameter 'phi' (it has x, y)", result.stderr)

    def test_other_files_are_refused(self):
        for path in (self.write("x.txt", ""), os.path.join(self.folder, "missing.plan"), self.folder + "/x.robot"):
            result = rubicon("check", path)
            self.assertEqual(result.returncode, 2)
            self.assertIn(path, result.stderr)

    def test_a_pipe_nobody_writes_to_does_not_hang(self):
        path = os.path.join(self.folder, "pipe.motion")
        os.mkfifo(path)
        self.assertEqual(rubicon("check", path).returncode, 2)


class Fmt(Case):
    def test_writes_in_place_keeps_comments_and_is_idempotent(self):
        script = self.write("s.motion", "# to the goal\nchain{move_to( x,goal(x) )  ,wait } ;   // so\n")
        self.assertEqual(rubicon("fmt", "--check", script).returncode, 1)
        self.assertEqual(rubicon("fmt", script).returncode, 0)
        text = self.read("s.motion")
        self.assertIn("# to the goal", text)
        self.assertIn("// so", text)
        self.assertIn("move_to(x, goal(x))", text)
        self.assertEqual(rubicon("fmt", "--check", script).returncode, 0)
        self.assertEqual(rubicon("fmt", "-", input=text).stdout, text)

    def test_links_modes_and_owners_stay(self):
        script = self.write("shared.motion", "chain{ wait } ;\n")
        os.makedirs(os.path.join(self.folder, "deep"))
        os.symlink("../shared.motion", os.path.join(self.folder, "deep", "link"))
        link = os.path.join(self.folder, "link.motion")
        os.symlink("deep/link", link)
        os.chmod(script, 0o640)
        owner = (1234, 2345) if os.geteuid() == 0 else (os.geteuid(), os.getegid())
        os.chown(script, *owner)
        self.assertEqual(rubicon("fmt", link).returncode, 0)
        status = os.stat(script)
        self.assertEqual((stat.S_IMODE(status.st_mode), status.st_uid, status.st_gid), (0o640, *owner))
        self.assertTrue(os.path.islink(link) and os.path.islink(os.path.join(self.folder, "deep", "link")))
        self.assertEqual(self.read("shared.motion"), "chain { wait };\n")
        # All names of a file show the change, be it longer or shorter than before.
        for text in ("chain{ wait } ;        \n\n\n\n", "chain{wait};\n"):
            hard = self.write("hard.motion", text)
            other = os.path.join(self.folder, "other.motion")
            os.link(hard, other)
            os.chmod(hard, 0o600)
            self.assertEqual(rubicon("fmt", hard).returncode, 0)
            self.assertEqual((self.read("other.motion"), self.read("hard.motion")), (self.read("shared.motion"),) * 2)
            self.assertEqual((os.stat(hard).st_nlink, stat.S_IMODE(os.stat(hard).st_mode)), (2, 0o600))
            os.remove(other)

    def test_outputs_keep_the_mode_of_what_they_replace(self):
        trace = self.write("trace.jsonl", "")
        os.chmod(trace, 0o600)
        os.symlink("trace.jsonl", os.path.join(self.folder, "link"))
        out = os.path.join(self.folder, "out")
        for i in range(2):
            self.assertEqual(rubicon("run", self.plan, "--trace", os.path.join(self.folder, "link"), "--out", out).returncode, 0)
            self.assertEqual(stat.S_IMODE(os.stat(trace).st_mode), 0o600)
            self.assertEqual(stat.S_IMODE(os.stat(os.path.join(out, "trace.jsonl")).st_mode), 0o600 if i else 0o644)
            os.chmod(os.path.join(out, "trace.jsonl"), 0o600)
        self.assertGreater(os.path.getsize(trace), 0)
        self.assertTrue(os.path.islink(os.path.join(self.folder, "link")))

    def test_leaves_a_wrong_file_alone(self):
        script = self.write("s.motion", "chain{ move_to(x }\n")
        result = rubicon("fmt", script)
        self.assertEqual(result.returncode, 2)
        self.assertIn("error:", result.stderr)
        self.assertEqual(self.read("s.motion"), "chain{ move_to(x }\n")

    def test_what_we_ship_is_in_canonical_form(self):
        shipped = []
        for top in ("robots", "taskplans", "examples"):
            for folder, _, names in os.walk(os.path.join(ROOT, top)):
                shipped += [os.path.join(folder, n) for n in names if n.endswith((".robot", ".motion", ".plan"))]
        self.assertGreater(len(shipped), 10)
        result = rubicon("fmt", "--check", *sorted(shipped))
        self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)


class Run(Case):
    def test_table_json_and_csv_say_the_same(self):
        table = rubicon("run", self.plan)
        self.assertEqual(table.returncode, 0, table.stderr)
        self.assertIn("process time", table.stdout)
        document = json.loads(rubicon("run", self.plan, "--format", "json").stdout)
        self.assertEqual(list(document["tasks"][0]), ["task", "robot", "crew", "start", "duration", "motion", "work",
                                                      "waited", "tried", "accepted", "result", "reason"])
        self.assertEqual(document["process_time"], 3)
        csv = rubicon("run", self.plan, "--format", "csv").stdout.splitlines()
        self.assertTrue(csv[0].startswith("task,robot,crew,start,duration,tried,accepted,result,reason,motion,work,"))
        self.assertEqual(csv[1], "p,gantry,,0,3,3,3,done,,3,0,0,0,0,0,,,,,,,,,,,,,,,,")

    def test_a_motion_that_does_not_end_done_exits_with_1(self):
        self.write("b.motion", "chain { move_dir(x, 1), move_dir(x, -1) };\n")
        result = rubicon("run", self.plan)
        self.assertEqual(result.returncode, 1)
        self.assertIn("livelock", result.stdout)

    def test_a_motion_that_ends_short_of_its_goal_is_short_and_exits_with_1(self):
        self.write("site.plan", PLAN.replace("goal x 3", "goal x 8"))  # behind the wall
        out = os.path.join(self.folder, "result")
        result = rubicon("run", self.plan, "--out", out)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertRegex(result.stdout, r"short: blocked by wall at step \d+ .*short of the goal: x is 4 m below the goal")
        self.assertIn("0 of 1 tasks done, 1 short, process time", result.stdout)
        with open(os.path.join(out, "schedule.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["tasks"][0]["result"], "short")
        with open(os.path.join(out, "schedule.csv"), encoding="utf-8") as file:
            self.assertIn(',short,"blocked by wall', file.read())
        with open(os.path.join(out, "trace.jsonl"), encoding="utf-8") as file:
            records = [json.loads(line) for line in file]
        self.assertEqual([record["status"] for record in records if record["type"] == "end"], ["done"])
        self.assertEqual([record["result"] for record in records if record["type"] == "task_end"], ["short"])
        self.assertEqual(rubicon("verify", out).returncode, 0)
        self.assertIn("p is short: blocked by wall", rubicon("why", out, "p").stdout)
        self.write("site.plan", PLAN.replace("goal x 3", "goal x 8; within x 4"))
        result = rubicon("run", self.plan)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("1 of 1 tasks done", result.stdout)

    def test_a_waypoint_that_is_not_reached_is_told(self):
        self.write("b.motion", "which { via: chain { move_to(x, 1) }; default: chain { move_to(x, goal(x)) } };\n")
        self.write("site.plan", PLAN.replace("goal x 3", "via x -2; via x 1; goal x 3"))
        out = os.path.join(self.folder, "result")
        result = rubicon("run", self.plan, "--out", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("waypoints not reached:\n  p: waypoint 1 is not reached: the tool was 3.000 m from it\n", result.stdout)
        self.assertEqual(result.stdout.count("is not reached"), 1)
        with open(os.path.join(out, "schedule.json"), encoding="utf-8") as file:
            self.assertEqual(len(json.load(file)["tasks"][0]["missed"]), 1)
        trace = os.path.join(out, "trace.jsonl")
        with open(trace, encoding="utf-8") as file:
            text = file.read()
        self.assertIn('"missed":[1],"missed_by":[3]', text)
        self.assertEqual(rubicon("verify", out).returncode, 0)
        for there, words in (('', "waypoint 1 was left with the tool 3 m from it and is not told as missed"),
                             (',"missed":[1],"missed_by":[2.9]', "waypoint 1 is told as missed by 2.9 m, not by 3 m"),
                             (',"missed":[1,2],"missed_by":[3,1]', "waypoint 2 was reached and is told as missed"),
                             (',"missed":[1,7],"missed_by":[3,1]', "waypoint 7 is told as missed, and the motion never left it")):
            with open(trace, "w", encoding="utf-8") as file:
                file.write(text.replace(',"missed":[1],"missed_by":[3]', there))
            verdict = rubicon("verify", out)
            self.assertEqual(verdict.returncode, 1, there)
            self.assertIn(words, verdict.stdout)

    def test_wrong_input_exits_with_2_before_anything_is_written(self):
        self.write("b.motion", "chain { move_to(x) };\n")
        trace = os.path.join(self.folder, "t.jsonl")
        result = rubicon("run", self.plan, "--trace", trace)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stdout, "")
        self.assertFalse(os.path.exists(trace))

    def test_what_is_not_executed_yet_is_refused_at_its_place(self):
        plan = self.write("full.plan", "plan p {\n  robot g \"gantry.robot\" { cost 10 per h; }\n"
                                       "  import \"house.ifc\" as house { }\n  task t { by g; go x 3; }\n}\n")
        self.assertEqual(rubicon("check", plan).returncode, 0)
        result = rubicon("run", plan)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"full\.plan:3:\d+: error: run does not read imports")

    def test_out_writes_the_same_documents(self):
        out = os.path.join(self.folder, "out")
        result = rubicon("run", self.plan, "--out", out)
        self.assertEqual(result.returncode, 0)
        # A build without node has no page, and says so.
        page = [] if "there is no report.html" in result.stderr else ["report.html"]
        self.assertEqual(sorted(os.listdir(out)), page + ["schedule.csv", "schedule.json", "trace.jsonl"])
        self.assertEqual(self.read("out/schedule.json"), rubicon("run", self.plan, "--format", "json").stdout)
        self.assertEqual(self.read("out/schedule.csv"), rubicon("run", self.plan, "--format", "csv").stdout)
        trace = rubicon("run", self.plan, "--format", "csv", "--trace", "-").stdout
        self.assertTrue(trace.startswith(self.read("out/trace.jsonl")))

    def test_a_full_disk_is_an_error(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full here")
        self.assertEqual(rubicon("run", self.plan, "--trace", "/dev/full").returncode, 2)
        with open("/dev/full", "w") as full:
            result = subprocess.run([RUBICON, "run", self.plan], stdout=full, stderr=subprocess.PIPE)
        self.assertEqual(result.returncode, 2)

    def test_two_runs_give_the_same_bytes(self):
        first = rubicon("run", self.plan, "--trace", "-").stdout
        self.assertEqual(first, rubicon("run", self.plan, "--trace", "-").stdout)
        self.assertIn('"rubicon-trace"', first)

    def test_every_record_of_a_trace_fits_the_schema(self):
        try:
            import jsonschema
        except ImportError:
            self.skipTest("python3-jsonschema is not installed")
        with open(os.path.join(ROOT, "docs", "trace.schema.json"), encoding="utf-8") as file:
            validator = jsonschema.Draft7Validator(json.load(file))
        seen = set()
        plans = [self.plan, os.path.join(ROOT, "taskplans", "unit.plan"),
                 os.path.join(ROOT, "tests", "language", "15_cycle_boundary", "site.plan"),
                 os.path.join(ROOT, "tests", "language", "23_which_labels", "site.plan")]
        for plan in plans:
            for line in rubicon("run", plan, "--format", "csv", "--trace", os.path.join(self.folder, "t")).stdout and \
                    self.read("t").splitlines():
                record = json.loads(line)
                if record["type"] == "try" and "try" in seen and len(seen) > 9:
                    continue
                seen.add(record["type"])
                errors = [e.message for e in validator.iter_errors(record)]
                self.assertEqual(errors, [], line[:300])
        self.assertLessEqual({"header", "goal", "set", "enter", "exit", "which", "try", "end", "task_start", "task_end",
                              "attach", "detach"}, seen)


class Test(Case):
    def setUp(self):
        super().setUp()
        rubicon("test", self.folder, "--update")

    def test_update_then_agree(self):
        result = rubicon("test", self.folder)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("1 passed, 0 failed", result.stdout)
        self.assertIn("move_to(x, goal(x))", self.read("expected.trace"))

    def test_a_difference_is_shown_and_exits_with_1(self):
        document = json.loads(self.read("expected.json"))
        document["events"][-2]["q"]["x"] += 0.001
        document["tries"] += 1
        self.write("expected.json", json.dumps(document))
        result = rubicon("test", self.folder, "--junit", os.path.join(self.folder, "out.xml"))
        self.assertEqual(result.returncode, 1)
        self.assertIn("tries", result.stdout)
        self.assertRegex(result.stdout, r"(?m)^ +- try .*x.*3\.001")
        self.assertRegex(result.stdout, r"(?m)^ +\+ try ")
        self.assertIn("<failure", self.read("out.xml"))

    def test_goldens_hold_costs_and_accept_tolerances_a_line_for_each_task_that_differs(self):
        robots = "".join(f'  robot g{i} "gantry.robot" at trans(0, {80 * i}, 0) {{ cost 100 per h; }}\n' for i in (0, 1))
        tasks = "".join(f"  task t{i} {{ by g{i}; go x {10 * (i + 1)}; takes 5 min; }}\n" for i in (0, 1))

        def plan(text=tasks, rates=robots):
            self.write("site.plan", 'plan p {\n  currency "EUR";\n  overhead 240 per day;\n' + rates + text + "}\n")

        def test(*options):
            return rubicon("test", self.folder, *options)

        plan()
        self.assertEqual(test("--update").returncode, 0)
        document = json.loads(self.read("expected.json"))
        self.assertEqual(document["cost"], sum(document["cost_by_kind"].values()))
        self.assertEqual([task["cost"] for task in document["tasks"]], [8.61, 8.89])
        self.assertEqual(test().returncode, 0)
        # Other rates: a line for each sum and each task that costs something else.
        plan(rates=robots.replace("100 per h", "110 per h", 1))
        result = test()
        self.assertEqual(result.returncode, 1)
        self.assertIn("  t0: cost: expected 8.61, found 9.47 (0.86 more)\n", result.stdout)
        self.assertIn("  cost of use: expected 17.50, found 18.36 (0.86 more)\n", result.stdout)
        self.assertNotIn("t1:", result.stdout)
        # Slower tasks: in times too, and what is there no more.
        plan(tasks.replace("takes 5 min", "takes 6 min", 1))
        result = test()
        self.assertRegex(result.stdout, r"(?m)^  t0: duration: expected 310 s, found 370 s \(60 s more\); cost: expected 8.61, "
                         r"found 10.28 \(1.67 more\)$")
        self.assertIn("  process_time: expected 320 s, found 370 s (50 s more)\n", result.stdout)
        plan(tasks.replace("task t1", "task t2"))
        result = test()
        self.assertIn("  t1: expected (done), not found\n", result.stdout)
        self.assertIn("  t2: found (done), not expected\n", result.stdout)

        # With a tolerance the same is near enough; what is farther off says what is allowed.
        plan(tasks.replace("takes 5 min", "takes 6 min", 1))
        document["tolerance"] = {"time": "1 min", "cost": "25 %"}
        del document["events"]
        self.write("expected.json", json.dumps(document))
        self.assertEqual(test().returncode, 0, test().stdout)  # the counts of steps are there, and agree
        for task in document["tasks"]:
            del task["tried"], task["accepted"]
        self.write("expected.json", json.dumps(document))
        self.assertEqual(test().returncode, 0, test().stdout)
        document["tolerance"] = {"time": "1 min", "cost": "25 %", "tasks": {"t0": {"time": 30}}}
        self.write("expected.json", json.dumps(document))
        result = test()
        self.assertEqual(result.returncode, 1)
        self.assertIn("  t0: duration: expected 310 s, found 370 s (60 s more, allowed 30 s)\n", result.stdout)
        self.assertEqual(result.stdout.count(": expected"), 1, result.stdout)
        # Update keeps the tolerance, and leaves out the steps, which differ where times do.
        self.assertEqual(test("--update").returncode, 0)
        written = json.loads(self.read("expected.json"))
        self.assertEqual(written["tolerance"], document["tolerance"])
        self.assertNotIn("events", written)
        self.assertNotIn("tried", written["tasks"][0])
        self.assertEqual(test().returncode, 0)
        for wrong, words in (({"time": "5 kg"}, "as the tolerance of time, found"), ({"tme": 5}, "found 'tme'"),
                             ({"cost": -1}, "as the tolerance of cost, found -1"), (5, "expected an object")):
            self.write("expected.json", json.dumps({**document, "tolerance": wrong}))
            result = test()
            self.assertEqual(result.returncode, 2, wrong)
            self.assertIn(words, result.stdout + result.stderr)
        for more, words in (({"tolerance": {"tasks": {"t7": {"time": 5}}}}, "there is no task 't7', which the tolerance names; did you mean t0?"),
                            ({"proces_time": 5}, "there is no member 'proces_time'; did you mean process_time?")):
            self.write("expected.json", json.dumps({**document, **more}))
            result = test()
            self.assertEqual(result.returncode, 2, more)
            self.assertIn(words, result.stdout)

    def test_filter_and_empty_folders(self):
        result = rubicon("test", self.folder, "--filter", "no such case")
        self.assertEqual(result.returncode, 2)
        self.assertIn("no case", result.stderr)

    def test_the_output_does_not_depend_on_the_number_of_jobs(self):
        cases = os.path.join(ROOT, "tests", "language")
        one = rubicon("test", cases, "--jobs", "1")
        self.assertEqual(one.returncode, 0, one.stdout)
        self.assertEqual(one.stdout, rubicon("test", cases, "--jobs", "4").stdout)


if __name__ == "__main__":
    unittest.main()
