#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

#include "src/cli/commands.hpp"
#include "src/cli/help.hpp"

namespace {

using namespace rubicon::cli;

void print(std::FILE* stream, std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stream);
}

/// CLI11 reports what is wrong with a call; the pages are ours.
class PageFormatter : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const override {
    const HelpPage* page = find_help(app->get_name());
    return std::string(page != nullptr ? page->text : overview());
  }
};

int dispatch(int argc, char** argv) {
  CLI::App app("", "rubicon");
  app.formatter(std::make_shared<PageFormatter>());
  app.set_version_flag("--version", "rubicon " RUBICON_VERSION);
  app.require_subcommand(0, 1);
  app.allow_extras(false);

  CheckOptions check;
  CLI::App* check_command = app.add_subcommand("check");
  check_command->add_option("--robot", check.robot);
  check_command->add_option("--format", check.format)->check(CLI::IsMember({"text", "json"}));
  check_command->add_option("FILE", check.files)->required();

  RunOptions run;
  CLI::App* run_command = app.add_subcommand("run");
  run_command->add_option("PLAN", run.plan)->required();
  run_command->add_option("--format", run.format)->check(CLI::IsMember({"table", "json", "csv"}));
  run_command->add_option("--trace", run.trace);
  run_command->add_option("--trace-detail", run.trace_detail)
      ->check(CLI::IsMember({"steps", "tasks", "none"}));
  run_command->add_option("--out", run.out);

  WhyOptions why;
  CLI::App* why_command = app.add_subcommand("why");
  why_command->add_option("SOURCE", why.source)->required();
  why_command->add_option("TASK", why.task)->required();
  why_command->add_option("--format", why.format)->check(CLI::IsMember({"text", "json"}));

  ReportOptions report;
  CLI::App* report_command = app.add_subcommand("report");
  report_command->add_option("RESULT", report.result)->required();
  report_command->add_option("--out", report.out);

  DebugOptions debug;
  CLI::App* debug_command = app.add_subcommand("debug");
  debug_command->add_option("SOURCE", debug.source)->required();
  debug_command->add_option("TASK", debug.task);
  debug_command->add_option("-x,--command", debug.commands)->expected(1)->take_all();
  debug_command->add_flag("--batch", debug.batch);

  TestOptions test;
  CLI::App* test_command = app.add_subcommand("test");
  test_command->add_option("DIR", test.folders)->required();
  test_command->add_option("--filter", test.filter);
  test_command->add_flag("--update", test.update);
  test_command->add_option("--jobs", test.jobs)->check(CLI::Range(1, 256));
  test_command->add_option("--junit", test.junit);

  VerifyOptions verify;
  CLI::App* verify_command = app.add_subcommand("verify");
  verify_command->add_option("RESULT", verify.result)->required();
  verify_command->add_option("--format", verify.format)->check(CLI::IsMember({"text", "json"}));

  ImportOptions import;
  CLI::App* import_command = app.add_subcommand("import");
  import_command->add_option("FILE", import.files)->required();
  import_command->add_option("--schedule", import.schedule);
  import_command->add_option("--match", import.match);
  import_command->add_option("--unit", import.unit)->check(CLI::IsMember({"mm", "cm", "m"}));
  import_command->add_option("--up", import.up)->check(CLI::IsMember({"y", "z"}));
  import_command->add_option("--out", import.out);

  ExportOptions exported;
  CLI::App* export_command = app.add_subcommand("export");
  export_command->add_option("SOURCE", exported.source)->required();
  export_command->add_option("--gltf", exported.gltf);
  export_command->add_option("--speed-up", exported.speed_up)->check(CLI::Range(0.01, 1e7));
  export_command->add_option("--svg", exported.svg);
  export_command->add_option("--mspdi", exported.mspdi);
  export_command->add_option("--csv", exported.csv);

  FormatOptions format;
  CLI::App* format_command = app.add_subcommand("fmt");
  format_command->add_flag("--check", format.check);
  format_command->add_option("--kind", format.kind)
      ->check(CLI::IsMember({"motion", "robot", "plan"}));
  format_command->add_option("FILE", format.files)->required();

  std::string page_name;
  CLI::App* help_command = app.add_subcommand("help");
  help_command->add_option("COMMAND", page_name);

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const auto chosen = app.get_subcommands();
    const HelpPage* page = chosen.empty() ? nullptr : find_help(chosen.front()->get_name());
    print(stdout, page != nullptr ? page->text : overview());
    return kFine;
  } catch (const CLI::CallForVersion&) {
    print(stdout, "rubicon " RUBICON_VERSION "\n");
    return kFine;
  } catch (const CLI::ParseError& error) {
    const auto chosen = app.get_subcommands();
    const std::string topic = chosen.empty() ? std::string() : " " + chosen.front()->get_name();
    print(stderr,
          fmt::format("rubicon: error: {}\n  hint: see 'rubicon help{}'\n", error.what(), topic));
    return kWrongInput;
  }

  if (*check_command) return run_check(check);
  if (*run_command) return run_plan_command(run);
  if (*why_command) return run_why(why);
  if (*report_command) return run_report(report);
  if (*debug_command) return run_debug(debug);
  if (*test_command) return run_test(test);
  if (*verify_command) return run_verify(verify);
  if (*import_command) return run_import(import);
  if (*export_command) return run_export(exported);
  if (*format_command) return run_format(format);
  if (!page_name.empty()) {
    const HelpPage* page = find_help(page_name);
    if (page == nullptr) {
      print(stderr,
            fmt::format("rubicon: error: there is no command '{}'\n  hint: see 'rubicon help'\n",
                        page_name));
      return kWrongInput;
    }
    print(stdout, page->text);
    return kFine;
  }
  print(stdout, overview());
  return kFine;
}

}  // namespace

int main(int argc, char** argv) {
  int code = kInternalFault;
  try {
    code = dispatch(argc, argv);
  } catch (const std::exception& error) {
    print(stderr, fmt::format("rubicon: internal fault: {}\n", error.what()));
    return kInternalFault;
  }
  // What was printed must have arrived: a full disk behind a redirection is an error, not a short
  // file.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    print(stderr, "rubicon: error: standard output cannot be written\n");
    return kWrongInput;
  }
  return code;
}
