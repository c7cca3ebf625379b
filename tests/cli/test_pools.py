"""Parts of crews, pools, and what all costs: run, its table and files, why; and verify, which finds what is wrong."""

import os
import unittest

import pool_plans
from result_case import ResultCase, rubicon

SHARES = """
plan shares {
  start_at "2026-03-02 07:00"; currency "EUR";
  calendar day { mon-fri 07:00-12:00, 12:30-16:00; }
  crew masons { size 4; cost 200 per h; calendar day; }
  task a { takes 2 h; needs 2 masons; }
  task b { takes 2 h; needs 2 masons; }
  task c { takes 1 h; needs 3 masons; }
  task d { by masons; takes 1 h; }
}
"""

# The same with machines in it, so that nothing is known before: crews for one work, and for a whole task.
SITE = """
plan site {
  start_at "2026-03-02 07:00"; currency "EUR";
  robot cart "ROBOTS/cart.robot" { start x -20, y -12; cost 12.5 per h; }
  crew masons { size 3; cost 100 per h; }
  task go { by cart; go x -12, y -12; within x 0.5, y 0.5; }
  task a { takes 10 min; needs 2 masons; after go; }
  task b { takes 10 min; needs 1 masons; after go; }
  task c { takes 5 min; needs 2 masons; after go; }
}
"""

POOL = """
plan pool {
  robot near "ROBOTS/cart.robot" at trans(0, 0, 0) { start x -20, y 0; cost 30 per h; }
  robot far "ROBOTS/cart.robot" at trans(0, 10, 0) { start x -25, y 0; cost 40 per h; }
  pool carts { of far, near; choose RULE; }
  task one { by carts; go x -10, y 0; within x 0.6, y 0.6; }
  task two { by carts; go x -10, y 0; within x 0.6, y 0.6; after one; }
  task home { by same as one; go x -18, y 0; within x 0.6, y 0.6; after two; }
}
"""

# A box is in the way of the first cart.
NEXT = """
plan next {
  robot a "ROBOTS/cart.robot" at trans(0, 0, 0) { start x -20, y 0; }
  robot b "ROBOTS/cart.robot" at trans(0, 6, 0) { start x -20, y 0; }
  pool carts { of a, b; }
  site box(-15, -3, 0, -14, 3, 2);
  SECOND
  task drive { by carts; go x 0, y 0; within x 0.6, y 0.6; }
  task after_it { by same as drive; go x 5, y 0; within x 0.6, y 0.6; after drive; }
}
"""

# What is kept for `again` is part of what `both` needs, and `again` comes after `both`.
RING = """
plan ring {
  start_at "2026-03-02 07:00";
  crew a; crew b; crew other;
  pool p { of a, b; }
  task both { by all of p; takes 1 h; }
  task one { by p; takes 2 h; priority 1; }
  task two { by p; takes 45 min; priority 1; }
  task again { by same as two; takes 45 min; after both, two; }
  task apart { by other; takes 60 h; }
}
"""

# `stuck` cannot drive through the box, which is known at 3 h, so `again` does not come, for which b was kept.
KEPT = """
plan kept {
  start_at "2026-03-02 07:00";
  robot cart "ROBOTS/cart.robot" { start x -20, y 0; }
  site box(-15, -3, 0, -14, 3, 2);
  crew a; crew b; crew other;
  pool p { of a, b; }
  task long { by a; takes 210 min; priority 1; }
  task two { by p; takes 45 min; priority 1; }
  task early { by other; takes 3 h; }
  task stuck { by cart; go x 0, y 0; within x 0.6, y 0.6; after early; }
  task again { by same as two; takes 45 min; after two, stuck; }
  task next { by p; takes 1 h; }
}
"""

# `two` has 2 of 4; `most` needs 3, and those of `again`, who come after it, are never free for it.
PART = """
plan part {
  crew gang { size 4; } crew b; crew other;
  pool p { of gang, b; }
  task one { by gang; needs 2 gang; takes 2 h; priority 1; }
  task two { by p; needs 2 gang; takes 45 min; priority 1; }
  task most { takes 1 h; needs 3 gang; }
  task again { by same as two; needs 2 gang; takes 45 min; after two, most; }
  task apart { by other; takes 60 h; }
}
"""

