#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace rubicon::cli {

/// Exit codes of the command.
inline constexpr int kFine = 0;
inline constexpr int kInfeasible = 1;
inline constexpr int kWrongInput = 2;
inline constexpr int kInternalFault = 3;

struct CheckOptions {
  std::string robot;
  std::string format = "text";
  std::vector<std::string> files;
  std::vector<std::string> set;  ///< NAME=VALUE: parameters of the plan; likewise below
};
int run_check(const CheckOptions& options);

struct FormatOptions {
  bool check = false;
  std::string kind = "motion";
  std::vector<std::string> files;
};
int run_format(const FormatOptions& options);

struct RunOptions {
  std::string plan;
  std::string format = "table";
  std::string trace;
  std::string trace_detail = "steps";
  std::string out;
  bool compress = false;
  std::vector<std::string> set;
  std::string sample;  ///< SEED or SEED:RUN; "": means
  bool prints = true;  ///< the table
};
int run_plan_command(const RunOptions& options);

struct StudyOptions {
  std::string study;
  std::string format = "table";
  std::string out;
  bool resume = false;
  bool films = false;  ///< the runs that are worth looking at get folders of their own
  int jobs = 0;
};
int run_study_command(const StudyOptions& options);

struct TestOptions {
  std::vector<std::string> folders;
  std::string filter;
  bool update = false;
  int jobs = 0;
  std::string junit;
};
int run_test(const TestOptions& options);

struct WhyOptions {
  std::string source;  ///< a plan, a result folder or a trace
  std::string task;
  std::string format = "text";
  std::vector<std::string> set;
  bool advise = false;
};
int run_why(const WhyOptions& options);

struct GuidesOptions {
  std::string plan;
  std::string task;  ///< "": the only one that moves
  int seeds = 10;
  bool exact = false;
  double slice = 0;   ///< s; 0: as travel has it
  std::string svg;    ///< file for the picture of one guide, or of a way over an area; "": none
  std::string chart;  ///< file for the chart of its way; "": none
  std::string kind;   ///< of that guide; "": the first of the task
  std::string ompl;   ///< planners of OMPL to compare with, commas between them
  std::string axes;   ///< of the picture: two or three parameters, commas between them
  std::optional<double> at;  ///< value of the third
  std::string page;          ///< file for the picture with a slider; "": none
  std::string format = "table";
  std::vector<std::string> set;
};
int run_guides(const GuidesOptions& options);

struct FlowOptions {
  std::string source;  ///< a plan, a result folder or a trace
  std::string format = "table";
  std::vector<std::string> set;
};
int run_flow(const FlowOptions& options);

struct LayoutOptions {
  std::string plan;
  std::string module;   ///< length x depth, or length x depth x height
  std::string spacing;  ///< a length; "": the width of a lane
  int choose = 1;       ///< row of the table
  std::string out;      ///< "": no plan is written
  std::string format = "table";
};
int run_layout(const LayoutOptions& options);

struct ReportOptions {
  std::string result;  ///< a result folder or a trace
  std::string out;
};
int run_report(const ReportOptions& options);

struct DebugOptions {
  std::string source;  ///< a plan, a result folder or a trace
  std::string task;    ///< "" for all
  std::vector<std::string> commands;
  bool batch = false;
  std::vector<std::string> set;
};
int run_debug(const DebugOptions& options);

struct VerifyOptions {
  std::string result;
  std::string format = "text";
};
int run_verify(const VerifyOptions& options);

struct ImportOptions {
  std::vector<std::string> files;  ///< one schedule, one machine, or models
  std::string schedule;            ///< that the models are joined to
  std::string match;
  std::string unit;
  std::string up;
  std::string out;
  bool level = false;                  ///< tasks of the schedule wait for their resources
  bool baseline = false;               ///< tasks keep the dates that the schedule has
  std::vector<std::string> packages;   ///< NAME=FOLDER, of a machine; likewise below
  std::vector<std::string> arguments;  ///< NAME=VALUE, of xacro
  std::string tool;                    ///< the link of the tool frame
  std::optional<std::string> area;     ///< floors are wanted: of this storey, of a drawing ""
  std::vector<std::string> layers;     ///< PART=LAYER, of a drawing
  std::string tolerance;               ///< a length: gaps that are closed
  std::string height;                  ///< a length: of the floor of a drawing
};
int run_import(const ImportOptions& options);
/// Of models, drawings and machines: run_import's other parts.
int import_building(const ImportOptions& options);
int import_drawing(const ImportOptions& options);
int import_machine(const ImportOptions& options);

struct ExportOptions {
  std::string source;   ///< the folder of a result, or a plan
  std::string gltf;     ///< files to write; "" is none, "-" is standard output
  double speed_up = 0;  ///< of the film, seconds of the plan for one of its own; 0: chosen
  std::string svg;
  std::string mspdi;
  std::string csv;
  std::vector<std::string> set;
};
int run_export(const ExportOptions& options);

struct HelpOptions {
  std::string command;  ///< "": all
  bool manual = false;
  std::string shell;  ///< whose completion; "": none
};
/// `app` has all commands, for completion.
int run_help(const HelpOptions& options, const CLI::App& app);

}  // namespace rubicon::cli
