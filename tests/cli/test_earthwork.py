"""Digging and hauling: worked examples of the literature, verify, studies, mistakes."""

import csv
import json
import math
import os
import random
import unittest

from result_case import ResultCase, rubicon

RANDOM_PLANS = int(os.environ.get("RUBICON_RANDOM_PLANS", "25"))
CREWS = "crew digger { size %d; cost 40 per h; } crew trucks { size %d; cost %d per h; } crew scale; crew dozer; "


def plan(dig, diggers=1, trucks=4, more="", by="digger"):
    return "plan p { %s task dig_pit { by %s; %s } %s }" % (CREWS % (diggers, trucks, 20 * trucks), by, dig, more)


def rounds(volume="40 m3", load="load trucks takes 7 min;", stages="haul takes 17 min; tip takes 3 min; return takes 13 min;",
           more="bed 1 m3;"):
    return "dig %s { %s %s %s }" % (volume, load, stages, more)


GANTRY = """robot gantry {
  body bridge { param x range(-5, 15) step(0.5) speed(0.5 m/s) start(9); frame trans(x, 0, 0); shape box(-0.1, -1, 6, 0.1, 11, 6.2); }
  body trolley on bridge { param y range(0, 10) step(0.5) speed(0.5 m/s) start(9); frame trans(0, y, 0); shape box(-0.1, -0.1, 5.8, 0.1, 0.1, 6); }
  body hook on trolley { param z range(-3, 5) step(0.25) speed(0.25 m/s) start(3); frame trans(0, 0, z); shape box(-0.1, -0.1, 0, 0.1, 0.1, 0.3); }
  tool hook;
  behaviour { chain { move_to(z, max(z)) }; chain { move_to(x, goal(x)), move_to(y, goal(y)) }; chain { move_to(z, goal(z)) }; }
}
"""


