#!/usr/bin/env python3
"""Reads what swept_query_bench measured (JSON of Google Benchmark) and prints tables with the targets.

usage: collision_table.py RESULT.json

Times are medians over the repetitions, processor time. What is measured: docs/benchmarks.md. Exits 1 if an answer that
is known was wrong: a touching step called a hit, a step of the crane's free way called a hit.
"""

import json
import sys

PANEL_COUNTS = (1000, 10000, 100000)
MESH_COUNTS = (100, 1000, 10000)

# scene, step: least ratio of FCL's time to ours, by default request and with a pose every 10 mm
LEAST_RATIO = {
    ("panels", "T"): (8, 100),
    ("panels", "R"): (8, 100),
    ("meshes", "T"): (25, 250),
    ("meshes", "R"): (15, None),
    ("mesh_load", "T"): (None, None),
    ("mesh_load", "R"): (None, None),
}
NEAR_COUNTS = {"panels": PANEL_COUNTS, "meshes": MESH_COUNTS, "mesh_load": MESH_COUNTS}
NEAR_NAMES = {"panels": "panels", "meshes": "panel among meshes", "mesh_load": "mesh among meshes"}

# Upper limits: ns a query, a query, a body and step, an insertion; and how much longer a step may take among 100,000
# panels than among 1,000.
FREE_LIMIT_NS = 60
FREE_BUDGET_LIMIT_NS = 15
CRANE_LIMIT_NS = 250
INSERT_LIMIT_NS = 5000
GROWTH_LIMIT = 2.5


class Results:
    """Medians by name SCENE/KIND/COUNT/METHOD; a benchmark that did not run is None."""

    def __init__(self, document):
        self._runs = {}
        for run in document["benchmarks"]:
            if run.get("run_type") == "aggregate" and run.get("aggregate_name") != "median":
                continue
            name = "/".join(run["run_name"].split("/")[:4])
            self._runs[name] = run
        if not self._runs:
            raise ValueError("it holds no benchmarks")

    def run(self, scene, kind, count, method):
        return self._runs.get(f"{scene}/{kind}/{count}/{method}")

    def ns(self, scene, kind, count, method):
        run = self.run(scene, kind, count, method)
        if run is None:
            return None
        factor = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}[run["time_unit"]]
        time = run["real_time"] if "manual_time" in run["run_name"] else run["cpu_time"]
        return time * factor

    def counter(self, scene, kind, count, method, name):
        run = self.run(scene, kind, count, method)
        return None if run is None else run.get(name)


class Verdicts:
    """What is reached and what falls short."""

    def __init__(self):
        self.short = []
        self.wrong = []
        self.reached = 0

    def limit(self, label, value, limit, unit):
        """`value` must not be above `limit`."""
        if value is None or limit is None:
            return ""
        return self._judge(value <= limit, f"{label}: {number(value)}{unit}, target {limit}{unit}")

    def least(self, label, value, least):
        """`value`, a ratio, must not be below `least`."""
        if value is None or least is None:
            return ""
        return self._judge(value >= least, f"{label}: {value:.1f}x, target {least}x")

    def none_wrong(self, label, share):
        if share is None:
            return ""
        if share > 0:
            self.wrong.append(f"{label}: {percent(share)} wrong, target 0 %")
            return "no"
        self.reached += 1
        return "yes"

    def _judge(self, good, sentence):
        if good:
            self.reached += 1
            return "yes"
        self.short.append(sentence)
        return "no"


def number(value):
    """Three digits, no exponent; a dash for what was not measured."""
    if value is None:
        return "-"
    if abs(value) >= 100:
        return f"{value:,.0f}"
    return f"{value:.1f}"


def percent(share):
    return "-" if share is None else f"{100 * share:.1f} %"


def ratio(slow, fast):
    return None if slow is None or fast is None else slow / fast


def times(value):
    return "-" if value is None else f"{value:.1f}x"


def target(least):
    return "" if least is None else f">= {least}x"


def both(first, second):
    verdicts = [verdict for verdict in (first, second) if verdict]
    if not verdicts:
        return ""
    return "yes" if all(verdict == "yes" for verdict in verdicts) else "no"


def table(title, header, rows):
    rows = [row for row in rows if row is not None]
    if not rows:
        return
    widths = [max(len(str(row[i])) for row in [header] + rows) for i in range(len(header))]
    print(f"\n{title}\n")
    for k, row in enumerate([header] + rows):
        print("| " + " | ".join(str(cell).ljust(width) for cell, width in zip(row, widths)) + " |")
        if k == 0:
            print("|" + "|".join("-" * (width + 2) for width in widths) + "|")


