#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/syntax/name_suggestion.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/input_file.hpp"
#include "src/cli/load_runnable_plan.hpp"
#include "src/cli/set_option.hpp"
#include "src/exchange/files/atomic_file_io.hpp"
#include "src/results/comparison/compare_guides.hpp"
#include "src/results/comparison/compare_travel.hpp"
#include "src/results/comparison/cover_way.hpp"
#include "src/results/comparison/guide_picture.hpp"
#include "src/results/comparison/ompl_guide.hpp"
#include "src/results/comparison/way_chart.hpp"

namespace rubicon::cli {

namespace {

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string no_motion_text(const GuidesOptions& options, const std::string& task) {
  return fmt::format(
      "'{}' makes no motion: it is not reached, it is rejected before it "
      "moves, or its goal holds already; see rubicon why {} {}",
      task, options.plan, task);
}

int print_travel(const GuidesOptions& options, const interpreter::PlanModel& plan,
                 const std::string& task) {
  comparison::TravelComparison result;
  try {
    travel::TravelSettings settings;
    if (options.slice > 0) settings.slice = options.slice;
    result = comparison::compare_travel(plan, task, settings);
  } catch (const std::invalid_argument& error) {
    return fail(error.what());
  }
  const std::string text = options.format == "json"  ? comparison::travel_json(result)
                           : options.format == "csv" ? comparison::travel_csv(result)
                                                     : comparison::travel_text(result);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return kFine;
}

/// What stands between commas.
std::vector<std::string> names_in(const std::string& list) {
  std::vector<std::string> names;
  std::string name;
  for (const char c : list + ",") {
    if (c == ',' && !name.empty()) names.push_back(std::exchange(name, {}));
    if (c != ',' && c != ' ') name += c;
  }
  return names;
}

/// To a file, or to standard output.
int write_picture(const std::string& path, const std::string& svg) {
  if (path == "-") {
    std::fwrite(svg.data(), 1, svg.size(), stdout);
    return kFine;
  }
  if (const auto failure = files::write_file(path, svg)) return fail(*failure);
  return kFine;
}

int print_cover(const GuidesOptions& options, const interpreter::PlanModel& plan,
                const interpreter::TaskSpec& task) {
  const std::string text = options.format == "json"  ? comparison::cover_way_json(plan, task)
                           : options.format == "csv" ? comparison::cover_way_csv(plan, task)
                                                     : comparison::cover_way_text(plan, task);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return kFine;
}

/// The picture of a guide, or the chart of its way.
int draw_guide(const GuidesOptions& options, const interpreter::PlanModel& plan,
               const interpreter::SourceMap& sources, const std::string& task) {
  comparison::PictureQuery query;
  query.kind = options.kind;
  query.axes = names_in(options.axes);
  query.at = options.at;
  std::string svg;
  const bool chart = !options.chart.empty();
  const bool page = !options.page.empty();
  try {
    svg = chart  ? comparison::way_chart(plan, sources, task, options.kind)
          : page ? comparison::guide_picture_page(plan, sources, task, query)
                 : comparison::guide_picture(plan, sources, task, query);
  } catch (const std::invalid_argument& error) {
    return fail(error.what());
  }
  if (svg.empty()) return fail(no_motion_text(options, task));
  return write_picture(chart ? options.chart : page ? options.page : options.svg, svg);
}

}  // namespace

int run_guides(const GuidesOptions& options) {
  interpreter::SourceMap sources;
  std::set<std::string> inputs;
  const auto plan =
      load_runnable_plan(options.plan, sources, parameter_texts(options.set), false, &inputs);
  if (!plan) return kWrongInput;
  for (const std::string& picture : {options.svg, options.page, options.chart}) {
    if (const auto mistake = overwriting(inputs, {picture})) return fail(*mistake);
  }
  std::vector<std::string> tasks = comparison::moving_tasks(*plan);
  std::string task = options.task;
  if (task.empty() && tasks.size() == 1) task = tasks.front();
  if (task.empty()) return fail("which task? the plan has several that move something");
  if (std::find(tasks.begin(), tasks.end(), task) == tasks.end()) {
    interpreter::NameSuggestions suggestions;
    return fail(fmt::format("there is no task '{}' in {} that moves anything{}", task, options.plan,
                            suggestions.ending(task, [&] { return tasks; })));
  }
  if (options.exact) return print_travel(options, *plan, task);
  const auto found = std::find_if(plan->tasks.begin(), plan->tasks.end(),
                                  [&](const auto& each) { return each.name == task; });
  const bool covers = found != plan->tasks.end() && found->cover.has_value();
  const bool of_area = covers && options.kind.empty() && options.axes.empty();
  if (!options.axes.empty() && options.svg.empty() && options.page.empty()) {
    return fail("--axes goes with --svg or --page");
  }
  if (!options.chart.empty() || !options.page.empty() || (!options.svg.empty() && !of_area)) {
    return draw_guide(options, *plan, sources, task);
  }
  if (!options.kind.empty()) return fail("--kind goes with --svg, --page or --chart");
  if (!options.svg.empty()) {
    const int code = write_picture(options.svg, comparison::cover_steps_svg(*plan, *found));
    if (code != kFine || options.svg == "-") return code;
  }
  if (covers) {
    const int code = print_cover(options, *plan, *found);
    if (code != kFine || found->guides.empty() || options.format != "table") return code;
    std::fputs("\n", stdout);
  }
  comparison::GuideComparison result;
  try {
    std::vector<guides::GuideSpec> added;
    for (const std::string& name : names_in(options.ompl)) {
      added.push_back(comparison::ompl_guide(name));
    }
    result = comparison::compare_guides(*plan, sources, task, options.seeds, seconds_now, added);
  } catch (const std::invalid_argument& error) {
    return fail(error.what());
  }
  if (result.motions.empty()) return fail(no_motion_text(options, task));
  const std::string text = options.format == "json"  ? comparison::comparison_json(result)
                           : options.format == "csv" ? comparison::comparison_csv(result)
                                                     : comparison::comparison_text(result);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return kFine;
}

}  // namespace rubicon::cli
