"""Things that keep a timetable: who waits for whom and for how long, against times worked out by hand; and random plans,
judged by verify with its own geometry."""

import json
import os
import random
import struct
import unittest

from result_case import ResultCase, rubicon

RANDOM_PLANS = int(os.environ.get("RUBICON_RANDOM_PLANS", "25"))
CAR = """robot car {
  time_step 1;
  body car {
    param x range(-100, 100) step(1) speed(1 m/s);
    frame trans(x, 0, 0);
    shape box(-0.5, -0.5, 0, 0.5, 0.5, 1);
  }
  tool car;
  behaviour { chain { move_to(x, goal(x)) } }
}
"""
HOIST = """robot hoist {
  body hook {
    param x range(-100, 100) step(1) speed(1 m/s);
    param z range(0, 20) step(1) speed(1 m/s) start(9);
    frame trans(x, 0, z);
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 1);
  }
  tool hook;
  behaviour { chain { move_to(z, 9) }; chain { move_to(x, goal(x)) }; chain { move_to(z, goal(z)) } }
}
"""
# A box of 0.6 m; from 0 s to 12 s it goes by 1 m a second.
VISITOR = "moving visitor { shape box(-0.3, -0.3, 0, 0.3, 0.3, 1.8); %s }"
ACROSS = "path 0 s trans(6, -6, 0), 12 s trans(6, 6, 0);"


def car_plan(visitor, start=0, more=""):
    return """plan p {
  robot left "car.robot" { start x %g; }
  task go { by left; go x 12; }
  %s %s
}
""" % (start, VISITOR % visitor, more)


