#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/exchange/files/result_folder_io.hpp"

namespace rubicon::cli {

/// What a plan without tasks gives. Texts are made when they are asked for.
struct TasklessResult {
  using Text = std::function<std::string()>;
  Text table, csv, json;
  std::vector<std::pair<const char*, Text>> files;  ///< of the result folder, those of its terms
  int code = kFine;
};

/// Opens the folder of `--out`, if it is given. An exit code: it cannot be, or the options ask for
/// what only tasks leave. `instead` says what the plan has, as in "a network with policy grid has
/// ways".
std::optional<int> open_taskless(const RunOptions& options, const char* instead,
                                 files::ResultTerms terms,
                                 std::optional<files::ResultFolder>& folder);

/// Writes the folder, if there is one, and prints what `--format` asks for. The exit code.
int write_taskless(const RunOptions& options, std::optional<files::ResultFolder>& folder,
                   const TasklessResult& result);

}  // namespace rubicon::cli
