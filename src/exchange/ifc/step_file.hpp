#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace rubicon::ifc {

/// One record of a STEP file, `#12= IFCWALL('1x',#3,$);`. Views into the text of its file.
struct StepRecord {
  std::uint64_t id = 0;
  std::string_view keyword;    ///< IFCWALL, in capitals as it must stand; empty for a record of
                               ///< several parts, `#1=(A()B());`
  std::string_view arguments;  ///< from `(` to `)`
};

/// Where a text is no STEP file, and why.
struct StepError {
  std::size_t line = 0;  ///< from 1
  std::string message;   ///< lower case, for people
};

/// The exchange file of ISO 10303-21 ("STEP physical file") as a list of records: what IFC files
/// are. Nothing of the schema is known here. The text is not trusted: reading takes time and memory
/// in proportion to it, and whatever breaks the form is an error.
class StepFile {
 public:
  /// `text` must outlive the file, and may have at most 2^32 - 1 bytes.
  static std::variant<StepFile, StepError> read(std::string_view text);

  /// The name of the schema in FILE_SCHEMA, such as IFC4; empty if the header has none.
  const std::string& schema() const { return schema_; }
  /// All records of all data sections, in the order of the file.
  const std::vector<StepRecord>& records() const { return records_; }
  /// The record of that number; null when there is none.
  const StepRecord* find(std::uint64_t id) const;
  std::uint64_t largest_id() const { return by_id_.empty() ? 0 : by_id_.back().first; }

 private:
  friend class StepReader;
  std::string schema_;
  std::vector<StepRecord> records_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> by_id_;  ///< id, index; sorted
};

/// The deepest nesting of brackets in a record: real files have three.
inline constexpr int kDeepestBrackets = 64;

}  // namespace rubicon::ifc
