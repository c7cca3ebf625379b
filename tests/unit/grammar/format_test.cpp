#include <gtest/gtest.h>

#include <cstdint>
#include <iterator>

#include "tests/unit/grammar/format_oracle.hpp"

namespace rubicon {
namespace {

using interpreter::format_text;
using interpreter::TextKind;

/// `text` formatted, after checking that its meaning stays and that nothing changes the next time.
std::string formatted(std::string_view text, TextKind kind = TextKind::script) {
  EXPECT_EQ(grammar_test::check_formatting(text, kind), "");
  EXPECT_NE(grammar_test::parsed_tree(text, kind), "") << "the example has mistakes";
  return format_text(text, kind);
}

TEST(Format, StatementsAndSpaces) {
  EXPECT_EQ(formatted("chain{move_to (x,goal( x ))}until(x>3);var(a)=-3*( b+1);x1;"),
            "chain { move_to(x, goal(x)) } until (x > 3);\n"
            "var(a) = -3 * (b + 1);\n"
            "x1;\n");
}

TEST(Format, ListsAcrossLinesAreBrokenAtEveryElement) {
  EXPECT_EQ(formatted("chain {move_to(x, 1),\n move_to(z, 2), each { wait, up }};"),
            "chain {\n"
            "  move_to(x, 1),\n"
            "  move_to(z, 2),\n"
            "  each { wait, up }\n"
            "};\n");
}

TEST(Format, ListsThatDoNotFitAreBroken) {
  EXPECT_EQ(formatted("chain { move_dir(theta, dir(theta, r_goal(theta))), move_dir(theta, "
                      "dir(theta, r_goal(theta))), wait };"),
            "chain {\n"
            "  move_dir(theta, dir(theta, r_goal(theta))),\n"
            "  move_dir(theta, dir(theta, r_goal(theta))),\n"
            "  wait\n"
            "};\n");
}

TEST(Format, LabelsAndTheirStatements) {
  EXPECT_EQ(
      formatted(
          "which{\nnight:safety:up;down;\ntransport:\nup;\ndown;\nvia:;\ndefault: chain{wait}}"),
      "which {\n"
      "  night: safety: up; down;\n"
      "  transport:\n"
      "    up;\n"
      "    down;\n"
      "  via: ;\n"
      "  default: chain { wait }\n"
      "}\n");
}

TEST(Format, CommentsAndBlankLinesStay) {
  EXPECT_EQ(
      formatted("# head\n\n\n\nchain { # why\n   # first\n  wait, // then\n\n\n  up\n}; # done\n\n"
                "/* block\n   of text */\nup; /* short */ down;"),
      "# head\n"
      "\n"
      "chain {  # why\n"
      "  # first\n"
      "  wait,  // then\n"
      "\n"
      "  up\n"
      "};  # done\n"
      "\n"
      "/* block\n"
      "   of text */\n"
      "up; /* short */\n"
      "down;\n");
}

TEST(Format, CommentsInsideStatements) {
  formatted(
      "chain # a\n { # b\n wait # c\n , # d\n up /* e */ } # f\n until # g\n ( # h\n x > 3 # i\n ) "
      "# j\n ;");
  formatted("which { # a\n night # b\n : # c\n up # d\n ; when # e\n (x > 3) # f\n : # g\n }");
}

TEST(Format, LongStatementsGoOnIndented) {
  const std::string text = formatted(
      "var(a) = aaaaaaaaaaaaaaaaaaaaaaaaaaaaa + bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb + "
      "cccccccccccccccccccccccccccc + dddddddddddddddd;");
  EXPECT_EQ(text,
            "var(a) = aaaaaaaaaaaaaaaaaaaaaaaaaaaaa + bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb +\n"
            "    cccccccccccccccccccccccccccc + dddddddddddddddd;\n");
}

TEST(Format, Robots) {
  EXPECT_EQ(
      formatted(
          "robot r{time_step 1;body b on a{param x step(1cm)range( -1 ,2);rule x<-x+x_s*cos(x);\n"
          "frame trans(x,0,0)*rotz(- 3);}\ncapacity(3 m,4 "
          "t),(5,6);behaviour{chain{move_to(x,x<-1)};}}",
          TextKind::robot),
      "robot r {\n"
      "  time_step 1;\n"
      "  body b on a {\n"
      "    param x step(1 cm) range(-1, 2);\n"
      "    rule x <- x + x_s * cos(x);\n"
      "    frame trans(x, 0, 0) * rotz(-3);\n"
      "  }\n"
      "  capacity (3 m, 4 t), (5, 6);\n"
      "  behaviour { chain { move_to(x, x < -1) }; }\n"
      "}\n");
}

TEST(Format, PlacesBehindWords) {
  EXPECT_EQ(formatted("plan p{network n{map \"a.map\";agent a from(1,2)to(3,4);}"
                      "task t{cover hall{from(0,0);inlet( 3,4);}}}",
                      TextKind::plan),
            "plan p {\n"
            "  network n { map \"a.map\"; agent a from (1, 2) to (3, 4); }\n"
            "  task t { cover hall { from (0, 0); inlet (3, 4); } }\n"
            "}\n");
}

TEST(Format, Meshes) {
  EXPECT_EQ(
      formatted("robot r{body b{shape mesh( \"a.stl\",mm,hull ,part \"x\");}}", TextKind::robot),
      "robot r { body b { shape mesh(\"a.stl\", mm, hull, part \"x\"); } }\n");
}

TEST(Format, Attributes) {
  EXPECT_EQ(
      formatted(
          "plan p{component c{name   \"St\xC3\xBCtze  1\";storey \"0\"\n;attribute fire\n\"60 "
          "min\";shape sphere(0,0,0,1);}task t{name \"a\";attribute b \"\";}}",
          TextKind::plan),
      "plan p {\n"
      "  component c {\n"
      "    name \"St\xC3\xBCtze  1\";\n"
      "    storey \"0\";\n"
      "    attribute fire \"60 min\";\n"
      "    shape sphere(0, 0, 0, 1);\n"
      "  }\n"
      "  task t { name \"a\"; attribute b \"\"; }\n"
      "}\n");
}

TEST(Format, Plans) {
  EXPECT_EQ(
      formatted("plan p{start theta  - 10,x 3;\ncalendar c{mon - fri 07:00 - 12:00,13:00-17:00;}"
                "crew a{cost 180per h;}\ntask t{after a SS+2h,b - 30min;takes 3 h;}}",
                TextKind::plan),
      "plan p {\n"
      "  start theta -10, x 3;\n"
      "  calendar c { mon-fri 07:00-12:00, 13:00-17:00; }\n"
      "  crew a { cost 180 per h; }\n"
      "  task t { after a SS + 2 h, b - 30 min; takes 3 h; }\n"
      "}\n");
}

/// Comments, blanks and line ends wherever a token may end.
TEST(Format, KeepsTheMeaningWhereverCommentsStand) {
  const struct {
    const char* text;
    TextKind kind;
  } seeds[] = {
      {"var(h) = 8 m; chain { move_to(z, max(z, -var(h))), each { wait, up } } until (x >= 2);\n"
       "which { night: safety: up; down; when (abs(x) > 3): ; default: first { wait } }\n"
       "together { move_to(x, 1), move_dir(z, 1) }; behaviour up { wait; }",
       TextKind::script},
      {"robot r { time_step 1 s; body b { param x step(1); rule x <- x + x_s; frame trans(x, 0, "
       "0);\n"
       "behaviour { chain { wait } } } capacity (3 m, 4 t), (5, 6); tool b at rotz(3); }",
       TextKind::robot},
      {"plan p { calendar c { mon-fri 07:00-12:00; off 2026-12-25; } task t { by a, b;\n"
       "hook 4 min by a; after u SS + 2 h; } component d { name \"D 1\"; attribute fire \"60 "
       "min\"; } "
       "robot a \"r\" { cost 180 per h; start x -3, y 2; } }",
       TextKind::plan}};
  const char* const pieces[] = {"# c\n",  "/* b */", "/* b\n  c */", " ", "\n",
                                "\n\n\n", "\r\n",    "//\n",         "\t"};
  std::uint32_t state = 7;
  const auto next = [&state](std::size_t below) {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) % below;
  };
  int valid = 0;
  for (int run = 0; run < 1500; ++run) {
    const auto& seed = seeds[run % 3];
    std::string text = seed.text;
    for (std::size_t count = 1 + next(8); count > 0; --count) {
      const std::size_t at = text.find_first_of("{}(),; ", next(text.size()));
      if (at != std::string::npos)
        text.insert(at, " " + std::string(pieces[next(std::size(pieces))]));
    }
    EXPECT_EQ(grammar_test::check_formatting(text, seed.kind), "") << text;
    if (!grammar_test::parsed_tree(text, seed.kind).empty()) ++valid;
  }
  EXPECT_GT(valid, 500);
}

TEST(Format, TextsWithMistakesStayAsTheyAre) {
  const std::string text = "chain{move_to(x,  3;";
  EXPECT_EQ(format_text(text, TextKind::script), text);
}

TEST(Format, LineEndsAndMarksAreMadeOne) {
  EXPECT_EQ(formatted("\xef\xbb\xbfwait;\r\n# remark  \r\nup;"), "wait;\n# remark\nup;\n");
  EXPECT_EQ(formatted(""), "");
}

TEST(Format, Studies) {
  EXPECT_EQ(
      formatted(
          "study   s{plan \"p.plan\";vary a 1 , -2 to 3 by .5,\"x\";vary yard.b[2]  3m;# why\n"
          "runs at most 500 until width( p80(finish) )<4h;seed 1;\n"
          "ask makespan,start ( set [ 3 ] );choose least mean(cost) with p80(finish)<="
          "\"2026-03-27\",rejected<.02;}",
          TextKind::study),
      "study s {\n"
      "  plan \"p.plan\";\n"
      "  vary a 1, -2 to 3 by .5, \"x\";\n"
      "  vary yard.b[2] 3 m;  # why\n"
      "  runs at most 500 until width(p80(finish)) < 4 h;\n"
      "  seed 1;\n"
      "  ask makespan, start(set[3]);\n"
      "  choose least mean(cost) with p80(finish) <= \"2026-03-27\", rejected < .02;\n"
      "}\n");
}

}  // namespace
}  // namespace rubicon
