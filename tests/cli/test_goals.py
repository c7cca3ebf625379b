"""Goals that are met: with all turns where a turn counts, by arms of six axes at any frame in reach; and `line` steps only where it leads."""

import json
import math
import os
import random
import subprocess
import tempfile
import unittest

RUBICON = os.environ["RUBICON"]

SCREW = """robot screw {
  body nut { param theta step(10) range(-1800, 1800); frame trans(0, 0, 0.01 * theta) * rotz(theta); shape box(-0.1, -0.1, 0, 1, 0.1, 0.2); }
  guide way rrt_connect { seed 1; }
  behaviour { chain { %s } }
}
"""
WINCH = """robot winch {
  body drum { param theta step(10) range(0, 1800); frame trans(0, 0, 3) * rotx(theta); shape cylinder(0.2, 0, 0.4); }
  body hook { param z = 2.5 - 0.001 * drum.theta; frame trans(0, 0, z); shape box(-0.1, -0.1, 0, 0.1, 0.1, 0.1); }
  tool hook;
  behaviour { chain { move_to(drum.theta, goal(drum.theta)) } }
}
"""
# A joint that can turn twice round, and nothing that would change by a turn of it.
JOINT = """robot joint {
  body arm { param theta step(10) range(-400, 400); frame rotz(theta); shape box(0, -0.1, 0, 1, 0.1, 0.2); }
  behaviour { chain { move_to(theta, goal(theta)) } }
}
"""
MAST = """robot v {
  body truck {
    param x step(0.5) range(-20, 20); param y range(-20, 20); param theta cyclic step(10);
    rule theta <- theta + theta_s; rule x <- x + x_s * cos(theta) - y_s * sin(theta); rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    frame trans(x, y, 0) * rotz(theta); shape box(-1, -0.6, 0.1, 1, 0.6, 1);
  }
  body mast on truck { param z range(0, 3) step(0.1) speed(0.2 m/s); frame trans(0.8, 0, z); shape box(0, -0.3, 1.2, 0.8, 0.3, 1.5); }
  tool mast;
  behaviour { chain { %s } }
}
"""
ARM = """robot arm {
  body b { param theta range(-170, 170) step(5); frame rotz(theta) * trans(0, 0, 0.5); }
  body u on b { param phi range(-120, 60) step(5); frame roty(phi) * trans(0, 0, 1); }
  body f on u { param phi range(-60, 150) step(5); frame roty(phi) * trans(0.2, 0, 0.9); }
  body w on f { param theta range(-180, 180) step(5); frame rotz(theta); }
  body h on w { param phi range(-120, 120) step(5); frame roty(phi) * trans(0, 0, 0.1); }
  body t on h { param theta range(-180, 180) step(5); frame rotz(theta); }
  tool t;
  behaviour { chain { follow } }
}
"""
# Three joints in a plane, and what carries them.
PLANAR = """robot planar {
  body base { %s }
  body boom on base { param phi range(-150, 150) step(5); frame roty(-phi); }
  body elbow on boom { param phi range(-150, 150) step(5); frame trans(3, 0, 0) * roty(-phi); }
  body hand on elbow { param phi range(-300, 300) step(5); frame trans(2, 0, 0) * roty(-phi); }
  tool hand at trans(1, 0, 0);
  behaviour { chain { %s } }
}
"""
# What one slides forth the other can slide back.
SLIDES = """robot slides {
  body outer { param x range(0, 5) step(0.2); frame trans(x, 0, 1); }
  body inner on outer { param x range(0, 5) step(0.2); frame trans(x, 0, 0); }
  tool inner;
  behaviour { chain { line } }
}
"""
ARM_RANGES = ((-170, 170), (-120, 60), (-60, 150), (-180, 180), (-120, 120), (-180, 180))


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def turn(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    matrix = [[1.0 if i == j else 0.0 for j in range(4)] for i in range(4)]
    i, j = {"y": (2, 0), "z": (0, 1)}[axis]
    matrix[i][i] = matrix[j][j] = c
    matrix[i][j], matrix[j][i] = -s, s
    return matrix


def shift(x, z):
    return [[1, 0, 0, x], [0, 1, 0, 0], [0, 0, 1, z], [0, 0, 0, 1]]


def arm_frame(q):
    """The tool frame of ARM as the language writes it."""
    matrix = turn("z", q[0])
    for each in (shift(0, 0.5), turn("y", q[1]), shift(0, 1), turn("y", q[2]), shift(0.2, 0.9), turn("z", q[3]), turn("y", q[4]), shift(0, 0.1),
                 turn("z", q[5])):
        matrix = product(matrix, each)
    rz = math.degrees(math.atan2(matrix[1][0], matrix[0][0]))
    ry = math.degrees(math.asin(max(-1.0, min(1.0, -matrix[2][0]))))
    rx = math.degrees(math.atan2(matrix[2][1], matrix[2][2]))
    return "trans(%.12g, %.12g, %.12g) * rotz(%.12g) * roty(%.12g) * rotx(%.12g)" % (*(row[3] for row in matrix[:3]), rz, ry, rx)


class Goals(unittest.TestCase):
    def run_plan(self, robot, plan):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("r.robot", robot), ("p.plan", plan)):
                with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                    file.write(text)
            made = subprocess.run([RUBICON, "run", "p.plan", "--trace", "trace.jsonl"], capture_output=True, text=True, timeout=60, cwd=folder)
            self.assertNotEqual(made.returncode, 2, made.stderr)
            with open(os.path.join(folder, "trace.jsonl"), encoding="utf-8") as file:
                tries = [json.loads(line) for line in file if line.startswith('{"type":"try"')]
            return made, (tries[-1]["q"] if tries else {})

    def check_turns(self, robot, expected, plan):
        made, q = self.run_plan(robot, plan)
        self.assertEqual(made.returncode, 0, made.stdout + made.stderr)
        turned = [value for name, value in q.items() if name.endswith("theta")]
        self.assertEqual(len(turned), 1)
        self.assertAlmostEqual(turned[0], expected, 5)

    def test_a_screw_is_turned_as_often_as_the_goal_says(self):
        self.check_turns(SCREW % "move_to(theta, goal(theta))", 1000, 'plan p { robot "r.robot"; goal theta 1000; }')

    def test_a_screw_goes_where_its_nut_shall_be(self):
        self.check_turns(SCREW % "follow", -1200, 'plan p { robot "r.robot"; goal at trans(0, 0, -12) * rotz(-120); }')
        task = "task t { by r; go at trans(0, 0, -12) * rotz(-120); guide way; }"
        self.check_turns(SCREW % "follow", -1200, 'plan p { robot r "r.robot"; support off; budget 1000; %s }' % task)

    def test_a_winch_counts_the_turns_of_its_drum(self):
        self.check_turns(WINCH, 1000, 'plan p { robot "r.robot"; goal drum.theta 1000; }')

    def test_a_joint_goes_the_shorter_way_in_its_range(self):
        self.check_turns(JOINT, 190, 'plan p { robot "r.robot"; start theta 170; goal theta -170; }')

    def test_frames_in_reach_of_six_axes_are_reached(self):
        draws = random.Random(5)
        tasks = ["task t_%d { by r; go at %s; }" % (i, arm_frame([draws.uniform(*each) for each in ARM_RANGES])) for i in range(120)]
        made, _ = self.run_plan(ARM, 'plan p { robot r "r.robot"; support off; budget 100000; %s }' % "\n".join(tasks))
        self.assertNotIn("out of reach", made.stdout)

    def test_what_is_as_far_off_as_within_allows_is_there(self):
        robot = ("robot r { body t { param x step(1) speed(1 m/s) range(-60, 60); frame trans(x, 0, 0); "
                 "shape box(-0.4, -0.4, 0, 0.4, 0.4, 1); } tool t;\n  behaviour { chain { move_to(x, goal(x) - 0.1) }; }\n}")
        for x in (1, 2, 3, 5.3, -2.5, -19.53):
            made, _ = self.run_plan(robot, f'plan p {{ robot r "r.robot"; task t {{ by r; go at trans({x}, 0, 0); within 0.1; }} }}')
            self.assertEqual(made.returncode, 0, made.stdout)

    def test_half_a_step_away_is_no_direction_however_it_is_rounded(self):
        robot = ("robot r { body t { param x step(0.5) speed(1 m/s) range(-60, 60); frame trans(x, 0, 0); "
                 "shape box(-0.4, -0.4, 0, 0.4, 0.4, 1); } tool t;\n  behaviour { chain { move_dir(x, dir(x, goal(x))) }; }\n}")
        for x in (0.1, 0.2, 0.3, 0.7, -3.3, 17.9):
            made, q = self.run_plan(robot, f'plan p {{ robot "r.robot"; start x {x}; goal x {x} + 0.25; within x 0.3; }}')
            self.assertEqual((made.returncode, q), (0, {"x": x}))

    def test_near_decides_by_what_it_names(self):
        # Two configurations: boom -33.69, elbow 90, hand -56.31, and the mirrored one.
        for side in (1, -1):
            for near in (90, 60, -60, -90, -130):
                _, q = self.run_plan(PLANAR % ("frame trans(0, 0, 1);", "follow"), 'plan p { robot "r.robot"; start boom.phi %d, elbow.phi %d; goal at trans(4.60555127546399, 0, 1); near elbow.phi %d; }'
                                     % (-40 * side, 20 * side, near * side))
                self.assertAlmostEqual(q["elbow.phi"], math.copysign(90, near * side), 5, (side, near))

    def test_line_moves_evenly_what_is_more_than_the_tool_needs(self):
        made, q = self.run_plan(PLANAR % ("param x range(-5, 5) step(0.5); frame trans(x, 0, 1);", "line"),
                                'plan p { robot "r.robot"; start x 0, boom.phi 60, elbow.phi -80, hand.phi 20; goal x 1, boom.phi 50, elbow.phi -80, hand.phi 30; within 0.001; }')
        self.assertEqual(made.returncode, 0, made.stdout)
        for name, value in (("x", 1), ("boom.phi", 50), ("elbow.phi", -80), ("hand.phi", 30)):
            self.assertAlmostEqual(q[name], value, 5)
        made, q = self.run_plan(SLIDES, 'plan p { robot "r.robot"; start outer.x 0, inner.x 1; goal outer.x 1, inner.x 0; within 0.001; }')
        self.assertEqual(made.returncode, 0, made.stdout)
        self.assertAlmostEqual(q["outer.x"], 1, 5)

    def test_line_names_the_range_that_ends_it(self):
        robot = """robot r { time_step 1;
          body a1 { param theta step(5) speed(40 deg/s) range(-170, 170); frame rotz(theta); shape box(0, -0.04, -0.04, 0.8, 0.04, 0.04); }
          body a2 on a1 { param theta step(5) speed(30 deg/s) range(-170, 60); frame trans(1, 0, 0) * rotz(theta); shape box(0, -0.04, 0.1, 0.8, 0.04, 0.2); }
          body a3 on a2 { param theta step(5) speed(30 deg/s) range(-170, 170); frame trans(1, 0, 0) * rotz(theta); shape box(0, -0.04, 0.3, 0.2, 0.04, 0.4); }
          tool a3; behaviour { chain { line }; } }"""
        with tempfile.TemporaryDirectory() as folder:
            # Near the range, and at it, the elbow would have to bend beyond 60 degrees.
            for bend in (50, 60):
                for name, text in (("r.robot", robot), ("p.plan", f"""plan p {{ robot "r.robot"; start a1.theta 0, a2.theta {bend}, a3.theta 0;
                        goal a1.theta 60, a2.theta {bend}, a3.theta 0; budget 1000; }}""")):
                    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                        file.write(text)
                subprocess.run([RUBICON, "run", "p.plan", "--trace", "trace.jsonl"], capture_output=True, timeout=60, cwd=folder)
                with open(os.path.join(folder, "trace.jsonl"), encoding="utf-8") as file:
                    tries = [json.loads(line) for line in file if line.startswith('{"type":"try"')]
                self.assertEqual((tries[-1]["ok"], tries[-1]["reason"]), (False, "limit a2.theta"), bend)

    def test_line_leads_nowhere_where_what_it_steps_does_not_move(self):
        made, _ = self.run_plan(MAST % "line", 'plan p { robot "r.robot"; start x 0, y 0, theta 0, z 1; goal x 3; }')
        self.assertEqual(made.returncode, 1)
        self.assertNotIn("livelock", made.stdout)
        made, _ = self.run_plan(MAST % "line, move_to(x, r_goal(x))", 'plan p { robot "r.robot"; start x 0, y 0, theta 0, z 1; goal x 3; }')
        self.assertEqual(made.returncode, 0, made.stdout)


if __name__ == "__main__":
    unittest.main()
