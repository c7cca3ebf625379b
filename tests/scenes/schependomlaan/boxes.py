"""Boxes of the elements of an IFC 2x3 file, read without the code under test: from the IfcBoundingBox that the program
which drew the model wrote for each element, and the element's placement."""

import os
import re


def _records(path):
    """Number -> (class, arguments) of a STEP file whose texts hold no bracket that is not closed."""
    with open(path, encoding="latin-1") as file:
        data = file.read().split("DATA;", 1)[1]
    records = {}
    for number, keyword, arguments in re.findall(r"#(\d+)\s*=\s*(\w+)\s*\((.*?)\)\s*;\s*(?=#|ENDSEC)", data, re.DOTALL):
        records[int(number)] = (keyword, arguments)
    return records


def _split(arguments):
    """The arguments of a record, outermost commas only."""
    parts, depth, quoted, current = [], 0, False, ""
    for c in arguments:
        if c == "'":
            quoted = not quoted
        if not quoted:
            depth += (c == "(") - (c == ")")
            if c == "," and depth == 0:
                parts.append(current.strip())
                current = ""
                continue
        current += c
    return [*parts, current.strip()]


class _File:
    def __init__(self, path):
        self.records = _records(path)

    def get(self, reference):
        keyword, arguments = self.records[int(reference.strip().lstrip("#"))]
        return keyword, _split(arguments)

    def numbers(self, reference):
        return [float(value) for value in self.get(reference)[1][0].strip("()").split(",")]

    def axes(self, reference):
        """x, y, z, origin of an IfcAxis2Placement3D."""
        _, (origin, z, x) = self.get(reference)
        z = self.numbers(z) if z != "$" else [0, 0, 1]
        x = self.numbers(x) if x != "$" else [1, 0, 0]
        y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]]
        return x, y, z, self.numbers(origin)

    def to_world(self, placement, point):
        while placement != "$":
            _, (above, axes) = self.get(placement)
            x, y, z, origin = self.axes(axes)
            point = [origin[k] + point[0] * x[k] + point[1] * y[k] + point[2] * z[k] for k in range(3)]
            placement = above
        return point


def of_file(path):
    """(file, GlobalId) -> [low x, low y, low z, high x, high y, high z], m; the file is in millimetres."""
    file = _File(path)
    found = {}
    for keyword, arguments in file.records.values():
        if keyword not in ("IFCSLAB", "IFCWALL", "IFCWALLSTANDARDCASE", "IFCSTAIR", "IFCBEAM", "IFCCOLUMN", "IFCMEMBER"):
            continue
        values = _split(arguments)
        _, (_, _, representations) = file.get(values[6])
        for representation in re.findall(r"#\d+", representations):
            _, (_, _, kind, items) = file.get(representation)
            if kind != "'BoundingBox'":
                continue
            _, (corner, *size) = file.get(items.strip("()"))
            corner, size = file.numbers(corner), [float(value) for value in size]
            corners = [
                file.to_world(values[5], [corner[k] + (size[k] if bits >> k & 1 else 0) for k in range(3)])
                for bits in range(8)
            ]
            low = [min(p[k] for p in corners) / 1000 for k in range(3)]
            high = [max(p[k] for p in corners) / 1000 for k in range(3)]
            found[os.path.basename(path), values[0].strip("'")] = low + high
    return found


def of_row(row):
    """The same of a row of the table of elements that is turned by 0 or 90 degrees."""
    x, y, z, length, width, height = (float(row[key]) for key in ("x", "y", "z", "length", "width", "height"))
    if float(row["turn_deg"]) == 90:
        length, width = width, length
    return [x - length / 2, y - width / 2, z, x + length / 2, y + width / 2, z + height]


def difference(a, b):
    return max(abs(p - q) for p, q in zip(a, b))
