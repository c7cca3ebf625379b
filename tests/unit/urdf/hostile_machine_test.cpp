#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "tests/support/places.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/urdf/machine_support.hpp"

namespace rubicon::urdf::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string machine(const std::string& content) {
  return "<robot name=\"r\">\n" + content + "\n</robot>\n";
}

constexpr const char* kTwo = "<link name=\"a\"/><link name=\"b\"/>\n";

std::string joint(const std::string& inside, const std::string& type = "continuous") {
  return kTwo +
         fmt::format(
             "<joint name=\"j\" type=\"{}\"><parent link=\"a\"/><child link=\"b\"/>{}</joint>",
             type, inside);
}

TEST(HostileMachine, MistakesAreSaidAtTheirPlace) {
  struct Case {
    std::string text;
    const char* error;
  };
  const std::vector<Case> cases = {
      {"", "I20 1: this XML is broken: no document element found"},
      {"<robot>", "I20 1: this XML is broken: start-end tags mismatch"},
      {"<robot name=\"a\"/><robot/>", "I20 1: expected one root element, found another: <robot>"},
      {"<sdf/>", "I20 1: expected a URDF file with the element <robot>, found <sdf>"},
      {"<robot a=\"1\" a=\"2\"/>", "I20 1: attribute 'a' of <robot> is given twice"},
      {"<!DOCTYPE r [<!ENTITY a \"b\">]>\n<robot/>",
       "I20 1: a document type (<!DOCTYPE ...>) is not read"},
      {machine(""), "I24 1: expected at least one <link>, found none"},
      {machine("<link/>"), "I24 2: expected the attribute 'name' in <link>, found none"},
      {machine("<link name=\"a\"/><link name=\"a\"/>"), "I24 2: link 'a' is there twice"},
      {machine(kTwo), "I24 2: expected one first link, found two: 'a' and 'b'"},
      {machine(joint("", "hinge")),
       "I24 3: expected the type fixed, revolute, continuous or prismatic of joint 'j', found "
       "'hinge'"},
      {machine(joint("") + joint("").substr(std::string(kTwo).size())),
       "I24 3: joint 'j' is there twice"},
      {machine(
           "<link name=\"arm\"/><joint name=\"j\" type=\"fixed\"><parent link=\"amr\"/></joint>"),
       "I24 2: there is no link 'amr'; did you mean arm?"},
      {machine("<link name=\"arm\"/><joint name=\"j\" type=\"fixed\"/>"),
       "I24 2: expected <parent> in this joint, found none"},
      {machine(
           kTwo +
           std::string(
               "<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>\n"
               "<joint name=\"k\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>")),
       "I24 4: link 'b' hangs on two joints, 'j' and 'k'; expected a tree"},
      {machine(
           kTwo +
           std::string(
               "<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>\n"
               "<joint name=\"k\" type=\"fixed\"><parent link=\"b\"/><child link=\"a\"/></joint>")),
       "I24 4: joint 'k' closes a ring of links; expected a tree"},
      {machine("<link name=\"a\"/>\n<joint name=\"k\" type=\"fixed\"><parent link=\"a\"/><child "
               "link=\"a\"/></joint>"),
       "I24 3: joint 'k' closes a ring of links; expected a tree"},
      {machine(joint("<axis xyz=\"0 0 0\"/>")),
       "I24 3: expected an axis longer than 0, found '0 0 0'"},
      {machine(joint("<axis xyz=\"0 0\"/>")),
       "I24 3: expected three numbers in 'xyz' of <axis>, found '0 0'"},
      {machine(joint("<origin xyz=\"0 0 nan\"/>")),
       "I24 3: expected three numbers in 'xyz' of <origin>, found '0 0 nan'"},
      {machine(joint("<origin xyz=\"0 0 1e300\"/>")),
       "I24 3: expected three numbers in 'xyz' of <origin>, found '0 0 1e300'"},
      {machine(joint("<origin quat_xyzw=\"0 0 0 1\"/>")),
       "I24 3: expected 'xyz' and 'rpy' in <origin>, found 'quat_xyzw'"},
      {machine(joint("<origin/><origin/>")), "I24 3: <origin> stands twice in this <joint>"},
      {machine(joint("", "revolute")),
       "I24 3: expected <limit lower=\"...\" upper=\"...\" velocity=\"...\"/> in joint 'j', which "
       "is revolute; "
       "found none"},
      {machine(joint("<limit lower=\"1\" upper=\"-1\" velocity=\"1\"/>", "revolute")),
       "I24 3: the limits of joint 'j' go from 1 to -1; expected the smaller first"},
      {machine(joint("<limit lower=\"x\"/>", "revolute")),
       "I24 3: expected a number up to 1000000 in 'lower' of <limit>, found 'x'"},
      {machine(joint("<limit velocity=\"-1\"/>", "revolute")),
       "I24 3: expected a velocity of 0 or more, found -1"},
      {machine(joint("<mimic joint=\"x\"/>")), "I24 3: joint 'j' mimics 'x', which is not there"},
      {machine(joint("<mimic joint=\"j\"/>")), "I24 3: joint 'j' mimics itself over others"},
      {machine("<link name=\"a\"><collision/></link>"),
       "I24 2: expected <geometry> in <collision>, found none"},
      {machine(
           "<link name=\"a\"><visual><geometry><box size=\"1 -1 1\"/></geometry></visual></link>"),
       "I24 2: expected sizes of 0 or more, found '1 -1 1'"},
      {machine(
           "<link name=\"a\"><visual><geometry><sphere radius=\"-1\"/></geometry></visual></link>"),
       "I24 2: expected 'radius' of <sphere> to be 0 or more, found -1"},
      {machine("<link name=\"a\"><visual><geometry><mesh filename=\"m.stl\" scale=\"1 0 "
               "1\"/></geometry></visual></link>"),
       "I24 2: expected a scale other than 0, found '1 0 1'"},
      {machine("<link name=\"a\"><visual><geometry><mesh "
               "filename=\"m.stl\"/></geometry></visual></link>"),
       "I23 2: this mesh cannot be had: there is no file 'm.stl'"},
  };
  for (const Case& each : cases) EXPECT_EQ(error_of(each.text), each.error) << each.text;
}

