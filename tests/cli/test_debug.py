"""rubicon debug: transcripts that are done again, the streams, the sources, wrong calls, hostile input."""

import contextlib
import os
import re
import shutil
import subprocess
import tempfile
import unittest

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TRANSCRIPTS = os.path.join(ROOT, "tests", "cli", "debug_transcripts")
EXAMPLE = "examples/02_over_the_wall/site.plan"


def rubicon(*arguments, stdin=""):
    return subprocess.run([RUBICON, *arguments], input=stdin, capture_output=True, text=True, timeout=120, cwd=ROOT)


def again(arguments, transcript):
    """The transcript of the commands of a transcript: the lines after '> '."""
    commands = [line[1:].strip() for line in transcript.splitlines() if re.match(r">( |$)", line)]
    result = rubicon("debug", *arguments.split(), stdin="\n".join(commands) + "\n")
    return result.stdout + result.stderr


class Transcripts(unittest.TestCase):
    """A file of debug_transcripts has the arguments in its first line; RUBICON_UPDATE=1 writes the rest anew."""

    maxDiff = None

    def test_each_is_what_happens(self):
        names = sorted(os.listdir(TRANSCRIPTS))
        self.assertGreaterEqual(len(names), 3)
        for name in names:
            path = os.path.join(TRANSCRIPTS, name)
            with open(path, encoding="utf-8") as file:
                head, _, text = file.read().partition("\n")
            self.assertTrue(head.startswith("rubicon debug "), name)
            happened = again(head[len("rubicon debug "):], text)
            if os.environ.get("RUBICON_UPDATE"):
                with open(path, "w", encoding="utf-8") as file:
                    file.write(head + "\n" + happened)
            else:
                self.assertEqual(text, happened, name)

    def test_those_of_the_guide_are_what_happens(self):
        path = os.path.join(ROOT, "docs", "debug.md")
        with open(path, encoding="utf-8") as file:
            guide = file.read()
        blocks = re.findall(r"```text\n\$ rubicon debug ([^\n]*)\n(.*?)```", guide, re.DOTALL)
        self.assertGreaterEqual(len(blocks), 2)
        for arguments, text in blocks:
            happened = again(arguments, text)
            if os.environ.get("RUBICON_UPDATE"):
                guide = guide.replace(arguments + "\n" + text, arguments + "\n" + happened)
            else:
                self.assertEqual(text, happened)
        if os.environ.get("RUBICON_UPDATE"):
            with open(path, "w", encoding="utf-8") as file:
                file.write(guide)

    def test_the_guide_names_every_command(self):
        with open(os.path.join(ROOT, "docs", "debug.md"), encoding="utf-8") as file:
            guide = file.read()
        words = re.findall(r"^  (.)  (\w+) ", rubicon("debug", EXAMPLE, stdin="help\n").stdout, re.MULTILINE)
        self.assertGreaterEqual(len(words), 20)
        for letter, word in words:
            self.assertRegex(guide, r"\n\| `%s[ `].*\| *%s *\|" % (word, f"`{letter}`" if letter != " " else ""))