class Moving(ResultCase):
    def setUp(self):
        super().setUp()
        self.write("car.robot", CAR)
        self.write("hoist.robot", HOIST)

    def records(self, *types):
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            return [record for record in map(json.loads, file) if record["type"] in types]

    def stops(self):
        return [(record["t"], record["by"], record["delay"]) for record in self.records("moving")]

    def test_a_machine_waits_until_it_has_passed(self):
        # In the seconds from 5 and from 6 it is in the lane; the step at 5 would come to within 0.2 m.
        schedule, _ = self.run_plan(car_plan(ACROSS))
        self.assertEqual(schedule["process_time"], 14)
        self.assertEqual([(each["for"], each["from"], each["t"]) for each in self.records("pause")], [("visitor", 5, 7)])
        self.assertEqual(self.stops(), [])
        # What comes before the wait does not make the plan longer.
        self.assertEqual([step["text"] for step in schedule["critical"]], ["go waits on its way for 'visitor'"])

    def test_it_stops_where_a_machine_has_its_next_second(self):
        # At 5 the car stands where it would go; a second later it has gone.
        schedule, _ = self.run_plan(car_plan(ACROSS, start=1))
        self.assertEqual(schedule["process_time"], 11)
        self.assertEqual(self.stops(), [(5, "left.car", 0), (6, "", 1)])
        self.assertEqual(schedule["timetables"], [{"name": "visitor", "stops": 1, "late": 1, "stands_before": ""}])
        self.assertRegex(self.run_result.stdout, r"timetable +stops +late by +stands before\nvisitor +1 +0:00:01 +-\n")

    def animation_of(self, node):
        """Times (s of the plan) and values of a node's channels in the exported film, by path."""
        film = os.path.join(self.folder, "site.glb")
        self.assertEqual(rubicon("export", self.out, "--gltf", film).returncode, 0)
        with open(film, "rb") as file:
            content = file.read()
        (length,) = struct.unpack_from("<I", content, 12)
        document, binary = json.loads(content[20:20 + length]), content[20 + length + 8:]
        (number,) = [i for i, each in enumerate(document["nodes"]) if each["name"] == node]
        (animation,) = document["animations"]

        def floats(accessor):
            accessor = document["accessors"][accessor]
            view = document["bufferViews"][accessor["bufferView"]]
            width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
            start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
            values = struct.unpack_from(f"<{width * accessor['count']}f", binary, start)
            return [values[i:i + width] for i in range(0, len(values), width)]

        curves = {}
        for channel in animation["channels"]:
            if channel["target"]["node"] != number:
                continue
            sampler = animation["samplers"][channel["sampler"]]
            times = [t * animation["extras"]["speed_up"] for (t,) in floats(sampler["input"])]
            curves[channel["target"]["path"]] = list(zip(times, floats(sampler["output"])))
        return curves

    def test_chart_and_animation_show_it_with_its_stops(self):
        self.run_plan(car_plan("path 2 s trans(6, -4, 0), 6 s trans(6, 0, 0), 8 s trans(6, 0, 0), 12 s trans(6, 4, 0);", start=1))
        self.assertEqual(self.stops(), [(5, "left.car", 0), (6, "", 1)])
        curves = self.animation_of("visitor")
        places = [(round(t, 4), [round(v, 5) for v in value]) for t, value in curves["translation"]]
        # From 5 to 6 it stands before the car, 1 m short of the lane; all after that is a second later. The plan ends at 11.
        self.assertEqual(places, [(2, [6, -4, 0]), (5, [6, -1, 0]), (6, [6, -1, 0]), (7, [6, 0, 0]), (9, [6, 0, 0]), (12, [6, 3, 0])])
        scale = [(round(t, 4), value) for t, value in curves["scale"]]
        self.assertEqual(scale, [(0, (0, 0, 0)), (2, (1, 1, 1))])
        chart = os.path.join(self.folder, "chart.svg")
        self.assertEqual(rubicon("export", self.out, "--svg", chart).returncode, 0)
        with open(chart, encoding="utf-8") as file:
            text = file.read()
        self.assertIn(">Timetables<", text)
        self.assertIn("<title>visitor: 1 stop, 0:00:01 late</title>", text)
        self.assertIn(">0:00:01 late<", text)

    def test_a_step_is_tested_over_its_whole_duration(self):
        # One step of 12 s: the visitor would be in it after five.
        self.write("car.robot", CAR.replace("step(1)", "step(12)"))
        schedule, _ = self.run_plan(car_plan(ACROSS))
        self.assertEqual(schedule["process_time"], 19)

    def test_it_comes_when_there_is_room_and_goes(self):
        # It would begin where the car stands until 7 and then drives for two seconds.
        text = car_plan("path 3 s trans(0, 0, 0), 5 s trans(0, 4, 0);", more="task before { takes 7 s; }")
        schedule, _ = self.run_plan(text.replace("go x 12;", "go x 12; after before;"))
        self.assertEqual(schedule["process_time"], 19)
        self.assertEqual(self.stops(), [(3, "left.car", 0), (8, "", 5)])

    def test_what_is_in_something_at_the_beginning_is_told(self):
        inside = "path 0 s trans(20, 0, 0), 9 s trans(20, 9, 0);"
        shelf = "component shelf { shape box(20.2, -1, 0, 21, 1, 2); } robot right \"car.robot\" at trans(0, 0.5, 0) { start x 20; }"
        self.run_plan(car_plan(inside, more=shelf))
        self.assertIn("at the beginning visitor is 100 mm deep in shelf", self.run_result.stderr)
        self.assertIn("at the beginning visitor is 300 mm deep in right.car", self.run_result.stderr)
        self.assertIn("let it begin later than 0 s", self.run_result.stderr)
        # verify finds what the header leaves out.
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            lines = file.readlines()
        header = json.loads(lines[0])
        header["beginning"]["overlaps"] = header["beginning"]["overlaps"][:1]
        with open(os.path.join(self.out, "trace.jsonl"), "w", encoding="utf-8") as file:
            file.writelines([json.dumps(header) + "\n", *lines[1:]])
        done = rubicon("verify", self.out)
        self.assertIn("at the beginning visitor is at least", done.stdout + done.stderr)

    def test_a_second_cause_tells_how_late_it_is_by_then(self):
        # It stands 1 m before the cars, from 3 s on: for the first one, from 4 s on for the second one, until 6 s.
        self.run_plan("""plan p { robot left "car.robot" { start x 3.5; } robot right "car.robot" { start x 1.5; }
  task go { by left; go x 12; } task follow { by right; go x 10; } %s }""" % (VISITOR % "path 0 s trans(6, -4, 0), 8 s trans(6, 4, 0);"))
        self.assertEqual(self.stops(), [(3, "left.car", 0), (4, "right.car", 1), (6, "", 3)])
        self.assertEqual(rubicon("verify", self.out).returncode, 0)

        def with_delay_of_before(result):
            next(record for record in result.records if record["type"] == "moving" and record["by"] == "right.car")["delay"] = 0

        self.assertIn("visitor: it is 1 s late, the trace says 0 s", self.faults_of(with_delay_of_before))

    def test_two_that_face_each_other(self):
        _, tasks = self.run_plan(car_plan("path 0 s trans(12, 0, 0), 12 s trans(0, 0, 0);"), expected=1)
        self.assertEqual(tasks["go"]["result"], "rejected")
        self.assertIn("left (go) waits for visitor: left.car meets visitor, and visitor waits for left.car", tasks["go"]["reason"])

    def test_waiting_for_what_comes_again_is_bounded_by_a_round(self):
        _, tasks = self.run_plan(car_plan("path 0 s trans(6, 0, 0), 5 s trans(6.4, 0, 0), 10 s trans(6, 0, 0); repeat;"), expected=1)
        self.assertIn("left.car meets visitor, which comes by again and again", tasks["go"]["reason"])

    def test_waiting_goes_on_as_long_as_a_machine_moves(self):
        # Rounds of 10 s; the car that stands in its way leaves after 30 s.
        text = """plan p {
  robot left "car.robot";
  robot other "car.robot" at trans(6, 3, 0) * rotz(90);
  moving gate { shape box(-0.3, -0.3, 0, 0.3, 0.3, 1); path 0 s trans(6, 0, 0), 5 s trans(6, 0, 0), 10 s trans(6, 4, 0), 15 s trans(6, 0, 0); repeat; }
  task go { by left; go x 12; }
  task stay { takes 30 s; }
  task leave { by other; go x 20; after stay; }
}
"""
        _, tasks = self.run_plan(text)
        self.assertEqual(tasks["go"]["result"], "done")
        self.assertEqual(self.stops()[0], (7, "other.car", 0))

    def lift(self, people):
        return """plan p {
  robot crane "hoist.robot";
  component crate { shape box(-0.5, -0.5, -1, 0.5, 0.5, 0); at trans(0, 0, 1); mass 500; }
  task move_it { by crane; move crate to trans(10, 0, 1); }
  %s
}
""" % (VISITOR % ("path 0 s trans(5, 0, 0), 40 s trans(5, 0, 0), 60 s trans(5, 9, 0);" + people))

    def test_no_load_hangs_over_people(self):
        schedule, _ = self.run_plan(self.lift(""))
        free = schedule["process_time"]
        schedule, _ = self.run_plan(self.lift("people;"))
        # The crate is 0.2 m before it at 20; the script goes down, ends at 28, and is tried again when the visitor leaves.
        self.assertEqual([(each["from"], each["t"]) for each in self.records("pause")], [(28, 40)])
        self.assertGreater(schedule["process_time"], free)
        hits = {tuple(record["hit"]) for record in self.records("try") if "hit" in record}
        self.assertEqual(hits, {("crate", "the air above visitor")})

    def test_verify_sees_a_load_over_people(self):
        self.run_plan(self.lift("people;"))
        overhead = next(iter(self.records("header")))["movings"][0]["overhead"]
        self.run_plan(self.lift(""))

        def with_people(result):
            result.header["movings"][0]["overhead"] = overhead

        self.assertIn("crate meets the air above visitor", self.faults_of(with_people))

    def test_verify_sees_what_did_not_stop(self):
        self.run_plan(car_plan(ACROSS, start=1))

        def without_stops(result):
            result.records = [record for record in result.records if record["type"] != "moving"]

        self.assertIn("left.car meets visitor", self.faults_of(without_stops))

        def with_other_delay(result):
            next(record for record in result.records if record["type"] == "moving" and not record["by"])["delay"] = 0.5

        self.assertIn("visitor: it is 1 s late, the trace says 0.5 s", self.faults_of(with_other_delay))

    def test_verify_sees_what_went_through_a_wall(self):
        self.run_plan(car_plan(ACROSS))

        def with_wall(result):
            result.header["site"] = [{"type": "box", "pose": [1, 0, 0, 3, 0, 1, 0, 4, 0, 0, 1, 0], "lower": [0, 0, 0], "upper": [9, 0.2, 3]}]

        self.assertIn("visitor meets site", self.faults_of(with_wall))

    def test_standing_things_stop_it(self):
        self.run_plan(car_plan(ACROSS, more="site box(3, 2, 0, 9, 2.2, 3);"))
        # From y = 1 on it would be at the wall within a second.
        self.assertEqual(self.stops(), [(7, "site", 0)])
        self.assertRegex(self.run_result.stdout, r"visitor +1 +0:00:07 +site\n")

    def test_what_is_undone_leaves_no_mark(self):
        self.run_plan(car_plan(ACROSS, start=1))
        alone = self.stops()
        self.run_plan(car_plan(ACROSS, start=1, more='robot other "car.robot" at trans(0, -3, 0); task vain { by other; go x 40; priority 1; }'
                               "component block { shape box(-1, -1, 0, 1, 1, 2); at trans(20, -3, 0); }"), expected=1)
        self.assertEqual([stop for stop in self.stops() if stop[1] != "other.car"][-1][1], "")
        self.assertEqual(alone, [(5, "left.car", 0), (6, "", 1)])

    def test_what_was_undone_lasted_longer_than_the_rest(self):
        # It would go through the car at 36 s. The plan is over at 12 s, but for a task that is undone.
        self.run_plan(car_plan("path 0 s trans(12, -6, 0), 30 s trans(12, -6, 0), 42 s trans(12, 6, 0);",
                               more='robot other "car.robot" at trans(0, -20, 0); task vain { by other; go x 60; } component block { shape box(-1, -1, 0, 1, 1, 2); at trans(50, -20, 0); }'), expected=1)

    def test_a_year_beside_a_machine_writes_nothing(self):
        text = car_plan("path 0 s trans(13.2, -6, 0), 12 s trans(13.2, 6, 0), 24 s trans(13.2, -6, 0); repeat;", more="task long { takes 365 h; after go; }")
        self.run_plan(text)
        self.assertEqual(self.stops(), [])
        self.assertLess(len(self.records("try", "pause", "moving")), 40)

    def test_random_plans(self):
        rng = random.Random(20261124)
        for _ in range(RANDOM_PLANS):
            movings = []
            for name in ("one", "two"):
                time, places = rng.choice((0, 0, 4)), []
                for _ in range(rng.randint(2, 5)):
                    places.append("%g s trans(%g, %g, 0) * rotz(%g)" % (time, rng.uniform(-8, 14), rng.uniform(-8, 8), rng.choice((0, 0, rng.uniform(-80, 80)))))
                    time += rng.choice((2, 5, 9.5, 20))
                repeat = ""
                if rng.random() < 0.6:
                    places.append("%g s %s" % (time, places[0].split(" s ", 1)[1]))
                    repeat = " repeat;"
                movings.append("moving %s { shape box(-1, -0.3, 0, 1, 0.3, 1.8); path %s;%s%s }" % (
                    name, ", ".join(places), repeat, " people;" if rng.random() < 0.3 else ""))
            text = """plan p {
  robot left "car.robot" { park x 0; }
  robot right "car.robot" at trans(6, -6, 0) * rotz(90) { park x 0; }
  %s
  task a { by left; go x 12; } task b { by right; go x 12; } task c { by left; go x -3; after a; }
}
""" % "\n  ".join(movings)
            self.run_plan(text, expected=None)


if __name__ == "__main__":
    unittest.main()
