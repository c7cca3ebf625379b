#include "src/cli/load_runnable_plan.hpp"

#include <cstdio>

#include "src/exchange/files/disk_io.hpp"
#include "src/results/report/diagnostic_printer.hpp"
#include "src/simulation/taskplan/run_mistakes.hpp"

namespace rubicon::cli {

std::unique_ptr<interpreter::PlanModel> load_runnable_plan(const std::string& path,
                                                           interpreter::SourceMap& sources) {
  files::DiskFiles disk;
  interpreter::Diagnostics diagnostics;
  std::unique_ptr<interpreter::PlanModel> plan = load_plan(path, sources, disk, diagnostics);
  if (plan) {
    for (auto& mistake : taskplan::run_mistakes(*plan)) diagnostics.add(std::move(mistake));
  }
  const std::string messages =
      report::print_text(diagnostics.sorted(), sources, files::wants_colour(stderr));
  std::fwrite(messages.data(), 1, messages.size(), stderr);
  if (diagnostics.has_errors()) plan.reset();
  return plan;
}

}  // namespace rubicon::cli
