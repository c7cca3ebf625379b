#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "src/simulation/trace/trace_sink.hpp"

namespace rubicon::film {

/// What a page plays (docs/film.md).
struct Film {
  std::string plan;   ///< its name
  std::string bytes;  ///< not compressed
};

class FilmBuilder;

/// Takes the lines of a trace and keeps what a film shows of them, in columns of a few bytes a
/// record.
class FilmWriter : public trace::TraceSink {
 public:
  FilmWriter();
  FilmWriter(FilmWriter&&) noexcept;
  FilmWriter& operator=(FilmWriter&&) noexcept;
  ~FilmWriter() override;

  /// Throws std::invalid_argument, with a message for the user, for what is no line of a trace or
  /// cannot come here; the writer is of no use then.
  void line(std::string_view text) override;
  void restart() override;

  /// Whether a header was read.
  bool has_header() const;

  /// Once all lines are read; no line may follow but after `restart`. `schedule` is the text of
  /// schedule.json, `flow` what flow::flow_json tells, or "" where there is none. Throws
  /// std::invalid_argument if one is no JSON; needs a header.
  Film finish(std::string_view schedule, std::string_view flow = "");

 private:
  std::unique_ptr<FilmBuilder> builder_;
};

}  // namespace rubicon::film
