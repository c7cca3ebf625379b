"""Holds the sources to the order of modules in modules.txt and to the house rules that a compiler cannot check.

usage: check_structure.py [ROOT]    prints one line a violation (file:line: what, and why); exit code 1 if there is any
"""

import json
import pathlib
import re
import subprocess
import sys
from dataclasses import dataclass


@dataclass(frozen=True)
class Rule:
    """Code that may stand in some files only."""

    pattern: re.Pattern
    allowed: re.Pattern  # files (paths from the root) where it may stand
    why: str


_NUMERIC = "a?(?:sin|cos|tan)h?|atan2|sincos|pow|exp|exp2|expm1|log|log2|log10|log1p|cbrt|hypot"

RULES = [
    Rule(
        re.compile(r"#\s*include\s*<(?:tao/|tao\.)"),
        re.compile(r"^grammar/.*\.hpp$|\.cpp$"),
        "PEGTL costs minutes of compile time: only .cpp files and the rules in grammar/ include it",
    ),
    Rule(
        re.compile(r"#\s*include\s*<(?:fcl/|assimp/|pugixml|simdjson)"),
        re.compile(r"\.cpp$|(?:^|/)\w*(?:fcl|assimp|pugixml|simdjson)\w*\.hpp$"),
        "FCL, assimp, pugixml and simdjson stay hidden in the .cpp files that need them, or in headers named after them",
    ),
    Rule(
        re.compile(rf"\bstd\s*::\s*(?:{_NUMERIC})[fl]?\b|(?<![\w.>:])(?:::\s*)?\b(?:{_NUMERIC})[fl]?\s*\("),
        re.compile(r"^src/motion/math/angles\.cpp$"),
        "the C library's results differ between machines: use src/motion/math/angles.hpp",
    ),
    Rule(
        re.compile(r"\b(?:AngleAxis[df]?|Rotation2D[df]?|eulerAngles|slerp|angularDistance)\b"),
        re.compile(r"^src/motion/math/angles\.cpp$"),
        "Eigen calls the C library's trigonometry here: use src/motion/math/angles.hpp",
    ),
    Rule(
        re.compile(r"#\s*include\s*<(?:chrono|ctime|time\.h|fcntl\.h|unistd\.h|sys/\w+\.h|fstream|iostream)>"
                   r"|\b(?:getenv|secure_getenv|random_device|fopen|system|popen)\s*\(|\bstd::(?:cout|cerr|cin)\b"),
        re.compile(r"^src/cli/|(?:^|/)\w+_io(?:/|\.)"),
        "only src/cli and files named *_io touch disk, stdout, the clock or the environment",
    ),
]

# The documents for those who join, and all that may lie in the top folder.
TOP_DOCUMENTS = {"CHANGELOG.md", "CONTRIBUTING.md", "THIRD_PARTY_NOTICES.md"}
TOP = TOP_DOCUMENTS | {
    ".ci", ".clang-format", ".clang-tidy", ".editorconfig", ".git-blame-ignore-revs", ".gitattributes", ".gitignore",
    "CMakeLists.txt", "CMakePresets.json", "README.md", "bench", "cmake", "docs", "examples", "grammar", "interpreter",
    "robots", "scripts", "src", "taskplans", "tests", "viewer",
}

# Headers that show the types of a hidden library or of the grammar: for .cpp files of their module and one another.
PRIVATE_HEADER = re.compile(r"/\w*(?:fcl|assimp|pugixml|simdjson)\w*\.hpp$|^interpreter/(?:\w+/)?parse_\w+\.hpp$")


def read_modules(text):
    """(direct uses, uses hidden in .cpp files): module -> list of modules, in the order of the file."""
    uses, hidden = {}, {}
    target = uses
    for line in text.splitlines():
        line = line.split("#")[0].strip()
        if line == "hidden:":
            target = hidden
        elif line:
            module, _, rest = line.partition(":")
            unknown = [name for name in rest.split() if name not in uses]
            if unknown:
                raise ValueError(f"modules.txt: {module} is built on {unknown[0]}, which is not listed above it")
            target[module] = rest.split()
    return uses, hidden


