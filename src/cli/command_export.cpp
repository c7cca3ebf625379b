#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/input_file.hpp"
#include "src/cli/result_files.hpp"
#include "src/cli/result_project.hpp"
#include "src/cli/set_option.hpp"
#include "src/exchange/files/atomic_file_io.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/exchange/project_io/project_of.hpp"
#include "src/exchange/project_io/write_mspdi.hpp"
#include "src/results/gantt/svg_chart.hpp"
#include "src/results/gltf/document_file.hpp"
#include "src/results/replay/replay.hpp"
#include "src/results/report/diagnostic_printer.hpp"
#include "src/results/report/schedule_reader.hpp"
#include "src/results/report/schedule_text.hpp"

namespace rubicon::cli {

namespace {

/// A file to write and all its bytes.
struct Output {
  std::string path;
  std::string bytes;
};

/// The files that the call reads.
std::set<std::string> inputs_of(const ExportOptions& options) {
  if (!files::is_folder(options.source)) return {options.source};
  const ResultFiles result(options.source);
  return {result.trace_path(), result.schedule_path()};
}

/// What is wrong with the call, if anything.
std::optional<std::string> call_mistake(const ExportOptions& options) {
  const std::array<std::pair<const char*, const std::string*>, 4> files = {
      {{"--gltf", &options.gltf},
       {"--svg", &options.svg},
       {"--mspdi", &options.mspdi},
       {"--csv", &options.csv}}};
  const auto wanted = std::count_if(files.begin(), files.end(),
                                    [](const auto& file) { return !file.second->empty(); });
  if (wanted == 0) {
    return "nothing is to be written: name a file with --gltf, --svg, --mspdi or --csv";
  }
  const auto to_screen = std::count_if(files.begin(), files.end(),
                                       [](const auto& file) { return *file.second == "-"; });
  if (to_screen > 1) return "only one of the files can go to standard output";
  auto overwritten =
      overwriting(inputs_of(options), {options.gltf, options.svg, options.mspdi, options.csv});
  if (std::isnan(options.speed_up)) return "expected a number after --speed-up";
  if (options.speed_up > 0 && options.gltf.empty()) return "--speed-up goes with --gltf";
  if (!options.set.empty() && files::is_folder(options.source)) {
    return "--set goes with a plan; a result keeps what its run was given";
  }
  if (files::is_folder(options.source)) return overwritten;
  for (const auto& [name, path] : files) {
    if (path != &options.mspdi && !path->empty()) {
      return fmt::format(
          "{} needs the folder of a result, and '{}' is no folder; 'rubicon run "
          "PLAN --out DIR' makes one",
          name, options.source);
    }
  }
  return overwritten;
}

/// The schedule of a plan before it is run; nothing, and the mistakes are printed, if the plan is
/// wrong.
std::optional<Output> plan_output(const ExportOptions& options) {
  interpreter::SourceMap sources;
  files::DiskFiles disk;
  interpreter::Diagnostics diagnostics;
  const std::unique_ptr<interpreter::PlanModel> plan =
      load_plan(options.source, sources, disk, diagnostics, parameter_texts(options.set));
  std::optional<Output> output;
  if (const auto mistake = overwriting(disk.read(), {options.mspdi})) {
    fail(*mistake);
    return std::nullopt;
  }
  if (plan) {
    const project_io::Project project = project_io::project_of(*plan, sources, diagnostics);
    output = Output{options.mspdi, project_io::write_mspdi(project)};
  }
  const std::string messages =
      report::print_text(diagnostics.sorted(), sources, files::wants_colour(stderr));
  std::fwrite(messages.data(), 1, messages.size(), stderr);
  return output;
}

taskplan::Schedule read_result_schedule(const ResultFiles& result) {
  const std::string text = result.schedule_json();
  try {
    return report::schedule_from_json(text);
  } catch (const std::invalid_argument& error) {
    throw WrongInput(fmt::format("{}: {}", result.schedule_path(), error.what()));
  }
}

/// The name of a folder, without what it stands in, however its path was typed.
std::string folder_name(const std::string& path) {
  return std::filesystem::canonical(path).filename().string();
}

/// A chart needs no trace, but is better with it.
std::string gantt_chart(const ExportOptions& options, const ResultFiles& result) {
  const taskplan::Schedule schedule = read_result_schedule(result);
  if (!result.has_trace()) {
    return gantt::svg_chart(gantt::make_chart(schedule, nullptr, folder_name(options.source)));
  }
  gantt::TraceTimesReader reader;
  result.each_trace_line([&](const std::string& line) { reader.line(line); });
  const gantt::TraceTimes times = reader.take();
  try {
    return gantt::svg_chart(gantt::make_chart(schedule, &times, folder_name(options.source)));
  } catch (const std::invalid_argument& error) {
    throw WrongInput(fmt::format("{}:1: {}", result.trace_path(), error.what()));
  }
}

/// Binary if its name ends so, else text.
std::string film(const ExportOptions& options, const ResultFiles& result) {
  replay::ReplayReader reader;
  result.each_trace_line([&](const std::string& line) { reader.line(line); });
  try {
    const gltf::Document document = gltf::make_document(reader.finish(), {options.speed_up});
    return options.gltf.ends_with(".glb") ? gltf::glb_bytes(document) : gltf::gltf_text(document);
  } catch (const std::invalid_argument& error) {
    throw WrongInput(fmt::format("{}: {}", result.trace_path(), error.what()));
  }
}

std::vector<Output> result_outputs(const ExportOptions& options) {
  const ResultFiles result(options.source);
  std::vector<Output> outputs;
  if (!options.gltf.empty()) outputs.push_back({options.gltf, film(options, result)});
  if (!options.csv.empty()) {
    outputs.push_back({options.csv, report::schedule_csv(read_result_schedule(result))});
  }
  if (!options.mspdi.empty()) {
    outputs.push_back({options.mspdi, result_mspdi(result, read_result_schedule(result))});
  }
  if (!options.svg.empty()) outputs.push_back({options.svg, gantt_chart(options, result)});
  return outputs;
}

int write(const Output& output) {
  if (output.path == "-") {
    std::fwrite(output.bytes.data(), 1, output.bytes.size(), stdout);
  } else if (const auto failure = files::write_file(output.path, output.bytes)) {
    return fail(*failure);
  }
  return kFine;
}

}  // namespace

int run_export(const ExportOptions& options) {
  if (const auto mistake = call_mistake(options)) return fail(*mistake);
  std::vector<Output> outputs;
  if (files::is_folder(options.source)) {
    try {
      outputs = result_outputs(options);
    } catch (const WrongInput& wrong) {
      return fail(wrong.what());
    }
  } else if (auto output = plan_output(options)) {
    outputs.push_back(std::move(*output));
  } else {
    return kWrongInput;
  }
  int code = kFine;
  for (const Output& output : outputs) code = std::max(code, write(output));
  return code;
}

}  // namespace rubicon::cli