# Only at 3 h, when `both` asks, is it known that `again` cannot come, for which a is kept.
LATE = """
  crew a_#; crew b_#; crew other_#; pool p_# { of a_#, b_#; } pool others_# { of other_#; }
  task two_# { by p_#; takes 45 min; priority 1; }
  task gate_# { by others_#; takes 3 h; }
  task both_# { by all of p_#; takes 30 min; after gate_#; priority -1; }
  task again_# { by same as two_#; takes 45 min; after two_#, both_#; }
  task next_# { by a_#; takes 4 h; }
"""

MONEY = """
plan money {
  start_at "2026-03-06 14:00"; currency "EUR"; overhead 333.33 per day;
  calendar long { mon-sat 06:00-20:00; }
  calendar normal { mon-fri 07:00-15:30; }
  crew masons { size 3; cost 100 per h; calendar long; overtime 1.5 outside normal; mobilisation 250.5; }
  crew painters { size 2; cost 33.33 per h; rental 10.01 per day from "2026-03-01" to "2026-03-10"; }
  robot cart "ROBOTS/cart.robot" { start x -20, y -12; cost 12.5 per h; rental 400 per day; mobilisation 1200; }
  component stone { shape box(0, 0, 0, 1, 1, 1); at trans(30, 30, 0); mass 1 t; cost 99.999; }
  task wall { takes 4 h; needs 2 masons; }
  task paint { by painters; takes 100 min; }
  task drive { by cart; go x -12, y -12; within x 0.5, y 0.5; after wall; }
}
"""