def closure(uses):
    """module -> set of all modules it may include, itself too."""
    result = {}
    for module, direct in uses.items():  # lowest first, so those below are there already
        result[module] = {module}.union(*(result[name] for name in direct))
    return result


def without_comments(text, keep_strings):
    """The text with comments (and the inside of strings, unless kept) blanked; line numbers stay."""
    token = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\((?:.*?)\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.DOTALL)

    def blank(match):
        found = match.group()
        if keep_strings and not found.startswith("/"):
            return found
        return re.sub(r"[^\n]", " ", found)

    return token.sub(blank, text)


def module_of(path, modules):
    """The module a path (from the root) lies in, or None."""
    inside = [name for name in modules if path.startswith(name + "/")]
    return max(inside, key=len) if inside else None


def line_of(text, offset):
    return text.count("\n", 0, offset) + 1


def check_includes(path, text, may_use, hidden):
    """Includes against the order of modules."""
    module = module_of(path, may_use)
    for match in re.finditer(r'^[ \t]*#\s*include\s*"([^"]+)"', without_comments(text, keep_strings=True), re.MULTILINE):
        target = match.group(1)
        place = f"{path}:{line_of(text, match.start(1))}"
        used = module_of(target, may_use)
        hides = path.endswith(".cpp") or PRIVATE_HEADER.search(path) is not None
        if PRIVATE_HEADER.search(target) and not (hides and used == module):
            yield f"{place}: includes {target}; only .cpp files of {used} may include this private header"
        if used is None:
            yield f"{place}: includes \"{target}\"; name project headers from the top folder, e.g. \"src/motion/math/pose.hpp\""
        elif used in hidden.get(module, []):
            if not hides:
                yield f"{place}: includes {used}; only the .cpp files of {module} may"
        elif used not in may_use[module]:
            allowed = ", ".join(name for name in may_use if name in may_use[module] - {module}) or "no other module"
            yield f"{place}: {module} may not use {used} (it may use {allowed})"


def check_rules(path, text):
    """Code that may stand elsewhere only."""
    code = without_comments(text, keep_strings=False)
    for rule in RULES:
        if not rule.allowed.search(path):
            for match in rule.pattern.finditer(code):
                yield f"{path}:{line_of(code, match.start())}: {match.group().strip()}: {rule.why}"


def check_folders(root, uses):
    """Every folder of sources is a listed module with a README and lists its sources by name."""
    sources = sorted((root / "src").rglob("*.[ch]pp"))
    for folder in sorted({source.parent.relative_to(root).as_posix() for source in sources}):
        if module_of(folder + "/", uses) is None:
            yield f"{folder}: is not listed in tests/structure/modules.txt"
    for module in uses:
        folder = root / module
        if not any(folder.rglob("*.cpp")) and not any(folder.rglob("*.hpp")):
            yield f"{module}: is listed in tests/structure/modules.txt and holds no source"
            continue
        readme = folder / "README.md"
        if not readme.is_file():
            yield f"{module}: has no README.md that says what goes in, what comes out and what it may use"
        elif module != "grammar":
            missing = [word for word in ("In:", "Out:", "May use:") if word not in readme.read_text(encoding="utf-8")]
            if missing:
                yield f"{module}/README.md: has no line that starts with {missing[0]}"
        lists = "".join(path.read_text(encoding="utf-8") for path in sorted(folder.rglob("CMakeLists.txt")))
        for source in sorted(folder.rglob("*.cpp")):
            if source.name not in lists:
                yield f"{source.relative_to(root).as_posix()}: no CMakeLists.txt of {module} names it, so nobody builds it"


