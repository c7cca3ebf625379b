// Writer, reader and schema know the same kinds of records with the same members.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "src/simulation/trace/header.hpp"
#include "src/simulation/trace/record_fields.hpp"
#include "src/simulation/trace/trace_reader.hpp"
#include "tests/support/places.hpp"
#include "tests/unit/trace/written_records.hpp"

namespace rubicon::trace {
namespace {

using nlohmann::ordered_json;
using Names = std::set<std::string, std::less<>>;

const RecordSpec& spec_of(const std::string& type) {
  for (const RecordSpec& spec : record_table()) {
    if (spec.type == type) return spec;
  }
  throw std::out_of_range(type);
}

Names names_of(const RecordSpec& spec, bool only_required) {
  Names names = {"type", "task", "robot"};
  for (const FieldSpec& field : spec.fields) {
    if (field.required || !only_required) names.emplace(field.name);
  }
  return names;
}

Names names_of(const ordered_json& object) {
  Names names;
  for (const auto& [name, value] : object.items()) names.insert(name);
  return names;
}

/// What a record is answered with behind a good header; "" if it is read.
std::string answer(const ordered_json& record) {
  TraceReader reader;
  const auto ignore = [](const auto&) {};
  reader.read(test::written_header(test::rich_plan()), ignore, ignore);
  try {
    reader.read(record.dump(), ignore, ignore);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(RecordTable, TheWriterWritesIt) {
  std::map<std::string, Names> all;
  for (const std::string& line : test::written_records()) {
    const auto record = ordered_json::parse(line);
    const Names names = names_of(record);
    const RecordSpec& spec = spec_of(record.at("type"));
    EXPECT_THAT(names_of(spec, false), testing::IsSupersetOf(names)) << line;
    EXPECT_THAT(names, testing::IsSupersetOf(names_of(spec, true))) << line;
    all[record.at("type")].insert(names.begin(), names.end());
    // In the order of the table, so that a reader finds each at once.
    std::size_t next = 0;
    for (const auto& [name, value] : record.items()) {
      if (name == "type" || name == "task" || name == "robot") continue;
      while (next < spec.fields.size() && spec.fields[next].name != name) ++next;
      EXPECT_LT(next, spec.fields.size()) << name << " of " << line;
    }
  }
  for (const RecordSpec& spec : record_table()) {
    EXPECT_EQ(all[std::string(spec.type)], names_of(spec, false)) << spec.type;
  }
}

TEST(RecordTable, TheSchemaSaysIt) {
  std::ifstream file(test::source_dir() + "/docs/trace.schema.json");
  const auto schema = ordered_json::parse(file);
  std::map<std::string, const ordered_json*> records;
  for (const auto& choice : schema.at("oneOf")) {
    const std::string reference = choice.at("$ref");
    const auto& record = schema.at("$defs").at(reference.substr(reference.rfind('/') + 1));
    const auto& type = record.at("properties").at("type");
    for (const auto& name :
         type.contains("enum") ? type.at("enum") : ordered_json{type.at("const")}) {
      records[name] = &record;
    }
  }
  EXPECT_EQ(records.erase("header"), 1u);
  EXPECT_EQ(records.size(), record_table().size());
  for (const RecordSpec& spec : record_table()) {
    ASSERT_TRUE(records.contains(std::string(spec.type))) << spec.type;
    const ordered_json& record = *records.at(std::string(spec.type));
    EXPECT_EQ(names_of(record.at("properties")), names_of(spec, false)) << spec.type;
    Names needed = record.at("required").get<Names>();
    needed.insert("type");
    EXPECT_EQ(needed, names_of(spec, true)) << spec.type;
  }
}

TEST(RecordTable, TheReaderWantsEveryMemberOnceAndOfItsKind) {
  for (const std::string& line : test::written_records()) {
    const auto record = ordered_json::parse(line);
    EXPECT_EQ(answer(record), "");
    const RecordSpec& spec = spec_of(record.at("type"));
    for (const FieldSpec& field : spec.fields) {
      const std::string name(field.name);
      if (!record.contains(name)) continue;
      ordered_json changed = record;
      changed.erase(name);
      EXPECT_EQ(answer(changed).empty(), !field.required) << name << " of " << line;
      changed[name] = ordered_json::array({ordered_json::array()});
      EXPECT_THAT(answer(changed), testing::HasSubstr("'" + name + "' should be")) << line;
    }
  }
}

}  // namespace
}  // namespace rubicon::trace
