"""rubicon export of results: tables, charts, schedules, and what is said of folders that are no results."""

import base64
import datetime
import json
import math
import os
import shutil
import struct
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

RUBICON = os.environ["RUBICON"]
HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
# Once is enough of what takes sanitizers half a minute.
LARGEST = "taskplans/residential.plan"
PLANS = ("taskplans/unit.plan", "taskplans/two_cranes.plan", "taskplans/people_below.plan",
         "taskplans/crane_and_trucks.plan", "taskplans/three_tow_motors.plan", LARGEST,
         "examples/03_round_the_block/site.plan", "examples/08_what_cannot_be_done/site.plan")
SVG = "{http://www.w3.org/2000/svg}"


def rubicon(*arguments):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=300)


class Export(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folders = {}
        for plan in PLANS:
            folder = os.path.join(cls.temporary.name, plan.replace("/", "_"))
            result = rubicon("run", os.path.join(ROOT, plan), "--out", folder)
            assert result.returncode in (0, 1), result.stderr
            cls.folders[plan] = folder
        cls.unit = cls.folders["taskplans/unit.plan"]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def path(self, name):
        return os.path.join(self.temporary.name, name)

    def read(self, path):
        with open(path, encoding="utf-8", newline="") as file:
            return file.read()

    def expect_error(self, *arguments):
        result = rubicon("export", *arguments)
        self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
        self.assertTrue(result.stderr.startswith("rubicon: error: "), result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        return result.stderr

    def test_a_result_is_not_checked_again_with_shapes_that_it_does_not_carry(self):
        folder = os.path.join(self.temporary.name, "mesh")
        os.makedirs(folder)
        # A box of 1 m whose mesh lies 20 m from its origin; its grip is 1.5 m above it.
        corners = [(x, y, z) for x in (20, 21) for y in (20, 21) for z in (0, 1)]
        sides = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
        with open(os.path.join(folder, "far.obj"), "w", encoding="utf-8") as file:
            file.writelines([f"v {x} {y} {z}\n" for x, y, z in corners] + [f"f {a} {b} {c} {d}\n" for a, b, c, d in sides])
        plan = os.path.join(folder, "p.plan")
        with open(plan, "w", encoding="utf-8") as file:
            file.write("""plan p { start_at "2026-03-02 07:00"; crew a; component far {
  shape mesh("far.obj", m) at trans(0, 0, 0); grip trans(20.5, 20.5, 2.5); } task t { by a; takes 1 h; } }""")
        out = os.path.join(folder, "out")
        run = rubicon("run", plan, "--out", out)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        result = rubicon("export", out, "--mspdi", os.path.join(folder, "x.xml"))
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_csv_is_that_of_the_run(self):
        for plan, folder in self.folders.items():
            with self.subTest(plan=plan):
                result = rubicon("export", folder, "--csv", "-")
                self.assertEqual((result.returncode, result.stderr), (0, ""))
                self.assertEqual(result.stdout, self.read(os.path.join(folder, "schedule.csv")))

    def test_charts_are_whole_and_the_same_each_time(self):
        for plan, folder in self.folders.items():
            with self.subTest(plan=plan):
                chart = self.path("chart.svg")
                result = rubicon("export", folder, "--svg", chart, "--csv", self.path("table.csv"))
                self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
                self.assertLess(os.path.getsize(chart), 2_000_000)
                self.assertEqual(rubicon("export", folder, "--svg", "-").stdout, self.read(chart))
                root = xml.etree.ElementTree.parse(chart).getroot()
                self.assertEqual(root.tag, SVG + "svg")
                titles = [element.text.split("\n")[0] for element in root.iter(SVG + "title")]
                with open(os.path.join(folder, "schedule.json"), encoding="utf-8") as file:
                    tasks = json.load(file)["tasks"]
                texts = "\n".join(element.text or "" for element in root.iter(SVG + "text"))
                for task in tasks:
                    if task["result"] == "done":
                        self.assertIn(task["task"], titles)
                    elif not task.get("parking"):
                        self.assertIn(task["task"], texts)
                self.assertFalse([e for e in root.iter() if e.tag.endswith(("script", "image", "foreignObject"))])

    def expect_the_same_as_text(self, folder, document, binary):
        text = json.loads(rubicon("export", folder, "--gltf", "-").stdout)
        head = "data:application/octet-stream;base64,"
        uri = text["buffers"][0].pop("uri")
        self.assertEqual(text, document)
        self.assertTrue(uri.startswith(head))
        within = base64.b64decode(uri[len(head):], validate=True)
        self.assertEqual(within, binary[:len(within)])

    def test_films_are_whole_and_the_same_each_time(self):
        for plan, folder in self.folders.items():
            with self.subTest(plan=plan):
                film = self.path("film.glb")
                result = rubicon("export", folder, "--gltf", film, "--csv", self.path("table.csv"))
                self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
                with open(film, "rb") as file:
                    data = file.read()
                magic, version, total, length, kind = struct.unpack("<4sIII4s", data[:20])
                self.assertEqual((magic, version, total, kind), (b"glTF", 2, len(data), b"JSON"))
                document = json.loads(data[20:20 + length])
                if plan != LARGEST:
                    self.expect_the_same_as_text(folder, document, data[28 + length:])
                with open(os.path.join(folder, "trace.jsonl"), encoding="utf-8") as file:
                    header = json.loads(file.readline())
                names = {node["name"] for node in document["nodes"]}
                for each in header["components"] + header["robots"]:
                    self.assertIn(each["name"], names)
                for robot in header["robots"]:
                    for body in robot["bodies"]:
                        self.assertIn(f"{robot['name']}.{body['name']}", names)
                with open(os.path.join(folder, "schedule.json"), encoding="utf-8") as file:
                    seconds = json.load(file)["process_time"]
                extras = document["asset"]["extras"]
                self.assertAlmostEqual(extras["seconds"], seconds, delta=1e-6)
                self.assertLessEqual(seconds / extras["speed_up"], 60.001)
                self.assertEqual([animation["name"] for animation in document["animations"]], ["construction"])
                for node in document["nodes"]:
                    for value in node.get("extras", {}).values():
                        self.assertIsInstance(value, (str, list, dict))

    def test_films_turn_no_faster_than_the_machine(self):
        # Angles pass 180 degrees, and others are derived from them: nothing may jump there.
        for case, fastest in (("40_counted_turns", 5), ("41_geared_turns", 10)):
            folder, film = self.path(case), self.path(case + ".gltf")
            plan = os.path.join(ROOT, "tests", "language", case, "site.plan")
            self.assertEqual(rubicon("run", plan, "--out", folder).returncode, 0)
            self.assertEqual(rubicon("export", folder, "--gltf", film, "--speed-up", "1").returncode, 0)
            with open(film, encoding="utf-8") as file:
                document = json.load(file)
            data = base64.b64decode(document["buffers"][0]["uri"].split(",")[1])

            def numbers(accessor, width):
                accessor = document["accessors"][accessor]
                view = document["bufferViews"][accessor["bufferView"]]
                begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
                flat = struct.unpack_from(f"<{width * accessor['count']}f", data, begin)
                return [flat[i:i + width] for i in range(0, len(flat), width)]

            animation = document["animations"][0]
            turns = [animation["samplers"][channel["sampler"]] for channel in animation["channels"]
                     if channel["target"]["path"] == "rotation"]
            self.assertEqual(len(turns), 2, case)
            for sampler in turns:
                times, values = numbers(sampler["input"], 1), numbers(sampler["output"], 4)
                for (t0,), (t1,), a, b in zip(times, times[1:], values, values[1:]):
                    angle = 2 * math.degrees(math.acos(min(1, abs(sum(x * y for x, y in zip(a, b))))))
                    self.assertLessEqual(angle, fastest * (t1 - t0) + 0.1, (case, t0, a, b))

    def test_the_speed_of_a_film(self):
        film = self.path("film.gltf")
        self.assertEqual(rubicon("export", self.unit, "--gltf", film, "--speed-up", "60").returncode, 0)
        with open(film, encoding="utf-8") as file:
            document = json.load(file)
        self.assertEqual(document["asset"]["extras"]["speed_up"], 60)
        last = max(document["accessors"][s["input"]]["max"][0] for s in document["animations"][0]["samplers"])
        self.assertAlmostEqual(last * 60, document["asset"]["extras"]["seconds"], delta=7200)
        for bad in ("0", "-1", "x", "nan"):
            self.assertEqual(rubicon("export", self.unit, "--gltf", film, "--speed-up", bad).returncode, 2, bad)

    def test_a_chart_needs_no_trace_and_takes_any_detail(self):
        plan = os.path.join(ROOT, "taskplans", "two_cranes.plan")
        for detail in ("none", "tasks", "steps"):
            folder = self.path("detail_" + detail)
            rubicon("run", plan, "--out", folder, "--trace-detail", detail)
            result = rubicon("export", folder, "--svg", "-")
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertIn("out of shift", result.stdout)
        os.remove(os.path.join(folder, "trace.jsonl"))
        result = rubicon("export", folder, "--svg", "-")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn(">detail_steps</title>", result.stdout)

    def test_a_chart_shows_what_nobody_does(self):
        # With a row for each task, and where there are too many for that.
        for tasks in (3, 90):
            plan = self.path("nobody.plan")
            with open(plan, "w", encoding="utf-8") as file:
                file.write("plan p { crew c; for i from 1 to %d { task t[i] { by c; takes 1 h; } }"
                           " task harden { takes 48 h; after t[%d]; } task cure { takes 24 h; after t[%d]; } task handed_over { after harden; } }" % (tasks, tasks, tasks))
            folder = self.path("nobody_%d" % tasks)
            self.assertEqual(rubicon("run", plan, "--out", folder).returncode, 0)
            root = xml.etree.ElementTree.fromstring(rubicon("export", folder, "--svg", "-").stdout)
            titles = [title.text.split("\n")[0] for title in root.iter(SVG + "title")]
            boxes = {rect.find(SVG + "title").text.split("\n")[0]: rect for rect in root.iter(SVG + "rect") if rect.find(SVG + "title") is not None}
            self.assertLessEqual({"harden", "cure", "handed_over"}, set(titles), tasks)
            self.assertNotEqual(boxes["harden"].get("y"), boxes["cure"].get("y"), "neither covers the other")
            # A diamond where the milestone is, as wide as its title can be met.
            end = float(boxes["harden"].get("x")) + float(boxes["harden"].get("width"))
            diamonds = [path.get("d") for path in root.iter(SVG + "path") if path.get("d").startswith("M%g " % end) and "l" in path.get("d")]
            self.assertTrue(diamonds, tasks)
            self.assertGreater(float(boxes["handed_over"].get("width")), 5)

    def test_a_schedule_has_the_dates_of_the_run(self):
        name = "{http://schemas.microsoft.com/project}"
        for plan, folder in self.folders.items():
            with self.subTest(plan=plan):
                out = self.path("result.xml")
                result = rubicon("export", folder, "--mspdi", out)
                self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)
                self.assertEqual(rubicon("export", folder, "--mspdi", "-").stdout, self.read(out))
                with open(os.path.join(folder, "schedule.json"), encoding="utf-8") as file:
                    schedule = json.load(file)
                start = datetime.datetime.fromisoformat(schedule.get("start_at", "2024-01-01 00:00"))
                written = {}
                for element in xml.etree.ElementTree.parse(out).getroot().iter(name + "Task"):
                    written[element.find(name + "Name").text] = element
                short = "03_round" in plan  # a plan without tasks
                for task in schedule["tasks"]:
                    if short or task.get("parking"):
                        continue
                    element = written.pop(task["task"])
                    text = {each.tag.removeprefix(name): each.text for each in element}
                    if task["result"] != "done":
                        self.assertIn(f"rubicon: {task['result']}: {task['reason']}", text["Notes"])
                        self.assertNotIn("Start", text)
                        continue
                    for what, seconds in (("Start", task["start"]), ("Finish", task["start"] + task["duration"])):
                        expected = start + datetime.timedelta(seconds=int(seconds + 1e-9))
                        self.assertEqual(text[what], expected.isoformat(), task["task"])
                    self.assertEqual((text["Manual"], text["ConstraintType"]), ("1", "4"))
                self.assertFalse(written)
                back = self.path("back.plan")
                self.assertEqual(rubicon("import", out, "--out", back).returncode, 0)
                if short:
                    continue
                self.assertEqual(rubicon("check", back).returncode, 0)
                if all(task["result"] == "done" for task in schedule["tasks"]):
                    again = rubicon("run", back, "--format", "json")
                    self.assertEqual(again.returncode, 0, again.stderr)
                    # Whole seconds: elapsed durations do not become shifts.
                    self.assertAlmostEqual(json.loads(again.stdout)["process_time"], schedule["process_time"], delta=1)

    def test_a_schedule_of_an_imported_plan_keeps_what_came_with_it(self):
        plan, folder, out = self.path("house.plan"), self.path("house"), self.path("house.xml")
        source = os.path.join(ROOT, "tests", "unit", "project_io", "house.xml")
        self.assertEqual(rubicon("import", source, "--out", plan).returncode, 0)
        self.assertIn(rubicon("run", plan, "--out", folder).returncode, (0, 1))
        self.assertEqual(rubicon("export", folder, "--mspdi", out).returncode, 0)
        name = "{http://schemas.microsoft.com/project}"
        before, after = (xml.etree.ElementTree.parse(path).getroot() for path in (source, out))
        for tag in ("UID", "Name", "OutlineLevel"):
            self.assertEqual(*([task.findtext(name + tag) for task in root.iter(name + "Task")] for root in (before, after)))

    def test_calls_that_are_wrong(self):
        self.assertIn("nothing is to be written", self.expect_error(self.unit))
        self.assertIn("--speed-up goes with --gltf", self.expect_error(self.unit, "--csv", "-", "--speed-up", "2"))
        self.assertIn("--gltf needs the folder", self.expect_error(self.path("no"), "--gltf", "-"))
        self.assertIn("only one of the files", self.expect_error(self.unit, "--svg", "-", "--csv", "-"))
        plan = os.path.join(ROOT, "taskplans", "unit.plan")
        self.assertIn("--csv needs the folder of a result", self.expect_error(plan, "--csv", "-"))
        self.assertIn("--svg needs the folder of a result", self.expect_error(self.path("no"), "--svg", "-"))
        self.assertEqual(rubicon("export", self.unit, "--csv", "/dev/full").returncode, 2)

    def test_folders_that_are_no_results(self):
        folder = self.path("empty")
        os.makedirs(folder)
        self.assertIn("schedule.json: there is no such file", self.expect_error(folder, "--csv", "-"))
        os.makedirs(os.path.join(folder, "schedule.json"))
        self.assertIn("schedule.json: this is not a file", self.expect_error(folder, "--svg", "-"))

    def broken(self, name, text):
        """A copy of a good result with one file that has another text."""
        folder = self.path("broken")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.unit, folder)
        with open(os.path.join(folder, name), "w", encoding="utf-8", newline="") as file:
            file.write(text)
        return folder

    def test_broken_files_are_named(self):
        good = self.read(os.path.join(self.unit, "schedule.json"))
        for bad in ("", "{", "[]", good[: len(good) // 2], good.replace('"done"', '"did"', 1), "[" * 100_000):
            message = self.expect_error(self.broken("schedule.json", bad), "--csv", "-")
            self.assertIn("schedule.json: expected", message)
        trace = self.read(os.path.join(self.unit, "trace.jsonl"))
        for bad, line in (("", ""), ("{}\n", "1"), (trace[:1000], "1"),
                          (trace.replace('{"type":"work"', '{"type":"work",,', 1), "")):
            message = self.expect_error(self.broken("trace.jsonl", bad), "--svg", "-")
            self.assertIn(f"trace.jsonl:{line}", message)
            self.assertIn("trace.jsonl:", self.expect_error(self.broken("trace.jsonl", bad), "--gltf", "-"))
        folder = self.path("tasks_only")
        rubicon("run", os.path.join(ROOT, "taskplans", "unit.plan"), "--out", folder, "--trace-detail", "tasks")
        self.assertIn("every step", self.expect_error(folder, "--gltf", self.path("x.glb")))
        for bad in ("", "{}\n", trace[:1000], '{"type":"header","path":"a.plan","files":[]}\n'):
            folder = self.broken("trace.jsonl", bad)
            result = rubicon("export", folder, "--mspdi", self.path("x.xml"))
            self.assertEqual(result.returncode, 2)
            self.assertIn("trace.jsonl", result.stderr)


if __name__ == "__main__":
    unittest.main()
