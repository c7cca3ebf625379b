#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "src/cli/commands.hpp"
#include "src/files/disk_io.hpp"
#include "src/project_io/decode_text.hpp"
#include "src/project_io/plan_text.hpp"
#include "src/project_io/read_project.hpp"
#include "src/report/diagnostic_printer.hpp"

namespace rubicon::cli {

namespace {

int fail(const std::string& message) {
  fmt::print(stderr, "rubicon: error: {}\n", message);
  return kWrongInput;
}

}  // namespace

int run_import(const ImportOptions& options) {
  files::DiskFiles disk;
  const auto bytes = disk.read_text(options.file);
  if (const auto* failure = std::get_if<interpreter::FileFailure>(&bytes)) {
    return fail(fmt::format("'{}': {}", options.file, failure->message));
  }
  project_io::DecodedText text = project_io::decode_text(std::get<std::string>(bytes));
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const interpreter::FileId file = sources.add(options.file, std::move(text.text));
  if (text.guessed) {
    diagnostics.warning("I03", {file, 0, 0}, "this text is not UTF-8: it is read as Windows-1252",
                        "check names with accents");
  }
  const std::optional<project_io::Project> project =
      project_io::read_project(sources, file, diagnostics);
  std::string plan;
  if (project) {
    const std::string name = std::filesystem::path(options.file).filename().string();
    plan = project_io::plan_text(*project, project_io::clean_utf8(name), diagnostics);
  }
  const std::string messages =
      report::print_text(diagnostics.sorted(), sources, files::wants_colour(stderr));
  std::fwrite(messages.data(), 1, messages.size(), stderr);
  if (!project) return kWrongInput;
  if (options.out.empty()) {
    std::fwrite(plan.data(), 1, plan.size(), stdout);
  } else if (const auto failure = files::write_file(options.out, plan)) {
    return fail(*failure);
  }
  return kFine;
}

}  // namespace rubicon::cli