def check_rooms(root, uses):
    """The folders inside a module do not depend on each other in a circle."""
    for module in uses:
        needs = {}
        for source in sorted((root / module).rglob("*.[ch]pp")):
            room = source.parent.relative_to(root).as_posix()
            for target in re.findall(r'^[ \t]*#\s*include\s*"([^"]+)"', source.read_text(encoding="utf-8"), re.MULTILINE):
                used = target.rpartition("/")[0]
                if used != room and (used + "/").startswith(module + "/") and module_of(target, uses) == module:
                    needs.setdefault(room, set()).add(used)
        while True:
            free = [room for room in needs if not needs[room] & needs.keys()]
            if not free:
                break
            for room in free:
                del needs[room]
        # The rooms that only need what lies in a circle are not in it themselves.
        while True:
            wanted = set().union(*needs.values()) if needs else set()
            outside = [room for room in needs if room not in wanted]
            if not outside:
                break
            for room in outside:
                del needs[room]
        if needs:
            yield f"{module}: its folders depend on each other in a circle: {', '.join(sorted(needs))}"


def check_top(root):
    """The top folder holds what newcomers expect there, and nothing else."""
    for name in sorted(TOP_DOCUMENTS):
        if not (root / name).is_file():
            yield f"{name}: is missing"
    try:
        listed = subprocess.run(["git", "-C", str(root), "ls-files", "--cached", "--others", "--exclude-standard"],
                                capture_output=True, text=True, check=True).stdout.split("\n")
    except (OSError, subprocess.CalledProcessError):
        return  # an unpacked archive
    for name in sorted({path.split("/")[0] for path in listed if path} - TOP):
        yield f"{name}: is not one of the known files and folders at the top (check_structure.py lists them)"


def check_notices(root):
    """The third-party notices name each version of a library that the report page is built with."""
    package, notices = root / "viewer/package.json", root / "THIRD_PARTY_NOTICES.md"
    if not package.is_file() or not notices.is_file():
        return
    version = json.loads(package.read_text(encoding="utf-8"))["devDependencies"]["three"]
    if version not in notices.read_text(encoding="utf-8"):
        yield f"THIRD_PARTY_NOTICES.md: does not name three.js {version}, which viewer/package.json asks for"


def check_links(root):
    """Links in our documents lead somewhere."""
    documents = [root / "README.md", *(root / name for name in sorted(TOP_DOCUMENTS) if (root / name).is_file()),
                 *sorted((root / "docs").rglob("*.md"))]
    for document in documents:
        if not document.is_file():
            yield f"{document.relative_to(root).as_posix()}: is missing"
            continue
        text = re.sub(r"```.*?```", lambda code: re.sub(r"[^\n]", " ", code.group()),
                      document.read_text(encoding="utf-8"), flags=re.DOTALL)
        for match in re.finditer(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", text):
            target = match.group(1)
            if "://" not in target and not target.startswith("mailto:") and not (document.parent / target).exists():
                place = f"{document.relative_to(root).as_posix()}:{line_of(text, match.start())}"
                yield f"{place}: links to {target}, which does not exist"


def check(root):
    """All violations under a project root, as a list of lines."""
    uses, hidden = read_modules((root / "tests/structure/modules.txt").read_text(encoding="utf-8"))
    may_use = closure(uses)
    found = []
    for module in uses:
        for source in sorted((root / module).rglob("*.[ch]pp")):
            path = source.relative_to(root).as_posix()
            text = source.read_text(encoding="utf-8")
            if source.stem.endswith("_test") and not path.startswith("src/cli/command_"):
                found.append(f"{path}: product files are not named as tests are")
            found += check_includes(path, text, may_use, hidden)
            found += check_rules(path, text)
    found += check_folders(root, uses)
    found += check_rooms(root, uses)
    found += check_top(root)
    found += check_notices(root)
    found += check_links(root)
    return found


def main(arguments):
    root = pathlib.Path(arguments[0]) if arguments else pathlib.Path(__file__).resolve().parents[2]
    found = check(root)
    for line in found:
        print(line)
    print(f"{len(found)} violations" if found else "the sources keep to the order of modules")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
