"""Plans made from a seed in which pools, parts of crews, and members that are kept by `same as` may come to wait for each other."""

import random

RULES = ("first", "least_used")


def make_tasks(seed):
    """By number: what each asks for, how long it takes, and its links; the later tasks last."""
    rng = random.Random(seed)
    pooled = {}  # those by a pool whom nobody has the same as yet
    tasks = []
    for number in range(rng.randint(6, 16)):
        after = {other: rng.choice(("FS", "FS", "FS", "SS")) for other in rng.sample(range(number), min(number, rng.choice((0, 1, 1, 2))))}
        by = rng.choice(("by p;", "by p;", "by p;", "by q;", "by all of p;", "by all of p;", "by all of q;", "by c0;", "needs 2 c1;", "needs 1 c3;"))
        if by == "by p;" and pooled and rng.random() < 0.8:
            first = rng.choice(sorted(pooled))
            del pooled[first]
            by = f"by same as t{first};"
            after[first] = "FS"
        if by.startswith("by same") or by == "by p;":
            pooled[number] = True
        tasks.append((number, by, rng.choice((30, 45, 60, 120, 240, 500)), rng.choice((0, 0, 1, 5)), after))
    return rng.choice(RULES), tasks


def text_of(plan, without=()):
    rule, tasks = plan
    lines = ['plan pools { start_at "2026-03-02 07:00";', "calendar day { mon-fri 07:00-12:00, 12:30-16:00; }"]
    lines += [f"crew c{i} {{ size 3; {'calendar day; ' if i % 2 else ''}}}" for i in range(5)]
    lines += [f"pool p {{ of c0, c1, c2; choose {rule}; }}", f"pool q {{ of c3, c4; choose {rule}; }}"]
    for number, by, minutes, priority, after in tasks:
        links = ", ".join(f"t{other} {link}" for other, link in after.items() if other not in without)
        if number not in without:
            lines.append(f"task t{number} {{ {by} takes {minutes} min; priority {priority}; {f'after {links}; ' if links else ''}}}")
    return "\n".join(lines) + "\n}\n"
