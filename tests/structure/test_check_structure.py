"""Seeds every kind of violation into a small project and expects check_structure to name it, and nothing else."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import check_structure  # noqa: E402  (the folder of this file is no package)

MODULES = """
grammar:
src/motion/math:
src/shape:   src/motion/math
src/exchange/mesh_io: src/shape
interpreter: src/shape
src/cli:     interpreter src/exchange/mesh_io
hidden:
interpreter: grammar
"""

README = "In: text.\nOut: text.\nMay use: what is below.\n"


class SeededViolations(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("tests/structure/modules.txt", MODULES)
        for name in check_structure.TOP_DOCUMENTS:
            self.write(name, "nothing yet\n")
        self.write("README.md", "see [the architecture](docs/architecture.md)\n")
        self.write("docs/architecture.md", "see [here](../README.md#top) and [there](https://example.org/x)\n")
        for module in ("grammar", "src/motion/math", "src/shape", "src/exchange/mesh_io", "interpreter", "src/cli"):
            self.write(f"{module}/README.md", README)
            self.write(f"{module}/CMakeLists.txt", "rubicon_module(x SOURCES good.cpp angles.cpp seeded.cpp)\n")
            self.write(f"{module}/good.hpp", "#pragma once\n#include <vector>\n")
        self.write("grammar/script.hpp", "#include <tao/pegtl.hpp>\n")
        self.write("src/motion/math/angles.cpp", "double f(double x) { return std::sin(x); }\n")
        self.write("src/shape/good.cpp", '#include "src/motion/math/good.hpp"\n// std::sin, #include <chrono>, getenv("HOME")\n')
        self.write("src/exchange/mesh_io/assimp_scene.hpp", "#include <assimp/scene.h>\n")
        self.write("src/exchange/mesh_io/good.cpp", '#include <fstream>\n#include "src/exchange/mesh_io/assimp_scene.hpp"\n')
        self.write("interpreter/good.cpp", '#include "grammar/script.hpp"\n#include "src/motion/math/good.hpp"\n'
                   'auto kind = Kind::sin; auto text = "sin(x)"; double d = sin_deg(x) + node.log();\n')
        self.write("interpreter/parse_state.hpp", '#include "grammar/script.hpp"\n')
        self.write("src/cli/good.cpp", '#include <chrono>\n#include "interpreter/good.hpp"\n')

    def write(self, path, text):
        target = self.root / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")

    def expect(self, *fragments):
        """Exactly one violation for each fragment, in this order."""
        found = check_structure.check(self.root)
        self.assertEqual(len(found), len(fragments), found)
        for line, fragment in zip(found, fragments):
            self.assertIn(fragment, line)

    def expect_in(self, path, text, fragment):
        self.write(path, text)
        self.expect(fragment)
        (self.root / path).unlink()

    def test_good_project(self):
        self.expect()

    def test_order_of_modules(self):
        self.expect_in("src/motion/math/seeded.cpp", '\n#include "src/shape/good.hpp"\n',
                       "src/motion/math/seeded.cpp:2: src/motion/math may not use src/shape (it may use no other module)")
        self.expect_in("src/shape/seeded.hpp", '#include "interpreter/good.hpp"\n', "may not use interpreter")
        self.expect_in("interpreter/seeded.hpp", ' # include  "src/cli/good.hpp"\n', "may not use src/cli")
        self.expect_in("src/exchange/mesh_io/seeded.cpp", '#include "grammar/script.hpp"\n', "may not use grammar")

    def test_hidden_module_in_header(self):
        self.expect_in("interpreter/seeded.hpp", '#include "grammar/script.hpp"\n', "only the .cpp files of interpreter")
        self.expect_in("interpreter/seeded.hpp", '#include "interpreter/parse_state.hpp"\n', "private header")

    def test_include_without_folder(self):
        self.expect_in("src/motion/math/seeded.cpp", '#include "good.hpp"\n', "name project headers from the top folder")

    def test_libraries(self):
        self.expect_in("interpreter/seeded.hpp", "#include <tao/pegtl.hpp>\n", "PEGTL")
        self.expect_in("src/shape/seeded.hpp", "#include <fcl/fcl.h>\n", "FCL")
        self.expect_in("src/exchange/mesh_io/seeded.hpp", "#include <assimp/scene.h>\n", "assimp")
        self.expect_in("src/exchange/mesh_io/seeded.hpp", '#include "src/exchange/mesh_io/assimp_scene.hpp"\n', "private header")
        self.expect_in("src/cli/seeded.cpp", '#include "src/exchange/mesh_io/assimp_scene.hpp"\n', "private header")

    def test_trigonometry(self):
        for code in ("return std::cos(x);", "return sin(x);", "y = -atan2f(y, x);", "using std::pow;", "::exp(2.0);",
                     "std::transform(a, b, c, std::log2);", "z = 2*tan (x);", "Eigen::AngleAxisd turn(a, axis);"):
            self.expect_in("src/shape/seeded.cpp", f"double f() {{\n{code} }}\n", "src/shape/seeded.cpp:2: ")

    def test_disk_and_clock(self):
        for code in ("#include <chrono>", "#include <fstream>", "#include <iostream>", "#include <unistd.h>",
                     'auto home = std::getenv("HOME");', 'auto f = fopen("x", "r");', "std::random_device()();"):
            self.expect_in("interpreter/seeded.cpp", code + "\n", "only src/cli and files named *_io")

    def test_folders(self):
        self.write("src/extra/seeded.cpp", "")
        self.expect("src/extra: is not listed")

    def test_folders_of_a_module_in_a_circle(self):
        self.write("src/shape/CMakeLists.txt", "rubicon_module(x SOURCES good.cpp)\n")
        self.write("src/shape/a/one.hpp", '#include "src/shape/b/two.hpp"\n')
        self.write("src/shape/c/four.hpp", '#include "src/shape/a/one.hpp"\n')
        self.assertEqual(check_structure.check(self.root), [])
        self.write("src/shape/b/two.hpp", '#include "src/shape/d/three.hpp"\n')
        self.write("src/shape/d/three.hpp", '#include "src/shape/a/one.hpp"\n')
        self.expect("src/shape: its folders depend on each other in a circle: src/shape/a, src/shape/b, src/shape/d")

    def test_module_without_sources(self):
        self.write("tests/structure/modules.txt", MODULES.replace("src/cli:", "src/new:\nsrc/cli:"))
        self.expect("src/new: is listed in tests/structure/modules.txt and holds no source")

    def test_product_file_named_as_a_test(self):
        self.write("src/shape/box_test.hpp", "#pragma once\n")
        self.expect("src/shape/box_test.hpp: product files are not named as tests are")

    def test_orphan_source(self):
        self.expect_in("src/motion/math/orphan.cpp", "", "src/motion/math/orphan.cpp: no CMakeLists.txt of src/motion/math names it")

    def test_missing_readme(self):
        (self.root / "src/shape/README.md").unlink()
        self.expect("src/shape: has no README.md")
        self.write("src/shape/README.md", "Out: text.\nMay use: nothing.\n")
        self.expect("src/shape/README.md: has no line that starts with In:")

    def test_dead_link(self):
        self.write("docs/guide.md", "\n[gone](missing.md)\n```\n[code](no link)\n```\n")
        self.expect("docs/guide.md:2: links to missing.md")

    def test_top_folder(self):
        (self.root / "CHANGELOG.md").unlink()
        self.expect("CHANGELOG.md: is missing")
        self.write("CHANGELOG.md", "nothing yet\n")
        subprocess.run(["git", "-C", str(self.root), "init", "--quiet"], check=True)
        self.expect()
        self.write("notes/todo.txt", "")
        self.expect("notes: is not one of the known files and folders")

    def test_notices(self):
        self.write("viewer/package.json", '{"devDependencies": {"three": "1.2.3"}}')
        self.expect("THIRD_PARTY_NOTICES.md: does not name three.js 1.2.3")
        self.write("THIRD_PARTY_NOTICES.md", "three.js 1.2.3\n")
        self.expect()

    def test_order_must_be_lowest_first(self):
        self.write("tests/structure/modules.txt", "src/motion/math: src/shape\nsrc/shape:\n")
        with self.assertRaisesRegex(ValueError, "src/shape, which is not listed above it"):
            check_structure.check(self.root)


if __name__ == "__main__":
    unittest.main()
