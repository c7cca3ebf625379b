#pragma once

#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/exchange/building_io/element.hpp"
#include "src/exchange/building_io/match_file.hpp"
#include "src/exchange/building_io/read_elements.hpp"
#include "src/exchange/project_io/project.hpp"

namespace rubicon::test {

/// What was said, "I12 3:7 expected ..." or "I15 ..." where there is no place.
std::vector<std::string> said(const interpreter::Diagnostics& diagnostics,
                              const interpreter::SourceMap& sources);

/// Whether one of them has all of these words.
bool says(const std::vector<std::string>& lines, const std::string& words);

/// A match file, and what was said of it.
struct ReadMatch {
  building_io::MatchFile match;
  std::vector<std::string> said;
};
ReadMatch read_match(const std::string& text);

/// An element at a place, 2 m x 0.2 m x 2.5 m.
building_io::Element element_at(const std::string& storey, const std::string& type,
                                const std::string& name, const building_io::Vec3& at);

/// A schedule of tasks with names, 8 h each, uid 1, 2, 3 ...
project_io::Project schedule_of(const std::vector<std::string>& names);

/// Reads models from a folder: (name, text) are written there.
struct ReadModels {
  building_io::Elements elements;
  std::vector<std::string> said;
};
ReadModels read_models(const std::vector<std::pair<std::string, std::string>>& files,
                       const std::string& unit = {}, char up = 0);

}  // namespace rubicon::test
