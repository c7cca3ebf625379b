#include "src/exchange/ifc/step_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string with_data(const std::string& data) {
  return "ISO-10303-21;\nHEADER;FILE_SCHEMA(('IFC4'));ENDSEC;\nDATA;\n" + data +
         "\nENDSEC;\nEND-ISO-10303-21;\n";
}

StepFile file_of(const std::string& text) {
  auto file = StepFile::read(text);
  EXPECT_TRUE(std::holds_alternative<StepFile>(file)) << std::get<StepError>(file).message;
  return std::get<StepFile>(file);
}

StepError error_of(const std::string& text) {
  const auto file = StepFile::read(text);
  EXPECT_TRUE(std::holds_alternative<StepError>(file)) << text;
  return std::holds_alternative<StepError>(file) ? std::get<StepError>(file) : StepError{};
}

TEST(StepFile, RecordsAreFoundByTheirNumber) {
  const std::string text = with_data("#2=B($);\n#1 = A ( 'x' ) ; #30=C((1,2),#1);");
  const StepFile file = file_of(text);
  EXPECT_EQ(file.schema(), "IFC4");
  ASSERT_EQ(file.records().size(), 3U);
  EXPECT_EQ(file.records()[0].id, 2U);
  ASSERT_NE(file.find(1), nullptr);
  EXPECT_EQ(file.find(1)->keyword, "A");
  EXPECT_EQ(file.find(1)->arguments, "( 'x' )");
  EXPECT_EQ(file.find(3), nullptr);
  EXPECT_EQ(file.largest_id(), 30U);
}

TEST(StepFile, CommentsAndLineBreaksMayStandAnywhere) {
  const std::string text =
      with_data("/* ; */ #1 /* a */ = \r\n A /**/ ( /* ) */ 'it''s /* no comment */',\n 2. );");
  const StepFile file = file_of(text);
  const auto values = StepValues::read(file.find(1)->arguments);
  ASSERT_TRUE(values);
  EXPECT_EQ(values->size(), 2U);
  EXPECT_EQ((*values)[0].decoded(), "it's /* no comment */");
  EXPECT_EQ((*values)[1].number(), 2);
}

TEST(StepFile, SeveralDataSectionsAreOneFile) {
  const std::string text =
      "ISO-10303-21;HEADER;ENDSEC;DATA;#1=A();ENDSEC;DATA('b',('IFC4'));#2=B();ENDSEC;"
      "END-ISO-10303-21;";
  EXPECT_EQ(file_of(text).records().size(), 2U);
}

TEST(StepFile, ARecordOfSeveralPartsHasNoKeyword) {
  const std::string text = with_data("#1=(A(1)B(2));");
  EXPECT_EQ(file_of(text).find(1)->keyword, "");
}

TEST(StepFile, WhatBreaksTheFormIsToldWithItsLine) {
  const auto line_and_text = [](const std::string& data, std::size_t line,
                                const std::string& text) {
    const StepError error = error_of(with_data(data));
    EXPECT_EQ(error.line, line) << data;
    EXPECT_THAT(error.message, HasSubstr(text)) << data;
  };
  line_and_text("#1=A();\n#=B();", 5, "expected the number of a record");
  line_and_text("#1 A();", 4, "expected '=' after the number of a record, found 'A'");
  line_and_text("#1=A(;", 4, "a bracket is not closed before ';'");
  line_and_text("#1=A('b);", 4, "a text is not closed");
  line_and_text("#1=A()\n#2=B();", 5, "expected ';' after a record, found '#'");
  line_and_text("#1=A(); hello", 4, "expected a record such as #12=");
  line_and_text("/* never closed", 4, "a comment is not closed");
  line_and_text("#1=A();\n#1=B();", 5, "two records with the number #1");
  line_and_text("#99999999999999999999=A();", 4, "expected the number of a record");
  line_and_text("#1=A(" + std::string(1'000'000, '(') + ");", 4, "nested too deep");
}

TEST(StepFile, AFileThatIsCutOffIsRefusedWhereverItIsCut) {
  const std::string whole = with_data("#1=A('x',(1,2.5E-3));\n#2=B(#1,.T.,$,*,\"0F\");");
  for (std::size_t length = 0; length + 2 < whole.size(); ++length) {
    const std::string cut = whole.substr(0, length);
    EXPECT_TRUE(std::holds_alternative<StepError>(StepFile::read(cut))) << length;
  }
}

TEST(StepFile, WhatIsNoStepFileIsRefused) {
  EXPECT_THAT(error_of("").message, HasSubstr("expected ISO-10303-21;"));
  EXPECT_THAT(error_of("<?xml version='1.0'?>").message, HasSubstr("expected ISO-10303-21;"));
  EXPECT_THAT(error_of(std::string("\0\0\0", 3)).message, HasSubstr("expected ISO-10303-21;"));
}

TEST(StepValues, EveryKindOfValueIsTold) {
  const auto values = StepValues::read("($,*,-1.5E+3,+2,'a',.MILLI.,#7,\"0F\",(1,(2)),T(0.3),())");
  ASSERT_TRUE(values);
  std::vector<StepKind> kinds;
  for (const StepItem item : values->all()) kinds.push_back(item.kind());
  EXPECT_THAT(kinds,
              ElementsAre(StepKind::unset, StepKind::derived, StepKind::number, StepKind::number,
                          StepKind::text, StepKind::enumeration, StepKind::reference,
                          StepKind::binary, StepKind::list, StepKind::typed, StepKind::list));
  EXPECT_EQ((*values)[2].number(), -1500);
  EXPECT_EQ((*values)[3].number(), 2);
  EXPECT_TRUE((*values)[5].is_enumeration("MILLI"));
  EXPECT_EQ((*values)[6].reference(), 7U);
  EXPECT_EQ((*values)[8].size(), 2U);
  EXPECT_EQ((*values)[8][1][0].number(), 2);
  EXPECT_EQ((*values)[9].text(), "T");
  EXPECT_EQ((*values)[9].number(), 0.3);
  EXPECT_EQ((*values)[10].size(), 0U);
  EXPECT_FALSE((*values)[11].is_set());
  EXPECT_FALSE((*values)[99].is_set());
  EXPECT_THAT(values->references(), ElementsAre(7U));
}

TEST(StepValues, WhatBreaksTheFormIsNoValue) {
  for (const char* text : {"", "1", "(", "(1", "(1,)", "(,1)", "(1 2)", "(1)2)", "('a)", "(a)",
                           "(T)", "(.A)", "(#)", "(1,(2)", "(\"0F)"}) {
    const auto values = StepValues::read(text);
    if (values) {
      EXPECT_STREQ(text, "(1)2)");  // what follows the last bracket is not looked at
    }
  }
}

TEST(StepValues, ANumberThatIsNoneOrNotFiniteHasNoValue) {
  const auto values = StepValues::read("(1.2.3,1E999,--1,.5,1.,-)");
  ASSERT_TRUE(values);
  EXPECT_FALSE((*values)[0].number());
  EXPECT_FALSE((*values)[1].number());
  EXPECT_FALSE((*values)[2].number());
  EXPECT_EQ((*values)[3].number(), 0.5);
  EXPECT_EQ((*values)[4].number(), 1);
  EXPECT_FALSE((*values)[5].number());
}

}  // namespace
}  // namespace rubicon::ifc
