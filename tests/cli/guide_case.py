"""What the tests of guides share: two cars that follow, and the records of their traces."""

import json
import os

from result_case import ResultCase

TRUCKS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "robots", "truck")

CAR = """robot %s {
  body car {
    param x step(0.5) speed(1 m/s) range(-20, 20);
    param y step(0.5) speed(1 m/s) range(-20, 20);
    frame trans(x, y, 0);
    shape box(-0.5, -0.5, 0, 0.5, 0.5, 1);
  }
  tool car;
  behaviour { chain { follow }; }
}
"""


class GuideCase(ResultCase):
    def setUp(self):
        super().setUp()
        for name in ("car", "other"):
            self.write(f"{name}.robot", CAR % name)

    def expect_parking(self, guide):
        """A guide, in place of `astar`, parks the truck of the case; no turn is narrower than its radius. Random places lie
        close enough to each other only on the site, not in all of the truck's range."""
        with open(os.path.join(TRUCKS, "steered_truck.robot"), encoding="utf-8") as file:
            self.write("truck.robot", file.read().replace("range(-100, 100)", "range(-20, 20)", 1).replace("range(-100, 100)", "range(-7, 9)", 1))
        with open(os.path.join(TRUCKS, "cases", "park_in_a_bay", "site.plan"), encoding="utf-8") as file:
            self.run_plan(file.read().replace("../../steered_truck.robot", "truck.robot").replace("astar { step 10;", guide))
        plan, = self.records("guide")
        self.assertIn(plan["kind"], guide.replace('"', ""))
        for value, wanted in zip(plan["way"][-3:], (0, -5, 90)):
            self.assertAlmostEqual(value, wanted, 6)

        def narrower(result):
            result.records[0]["guides"][0]["turn_radius"] = 8

        self.assertIn("narrower than its radius of 8 m", self.faults_of(narrower))

    def records(self, *types):
        return [record for record in self.all_records() if record["type"] in types]

    def all_records(self):
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            return [json.loads(line) for line in file]
