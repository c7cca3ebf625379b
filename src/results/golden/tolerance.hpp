#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rubicon::golden {

/// How far a time or a cost may be from what a golden expects: so much, or a share of it.
struct Allowance {
  double absolute = 0;  ///< s, or the plan's currency
  double share = 0;     ///< 0.05: 5 %

  double of(double expected) const;
};

/// What the `tolerance` of a golden says: of the plan, and of tasks that have their own.
class Tolerance {
 public:
  /// Nothing is allowed where `document` has no `tolerance`. Throws std::invalid_argument with a
  /// sentence for people where it cannot be read.
  explicit Tolerance(const nlohmann::ordered_json& document);

  /// `what` is "time" or "cost"; `task` "" for the plan.
  Allowance of(std::string_view what, const std::string& task) const;

  /// The names of tasks that have their own.
  std::vector<std::string> tasks() const;

 private:
  nlohmann::ordered_json members_ = nlohmann::ordered_json::object();
};

}  // namespace rubicon::golden
