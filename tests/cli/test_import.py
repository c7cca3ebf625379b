"""rubicon import and rubicon export: schedules to plans and back, as users call them."""

import csv
import os
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from datetime import datetime, timedelta
from random import Random

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SAMPLES = os.path.join(ROOT, "tests", "unit", "project_io")
REAL = os.path.join(ROOT, "..", "shared", "data", "schependomlaan", "planning-2015-02-18.mspdi.xml")


def rubicon(*arguments):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=120)


class Import(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content)
        return self.path(name)

    def round_trip(self, schedule):
        """Imports, checks, formats, exports, imports again; the two plans, but for the file's name."""
        plan, back, again = self.path("a.plan"), self.path("b.xml"), self.path("c.plan")
        first = rubicon("import", schedule, "--out", plan)
        self.assertEqual((first.returncode, first.stdout), (0, ""), first.stderr)
        self.assertEqual(rubicon("check", plan).stderr, "")
        self.assertEqual(rubicon("fmt", "--check", plan).returncode, 0)
        out = rubicon("export", plan, "--mspdi", back)
        self.assertEqual((out.returncode, out.stdout, out.stderr), (0, "", ""))
        self.assertEqual(rubicon("import", back, "--out", again).returncode, 0)
        texts = []
        for path, name in ((plan, os.path.basename(schedule)), (again, "b.xml")):
            with open(path, encoding="utf-8") as file:
                texts.append(file.read().replace(f'import "{name}"', "import"))
        self.assertEqual(*texts)
        return first, texts[0]

    def test_microsoft_project_there_and_back(self):
        first, plan = self.round_trip(os.path.join(SAMPLES, "house.xml"))
        self.assertIn("warning: resource 'Beton' is a material", first.stderr)
        self.assertIn("task fundament {", plan)
        root = ElementTree.parse(self.path("b.xml")).getroot()
        space = "{http://schemas.microsoft.com/project}"
        self.assertEqual(root.tag, space + "Project")
        names = [task.findtext(space + "Name") for task in root.find(space + "Tasks")]
        self.assertEqual(names[:3], ["House", "Rohbau", "Fundament"])
        numbers = [task.findtext(space + "OutlineNumber") for task in root.find(space + "Tasks")]
        self.assertEqual(numbers[:4] + numbers[7:9], ["0", "1", "1.1", "1.2", "2", "2.1"])

    def test_primavera_there_and_back(self):
        first, plan = self.round_trip(os.path.join(SAMPLES, "hall.xer"))
        self.assertIn("this text is not UTF-8: it is read as Windows-1252", first.stderr)
        self.assertIn('currency "\u20ac";', plan)

    @unittest.skipUnless(os.path.exists(REAL), "../shared/data/schependomlaan is not there")
    def test_the_apartment_building_there_and_back(self):
        first, plan = self.round_trip(REAL)
        # 114 of the 157 rows are work; plan_begins is one more. The others head or part them.
        self.assertEqual(plan.count("\n  task "), 115)
        self.assertIn("ExtendedAttribute of Task is not taken over (113 more like it)", first.stderr)

    def test_the_plan_is_printed_without_out(self):
        result = rubicon("import", os.path.join(SAMPLES, "house.xml"))
        self.assertEqual(result.returncode, 0)
        self.assertTrue(result.stdout.startswith("plan house_garage {\n"))

    def test_what_cannot_be_read_exits_with_2_and_leaves_the_old_plan(self):
        plan = self.write("old.plan", b"plan old { }\n")
        for name, content, words in (("a.xml", b"<Project>", "a.xml:1:"), ("b.xml", b"<html/>", "found 'html'"),
                                     ("c.txt", b"hello", "expected Microsoft Project XML"), ("d", b"", "found nothing")):
            result = rubicon("import", self.write(name, content), "--out", plan)
            self.assertEqual(result.returncode, 2, name)
            self.assertIn(words, result.stderr)
        result = rubicon("import", self.path("missing.xml"))
        self.assertEqual(result.returncode, 2)
        self.assertIn("there is no such file", result.stderr)
        with open(plan, encoding="utf-8") as file:
            self.assertEqual(file.read(), "plan old { }\n")

    def imported_xer(self, *rows, code=0):
        """The plan and the remarks of a Primavera file with these activities."""
        lines = ["ERMHDR\t8.0", "%T\tPROJECT", "%F\tproj_id\tproj_short_name\tplan_start_date", "%R\t100\tP\t2026-03-02 08:00",
                 "%T\tPROJWBS", "%F\twbs_id\tproj_id\tproj_node_flag\twbs_name\tparent_wbs_id", "%R\t10\t100\tY\tP\t", "%T\tTASK",
                 "%F\ttask_id\tproj_id\twbs_id\ttask_code\ttask_name\ttask_type\ttarget_drtn_hr_cnt\tcstr_type\tcstr_date", *rows, "%E"]
        result = rubicon("import", self.write("a.xer", "\n".join(lines).encode()))
        self.assertEqual(result.returncode, code, result.stderr)
        return result.stdout, result.stderr

    def test_durations_that_cannot_be_read_are_errors(self):
        for hours, words in (("-8", "expected 0 hours or more in column target_drtn_hr_cnt of TASK, found '-8'"),
                             ("7,5", "expected a number in column target_drtn_hr_cnt of TASK, found '7,5'")):
            plan, told = self.imported_xer(f"%R\t1\t100\t10\tA1\tdig\tTT_Task\t{hours}\t\t", code=2)
            self.assertEqual(plan, "")
            self.assertIn("a.xer:10:1: error: " + words, told)
        self.assertIn("hint: the decimal symbol of this file is '.'", told)
        with open(os.path.join(SAMPLES, "house.xml"), encoding="utf-8") as file:
            house = file.read()
        wrong = self.write("house.xml", house.replace("PT72H0M0S", "3 days").encode())
        result = rubicon("import", wrong)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("error: expected a duration such as PT8H0M0S in Duration of Task, found '3 days'", result.stderr)

    def test_rows_that_lack_cells_are_told(self):
        plan, told = self.imported_xer("%R\t1\t100\t10\tA1\tTT_Task\t8\t\t", "%R\t2\t100\t10\tA2\tdig\tTT_Task\t8")
        self.assertIn("a.xer:10:1: warning: this row has 8 cells, its table 9 columns", told)
        self.assertIn("a.xer:10:1: warning: cells are missing before the end of this row: its task_type is '8'; the activity is left out", told)
        self.assertNotIn("tt_task", plan)
        # Without its empty cells at the end a row is whole.
        self.assertIn("task dig", plan)

    def test_a_duration_that_is_too_long_is_told_as_such(self):
        with open(os.path.join(SAMPLES, "house.xml"), encoding="utf-8") as file:
            house = file.read()
        for text, words in (("PT8000000H0M0S", "expected a duration of at most 2777777 h in Duration of Task, found 'PT8000000H0M0S'"),
                            ("PT8", "expected a duration such as PT8H0M0S in Duration of Task, found 'PT8'")):
            changed = re.sub("<Duration>[^<]*<", f"<Duration>{text}<", house, count=1)
            self.assertIn(words, rubicon("import", self.write("house.xml", changed.encode())).stderr)

    def test_a_name_of_what_is_written_is_not_empty(self):
        plan = self.write("p.plan", b"plan p { crew c; task a { by c; takes 1 h; } }")
        for command in (("run", plan, "--out", ""), ("run", plan, "--trace="), ("import", os.path.join(SAMPLES, "house.xml"), "--out", ""),
                        ("export", plan, "--svg", ""), ("study", plan, "--out", "")):
            result = rubicon(*command)
            self.assertEqual(result.returncode, 2, command)
            self.assertIn(command[2].rstrip("="), result.stderr)

    def test_export_of_a_wrong_plan_exits_with_2(self):
        plan = self.write("wrong.plan", b"plan p { task a { takes 1 h; after b; } }")
        result = rubicon("export", plan, "--mspdi", self.path("x.xml"))
        self.assertEqual(result.returncode, 2)
        self.assertIn("wrong.plan:1:", result.stderr)
        self.assertFalse(os.path.exists(self.path("x.xml")))

    def test_export_of_any_plan_to_standard_output(self):
        result = rubicon("export", os.path.join(ROOT, "taskplans", "unit.plan"), "--mspdi", "-")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("warning: the motions of task", result.stderr)
        self.assertIn("<Task>", result.stdout)

    def test_a_full_disk_is_an_error(self):
        schedule = os.path.join(SAMPLES, "house.xml")
        self.assertEqual(rubicon("import", schedule, "--out", "/dev/full").returncode, 2)
        plan = self.path("a.plan")
        rubicon("import", schedule, "--out", plan)
        self.assertEqual(rubicon("export", plan, "--mspdi", "/dev/full").returncode, 2)


