#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "interpreter/plan_model.hpp"
#include "src/cli/commands.hpp"
#include "src/files/disk_io.hpp"
#include "src/project_io/project_of.hpp"
#include "src/project_io/write_mspdi.hpp"
#include "src/report/diagnostic_printer.hpp"

namespace rubicon::cli {

int run_export(const ExportOptions& options) {
  interpreter::SourceMap sources;
  files::DiskFiles disk;
  interpreter::Diagnostics diagnostics;
  const std::unique_ptr<interpreter::PlanModel> plan =
      load_plan(options.plan, sources, disk, diagnostics);
  std::string schedule;
  if (plan) schedule = project_io::write_mspdi(project_io::project_of(*plan, sources, diagnostics));
  const std::string messages =
      report::print_text(diagnostics.sorted(), sources, files::wants_colour(stderr));
  std::fwrite(messages.data(), 1, messages.size(), stderr);
  if (!plan) return kWrongInput;
  if (options.mspdi == "-") {
    std::fwrite(schedule.data(), 1, schedule.size(), stdout);
  } else if (const auto failure = files::write_file(options.mspdi, schedule)) {
    fmt::print(stderr, "rubicon: error: {}\n", *failure);
    return kWrongInput;
  }
  return kFine;
}

}  // namespace rubicon::cli
