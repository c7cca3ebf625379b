"""Packed traces: the same bytes each time, the same answers as plain ones, and refused where they are damaged or bombs."""

import gzip
import os
import shutil
import subprocess
import tempfile
import unittest
import zlib

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PLAN = os.path.join(ROOT, "examples", "08_what_cannot_be_done", "site.plan")


def rubicon(*arguments):
    return subprocess.run([RUBICON, *arguments], stdin=subprocess.DEVNULL, capture_output=True, timeout=120)


class CompressedTrace(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.plain, self.packed = self.path("plain", "r"), self.path("packed", "r")
        rubicon("run", PLAN, "--out", self.plain)
        rubicon("run", PLAN, "--out", self.packed, "--compress")
        self.trace = os.path.join(self.packed, "trace.jsonl.gz")

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def read(self, *names):
        with open(os.path.join(*names), "rb") as file:
            return file.read()

    def refused(self, data, text):
        with open(self.trace, "wb") as file:
            file.write(data)
        for call in (("verify", self.packed), ("why", self.packed, "set_a"), ("why", self.trace, "set_a"),
                     ("export", self.packed, "--svg", self.path("s"))):
            result = rubicon(*call)
            self.assertEqual((result.returncode, result.stdout), (2, b""), call)
            self.assertIn(text, result.stderr.decode(), call)

    def test_what_is_packed_is_the_trace(self):
        data = self.read(self.trace)
        self.assertEqual(gzip.decompress(data), self.read(self.plain, "trace.jsonl"))
        self.assertEqual(data[:10], b"\x1f\x8b\x08\0\0\0\0\0\0\xff")
        self.assertLess(len(data) * 5, os.path.getsize(os.path.join(self.plain, "trace.jsonl")))
        self.assertNotIn("trace.jsonl", os.listdir(self.packed))
        rubicon("run", PLAN, "--trace", self.path("t.gz"))
        self.assertEqual(self.read(self.path("t.gz")), data)
        for name in os.listdir(self.plain):
            if name != "trace.jsonl":
                self.assertEqual(self.read(self.packed, name), self.read(self.plain, name), name)
        self.assertEqual(rubicon("run", PLAN, "--compress").returncode, 2)

    def test_one_takes_the_place_of_the_other(self):
        rubicon("run", PLAN, "--out", self.packed)
        self.assertNotIn("trace.jsonl.gz", os.listdir(self.packed))
        rubicon("run", PLAN, "--out", self.packed, "--compress")
        self.assertNotIn("trace.jsonl", os.listdir(self.packed))

    def test_every_command_says_the_same(self):
        calls = [("verify", "R"), ("why", "R", "set_a"), ("debug", "R", "set_a", "-x", "break hit; continue; where", "--batch"),
                 ("export", "R", "--svg", "-"), ("export", "R", "--gltf", "-"), ("export", "R", "--mspdi", "-"),
                 ("report", "R", "--out", "-"), ("why", "T", "set_a"), ("debug", "T", "set_a", "-x", "step", "--batch"),
                 ("verify", "T"), ("report", "T", "--out", "-")]
        shutil.copy(self.trace, self.path("named_otherwise"))
        for call in calls:
            found = []
            for folder, trace in ((self.plain, os.path.join(self.plain, "trace.jsonl")),
                                  (self.packed, self.path("named_otherwise"))):
                result = rubicon(*({"R": folder, "T": trace}.get(word, word) for word in call))
                found.append((result.returncode, result.stdout))
            self.assertEqual(found[0], found[1], call)
            self.assertTrue(found[0][1] or call[0] == "report", call)

    def test_damage_and_bombs_are_refused(self):
        data = self.read(self.trace)
        self.refused(data[:-30], "ends too soon")
        self.refused(data[:10] + b"\xff" * 20 + data[30:], "damaged")  # no such kind of block
        self.refused(data[:200] + bytes(20) + data[220:], "trace.jsonl.gz")  # where it is seen depends on the bytes
        self.refused(data + b"x" * 20, "damaged")
        self.refused(gzip.compress(b""), "found nothing")
        packer = zlib.compressobj(9, zlib.DEFLATED, 31)
        bomb = b"".join(packer.compress(bytes(1 << 20)) for _ in range(300)) + packer.flush()
        self.refused(bomb, "400 times its size")

    def test_parts_one_after_the_other_are_one_trace(self):
        text = self.read(self.plain, "trace.jsonl")
        with open(self.trace, "wb") as file:
            file.write(gzip.compress(text[:5000]) + gzip.compress(text[5000:]))
        self.assertEqual(rubicon("verify", self.packed).stdout, rubicon("verify", self.plain).stdout)


if __name__ == "__main__":
    unittest.main()
