"""Wrong files: each gives exit code 2 and a message at a place, and no signal."""

import os
import re
import shutil
import subprocess
import tempfile
import time
import unittest

RUBICON = os.environ["RUBICON"]
HERE = os.path.dirname(os.path.abspath(__file__))
CHECK = os.path.join(os.path.dirname(HERE), "unit", "check")
SITE = os.path.join(CHECK, "site")
LIMIT_SECONDS = 60  # a guard against hangs on a loaded machine, not a measure of speed
ERROR = re.compile(r"^(?P<file>[^:\n]+):(?P<line>\d+):(?P<column>\d+): error: (?P<message>.*)$", re.MULTILINE)


def own_cases():
    """Yields title, kind, text, expectation from bad/cases.txt."""
    title, kind, text = None, None, []
    with open(os.path.join(HERE, "bad", "cases.txt"), encoding="utf-8") as file:
        for line in file.read().split("\n"):
            match = re.fullmatch(r"--- (.*) \[(motion|robot|plan)\]", line)
            if match:
                title, kind, text = match.group(1), match.group(2), []
            elif line.startswith("  => "):
                yield title, kind, "".join(text), line[5:]
            elif title is not None and not line.startswith("#"):
                text.append(line[4:] + "\n")


def unit_cases(name):
    """Yields title, text, first error from a case file of the unit tests."""
    title, text, errors = None, [], []
    with open(os.path.join(CHECK, name), encoding="utf-8") as file:
        for line in file.read().split("\n") + ["--- end"]:
            if line.startswith("--- "):
                own = [each for each in errors if re.match(r"\d", each)]
                if own and not any("cannot be used:" in each for each in errors):
                    yield title, "".join(text), own[0]
                title, text, errors = line[4:], [], []
            elif line.startswith("  => "):
                if re.search(r": \w\d\d error: ", line):
                    errors.append(re.sub(r" \w\d\d error:", "", line[5:]))
            elif line.startswith("    "):
                text.append(line[4:] + "\n")


