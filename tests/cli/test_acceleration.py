"""Robots with accelerations: what a run takes, and that verify finds every ramp and every stop that is not what it must be."""

import copy
import json
import math
import os
import random
import re
import shutil
import subprocess
import tempfile
import unittest

import random_plans
import waiting_plans

RUBICON = os.environ["RUBICON"]
HERE = os.path.dirname(os.path.abspath(__file__))
SEED = int(os.environ.get("RUBICON_SEED", "1995"))
ROUNDS = int(os.environ.get("RUBICON_ROUNDS", "8"))

TROLLEY = """robot trolley {
  body trolley { param x step(0.5) speed(0.5 m/s)%s range(-20, 20); param z step(0.5) speed(0.5 m/s); frame trans(x, 0, z); }
  tool trolley;
  behaviour { chain { move_to(x, goal(x)) }; chain { move_to(z, goal(z)) }; }
}
"""
PLAN = 'plan p { robot "t.robot"; goal x 4, z 1; }\n'


RANDOM_PLANS = int(os.environ.get("RUBICON_RANDOM_PLANS", "30"))


def accelerate(folder, rng):
    """Gives most parameters of the robots in a folder an acceleration."""
    def attribute(match):
        value = round(rng.choice((0.05, 0.3, 1, 4)) * (10 if match.group(1) in ("theta", "phi", "psi") else 1), 3)
        return match.group(0) + (f" accel({value})" if rng.random() < 0.8 else "")
    for name in sorted(os.listdir(folder)):
        if not name.endswith(".robot"):
            continue
        path = os.path.join(folder, name)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        with open(path, "w", encoding="utf-8") as file:
            file.write(re.sub(r"param (\w+)[^;=]*speed\([^)]*\)", attribute, text))


def rubicon(*arguments):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=120)


def read(path):
    with open(path, encoding="utf-8") as file:
        return [json.loads(line) for line in file]