def near_rows(results, verdicts):
    for (scene, kind), (least_default, least_10mm) in LEAST_RATIO.items():
        for count in NEAR_COUNTS[scene]:
            ours = results.ns(scene, kind, count, "ours")
            if ours is None:
                continue
            default = results.ns(scene, kind, count, "fcl_default")
            every_10mm = results.ns(scene, kind, count, "fcl_10mm")
            label = f"{NEAR_NAMES[scene]}, {kind}, {count}"
            by_default = verdicts.least(f"{label}, FCL default", ratio(default, ours), least_default)
            by_10mm = verdicts.least(f"{label}, FCL 10 mm", ratio(every_10mm, ours), least_10mm)
            yield [
                NEAR_NAMES[scene], kind, count, percent(results.counter(scene, kind, count, "ours", "hits")),
                number(ours), number(default), number(every_10mm), times(ratio(default, ours)), target(least_default),
                times(ratio(every_10mm, ours)), target(least_10mm), both(by_default, by_10mm)
            ]


def contact_rows(results, verdicts):
    for kind in ("T", "R"):
        for count in PANEL_COUNTS:
            ours = results.ns("contact", kind, count, "ours")
            if ours is None:
                continue
            wrong = results.counter("contact", kind, count, "ours", "hits")
            row = [kind, count, number(ours), percent(wrong)]
            for method in ("fcl_default", "fcl_10mm"):
                row += [number(results.ns("contact", kind, count, method)),
                        percent(results.counter("contact", kind, count, method, "hits"))]
            yield row + [verdicts.none_wrong(f"touching contact, {kind}, {count}", wrong)]


def figure_rows(results, verdicts):

    def row(label, value, other, limit, unit):
        if value is None:
            return None
        bound = "" if limit is None else f"<= {limit}{unit}"
        return [label, f"{number(value)}{unit}", "-" if other is None else f"{number(other)}{unit}", bound,
                verdicts.limit(label, value, limit, unit)]

    for kind in ("T", "R"):
        few, many = [[results.ns("panels", kind, count, method) for method in ("ours", "fcl_default")]
                     for count in (1000, 100000)]
        yield row(f"growth of a step among panels, {kind}, 1,000 to 100,000", ratio(many[0], few[0]),
                  ratio(many[1], few[1]), GROWTH_LIMIT, "x")
    for kind in ("T", "R"):
        other = results.ns("free", kind, 100000, "fcl_default")
        yield row(f"free space, {kind}, 100,000 panels", results.ns("free", kind, 100000, "ours"), other,
                  FREE_LIMIT_NS, " ns")
        yield row(f"free space with the clearance budget, {kind}", results.ns("free", kind, 100000, "ours_budget"),
                  other, FREE_BUDGET_LIMIT_NS, " ns")
    for method, what in (("ours", "against the site"), ("ours_budget", "against the site, with the clearance budget"),
                         ("ours_pairs", "and each other"),
                         ("ours_pairs_budget", "and each other, with the clearance budget")):
        label = f"crane over the building, a body and step, {what}"
        other = results.ns("crane", "path", 1401, "fcl_default") if "pairs" not in method else None
        yield row(label, results.ns("crane", "path", 1401, method), other, CRANE_LIMIT_NS, " ns")
        hits = results.counter("crane", "path", 1401, method, "hits")
        if hits:  # the way is free; this is counted only where it is answered wrongly
            verdicts.none_wrong(label, hits)
    for scene, what, limit in (("insert", "insert a panel into 100,000", INSERT_LIMIT_NS),
                               ("insert_ask", "the same and a step tested after each", None)):
        yield row(what, results.ns(scene, "panels", 100000, "ours"),
                  results.ns(scene, "panels", 100000, "fcl_default"), limit, " ns")
    for scene, what in (("remove", "remove a panel out of 120,000"),
                        ("remove_ask", "the same and a step tested after each")):
        yield row(what, results.ns(scene, "panels", 120000, "ours"),
                  results.ns(scene, "panels", 120000, "fcl_default"), None, " ns")
    yield row("build from nothing to 100,000 panels, a panel", results.ns("build", "panels", 100000, "ours"),
              results.ns("build", "panels", 100000, "fcl_default"), None, " ns")
    for kind, count, what in (("panels", 100000, "memory a panel"), ("meshes", 10000, "memory a mesh instance")):
        yield row(what, results.counter("build", kind, count, "ours", "bytes"),
                  results.counter("build", kind, count, "fcl_default", "bytes"), None, " bytes")