class BadInput(unittest.TestCase):
    checked = 0

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.join(folder.name, "site")
        shutil.copytree(SITE, self.folder)

    def check(self, name, content, expectation, kind=None):
        """Runs the command on one file; its first error must stand at the place and hold the message."""
        path = os.path.join(self.folder, name)
        with open(path, "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode("utf-8"))
        with_robot = ["--robot", "crane.robot"] if kind == "motion" else []
        result = subprocess.run([RUBICON, "check", *with_robot, name], capture_output=True, cwd=self.folder,
                                timeout=LIMIT_SECONDS)
        said = result.stderr.decode("utf-8", "replace")
        self.assertEqual(result.returncode, 2, said[:2000])
        errors = [match for match in ERROR.finditer(said) if match["file"] == name]
        self.assertTrue(errors, "no error at a place: " + said[:2000])
        found = "{}:{}: {}".format(errors[0]["line"], errors[0]["column"], errors[0]["message"])
        place = re.match(r"(\d+:(\d+:)?)? ?(.*)", expectation)
        self.assertTrue(found.startswith(place[1] or ""), found)
        self.assertIn(place[3].strip(), found)
        BadInput.checked += 1
        return said

    def test_own_cases(self):
        for title, kind, text, expectation in own_cases():
            with self.subTest(title, kind=kind):
                self.check("case." + kind, text, expectation, kind)

    def test_cases_of_the_unit_tests(self):
        for kind in ("robot", "plan"):
            for title, text, expectation in unit_cases(kind + "_cases.txt"):
                with self.subTest(title, kind=kind):
                    self.check("case." + kind, text, expectation)

    def test_a_night_shift_is_told_as_the_lines_that_it_has_to_be(self):
        plan = 'plan p { calendar a { %s } robot "crane.robot"; goal theta 0, x 20, z 10; }\n'
        for days, times, lines in (
                ("mon", "22:00-06:00", "mon 22:00-24:00; tue 00:00-06:00;"),
                ("mon-fri", "22:00-06:00", "mon-fri 22:00-24:00; tue-sat 00:00-06:00;"),
                ("mon-sun", "20:00-04:30", "mon-sun 20:00-24:00; mon-sun 00:00-04:30;"),
                ("fri-sun", "22:00-06:00", "fri-sun 22:00-24:00; mon 00:00-06:00; sat-sun 00:00-06:00;"),
                ("sun", "22:00-06:00", "sun 22:00-24:00; mon 00:00-06:00;"),
                ("tue", "16:00-00:00", "tue 16:00-24:00;")):
            with self.subTest(days + " " + times):
                said = self.check("night.plan", plan % f"{days} {times};", "this shift ends at")
                self.assertIn(f"split a night shift at 24:00: {lines}\n", said)
                with open(os.path.join(self.folder, "night.plan"), "w", encoding="utf-8") as file:
                    file.write(plan % lines)
                done = subprocess.run([RUBICON, "check", "night.plan"], capture_output=True, cwd=self.folder, timeout=LIMIT_SECONDS)
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_bytes_that_are_no_text(self):
        robot = b'robot r { body b { param x step(1); } behaviour "ok.motion"; }\n'
        for title, kind, content, expectation in (
                ("NUL in a script", "motion", b"chain {move_to(x,\0 3)};\n", "1:18:"),
                ("NUL in a robot", "robot", robot.replace(b"param", b"par\0m"), "1:"),
                ("NUL in a plan", "plan", b"plan p { \0 }\n", "1:10:"),
                ("nothing but NUL", "plan", b"\0" * 1000, "1:1:"),
                ("not UTF-8", "motion", b"chain {move_to(x, 3)}; # caf\xe9\n", "1: UTF-8"),
                ("not UTF-8 in a robot", "robot", robot.replace(b"ok", b"\xff\xfe"), "1:"),
                ("UTF-16", "plan", "plan p { }".encode("utf-16"), "1:"),
                ("Latin-1 in a name", "plan", b'plan p { component k { name "St\xfctze"; } }\n', "1:32: not UTF-8"),
                ("cut in the middle of a character", "motion", "chain {move_to(\u03b8, 3)};\n".encode()[:16], "1:"),
                ("an overlong character", "robot", b"robot \xc0\xaf { }\n", "1:"),
                ("BOM before a mistake", "motion", b"\xef\xbb\xbfchain {moveto(x, 3)};\n", "1:8: did you mean move_to?"),
                ("BOM alone", "robot", b"\xef\xbb\xbf", "1:1:"),
                ("CRLF", "motion", b"chain {move_to(x, 3)};\r\nchain {moveto(x, 3)};\r\n", "2:8: moveto"),
                ("CRLF in a plan", "plan", b'plan p {\r\n  robot "crane.robot";\r\n  goal q 3;\r\n}\r\n', "3:8: 'q'"),
                ("columns count characters", "motion", "chain {move_to(\u03b8, 3), moveto(x, 3)};\n", "1:23: moveto"),
                ("tabs count one", "motion", "\t\tmoveto(x, 3);\n", "1:3: moveto")):
            with self.subTest(title):
                self.check("case." + kind, content, expectation, kind)

    def test_deep_nesting(self):
        deep = 100000
        for title, kind, content in (
                ("chains", "motion", "chain {" * deep),
                ("closed chains", "motion", "chain {" * deep + "wait" + "}" * deep + ";"),
                ("parentheses", "motion", "var(a) = " + "(" * deep + "1" + ")" * deep + ";"),
                ("signs", "motion", "var(a) = " + "-" * deep + ";"),
                ("not", "motion", "chain {wait} until (" + "not " * deep + ");"),
                ("which", "motion", "which { default: " * deep),
                ("calls", "motion", "var(a) = " + "abs(" * deep),
                ("a rule", "robot", "robot r { body b { param x step(1); rule x <- " + "(" * deep),
                ("a constant", "robot", "robot r { const a = " + "sin(" * deep + "1" + ")" * deep + "; }"),
                ("bodies", "robot", "robot r { " + "body b { " * deep),
                ("tasks", "plan", "plan p { " + "task t { " * deep),
                ("modules", "plan", "plan p { " + "module m { " * deep),
                ("an import", "plan", 'plan p { import "a.ifc" ' + "{ " * deep),
                ("braces", "plan", "{" * deep)):
            with self.subTest(title, kind=kind):
                self.check("case." + kind, content, "1:", kind)

    def test_long_input_ends_soon(self):
        million = 1000000
        garbage = bytes((i * 7919 + (i >> 8) * 104729 + 13) % 251 for i in range(10 * million))
        words = b"chain } ; , move_to ( x { param body 3.5 task \" ) = <- + which : default # \n" * (million // 8)
        for title, kind, content in (
                ("10 MB of garbage", "motion", garbage),
                ("10 MB of garbage in a robot", "robot", b"robot r { " + garbage),
                ("10 MB of garbage in a plan", "plan", b"plan p { " + garbage),
                ("10 MB of words", "motion", words),
                ("10 MB of words in a robot", "robot", b"robot r { " + words),
                ("10 MB of words in a plan", "plan", b"plan p { " + words),
                ("10 MB of one name", "motion", b"a" * (10 * million)),
                ("10 MB of digits", "motion", b"var(a) = " + b"1" * (10 * million) + b";"),
                ("a million wrong commands", "motion", b"moveto(x, 3);\n" * million)):
            with self.subTest(title):
                begin = time.monotonic()
                said = self.check("case." + kind, content, "", kind)
                self.assertLess(len(said), 1 << 20, "the messages are bounded")
                self.assertLess(time.monotonic() - begin, LIMIT_SECONDS)

    def test_bad_meshes(self):
        for title, name, content in (
                ("not a mesh", "bad.stl", b"solid nothing, and no facet\n"),
                ("missing", "none.stl", None),
                ("empty", "empty.stl", b""),
                ("truncated", "short.stl", b"\0" * 80 + b"\xff\xff\xff\x7f" + b"\0" * 20),
                ("not a number", "nan.obj", b"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                ("index out of range", "range.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"),
                ("claims 100 million points", "bomb.ply",
                 b"ply\nformat ascii 1.0\nelement vertex 100000000\nproperty float x\nend_header\n0\n"),
                ("a format nobody knows", "cube.xyzzy", b"1 2 3\n")):
            with self.subTest(title):
                if content is not None:
                    with open(os.path.join(self.folder, name), "wb") as file:
                        file.write(content)
                self.check("case.robot", 'robot r {\n  body b { param x step(1);\n    shape mesh("%s", mm); }\n'
                           '  behaviour "ok.motion";\n}\n' % name, "3:16: mesh '%s'" % name)

    def test_files_that_are_no_files(self):
        os.mkdir(os.path.join(self.folder, "folder.robot"))
        os.mkfifo(os.path.join(self.folder, "pipe.robot"))
        os.symlink("loop.robot", os.path.join(self.folder, "loop.robot"))
        for name in ("folder.robot", "pipe.robot", "loop.robot", "nowhere.robot", "", "a" * 5000 + ".robot"):
            with self.subTest(name[:20]):
                self.check("case.plan", 'plan p { robot "%s"; goal x 3; }\n' % name, "1:16: robot file '" + name[:50])

    @classmethod
    def tearDownClass(cls):
        if cls.checked < 120:
            raise AssertionError("only {} wrong files were refused as they should".format(cls.checked))


if __name__ == "__main__":
    unittest.main()
