#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/exchange/project_io/fields.hpp"
#include "src/exchange/project_io/value_text.hpp"

namespace rubicon::project_io {

/// What a schedule says and a plan has no word for, carried along in the plan's import block, one
/// statement for each element: KEYWORD NAME word value word value ... ; NAME is the element's name
/// in the plan. It is part of the language, so checking and formatting a plan keep it.
struct CarriedItem {
  std::string text;
  bool quoted = false;
};
struct CarriedRecord {
  std::string keyword;
  std::string name;
  std::vector<CarriedItem> items;
  interpreter::Span span;

  /// The value behind a word; null if the word is not there.
  const std::string* value(std::string_view word) const;
};

/// The statements of the import blocks of a plan that are called `schedule`, in file order.
std::vector<CarriedRecord> carried_records(const interpreter::PlanModel& plan,
                                           const interpreter::SourceMap& sources);

/// Text as a string of a plan: quotes, ampersands and control characters as in XML (&quot;).
std::string quoted(std::string_view text);

/// Writes the fields of a record that differ from those of a new one, as " word value".
class CarriedWriter {
 public:
  template <typename T>
  void operator()(const char* word, const char* /*element*/, const T& member) {
    add(word, text_of(member), std::is_same_v<T, int> || std::is_same_v<T, std::int64_t>);
  }

  /// The texts of all fields, to compare with.
  struct Field {
    const char* word;
    std::string text;
    bool is_number;
  };
  const std::vector<Field>& fields() const { return fields_; }
  /// The fields whose text is another than in `usual`, which has the same fields.
  std::string changed(const CarriedWriter& usual) const;

 private:
  void add(const char* word, std::string text, bool is_number) {
    fields_.push_back({word, std::move(text), is_number});
  }
  std::vector<Field> fields_;
};

/// Reads them back; a word that is not there leaves the field alone, `wrong` gets a word whose
/// value is none.
class CarriedReader {
 public:
  explicit CarriedReader(const CarriedRecord& record) : record_(record) {}

  template <typename T>
  void operator()(const char* word, const char* /*element*/, T& member) {
    const std::string* text = record_.value(word);
    if (text != nullptr && !project_io::read(*text, member)) wrong_.emplace_back(word);
  }
  const std::vector<std::string>& wrong() const { return wrong_; }

 private:
  const CarriedRecord& record_;
  std::vector<std::string> wrong_;
};

}  // namespace rubicon::project_io
