"""Runs every example of docs/language.md with the real command and compares it with the line `# =>` at its end.

Blocks: ```robot declares a machine; ```motion runs a script on one of them (its attributes give the short plan);
```plan runs a plan; ```csv is a file beside it; ```motion-error gives exactly one diagnostic. A `# =>` line lists, separated by commas: the status
of the motion, reached or short, `tries N`, `t SECONDS`, `var(name) VALUE`, or `parameter VALUE` at the end.
"""

import json
import os
import re
import shlex
import subprocess
import tempfile
import unittest

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BLOCK = re.compile(r"^```(\w[\w-]*)([^\n]*)\n(.*?)^```$", re.M | re.S)

# What a crane of a plan example does when the plan says nothing of its own.
PLAN_SCRIPT = """
var(height) = 4;
which {
  place: chain { move_to(z, goal(z)) };
  default:
    chain { move_to(z, max(z, goal(z) + var(height))) };
    chain { move_to(x, min(x, goal(x))) };
    chain { move_to(theta, goal(theta)), move_dir(z, dir(z, max(z))) };
    chain { move_to(x, goal(x)), move_dir(z, dir(z, max(z))) };
    which {
      transport: chain { move_to(z, goal(z) + var(height)) };
      default: chain { move_to(z, goal(z)) };
    };
};
"""


def examples():
    with open(os.path.join(ROOT, "docs", "language.md"), encoding="utf-8") as file:
        text = file.read()
    for match in BLOCK.finditer(text):
        attributes = dict(word.split("=", 1) for word in shlex.split(match.group(2)))
        line = text.count("\n", 0, match.start()) + 1
        yield match.group(1), attributes, match.group(3), line


def expectation(body):
    line = [l for l in body.splitlines() if l.startswith("# =>")]
    return line[-1][len("# =>"):].strip() if line else None


class LanguageExamples(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        for kind, attributes, body, _ in examples():
            if kind == "csv":
                self.write(attributes["file"], body)
            if kind == "robot":
                self.write(re.search(r"robot (\w+)", body).group(1) + ".robot", body)

    def write(self, name, text):
        path = os.path.join(self.folder.name, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def run_command(self, *arguments):
        return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=60)

    def trace(self, plan, context):
        result = self.run_command("run", plan, "--format", "json", "--trace", plan + ".jsonl")
        self.assertIn(result.returncode, (0, 1), context + result.stderr)
        with open(plan + ".jsonl", encoding="utf-8") as file:
            records = [json.loads(line) for line in file]
        return result, [r for r in records if r["type"] == "end"]

    def compare(self, end, expected, context):
        for item in expected.split(","):
            words = item.strip().rsplit(" ", 1)
            if words == ["reached"]:
                self.assertTrue(end["reached"], context)
            elif words == ["short"]:
                self.assertFalse(end["reached"], context)
            elif len(words) == 1:
                self.assertEqual(end["status"], words[0], context)
            else:
                name, value = words[0], float(words[1])
                if name == "tries":
                    found = end["tries"]
                elif name == "t":
                    found = end["t"]
                elif name.startswith("var("):
                    found = end["vars"][name[4:-1]]
                else:
                    found = end["q"][name]
                self.assertAlmostEqual(found, value, delta=1e-6, msg=context + name)

    def test_motion_examples(self):
        count = 0
        for kind, attributes, body, line in examples():
            if kind != "motion":
                continue
            count += 1
            context = f"docs/language.md:{line}: "
            expected = expectation(body)
            self.assertIsNotNone(expected, context + "the example has no '# =>' line")
            self.write("script.motion", body)
            plan = "plan example {\n"
            plan += f"  contact {attributes.get('contact', '1 mm')};\n"
            plan += f"  robot \"{attributes['robot']}.robot\";\n"
            plan += f"  {attributes.get('site', '')}\n"
            plan += f"  start {attributes['start']};\n"
            for via in attributes.get("via", "").split(";"):
                plan += f"  via {via};\n" if via.strip() else ""
            plan += f"  goal {attributes['goal']};\n"
            for item in ("within", "situation"):
                plan += f"  {item} {attributes[item]};\n" if item in attributes else ""
            _, ends = self.trace(self.write("example.plan", plan + "}\n"), context)
            self.assertEqual(len(ends), 1, context)
            with self.subTest(line=line):
                self.compare(ends[0], expected, context)
        self.assertGreater(count, 25)

    def test_plan_examples(self):
        self.write("script.motion", PLAN_SCRIPT)
        for kind, _, body, line in examples():
            if kind != "plan":
                continue
            context = f"docs/language.md:{line}: "
            result, ends = self.trace(self.write("example.plan", body), context)
            with self.subTest(line=line):
                self.assertEqual(result.returncode, 0, context + result.stdout + result.stderr)
                if "reached" in expectation(body):
                    self.assertTrue(ends[-1]["reached"], context)

    def test_error_examples(self):
        for kind, attributes, body, line in examples():
            if kind != "motion-error":
                continue
            script = self.write("wrong.motion", body)
            robot = os.path.join(self.folder.name, attributes["robot"] + ".robot")
            self.write("script.motion", "chain { move_to(z, goal(z)) };\n")
            result = self.run_command("check", "--robot", robot, script)
            found = [l for l in result.stderr.splitlines() if l.startswith(script + ":")]
            with self.subTest(line=line):
                self.assertEqual(found, [f"{script}:{expectation(body)}"])


if __name__ == "__main__":
    unittest.main()