DAY = 86400


def schedule_xml(tasks, assignments=(), resources=()):
    """tasks: (hours, [(predecessor, type, lag in hours)], more elements...); assignments: (task, resource); numbers from 1."""
    text = ('<?xml version="1.0" encoding="UTF-8"?><Project xmlns="http://schemas.microsoft.com/project">'
            "<Name>site</Name><StartDate>2026-03-02T08:00:00</StartDate><CalendarUID>1</CalendarUID><Calendars><Calendar>"
            "<UID>1</UID><Name>Site</Name><IsBaseCalendar>1</IsBaseCalendar><BaseCalendarUID>-1</BaseCalendarUID><WeekDays>")
    for day in range(1, 8):
        times = ("<WorkingTimes><WorkingTime><FromTime>08:00:00</FromTime><ToTime>16:00:00</ToTime></WorkingTime>"
                 "</WorkingTimes>" if 1 < day < 7 else "")
        text += f"<WeekDay><DayType>{day}</DayType><DayWorking>{1 if times else 0}</DayWorking>{times}</WeekDay>"
    text += "</WeekDays></Calendar></Calendars><Tasks>"
    for uid, (hours, links, *more) in enumerate(tasks, 1):
        text += (f"<Task><UID>{uid}</UID><ID>{uid}</ID><Name>t{uid}</Name><OutlineLevel>1</OutlineLevel>"
                 f"<Duration>PT{hours}H0M0S</Duration><DurationFormat>5</DurationFormat>")
        for predecessor, kind, lag in links:
            text += (f"<PredecessorLink><PredecessorUID>{predecessor}</PredecessorUID><Type>{kind}</Type>"
                     f"<LinkLag>{lag * 600}</LinkLag><LagFormat>6</LagFormat></PredecessorLink>")
        text += "".join(f"<{key}>{value}</{key}>" for key, value in more) + "</Task>"
    text += "</Tasks><Resources>"
    for uid, name in enumerate(resources, 1):
        name, *more = (name,) if isinstance(name, str) else name
        text += f"<Resource><UID>{uid}</UID><ID>{uid}</ID><Name>{name}</Name><Type>1</Type>"
        text += "".join(f"<{key}>{value}</{key}>" for key, value in more) + "</Resource>"
    text += "</Resources><Assignments>"
    for uid, (task, resource, *units) in enumerate(assignments, 1):
        text += (f"<Assignment><UID>{uid}</UID><TaskUID>{task}</TaskUID><ResourceUID>{resource}</ResourceUID>"
                 f"<Units>{units[0] if units else 1}</Units></Assignment>")
    return (text + "</Assignments></Project>").encode()


