"""Solids that stand upright: boxes and cylinders turned about the vertical only, as most things on a site are. Whether two
overlap is exact: in height, and in plan. Everything else is taken as the box around it, so an overlap may be said to be
there that is none, never the other way round. Metres, degrees."""

import math

UPRIGHT = 1e-9
"""How far the vertical axis of a pose may lean (sine of the angle); the rest is rounding."""


class Frame:
    """A pose turned about the vertical only: a point and the cosine and sine of the turn."""

    __slots__ = ("x", "y", "z", "c", "s")

    def __init__(self, x, y, z, c, s):
        self.x, self.y, self.z, self.c, self.s = x, y, z, c, s

    def __mul__(self, other):
        x, y = self.turned(other.x, other.y)
        return Frame(
            self.x + x,
            self.y + y,
            self.z + other.z,
            self.c * other.c - self.s * other.s,
            self.s * other.c + self.c * other.s,
        )

    def turned(self, x, y):
        return self.c * x - self.s * y, self.s * x + self.c * y

    def point(self, x, y):
        x, y = self.turned(x, y)
        return self.x + x, self.y + y


def trans(x, y, z):
    return Frame(x, y, z, 1, 0)


def rotz(degrees):
    return Frame(0, 0, 0, math.cos(math.radians(degrees)), math.sin(math.radians(degrees)))


def frame_of(pose):
    """Of a pose of 12 numbers; an error if it leans."""
    if abs(pose[10] - 1) > UPRIGHT:
        raise ValueError(f"the pose {pose} does not stand upright")
    return Frame(pose[3], pose[7], pose[11], pose[0], pose[4])


class Solid:
    """A rectangle or a circle in the plan of its body, from one height to another."""

    def __init__(self, shape):
        self.radius = shape["radius"] if shape["type"] == "cylinder" else None
        lower, upper = bounds(shape)
        self.frame = trans(*((a + b) / 2 for a, b in zip(lower, upper)))
        self.half = [(b - a) / 2 for a, b in zip(lower, upper)]

    def at(self, body):
        return Placed(self, body * self.frame)


def bounds(shape):
    """Two corners of the box around a shape, in the frame of its body; exact for boxes turned by quarters."""
    if shape["type"] == "box":
        lower, upper = shape["lower"], shape["upper"]
    elif shape["type"] == "cylinder":
        r = shape["radius"]
        lower, upper = [-r, -r, shape["z0"]], [r, r, shape["z1"]]
    elif shape["type"] == "prism":
        xs, ys = zip(*shape["polygon"])
        lower, upper = [min(xs), min(ys), shape["z0"]], [max(xs), max(ys), shape["z1"]]
    else:
        raise ValueError(f"no upright solid is made of a {shape['type']}")
    pose = shape["pose"]
    corners = [
        [sum(pose[4 * row + k] * corner[k] for k in range(3)) + pose[4 * row + 3] for row in range(3)]
        for corner in ((x, y, z) for x in (lower[0], upper[0]) for y in (lower[1], upper[1]) for z in (lower[2], upper[2]))
    ]
    return [min(c[k] for c in corners) for k in range(3)], [max(c[k] for c in corners) for k in range(3)]


class Placed:
    """A solid in the world."""

    __slots__ = ("frame", "half", "radius", "z0", "z1", "reach")

    def __init__(self, solid, frame):
        self.frame, self.half, self.radius = frame, solid.half, solid.radius
        self.z0, self.z1 = frame.z - solid.half[2], frame.z + solid.half[2]
        self.reach = solid.radius or math.hypot(solid.half[0], solid.half[1])

    def extent(self, nx, ny):
        """Half its width along a direction in plan."""
        if self.radius is not None:
            return self.radius
        f, half = self.frame, self.half
        return half[0] * abs(f.c * nx + f.s * ny) + half[1] * abs(-f.s * nx + f.c * ny)

    def corners(self):
        a, b = self.half[0], self.half[1]
        return [self.frame.point(x, y) for x, y in ((a, b), (-a, b), (-a, -b), (a, -b))]


def plan_depth(a, b, enough):
    """How far the one must be pushed to be clear of the other in plan; no more than `enough` is looked for."""
    dx, dy = b.frame.x - a.frame.x, b.frame.y - a.frame.y
    if math.hypot(dx, dy) > a.reach + b.reach - enough:
        return a.reach + b.reach - math.hypot(dx, dy)
    axes = [(f.c, f.s) for f in (a.frame, b.frame)] + [(-f.s, f.c) for f in (a.frame, b.frame)]
    for circle, other in ((a, b), (b, a)):
        if circle.radius is None:
            continue
        cx, cy = circle.frame.x, circle.frame.y
        for x, y in [(other.frame.x, other.frame.y)] if other.radius is not None else other.corners():
            length = math.hypot(x - cx, y - cy)
            if length > 0:
                axes.append(((x - cx) / length, (y - cy) / length))
    depth = math.inf
    for nx, ny in axes:
        depth = min(depth, a.extent(nx, ny) + b.extent(nx, ny) - abs(nx * dx + ny * dy))
        if depth <= enough:
            break
    return depth


def overlap(a, b, contact):
    """Whether two placed solids are deeper in each other than `contact` (m) in every direction."""
    if a.z1 - b.z0 <= contact or b.z1 - a.z0 <= contact:
        return False
    return plan_depth(a, b, contact) > contact


def stands_on(a, b, contact, width):
    """Whether `a` touches the top of `b` from above over more than `width` (m) in every direction of the plan."""
    return abs(a.z0 - b.z1) <= contact and plan_depth(a, b, width) > width