class Earthwork(ResultCase):
    def dig(self, text, sample=()):
        schedule, _ = self.run_plan(text, options=sample)
        task = [each for each in schedule["tasks"] if each["task"] == "dig_pit"][0]
        return task, task["dig"]

    def loads(self):
        with open(os.path.join(self.out, "loads.csv"), encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def test_dump_trucks_of_banks(self):
        text = rounds("1000 m3", "load trucks takes sequence(10 min, 5 min, 5 min, 10 min, 15 min, 10 min, 10 min);",
                      "weigh takes sequence(12 min, 12 min, 12 min, 16 min, 12 min, 16 min) by scale;"
                      "haul takes sequence(60 min, 100 min, 40 min, 40 min, 80 min); tip takes 0 s;", "bed 1 m3; loaded 1; limit %d min;")
        for limit, loader, scale in ((76, 49, 76), (12, 24, 12)):
            task, dig = self.dig(plan(text % limit, 2, 6))
            self.assertEqual(task["duration"], limit * 60)
            load, weigh = dig["queues"]
            self.assertAlmostEqual(load["utilisation"], loader / (2 * limit), 12)
            self.assertAlmostEqual(weigh["utilisation"], scale / limit, 12)

    def test_fuel(self):
        """Trucks burn what they burn at work while they drive, and idle while they queue and are loaded."""
        burns = "fuel 18 l per h idling 4 l per h;", "fuel trucks * 12 l per h idling trucks * 2 l per h price litre;"
        text = "plan p { parameter litre = 1.5 per l; parameter trucks = 4; crew digger { size 1; %s } crew trucks { size 4; %s } task dig_pit { by digger; %s } }" % (
            *burns, rounds())
        # 10 rounds of 40 min, the last truck is loaded at 388 min and tips at 408. On the way back that cuts 6 min of the third's 13, and all of the fourth's.
        schedule, tasks = self.run_plan(text)
        self.assertEqual(tasks["dig_pit"]["duration"], 408 * 60)
        driving = 40 * 20 + 36 * 13 + 13 + 13 + 7
        digger, trucks = (use["fuel"] for use in schedule["resources"])
        self.assertAlmostEqual(digger, (18 * 280 + 4 * 128) / 60, delta=6e-4)
        self.assertAlmostEqual(trucks, (12 * driving + 2 * (4 * 408 - driving)) / 60, delta=6e-4)
        self.assertEqual([use["busy"] for use in schedule["resources"]], [280 * 60, driving * 60 / 4])
        self.assertEqual(schedule["cost_by_kind"]["fuel"], round(1.5 * trucks, 2))
        self.assertAlmostEqual(tasks["dig_pit"]["dig"]["fuel_per_m3"], schedule["fuel"] / 40, places=9)

        # In the nights of the digger they are off, though they have no calendar. 408 min are on 3 days.
        shifts = text.replace("plan p {", 'plan p { start_at "2026-03-02 07:00"; calendar d { mon-fri 07:00-09:30; }').replace("size 1;", "size 1; calendar d;")
        nights, tasks = self.run_plan(shifts)
        self.assertEqual(tasks["dig_pit"]["duration"], 2 * 86400 + 108 * 60)
        self.assertEqual((nights["fuel"], nights["cost"]), (schedule["fuel"], schedule["cost"]))
        self.run_plan(text)

        def end(result):
            return next(record for record in result.records if record["type"] == "task_end")

        self.assertIn("its trucks drive for 78000 s, by its rounds 78060 s", self.faults_of(lambda result: end(result).update(driving=78000)))
        self.assertIn("its trucks are served for 16801 s, by its rounds 16800 s", self.faults_of(lambda result: end(result).update(serving=[16801])))
        # Of drawn durations verify knows bounds.
        drawn = text.replace("17 min", "uniform(14 min, 20 min)").replace("tip takes 3 min", "tip takes exponential(3 min) by dozer").replace(
            "task", "crew dozer { fuel 20 l per h; } task")
        self.run_plan(drawn, options=("--sample", "1:3"))
        for wrong in (1e6, 100):
            self.assertIn(f"its trucks drive for {wrong:g} s, and that is from", self.faults_of(lambda result: end(result).update(driving=wrong)))
        self.assertIn("trucks are served for 50000 s by 1 in ", self.faults_of(lambda result: end(result).update(serving=[50000, 100])))
        # A study asks for litres, and varies what they cost.
        self.write("p.plan", text)
        study = rubicon("study", self.write("s.study", 'study s { plan "p.plan"; vary litre 0 per l, 1 per l, 3 per l; ask fuel, cost; }'), "--format", "json")
        study = json.loads(study.stdout)
        names = [question["text"] for question in study["questions"]]
        answers = [dict(zip(names, variant["answers"])) for variant in study["variants"]]
        self.assertEqual({each["fuel"]["mean"] for each in answers}, {schedule["fuel"]})
        self.assertEqual([round(each["cost"]["mean"], 2) for each in answers], [0, round(trucks, 2), round(3 * trucks, 2)])

    def test_a_loader_and_ten_trucks(self):
        text = rounds("100560 m3", "load trucks takes 7 min;", more="bed 60 m3;")
        task, dig = self.dig(plan(text, 1, 10))
        self.assertEqual(task["duration"], 11752 * 60)
        self.assertEqual(dig["loads"], 1676)
        self.assertAlmostEqual(dig["queues"][0]["mean_wait"], 30.01 * 60, delta=0.3)
        self.assertEqual(dig["queues"][0]["longest_wait"], 63 * 60)
        self.assertAlmostEqual(dig["match_factor"], 10 * 7 / 40, 12)
        self.assertEqual(len(self.loads()), 1676)
        _, dig = self.dig(plan(rounds("99960 m3", more="bed 60 m3;"), 1, 10))
        self.assertEqual(dig["loads"], 1666)

    def test_volumes_by_bed_bucket_and_mass(self):
        text = rounds("100 m3", "load trucks; pass takes 20 s;",
                      more="swell 0.25; bed 12.5 m3; bucket 2.5 m3; fill_factor 0.8;")
        _, dig = self.dig(plan(text))
        self.assertEqual((dig["load"], dig["loads"], dig["passes"]), (10, 10, 70))  # 7 passes of 1.6 m3 for 10
        self.assertEqual(dig["mean_loading"], 140)
        _, dig = self.dig(plan(text.replace("fill_factor 0.8;", "fill_factor 0.8; payload 9 t; density 1.8 t per m3;")))
        self.assertEqual((dig["load"], dig["loads"]), (5, 20))

    def test_money_shifts_and_links(self):
        text = "start_at \"2026-05-04 07:00\"; calendar day { mon-fri 07:00-12:00, 13:00-16:00; } crew digger { calendar day; cost 100 per h; } " \
               "crew trucks { size 3; cost 60 per h; calendar day; } task dig_pit { by digger; %s } task after_it { takes 1 h; after dig_pit; }" % (
                   rounds("30 m3", "load trucks takes 20 min;", "haul takes 20 min; tip takes 0 s; return takes 20 min;"))
        task, dig = self.dig("plan p { %s }" % text)
        self.assertEqual(dig["working"], 30 * 1200 + 1200)
        self.assertEqual(task["start"] + task["duration"], 24 * 3600 + 2 * 3600 + 20 * 60)  # 8 h on the first day
        self.assertEqual(task["waited"]["shift"], task["duration"] - dig["working"])
        self.assertAlmostEqual(dig["cost_per_m3"], 160 * dig["working"] / 3600 / 30, 3)

    def test_draws_are_of_their_place_and_verified(self):
        text = plan(rounds("200 m3", "load trucks takes exponential(4 min);",
                           "haul takes gamma(10 min, 3 min); tip takes 1 min by dozer; return takes uniform(5 min, 9 min);"))
        _, means = self.dig(text)
        self.assertIn("with chance queues are longer", self.run_result.stdout)
        _, first = self.dig(text, ("--sample", "3:5"))
        first_loads = self.loads()
        self.assertNotIn("with chance", self.run_result.stdout)
        self.dig(text.replace("size 4;", "size 5;"), ("--sample", "3:5"))
        more_loads = self.loads()
        took = lambda loads: [float(each["loaded"]) - float(each["began"]) for each in sorted(loads, key=lambda e: int(e["load"]))]
        for one, other in zip(took(first_loads), took(more_loads)):
            self.assertAlmostEqual(one, other, 2)
        self.assertNotEqual(means["working"], first["working"])

    def test_random_fleets_are_verified(self):
        chance = random.Random(16)
        for _ in range(RANDOM_PLANS):
            seconds = lambda: "%d s" % chance.randrange(10, 900)
            some = lambda: chance.choice((seconds(), "sequence(%s, %s, %s)" % (seconds(), seconds(), seconds())))
            stages = "haul takes %s;" % some()
            stages += chance.choice(("", " weigh takes %s by scale;" % some()))
            stages += " tip takes %s%s;" % (some(), chance.choice(("", " by dozer")))
            stages += chance.choice(("", " return takes %s;" % some()))
            load = chance.choice(("load trucks takes %s;" % some(), "load trucks; bucket 1.1 m3; pass takes %s;" % some()))
            trucks = chance.randrange(1, 9)
            more = "bed %.2f m3; swell %.2f; efficiency %.2f;" % (chance.uniform(1, 20), chance.uniform(0, 0.5), chance.uniform(0.5, 1))
            more += chance.choice(("", " loaded %d;" % chance.randrange(0, trucks + 1)))
            more += chance.choice(("", "", " limit %d s;" % chance.randrange(60, 30000)))
            text = plan(rounds("%.3f m3" % chance.uniform(5, 300), load, stages, more), chance.randrange(1, 4), trucks,
                        "crew second { size 2; }", chance.choice(("digger", "digger, second")))
            text = text.replace("; cost", "; fuel %d l per h idling 3 l per h price 1.5 per l; cost" % chance.randrange(3, 60))
            text = text.replace("crew dozer;", "crew dozer { fuel 30 l per h idling 4.25 l per h; }")
            self.dig(text)  # run_plan has it verified

    def test_verify_finds_other_rounds(self):
        text = plan(rounds("40 m3"))
        self.dig(text)
        path = os.path.join(self.out, "trace.jsonl")
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines(keepends=True)
        header = json.loads(lines[0])
        for change in ({"trucks": 3}, {"loads": 39}, {"tipped": 39_000_000_000}, {"time": header["tasks"][0]["dig"]["time"] - 60},
                       {"efficiency": 0.9}, {"load": 500_000_000}):
            other = json.loads(lines[0])
            other["tasks"][0]["dig"].update(change)
            with open(path, "w", encoding="utf-8") as file:
                file.write(json.dumps(other) + "\n" + "".join(lines[1:]))
            found = rubicon("verify", self.out)
            self.assertEqual(found.returncode, 1, change)
            self.assertIn("dig: ", found.stdout, change)

    def test_a_study_finds_the_cheapest_fleet(self):
        self.write("p.plan", plan(rounds("400 m3", "load trucks takes exponential(2.4 min);", "haul takes exponential(10 min); tip takes 0 s;",
                                         "bed 1 m3;")).replace("plan p {", "plan p { parameter n = 4;").replace(
                                             "size 4; cost 80 per h", "size n; cost n * 20 per h"))
        path = self.write("s.study", "study s { plan \"p.plan\"; vary n 1 to 8; runs 30; ask unit_cost(dig_pit), production(dig_pit); "
                                     "choose least mean(unit_cost(dig_pit)); }")
        found = rubicon("study", path, "--format", "json")
        self.assertEqual(found.returncode, 0, found.stderr)
        self.assertRegex(json.loads(found.stdout)["choice"]["text"] if "text" in json.loads(found.stdout).get("choice", {}) else found.stdout,
                         r"(?s)n.{0,8}[45]")
        wrong = self.write("w.study", "study s { plan \"p.plan\"; vary n 1 to 2; ask production(dig_pot); }")
        self.assertIn("did you mean dig_pit?", rubicon("study", wrong).stderr)

    def pit(self, dig="dig ground to box(3, 3, -1, 7, 7, 1)", more="", earth="height 0 m; stands 60 deg;", after="after dig_pit;"):
        self.write("gantry.robot", GANTRY)
        return ("plan p { %s earth ground { grid 40, 40; cell 0.25 m; %s } robot gantry \"gantry.robot\";"
                "component footing { shape box(-0.5, -0.5, 0, 0.5, 0.5, 0.5); at trans(9, 9, 0); grip trans(0, 0, 0.5); }"
                "task dig_pit { by digger; %s { load trucks takes 2 min; bed 8 m3; haul takes 5 min; tip takes 1 min; } }"
                "task place { by gantry; move footing to trans(5, 5, -1); %s } %s }" % (CREWS % (1, 2, 40), earth, dig, after, more))

    def test_soil_is_in_the_way_until_it_is_dug(self):
        schedule, tasks = self.run_plan(self.pit())
        dig = tasks["dig_pit"]["dig"]
        # 4 x 4 m, 1 m deep; slopes of 60 degrees round it, by cells of 0.25 m.
        run = 1 / math.tan(math.radians(60))
        self.assertAlmostEqual(dig["volume"], 16 + 16 * run / 2 + math.pi * run * run / 3, delta=0.6)
        self.assertEqual(tasks["place"]["result"], "done")
        _, tasks = self.run_plan(self.pit(after=""), 1)
        self.assertIn("footing meets dig_pit.soil", tasks["place"]["reason"])
        _, tasks = self.run_plan(self.pit("dig ground to box(3, 3, -0.75, 7, 7, 1)"), 1)
        self.assertIn("footing meets ground", tasks["place"]["reason"])

    def test_a_round_pit(self):
        # Its outline is no more than half a millimetre inside the circle.
        text = self.pit("dig ground to cylinder(4.8, -1, 1)", earth="height 0 m; stands 90 deg; at trans(-5, -5, 0);", after="")
        _, tasks = self.run_plan(text.replace("grid 40, 40; cell 0.25 m", "grid 200, 200; cell 0.05 m"), None)
        middles = [(i + 0.5) * 0.05 - 5 for i in range(200)]
        least, most = (sum(math.hypot(x, y) < radius for x in middles for y in middles) * 0.0025 for radius in (4.7995, 4.8))
        self.assertGreaterEqual(tasks["dig_pit"]["dig"]["volume"], least - 1e-9)
        self.assertLessEqual(tasks["dig_pit"]["dig"]["volume"], most + 1e-9)

    def test_pits_that_meet_share_the_soil(self):
        deeper = "task deeper { by digger; %s dig ground to box(4, 4, -2, 6, 6, 1) { load trucks takes 2 min; bed 8 m3; tip takes 1 min; } }"
        # Nobody digs under what stands.
        _, tasks = self.run_plan(self.pit(more=deeper % "after dig_pit;"), 1)
        self.assertIn("without it footing does not stand", tasks["deeper"]["reason"])
        _, tasks = self.run_plan(self.pit(more=deeper % "after dig_pit;", after="after deeper;"), 1)
        both = tasks["dig_pit"]["dig"]["volume"] + tasks["deeper"]["dig"]["volume"]
        _, tasks = self.run_plan(self.pit("dig ground to box(4, 4, -2, 6, 6, 1)"), 1)
        alone = tasks["dig_pit"]["dig"]["volume"]
        self.assertGreater(both, alone)
        path = self.write("p.plan", self.pit(more=deeper % ""))
        checked = rubicon("check", path)
        self.assertEqual(checked.returncode, 2)
        self.assertIn("'deeper' digs where 'dig_pit' digs, and does not come after it", checked.stderr)

    def test_nobody_digs_under_a_machine(self):
        crane = ("robot crane { body mast { shape box(-0.5, -0.5, 0, 0.5, 0.5, 3); } body jib on mast { param theta range(-90, 90) step(5) speed(10 deg/s);"
                 "frame rotz(theta); shape box(0.6, -0.1, 2.6, 2, 0.1, 2.8); } tool jib; behaviour { chain { move_to(theta, goal(theta)) } } }")
        self.write("crane.robot", crane)
        stands = "robot crane \"crane.robot\" at trans(%s, 0);"
        for place, result in (("3.5, 3.5", "rejected"), ("2.8, 5", "rejected"), ("1.5, 5", "done")):
            _, tasks = self.run_plan(self.pit(more=stands % place), None)
            self.assertEqual(tasks["dig_pit"]["result"], result, place)
            if result == "rejected":
                self.assertIn("dig_pit.soil cannot be taken away: crane stands on it", tasks["dig_pit"]["reason"])

    def test_heights_from_a_file(self):
        self.write("heights.csv", "# m\n" + "\n".join(", ".join("%.1f" % (row * 0.05) for _ in range(40)) for row in range(39, -1, -1)))
        _, tasks = self.run_plan(self.pit("dig ground to box(3, 3, -1, 7, 7, 3)", earth="height from \"heights.csv\"; stands 90 deg;", after="after dig_pit;"), None)
        # Rows 12 to 27 of 0.0, 0.05, ... as 0.0, 0.1, 0.1 (or 0.2), ...: what the file says, in whole mm.
        heights = [round(float("%.1f" % (row * 0.05)) * 1000) for row in range(12, 28)]
        self.assertAlmostEqual(tasks["dig_pit"]["dig"]["volume"], sum((h + 1000) * 16 * 0.0625 / 1000 for h in heights), 9)
        self.write("heights.csv", "1, 2, 3\n")
        checked = rubicon("check", self.write("p.plan", self.pit(earth="height from \"heights.csv\"; stands 90 deg;")))
        self.assertEqual(checked.returncode, 2)
        self.assertIn("line 1: expected 40 heights, found 3", checked.stderr)

    def test_verify_finds_soil_that_was_not_hauled(self):
        self.run_plan(self.pit())
        path = os.path.join(self.out, "trace.jsonl")
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines(keepends=True)
        header = json.loads(lines[0])
        soil = [each for each in header["components"] if each["name"] == "dig_pit.soil"][0]
        soil["shapes"] = soil["shapes"][1:]
        with open(path, "w", encoding="utf-8") as file:
            file.write(json.dumps(header) + "\n" + "".join(lines[1:]))
        found = rubicon("verify", self.out)
        self.assertEqual(found.returncode, 1)
        self.assertIn("not the soil that it takes away", found.stdout)

    def test_mistakes_are_told_at_their_places(self):
        fine = rounds()
        for text, message in (
                (plan(fine.replace("40 m3", "0 m3")), "expected a volume above 0"),
                (plan(fine.replace("40 m3", "40 t")), "expected a volume above 0"),
                (plan(fine.replace("40 m3", "1e9 m3")), "loads; a task has up to"),
                (plan(fine.replace("load trucks takes 7 min;", "")), "does not say who hauls"),
                (plan(fine.replace("takes 7 min", "")), "how long loading takes"),
                (plan(fine.replace("haul", "pass")), "expected one of them"),
                (plan(fine.replace("tip", "dump")), "the trucks never tip"),
                (plan(fine.replace("bed 1 m3;", "")), "how much a truck takes"),
                (plan(fine.replace("bed 1 m3;", "payload 9 t;")), "needs the density"),
                (plan(fine.replace("bed 1 m3;", "bed 1 m3; bucket 1 m3;")), "bucket needs"),
                (plan(fine.replace("bed 1 m3;", "bed 1 m3; swell -0.1;")), "swell cannot be negative"),
                (plan(fine.replace("bed 1 m3;", "bed 1 m3; efficiency 0;")), "efficiency must be between"),
                (plan(fine.replace("bed 1 m3;", "bed 1 m3; loaded 5;")), "5 trucks are loaded"),
                (plan(fine.replace("bed 1 m3;", "bed 1 m3; loaded 1.5;")), "whole number of trucks"),
                (plan(fine.replace("bed 1 m3;", "bed 1 m3; bed 2 m3;")), "bed is given twice"),
                (plan(fine.replace("3 min;", "3 min by trucks;")), "does something else in this task"),
                (plan(fine.replace("3 min;", "3 min by dozzer;")), "did you mean dozer?"),
                (plan(fine.replace("load trucks", "load trucs")), "did you mean trucks?"),
                (plan(fine, by="trucks"), "digs and hauls"),
                (plan(fine + "takes 3 min;"), "no takes beside dig"),
                (plan(fine + fine), "dig is given twice"),
                (plan(fine.replace("17 min", "3 years")), "3 years"),
                (plan(fine.replace("7 min", "0 s").replace("17 min", "0 s").replace("3 min", "0 s").replace("13 min", "0 s").replace("10 s", "0 s")),
                 "takes time"),
                (plan(fine.replace("17 min", "1e8 s")), "longer than 1e8 s"),
                (plan(fine.replace("haul takes", "haul")), "haul"),
                ("plan p { crew c; task t { by c; takes sequence(1 h, 2 h); } }", "done once"),
                ("plan p { crew trucks; task dig_pit { %s } }" % fine, "nobody digs")):
            path = self.write("p.plan", text)
            checked = rubicon("check", path)
            self.assertEqual(checked.returncode, 2, text)
            self.assertIn(message, checked.stderr, text)


if __name__ == "__main__":
    unittest.main()