def xer_calendar(uid, name, *shifts, days=range(1, 8), default="N"):
    """A row of CALENDAR: these shifts ("08:00|f|12:00") on these days of the week, 1 Sunday."""
    times = "".join(f"(0||{i}(s|{shift})())" for i, shift in enumerate(shifts))
    week = "".join(f"(0||{day}()({times if day in days else ''}))" for day in range(1, 8))
    return (uid, default, name, f"(0||CalendarData()((0||DaysOfWeek()({week}))(0||VIEW(ShowTotal|N)())(0||Exceptions()())))")


def schedule_xer(calendars, tasks, resources=(), work=(), links=(), more="", tables=()):
    """tasks: (calendar, type, name, hours, cells of the columns `more`...); resources: (calendar, name); work: (task, resource);
    links: (predecessor, successor, type, lag in hours); numbers from 1; tables: (name, columns, rows)."""
    tables = (*tables, ("PROJECT", "proj_id clndr_id proj_short_name plan_start_date", [(9, 1, "X", "2026-03-02 08:00")]),
              ("CALENDAR", "clndr_id default_flag clndr_name clndr_data", calendars),
              ("PROJWBS", "wbs_id proj_id proj_node_flag wbs_name", [(90, 9, "Y", "X")]),
              ("TASK", "task_id proj_id wbs_id clndr_id task_type task_name target_drtn_hr_cnt " + more,
               [(i, 9, 90, *task) for i, task in enumerate(tasks, 1)]),
              ("RSRC", "rsrc_id rsrc_type clndr_id rsrc_name", [(i, "RT_Labor", *each) for i, each in enumerate(resources, 1)]),
              ("TASKRSRC", "taskrsrc_id proj_id task_id rsrc_id", [(i, 9, *each) for i, each in enumerate(work, 1)]),
              ("TASKPRED", "proj_id pred_task_id task_id pred_type lag_hr_cnt",
               [(9, *each[:3], each[3] if len(each) > 3 else 0) for each in links]))
    text = "ERMHDR\t19.12\n"
    for name, columns, rows in tables:
        text += f"%T\t{name}\n%F\t" + "\t".join(columns.split()) + "\n"
        text += "".join("%R\t" + "\t".join(map(str, row)) + "\n" for row in rows)
    return (text + "%E\n").encode()