class Acceleration(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = cls.temporary.name
        cls.good = []
        site = os.path.join(cls.folder, "site")
        shutil.copytree(os.path.join(HERE, "verify_results"), site)
        for name, turning in (("crane.robot", 3), ("cart.robot", 40)):
            path = os.path.join(site, name)
            with open(path, encoding="utf-8") as file:
                text = file.read()
            text = re.sub(r"(param theta .*speed\([^)]*\))", rf"\1 accel({turning} deg/s2)", text)
            text = re.sub(r"(param [xz] .*speed\([^)]*\))", r"\1 accel(0.3)", text)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        for name in ("yard", "meeting"):
            out = os.path.join(cls.folder, name)
            result = rubicon("run", os.path.join(site, name + ".plan"), "--out", out)
            assert result.returncode in (0, 1), result.stderr
            cls.good.append(out)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def run_trolley(self, attribute):
        folder = tempfile.mkdtemp(dir=self.folder)
        for name, text in (("t.robot", TROLLEY % attribute), ("p.plan", PLAN)):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        out = os.path.join(folder, "out")
        result = rubicon("run", os.path.join(folder, "p.plan"), "--out", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(rubicon("verify", out).returncode, 0)
        return read(os.path.join(out, "trace.jsonl"))

    def test_a_way_takes_its_trapezoid(self):
        records = self.run_trolley(" accel(0.25 m/s2)")
        self.assertEqual(records[-1]["t"], 4 / 0.5 + 2 + 1 / 0.5)
        stops = [record for record in records if record["type"] == "stop"]
        self.assertEqual([set(stop) for stop in stops], [{"type", "task", "robot", "t"}])
        self.assertEqual(stops[0]["t"], 10)
        parameters = records[0]["robots"][0]["parameters"]
        self.assertEqual([each.get("acceleration") for each in parameters], [0.25, None])

    def test_without_it_nothing_changes(self):
        records = self.run_trolley("")
        self.assertEqual(records[-1]["t"], 4 / 0.5 + 1 / 0.5)
        text = json.dumps(records)
        self.assertNotIn("acceleration", text)
        self.assertNotIn('"stop"', text)

    def test_good_results_have_no_fault(self):
        for out in self.good:
            result = rubicon("verify", out)
            self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
            stops = [record for record in read(os.path.join(out, "trace.jsonl")) if record["type"] == "stop"]
            self.assertGreater(len(stops), 20)

    def test_what_reads_a_trace_reads_stops(self):
        for out in self.good:
            trace = os.path.join(out, "trace.jsonl")
            with tempfile.TemporaryDirectory() as folder:
                film = os.path.join(folder, "a.glb")
                self.assertEqual(rubicon("export", out, "--gltf", film).returncode, 0)
                chart = rubicon("export", out, "--svg", os.path.join(folder, "a.svg"))
                self.assertEqual(chart.returncode, 0, chart.stderr)
            task = next(record["task"] for record in read(trace) if record["type"] == "stop")
            why = rubicon("why", out, task)
            self.assertEqual(why.returncode, 0, why.stderr)
            debug = subprocess.run([RUBICON, "debug", out], input=f"go {task}\nsteps\ncontinue\nquit\n", text=True,
                                   capture_output=True, timeout=120)
            self.assertEqual(debug.returncode, 0, debug.stderr)

    def test_results_of_random_plans_have_no_fault(self):
        stops = 0
        for number in range(RANDOM_PLANS):
            plans = random_plans if number % 3 else waiting_plans
            with self.subTest(number=number), tempfile.TemporaryDirectory() as folder:
                plan = plans.write_plan(SEED * 10000 + number, folder)
                accelerate(folder, random.Random(number))
                out = os.path.join(folder, "out")
                run = rubicon("run", plan, "--out", out)
                self.assertIn(run.returncode, (0, 1), run.stderr)
                result = rubicon("verify", out)
                self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
                with open(os.path.join(out, "trace.jsonl"), encoding="utf-8") as file:
                    stops += file.read().count('"type":"stop"')
        self.assertGreater(stops, RANDOM_PLANS)

    def records_of(self, texts):
        """The trace of p.plan among these files, after it was done and verified."""
        folder = tempfile.mkdtemp(dir=self.folder)
        for name, text in texts.items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        out = os.path.join(folder, "out")
        run = rubicon("run", os.path.join(folder, "p.plan"), "--out", out)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertEqual(rubicon("verify", out).returncode, 0)
        return read(os.path.join(out, "trace.jsonl"))

    def test_who_goes_away_while_a_robot_stops_is_not_waited_for(self):
        robot = ('robot %s { body car { param %s range(-20, 20); frame trans(%s); shape box(-0.4, -0.4, 0, 0.4, 0.4, 1); }\n'
                 '  tool car; behaviour { chain { move_to(%s, goal(%s)) }; } }\n')
        texts = {"left.robot": robot % ("left", "x step(0.5) speed(0.5 m/s) accel(0.1 m/s2)", "x, 0, 0", "x", "x"),
                 "right.robot": robot % ("right", "y step(10) speed(3 km/h)", "0, y, 0", "y", "y"),
                 "p.plan": 'plan p { robot left "left.robot"; robot right "right.robot" at trans(5, 0, 0);\n'
                           '  task go { by left; go x 10; } task away { by right; go y 10; } }\n'}
        # It meets the other after 4 m, at 10.5 s, and stands at 13 s; the other is gone since 12 s.
        records = self.records_of(texts)
        self.assertEqual([r["t"] for r in records if r["type"] == "stop"], [13, 30])
        self.assertEqual([r for r in records if r["type"] == "pause"], [])

    def test_a_stop_may_end_with_the_shift(self):
        # Its last stop is over at 12:00 sharp: the motion is done then, and not after the break.
        texts = {"c.robot": "robot c { body b { param x step(1) speed(1 m/s) accel(0.5 m/s2) range(-1000, 1000); frame trans(x, 0, 0); } tool b;\n"
                            "  behaviour { chain { move_to(x, goal(x)) }; } }\n",
                 "p.plan": 'plan p { start_at "2026-03-02 11:58"; calendar s { mon-fri 07:00-12:00, 12:30-16:00; carry_over; }\n'
                           '  robot c "c.robot" { start x 0; calendar s; } task a { by c; go x 118; } task b { by c; go x 0; after a; } }\n'}
        records = self.records_of(texts)
        self.assertEqual([r["t"] for r in records if r["type"] == "end"], [120, 30 * 60 + 240])

    def expect_found(self, records, words):
        path = os.path.join(self.folder, "faulty.jsonl")
        with open(path, "w", encoding="utf-8") as file:
            file.writelines(json.dumps(record) + "\n" for record in records)
        result = rubicon("verify", path)
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertRegex(result.stdout, words)

    def happened(self, records):
        results = {record["task"]: record["result"] for record in records if record["type"] == "task_end"}
        return {task for task, result in results.items() if result == "done"}

    def test_every_seeded_fault_is_found(self):
        rng = random.Random(SEED)
        for out in self.good:
            good = read(os.path.join(out, "trace.jsonl"))
            done = self.happened(good)
            stops = [i for i, record in enumerate(good) if record["type"] == "stop" and record["task"] in done]
            for index in rng.sample(stops, min(2 * ROUNDS, len(stops))):
                with self.subTest(out=out, line=index + 1):
                    self.expect_found(self.without(good, index), "before the machine stands")
                    self.expect_found(self.earlier(good, index, 0.2), "the stop lasts")
                    self.expect_found(self.earlier(good, index, -0.1), "the stop lasts")
                    first = self.first_of_run(good, index)
                    self.expect_found(self.earlier(good, first, 0.1), "the step lasts")
            for _ in range(ROUNDS):
                for change in (0.95, 1.05, None):
                    records, touched = copy.deepcopy(good), set()
                    stop = good[rng.choice(stops)]
                    robot = next(each for each in records[0]["robots"] if each["name"] == stop["robot"])
                    step = good[self.first_of_run(good, good.index(stop))]
                    names = step["parameter"] if isinstance(step["parameter"], list) else [step["parameter"]]
                    for parameter in robot["parameters"]:
                        if parameter["name"] not in names or "acceleration" not in parameter:
                            continue
                        touched.add(parameter["name"])
                        if change is None:
                            del parameter["acceleration"]
                        else:
                            parameter["acceleration"] *= change
                    self.assertTrue(touched)
                    self.expect_found(records, "the step lasts|the stop lasts|a stop of a machine that stands")

    def test_a_stop_in_the_middle_of_a_run_is_found(self):
        good = read(os.path.join(self.good[0], "trace.jsonl"))
        done = self.happened(good)
        for index in range(1, len(good) - 1):
            one, other = good[index], good[index + 1]
            same = all(a["type"] == "try" and a["ok"] and a["task"] in done for a in (one, other))
            if not same or one["parameter"] != "x" or other["parameter"] != "x" or one["task"] != other["task"]:
                continue
            records = copy.deepcopy(good)
            stop = {"type": "stop", "task": one["task"], "robot": one["robot"], "t": one["t"] + 1}
            records.insert(index + 1, stop)
            self.expect_found(records, "a stop in the middle of a run|a stop of a machine|the stop lasts")
            return
        self.fail("no run of two steps")

    def before(self, records, index):
        task = records[index]["task"]
        return next(record["t"] for record in reversed(records[:index])
                    if record.get("task") == task and "t" in record)

    def first_of_run(self, records, stop):
        """The step with which the run of a stop begins; at least a step of it."""
        task = records[stop]["task"]
        found = None
        for i in range(stop - 1, 0, -1):
            record = records[i]
            if record["task"] != task or record["type"] in ("goal", "set", "enter", "exit", "which"):
                continue
            if record["type"] != "try":
                break
            if record["ok"]:
                found = i
        return found

    def earlier(self, good, index, share):
        """A record that ends earlier by a share of what it lasts; what follows it lasts longer."""
        records = copy.deepcopy(good)
        before = self.before(records, index)
        records[index]["t"] -= share * (records[index]["t"] - before)
        return records

    def without(self, good, index):
        """A stop that is not charged: all that follows in the task comes so much earlier."""
        records = copy.deepcopy(good)
        by = records[index]["t"] - self.before(records, index)
        task = records[index]["task"]
        for record in records[index + 1:]:
            if record["task"] != task:
                continue
            for member in ("t", "from"):
                if member in record:
                    record[member] -= by
        del records[index]
        return records


if __name__ == "__main__":
    unittest.main()
