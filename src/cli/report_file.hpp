#pragma once

#include <string>
#include <string_view>

#include "src/exchange/encoding/sha256.hpp"
#include "src/results/film/film_writer.hpp"
#include "src/results/replay/replay.hpp"

namespace rubicon::cli {

/// Reads a trace for the page that plays it.
class ReportWriter {
 public:
  /// Throws std::invalid_argument as film::FilmWriter::line.
  void line(std::string_view text);
  /// The page. `schedule` is the text of schedule.json, or "". Needs a build that has the page.
  std::string page(const std::string& schedule);

 private:
  std::string flow_text();

  film::FilmWriter film_;
  replay::ReplayReader replay_;
  bool has_steps_ = true;  ///< what `replay_` can read
  encoding::Sha256 trace_;
};

}  // namespace rubicon::cli
