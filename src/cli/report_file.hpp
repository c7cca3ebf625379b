#pragma once

#include <optional>
#include <string>

#include "src/results/film/film_writer.hpp"

namespace rubicon::cli {

/// Writes the page that plays what `writer` has read to `path`; a message if that fails. `schedule`
/// is the text of schedule.json, or "". Needs a build that has the page.
std::optional<std::string> write_report(const std::string& path, film::FilmWriter& writer,
                                        const std::string& schedule);

}  // namespace rubicon::cli
