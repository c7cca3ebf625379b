"""The listings of the 1995 paper, read from its text where that is at hand, load and run.

Two things are done to them, no more: prose lines become comments, and the closing braces that the print lost in 4.3 are put
back. The paper's text is not part of this project.
"""

import json
import os
import re
import subprocess
import tempfile
import unittest

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PAPER = os.path.join(ROOT, "..", "shared", "papers", "rubicon-behavioral-language-1995.txt")

CODE = re.compile(r"^\s*(var\(|chain\b|which\b|each\b|move_to\b|move_dir\b|transport:|default:|[};]+\s*$)")

FINISHER_BODY = """robot part {{ body b {{ param {p} range(-20, 40) step(0.5); frame trans({frame}); }}
  tool b; behaviour "script.motion"; }}"""
CRANE = """robot crane { time_step 2;
  body mast { shape box(-1, -1, 0, 1, 1, 64); }
  body jib on mast { param theta range(-180, 180) step(5); frame rotz(theta); shape box(-12, -0.8, 64, 52, 0.8, 66); }
  body hook on jib { param x range(4, 50) step(1) start(20); param z range(0, 62) step(1) start(10);
    frame trans(x, 0, z); shape box(-0.5, -0.5, 0, 0.5, 0.5, 1); }
  tool hook; behaviour "script.motion"; }"""
AGENT = """robot agent { time_step 1;
  body truck { param x step(0.5); param y; param z; param theta cyclic step(10);
    rule theta <- theta + theta_s;
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    rule z <- z_c;
    frame trans(x, y, z) * rotz(theta); shape box(-1.2, -0.7, 0, 1.2, 0.7, 2); }
  tool truck; behaviour "script.motion"; }"""


def blocks():
    """The text between the code fences, those that the scan broke line by line joined."""
    with open(PAPER, encoding="utf-8") as file:
        text = file.read()
    section = text[text.index("4.1. Exterior wall"):text.index("5. The RUBICON simulator")]
    parts = [block.strip("\n") for block in re.findall(r"```\n(.*?)```", section, re.S)]
    return parts, re.findall(r"^\$chain(.*)\$$", section, re.M)


def with_comments(listing):
    lines = []
    for line in listing.split("\n"):
        lines.append(line if CODE.match(line) or not line.strip() else "# " + line.strip())
    return "\n".join(lines) + "\n"


class PaperListings(unittest.TestCase):
    def setUp(self):
        if not os.path.exists(PAPER):
            self.skipTest("the paper's text is not at ../shared/papers")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.parts, self.inline = blocks()

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def check(self, robot, script):
        self.write("r.robot", robot)
        return subprocess.run([RUBICON, "check", "--format", "json", "--robot", os.path.join(self.folder, "r.robot"),
                               self.write("script.motion", script)], capture_output=True, text=True, timeout=60)

    def run_script(self, robot, script, plan):
        self.write("r.robot", robot)
        self.write("script.motion", script)
        path = self.write("p.plan", 'plan p { contact 1e-6; robot "r.robot"; ' + plan + " }")
        trace = os.path.join(self.folder, "t.jsonl")
        result = subprocess.run([RUBICON, "run", path, "--trace", trace], capture_output=True, text=True, timeout=60)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        with open(trace, encoding="utf-8") as file:
            return json.loads(file.readlines()[-2])

    def test_wall_finishing(self):
        base = "chain" + self.inline[0].replace("\\", "")
        carriage = [part for part in self.parts if part.startswith("chain{move_to(z")][0]
        end = self.run_script(FINISHER_BODY.format(p="x", frame="x, 0, 20"), base, "start x 2; goal x 8.2;")
        self.assertTrue(end["reached"])
        end = self.run_script(FINISHER_BODY.format(p="z", frame="0, 0, z"), carriage, "start z -1; goal z -12;")
        self.assertTrue(end["reached"])

    def test_crane(self):
        main = with_comments([part for part in self.parts if "var(height) = 30" in part][0])
        wall = "component wall { shape box(12,-1.5,0,28,1.5,50); at rotz(30); } carry box(-2,-2,-4,2,2,0); "
        end = self.run_script(CRANE, main, wall + "start theta 0, x 20, z 6; goal theta 60, x 24.5, z 6;")
        self.assertTrue(end["reached"])
        end = self.run_script(CRANE, main, wall + "start theta 0, x 20, z 6; goal theta 60, x 24.5, z 6; within z 30; "
                                                  "situation transport;")
        self.assertTrue(end["reached"])
        self.assertEqual(end["q"]["z"], 36)

    def test_crane_sub_plan(self):
        at = [i for i, part in enumerate(self.parts) if "try a combination" in part][0]
        sub = with_comments(self.parts[at] + "\n" + self.parts[at + 1])
        pillar = "component pillar { shape box(18.3,-1.5,0,26.4,1.5,63.5); at rotz(40); } carry box(-2,-2,-4,2,2,0); "
        end = self.run_script(CRANE, sub, pillar + "start theta 0, x 22, z 10; goal theta 90, x 22, z 10; within x 7;")
        self.assertEqual((end["q"]["theta"], end["q"]["x"]), (90, 29))

    def mobile(self):
        at = [i for i, part in enumerate(self.parts) if part.startswith("var(theta) = dir")][0]
        return with_comments("\n".join(self.parts[at:]))

    def test_the_lost_braces_of_the_mobile_agent_are_found_each_at_its_place(self):
        listing = self.mobile()
        result = self.check(AGENT, listing)
        self.assertEqual(result.returncode, 2)
        found = [d for file in json.loads(result.stdout) for d in file["diagnostics"] if d["severity"] == 1]
        self.assertEqual([d["code"] for d in found], ["S01"] * 5)
        lines = listing.split("\n")
        for diagnostic in found:
            place = diagnostic["range"]["start"]
            self.assertEqual(lines[place["line"]][place["character"]], ";")
            self.assertIn("this chain is still open", diagnostic["message"])

    def test_mobile_agent(self):
        lines = self.mobile().split("\n")
        found = [d["range"]["start"] for file in json.loads(self.check(AGENT, "\n".join(lines)).stdout)
                 for d in file["diagnostics"]]
        for place in found:
            line = lines[place["line"]]
            lines[place["line"]] = line[:place["character"]] + "}" + line[place["character"]:]
        script = "\n".join(lines)
        block = "component block { shape box(8.48,-3.2,0,12.48,4.3,3); } start x 0, y 0, theta 30; "
        end = self.run_script(AGENT, script, block + "goal x 20, y 0, theta 90; situation transport;")
        self.assertTrue(end["reached"])
        self.assertEqual((end["tries"], end["accepted"]), (140, 80))
        end = self.run_script(AGENT, script, "start x 0, y 0, theta 0; goal x 6, y 3, theta 90;")
        self.assertTrue(end["reached"])


if __name__ == "__main__":
    unittest.main()
