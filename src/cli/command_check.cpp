#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "interpreter/check/check.hpp"
#include "interpreter/check/plan_model.hpp"
#include "interpreter/parse/parse.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/load_study.hpp"
#include "src/cli/set_option.hpp"
#include "src/cli/text_kind.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/results/report/diagnostic_printer.hpp"
#include "src/simulation/site/beginning.hpp"

namespace rubicon::cli {

namespace {

using interpreter::Diagnostics;
using interpreter::FileFailure;
using interpreter::SourceMap;

/// One run of `rubicon check`: what was read, what was found.
struct CheckRun {
  SourceMap sources;
  files::DiskFiles disk;
  Diagnostics diagnostics;
};

void add_failure(CheckRun& run, const std::string& path, const std::string& message) {
  run.diagnostics.error("F01", {}, fmt::format("'{}': {}", path, message));
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  return a == b || (std::filesystem::equivalent(a, b, error) && !error);
}

bool already_read(const SourceMap& sources, const std::string& path) {
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (same_file(sources.file(static_cast<interpreter::FileId>(i)).path, path)) return true;
  }
  return false;
}

void check_motion(CheckRun& run, const std::string& path, const interpreter::CheckedRobot* robot) {
  auto text = run.disk.read_text(path);
  if (const auto* failure = std::get_if<FileFailure>(&text)) {
    add_failure(run, path, failure->message);
    return;
  }
  const interpreter::FileId file = run.sources.add(path, std::get<std::string>(std::move(text)));
  const syntax::Script script = parse_script(run.sources, file, run.diagnostics);
  interpreter::ScriptContext context;
  if (robot != nullptr) {
    context.robot = &robot->model;
    for (std::size_t i = 0; i < robot->body_scripts.size(); ++i) {
      if (robot->body_scripts[i]) context.body_behaviours.push_back(robot->model.bodies[i].name);
    }
  }
  check_script(script, context, run.diagnostics);
}

/// A plan, and what of it is seen only where it stands on the site.
void check_plan(CheckRun& run, const std::string& path, const interpreter::ParameterTexts& set) {
  const auto plan = load_plan(path, run.sources, run.disk, run.diagnostics, set);
  if (!plan) return;
  try {
    for (auto& each : site::warnings_of(*plan, site::look_at_beginning(*plan))) {
      run.diagnostics.add(std::move(each));
    }
  } catch (const std::invalid_argument& error) {
    add_failure(run, path, error.what());
  }
}

}  // namespace

int run_check(const CheckOptions& options) {
  CheckRun run;
  std::shared_ptr<const interpreter::CheckedRobot> robot;
  if (!options.robot.empty()) {
    robot = load_robot(options.robot, run.sources, run.disk, nullptr, run.diagnostics);
  }
  for (const std::string& path : options.files) {
    const std::optional<interpreter::TextKind> kind = kind_of(path);
    if (!kind) {
      add_failure(run, path, "expected a .robot, .motion, .plan or .study file");
    } else if (already_read(run.sources, path)) {
      continue;
    } else if (*kind == interpreter::TextKind::robot) {
      load_robot(path, run.sources, run.disk, nullptr, run.diagnostics);
    } else if (*kind == interpreter::TextKind::plan) {
      check_plan(run, path, parameter_texts(options.set));
    } else if (*kind == interpreter::TextKind::study) {
      load_study(path, run.sources, run.diagnostics);
    } else if (options.robot.empty() || robot) {
      check_motion(run, path, robot.get());
    }
  }
  const auto is_plan = [](const std::string& path) {
    return kind_of(path) == interpreter::TextKind::plan;
  };
  if (!options.set.empty() && std::none_of(options.files.begin(), options.files.end(), is_plan)) {
    run.diagnostics.error("P24", {}, "--set goes with a plan");
  }
  const auto sorted = run.diagnostics.sorted();
  if (options.format == "json") {
    const std::string text = report::print_json(sorted, run.sources);
    std::fwrite(text.data(), 1, text.size(), stdout);
  } else {
    const std::string text = report::print_text(sorted, run.sources, files::wants_colour(stderr));
    std::fwrite(text.data(), 1, text.size(), stderr);
  }
  return run.diagnostics.has_errors() ? kWrongInput : kFine;
}

}  // namespace rubicon::cli
