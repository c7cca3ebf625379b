"""What the tests of studies share: a plan with durations that are not certain."""

import os

from result_case import ResultCase

PLAN = """plan house {
  start_at "2026-03-02 08:00";
  currency "EUR";
  parameter floors = 3;
  parameter gang = 2;
  crew masons { size gang; cost 40 per h; }
  crew carpenters { cost 45 per h; }
  for i from 1 to floors {
    task wall[i] { by masons; takes pert(4 h, 6 h, 14 h); when (i > 1) { after slab[i - 1]; } }
    task form[i] { by carpenters; takes triangular(2 h, 3 h, 7 h); after wall[i]; }
    task slab[i] { by masons; needs 2 masons; takes lognormal(5 h, 1.5 h); after form[i]; }
  }
}
"""


class StudyCase(ResultCase):
    def setUp(self):
        super().setUp()
        self.write("house.plan", PLAN)

    def files(self, folder):
        result = {}
        for name in sorted(os.listdir(folder)):
            with open(os.path.join(folder, name), "rb") as file:
                result[name] = file.read()
        return result

    def path_of(self, items, name="s.study"):
        return self.write(name, 'study s { plan "house.plan"; %s }' % items)