CALENDARS = [xer_calendar(1, "Std", "08:00|f|12:00", "13:00|f|17:00", days=range(2, 7), default="Y"),
             xer_calendar(2, "Always", "00:00|f|00:00"), xer_calendar(3, "Night", "22:00|f|00:00", "00:00|f|06:00", days=range(2, 7))]


def moment(text):
    return f"2026-{text}:00:00"


def stands(start, finish):
    return ("Start", moment(start)), ("Finish", moment(finish))


def fact(start, finish):
    return ("ActualStart", moment(start)), ("ActualFinish", moment(finish)), *stands(start, finish)


class Dates(unittest.TestCase):
    """A run of an imported schedule has the dates of the schedule's own program."""

    setUp, path, write, round_trip = Import.setUp, Import.path, Import.write, Import.round_trip

    def dates(self, name, schedule, *options):
        """When each task starts and finishes, by its name; and what the import said."""
        plan = self.path("s.plan")
        done = rubicon("import", self.write(name, schedule), "--out", plan, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        run = rubicon("run", plan, "--format", "csv")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        begin = datetime(2026, 3, 2, 8)
        dates = {}
        for row in csv.DictReader(run.stdout.splitlines()):
            start = begin + timedelta(seconds=float(row["start"]))
            dates[row["task"]] = tuple(str(each)[5:] for each in (start, start + timedelta(seconds=float(row["duration"]))))
        return dates, done.stderr

    def test_primavera_goes_by_the_calendar_of_the_activity_or_of_its_resources(self):
        tasks = [(2, "TT_Task", "pump", 48), (2, "TT_Rsrc", "check", 16), (1, "TT_Task", "paint", 8), (2, "TT_Rsrc", "watch", 16)]
        resources = [(1, "Operator"), (3, "Guard")]
        schedule = schedule_xer(CALENDARS, tasks, resources, [(1, 1), (2, 1), (3, 2)], [(1, 2, "PR_FS")])
        for options in ((), ("--level",)):
            dates, _ = self.dates("a.xer", schedule, *options)
            self.assertEqual(dates["pump"], ("03-02 08:00:00", "03-04 08:00:00"))  # nights are its own, whoever is on it
            self.assertEqual(dates["check"], ("03-04 08:00:00", "03-05 17:00:00"))  # the operator's shifts
            self.assertEqual(dates["paint"], ("03-02 08:00:00", "03-02 17:00:00"))  # none in common with the guard
            self.assertEqual(dates["watch"], ("03-02 08:00:00", "03-03 00:00:00"))  # nobody is on it: its own
        with open(self.path("s.plan"), encoding="utf-8") as file:
            self.assertEqual(file.read().count("  crew operator {"), 1)  # one crew for both, with --level or without
        # The way back knows both kinds, and the calendars of the resources.
        xml, plan = self.round_trip(self.path("a.xer"))
        space = "{http://schemas.microsoft.com/project}"
        root = ElementTree.parse(self.path("b.xml")).getroot()
        self.assertEqual([(each.findtext(space + "CalendarUID"), each.findtext(space + "IgnoreResourceCalendar"))
                          for each in root.iter(space + "Task")], [("2", "1"), ("-1", "0"), ("1", "1"), ("2", "0")])
        self.assertEqual([each.findtext(space + "CalendarUID") for each in root.iter(space + "Resource")], ["1", "3"])


    def test_lags_behind_what_never_stops_run_day_and_night(self):
        tasks = [(2, "TT_Task", "pour", 8), (2, "TT_Task", "heat", 8), (1, "TT_Task", "strip", 8)]
        links = [(1, 2, "PR_FS", 72), (1, 3, "PR_FS", 72)]
        dates, said = self.dates("a.xer", schedule_xer(CALENDARS, tasks, links=links))
        self.assertEqual((dates["heat"][0], dates["strip"][0]), ("03-05 16:00:00", "03-05 16:00:00"))
        self.assertEqual(said, "")
        self.round_trip(self.path("a.xer"))
        for choice, strip in (("rcal_Successor", "03-13"), ("rcal_24Hour", "03-05"), ("rcal_24hour", "03-05"), ("rcal_ProjDefault", "03-13")):
            options = ("SCHEDOPTIONS", "proj_id sched_calendar_on_relationship_lag", [(9, choice)])
            dates, _ = self.dates("a.xer", schedule_xer(CALENDARS, tasks, links=links, tables=[options]))
            self.assertEqual(dates["strip"][0][:5], strip, choice)
        options = ("SCHEDOPTIONS", "proj_id sched_calendar_on_relationship_lag", [(9, "rcal_None")])
        _, said = self.dates("a.xer", schedule_xer(CALENDARS, tasks, links=links, tables=[options]))
        self.assertIn("'rcal_None' names no calendar of lags: they count in that of the predecessor", said)
        always = ("CalendarUID", 2)
        schedule = schedule_xml([(8, [], always), (8, [(1, 1, 72)], always)]).replace(
            b"</Calendars>", b"<Calendar><UID>2</UID><Name>24h</Name><IsBaseCalendar>1</IsBaseCalendar><WeekDays>" + b"".join(
                b"<WeekDay><DayType>%d</DayType><DayWorking>1</DayWorking><WorkingTimes><WorkingTime><FromTime>00:00:00</FromTime>"
                b"<ToTime>00:00:00</ToTime></WorkingTime></WorkingTimes></WeekDay>" % day for day in range(1, 8)) +
            b"</WeekDays></Calendar></Calendars>")
        dates, said = self.dates("s.xml", schedule)
        self.assertEqual((dates["t2"][0], said), ("03-05 16:00:00", ""))
        self.round_trip(self.path("s.xml"))

    def test_numbers_have_the_decimal_symbol_of_the_currency(self):
        header = b"ERMHDR\t19.12\t2026-01-05\tProject\tadmin\tAdmin\tdb\tProject Management\tEUR"
        money = ("CURRTYPE", "curr_id curr_short_name curr_symbol decimal_symbol", [(1, "USD", "$", "."), (2, "EUR", "\u20ac", ",")])
        rates = ("RSRCRATE", "rsrc_rate_id rsrc_id cost_per_qty max_qty_per_hr", [(1, 1, "48,5", "4")])
        around = ("SCHEDOPTIONS", "proj_id sched_calendar_on_relationship_lag", [(9, "rcal_24Hour")])
        tasks = [(1, "TT_Task", "form", "7,5"), (1, "TT_Task", "fix", "22,5"), (1, "TT_Task", "pour", "8")]
        schedule = schedule_xer(CALENDARS, tasks, [(1, "Gang")], links=[(1, 2, "PR_FS", 0), (2, 3, "PR_FS", "4,5")],
                                tables=[money, rates, around]).replace(b"ERMHDR\t19.12", header)
        dates, said = self.dates("a.xer", schedule)
        self.assertEqual(dates["form"], ("03-02 08:00:00", "03-02 16:30:00"))
        self.assertEqual(dates["fix"], ("03-02 16:30:00", "03-05 15:00:00"))
        self.assertEqual(dates["pour"], ("03-06 08:00:00", "03-06 17:00:00"))  # not before 19:30 on the 5th
        self.assertNotIn("expected a number", said)
        with open(self.path("s.plan"), encoding="utf-8") as file:
            plan = file.read()
        self.assertIn('currency "\u20ac";', plan)
        self.assertIn("cost 194 per h;", plan)

    def test_of_several_rates_the_one_at_the_beginning_counts(self):
        columns = "rsrc_rate_id rsrc_id start_date cost_per_qty max_qty_per_hr"
        rates = [(1, 1, "2026-01-01 00:00", 50, 1), (2, 1, "2027-01-01 00:00", 99, 1), (3, 2, "2027-01-01 00:00", 30, 1),
                 (4, 2, "2026-06-01 00:00", 20, 1), (5, 3, "2025-01-01 00:00", 8, 1), (6, 3, "2026-02-01 00:00", 9, 1)]
        schedule = schedule_xer(CALENDARS, [(1, "TT_Task", "dig", 8)], [(1, "A"), (1, "B"), (1, "C")], tables=[("RSRCRATE", columns, rates)])
        done = rubicon("import", self.write("a.xer", schedule))
        self.assertEqual(re.findall("cost ([0-9.]+) per h", done.stdout), ["50", "20", "9"])
        self.assertIn("resource 'A' has several rates: the one at the beginning of the project is taken for all of it (2 more like it)", done.stderr)

    # By the project's calendar work is from 8:00 to 16:00, Monday to Friday; 2026-03-02 is a Monday.
    BEGUN = [(16, [], *fact("03-10T08", "03-11T16")), (8, [(1, 1, 0)]),  # 1, 2
             (8, [(4, 1, 0)], ("Manual", 1), *stands("03-20T08", "03-20T16")), (160, []),  # 3, 4
             (16, [], *fact("03-07T09", "03-08T12")), (8, [(5, 1, 0)]),  # 5, 6: on a weekend
             (24, [], ("ActualStart", moment("03-04T12")), *stands("03-04T12", "03-12T12")),  # 7: with a break
             (32, [], *fact("02-26T08", "03-03T16")), (8, [(8, 1, 0), (1, 1, 0)], *fact("03-05T08", "03-05T16"))]  # 8, 9

    def test_what_has_begun_or_is_placed_by_hand_keeps_its_dates(self):
        schedule = schedule_xml(self.BEGUN, [(1, 1), (5, 1), (7, 1)], ["Masons"])
        dates, said = self.dates("s.xml", schedule)
        self.assertEqual([f"{name} {' - '.join(dates[name])}".replace(":00:00", "") for name in sorted(dates)],
                         ["t1 03-10 08 - 03-11 16", "t2 03-12 08 - 03-12 16", "t3 03-20 08 - 03-20 16", "t4 03-02 08 - 03-27 16",
                          "t5 03-07 09 - 03-08 12", "t6 03-09 08 - 03-09 16", "t7 03-04 12 - 03-12 12",
                          "t8 03-02 08 - 03-03 16", "t9 03-05 08 - 03-05 16"])
        self.assertIn("the link from 't4' to 't3' is carried along: 't3' has begun or is placed by hand", said)
        self.assertIn("(1 more like it)", said.split("the link from", 1)[1].split("warning")[0])  # from 1 to 9; that from 8 to 9 holds
        self.assertIn("task 't5' begins or ends when those on it have no shift: in the plan nobody is on it", said)
        self.assertIn("'t8' begins before 2026-03-02 08:00, at which the plan does", said)
        self.assertEqual(said.count("warning:"), 3, said)
        _, plan = self.round_trip(self.path("s.xml"))
        self.assertIn('not_before "2026-03-10 08:00";', plan)
        self.assertIn("after t8;", plan)
        space = "{http://schemas.microsoft.com/project}"

        def task(number):
            return [each for each in ElementTree.parse(self.path("b.xml")).getroot().iter(space + "Task")][number - 1]

        self.assertEqual([(each.findtext(space + "PredecessorUID")) for each in task(9).iter(space + "PredecessorLink")], ["1", "8"])
        self.assertEqual([task(7).findtext(space + key) for key in ("Duration", "ActualStart")], ["PT24H0M0S", moment("03-04T12")])
        # Where somebody moves it in the plan, it goes by that, and by its links again.
        with open(self.path("s.plan"), encoding="utf-8") as file:
            text = file.read()
        moved = self.write("s.plan", text.replace('not_before "2026-03-20 08:00"', 'not_before "2026-03-24 08:00"').encode())
        done = rubicon("export", moved, "--mspdi", self.path("b.xml"))
        self.assertIn("the dates of task 't3' in fact or by hand are left out: the plan says others", done.stderr)
        self.assertEqual([task(3).findtext(space + key) for key in ("Manual", "ConstraintType", "ConstraintDate")],
                         ["0", "4", moment("03-24T08")])
        self.assertEqual(task(3).find(space + "PredecessorLink").findtext(space + "PredecessorUID"), "4")

    def test_actual_dates_that_make_no_sense_are_told(self):
        dates, said = self.dates("s.xml", schedule_xml([
            (8, [], ("ActualStart", "9999-12-31T08:00:00")), (8, [], ("ActualFinish", moment("03-05T08"))),
            (8, [], *fact("03-10T08", "03-09T16"))]))
        self.assertIn("not all actual dates of 't1' can be kept", said)
        self.assertIn("(2 more like it)", said)
        self.assertEqual(dates["t3"], ("03-10 08:00:00", "03-10 16:00:00"))

    def test_a_rate_is_by_the_hour_of_one(self):
        gang = ("Gang", ("MaxUnits", 4), ("StandardRate", 100), ("StandardRateFormat", 3))  # shown by the day
        schedule = self.write("s.xml", schedule_xml([(8, []), (8, [(1, 1, 0)])], [(1, 1, 4), (2, 1, 2)], [gang]))
        plan = self.path("s.plan")
        for options in ((), ("--level",)):
            self.assertEqual(rubicon("import", schedule, "--out", plan, *options).stderr.count("warning:"), 0)
            run = rubicon("run", plan, "--format", "csv")
            self.assertEqual([float(row["cost"]) for row in csv.DictReader(run.stdout.splitlines())], [3200, 1600])
        self.round_trip(schedule)

    def test_what_must_be_before_the_plan_begins_is_told(self):
        _, said = self.dates("s.xml", schedule_xml([(8, [], ("ConstraintType", 2), ("ConstraintDate", "2025-01-01T08:00:00"))]))
        self.assertIn("'t1' must be on 2025-01-01 08:00 there, before the plan begins", said)

    def test_primavera_keeps_what_has_begun_and_begins_nothing_before_the_data_date(self):
        tasks = [(1, "TT_Task", "dug", 16, "2026-03-02 08:00", "2026-03-04 12:00", ""),
                 (1, "TT_Task", "pour", 24, "2026-03-04 13:00", "", "2026-03-12 17:00"),
                 (1, "TT_Task", "fill", 8, "", "", ""), (1, "TT_Task", "build", 8, "", "", ""), (1, "TT_FinMile", "ready", 0, "", "", "")]
        schedule = schedule_xer(CALENDARS, tasks, links=[(1, 3, "PR_FS"), (2, 4, "PR_FS"), (4, 5, "PR_FS")],
                                more="act_start_date act_end_date reend_date").replace(
            b"plan_start_date\n%R\t9\t1\tX\t2026-03-02 08:00", b"plan_start_date\tlast_recalc_date\n%R\t9\t1\tX\t2026-03-02 08:00\t2026-03-10 08:00")
        dates, said = self.dates("a.xer", schedule)
        self.assertEqual(dates["dug"], ("03-02 08:00:00", "03-04 12:00:00"))
        self.assertEqual(dates["pour"], ("03-04 13:00:00", "03-12 17:00:00"))
        self.assertEqual(dates["fill"], ("03-10 08:00:00", "03-10 17:00:00"))  # the data date
        self.assertEqual(dates["build"], ("03-13 08:00:00", "03-13 17:00:00"))
        self.assertEqual(dates["ready"][0], "03-13 17:00:00")
        self.assertEqual(said, "")
        self.round_trip(self.path("a.xer"))


    def test_of_two_constraints_of_primavera_that_which_moves_the_work_holds(self):
        permit, finish = ("2026-03-17 08:00", "CS_MSOA"), ("2026-03-20 17:00", "CS_MEOB")
        tasks = [(1, "TT_Task", "close", 16, *permit, *finish), (1, "TT_Task", "open", 16, *finish, *permit),
                 (1, "TT_Task", "dig", 8, "", "", *permit), (1, "TT_Task", "fill", 8, *finish, "2026-03-18 08:00", "CS_MSOB")]
        schedule = schedule_xer(CALENDARS, tasks, more="cstr_date cstr_type cstr_date2 cstr_type2")
        dates, said = self.dates("a.xer", schedule, "--baseline")
        for name, start in (("close", "03-17"), ("open", "03-17"), ("dig", "03-17"), ("fill", "03-02")):
            self.assertEqual(dates[name][0], start + " 08:00:00", name)
        self.assertNotIn("cstr", said)
        self.assertIn("activity 'fill' has two constraints: that of 2026-03-20 17:00 holds, that of 2026-03-18 08:00 is left out", said)
        # The latest finish is a deadline, and goes out as one.
        with open(self.path("s.plan"), encoding="utf-8") as file:
            self.assertEqual(file.read().count('due "2026-03-20 17:00";'), 2)
        self.round_trip(self.path("a.xer"))
        root = ElementTree.parse(self.path("b.xml")).getroot()
        space = "{http://schemas.microsoft.com/project}"
        found = [[each.findtext(space + name) for name in ("ConstraintType", "ConstraintDate", "Deadline")] for each in root.iter(space + "Task")]
        self.assertEqual(found[0], ["4", "2026-03-17T08:00:00", "2026-03-20T17:00:00"])
        self.assertEqual(found[1], found[0])
        # Nor does a latest finish let anything begin before the data date.
        at = b"plan_start_date\n%R\t9\t1\tX\t2026-03-02 08:00"
        dates, _ = self.dates("a.xer", schedule.replace(at, b"plan_start_date\tlast_recalc_date\n%R\t9\t1\tX\t2026-03-02 08:00\t2026-03-10 08:00"))
        self.assertEqual((dates["fill"][0], dates["open"][0]), ("03-10 08:00:00", "03-17 08:00:00"))


class Levelling(unittest.TestCase):
    """By default links and calendars alone decide, as in the schedule's own program."""

    setUp, path, write, round_trip = Import.setUp, Import.path, Import.write, Import.round_trip

    def starts(self, xml, *options):
        """When each task of the schedule starts, s; and what the import said."""
        schedule, plan = self.write("s.xml", xml), self.path("s.plan")
        done = rubicon("import", schedule, "--out", plan, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        run = rubicon("run", plan, "--format", "csv")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        rows = csv.DictReader(run.stdout.splitlines())
        return {row["task"]: float(row["start"]) for row in rows if row["task"].startswith("t")}, done.stderr

    # Three tasks of one crew that may all begin at once, and one behind the first of them.
    TASKS = [(8, []), (8, []), (8, []), (8, [(1, 1, 0)])]
    WORK = [(1, 1), (2, 1), (3, 1), (4, 1)]

    def test_tasks_do_not_wait_for_a_resource(self):
        starts, said = self.starts(schedule_xml(self.TASKS, self.WORK, ["Masons"]))
        self.assertEqual(starts, {"t1": 0, "t2": 0, "t3": 0, "t4": DAY})
        self.assertEqual(said, "")
        with open(self.path("s.plan"), encoding="utf-8") as file:
            plan = file.read()
        # The fourth never meets the first: they share a crew.
        self.assertIn("// 3 crews: the links let so many of its tasks meet, and none waits\n  crew masons {", plan)
        self.assertEqual([line for line in plan.splitlines() if "    by " in line],
                         ["    by masons;", "    by masons_2;", "    by masons_3;", "    by masons;"])

    def test_with_level_they_do_and_it_is_said(self):
        starts, said = self.starts(schedule_xml(self.TASKS, self.WORK, ["Masons"]), "--level")
        self.assertEqual(starts, {"t1": 0, "t2": DAY, "t3": 2 * DAY, "t4": 3 * DAY})
        self.assertIn("levelled: 3 of 4 tasks start later than their links and calendars let them, ", said)
        self.assertIn("2 d 0 h 0 min", said)
        free, said = self.starts(schedule_xml(self.TASKS, self.WORK[:1], ["Masons"]), "--level")
        self.assertIn("levelled: none of 4 tasks waits", said)
        self.assertEqual(free["t4"], DAY)

    def test_the_resource_comes_back_as_one(self):
        xml = schedule_xml(self.TASKS, self.WORK, ["Masons", "Masons 2"])
        _, plan = self.round_trip(self.write("s.xml", xml))
        self.assertIn("crew_of masons_3", plan)
        root = ElementTree.parse(self.path("b.xml")).getroot()
        space = "{http://schemas.microsoft.com/project}"
        self.assertEqual([each.findtext(space + "Name") for each in root.find(space + "Resources")], ["Masons", "Masons 2"])
        self.assertEqual([(each.findtext(space + "TaskUID"), each.findtext(space + "ResourceUID"))
                          for each in root.find(space + "Assignments")], [(str(task), str(who)) for task, who in self.WORK])

    def test_dates_are_those_without_resources_whatever_the_links(self):
        random = Random(11)
        shared = 0
        for _ in range(12):
            tasks = []
            for i in range(1, 31):
                links = {random.randrange(1, i) for _ in range(random.randrange(3))} if i > 1 else set()
                tasks.append((random.choice((0, 4, 8, 20)), [
                    (link, random.choice((0, 1, 1, 1, 3)), random.choice((0, 0, 0, 8))) for link in sorted(links)]))
            work = [(task, resource) for task in range(1, 31) for resource in (1, 2) if random.random() < 0.6]
            free, _ = self.starts(schedule_xml(tasks))
            loaded, _ = self.starts(schedule_xml(tasks, work, ["Crane", "Masons"]))
            self.assertEqual(free, loaded)
            with open(self.path("s.plan"), encoding="utf-8") as file:
                shared += len(work) - file.read().count("  crew ")
        self.assertGreater(shared, 0)  # crews are shared where links keep tasks apart

    def test_it_goes_with_schedules_only(self):
        model = self.write("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        done = rubicon("import", model, "--unit", "m", "--level")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--level goes with a schedule", done.stderr)


if __name__ == "__main__":
    unittest.main()