class Sources(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def test_a_plan_a_result_and_a_trace_tell_the_same(self):
        out = os.path.join(self.folder, "out")
        rubicon("run", EXAMPLE, "--out", out)
        renamed = shutil.copy(os.path.join(out, "trace.jsonl"), os.path.join(self.folder, "of any name"))
        told = [rubicon("debug", source, stdin="s 3\nw\nx\np\nl\nc\n").stdout
                for source in (EXAMPLE, out, os.path.join(out, "trace.jsonl"), renamed)]
        self.assertEqual(told[1:], told[:1] * 3)
        self.assertIn("try 3/34", told[0])

    def test_work_takes_its_hours_in_shifts(self):
        path = os.path.join(self.folder, "p.plan")
        with open(path, "w", encoding="utf-8") as file:
            file.write('plan p { start_at "2026-03-02 07:00"; calendar day { mon-fri 07:00-12:00, 12:30-16:00; }\n'
                       "  crew masons { calendar day; } task grout { by masons; takes 20 h; } }\n")
        self.assertIn("  takes: 72000 s\n", rubicon("debug", path, "-x", "step", "--batch").stdout)

    def test_a_trace_without_steps_says_how_to_get_them(self):
        trace = os.path.join(self.folder, "t.jsonl")
        for detail in ("tasks", "none"):
            rubicon("run", EXAMPLE, "--trace", trace, "--trace-detail", detail)
            result = rubicon("debug", trace)
            self.assertEqual((result.returncode, result.stdout), (2, ""))
            self.assertIn(f"this trace has no steps (its detail is '{detail}'): run again with --trace-detail steps",
                          result.stderr)

    def test_wrong_input_exits_with_2(self):
        result = rubicon("debug", "taskplans/two_cranes.plan", "set_wal_4")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("there is no task 'set_wal_4'; did you mean set_wall_4?", result.stderr)
        result = rubicon("debug", "examples/08_what_cannot_be_done/site.plan", "set_b")
        self.assertEqual(result.returncode, 2)
        self.assertIn("'set_b' never began: it comes after set_a, which is rejected", result.stderr)
        for text in ("", "no json\n", '{"type":"header","format":"other"}\n', '{"type":"try"}\n', "[]\n", "[" * 100000):
            result = rubicon("debug", self.write("bad.jsonl", text))
            self.assertEqual(result.returncode, 2, text[:80])
            self.assertIn("bad.jsonl", result.stderr)
        self.assertEqual(rubicon("debug", os.path.join(self.folder, "none.jsonl")).returncode, 2)
        self.assertEqual(rubicon("debug", os.path.join(self.folder, "none.plan")).returncode, 2)
        self.assertEqual(rubicon("debug").returncode, 2)

    def test_a_trace_that_stops_in_a_line_is_refused_at_its_place(self):
        trace = os.path.join(self.folder, "t.jsonl")
        rubicon("run", EXAMPLE, "--trace", trace)
        with open(trace, encoding="utf-8") as file:
            text = file.read()
        lines = text.count("\n", 0, len(text) * 9 // 10) + 1
        result = rubicon("debug", self.write("cut.jsonl", text[:len(text) * 9 // 10]))
        self.assertEqual(result.returncode, 2)
        self.assertIn(f"cut.jsonl:{lines}: ", result.stderr)


class Streams(unittest.TestCase):
    def test_commands_of_the_call_come_first_and_batch_ends_after_them(self):
        call = ["debug", EXAMPLE, "--command", "break hit; continue", "-x", "where"]
        batch = rubicon(*call, "--batch", stdin="step\n").stdout
        self.assertIn("> break hit\nbreakpoint 1: hit\n> continue\nbreakpoint 1, hit\n", batch)
        self.assertIn("> where\n#0  chain at over.motion:2", batch)
        self.assertNotIn("> step", batch)
        self.assertEqual(rubicon(*call, stdin="step\n").stdout.partition("> step\n")[0], batch)

    def test_quit_and_the_end_of_the_input_end_it(self):
        for stdin in ("", "step", "step\n", "quit\nstep\n", "q", "step\r\nquit\r\n"):
            result = rubicon("debug", EXAMPLE, stdin=stdin)
            self.assertEqual((result.returncode, result.stderr), (0, ""), stdin)
        self.assertNotIn("> step", rubicon("debug", EXAMPLE, stdin="quit\nstep\n").stdout)

    def test_a_line_without_end_is_not_read_for_ever(self):
        with open("/dev/zero", "rb") as zeros:
            result = subprocess.run([RUBICON, "debug", EXAMPLE], stdin=zeros, capture_output=True, timeout=60, cwd=ROOT)
        self.assertEqual(result.returncode, 2)
        self.assertIn(b"no command is that long", result.stderr)
        self.assertLess(len(result.stdout), 10000)

    def test_a_reader_that_goes_away_ends_it(self):
        command = subprocess.Popen([RUBICON, "debug", EXAMPLE], stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=ROOT)
        command.stdout.close()
        with self.assertRaises(BrokenPipeError):
            for _ in range(1000000):
                command.stdin.write(b"info\n")
        with contextlib.suppress(BrokenPipeError):
            command.stdin.close()
        self.assertNotEqual(command.wait(timeout=60), 0)

    def test_a_full_disk_is_an_error(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full here")
        with open("/dev/full", "w", encoding="utf-8") as full:
            result = subprocess.run([RUBICON, "debug", EXAMPLE], input=b"step\n", stdout=full, stderr=subprocess.PIPE,
                                    cwd=ROOT, timeout=60)
        self.assertEqual(result.returncode, 2)

    def test_no_colour_in_a_pipe_and_a_prompt_only_on_a_terminal(self):
        piped = rubicon("debug", EXAMPLE, stdin="step\nbreak hit\nc\n").stdout
        self.assertNotIn("\x1b", piped)
        try:
            import pty
        except ImportError:
            self.skipTest("no terminals here")
        main, side = pty.openpty()
        command = subprocess.Popen([RUBICON, "debug", EXAMPLE], stdin=side, stdout=side, stderr=side, cwd=ROOT,
                                   env={**os.environ, "NO_COLOR": ""})
        os.close(side)
        os.write(main, b"step\n\nbreak hit\nc\nq\n")
        seen = b""
        try:
            while chunk := os.read(main, 4096):
                seen += chunk
        except OSError:  # the terminal is gone: the command has ended
            pass
        os.close(main)
        self.assertEqual(command.wait(timeout=60), 0)
        self.assertIn(b"> ", seen)
        self.assertIn(b"\x1b[32maccepted\x1b[0m", seen)
        self.assertIn(b"refused: hook of hoist meets wall", seen)


class Hostile(unittest.TestCase):
    def test_names_with_control_characters_are_shown_without_them(self):
        with tempfile.TemporaryDirectory() as folder:
            trace = os.path.join(folder, "t.jsonl")
            rubicon("run", EXAMPLE, "--trace", trace)
            with open(trace, encoding="utf-8") as file:
                text = file.read()
            with open(trace, "w", encoding="utf-8") as file:
                file.write(text.replace("wall", "wa\\u001b[2Jll\\u202e\\u0007").replace("chain", "ch\\u009bain"))
            told = rubicon("debug", trace, stdin="tasks\nbreak hit\nc\nw\nl\ni\n\x1b[2J\ntask \x1b]0;x\x07\n").stdout
        self.assertIn("wa?[2Jll??", told)
        self.assertEqual([c for c in told if (ord(c) < 32 and c != "\n") or 0x7F <= ord(c) < 0xA0 or c == "\u202e"], [])


if __name__ == "__main__":
    unittest.main()
