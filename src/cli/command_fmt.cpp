#include <fmt/format.h>

#include <cstdio>
#include <optional>

#include "interpreter/parse/parse.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/text_kind.hpp"
#include "src/exchange/files/atomic_file_io.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/results/report/diagnostic_printer.hpp"

namespace rubicon::cli {

namespace {

using interpreter::Diagnostics;
using interpreter::FileFailure;
using interpreter::SourceMap;
using interpreter::TextKind;

void complain(const std::string& path, const std::string& message) {
  const std::string text = fmt::format("rubicon: error: '{}': {}\n", path, message);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

/// The canonical text, or nothing after printing the errors of the file.
std::optional<std::string> canonical(const std::string& path, const std::string& text,
                                     TextKind kind) {
  SourceMap sources;
  Diagnostics diagnostics;
  const interpreter::FileId file = sources.add(path, text);
  switch (kind) {
    case TextKind::script:
      parse_script(sources, file, diagnostics);
      break;
    case TextKind::robot:
      parse_robot(sources, file, diagnostics);
      break;
    case TextKind::plan:
      parse_plan(sources, file, diagnostics);
      break;
    case TextKind::study:
      parse_study(sources, file, diagnostics);
      break;
  }
  if (diagnostics.has_errors()) {
    const std::string errors =
        report::print_text(diagnostics.sorted(), sources, files::wants_colour(stderr));
    std::fwrite(errors.data(), 1, errors.size(), stderr);
    return std::nullopt;
  }
  return interpreter::format_text(sources.file(file).text, kind);
}

int format_standard_input(const FormatOptions& options) {
  const TextKind kind = *kind_of("-." + options.kind);
  auto text = files::read_standard_input();
  if (const auto* failure = std::get_if<FileFailure>(&text)) {
    complain("-", failure->message);
    return kWrongInput;
  }
  const auto result = canonical("-", std::get<std::string>(text), kind);
  if (!result) return kWrongInput;
  if (options.check) return *result == std::get<std::string>(text) ? kFine : kInfeasible;
  std::fwrite(result->data(), 1, result->size(), stdout);
  return kFine;
}

}  // namespace

int run_format(const FormatOptions& options) {
  int code = kFine;
  files::DiskFiles disk;
  for (const std::string& path : options.files) {
    if (path == "-") {
      code = std::max(code, format_standard_input(options));
      continue;
    }
    const auto kind = kind_of(path);
    if (!kind) {
      complain(path, "expected a .robot, .motion, .plan or .study file");
      code = kWrongInput;
      continue;
    }
    auto text = disk.read_text(path);
    if (const auto* failure = std::get_if<FileFailure>(&text)) {
      complain(path, failure->message);
      code = kWrongInput;
      continue;
    }
    const auto result = canonical(path, std::get<std::string>(text), *kind);
    if (!result) {
      code = kWrongInput;
    } else if (*result != std::get<std::string>(text)) {
      if (options.check) {
        fmt::print(stdout, "{}\n", path);
        code = std::max(code, kInfeasible);
      } else if (const auto failure = files::change_file(path, *result)) {
        complain(path, *failure);
        code = kWrongInput;
      }
    }
  }
  return code;
}

}  // namespace rubicon::cli
