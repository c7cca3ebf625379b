#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/urdf/machine_support.hpp"

namespace rubicon::urdf::testing {
namespace {

using ::testing::HasSubstr;

std::string xacro(const std::string& content) {
  return "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n" + content +
         "\n</robot>\n";
}

/// The size of the box of the one link, as the robot file has it.
std::string box(const std::string& before, const std::string& size,
                const std::map<std::string, std::string>& arguments = {}) {
  Asked asked{xacro(before + "<link name=\"a\"><collision><geometry><box size=\"" + size +
                    "\"/></geometry></collision></link>")};
  asked.arguments = arguments;
  const Imported imported = import(asked);
  if (!imported.machine) return imported.said();
  const std::size_t begin = imported.machine->robot.find("box(");
  return imported.machine->robot.substr(begin, imported.machine->robot.find(';') - begin);
}

std::string error(const std::string& content) { return error_of(xacro(content)); }

TEST(Xacro, PropertiesAndExpressions) {
  EXPECT_EQ(box("<xacro:property name=\"w\" value=\"4\"/>", "${w} ${w / 2} ${2 * w}"),
            "box(-2, -1, -4, 2, 1, 4)");
  // Evaluated when it is asked for, as xacro does.
  EXPECT_EQ(box("<xacro:property name=\"w\" value=\"${h + 1}\"/><xacro:property name=\"h\" "
                "value=\"3\"/>",
                "${w} 2 2"),
            "box(-2, -1, -1, 2, 1, 1)");
  EXPECT_EQ(box("<xacro:property name=\"size\" value=\"2 4 6\"/>", "${size}"),
            "box(-1, -2, -3, 1, 2, 3)");
  EXPECT_EQ(box("<xacro:property name=\"w\" default=\"4\"/><xacro:property name=\"w\" "
                "default=\"6\"/>",
                "${w} 2 2"),
            "box(-2, -1, -1, 2, 1, 1)");
}

TEST(Xacro, Arguments) {
  const std::string argument = "<xacro:arg name=\"w\" default=\"4\"/>";
  EXPECT_EQ(box(argument, "$(arg w) 2 2"), "box(-2, -1, -1, 2, 1, 1)");
  EXPECT_EQ(box(argument, "$(arg w) 2 2", {{"w", "6"}}), "box(-3, -1, -1, 3, 1, 1)");
  EXPECT_EQ(box(argument + "<xacro:property name=\"v\" value=\"$(arg w)\"/>", "${v * 2} 2 2"),
            "box(-4, -1, -1, 4, 1, 1)");
  EXPECT_EQ(box(argument, "$(eval 2 * 3) 2 2"), "box(-3, -1, -1, 3, 1, 1)");
  for (const char* const six :
       {"${2*$(arg w)}", "$(eval arg('w') * 2)", "$(eval w * 2)", "$(eval 2 + arg( 'w' ))"}) {
    EXPECT_EQ(box(argument, std::string(six) + " 2 2", {{"w", "3"}}),
              std::string(six).find('+') == std::string::npos ? "box(-3, -1, -1, 3, 1, 1)"
                                                              : "box(-2.5, -1, -1, 2.5, 1, 1)");
  }
  EXPECT_EQ(box(argument, "${2 - $(arg w)} 2 2", {{"w", "-2"}}), "box(-2, -1, -1, 2, 1, 1)");
  EXPECT_EQ(
      error("<link name=\"$(arg n)\"/>"),
      "I22 2: in '$(arg n)' of <link>: the argument 'n' has no value; give it: --arg n=VALUE");
}

TEST(Xacro, MacrosWithValuesBlocksAndConditions) {
  Asked asked{
      xacro(R"(<xacro:macro name="wheel" params="side:='front left' n *place **more r:=${0.5}">
<link name="wheel_${n}"><collision><xacro:insert_block name="place"/><geometry><sphere radius="${r}"/></geometry></collision>
<xacro:insert_block name="more"/></link>
<joint name="j_${n}" type="continuous"><parent link="base"/><child link="wheel_${n}"/></joint></xacro:macro>
<link name="base"/>
<xacro:property name="front" value="true"/>
<xacro:if value="${front}"><xacro:wheel n="${1 + 1}"><origin xyz="1 0 0"/><and><collision><geometry><sphere radius="2"/></geometry></collision></and></xacro:wheel></xacro:if>
<xacro:unless value="${front}"><xacro:nothing/></xacro:unless>)")};
  const Imported imported = import(asked);
  ASSERT_TRUE(imported.machine) << imported.said();
  EXPECT_THAT(imported.machine->robot, HasSubstr("body wheel_2 on base {"));
  EXPECT_THAT(imported.machine->robot, HasSubstr("shape sphere(0, 0, 0, 0.5) at trans(1, 0, 0);"));
  EXPECT_THAT(imported.machine->robot, HasSubstr("shape sphere(0, 0, 0, 2);"));
}

TEST(Xacro, MacrosMayCallThemselvesToAnEnd) {
  Asked asked{xacro(R"(<xacro:macro name="row" params="n"><link name="l_${n}"/>
<xacro:if value="${n > 0}"><joint name="j_${n}" type="fixed"><parent link="l_${n}"/><child link="l_${n - 1}"/></joint>
<xacro:row n="${n - 1}"/></xacro:if></xacro:macro><xacro:row n="30"/>)")};
  EXPECT_TRUE(import(asked).machine) << import(asked).said();
}

TEST(Xacro, MacrosAreKnownToAllWhereverTheyAreDefined) {
  Asked asked{
      xacro(R"(<xacro:macro name="load"><xacro:include filename="parts.xacro"/></xacro:macro>
<xacro:load/><xacro:part xacro:note="n" n="a"/>)")};
  asked.files["parts.xacro"] =
      xacro("<xacro:macro name=\"part\" params=\"n\"><link name=\"${n}\"/></xacro:macro>");
  EXPECT_FALSE(import(asked).machine);  // a macro takes its parameters only
  asked.text.replace(asked.text.find(" xacro:note=\"n\""), 15, "");
  EXPECT_TRUE(import(asked).machine) << import(asked).said();
}

TEST(Xacro, BlocksOfPropertiesAndForwardedParameters) {
  Asked asked{xacro(R"(<xacro:property name="place"><origin xyz="0 0 ${z}"/></xacro:property>
<xacro:property name="z" value="7"/>
<xacro:macro name="ball" params="r:=^|1 q:=^"><link name="a"><collision><xacro:insert_block name="place"/>
<geometry><sphere radius="${r + q}"/></geometry></collision></link></xacro:macro>
<xacro:property name="q" value="2"/><xacro:ball/>)")};
  const Imported imported = import(asked);
  ASSERT_TRUE(imported.machine) << imported.said();
  EXPECT_THAT(imported.machine->robot, HasSubstr("shape sphere(0, 0, 0, 3) at trans(0, 0, 7);"));
}

TEST(Xacro, IncludesAreReadOnceEachPlaceAndErrorsNameTheirFile) {
  Asked asked{
      xacro("<xacro:include filename=\"$(find p)/wheels.xacro\"/>\n<xacro:wheel n=\"1\"/>")};
  asked.files["wheels.xacro"] =
      xacro("<xacro:macro name=\"wheel\" params=\"n\">\n<link name=\"w${n}\"/></xacro:macro>");
  EXPECT_THAT(import(asked).machine->robot, HasSubstr("body w1 {"));
  asked.files["wheels.xacro"] =
      xacro("<xacro:macro name=\"wheel\" params=\"n\">\n<link name=\"w${m}\"/></xacro:macro>");
  const Imported imported = import(asked);
  ASSERT_EQ(imported.diagnostics.all().size(), 1U);
  const auto& diagnostic = imported.diagnostics.all().front();
  EXPECT_EQ(imported.sources.file(diagnostic.span.file).path, "wheels.xacro");
  EXPECT_EQ(imported.said(), "I22 3: in 'w${m}' of <link>: the property 'm' is not known\n");
  ASSERT_EQ(diagnostic.notes.size(), 1U);
  EXPECT_EQ(imported.sources.position(diagnostic.notes[0].span).line, 3);
}

TEST(Xacro, IncludeLoopsAndMissingFiles) {
  Asked asked{xacro("<xacro:include filename=\"a.xacro\"/>")};
  asked.files["a.xacro"] = xacro("<xacro:include filename=\"b.xacro\"/>");
  asked.files["b.xacro"] = xacro("\n<xacro:include filename=\"a.xacro\"/>");
  EXPECT_EQ(error_of(asked), "I22 3: 'a.xacro' includes itself");
  EXPECT_EQ(error("<xacro:include filename=\"c.xacro\"/>"),
            "I23 2: this file cannot be included: there is no file 'c.xacro'");
  // Each of twenty files includes the next one ten times.
  Asked many{xacro("<xacro:include filename=\"0\"/>")};
  for (int i = 0; i < 20; ++i) {
    std::string text;
    for (int k = 0; k < 10; ++k) text += fmt::format("<xacro:include filename=\"{}\"/>\n", i + 1);
    many.files[std::to_string(i)] = xacro(text);
  }
  many.files["20"] = xacro("");
  EXPECT_THAT(error_of(many), HasSubstr("expected at most 500 included files"));
}

TEST(Xacro, BombsAreCounted) {
  EXPECT_THAT(error("<xacro:macro name=\"m\" params=\"\"><xacro:m/></xacro:macro><xacro:m/>"),
              HasSubstr("expected macros at most 100 deep in each other, found more"));
  std::string doubling = "<xacro:macro name=\"m0\"><link name=\"a\"/></xacro:macro>\n";
  for (int i = 1; i <= 40; ++i) {
    doubling += fmt::format("<xacro:macro name=\"m{0}\"><xacro:m{1}/><xacro:m{1}/></xacro:macro>\n",
                            i, i - 1);
  }
  EXPECT_THAT(error(doubling + "<xacro:m40/>"),
              HasSubstr("expected at most 500000 elements after expansion, found more"));
  std::string text = "<xacro:property name=\"p0\" value=\"xxxxxxxxxx\"/>\n";
  for (int i = 1; i <= 25; ++i) {
    text += fmt::format("<xacro:property name=\"p{0}\" value=\"${{p{1} + p{1}}}\"/>\n", i, i - 1);
  }
  EXPECT_THAT(error(text + "<link name=\"${p25}\"/>"), HasSubstr("the text becomes too long"));
  std::string nested = "a";
  for (int i = 0; i < 1000; ++i) nested = "$(arg " + nested + ")";
  EXPECT_THAT(error("<link name=\"" + nested + "\"/>"), HasSubstr("it is nested too deep"));
  EXPECT_THAT(error("<xacro:property name=\"a\" value=\"${b}\"/><xacro:property name=\"b\" "
                    "value=\"${a}\"/><link name=\"${a}\"/>"),
              HasSubstr("needs itself, or too many others"));
  EXPECT_THAT(error("<xacro:property name=\"b\"><xacro:insert_block name=\"b\"/></xacro:property>"
                    "<xacro:insert_block name=\"b\"/>"),
              HasSubstr("expected elements at most 200 deep in each other"));
}

TEST(Xacro, WhatItCannotDoItNames) {
  struct Case {
    const char* content;
    const char* error;
  };
  constexpr Case kCases[] = {
      {"<xacro:whel/>", "I22 2: the macro 'whel' is not known"},
      {"<xacro:macro name=\"wheel\"/><xacro:whel/>",
       "I22 2: the macro 'whel' is not known; did you mean wheel?"},
      {"<xacro:element/>", "I22 2: <xacro:element> is not read here"},
      {"<xacro:include filename=\"a\" ns=\"b\"/>",
       "I22 2: the attribute 'ns' of <xacro:include> is not read here"},
      {"<xacro:include/>",
       "I22 2: expected the attribute 'filename' in <xacro:include>, found none"},
      {"<link name=\"$(env HOME)\"/>",
       "I22 2: in '$(env HOME)' of <link>: $(env) is not read here; arg, find, dirname and eval "
       "are"},
      {"<link name=\"${1\"/>", "I22 2: in '${1' of <link>: expected '}' before its end"},
      {"<xacro:if value=\"maybe\"/>",
       "I22 2: in <xacro:if>: expected true, false or a number, found 'maybe'"},
      {"<xacro:insert_block name=\"b\"/>", "I22 2: the block 'b' is not known"},
      {"<xacro:macro name=\"m\" params=\"a\"/><xacro:m/>",
       "I22 2: <xacro:m> needs a value for its parameter 'a'"},
      {"<xacro:macro name=\"m\" params=\"a\"/><xacro:m a=\"1\" b=\"2\"/>",
       "I22 2: the macro of <xacro:m> has no parameter 'b'"},
      {"<xacro:macro name=\"m\" params=\"*a\"/><xacro:m/>",
       "I22 2: <xacro:m> needs an element for its block 'a'"},
      {"<xacro:macro name=\"m\" params=\"*a\"/><xacro:m><b/><c/></xacro:m>",
       "I22 2: <xacro:m> takes 1 elements, found one more"},
      {"<xacro:macro name=\"m\" params=\"***a\"/>",
       "I22 2: expected names of parameters in params, found '***a'"},
      {"<xacro:property name=\"a\" value=\"1\" scope=\"mine\"/>",
       "I22 2: expected scope=\"global\" or \"parent\", found 'mine'"},
      {"<link name=\"${xacro.load_yaml('a')}\"/>",
       "I22 2: in '${xacro.load_yaml('a')}' of <link>: the function 'xacro.load_yaml' is not known "
       "here"},
  };
  for (const Case& each : kCases) EXPECT_EQ(error(each.content), each.error) << each.content;
}

}  // namespace
}  // namespace rubicon::urdf::testing
