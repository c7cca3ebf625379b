"""Every command that reads a result, given files that are no files, files to write over, and damaged files."""

import copy
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WALK = "info; tasks; step 3; where; config; list; break hit; continue; next; out; record -7; reverse; until 5; where"
# What numbers, texts and lists of a trace are replaced by.
ODD = (None, True, 0, -1, 0.5, 2**31, 2**53, 2**64, 1e17, -1e308, "", "nobody", "\0\x1b[31m", "a" * 5000, [], [[]], {})


def rubicon(*arguments, timeout=120):
    return subprocess.run([RUBICON, *arguments], stdin=subprocess.DEVNULL, capture_output=True, timeout=timeout)


def readers(folder, out):
    """A call of each command that reads a result; those that write a file write `out`."""
    return (("why", folder, "set_a"), ("verify", folder), ("debug", folder, "-x", WALK, "--batch"),
            ("report", folder, "--out", out), ("export", folder, "--gltf", out), ("export", folder, "--svg", out),
            ("export", folder, "--csv", out), ("export", folder, "--mspdi", out))


class DamagedResult(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.good = os.path.join(cls.temporary.name, "good")
        rubicon("run", os.path.join(ROOT, "examples/08_what_cannot_be_done/site.plan"), "--out", cls.good)
        cls.has_page = b"built without the page" not in rubicon("report", cls.temporary.name).stderr
        with open(os.path.join(cls.good, "trace.jsonl"), encoding="utf-8") as file:
            cls.lines = file.read().splitlines()
        with open(os.path.join(cls.good, "schedule.json"), encoding="utf-8") as file:
            cls.schedule = file.read()

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def refused(self, *arguments):
        """What a call that ends with 2 says, in one line."""
        result = rubicon(*arguments, timeout=20)
        message = result.stderr.decode()
        self.assertEqual((result.returncode, result.stdout), (2, b""), (arguments, message))
        self.assertRegex(message, r"^rubicon: error: [^\n]*\n$", arguments)
        return message

    def test_pipes_and_folders_in_place_of_files_do_not_hang(self):
        for make in (os.mkfifo, os.makedirs):
            folder = self.path(make.__name__)
            os.makedirs(folder)
            for name in ("trace.jsonl", "schedule.json", "schedule.csv"):
                make(os.path.join(folder, name))
            for call in readers(folder, self.path("out")):
                if call[0] != "report" or self.has_page:
                    self.assertIn("this is not a file", self.refused(*call))
        for command in (("why", "set_a"), ("debug",), ("verify",)):
            pipe = self.path("mkfifo", "trace.jsonl")
            self.assertIn("this is not a file", self.refused(command[0], pipe, *command[1:]))

    def test_nothing_is_written_over_what_is_read(self):
        good = self.path("good")
        shutil.copytree(self.good, good)
        trace, schedule = os.path.join(good, "trace.jsonl"), os.path.join(good, "schedule.json")
        link = self.path("link")
        os.symlink(trace, link)
        for name in (trace, schedule, os.path.join(good, ".", "trace.jsonl"), link):
            for kind in ("--gltf", "--svg", "--csv", "--mspdi"):
                self.assertIn("is read here", self.refused("export", good, kind, name))
            if self.has_page:
                self.assertIn("is read here", self.refused("report", good, "--out", name))
                self.assertIn("is read here", self.refused("report", trace, "--out", trace))
        shutil.copytree(os.path.join(ROOT, "examples/08_what_cannot_be_done"), self.path("plan"))
        plan = self.path("plan", "site.plan")
        self.assertIn("is read here", self.refused("export", plan, "--mspdi", plan))
        new = self.path("new")
        self.assertIn("two outputs", self.refused("export", good, "--svg", new, "--csv", self.path(".", "new")))
        self.assertFalse(os.path.exists(new))
        for name in ("trace.jsonl", "schedule.json"):
            with open(os.path.join(self.good, name), "rb") as one, open(os.path.join(good, name), "rb") as other:
                self.assertEqual(one.read(), other.read(), name)
        self.assertEqual(rubicon("export", good, "--svg", "/dev/null", "--csv", "/dev/null").returncode, 0)

    def test_nothing_is_written_over_what_the_plan_names(self):
        texts = {"site.plan": """plan m {
  robot gantry "gantry.robot" at trans(0, 0, 0); crew a; support off;
  component beam { shape mesh("beam.stl", mm) at trans(50, 0, 0); }
  task go { by gantry; go x 1; }
  task count { by a; takes measured("times.csv", min); }
}
""", "gantry.robot": """robot gantry {
  body trolley { param x step(0.5) range(0, 10); frame trans(x, 0, 0); shape box(-1, -1, 0, 1, 1, 1); }
  tool trolley; behaviour "move.motion";
}
""", "move.motion": "chain { move_to(x, goal(x)) };\n", "times.csv": "3\n4\n"}
        for name, text in texts.items():
            with open(self.path(name), "w", encoding="utf-8") as file:
                file.write(text)
        shutil.copy(os.path.join(ROOT, "tests/cli/models/beam.stl"), self.folder)
        plan, new = self.path("site.plan"), self.path("new")
        self.assertEqual(rubicon("run", plan, "--trace", new).returncode, 0)
        os.symlink("move.motion", self.path("link"))
        os.link(self.path("beam.stl"), self.path("hard"))
        names = [*texts, "beam.stl", "link", "hard", "../" + os.path.basename(self.folder) + "/times.csv"]
        before = {name: pathlib.Path(self.path(name)).read_bytes() for name in names}
        for name in names:
            for call in (("run", plan, "--trace"), ("guides", plan, "go", "--svg"), ("guides", plan, "go", "--chart"),
                         ("guides", plan, "go", "--page"), ("export", plan, "--mspdi"), ("layout", plan, "--out")):
                more = {"layout": ("--module", "2 m x 1 m"), "--page": ("--axes", "x")}
                self.assertIn("is read here", self.refused(
                    *call, self.path(name), *more.get(call[0], more.get(call[-1], ()))))
        for call in (["a.xml"], ["a.ifc"], ["a.ifc", "--schedule", "a.xml", "--match", "b.match"], ["a.urdf"], ["f.dxf", "--area"],
                     ["g.map", "g.scen"]):
            for output in filter(lambda word: "." in word, call):
                shutil.copy(plan, self.path(output))
                before[output] = before["site.plan"]
                words = [self.path(word) if "." in word else word for word in call]
                self.assertIn("is read here", self.refused("import", *words, "--out", self.path(".", output)))
        shutil.copy(plan, self.path("a_elements.csv"))
        self.assertIn("is read here", self.refused("import", self.path("a.ifc"), "--schedule", self.path("a_elements.csv"), "--match",
                                                   self.path("b.match"), "--out", self.path("a.plan")))
        shutil.copytree(os.path.join(ROOT, "examples/08_what_cannot_be_done"), self.path("case"))
        for name in ("site.plan", "expected.json"):
            self.assertIn("is read here", self.refused("test", self.path("case"), "--junit", self.path("case", name)))
        self.assertEqual({name: pathlib.Path(self.path(name)).read_bytes() for name in before}, before)

    def test_a_report_replaces_no_page_of_somebody(self):
        if not self.has_page:
            self.skipTest("this build has no page")
        good = self.path("good")
        shutil.copytree(self.good, good)
        page = os.path.join(good, "report.html")
        self.assertEqual(rubicon("report", good).returncode, 0)
        with open(page, "w", encoding="utf-8") as file:
            file.write("<!doctype html><title>what we did last week</title>")
        self.assertIn("is not a page of rubicon", self.refused("report", good))
        os.remove(page)
        self.assertEqual(rubicon("report", good).returncode, 0)

    def places(self, value, place=()):
        """The place of everything in a JSON value."""
        if place:
            yield place
        members = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
        for key, member in members:
            yield from self.places(member, place + (key,))

    def damage(self, chance, text):
        """A JSON text in which one thing is another, missing, or there more than once."""
        value = json.loads(text)
        places = list(self.places(value))
        *outer, key = chance.choice(places)
        holder = value
        for step in outer:
            holder = holder[step]
        what = chance.random()
        if what < 0.6:
            holder[key] = copy.deepcopy(chance.choice(ODD))
        elif what < 0.8 or not isinstance(holder, list):
            del holder[key]
        else:
            holder += [copy.deepcopy(holder[key])] * chance.choice((1, 50))
        return json.dumps(value, separators=(",", ":"))

    def write_damaged(self, chance, folder):
        lines, schedule = list(self.lines), self.schedule
        where = chance.random()
        if where < 0.2:
            schedule = self.damage(chance, schedule)
        elif where < 0.5:
            lines[0] = self.damage(chance, lines[0])
        else:
            number = chance.randrange(1, len(lines))
            lines[number] = self.damage(chance, lines[number])
            if where > 0.8:
                del lines[chance.randrange(1, len(lines))]
        os.makedirs(folder)
        for name, text in (("trace.jsonl", "\n".join(lines) + "\n"), ("schedule.json", schedule)):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        shutil.copy(os.path.join(self.good, "schedule.csv"), folder)

    def expect_sound(self, call, out):
        """A call ended well, with a sound file, or said why not and wrote none."""
        result = rubicon(*call)
        message = result.stderr.decode()
        self.assertIn(result.returncode, (0, 1, 2), message)
        self.assertFalse(re.search("[\x00-\x09\x0b-\x1f]", message + result.stdout.decode()), message)
        if result.returncode == 2:
            self.assertIn("error: ", message)
            self.assertFalse(os.path.exists(out), message)
        elif os.path.exists(out):
            if call[2] in ("--svg", "--mspdi"):
                xml.etree.ElementTree.parse(out)
            elif call[2] == "--gltf":
                with open(out, encoding="utf-8") as file:
                    json.load(file, parse_constant=self.fail)
            os.remove(out)

    def test_damaged_files_are_refused_or_shown(self):
        count = int(os.environ.get("RUBICON_DAMAGED_RESULTS", "12"))
        for seed in range(count):
            folder, out = self.path(str(seed)), self.path("out")
            self.write_damaged(random.Random(seed), folder)
            for call in readers(folder, out):
                with self.subTest(seed=seed, call=call[:3]):
                    self.expect_sound(call, out)
            shutil.rmtree(folder)
            self.assertEqual(os.listdir(self.folder), [], "nothing half written stays")


if __name__ == "__main__":
    unittest.main()
