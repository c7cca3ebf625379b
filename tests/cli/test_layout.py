"""Layouts of halls: the plan that is written passes check, run and verify; what cannot be is told."""

import json
import os
import unittest

from result_case import ResultCase, rubicon

HERE = os.path.dirname(os.path.abspath(__file__))
SHIPPED = os.path.join(HERE, "..", "..", "taskplans", "hall.plan")
MOTOR = os.path.join(HERE, "..", "..", "robots", "tow_motor", "tow_motor_on_lanes.robot")
AREA = "area hall { outline (0, 0), (30, 0), (30, 18), (0, 18); column (10, 9), 0.5 m; round_column (20, 9), 0.5 m; shaft (25, 13), (29, 13), (29, 17), (25, 17); }"
NETWORK = "network lanes { class aisle { speed 1 m/s; width 3.6 m; } node gate at trans(-4, 6, 0); node back at trans(-4, 12, 0); }"
FLEET = 'fleet motors { robot "%s"; on lanes; at gate, back; }' % MOTOR
MODULE = "2 m x 1 m"


def hall(*parts):
    return "plan hall {\n" + "\n".join(parts) + "\n}\n"


class Layout(ResultCase):
    def layout(self, text, *options, module=MODULE):
        path = self.write("hall.plan", text)
        return rubicon("layout", path, "--module", module, *options)

    def test_the_plan_runs(self):
        made = os.path.join(self.folder, "made.plan")
        told = self.layout(hall(AREA, NETWORK, FLEET), "--out", made, "--format", "json")
        self.assertEqual(told.returncode, 0, told.stderr)
        best = json.loads(told.stdout)["layouts"][0]
        self.assertEqual(rubicon("fmt", "--check", made).returncode, 0)
        with open(made, encoding="utf-8") as file:
            text = file.read()
        self.assertEqual(text.count("site box("), len(best["modules"]))
        schedule, _ = self.run_plan(text)
        self.assertEqual(len(schedule["tasks"]), 40)
        self.assertEqual({task["result"] for task in schedule["tasks"]}, {"done"})

    def test_aisles_are_as_wide_as_their_class(self):
        area = "area hall { outline (0, 0), (30, 0), (30, 15), (0, 15); }"
        narrow, wide = (NETWORK.replace("width 3.6 m; }", "width %s; } class wide { speed 1 m/s; width %s; }" % each)
                        for each in (("3.6 m", "3 m"), ("2.2 m", "3.6 m")))
        modules = [len(json.loads(self.layout(hall(area, each), "--format", "json").stdout)["layouts"][0]["modules"])
                   for each in (NETWORK, narrow, wide)]
        self.assertGreater(modules[1], modules[0])
        self.assertGreater(modules[2], 1.2 * modules[0])
        made = os.path.join(self.folder, "made.plan")
        self.assertEqual(self.layout(hall(area, narrow, FLEET), "--out", made).returncode, 0)
        with open(made, encoding="utf-8") as file:
            schedule, _ = self.run_plan(file.read())
        self.assertEqual({task["result"] for task in schedule["tasks"]}, {"done"})

    def test_names_and_remarks_are_kept(self):
        made = os.path.join(self.folder, "made.plan")
        text = hall(AREA, "# {the lanes}", NETWORK.replace("gate", "stop_1")) + "# the end }\n"
        told = self.layout(text, "--out", made)
        self.assertEqual(told.returncode, 0, told.stderr)
        with open(made, encoding="utf-8") as file:
            written = file.read()
        for part in ("# {the lanes}", "node stop_1 at", "node stop_1_ at"):
            self.assertEqual(written.count(part), 1, part)
        self.assertTrue(written.endswith("# the end }\n"))

    def test_another_layout_of_the_table(self):
        made = os.path.join(self.folder, "made.plan")
        text = hall(AREA, NETWORK, FLEET)
        layouts = json.loads(self.layout(text, "--format", "json").stdout)["layouts"]
        two = next(i for i, each in enumerate(layouts) if each["lanes"] == "two lanes")
        self.assertEqual(self.layout(text, "--out", made, "--choose", str(two + 1)).returncode, 0)
        with open(made, encoding="utf-8") as file:
            schedule, _ = self.run_plan(file.read())
        self.assertEqual({task["result"] for task in schedule["tasks"]}, {"done"})

    def test_table_csv_and_json_tell_the_same(self):
        text = hall(AREA, NETWORK)
        table, lines, told = (self.layout(text, "--format", each).stdout for each in ("table", "csv", "json"))
        layouts = json.loads(told)["layouts"]
        rows = [line.split(",") for line in lines.splitlines()[1:]]
        self.assertEqual([int(row[1]) for row in rows], [len(each["modules"]) for each in layouts])
        self.assertEqual([float(row[2]) for row in rows], [each["mean_trip"] for each in layouts])
        self.assertEqual(len(table.splitlines()), 3 + len(layouts))
        self.assertEqual(self.layout(text, "--format", "json").stdout, told)
        # Without a fleet there are no tasks, and the plan is still one.
        made = os.path.join(self.folder, "made.plan")
        self.assertEqual(self.layout(text, "--out", made).returncode, 0)
        self.assertEqual(rubicon("check", made).returncode, 0)

    def test_what_cannot_be_is_told(self):
        crossing = NETWORK.replace("node back", "node far at trans(40, 6, 0); lane gate to far; node back")
        for text, module, said in [
                (hall(NETWORK), MODULE, "this one has 0; write area hall"),
                (hall(AREA), MODULE, "this one has 0; write network"),
                (hall(AREA, NETWORK, NETWORK.replace("lanes", "more")), MODULE, "this one has 2"),
                (hall(AREA, crossing), MODULE, "has lanes already"),
                (hall(AREA, NETWORK.replace(" width 3.6 m;", "")), MODULE, "class 'aisle' of network 'lanes' has no width"),
                (hall(AREA.replace("{ out", "{ at trans(0, 0, 1) * rotx(90); out", 1), NETWORK), MODULE, "has a frame"),
                (hall(AREA, NETWORK), "2 m", "--module takes the length along the aisle"),
                (hall(AREA, NETWORK), "2 x 1", "takes a length"),
                (hall(AREA, NETWORK), "2 m x ", "takes a length"),
                (hall(AREA, NETWORK), "0 m x 1 m", "is from 0.05 to 100 m"),
                (hall(AREA, NETWORK), "0.05 m x 0.05 m", "are too small for a hall"),
                (hall(AREA, NETWORK).replace("outline", "outlin"), MODULE, "outline")]:
            with self.subTest(said):
                told = self.layout(text, module=module)
                self.assertEqual((told.returncode, told.stdout), (2, ""), told.stderr)
                self.assertIn(said, told.stderr)

    def test_nothing_fits(self):
        told = self.layout(hall(AREA, NETWORK.replace("3.6 m", "20 m")))
        self.assertEqual(told.returncode, 1)
        self.assertIn("0 of them hold modules", told.stdout)
        self.assertIn("no layout of these sizes fits", told.stderr)

    def test_options(self):
        text = hall(AREA, NETWORK)
        made = os.path.join(self.folder, "made.plan")
        for options, said in [(("--out", made, "--choose", "1000"), "is one of the"), (("--choose", "2"), "--out"),
                              (("--spacing", "3"), "takes a length"), (("--out", os.path.join(self.folder, "hall.plan")), "")]:
            with self.subTest(options):
                told = self.layout(text, *options)
                self.assertEqual(told.returncode, 2)
                self.assertIn(said, told.stderr)
        self.assertFalse(os.path.exists(made))
        with open(os.path.join(self.folder, "hall.plan"), encoding="utf-8") as file:
            self.assertEqual(file.read(), text)

    def test_the_shipped_hall(self):
        told = rubicon("layout", SHIPPED, "--module", "2.7 m x 1.1 m x 2 m")
        self.assertEqual((told.returncode, told.stderr), (0, ""))
        self.assertIn("1 *", told.stdout)


if __name__ == "__main__":
    unittest.main()
