"""rubicon report and the page of rubicon run --out, from outside: the film in the page is read back here."""

import base64
import gzip
import json
import os
import re
import shutil
import struct
import subprocess
import tempfile
import unittest

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
EVIL = "a </script><!-- ]]> <b>\"'& \U0001F3D7 b"


def rubicon(*arguments, cwd=ROOT):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=120, cwd=cwd)


def build_has_a_page():
    with tempfile.TemporaryDirectory() as folder:
        return "built without the page" not in rubicon("report", folder).stderr


def head_of(page):
    """The head of the film in a page, and how many bytes of columns it has."""
    with open(page, encoding="utf-8") as file:
        text = file.read()
    packed = re.findall(r'<script type="text/plain" id="film">([^<]*)</script>', text)
    assert len(packed) == 1, "a page has one film"
    film = gzip.decompress(base64.b64decode(packed[0], validate=True))
    magic, version, length = struct.unpack("<8sII", film[:16])
    assert (magic, version) == (b"RUBICONF", 1)
    return json.loads(film[16:16 + length]), len(film) - 16 - length


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def run_plan(self, plan, *more):
        result = rubicon("run", plan, "--out", self.path("out"), "--format", "csv", *more)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        return result


class WithoutPage(Case):
    def test_a_run_says_that_there_is_no_page(self):
        if build_has_a_page():
            self.skipTest("this build has the page")
        result = self.run_plan("taskplans/people_below.plan")
        self.assertIn("note: there is no report.html", result.stderr)
        self.assertFalse(os.path.exists(self.path("out", "report.html")))
        self.assertEqual(rubicon("report", self.path("out")).returncode, 2)