def answer_rows(results):
    """Questions beyond free or hit; they have no counterpart in FCL."""
    for kind in ("T", "R"):
        for scene, counts in (("panels", PANEL_COUNTS), ("meshes", MESH_COUNTS)):
            values = [(method, results.ns(f"{scene}_{method}", kind, counts[1], "ours"))
                      for method in ("contact", "explain", "clearance")]
            if any(value is not None for _, value in values):
                yield [scene, kind, counts[1]] + [number(value) for _, value in values]


def simd_rows(results):
    for scene, kind in LEAST_RATIO:
        for count in NEAR_COUNTS[scene]:
            best = results.ns(scene, kind, count, "ours")
            plain = results.ns(scene, kind, count, "ours_baseline")
            if best is not None and plain is not None:
                yield [NEAR_NAMES[scene], kind, count, number(plain), number(best), times(ratio(plain, best))]


def dropped_rows(results):
    for scene in NEAR_COUNTS:
        for count in NEAR_COUNTS[scene]:
            ours = results.ns(scene, "R", count, "ours")
            dropped = results.ns(scene, "R", count, "fcl_dropped")
            if ours is not None and dropped is not None:
                yield [NEAR_NAMES[scene], count, number(dropped), times(ratio(dropped, ours))] + [
                    percent(results.counter(scene, "R", count, "fcl_dropped", name)) for name in ("missed", "false_hits")]


def tuned_rows(results):
    for scene, kind in LEAST_RATIO:
        for count in NEAR_COUNTS[scene]:
            ours = results.ns(scene, kind, count, "ours")
            tight = results.ns(scene, kind, count, "fcl_tight")
            one_tree = results.ns(scene, kind, count, "fcl_10mm_one_tree")
            if ours is not None and tight is not None and one_tree is not None:
                yield [NEAR_NAMES[scene], kind, count, number(tight), times(ratio(tight, ours)), number(one_tree),
                       times(ratio(one_tree, ours))]


def miss_rows(results):
    for scene, kind in LEAST_RATIO:
        for count in NEAR_COUNTS[scene]:
            shares = [results.counter(scene, kind, count, method, name) for method in ("fcl_default", "fcl_10mm")
                      for name in ("missed", "false_hits")]
            if any(share is not None for share in shares):
                yield [NEAR_NAMES[scene], kind, count] + [percent(share) for share in shares]


def main(arguments):
    if len(arguments) != 1:
        print("usage: collision_table.py RESULT.json", file=sys.stderr)
        return 2
    try:
        with open(arguments[0], encoding="utf-8") as file:
            results = Results(json.load(file))
    except (OSError, ValueError, KeyError, TypeError) as error:
        print(f"collision_table.py: {arguments[0]}: {error}", file=sys.stderr)
        return 2
    verdicts = Verdicts()
    table("Steps among obstacles, ns a step (T: 0.5 m, R: 5 degrees, radius to 30 m)",
          ["scene", "step", "n", "hits", "ours", "FCL default", "FCL 10 mm", "ratio", "target", "ratio 10 mm",
           "target", "reached"], list(near_rows(results, verdicts)))
    table("Touching contact: a panel slides or turns on slabs, every step is free, ns a step",
          ["step", "n", "ours", "wrong", "FCL default", "wrong", "FCL 10 mm", "wrong", "reached"],
          list(contact_rows(results, verdicts)))
    table("Single figures", ["what", "ours", "FCL", "target", "reached"], list(figure_rows(results, verdicts)))
    table("Further questions, ns", ["scene", "step", "n", "contact of a hit", "explain", "clearance within 2 m"],
          list(answer_rows(results)))
    table("Instructions, ns a step", ["scene", "step", "n", "every x86-64", "AVX2", "ratio"], list(simd_rows(results)))
    table("FCL's answers against ours", ["scene", "step", "n", "default misses", "default false hits",
                                         "10 mm misses", "10 mm false hits"], list(miss_rows(results)))
    table("FCL's default request on R, which drops the rotation, ns a step",
          ["scene", "n", "FCL", "ratio", "misses", "false hits"], list(dropped_rows(results)))
    table("FCL tuned by hand, ns a step",
          ["scene", "step", "n", "exact bounds, default", "ratio", "10 mm, one tree query", "ratio"],
          list(tuned_rows(results)))
    print(f"\n{verdicts.reached} targets reached, {len(verdicts.short) + len(verdicts.wrong)} not.")
    for sentence in verdicts.wrong + verdicts.short:
        print(f"- {sentence}")
    return 1 if verdicts.wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
