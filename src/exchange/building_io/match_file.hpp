#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/motion/geometry/shape.hpp"

namespace rubicon::building_io {

/// How elements are put into place. Texts stand in the plan as they are.
struct MoveTerms {
  std::string by;                     ///< "crane" or "crane, riggers"
  std::string hook, adjust, release;  ///< "4 min by riggers"; empty: none
  std::string grip;                   ///< a frame behind the middle of the upper side; empty: that
  std::string priority;               ///< of the tasks; empty: none
  std::string mass;                   ///< "1.2 t"; empty: by density
  std::optional<double> density;      ///< kg/m3
  bool unlinked = false;              ///< what comes after the task does not wait for them
  std::string stock;                  ///< name of the area they wait in; empty: the first with room
  /// Where what is said after each word ("by", "hook", "mass" ...) stands in the match file.
  std::map<std::string, interpreter::Span, std::less<>> places;
};

/// One line of a match file.
struct MatchRule {
  /// All must hold; patterns as matches_glob has them.
  struct Condition {
    enum class Field { storey, type, name, guid, file };
    Field field = Field::name;
    std::string pattern;
  };
  enum class Action {
    task,      ///< the task puts them there
    stands,    ///< they stand there from the beginning
    leave_out  ///< they are no part of the plan
  };
  std::vector<Condition> conditions;
  Action action = Action::task;
  std::string task;      ///< its name in the schedule, or in the plan
  bool in_plan = false;  ///< which of the two
  MoveTerms terms;
  interpreter::Span span;       ///< of the rule
  interpreter::Span task_span;  ///< of the name of the task
};

/// Where elements wait: a box on whose floor they lie in rows.
struct StockArea {
  std::string name;  ///< may be empty
  geometry::Box box;
  int stack = 1;     ///< so many flat ones lie on each other
  double gap = 0.5;  ///< m between them
};

/// Which elements of a building belong to which tasks of its schedule, who puts them there, and
/// what else the plan has.
struct MatchFile {
  std::string plan_items;                      ///< robots, crews, site ...: items of the plan
  std::vector<interpreter::Span> plan_places;  ///< of the texts that plan_items is made of
  std::set<std::string> workers;               ///< names of the robots and crews in them
  std::set<std::string> calendars;             ///< names of the calendars in them
  std::vector<StockArea> stocks;
  std::vector<MatchRule> rules;
};

/// Reads a match file; mistakes are errors (I12) at their place.
MatchFile read_match_file(const interpreter::SourceMap& sources, interpreter::FileId file,
                          interpreter::Diagnostics& diagnostics);

}  // namespace rubicon::building_io
