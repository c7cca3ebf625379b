#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/grammar/parse_support.hpp"

/// Mistakes and how the parser goes on after them: one mistake, one message, at its place.
namespace rubicon {
namespace {

using grammar_test::mistakes;
using interpreter::TextKind;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> in_script(std::string_view text) {
  return mistakes(text, TextKind::script);
}
std::vector<std::string> in_robot(std::string_view text) { return mistakes(text, TextKind::robot); }
std::vector<std::string> in_plan(std::string_view text) { return mistakes(text, TextKind::plan); }

constexpr const char* kStillOpen =
    "error: ';' ends a statement, but this chain is still open: separate its elements with ',' or "
    "close it with '}'";

std::string still_open(std::string_view place) { return std::string(place) + ": " + kStillOpen; }

TEST(Recovery, SemicolonInsideAChain) {
  EXPECT_THAT(in_script("chain {move_to(z, goal(z)); move_dir(z, 1)};"),
              ElementsAre(still_open("1:27")));
}

TEST(Recovery, MissingBraceBeforeTheNextStatement) {
  EXPECT_THAT(in_script("chain {move_to (theta, r_goal(theta));\nvar(x) = dir(x, r_goal(x));"),
              ElementsAre(still_open("1:38")));
}

TEST(Recovery, UnclosedChainAtTheEndOfTheFile) {
  EXPECT_THAT(in_script("chain {move_to(x, goal(x)), each {move_dir(x,1), move_dir(x,-1)};\n\n"),
              ElementsAre(still_open("1:65")));
  EXPECT_THAT(in_script("chain {move_to(x, goal(x))"),
              ElementsAre("1:27: error: missing '}' to close this chain"));
}

TEST(Recovery, AMissingBraceIsOneMistakeWhateverStandsBehindIt) {
  EXPECT_THAT(
      in_plan("plan p {\n"
              "  crew c { size 2;\n"
              "  component a { shape box(0, 0, 0, 1, 1, 1); }\n"
              "  component b { shape box(0, 0, 0, 1, 1, 1); }\n"
              "  task t { by g; move a to trans(20, 0, 0); }\n"
              "  task u { by g; move b to trans(30, 0, 0); after t; }\n"
              "}\n"),
      ElementsAre("3:3: error: 'component' does not belong into this crew; is a '}' missing "
                  "before it?"));
  EXPECT_THAT(
      in_plan("plan p {\n"
              "  calendar day { mon-fri 07:00-12:00, 12:30-16:00;\n"
              "  crew masons { size 3; calendar day; }\n"
              "  component a { shape box(0, 0, 0, 1, 1, 1); }\n"
              "  task t { by masons; takes 1 h; }\n"
              "}\n"),
      ElementsAre(
          "3:3: error: 'crew' does not belong into this calendar; is a '}' missing before it?"));
  EXPECT_THAT(in_plan("plan p {\n"
                      "  calendar day { mon-fri 07:00-12:00;\n"
                      "  start_at \"2026-03-02 07:00\";\n"
                      "  earth e { grid 2, 2; }\n"
                      "}\n"),
              ElementsAre("3:3: error: 'start_at' does not belong into this calendar; is a '}' "
                          "missing before it?"));
  EXPECT_THAT(
      in_robot("robot gantry {\n"
               "  body bridge { param x step(1); frame trans(x, 0, 0);\n"
               "  body hoist on bridge { param z step(1); frame trans(0, 0, z); }\n"
               "  tool hoist;\n"
               "  behaviour \"g.motion\";\n"
               "}\n"),
      ElementsAre(
          "3:3: error: 'body' does not belong into this body; is a '}' missing before it?"));
}

TEST(Recovery, MissingSeparator) {
  EXPECT_THAT(in_script("chain {move_to(z, goal(z)) move_dir(z, 1)};"),
              ElementsAre("1:28: error: expected ',' or '}' in this chain, found 'move_dir'"));
}

TEST(Recovery, CommaAtTheEndOfAStatement) {
  EXPECT_THAT(in_script("var(a) = 3, chain {move_to(x, 3)};"),
              ElementsAre("1:11: error: ',' separates the elements of a chain, cycle or each; a "
                          "statement ends with ';'"));
}

TEST(Recovery, RemarkWithoutItsSign) {
  EXPECT_THAT(
      in_script("set the goal height\nvar(height) = 30;"),
      ElementsAre("1:1: error: 'set the ...' is not a statement; if it is a remark put # in "
                  "front of it"));
}

TEST(Recovery, TheRemarksOfThePaper) {
  const std::vector<std::string> found = in_script(
      "move clear of the goal height\n"
      "chain {\n"
      "  move_to (theta, goal(theta)),\n"
      "  while staying clear of any obstacles\n"
      "  move_dir (z, dir(z, max(z)))\n"
      "};\n"
      "which {\n"
      "  transport:\n"
      "  when transporting an object\n"
      "  stop clear of the goal\n"
      "  chain {move_to(z, var(height) + goal(z))};\n"
      "  default:\n"
      "  else\n"
      "  lower the end-effector to the goal height\n"
      "  chain {move_to (z, goal(z))};\n"
      "};\n"
      "finally, adopt the correct orientation\n"
      "chain {\n"
      "  and rotational motion\n"
      "  moves:\n"
      "  or rotate the other way\n"
      "  move_to (theta, goal(theta))\n"
      "};\n");
  std::vector<std::string> places;
  for (const std::string& line : found) {
    EXPECT_THAT(line,
                ::testing::HasSubstr("is not a statement; if it is a remark put # in front of it"));
    places.push_back(line.substr(0, line.find(": ")));
  }
  EXPECT_THAT(places, ElementsAre("1:1", "4:3", "9:3", "10:3", "13:3", "14:3", "17:1", "19:3",
                                  "20:3", "21:3"));
}

/// The listing of section 4.3 as it was printed, with # put before its prose: five braces are lost.
constexpr const char* kAgentListing =
    "var(theta) = dir(theta, r_goal(theta));\n"
    "which {\n"
    "  transport:\n"
    "    # when transporting an object\n"
    "    # try to orientate itself relative to the goal\n"
    "    chain {move_to (theta, r_goal(theta))@;\n"
    "          var(x) = dir(x, r_goal(x));\n"
    "    # keep an orientation towards the goal\n"
    "    # while the goal has not been reached\n"
    "    chain {move_to (theta, r_goal(theta)),\n"
    "           move_to (x, r_goal(x)),\n"
    "           move_dir (theta, dir(theta, r_goal(theta))),\n"
    "    # follow the boundary of the obstacle by\n"
    "    # using a combination of the following\n"
    "    # moves:\n"
    "      # move forward\n"
    "      move_dir (x, var(x)),\n"
    "      # rotate one way\n"
    "      move_dir (theta, var(theta)),\n"
    "      # move backward\n"
    "      move_dir (x, -var(x)),\n"
    "      # or rotate the other way\n"
    "      move_dir (theta, -var(theta))@;\n"
    "  default:\n"
    "    # else\n"
    "  # follow the same behavior but assume the axis\n"
    "  # is not oriented\n"
    "  chain {move_to (theta, axis(theta, r_goal(theta)))@;\n"
    "        var(x) = dir(x, r_goal(x));\n"
    "  chain {move_to (theta, axis (theta, r_goal(theta))),\n"
    "         move_to (x, r_goal(x)),\n"
    "         move_dir (theta, dir(theta, r_goal(theta))),\n"
    "         move_dir (x, var(x)),\n"
    "         move_dir (theta, var(theta)),\n"
    "         move_dir (x, -var(x)),\n"
    "         move_dir (theta, -var(theta))@;\n"
    "};\n"
    "# finally, adopt the correct orientation\n"
    "chain {move_to (theta, goal(theta))@;\n";

std::string listing_with(std::string_view brace) {
  std::string text = kAgentListing;
  for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@')) {
    text.replace(at, 1, brace);
  }
  return text;
}

TEST(Recovery, TheLostBracesOfThePaper) {
  EXPECT_THAT(in_script(listing_with("")),
              ElementsAre(still_open("6:42"), still_open("23:36"), still_open("28:53"),
                          still_open("36:39"), still_open("39:36")));
}

TEST(Recovery, ThePaperParsesWithItsBraces) {
  EXPECT_THAT(in_script(listing_with("}")), IsEmpty());
}

TEST(Recovery, UnknownCommand) {
  EXPECT_THAT(in_script("chain {moveto(x, 3)};"),
              ElementsAre("1:8: error: unknown command 'moveto'; did you mean move_to?"));
  EXPECT_THAT(in_script("chian { move_to(x, 1), move_to(z, 2) };\nvar(a) = 1;"),
              ElementsAre("1:1: error: unknown command 'chian'; did you mean chain?"));
}

TEST(Recovery, FunctionAsStatement) {
  EXPECT_THAT(in_script("dir(x, 3);"),
              ElementsAre("1:1: error: 'dir' is a function: it gives a value and cannot stand as a "
                          "statement"));
}

TEST(Recovery, AssignmentWithoutVar) {
  EXPECT_THAT(in_script("height = 30;"),
              ElementsAre("1:8: error: only variables can be assigned: write var(height) = ..."));
  EXPECT_THAT(in_script("base.x = 30;"),
              ElementsAre("1:8: error: only variables can be assigned: write var(base.x) = ..."));
}

TEST(Recovery, HabitsOfOtherLanguages) {
  EXPECT_THAT(in_script("x := 3;"),
              ElementsAre("1:3: error: only variables can be assigned: write var(x) = ..."));
  EXPECT_THAT(in_script("var(a) == 3;"),
              ElementsAre("1:8: error: expected '=' and a value, found '=='"));
  EXPECT_THAT(in_script("var(a) = 1,5;"), ElementsAre("1:11: error: expected ';', found ','"));
  EXPECT_THAT(in_script("while (x > 3) { wait; }"),
              ElementsAre("1:1: error: unknown command 'while'"));
  EXPECT_THAT(in_script("var(a) = x && y;"), ElementsAre("1:12: error: unexpected character '&'"));
}

TEST(Recovery, PlacesAreStartsOfTokens) {
  EXPECT_THAT(in_plan("plan p { task t { move c toward trans(0, 0, 0); } }"),
              ElementsAre("1:26: error: expected 'to' and a frame, found 'toward'"));
  EXPECT_THAT(in_plan("plan p { calendar c { mon 07:00-12; } }"),
              ElementsAre("1:33: error: expected a time such as 16:30, found '12'"));
}

TEST(Recovery, LabelMissing) {
  EXPECT_THAT(in_script("which { chain {move_to(x, goal(x))}; };"),
              ElementsAre("1:9: error: expected a label such as 'transport:' or 'default:' in this "
                          "which"));
}

TEST(Recovery, UnexpectedCharacter) {
  EXPECT_THAT(in_script("var(a) = 3 @ 4;"), ElementsAre("1:12: error: unexpected character '@'"));
  EXPECT_THAT(in_script("var(ä) = 3;"),
              ElementsAre("1:5: error: 'ä' cannot stand in a name: names have the letters a to z, "
                          "digits and _"));
}

TEST(Recovery, HyphensInNames) {
  EXPECT_THAT(in_plan("plan p { task set-a1 { remove c; } crew m; }"),
              ElementsAre("1:18: error: '-' cannot stand in a name: names have the letters a to z, "
                          "digits and _"));
  EXPECT_THAT(in_plan("plan p-1 { crew the-men; }"),
              ElementsAre("1:7: error: '-' cannot stand in a name: names have the letters a to z, "
                          "digits and _"));
  // Where a number may stand it is a minus.
  EXPECT_THAT(in_plan("plan p { parameter a = 3; parameter b = a-1; }"), ElementsAre());
}

TEST(Recovery, EveryMistakeOfAFileInOneRun) {
  EXPECT_THAT(
      in_script("var(a) = 3 +;\n"
                "chain {moveto(x, 3), move_dir(z 1), goal(x), move_dir(z, 1)} until (x > );\n"
                "var(b = 3;\n"
                "wait 3;\n"
                "var(c) = 2 < 3 < 4;\n"
                "chain { move_to(x, 1) };\n"
                "until (x > 3);\n"
                "}\n"
                "var(d) = 1"),
      ElementsAre("1:13: error: expected a value, found ';'",
                  "2:8: error: unknown command 'moveto'; did you mean move_to?",
                  "2:33: error: expected ',' and a value, found '1'",
                  "2:37: error: 'goal' is a function: it gives a value and cannot stand as a "
                  "statement",
                  "2:73: error: expected a value, found ')'", "3:7: error: expected ')', found '='",
                  "4:6: error: expected ';', found '3'",
                  "5:16: error: expected one comparison at a time (a < b and b < c), found '<'",
                  "7:1: error: until stands behind the '}' of a chain, cycle or first",
                  "8:1: error: this '}' closes nothing",
                  "9:11: error: expected ';' before the end of the file"));
}

TEST(Recovery, MissingSemicolon) {
  EXPECT_THAT(in_script("var(a) = 3\nchain {move_to(x, 1)};"),
              ElementsAre("2:1: error: expected ';' before 'chain'"));
}

TEST(Recovery, MissingParenthesisDoesNotSwallowTheNextElement) {
  EXPECT_THAT(in_script("chain {move_to(x, goal(x), move_dir(z 1)};"),
              ElementsAre("1:26: error: expected ')', found ','",
                          "1:39: error: expected ',' and a value, found '1'"));
}

TEST(Recovery, BrokenStatementsAreMarkedAsAWhole) {
  const grammar_test::ParsedScript parsed(
      "chain {move_to(x, ), each {move_dir(z, 1)}};\nvar(a) = 3;\nset the height\nwait;");
  ASSERT_EQ(parsed.script.statements.size(), 3u);
  EXPECT_EQ(parsed.script.statements[0].kind, syntax::Statement::Kind::broken);
  EXPECT_EQ(parsed.script.statements[1].kind, syntax::Statement::Kind::assignment);
  EXPECT_EQ(parsed.script.statements[2].kind, syntax::Statement::Kind::wait);
}

TEST(Recovery, ReservedWordsAreNoNames) {
  EXPECT_THAT(in_script("var(each) = 3;"),
              ElementsAre("1:5: error: expected the name of a variable, found 'each'"));
}

TEST(Recovery, TogetherTakesOnlyMotions) {
  EXPECT_THAT(
      in_script("together { move_to(x, 1), wait };"),
      ElementsAre("1:27: error: expected move_to or move_dir in this together, found 'wait'"));
}

TEST(Recovery, Robots) {
  EXPECT_THAT(
      in_robot("robot r {\n"
               "  time_stp 3;\n"
               "  body mast {\n"
               "    param x step(3)\n"
               "    param y;\n"
               "    rule x = x + 3;\n"
               "    frame rota(3);\n"
               "    shape box(1, 2, 3 foo);\n"
               "    pram z;\n"
               "  }\n"
               "  tool mast\n"
               "  behaviour { chain {move_to(x, goal(x)); }\n"
               "}\n"),
      ElementsAre("2:3: error: unknown item 'time_stp' in this robot; did you mean time_step?",
                  "5:5: error: expected ';', found 'param'",
                  "6:12: error: expected '<-', found '='",
                  "7:11: error: expected a frame such as trans(x, y, z) or rotz(theta), found "
                  "'rota'",
                  "8:23: error: unknown unit 'foo'",
                  "9:5: error: unknown item 'pram' in this body; did you mean param?",
                  "12:3: error: expected ';', found 'behaviour'", still_open("12:41")));
}

TEST(Recovery, Plans) {
  EXPECT_THAT(
      in_plan("plan p {\n"
              "  robot \"x.robot\"\n"
              "  start x 0 y 3;\n"
              "  gaol x 3;\n"
              "  task t { by a b; move c trans(0, 0, 0); hook 3 mn; go at trans(0, 0; }\n"
              "  crew a { cost 30; siz 3; }\n"
              "  calendar c { mon 7-8; tue 07:00; }\n"
              "}\n"),
      ElementsAre("3:3: error: expected ';', found 'start'", "3:13: error: expected ';', found 'y'",
                  "4:3: error: unknown item 'gaol' in this plan; did you mean goal?",
                  "5:17: error: expected ';', found 'b'",
                  "5:27: error: expected 'to' and a frame, found 'trans'",
                  "5:50: error: unknown unit 'mn'; did you mean mm?",
                  "5:70: error: expected ',' or ')', found ';'",
                  "6:17: error: expected an amount per h, such as 180 per h",
                  "6:21: error: unknown item 'siz' in this crew; did you mean size?",
                  "7:20: error: expected a time such as 07:00, found '7'",
                  "7:34: error: expected '-' and the end of the shift, found ';'"));
}

TEST(Recovery, AMissingBraceIsOneMistake) {
  EXPECT_THAT(in_plan("plan p {\n"
                      "  component a\n"
                      "    shape box(0, 0, 0, 1, 1, 1); at trans(0, 0, 0);\n"
                      "  }\n"
                      "  task t\n"
                      "    by c;\n"
                      "    dig 3 m3 { load trucks takes 3 min; }\n"
                      "    takes 5 min;\n"
                      "  }\n"
                      "  task u { by c; takes 5 min; after t }\n"
                      "  task v by c; takes 5 min;\n"
                      "  task w { by c; takes 5; foo; }\n"
                      "  task x by c; takes 5 min;\n"
                      "}\n"),
              ElementsAre("3:5: error: expected '{' after component, found 'shape'",
                          "6:5: error: expected '{' after task, found 'by'",
                          "10:39: error: expected ';', found '}'",
                          "11:10: error: expected '{' after task, found 'by'",
                          "12:27: error: unknown item 'foo' in this task; did you mean for?",
                          "13:10: error: expected '{' after task, found 'by'"));
}

}  // namespace
}  // namespace rubicon
