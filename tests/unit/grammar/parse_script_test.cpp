#include <gtest/gtest.h>

#include "tests/unit/grammar/parse_support.hpp"

namespace rubicon {
namespace {

using grammar_test::ParsedScript;
using grammar_test::statement_tree;
using syntax::Expression;
using syntax::Label;
using syntax::Statement;

TEST(ParseScript, EmptyTexts) {
  for (const char* text : {"", " \t\r\n", "# nothing", ";;", "/* a\n b */", "\xef\xbb\xbf"}) {
    const ParsedScript parsed(text);
    EXPECT_TRUE(parsed.diagnostics.all().empty()) << text;
    EXPECT_TRUE(parsed.script.statements.empty()) << text;
  }
}

TEST(ParseScript, EveryStatement) {
  const ParsedScript parsed(
      "behaviour up { wait; }\n"
      "behavior down { up; };\n"
      "var(height) = 30;\n"
      "move_to(x, 3); move_dir(base.z, -1);\n"
      "together { move_to(x, 1), move_dir(z, 1), };\n"
      "wait; up;\n"
      "chain { up, wait, } until (x > 3);\n"
      "cycle { move_dir(x, 1) }\n"
      "first { move_dir(x, 1) } until (time() > 3)\n"
      "each { move_dir(x, 1), move_dir(x, -1) };\n"
      "which { night: safety: up; down; when (x > 3): ; default: wait }\n");
  ASSERT_TRUE(parsed.diagnostics.all().empty()) << parsed.diagnostics.all()[0].message;
  const std::vector<Statement>& statements = parsed.script.statements;
  const Statement::Kind kinds[] = {
      Statement::Kind::assignment, Statement::Kind::move_to, Statement::Kind::move_dir,
      Statement::Kind::together,   Statement::Kind::wait,    Statement::Kind::use,
      Statement::Kind::chain,      Statement::Kind::cycle,   Statement::Kind::first,
      Statement::Kind::each,       Statement::Kind::which};
  ASSERT_EQ(statements.size(), std::size(kinds));
  for (std::size_t i = 0; i < std::size(kinds); ++i) EXPECT_EQ(statements[i].kind, kinds[i]) << i;
  ASSERT_EQ(parsed.script.behaviours.size(), 2u);
  EXPECT_EQ(parsed.script.behaviours[1].name.text, "down");
  EXPECT_EQ(statements[2].name.text(), "base.z");
  EXPECT_EQ(statements[3].elements.size(), 2u);
  EXPECT_EQ(statements[6].elements.size(), 2u);
  EXPECT_TRUE(statements[6].until);
  EXPECT_FALSE(statements[7].until);
  EXPECT_TRUE(statements[8].until);
  ASSERT_EQ(statements[10].modules.size(), 3u);
  ASSERT_EQ(statements[10].modules[0].labels.size(), 2u);
  EXPECT_EQ(statements[10].modules[0].labels[1].name.text, "safety");
  EXPECT_EQ(statements[10].modules[0].statements.size(), 2u);
  EXPECT_EQ(statements[10].modules[1].labels[0].kind, Label::Kind::when);
  EXPECT_TRUE(statements[10].modules[1].labels[0].condition);
  EXPECT_TRUE(statements[10].modules[1].statements.empty());
  EXPECT_EQ(statements[10].modules[2].labels[0].kind, Label::Kind::otherwise);
}

TEST(ParseScript, PlacesOfStatements) {
  const ParsedScript parsed("wait;\n  chain { move_to(x, goal(x)) } until (x > 3) ;\nlift;");
  const Statement& chain = parsed.script.statements[1];
  EXPECT_EQ(parsed.text(chain.keyword), "chain");
  EXPECT_EQ(parsed.text(chain.span), "chain { move_to(x, goal(x)) } until (x > 3)");
  EXPECT_EQ(parsed.sources.position(chain.keyword).line, 2);
  EXPECT_EQ(parsed.sources.position(chain.keyword).column, 3);
  EXPECT_EQ(parsed.text(chain.elements[0].keyword), "move_to");
  EXPECT_EQ(parsed.text(chain.elements[0].span), "move_to(x, goal(x))");
  EXPECT_EQ(parsed.text(chain.elements[0].value->span), "goal(x)");
  EXPECT_EQ(parsed.text(parsed.script.statements[2].keyword), "lift");
}

TEST(ParseScript, PlacesOfExpressions) {
  const ParsedScript parsed("var(a) = (z > 3) + -b * f(1 , 2 ) ;");
  const Expression& sum = *parsed.script.statements[0].value;
  EXPECT_EQ(parsed.text(sum.span), "(z > 3) + -b * f(1 , 2 )");
  EXPECT_EQ(parsed.text(sum.op_span), "+");
  EXPECT_EQ(parsed.text(sum.operands[0]->span), "z > 3");
  EXPECT_EQ(parsed.text(sum.operands[1]->span), "-b * f(1 , 2 )");
  EXPECT_EQ(parsed.text(sum.operands[1]->operands[1]->span), "f(1 , 2 )");
  EXPECT_EQ(parsed.text(sum.operands[1]->operands[1]->name.span), "f");
}

TEST(ParseScript, PrecedenceAndAssociation) {
  const auto same = [](const std::string& a, const std::string& b) {
    const std::string tree = statement_tree("var(v) = " + a + ";");
    EXPECT_FALSE(tree.empty()) << a;
    EXPECT_EQ(tree, statement_tree("var(v) = " + b + ";")) << a;
  };
  same("a - b - c", "(a - b) - c");
  same("a + b * c", "a + (b * c)");
  same("a / b / c", "(a / b) / c");
  same("-a * b", "(-a) * b");
  same("not a < b", "not (a < b)");
  same("a < b and c or d", "((a < b) and c) or d");
  same("not a and b", "(not a) and b");
  same("a - -b", "a - (-b)");
  same("x<-1", "x < (-1)");
  same("θ + ψ_s", "theta + psi_s");
  same("a <= b", "(a) <= (b)");
}

TEST(ParseScript, GreekLettersAreSpelt) {
  const ParsedScript parsed("move_to(Θ, ϑ + ϕ + φ + Ψ);");
  EXPECT_EQ(parsed.script.statements[0].name.text(), "theta");
  EXPECT_EQ(statement_tree("move_to(θ, ϕ);"), statement_tree("move_to(theta, phi);"));
}

TEST(ParseScript, CommandsAsValuesAreKept) {
  const ParsedScript parsed("var(a) = move_to(x, 3);");
  EXPECT_FALSE(parsed.diagnostics.has_errors());
  const Expression& value = *parsed.script.statements[0].value;
  EXPECT_EQ(value.kind, Expression::Kind::command);
  EXPECT_EQ(value.name.text(), "move_to");
  EXPECT_EQ(value.operands.size(), 2u);
  EXPECT_EQ(parsed.sources.position(value.span).column, 10);
}

TEST(ParseScript, EmptyStructuresAreLeftToTheChecks) {
  const ParsedScript parsed("chain {} each { } which {}");
  EXPECT_FALSE(parsed.diagnostics.has_errors());
  EXPECT_EQ(parsed.script.statements.size(), 3u);
}

TEST(ParseScript, LineEndsDoNotMatter) {
  EXPECT_EQ(statement_tree("chain {\r\n move_to(x, 1), # remark\r\n wait\r\n};\r\n"),
            statement_tree("chain { move_to(x, 1), wait };"));
}

}  // namespace
}  // namespace rubicon