class Pools(ResultCase):
    def starts(self, tasks):
        return {name: task["start"] for name, task in tasks.items()}

    def test_a_crew_is_shared_up_to_its_size(self):
        schedule, tasks = self.run_plan(SHARES)
        self.assertEqual(self.starts(tasks), {"a": 0, "b": 0, "c": 7200, "d": 10800})
        self.assertEqual([tasks[name]["cost"] for name in "abcd"], [200, 200, 150, 200])
        masons = schedule["resources"][0]
        self.assertEqual((masons["held"], masons["busy"], masons["cost"]), (13500, 13500, 750))
        self.assertAlmostEqual(masons["utilisation"], 13500 / 14400)
        self.assertEqual(schedule["cost"], 750)

    def test_busy_is_what_it_moves_and_works(self):
        # No crew is named for the 20 minutes: all that hold the task do them.
        text = SITE.split("  task go")[0] + "  task a { by cart, masons; go x -12, y -12; within x 0.5, y 0.5; takes 20 min; }\n}\n"
        schedule, tasks = self.run_plan(text)
        self.assertGreater(tasks["a"]["motion"], 0)
        self.assertEqual([use["busy"] for use in schedule["resources"]], [tasks["a"]["motion"] + 1200, 1200])
        self.assertIn("cart: the time busy is ", self.faults_of(lambda result: result.schedule["resources"][0].update(busy=tasks["a"]["motion"])))

    def test_a_crew_is_shared_where_machines_move(self):
        schedule, tasks = self.run_plan(SITE)
        at = tasks["go"]["start"] + tasks["go"]["duration"]
        self.assertEqual(self.starts(tasks), {"go": 0, "a": at, "b": at, "c": at + 600})
        self.assertAlmostEqual(schedule["resources"][1]["held"], 600 * 2 / 3 + 600 / 3 + 300 * 2 / 3)

    def test_needs_of_who_is_chosen_from_a_pool(self):
        # 1 of a, or 3 of b: never both. Two tasks share a; the third has b, and who comes after it has the same.
        _, tasks = self.run_plan("""plan p {
          crew a { size 2; cost 20 per h; } crew b { size 4; cost 80 per h; } crew c { size 3; cost 30 per h; }
          pool q { of a, b; }
          task t1 { by q; takes 1 h; needs 1 a, 3 b; }
          task t2 { by q; takes 1 h; needs 1 a, 3 b, 2 c; }
          task t3 { by q; takes 1 h; needs 2 a, 3 b; }
          task t4 { by same as t3; takes 1 h; needs 2 a, 1 b; after t3; }
        }""")
        self.assertEqual({name: (task["crew"], task["start"], task["cost"]) for name, task in tasks.items()},
                         {"t1": ("a", 0, 10), "t2": ("a, c", 0, 30), "t3": ("b", 0, 60), "t4": ("b", 3600, 20)})

    def test_verify_finds_an_overdrawn_crew(self):
        for plan in (SHARES, SITE):
            self.run_plan(plan)

            def crew_is_smaller(result):
                result.header["crews"][0]["size"] -= 1

            def task_needs_more(result):
                result.header["tasks"][-3]["needs"]["masons"] += 1

            self.assertIn("people at once, and it has", self.faults_of(crew_is_smaller))
            self.assertIn("people at once, and it has", self.faults_of(task_needs_more))

    def test_verify_finds_another_size_of_a_crew(self):
        self.run_plan(SHARES)

        def size(people):
            return lambda result: result.schedule["resources"][0].update(size=people)

        def no_size(result):
            del result.schedule["resources"][0]["size"]

        for change in (size(3), size(5), no_size):
            self.assertIn("masons: the size is", self.faults_of(change))

    def test_the_nearest_is_chosen(self):
        _, tasks = self.run_plan(POOL.replace("RULE", "nearest"))
        self.assertEqual({name: task["robot"] for name, task in tasks.items()},
                         {"one": "near", "two": "far", "home": "near"})
        self.assertRegex(tasks["one"]["choice"], r"^near of carts: the nearest that is free, 10\.00 m; far 15\.00 m$")
        self.assertEqual(tasks["home"]["choice"], "near of carts: the same as one")
        self.assertIn("near is kept for what has the same as one", tasks["two"]["choice"])
        why = rubicon("why", self.out, "one")
        self.assertIn("near of carts: the nearest that is free", why.stdout, why.stderr)

    def test_of_equally_near_ones_the_first_is_chosen_wherever_they_stand(self):
        for middle in (1, 3.7, 5.3, 7.7):
            for order in ("near, far", "far, near"):
                _, tasks = self.run_plan(f"""plan pool {{
                  robot near "ROBOTS/cart.robot" {{ start x {middle} - 10.1, y 0; }}
                  robot far "ROBOTS/cart.robot" {{ start x {middle} + 10.1, y 0; }}
                  pool carts {{ of {order}; choose nearest; }}
                  task one {{ by carts; go x {middle}, y 0; within x 0.6, y 0.6; }} }}""")
                self.assertEqual(tasks["one"]["robot"], order.split(",")[0], (middle, order))

    def test_the_first_is_chosen(self):
        _, tasks = self.run_plan(POOL.replace("RULE", "first"))
        self.assertEqual([tasks[name]["robot"] for name in ("one", "two", "home")], ["far", "near", "far"])

    def test_the_least_used_is_chosen(self):
        plan = POOL.replace("RULE", "least_used").replace("by same as one", "by carts")
        _, tasks = self.run_plan(plan)
        self.assertEqual([tasks[name]["robot"] for name in ("one", "two")], ["far", "near"])
        self.assertIn("the least used that is free, 0:00:00", tasks["two"]["choice"])

    def test_who_was_rejected_with_one_is_tried_with_the_next(self):
        _, tasks = self.run_plan(NEXT.replace("SECOND", ""))
        self.assertEqual(tasks["drive"]["robot"], "b")
        self.assertIn("a could not: ", tasks["drive"]["choice"])
        self.assertEqual((tasks["after_it"]["robot"], tasks["after_it"]["result"]), ("b", "done"))

    def test_with_none_left_the_cause_of_each_is_said(self):
        _, tasks = self.run_plan(NEXT.replace("SECOND", "site box(-15, 3, 0, -14, 9, 2);"), expected=1)
        self.assertEqual(tasks["drive"]["result"], "rejected")
        self.assertRegex(tasks["drive"]["reason"], r"^a: .+; b: .+")
        self.assertEqual(tasks["after_it"]["result"], "not reached")

    def test_all_of_a_pool(self):
        text = """plan all { crew a { cost 10 per h; } crew b { cost 20 per h; } pool gangs { of a, b; }
                  task one { by gangs; takes 1 h; } task two { by gangs; takes 1 h; }
                  task all { by all of gangs; takes 1 h; } }"""
        _, tasks = self.run_plan(text)
        self.assertEqual(self.starts(tasks), {"one": 0, "two": 0, "all": 3600})
        self.assertEqual([tasks[name]["cost"] for name in ("one", "two", "all")], [10, 20, 30])
        self.assertEqual(tasks["all"]["crew"], "a, b")

    def test_who_waits_for_what_is_kept_for_those_after_it_is_found_at_once(self):
        _, tasks = self.run_plan(RING, expected=1)
        self.assertEqual((tasks["both"]["start"], tasks["both"]["waited"]["resource"]), (7200, 7200))
        self.assertEqual((tasks["again"]["result"], tasks["again"]["start"]), ("rejected", 0))
        self.assertEqual(tasks["again"]["reason"], "tasks wait for each other: both waits for b, which is kept for again; "
                         "again does not start until both has finished")

    def test_a_part_of_a_crew_that_is_kept_is_in_a_ring_too(self):
        _, tasks = self.run_plan(PART, expected=1)
        self.assertEqual((tasks["most"]["start"], tasks["most"]["result"]), (7200, "done"))
        self.assertIn("most waits for gang, which is kept for again", tasks["again"]["reason"])

    def test_nothing_is_kept_for_what_is_not_reached(self):
        _, tasks = self.run_plan(KEPT, expected=1)
        self.assertEqual(tasks["again"]["result"], "not reached")
        self.assertEqual((tasks["next"]["start"], tasks["next"]["waited"]["resource"]), (2700, 2700))

    def test_what_was_kept_in_vain_is_waited_for_as_a_resource(self):
        rings = 51  # the run begins again for 50 of them
        schedule, tasks = self.run_plan("plan late { start_at \"2026-03-02 07:00\";" + "".join(LATE.replace("#", str(i)) for i in range(rings)) + "}",
                                        expected=1)
        waits = [tasks[f"next_{i}"]["waited"] for i in range(rings)]
        self.assertEqual([wait["shift"] for wait in waits], [0] * rings)
        self.assertEqual(sorted(wait["resource"] for wait in waits), [2700] * (rings - 1) + [10800])
        name = schedule["critical"][-1]["task"]
        number = name.split("_")[1]
        self.assertEqual(schedule["critical"][-1]["text"], f"{name} starts when 'a_{number}' is kept for nobody any more, which two_{number} had")

        def shift(result):
            row = next(row for row in result.schedule["tasks"] if row["task"] == name)
            row["waited"].update(resource=2700, shift=8100)

        def other(result):
            step = result.schedule["critical"][-1]
            step["text"] = step["text"].replace("'a_", "'b_")

        self.assertIn("it waits for a shift, and has 2:15:00 of it", self.faults_of(shift))
        self.assertIn("does not lead from the task before it in the critical path", self.faults_of(other))

    def test_what_is_not_done_holds_nothing_up(self):
        """The long form by hand: RUBICON_POOL_PLANS=400."""
        rejected = 0
        for seed in range(int(os.environ.get("RUBICON_POOL_PLANS", "40"))):
            with self.subTest(seed=seed):
                plan = pool_plans.make_tasks(seed)
                starts = {name: task["start"] for name, task in self.run_plan(pool_plans.text_of(plan), expected=None)[1].items() if task["result"] == "done"}
                without = {number for number, *_ in plan[1] if f"t{number}" not in starts}
                if not without:
                    continue
                rejected += 1
                self.assertEqual(self.starts(self.run_plan(pool_plans.text_of(plan, without))[1]), starts)
        self.assertGreater(rejected, 3)

    def test_verify_finds_somebody_who_is_not_in_the_pool(self):
        self.run_plan(POOL.replace("RULE", "nearest"))

        def chosen(task, name):
            def change(result):
                record = next(r for r in result.records if r["type"] == "task_start" and r["task"] == task)
                record["chosen"] = name
            return change

        self.assertIn("'nobody' is no choice of its pools", self.faults_of(chosen("one", "nobody")))
        self.assertIn("the robot is not the one of the plan", self.faults_of(chosen("one", "far")))

        def other(result):
            result.task("home")["same_as"] = "two"

        self.assertIn("it has not far, as two has", self.faults_of(other))
        self.assertIn("'choice' does not name whom", self.faults_of(lambda result: result.schedule["tasks"][0].update(choice="far of carts: the nearest")))

    def test_what_all_costs(self):
        schedule, tasks = self.run_plan(MONEY)
        # Friday 14:00 to 18:00, of it 2.5 h after 15:30; 2 of 3 masons.
        self.assertAlmostEqual(tasks["wall"]["cost"], 4 * 100 * 2 / 3 + 2.5 * 50 * 2 / 3, delta=0.011)
        kinds = schedule["cost_by_kind"]
        self.assertEqual(list(kinds), ["use", "overtime", "rental", "mobilisation", "material", "overhead"])
        self.assertAlmostEqual(kinds["overtime"], 2.5 * 50 * 2 / 3, delta=0.011)
        self.assertEqual(kinds["rental"], 400 + 10 * 10.01)
        self.assertEqual(kinds["mobilisation"], 250.5 + 1200)
        self.assertEqual((kinds["material"], kinds["overhead"]), (0, 333.33))

        def cents(amounts):
            return sum(round(100 * amount) for amount in amounts)

        self.assertEqual(cents(kinds.values()), cents([schedule["cost"]]))
        self.assertEqual(cents(task["cost"] for task in schedule["tasks"]),
                         cents([kinds["use"], kinds["overtime"], kinds["material"]]))
        self.assertEqual(cents(use["cost"] for use in schedule["resources"]),
                         cents(kinds[kind] for kind in ("use", "overtime", "rental", "mobilisation")))
        self.assertRegex(self.run_result.stdout, r"(?m)^rental +500\.10$")
        self.assertRegex(self.run_result.stdout, rf"(?m)^total +{schedule['cost']:.2f}$")

    def test_verify_finds_a_wrong_cost(self):
        self.run_plan(MONEY)

        def change_kind(kind, by):
            def change(result):
                result.schedule["cost_by_kind"][kind] += by
            return change

        for kind in ("use", "overtime", "rental", "mobilisation", "material", "overhead"):
            self.assertIn(f"{kind} costs", self.faults_of(change_kind(kind, 1)))
            self.assertIn("the costs of all kinds add up", self.faults_of(change_kind(kind, 0.01)))

        def drop(kind):
            def change(result):
                amount = result.schedule["cost_by_kind"][kind]
                result.schedule["cost_by_kind"][kind] = 0
                result.schedule["cost"] -= amount
            return change

        for kind in ("overtime", "rental", "mobilisation", "overhead"):
            self.assertIn("the whole costs", self.faults_of(drop(kind)))

        def row(list_name, place, by):
            def change(result):
                result.schedule[list_name][place]["cost"] += by
            return change

        for by in (5, 0.01):
            self.assertIn("the cost", self.faults_of(row("tasks", 0, by)))
            self.assertIn("the cost", self.faults_of(row("resources", 0, by)))

        def no_kinds(result):
            del result.schedule["cost_by_kind"]

        self.assertIn("the cost by kind is missing", self.faults_of(no_kinds))

    def test_material_is_paid_with_the_first_task_that_moves_it(self):
        text = """plan stone {
          currency "EUR"; robot crane "ROBOTS/crane.robot" at trans(-8, 0, 0) { start jib.theta 90, x 4, z 6; }
          component stone { shape box(-1, -1, 0, 1, 1, 0.2); at trans(-8, 6, 0); grip trans(0, 0, 0.8); mass 0.8 t; cost 99.995; }
          component other { shape box(20, 20, 0, 21, 21, 1); mass 0.5 t; cost 5; }
          task set { by crane; move stone to trans(-1.2, 2.2, 0); }
        }"""
        schedule, tasks = self.run_plan(text)
        self.assertEqual((tasks["set"]["cost"], schedule["cost"]), (100, 100))


if __name__ == "__main__":
    unittest.main()
