"""rubicon import --area: floors of drawings (DXF) and of storeys of building models, as users call it."""

import os
import random
import re
import subprocess
import tempfile
import unittest

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
REAL = os.path.join(ROOT, "..", "shared", "data", "schependomlaan")


def rubicon(*arguments, cwd=None):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=120, cwd=cwd)


def line(layer, a, b):
    return ["0", "LINE", "8", layer, "10", a[0], "20", a[1], "30", 0, "11", b[0], "21", b[1], "31", 0]


def lines(layer, *points):
    """A closed line of LINEs."""
    return [text for a, b in zip(points, points[1:] + points[:1]) for text in line(layer, a, b)]


def polyline(layer, *points, closed=True, bulges=()):
    """LWPOLYLINE."""
    texts = ["0", "LWPOLYLINE", "8", layer, "90", len(points), "70", int(closed)]
    for i, (x, y) in enumerate(points):
        texts += ["10", x, "20", y]
        if i < len(bulges) and bulges[i]:
            texts += ["42", bulges[i]]
    return texts


def old_polyline(layer, *points):
    """POLYLINE with VERTEX and SEQEND, as R12 has it."""
    texts = ["0", "POLYLINE", "8", layer, "66", 1, "10", 0, "20", 0, "70", 1]
    for x, y in points:
        texts += ["0", "VERTEX", "8", layer, "10", x, "20", y, "30", 0]
    return texts + ["0", "SEQEND", "8", layer]


def circle(layer, middle, radius):
    return ["0", "CIRCLE", "8", layer, "10", middle[0], "20", middle[1], "40", radius]


def dxf(*entities, units=4):
    head = ["0", "SECTION", "2", "HEADER", "9", "$ACADVER", "1", "AC1015"]
    if units is not None:
        head += ["9", "$INSUNITS", "70", units]
    body = [text for each in entities for text in each]
    texts = head + ["0", "ENDSEC", "0", "SECTION", "2", "ENTITIES"] + body + ["0", "ENDSEC", "0", "EOF"]
    return "\n".join(str(text) for text in texts) + "\n"


def rectangle(x, y, width, height):
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


class InAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content.encode() if isinstance(content, str) else content)

    def read(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def floor(self, text, *options, warnings=None):
        """The area statement of a drawing, its lines."""
        self.write("deck.dxf", text)
        ran = rubicon("import", "deck.dxf", "--area", *options, cwd=self.folder)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        if warnings is None:
            self.assertEqual(ran.stderr, "")
        else:
            self.assertRegex(ran.stderr, warnings)
        self.plan = ran.stdout
        return [each.strip() for each in ran.stdout.splitlines()]

    def refused(self, text, message, *options):
        self.write("deck.dxf", text)
        ran = rubicon("import", "deck.dxf", "--area", *options, cwd=self.folder)
        self.assertEqual(ran.returncode, 2, ran.stdout)
        self.assertIn(message, ran.stderr)
        self.assertEqual(ran.stdout, "")
        return ran.stderr


DECK = "outline (0, 0), (12, 0), (12, 8), (0, 8);"


class Drawings(InAFolder):
    def test_lines_by_layer_become_a_floor(self):
        got = self.floor(dxf(
            lines("OUTLINE", *rectangle(0, 0, 12000, 8000)),
            polyline("shafts", *rectangle(7000, 2000, 2000, 2500)),
            line("shafts", (7000, 2000), (9000, 4500)),  # the cross of draughtsmen
            line("shafts", (7000, 4500), (9000, 2000)),
            old_polyline("Columns", *rectangle(2800, 3800, 400, 400)),
            circle("columns", (5000, 4000), 250),
            polyline("columns", *rectangle(2000, 6000, 300, 900)),  # no square: cut out
            line("beams", (0, 4000), (12000, 4000)),
            circle("furniture", (1000, 1000), 100),
        ), "--height", "3.2 m", warnings="1 of the columns cut out of the slab")
        for each in ["height 3.2 m;", DECK, "shaft (7, 2), (9, 2), (9, 4.5), (7, 4.5);", "column (3, 4), 0.4 m;",
                     "round_column (5, 4), 0.5 m;", "shaft (2, 6), (2.3, 6), (2.3, 6.9), (2, 6.9);",
                     "beam (0, 4), (12, 4);"]:
            self.assertIn(each, got)
        self.assertIn("// 1 line on other layers left out: 'furniture'", got)

    def test_the_floor_is_covered(self):
        with open(os.path.join(ROOT, "examples", "18_cover_a_floor", "hall.dxf"), encoding="utf-8") as file:
            self.write("deck.dxf", file.read())
        ran = rubicon("import", "deck.dxf", "--area", "--out", "deck.plan", cwd=self.folder)
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        self.assertEqual(rubicon("fmt", "--check", "deck.plan", cwd=self.folder).returncode, 0)
        with open(os.path.join(ROOT, "examples", "18_cover_a_floor", "screed.robot"), encoding="utf-8") as file:
            self.write("screed.robot", file.read())
        self.write("lay.plan", self.read("deck.plan").rstrip()[:-1] + """
  robot screed "screed.robot";
  task lay { by screed; cover deck { width 1 m; clearance 0.2 m; above 0.1 m; thickness 0.06 m; rate 30 m3 per h; } }
}
""")
        ran = rubicon("run", "lay.plan", cwd=self.folder)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        # The floor of example 18, and its figures.
        self.assertRegex(ran.stdout, r"lay +deck +\d+\.\d +100\.0 %")

    def test_units(self):
        for units, factor in [(4, 1000), (5, 100), (6, 1), (14, 10), (1, 1 / 0.0254), (2, 1 / 0.3048)]:
            text = dxf(lines("outline", *[(x * factor, y * factor) for x, y in rectangle(0, 0, 12, 8)]), units=units)
            self.assertIn(DECK, self.floor(text), units)
        none = dxf(lines("outline", *rectangle(0, 0, 1200, 800)), units=0)
        self.refused(none, "'deck.dxf' says no unit of length ($INSUNITS is 0)")
        self.assertIn(DECK, self.floor(none, "--unit", "cm"))
        self.assertIn(DECK, self.floor(dxf(lines("outline", *rectangle(0, 0, 1200, 800))), "--unit", "cm",
                                       warnings="the drawing says that it is in mm; taken as told by --unit"))

    def test_gaps_and_overlaps_are_closed(self):
        # Ends short of and past their corners, in both directions; a line drawn twice, in pieces.
        text = dxf(
            line("outline", (0, 0), (11996, 0)), line("outline", (12000, -3), (12000, 8004)),
            line("outline", (12004, 8000), (0, 8000)), line("outline", (0, 7997), (0, 2)),
            line("outline", (2000, 0), (6000, 0)), line("outline", (5000, 8000), (7000, 8000)),
        )
        got = self.floor(text, warnings=r"(?s)outline: \d+ ends of lines moved by up to 5 mm to meet.*"
                                        r"outline: \d+ pieces lie on others, each counted once")
        self.assertIn(DECK, got)
        self.refused(text, "open at", "--tolerance", "1 mm")

    def test_a_gap_is_named_with_places_and_lines(self):
        text = dxf(line("outline", (0, 0), (12000, 0)), line("outline", (12000, 0), (12000, 8000)),
                   line("outline", (12000, 8000), (0, 8000)), line("outline", (0, 8000), (0, 100)))
        said = self.refused(text, "the lines for outline are open at (0, 0); the nearest other open end is at (0, 100), "
                                  "100 mm away")
        first, second = re.findall(r"line (\d+)", said.splitlines()[0])
        numbered = text.splitlines()
        self.assertEqual([numbered[int(each) - 1] for each in (first, second)], ["LINE", "LINE"])
        self.assertLess(int(first), int(second))
        self.assertIn(DECK, self.floor(text, "--tolerance", "100 mm", warnings="moved"))

    def test_inner_lines_of_the_outline_do_not_matter(self):
        # Faces drawn one by one share their lines; a loop in a loop is an opening.
        got = self.floor(dxf(lines("outline", *rectangle(0, 0, 6000, 8000)), lines("outline", *rectangle(6000, 0, 6000, 8000)),
                             lines("outline", *rectangle(2000, 2000, 1000, 1000))), warnings="1 piece lies on others")
        self.assertIn(DECK, got)
        self.assertIn("shaft (2, 2), (3, 2), (3, 3), (2, 3);", got)

    def test_several_floors(self):
        got = self.floor(dxf(lines("outline", *rectangle(0, 0, 5000, 4000)), lines("outline", *rectangle(9000, 0, 9000, 4000))))
        self.assertIn("area deck {", got)
        self.assertIn("area deck_2 {", got)
        self.assertLess(got.index("outline (9, 0), (18, 0), (18, 4), (9, 4);"), got.index("outline (0, 0), (5, 0), (5, 4), (0, 4);"))

    def test_arcs_are_chords_of_the_right_area(self):
        # A slab with half a circle at its end, by a bulge, and its mirror image by a normal downwards.
        shape = polyline("outline", (0, 0), (10000, 0), (10000, 6000), (0, 6000), bulges=[0, 1])
        self.floor(dxf(shape))
        area = float(re.search(r"// ([\d.]+) m2", self.plan).group(1))
        self.assertAlmostEqual(area, 60 + 3.14159265 * 9 / 2, delta=0.05)
        mirrored = self.floor(dxf(shape + ["210", 0, "220", 0, "230", -1]))
        self.assertTrue(any("(-10, 0)" in each for each in mirrored), mirrored)

    def test_a_map_is_moved_to_the_origin(self):
        got = self.floor(dxf(lines("outline", *rectangle(155012, 463007.5, 12, 8)), units=6))
        self.assertIn("// The point 155000, 463000 (m) of the drawing is the origin of this plan", got)
        self.assertIn("outline (12, 7.5), (24, 7.5), (24, 15.5), (12, 15.5);", got)

    def test_layers_by_name(self):
        text = dxf(lines("A-SLAB", *rectangle(0, 0, 12000, 8000)), circle("S-COL-1", (3000, 3000), 200))
        self.refused(text, "has no line on a layer 'outline'; it has lines on 'A-SLAB', 'S-COL-1'")
        got = self.floor(text, "--layer", "outline=a-slab", "--layer", "columns=S-COL*")
        self.assertIn("round_column (3, 3), 0.4 m;", got)
        self.refused(text, "--layer takes outline=NAME", "--layer", "walls=X")

    def test_what_is_not_read_is_told(self):
        self.floor(dxf(lines("outline", *rectangle(0, 0, 12000, 8000)), ["0", "INSERT", "8", "columns", "2", "C1", "10", 1, "20", 2],
                       ["0", "TEXT", "8", "notes", "10", 1, "20", 2, "1", "hello"]),
                   warnings="1 INSERT on the layer 'columns' not read")

    def test_random_broken_rectangles_are_mended(self):
        chance = random.Random(17)
        for _ in range(20):
            pieces = []
            corners = rectangle(0, 0, 12000, 8000)
            for a, b in zip(corners, corners[1:] + corners[:1]):
                cuts = sorted(chance.random() for _ in range(chance.randrange(3)))
                shares = [0.0] + cuts + [1.0]
                for low, high in zip(shares, shares[1:]):
                    off = [chance.uniform(-3, 3) / 12000 for _ in range(2)]
                    ends = [(a[0] + (b[0] - a[0]) * s, a[1] + (b[1] - a[1]) * s) for s in (low + off[0], high + off[1])]
                    chance.shuffle(ends)
                    pieces.append(line("outline", *ends))
            chance.shuffle(pieces)
            self.write("deck.dxf", dxf(*pieces))
            ran = rubicon("import", "deck.dxf", "--area", "--tolerance", "10 mm", cwd=self.folder)
            self.assertEqual(ran.returncode, 0, ran.stderr)
            self.assertIn(DECK, ran.stdout)


class BadDrawings(InAFolder):
    def test_messages(self):
        good = dxf(lines("outline", *rectangle(0, 0, 12000, 8000)))
        at = good.splitlines()
        cases = [
            ("", "the file ends without EOF"),
            ("AutoCAD Binary DXF\r\n\x1a\x00", "is a binary DXF; save it as ASCII DXF"),
            ("AC1032\x00\x00", "is a DWG; save it as ASCII DXF"),
            ("hello\nworld\n", "line 1: expected a group code, found 'hello'"),
            (good[: len(good) // 2], "cut off"),
            (good.replace("12000", "twelve", 1), f"line {at.index('12000') + 1}: expected a number, found 'twelve'"),
            (good.replace("12000", "1e999", 1), "expected a number, found '1e999'"),
            (good.replace("12000", "nan", 1), "expected a number, found 'nan'"),
            (good.replace("12000", "1e300", 1), "is more than 9000 m from the outline"),
            (dxf(["0", "LINE", "8", "outline", "10", 1]), "LINE has 1 x and 0 y"),
            (dxf(["0", "LINE", "8", "outline", "10", 1, "20", 1]), "LINE has no end"),
            (good[: good.index("ENDSEC", 200)], "cut off"),
            (dxf(polyline("outline", *[(i % 2, i) for i in range(20000)], bulges=[9] * 20000)), "more than 1000000 points"),
            (dxf(circle("columns", (0, 0), 0)), "CIRCLE has no radius"),
            (dxf(["0", "POLYLINE", "8", "outline", "70", 1]), "expected VERTEX or SEQEND of the POLYLINE of line"),
            (dxf(), "has no line on a layer 'outline'; it has no lines at all"),
            (dxf(line("outline", (0, 0), (0, 0))), "enclose no floor"),
        ]
        for text, message in cases:
            with self.subTest(message):
                self.refused(text, message)
        self.refused(good, "--tolerance takes a length", "--tolerance", "5")
        self.refused(good, "--tolerance is from", "--tolerance", "5 m")
        self.refused(good, "a drawing takes --area, --layer", "--up", "y")

    def test_damaged_files_never_crash(self):
        chance = random.Random(5)
        good = dxf(lines("outline", *rectangle(0, 0, 12000, 8000)), polyline("shafts", *rectangle(7000, 2000, 2000, 2500)),
                   circle("columns", (5000, 4000), 250)).encode()
        for _ in range(60):
            text = bytearray(good)
            for _ in range(chance.randrange(1, 4)):
                at = chance.randrange(len(text))
                text[at : at + chance.randrange(3)] = bytes(chance.randrange(1, 256) for _ in range(chance.randrange(3)))
            self.write("deck.dxf", bytes(text))
            ran = subprocess.run([RUBICON, "import", "deck.dxf", "--area"], capture_output=True, timeout=60, cwd=self.folder)
            self.assertIn(ran.returncode, (0, 2), bytes(text))

    def test_tangled_lines_end(self):
        chance = random.Random(3)
        pieces = [line("outline", *[(chance.randrange(100000), chance.randrange(100000)) for _ in range(2)]) for _ in range(2500)]
        self.refused(dxf(*pieces), "cross more than 500000 times")


def ifc(*blocks):
    """A storey of blocks: type, name, corner and size, m."""
    texts = ["#1=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);", "#2=IFCUNITASSIGNMENT((#1));", "#3=IFCCARTESIANPOINT((0.,0.,0.));",
             "#4=IFCAXIS2PLACEMENT3D(#3,$,$);", "#5=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#4,$);",
             "#6=IFCPROJECT('p',$,'P',$,$,$,$,(#5),#2);", "#7=IFCLOCALPLACEMENT($,#4);",
             "#8=IFCBUILDING('b',$,'B',$,$,#7,$,$,.ELEMENT.,$,$,$);", "#9=IFCBUILDINGSTOREY('s',$,'01 first',$,$,#7,$,$,.ELEMENT.,0.);",
             "#10=IFCRELAGGREGATES('r',$,$,$,#6,(#8));", "#11=IFCRELAGGREGATES('q',$,$,$,#8,(#9));"]
    for i, (kind, name, corner, size) in enumerate(blocks):
        n = 100 + 10 * i
        texts += [f"#{n}=IFCCARTESIANPOINT(({','.join(str(float(c)) for c in corner)}));", f"#{n + 1}=IFCAXIS2PLACEMENT3D(#{n},$,$);",
                  f"#{n + 2}=IFCLOCALPLACEMENT(#7,#{n + 1});", f"#{n + 3}=IFCBLOCK(#4,{','.join(str(float(c)) for c in size)});",
                  f"#{n + 4}=IFCSHAPEREPRESENTATION(#5,'Body','CSG',(#{n + 3}));", f"#{n + 5}=IFCPRODUCTDEFINITIONSHAPE($,$,(#{n + 4}));",
                  f"#{n + 6}=IFC{kind}('e{i}',$,'{name}',$,$,#{n + 2},#{n + 5},$,$);"]
    elements = ",".join(f"#{100 + 10 * i + 6}" for i in range(len(blocks)))
    texts.append(f"#12=IFCRELCONTAINEDINSPATIALSTRUCTURE('c',$,$,$,({elements}),#9);")
    return ("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('IFC4'));\n"
            "ENDSEC;\nDATA;\n" + "\n".join(texts) + "\nENDSEC;\nEND-ISO-10303-21;\n")


class StoreyOfTwoFloors(InAFolder):
    def test_what_stands_in_one_floor_is_not_outside_of_every_slab(self):
        self.write("two.ifc", ifc(("SLAB", "high", (0, 0, 2.8), (10, 8, 0.2)), ("SLAB", "low", (10, 0, 2.4), (5, 8, 0.2)),
                                  ("COLUMN", "in high", (4, 4, 0), (0.4, 0.4, 6)), ("COLUMN", "in low", (12, 4, 0), (0.4, 0.4, 6)),
                                  ("WALL", "far wall", (20, 0, 0), (0.2, 8, 6)), ("COLUMN", "far column", (22, 0, 0), (0.4, 0.4, 6))))
        ran = rubicon("import", self.path("two.ifc"), "--area", "01*")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual(re.findall(r"// (.*) lies outside of every slab", ran.stdout), ["wall 'far wall'", "column 'far column'"])
        self.assertEqual(len(re.findall(r"column \(.*// 'in ", ran.stdout)), 2)


@unittest.skipUnless(os.path.isdir(REAL), "../shared/data is not there")
class RealBuilding(InAFolder):
    def test_ground_floor(self):
        models = [os.path.join(REAL, f"IFC-{name}.ifc") for name in ("kanaalplaatvloer", "staal", "kalkzandsteen")]
        ran = rubicon("import", *models, "--area", "00*", "--out", self.path("deck.plan"))
        self.assertEqual(ran.returncode, 0, ran.stderr)
        plan = self.read("deck.plan")
        self.assertIn("height -0.09 m;", plan)
        area = float(re.search(r"// ([\d.]+) m2", plan).group(1))
        self.assertGreater(area, 250)
        self.assertLess(area, 21.3 * 20.89)
        # The topping of that floor, by a screed that reaches all of it.
        with open(os.path.join(ROOT, "examples", "18_cover_a_floor", "screed.robot"), encoding="utf-8") as file:
            self.write("screed.robot", re.sub(r"range\(0, \d\)", "range(-1, 23)", file.read()))
        self.write("lay.plan", plan.rstrip()[:-1] + """
  robot screed "screed.robot" at trans(0, 0, -0.09) { start x 1, y 15; }
  task lay { by screed; cover deck { width 1 m; clearance 0.25 m; above 0.1 m; thickness 0.05 m; rate 30 m3 per h; } }
}
""")
        ran = rubicon("run", "lay.plan", cwd=self.folder)
        self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
        covered, share = re.search(r"lay +deck +([\d.]+) +([\d.]+) %", ran.stdout).groups()
        self.assertAlmostEqual(float(covered), area, delta=0.01 * area)
        self.assertGreaterEqual(float(share), 99.5)
        ran = rubicon("import", models[0], "--area", "05")
        self.assertEqual(ran.returncode, 2)
        self.assertIn("there is no storey '05'; the model has '00 begane grond'", ran.stderr)


if __name__ == "__main__":
    unittest.main()
