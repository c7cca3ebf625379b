#pragma once

#include <simdjson.h>

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "src/simulation/trace/record.hpp"

namespace rubicon::trace {

/// The value of a member is of another kind; `expected` says what it should have been.
struct WrongValue {
  const char* expected;
};

/// Reads the values of the members of one record, each by the type of what it is read into; throws
/// WrongValue. Holds what texts and lists are views of until the next record.
class RecordValues {
 public:
  using Value = simdjson::ondemand::value;

  /// The next record begins.
  void clear() { used_lists_ = used_numbers_ = 0; }

  void read(Value& from, std::string_view& into);
  void read(Value& from, bool& into);
  void read(Value& from, int& into);
  void read(Value& from, double& into);
  void read(Value& from, Ticks& into);
  void read(Value& from, std::optional<Hit>& into);
  void read(Value& from, Names& into);
  void read(Value& from, Numbers& into);
  void read(Value& from, Configuration& into);
  void read(Value& from, NamedValues& into);
  void read(Value& from, RefusalCounts& into);
  void read(Value& from, math::Pose& into);

  /// A value or null.
  template <typename T>
  void read(Value& from, std::optional<T>& into) {
    if (is_null(from)) {
      into.reset();
    } else {
      read(from, into.emplace());
    }
  }

 private:
  static bool is_null(Value& from);

  std::vector<std::string_view> parameters_;
  std::array<std::vector<double>, 6> numbers_;  ///< no record has more lists of numbers
  std::vector<ParameterValue> q_;
  std::array<std::vector<NamedValue>, 2> lists_;  ///< `residual` and `vars`
  std::size_t used_lists_ = 0;
  std::size_t used_numbers_ = 0;
};

}  // namespace rubicon::trace
