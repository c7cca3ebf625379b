#include "src/cli/taskless_result.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <utility>
#include <variant>

namespace rubicon::cli {

std::optional<int> open_taskless(const RunOptions& options, const char* instead,
                                 files::ResultTerms terms,
                                 std::optional<files::ResultFolder>& folder) {
  if (!options.trace.empty() || options.compress || !options.sample.empty()) {
    return fail(
        fmt::format("--trace, --compress and --sample go with tasks; {}: --out FOLDER or "
                    "--format json",
                    instead));
  }
  if (options.out.empty()) return std::nullopt;
  auto opened = files::ResultFolder::open(options.out, std::move(terms));
  if (auto* message = std::get_if<std::string>(&opened)) return fail(*message);
  folder.emplace(std::get<files::ResultFolder>(std::move(opened)));
  return std::nullopt;
}

int write_taskless(const RunOptions& options, std::optional<files::ResultFolder>& folder,
                   const TasklessResult& result) {
  if (folder) {
    for (const auto& [name, text] : result.files) {
      if (const auto failure = folder->write(name, text())) return fail(*failure);
    }
    if (const auto failure = folder->commit()) return fail(*failure);
  }
  const std::string text = options.format == "json"  ? result.json()
                           : options.format == "csv" ? result.csv()
                                                     : result.table();
  std::fwrite(text.data(), 1, text.size(), stdout);
  return result.code;
}

}  // namespace rubicon::cli
