#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "interpreter/check/check.hpp"
#include "interpreter/parse/parse.hpp"
#include "tests/support/growth.hpp"
#include "tests/support/places.hpp"
#include "tests/unit/check/script_robots.hpp"

namespace rubicon::test {

namespace {

using interpreter::Diagnostic;
using interpreter::Diagnostics;
using interpreter::ScriptContext;
using interpreter::Severity;

/// A script and the diagnostics it deserves, as they stand in script_cases.txt.
struct Case {
  std::string title;
  std::string robot;  ///< a name of script_robots(), or none
  std::string body;   ///< the body whose behaviour the script is, empty: the robot's own
  bool has_plan = false;
  std::vector<std::string> situations;
  std::string script;
  std::vector<std::string> expected;  ///< line:column: [code ]level: message
};

/// Reads cases: `--- title [robot]` or `[robot.body]`, `plan(a, b)` where there is a plan; then the
/// script, indented by four; then `  => ...` for each diagnostic. Lines beginning with # are for
/// people.
std::vector<Case> read_cases(const std::string& path) {
  std::ifstream file(path);
  std::vector<Case> cases;
  static const std::regex kTitle(R"(--- (.*?) \[(\w+)(?:\.(\w+))?\](?: plan\(([^)]*)\))?\s*)");
  static const std::regex kWord(R"(\w+)");
  for (std::string line; std::getline(file, line);) {
    std::smatch match;
    if (std::regex_match(line, match, kTitle)) {
      Case next{match[1], match[2], match[3], match[4].matched, {}, {}, {}};
      const std::string words = match[4];
      for (std::sregex_iterator word(words.begin(), words.end(), kWord), end; word != end; ++word) {
        next.situations.push_back(word->str());
      }
      cases.push_back(next);
    } else if (line.rfind("---", 0) == 0) {
      ADD_FAILURE() << "not a title: " << line;
    } else if (line.rfind("  => ", 0) == 0) {
      cases.back().expected.push_back(line.substr(5));
    } else if (!cases.empty() && !line.empty() && line[0] != '#') {
      cases.back().script += (line.size() > 4 ? line.substr(4) : "") + "\n";
    }
  }
  return cases;
}

std::vector<Diagnostic> check(const Case& given, interpreter::SourceMap& sources) {
  const interpreter::FileId file = sources.add("script.motion", given.script);
  Diagnostics diagnostics;
  const syntax::Script script = interpreter::parse_script(sources, file, diagnostics);
  ScriptContext context;
  if (given.robot != "none") {
    context.robot = &script_robots().at(given.robot);
    for (std::size_t i = 0; i < context.robot->bodies.size(); ++i) {
      if (context.robot->bodies[i].name == given.body) context.body = static_cast<int>(i);
    }
    if (given.robot == "finisher" && given.body.empty()) {
      context.body_behaviours = {"base", "carriage", "effector"};
    }
  }
  context.has_plan = given.has_plan;
  context.plan_situations = given.situations;
  interpreter::check_script(script, context, diagnostics);
  return diagnostics.sorted();
}

std::vector<std::string> texts(const Case& given, bool with_code) {
  interpreter::SourceMap sources;
  std::vector<std::string> result;
  for (const Diagnostic& diagnostic : check(given, sources)) {
    const interpreter::Position at = sources.position(diagnostic.span);
    const char* level = diagnostic.severity == Severity::error     ? "error"
                        : diagnostic.severity == Severity::warning ? "warning"
                                                                   : "note";
    result.push_back(fmt::format("{}:{}: {}{}: {}", at.line, at.column,
                                 with_code ? diagnostic.code + " " : "", level,
                                 diagnostic.message));
  }
  return result;
}

const std::string kCases = test::source_dir() + "/tests/unit/check/script_cases.txt";

std::string listed(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "  => " + line + "\n";
  return text;
}

TEST(ScriptCheck, SaysExactlyWhatEachCaseDeserves) {
  const std::vector<Case> cases = read_cases(kCases);
  ASSERT_GT(cases.size(), 100u);
  for (const Case& given : cases) {
    EXPECT_EQ(listed(texts(given, true)), listed(given.expected)) << given.title << "\n"
                                                                  << given.script;
  }
}

TEST(ScriptCheck, EveryCodeIsProvokedByACase) {
  std::string all;
  for (const Case& given : read_cases(kCases)) all += listed(given.expected);
  for (const char* code :
       {"S05", "S06", "S08", "S09", "S10", "S11", "S12", "S13", "S14", "S15", "W01",
        "W02", "W03", "W04", "W05", "W06", "W07", "W08", "W09", "N01", "N02"}) {
    EXPECT_NE(all.find(std::string(": ") + code + " "), std::string::npos) << code;
  }
}

TEST(ScriptCheck, AgreesWithTheSpecificationsOwnCases) {
  const std::string path = test::source_dir() + "/../shared/golden/static_checks.txt";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const std::vector<Case> cases = read_cases(path);
  ASSERT_GT(cases.size(), 20u);
  for (const Case& given : cases) {
    EXPECT_EQ(listed(texts(given, false)), listed(given.expected)) << given.title << "\n"
                                                                   << given.script;
  }
}

// Scripts of one long line or one long list: time must grow with their length, not with its square,
// and no stack runs out. Each is checked at two lengths; a square would make the longer one sixteen
// times slower.
TEST(ScriptCheck, LargeScriptsTakeLinearTime) {
  const std::vector<std::pair<const char*, std::string (*)(int)>> shapes = {
      {"long sum",
       [](int n) {
         std::string text = "var(a) = 1";
         for (int i = 0; i < std::min(n, 9000); ++i) text += " + goal(x)";
         return text + ";";
       }},
      {"many behaviours in a row",
       [](int n) {
         std::string text = fmt::format("b{}; behaviour b0 {{ wait; }}", n);
         for (int i = 1; i <= n; ++i) text += fmt::format(" behaviour b{} {{ b{}; }}", i, i - 1);
         return text;
       }},
      {"many branches",
       [](int n) {
         std::string text;
         for (int i = 0; i < n; ++i) {
           text +=
               fmt::format("which {{ transport: var(v{}) = 1; default: var(v{}) = 2; }}\n", i, i);
         }
         return text;
       }},
      {"many wrong names",
       [](int n) {
         std::string text;
         for (int i = 0; i < n; ++i)
           text += fmt::format("nam{}; behaviour name{} {{ wait; }}", i, i);
         return text;
       }},
      {"long chain",
       [](int n) {
         std::string text = "var(a) = 3; chain { move_dir(x, 1)";
         for (int i = 0; i < n; ++i) text += ", move_to(z, var(a)), move_dir(x, 1)";
         return text + "};";
       }},
  };
  for (const auto& [title, make] : shapes) {
    const auto check_at = [make = make](int n) {
      Case given;
      given.robot = "crane";
      given.script = make(n);
      return [given] {
        interpreter::SourceMap sources;
        check(given, sources);
      };
    };
    // 16 is linear, 256 quadratic.
    EXPECT_TRUE(grows_at_most(64, check_at(1250), check_at(20000))) << title;
  }
}

TEST(ResolveParameter, PrefersTheBodyAndTellsAmbiguous) {
  const robot::RobotModel& robot = script_robots().at("finisher");
  const auto named = [](const char* body, const char* name) {
    syntax::QualifiedName result;
    if (*body != '\0') result.body = syntax::Name{body, {}};
    result.name.text = name;
    return result;
  };
  EXPECT_EQ(interpreter::resolve_parameter(robot, -1, named("", "z")), 1);
  EXPECT_EQ(interpreter::resolve_parameter(robot, -1, named("carriage", "z")), 1);
  EXPECT_EQ(interpreter::resolve_parameter(robot, -1, named("", "x")), -2);
  EXPECT_EQ(interpreter::resolve_parameter(robot, 0, named("", "x")), 0);
  EXPECT_EQ(interpreter::resolve_parameter(robot, 2, named("", "x")), 2);
  EXPECT_EQ(interpreter::resolve_parameter(robot, 1, named("", "x")), -2);
  EXPECT_EQ(interpreter::resolve_parameter(robot, 0, named("effector", "x")), 2);
  EXPECT_EQ(interpreter::resolve_parameter(robot, -1, named("", "y")), -1);
  EXPECT_EQ(interpreter::resolve_parameter(robot, -1, named("base", "z")), -1);
  EXPECT_EQ(interpreter::resolve_parameter(robot, -1, named("roof", "x")), -1);
}

}  // namespace

}  // namespace rubicon::test
