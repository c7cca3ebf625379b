"""rubicon import of robot descriptions: a robot file and its meshes, or exit 2 with the place."""

import os
import subprocess
import tempfile
import unittest

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
REAL = os.path.join(ROOT, "..", "shared", "data", "zx200", "zx200.xacro")

# A cube of 2 x 2 x 2 units about the origin.
CUBE = "".join(f"v {x} {y} {z}\n" for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)) + "".join(
    f"f {face}\n" for face in ("1 2 4", "1 4 3", "5 7 8", "5 8 6", "1 5 6", "1 6 2", "3 4 8", "3 8 7", "1 3 7", "1 7 5",
                               "2 6 8", "2 8 4"))

MACHINE = """<robot name="press" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="stroke" default="0.5"/>
<link name="frame"><collision><geometry><mesh filename="package://press/meshes/cube.obj"/></geometry></collision></link>
<link name="ram"><collision><geometry><mesh filename="package://press/meshes/cube.obj" scale="0.1 0.1 -0.3"/></geometry></collision></link>
<joint name="down" type="prismatic"><parent link="frame"/><child link="ram"/><origin xyz="0 0 3"/><axis xyz="0 0 -1"/>
<limit lower="0" upper="$(arg stroke)" velocity="0.1" effort="1"/></joint>
</robot>
"""


def rubicon(*arguments, cwd=None):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=120, cwd=cwd)


