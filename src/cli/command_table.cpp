#include "src/cli/command_table.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "src/cli/commands.hpp"
#include "src/cli/help_pages.hpp"
#include "src/cli/set_option.hpp"

namespace rubicon::cli {

namespace {

using CLI::IsMember;

/// Of a file or folder that is written: an empty name would be none.
CLI::Validator named() {
  return CLI::Validator(
      [](const std::string& name) {
        return name.empty()
                   ? std::string("expected the name of a file or folder, found an empty one")
                   : std::string();
      },
      "");
}

Action declare_check(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  app.add_option("--robot", options->robot);
  app.add_option("--format", options->format)->check(IsMember({"text", "json"}));
  declare_set(app, options->set);
  app.add_option("FILE", options->files)->required();
  return [options] { return run_check(*options); };
}

Action declare_run(CLI::App& app) {
  const auto options = std::make_shared<RunOptions>();
  app.add_option("PLAN", options->plan)->required();
  app.add_option("--format", options->format)->check(IsMember({"table", "json", "csv"}));
  app.add_option("--trace", options->trace)->check(named());
  app.add_option("--trace-detail", options->trace_detail)
      ->check(IsMember({"full", "steps", "tasks", "none"}));
  app.add_option("--out", options->out)->check(named());
  app.add_flag("--compress", options->compress);
  declare_set(app, options->set);
  declare_sample(app, options->sample);
  return [options] { return run_plan_command(*options); };
}

Action declare_why(CLI::App& app) {
  const auto options = std::make_shared<WhyOptions>();
  app.add_option("SOURCE", options->source)->required();
  app.add_option("TASK", options->task)->required();
  app.add_option("--format", options->format)->check(IsMember({"text", "json"}));
  app.add_flag("--advise", options->advise);
  declare_set(app, options->set);
  return [options] { return run_why(*options); };
}

Action declare_guides(CLI::App& app) {
  const auto options = std::make_shared<GuidesOptions>();
  app.add_option("PLAN", options->plan)->required();
  app.add_option("TASK", options->task);
  app.add_option("--seeds", options->seeds)->check(CLI::Range(1, 10000));
  CLI::Option* const exact = app.add_flag("--exact", options->exact);
  app.add_option("--dt", options->slice)->check(CLI::Range(1e-3, 1e3))->needs(exact);
  CLI::Option* const svg = app.add_option("--svg", options->svg)->check(named())->excludes(exact);
  CLI::Option* const chart =
      app.add_option("--chart", options->chart)->check(named())->excludes(exact)->excludes(svg);
  app.add_option("--kind", options->kind);
  app.add_option("--ompl", options->ompl)->excludes(exact)->excludes(svg)->excludes(chart);
  CLI::Option* const axes = app.add_option("--axes", options->axes)->excludes(chart);
  app.add_option("--at", options->at)->needs(svg)->needs(axes);
  app.add_option("--page", options->page)
      ->needs(axes)
      ->excludes(svg)
      ->excludes(chart)
      ->excludes(exact);
  app.add_option("--format", options->format)->check(IsMember({"table", "json", "csv"}));
  declare_set(app, options->set);
  return [options] { return run_guides(*options); };
}

Action declare_flow(CLI::App& app) {
  const auto options = std::make_shared<FlowOptions>();
  app.add_option("SOURCE", options->source)->required();
  app.add_option("--format", options->format)->check(IsMember({"table", "json", "csv"}));
  declare_set(app, options->set);
  return [options] { return run_flow(*options); };
}

Action declare_layout(CLI::App& app) {
  const auto options = std::make_shared<LayoutOptions>();
  app.add_option("PLAN", options->plan)->required();
  app.add_option("--module", options->module)->required();
  app.add_option("--spacing", options->spacing);
  CLI::Option* const out = app.add_option("--out", options->out)->check(named());
  app.add_option("--choose", options->choose)->check(CLI::Range(1, 10000))->needs(out);
  app.add_option("--format", options->format)->check(IsMember({"table", "json", "csv"}));
  return [options] { return run_layout(*options); };
}

Action declare_report(CLI::App& app) {
  const auto options = std::make_shared<ReportOptions>();
  app.add_option("RESULT", options->result)->required();
  app.add_option("--out", options->out)->check(named());
  return [options] { return run_report(*options); };
}

Action declare_debug(CLI::App& app) {
  const auto options = std::make_shared<DebugOptions>();
  app.add_option("SOURCE", options->source)->required();
  app.add_option("TASK", options->task);
  app.add_option("-x,--command", options->commands)->expected(1)->take_all();
  app.add_flag("--batch", options->batch);
  declare_set(app, options->set);
  return [options] { return run_debug(*options); };
}

Action declare_study(CLI::App& app) {
  const auto options = std::make_shared<StudyOptions>();
  app.add_option("STUDY", options->study)->required();
  app.add_option("--format", options->format)->check(IsMember({"table", "json", "csv"}));
  CLI::Option* const out = app.add_option("--out", options->out)->check(named());
  app.add_flag("--resume", options->resume)->needs(out);
  app.add_flag("--films", options->films)->needs(out);
  app.add_option("--jobs", options->jobs)->check(CLI::Range(1, 256));
  return [options] { return run_study_command(*options); };
}

Action declare_test(CLI::App& app) {
  const auto options = std::make_shared<TestOptions>();
  app.add_option("DIR", options->folders)->required();
  app.add_option("--filter", options->filter);
  app.add_flag("--update", options->update);
  app.add_option("--jobs", options->jobs)->check(CLI::Range(1, 256));
  app.add_option("--junit", options->junit)->check(named());
  return [options] { return run_test(*options); };
}

Action declare_verify(CLI::App& app) {
  const auto options = std::make_shared<VerifyOptions>();
  app.add_option("RESULT", options->result)->required();
  app.add_option("--format", options->format)->check(IsMember({"text", "json"}));
  return [options] { return run_verify(*options); };
}

Action declare_import(CLI::App& app) {
  const auto options = std::make_shared<ImportOptions>();
  app.add_option("FILE", options->files)->required();
  app.add_option("--schedule", options->schedule);
  app.add_option("--match", options->match);
  app.add_flag("--level", options->level);
  app.add_flag("--baseline", options->baseline);
  app.add_option("--unit", options->unit)->check(IsMember({"mm", "cm", "m"}));
  app.add_option("--up", options->up)->check(IsMember({"y", "z"}));
  app.add_option("--package", options->packages)->take_all();
  app.add_option("--arg", options->arguments)->take_all();
  app.add_option("--tool", options->tool);
  app.add_option("--area", options->area)->expected(0, 1)->default_str("");
  app.add_option("--layer", options->layers)->take_all();
  app.add_option("--tolerance", options->tolerance);
  app.add_option("--height", options->height);
  app.add_option("--out", options->out)->check(named());
  return [options] { return run_import(*options); };
}

Action declare_export(CLI::App& app) {
  const auto options = std::make_shared<ExportOptions>();
  app.add_option("SOURCE", options->source)->required();
  app.add_option("--gltf", options->gltf)->check(named());
  app.add_option("--speed-up", options->speed_up)->check(CLI::Range(0.01, 1e7));
  app.add_option("--svg", options->svg)->check(named());
  app.add_option("--mspdi", options->mspdi)->check(named());
  app.add_option("--csv", options->csv)->check(named());
  declare_set(app, options->set);
  return [options] { return run_export(*options); };
}

Action declare_fmt(CLI::App& app) {
  const auto options = std::make_shared<FormatOptions>();
  app.add_flag("--check", options->check);
  app.add_option("--kind", options->kind)->check(IsMember({"motion", "robot", "plan", "study"}));
  app.add_option("FILE", options->files)->required();
  return [options] { return run_format(*options); };
}

Action declare_help(CLI::App& app) {
  const auto options = std::make_shared<HelpOptions>();
  app.add_option("COMMAND", options->command);
  app.add_flag("--man", options->manual);
  app.add_option("--completion", options->shell)->check(IsMember({"bash"}));
  return [options, root = app.get_parent()] { return run_help(*options, *root); };
}

}  // namespace

const std::vector<Command>& command_table() {
  static const std::vector<Command> table = {
      {"check", "[--robot FILE] FILE...", "find every mistake in robots, behaviours and plans",
       pages::kCheck, declare_check},
      {"run", "PLAN", "simulate a plan: process time, cost, refused tasks with the reason, trace",
       pages::kRun, declare_run},
      {"study", "STUDY", "run many variants of a plan and compare their time, cost and risk",
       pages::kStudy, declare_study},
      {"why", "PLAN|RESULT TASK", "say why a task failed, took long or came late", pages::kWhy,
       declare_why},
      {"guides", "PLAN [TASK]", "compare all kinds of guides on the motions of one task",
       pages::kGuides, declare_guides},
      {"flow", "PLAN|RESULT",
       "report what became of the components, and the stock of storage places", pages::kFlow,
       declare_flow},
      {"layout", "PLAN --module SIZE", "lay rows and lanes out in a hall, the best of many ways",
       pages::kLayout, declare_layout},
      {"report", "RESULT", "make the page that shows a result: the film, the Gantt, the tables",
       pages::kReport, declare_report},
      {"debug", "PLAN|RESULT [TASK]", "step through the behaviour of machines, forward and back",
       pages::kDebug, declare_debug},
      {"test", "DIR...", "run golden cases and compare them with what is expected", pages::kTest,
       declare_test},
      {"verify", "RESULT",
       "replay a result by other means and look for contact, gaps and broken links", pages::kVerify,
       declare_verify},
      {"import", "FILE... [--out FILE]",
       "make a plan of a schedule or building model, a robot of a URDF", pages::kImport,
       declare_import},
      {"export", "RESULT|PLAN ...", "write a film, a Gantt chart, a schedule or a table",
       pages::kExport, declare_export},
      {"fmt", "FILE...", "write files in the one canonical form", pages::kFmt, declare_fmt},
      {"help", "[COMMAND]", "this page, or the page of a command", pages::kHelp, declare_help},
  };
  return table;
}

const Command* find_command(std::string_view name) {
  const auto& table = command_table();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const Command& each) { return each.name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace rubicon::cli
