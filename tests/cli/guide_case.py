"""What the tests of guides share: two cars that follow, and the records of their traces."""

import json
import os

from result_case import ResultCase

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

    def records(self, *types):
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            return [record for record in map(json.loads, file) if record["type"] in types]