@unittest.skipUnless(build_has_a_page(), "this build has no page")
class Report(Case):
    def test_a_run_and_its_report_give_the_same_page(self):
        self.assertEqual(self.run_plan("taskplans/people_below.plan").stderr, "")
        page = self.path("out", "report.html")
        with open(page, "rb") as file:
            first = file.read()
        os.remove(page)
        result = rubicon("report", self.path("out"))
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, page + "\n", ""))
        with open(page, "rb") as file:
            self.assertEqual(file.read(), first)
        self.assertIn(b"<title>people_below - RUBICON</title>", first)

    def test_the_film_tells_the_runs_and_the_schedule(self):
        self.run_plan("taskplans/people_below.plan")
        head, columns = head_of(self.path("out", "report.html"))
        with open(self.path("out", "schedule.json"), encoding="utf-8") as file:
            schedule = json.load(file)
        self.assertEqual(head["schedule"], schedule)
        self.assertEqual([run["task"] for run in head["runs"] if not run["task"].startswith("park ")],
                         [task["task"] for task in sorted(schedule["tasks"], key=lambda t: t["start"])])
        self.assertEqual(head["end"], schedule["process_time"])
        self.assertGreater(columns, 100)

    def test_a_plan_without_tasks(self):
        with open(self.path("empty.plan"), "w", encoding="utf-8") as file:
            file.write("plan empty {\n}\n")
        self.run_plan(self.path("empty.plan"))
        head, _ = head_of(self.path("out", "report.html"))
        self.assertEqual((head["runs"], head["tracks"], head["end"]), ([], [], 0))

    def test_refused_tasks(self):
        self.assertEqual(self.run_plan("examples/08_what_cannot_be_done/site.plan").returncode, 1)
        head, _ = head_of(self.path("out", "report.html"))
        self.assertEqual({run["result"]: run["happened"] for run in head["runs"]},
                         {"rejected": False, "not reached": False, "done": True})
        rejected = [i for i, run in enumerate(head["runs"]) if run["result"] == "rejected"]
        self.assertEqual([track["run"] for track in head["tracks"]], [-1] + rejected)

    def test_a_trace_alone(self):
        self.run_plan("examples/01_one_step_at_a_time/site.plan")
        trace, page = self.path("lone.jsonl"), self.path("lone.html")
        shutil.move(self.path("out", "trace.jsonl"), trace)
        result = rubicon("report", trace, "--out", page)
        self.assertEqual((result.returncode, result.stdout), (0, page + "\n"))
        self.assertIsNone(head_of(page)[0]["schedule"])
        missing = rubicon("report", trace)
        self.assertEqual(missing.returncode, 2)
        self.assertIn("--out FILE", missing.stderr)

    def test_less_detail_plays_too(self):
        for detail in ("tasks", "none"):
            self.run_plan("examples/01_one_step_at_a_time/site.plan", "--trace-detail", detail)
            head, _ = head_of(self.path("out", "report.html"))
            self.assertEqual(len(head["tracks"]), 1)
            self.assertEqual(head["tracks"][0]["count"], 2 if detail == "tasks" else 1)

    def test_names_of_a_plan_are_never_markup(self):
        self.run_plan("examples/01_one_step_at_a_time/site.plan")
        trace = self.path("out", "trace.jsonl")
        with open(trace, encoding="utf-8") as file:
            lines = [json.loads(line) for line in file]
        for line in lines:
            if line["type"] == "header":
                line["plan"] = EVIL
            else:
                line["task"] = EVIL
        with open(trace, "w", encoding="utf-8") as file:
            file.writelines(json.dumps(line) + "\n" for line in lines)
        self.assertEqual(rubicon("report", self.path("out")).returncode, 0)
        head, _ = head_of(self.path("out", "report.html"))
        self.assertEqual(head["header"]["plan"], EVIL)
        self.assertEqual([run["task"] for run in head["runs"]], [EVIL])
        with open(self.path("out", "report.html"), encoding="utf-8") as file:
            page = file.read()
        self.assertIn("<title>a &lt;/script&gt;&lt;!-- ]]&gt; &lt;b&gt;\"'&amp; \U0001F3D7 b - RUBICON</title>", page)
        self.assertNotIn("a </script>", page)

    def test_damage_is_told_with_its_line(self):
        self.run_plan("examples/01_one_step_at_a_time/site.plan")
        trace = self.path("out", "trace.jsonl")
        os.remove(self.path("out", "report.html"))
        with open(trace, encoding="utf-8") as file:
            lines = file.read().splitlines()
        damaged = {
            ":1: expected the header of a trace, found nothing": [],
            ":1: this is no trace": lines[1:],
            ":4: this is no line of a trace": lines[:3] + [lines[3][:40]],
            ":3: this is no line of a trace: it has no 'k'": [*lines[:2], lines[2].replace('"k"', '"kk"')],
        }
        for message, text in damaged.items():
            with open(trace, "w", encoding="utf-8") as file:
                file.writelines(line + "\n" for line in text)
            result = rubicon("report", self.path("out"))
            self.assertEqual((result.returncode, result.stdout), (2, ""), message)
            self.assertIn(message, result.stderr)
            self.assertFalse(os.path.exists(self.path("out", "report.html")))

    def test_missing_and_broken_files(self):
        self.assertIn("there is no such file", rubicon("report", self.path("nothing"), "--out", self.path("x")).stderr)
        self.run_plan("examples/01_one_step_at_a_time/site.plan")
        os.remove(self.path("out", "schedule.json"))
        self.assertEqual(rubicon("report", self.path("out")).returncode, 0)
        self.assertIsNone(head_of(self.path("out", "report.html"))[0]["schedule"])
        with open(self.path("out", "schedule.json"), "w", encoding="utf-8") as file:
            file.write('{"tasks": [')
        result = rubicon("report", self.path("out"))
        self.assertEqual(result.returncode, 2)
        self.assertIn("schedule.json: expected JSON", result.stderr)
        open(self.path("out", "schedule.json"), "w").close()
        self.assertIn("schedule.json: expected JSON", rubicon("report", self.path("out")).stderr)
        for text in ("5", "[]", "{}", '{"tasks": 5}'):
            with open(self.path("out", "schedule.json"), "w", encoding="utf-8") as file:
                file.write(text)
            result = rubicon("report", self.path("out"))
            self.assertEqual((result.returncode, result.stdout), (2, ""), text)
            self.assertIn("schedule.json: expected", result.stderr)
        os.remove(self.path("out", "trace.jsonl"))
        os.mkfifo(self.path("out", "trace.jsonl"))
        self.assertEqual(rubicon("report", self.path("out")).returncode, 2)

    def test_a_page_that_cannot_be_written(self):
        self.run_plan("examples/01_one_step_at_a_time/site.plan")
        for place in (self.path("no", "such", "folder.html"), self.folder):
            result = rubicon("report", self.path("out"), "--out", place)
            self.assertEqual((result.returncode, result.stdout), (2, ""))
            self.assertIn("cannot write", result.stderr)


if __name__ == "__main__":
    unittest.main()