TEST(HostileMachine, EntitiesAreNeverExpanded) {
  std::string bomb = "<!DOCTYPE r [<!ENTITY a0 \"x\">";
  for (int i = 1; i < 60; ++i) bomb += fmt::format("<!ENTITY a{0} \"&a{1};&a{1};\">", i, i - 1);
  EXPECT_THAT(error_of(bomb + "]>\n<robot name=\"&a59;\"/>"), HasSubstr("a document type"));
}

TEST(HostileMachine, LinksAndElementsAreCounted) {
  std::string links = "<robot name=\"r\">\n";
  for (int i = 0; i < 1'000'000; ++i) links += fmt::format("<link name=\"l{}\"/>\n", i);
  links += "</robot>";
  EXPECT_EQ(error_of(links), "I21 500001: expected at most 500000 elements, found more");
  std::string chain = "<robot name=\"r\">\n<link name=\"l0\"/>\n";
  for (int i = 1; i <= 10'000; ++i) chain += fmt::format("<link name=\"l{}\"/>\n", i);
  EXPECT_EQ(error_of(chain + "</robot>"), "I21 10002: expected at most 10000 links, found more");
  std::string joints = "<robot name=\"r\">\n<link name=\"l0\"/>\n";
  for (int i = 1; i <= 1'000; ++i) {
    joints += fmt::format(
        "<link name=\"l{0}\"/><joint name=\"j{0}\" type=\"continuous\">"
        "<parent link=\"l{1}\"/><child link=\"l{0}\"/></joint>\n",
        i, i - 1);
  }
  EXPECT_EQ(error_of(joints + "</robot>"),
            "I21 1002: expected at most 999 joints that move, found more");
  std::string fixed = "<robot name=\"r\">\n<link name=\"l0\"/>\n";
  for (int i = 1; i <= 5'000; ++i) {
    fixed += fmt::format(
        "<link name=\"l{0}\"/><joint name=\"j{0}\" type=\"fixed\"><origin xyz=\"1 0 0\"/>"
        "<parent link=\"l{1}\"/><child link=\"l{0}\"/></joint>\n",
        i, i - 1);
  }
  EXPECT_THAT(error_of(fixed + "</robot>"),
              HasSubstr("more fixed joints hang on each other here than a frame can hold"));
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  for (int i = 0; i < 100'000; ++i) deep += "</a>";
  EXPECT_EQ(error_of(deep), "I21 1: expected elements at most 200 deep in each other, found more");
}

/// Any damage is a message or a machine, never a crash.
TEST(HostileMachine, SmokeDamagedText) {
  std::ifstream file(test::source_dir() + "/tests/unit/urdf/stool.urdf");
  std::stringstream content;
  content << file.rdbuf();
  const std::string whole = content.str();
  ASSERT_TRUE(import({whole}).machine) << import({whole}).said();
  std::mt19937 random(5);
  for (int i = 0; i < test::cases(3000); ++i) {
    std::string text = whole;
    for (int k = static_cast<int>(random() % 4); k >= 0; --k) {
      const std::size_t at = random() % text.size();
      const std::size_t from = random() % text.size();
      const std::size_t length = random() % 20;
      switch (random() % 4) {
        case 0:
          text.erase(at, length);
          break;
        case 1:
          text.insert(at, text.substr(from, length));
          break;
        case 2:
          text[at] = static_cast<char>(random() % 256);
          break;
        default:
          text[at] = "<>\"{}$()'=:/*^|1"[random() % 16];
      }
      if (text.empty()) text = " ";
    }
    const Imported imported = import({text});
    EXPECT_NE(imported.machine.has_value(), imported.diagnostics.has_errors()) << text;
  }
}

}  // namespace
}  // namespace rubicon::urdf::testing
