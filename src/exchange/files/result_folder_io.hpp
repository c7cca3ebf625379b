#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "src/exchange/files/atomic_file_io.hpp"
#include "src/exchange/files/temporaries_io.hpp"

namespace rubicon::files {

/// What a result folder may hold of ours. A new result takes the place of those that an older one
/// left there (own_names); everything else in the folder is somebody's, and stays.
inline constexpr std::array<std::string_view, 22> kResultNames = {
    "trace.jsonl", "trace.jsonl.gz", "schedule.json", "schedule.csv", "loads.csv",   "report.html",
    "study.json",  "study.html",     "runs.csv",      "variants.csv", "drivers.csv", "progress.csv",
    "ways.json",   "ways.csv",       "jobs.json",     "jobs.csv",     "agents.csv",  "charts.json",
    "charts.csv",  "charts.svg",     "walk.json",     "walk.csv"};

/// Where a file of a result stands: in the folder; or, if a program was ended while it put a new
/// result there file by file, still in that result.
std::string result_path(const std::string& folder, std::string_view name);
/// The trace of a result: trace.jsonl, or, where only that is there, trace.jsonl.gz.
std::string result_trace(const std::string& folder);

/// A result that is to be made: what it may write, and the files that it was made of.
struct ResultTerms {
  std::vector<std::string> names;  ///< some of kResultNames
  std::set<std::string> read;
};

/// A result on its way to its folder. It is written to a temporary folder and, when it is whole,
/// takes the place of the old one by a single rename, so that whoever looks finds one or the other
/// (docs/commands/run.md tells when this cannot be, and what is done then). While it is alive its
/// temporary folder is locked; one that is not locked was left over, and is removed by the next.
class ResultFolder {
 public:
  /// Why this result must not go to `path`: one of its files would take the place of one that is
  /// not of a result of ours, or is read; a message, or nothing. Left over folders are cleared.
  static std::optional<std::string> obstacle(const std::string& path, const ResultTerms& terms);
  /// Makes the temporary folder, and folders on the way to `path`; a message if that fails, or
  /// where there is an obstacle.
  static std::variant<ResultFolder, std::string> open(const std::string& path, ResultTerms terms);
  ResultFolder(ResultFolder&& other) noexcept;
  ResultFolder& operator=(ResultFolder&&) = delete;
  /// What was not committed goes.
  ~ResultFolder();

  /// A new file of the result, one of kResultNames.
  std::variant<AtomicFile, std::string> create(std::string_view name) const;
  std::optional<std::string> write(std::string_view name, std::string_view bytes) const;
  /// Puts the result in its place; a message if it is not there then. Its files are committed
  /// before.
  std::optional<std::string> commit();

 private:
  ResultFolder() = default;
  int make_temporary(const std::string& pattern);
  void protect();
  std::vector<std::string> written() const;
  void keep_modes(const std::set<std::string>& old) const;
  std::optional<std::string> replace();
  int exchange(const std::set<std::string>& old);

  ResultTerms terms_;
  std::string shown_;              ///< as the user named it
  std::string target_;             ///< without links
  std::string temporary_;          ///< "" once it has its place
  std::vector<std::string> made_;  ///< folders on the way that were not there, deepest first
  int lock_ = -1;
  bool beside_ = true;  ///< the temporary folder stands beside the target, else in it
  Temporaries guard_;
};

}  // namespace rubicon::files
