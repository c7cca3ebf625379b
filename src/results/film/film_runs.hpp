#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubicon::film {

/// A row of the head's `runs`; times in seconds.
struct FilmRun {
  std::string task;
  int robot = -1;
  double start = 0;
  std::optional<double> end;
  std::string result;
  std::string reason;
  std::string because;
  std::string after;
  bool happened = true;
  double last = 0;  ///< the time of its last record
};

/// The runs of the tasks of a plan; a task (a robot that is parked) may run several times.
class FilmRuns {
 public:
  /// The run of the task that is not over; -1: none.
  int open_run(std::string_view task) const;
  /// Begins a run of a task that has no open one; its number.
  int begin(FilmRun run);
  /// The run is over.
  void close(int run);

  FilmRun& operator[](int run) { return runs_[static_cast<std::size_t>(run)]; }
  const std::vector<FilmRun>& all() const { return runs_; }
  /// The last moment of what happened (s).
  double end() const;

 private:
  std::vector<FilmRun> runs_;
  std::map<std::string, int, std::less<>> open_;
};

/// The head's `runs`.
std::string runs_json(const FilmRuns& runs);

}  // namespace rubicon::film
