#pragma once

#include <string>
#include <string_view>

#include "src/results/film/film_writer.hpp"

namespace rubicon::page {

/// The page that viewer/ was built into, without a film; empty where the build had no node or npm.
std::string_view viewer_page();

/// The page of studies, without a study; empty where the build had no node or npm.
std::string_view empty_study_page();

/// What to tell a user who asks for a page that this build does not have.
inline constexpr std::string_view kNoViewerPage =
    "this rubicon was built without the page: that takes node (18 or later) and npm";

/// What a page was made of, as SHA-256 in hexadecimal digits; "" where there was none.
struct PageOrigin {
  std::string trace;     ///< of the lines of the trace, each with a line feed
  std::string schedule;  ///< of the bytes of schedule.json
};

/// The page with a film in it: packed and as base64, so that no text of a plan can become markup;
/// the plan's name is in the title, and its head says what it was made of, for `rubicon verify`.
/// Throws std::logic_error if the page has no place for them.
std::string report_page(std::string_view viewer_page, const film::Film& film,
                        const PageOrigin& origin);

/// The page of studies with one in it, as `rubicon study --format json` writes it; its name is in
/// the title. Throws std::logic_error if the page has no place for them.
std::string study_page(std::string_view empty_study_page, std::string_view json,
                       std::string_view name);

}  // namespace rubicon::page