class ImportMachine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write("press/meshes/cube.obj", CUBE)
        self.machine = self.write("press/urdf/press.urdf", MACHINE)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def read(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def import_machine(self, *arguments):
        return rubicon("import", *arguments, "--out", self.path("press.robot"))

    def refused(self, text, *arguments):
        """What is said of a machine that is not imported; nothing is written."""
        before = sorted(os.listdir(self.folder))
        run = self.import_machine(self.write("press/urdf/press.urdf", text), *arguments)
        self.assertEqual((run.returncode, run.stdout), (2, ""), run.stderr)
        self.assertEqual(sorted(os.listdir(self.folder)), before)
        return run.stderr

    def test_a_machine_with_its_meshes_is_checked_formatted_and_moves(self):
        run = self.import_machine(self.machine)
        self.assertEqual((run.returncode, run.stdout), (0, ""), run.stderr)
        self.assertIn("note: package 'press' is taken to be the folder", run.stderr)
        check = rubicon("check", self.path("press.robot"))
        self.assertEqual((check.returncode, check.stderr), (0, ""))
        self.assertEqual(rubicon("fmt", "--check", self.path("press.robot")).returncode, 0)
        self.assertEqual(sorted(os.listdir(self.path("press_meshes"))), ["cube.obj", "cube_scaled.obj"])
        self.assertEqual(self.read("press_meshes/cube.obj"), CUBE)
        plan = self.write("press.plan", 'plan p { robot "press.robot"; goal z 0.5; }')
        moved = rubicon("run", plan)
        self.assertEqual(moved.returncode, 0, moved.stdout + moved.stderr)
        # 3 m up, 0.5 m down, the ram 0.3 m high on each side: it stops above a block of 2.2 m and not above one of 2.1 m.
        for height, code in ((2.1, 0), (2.3, 1)):
            self.write("press.plan", 'plan p { robot "press.robot"; component block { shape box(-0.05, -0.05, 1.2, 0.05, 0.05, '
                       f'{height}); }} goal z 0.5; }}')
            self.assertEqual(rubicon("run", plan).returncode, code, height)

    def test_arguments_packages_and_tool(self):
        package = "press=" + self.path("press")
        run = self.import_machine(self.machine, "--package", package, "--arg", "stroke=0.25", "--tool", "frame")
        self.assertEqual((run.returncode, run.stderr.count("is taken to be")), (0, 0), run.stderr)
        robot = self.read("press.robot")
        self.assertIn("range(0, 0.25)", robot)
        self.assertIn("tool frame;", robot)

    def test_wrong_calls(self):
        for arguments, message in (
                (("--package", "press"), "expected --package NAME=FOLDER, found 'press'"),
                (("--package", "press=/no/folder"), "found '/no/folder'"),
                (("--arg", "=3"), "expected --arg NAME=VALUE, found '=3'"),
                (("--level",), "a machine takes --out, --package, --arg and --tool only"),
                ((self.machine,), "one machine at a time"),
                (("--tool", "rum"), "there is no link 'rum' for --tool; did you mean ram?")):
            run = self.import_machine(self.machine, *arguments)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(message, run.stderr)
        run = rubicon("import", self.machine)
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertIn("2 meshes are to lie beside the robot file; give --out", run.stderr)
        run = rubicon("import", self.write("plan.xml", "<Project/>"), "--tool", "a")
        self.assertEqual(run.returncode, 2)
        self.assertIn("go with a machine", run.stderr)

    def test_without_meshes_it_goes_to_standard_output(self):
        path = self.write("ball.urdf", '<robot name="ball"><link name="a"><collision><geometry><sphere radius="1"/></geometry>'
                          '</collision></link><link name="b"/><joint name="j" type="continuous"><parent link="a"/>'
                          '<child link="b"/><limit velocity="1"/></joint></robot>')
        run = rubicon("import", path)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertTrue(run.stdout.startswith("# Made by rubicon import of ball.urdf.\n"))

    def test_bombs_and_other_mistakes_are_refused_with_their_place(self):
        bomb = '<!DOCTYPE r [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;">]>\n<robot name="&b;"/>'
        self.assertRegex(self.refused(bomb), r"press\.urdf:1:\d+: error: a document type")
        links = '<robot name="r">\n' + "".join(f'<link name="l{i}"/>\n' for i in range(1_000_000)) + "</robot>\n"
        self.assertIn("press.urdf:500001:2: error: expected at most 500000 elements, found more", self.refused(links))
        self.write("press/urdf/a.xacro", MACHINE.split("\n")[0] + '\n<xacro:include filename="b.xacro"/></robot>')
        self.write("press/urdf/b.xacro", MACHINE.split("\n")[0] + '\n\n<xacro:include filename="a.xacro"/></robot>')
        loop = MACHINE.split("\n")[0] + '<xacro:include filename="a.xacro"/></robot>'
        self.assertIn("b.xacro:3:2: error: 'a.xacro' includes itself", self.refused(loop))
        self.assertIn("press.urdf:3:", self.refused(MACHINE.replace("cube.obj", "cub.obj", 1)))

    def test_nothing_outside_of_its_folders_is_read(self):
        self.write("secret.xacro", "<robot><link name='secret'/></robot>")
        for name in ("../../secret.xacro", "file://" + self.path("secret.xacro"), self.path("secret.xacro")):
            text = MACHINE.replace('<link name="ram"', f'<xacro:include filename="{name}"/><link name="ram"')
            self.assertIn("lies outside of", self.refused(text))

    def test_a_mesh_that_cannot_be_read_leaves_nothing(self):
        self.write("press/meshes/cube.obj", "v 0 0 0\n")
        self.assertIn("the robot is not written: 'rubicon check' refuses it", self.refused(MACHINE))

    @unittest.skipUnless(os.path.exists(REAL), f"the machine of this test is not there: {REAL}")
    def test_a_real_excavator(self):
        run = rubicon("import", REAL, "--out", self.path("zx200.robot"))
        self.assertEqual((run.returncode, run.stdout), (0, ""), run.stderr)
        self.assertIn("joint 'swing_joint' has no velocity: 10 deg/s is assumed", run.stderr)
        self.assertIn("<transmission> is not taken over (drives) (3 more like it)", run.stderr)
        check = rubicon("check", self.path("zx200.robot"))
        self.assertEqual((check.returncode, check.stderr), (0, ""))
        self.assertEqual(len(os.listdir(self.path("zx200_meshes"))), 5)
        plan = self.write("dig.plan", 'plan dig { robot "zx200.robot"; start arm_link.phi 100; goal body_link.theta 30, '
                          'boom_link.phi -30, arm_link.phi 60, bucket_link.phi 30; }')
        moved = rubicon("run", plan)
        self.assertEqual(moved.returncode, 0, moved.stdout + moved.stderr)


if __name__ == "__main__":
    unittest.main()
