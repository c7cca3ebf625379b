#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/parse/parse.hpp"
#include "interpreter/syntax/token.hpp"
#include "src/cli/check_import.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/input_file.hpp"
#include "src/cli/length_option.hpp"
#include "src/cli/load_runnable_plan.hpp"
#include "src/exchange/files/atomic_file_io.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/fleets/layout/plan_parts.hpp"
#include "src/motion/math/index.hpp"
#include "src/results/report/layout_text.hpp"

namespace rubicon::cli {

namespace {

using interpreter::AreaSpec;
using interpreter::NetworkSpec;
using interpreter::PlanModel;
using math::at;

/// m: a module may be as small and as large as this, and so may the spacing of nodes.
constexpr double kLeastPart = 0.05;
constexpr double kMostPart = 100;
/// m: where the width is left out the checker takes this.
constexpr double kAnyWidth = 1000;

/// "2.4 m x 1.2 m", or with a height behind; a message if it is neither.
std::optional<std::string> take_module(const std::string& text, layout::Sizes& sizes) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == 'x') {
      parts.emplace_back();
    } else if (c != ' ' || !parts.back().empty()) {
      parts.back() += c;
    }
  }
  if (parts.size() != 2 && parts.size() != 3) {
    return fmt::format(
        "--module takes the length along the aisle, the depth and perhaps the height, such as "
        "\"2.4 m x 1.2 m x 2 m\", found '{}'",
        text);
  }
  double* const places[] = {&sizes.length, &sizes.depth, &sizes.height};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::string& part = parts[i];
    while (!part.empty() && part.back() == ' ') part.pop_back();
    if (part.empty()) part = " ";  // given, and no length
    if (auto wrong = take_length("--module", part, kLeastPart, kMostPart, *places[i])) {
      return wrong;
    }
  }
  return std::nullopt;
}

/// What the plan has to have, and where.
struct Asked {
  const AreaSpec* area = nullptr;
  const NetworkSpec* network = nullptr;
};

std::optional<std::string> find_asked(const PlanModel& plan, interpreter::FileId file,
                                      Asked& asked) {
  if (plan.areas.size() != 1) {
    return fmt::format(
        "a layout goes into the one area of its plan, and this one has {}; write area hall {{ "
        "outline (0, 0), (40, 0), (40, 24), (0, 24); }}",
        plan.areas.size());
  }
  if (plan.networks.size() != 1) {
    return fmt::format(
        "the lanes go into the one network of the plan, and this one has {}; write network lanes "
        "{{ class aisle {{ speed 1.5 m/s; width 3 m; }} node gate at trans(0, 2, 0); }}",
        plan.networks.size());
  }
  asked = {&plan.areas.front(), &plan.networks.front()};
  const NetworkSpec& network = *asked.network;
  if (network.span.file != file || network.span.copy != 0) {
    return fmt::format(
        "network '{}' has to stand in the plan itself, not in a file that it imports",
        network.name);
  }
  if (!network.description.lanes.empty()) {
    return fmt::format("network '{}' has lanes already: a layout is for a network of gates only",
                       network.name);
  }
  if (network.description.classes.size() > 2) {
    return fmt::format(
        "network '{}' has {} classes; a layout takes one for all lanes, or two, the first for "
        "aisles and the second for cross aisles and gates",
        network.name, network.description.classes.size());
  }
  for (const lanes::LaneClass& each : network.description.classes) {
    if (each.width >= kAnyWidth) {
      return fmt::format("class '{}' of network '{}' has no width: write width 3 m;", each.name,
                         network.name);
    }
  }
  const auto& X_WA = asked.area->X_WA;
  const bool is_level = X_WA.linear().isApprox(Eigen::Matrix3d::Identity(), 1e-9) &&
                        std::abs(X_WA.translation().x()) < 1e-9 &&
                        std::abs(X_WA.translation().y()) < 1e-9;
  if (!is_level) {
    return fmt::format("area '{}' has a frame; a layout takes one with a height", asked.area->name);
  }
  return std::nullopt;
}

layout::Hall hall_of(const Asked& asked) {
  layout::Hall hall;
  const coverage::FloorDescription& floor = asked.area->floor;
  for (const coverage::Place& each : floor.outline) hall.outline.push_back({each.x, each.y});
  for (const coverage::ShaftDescription& shaft : floor.shafts) {
    layout::Polygon& polygon = hall.obstacles.emplace_back();
    for (const coverage::Place& each : shaft.corners) polygon.push_back({each.x, each.y});
  }
  for (const coverage::ColumnDescription& column : floor.columns) {
    const layout::Point centre{column.centre.x, column.centre.y};
    hall.obstacles.push_back(column.round ? layout::around(centre, column.size)
                                          : layout::square(centre, column.size));
  }
  for (const lanes::Node& node : asked.network->description.nodes) {
    hall.gates.push_back({node.name, {node.x, node.y}});
  }
  return hall;
}

/// Where a block ends that begins behind `from`: its closing brace. With `last` the last closing
/// brace of all.
std::size_t closing_brace(const std::string& text, std::size_t from, bool last) {
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  int depth = 0;
  std::size_t found = text.size();
  for (auto token = interpreter::next_token(begin + from, end);
       token.kind != interpreter::Token::Kind::end;
       token = interpreter::next_token(token.end, end)) {
    if (token.is_symbol('{')) ++depth;
    if (!token.is_symbol('}')) continue;
    --depth;
    found = static_cast<std::size_t>(token.begin - begin);
    if (depth == 0 && !last) break;
  }
  return found;
}

/// The plan as it was written, with the layout in it.
std::string with_layout(const std::string& text, const PlanModel& plan, const Asked& asked,
                        const layout::Layout& chosen, const layout::Sizes& sizes) {
  layout::PlanNames names;
  names.network = asked.network->name;
  const auto& description = asked.network->description;
  for (const lanes::Node& node : description.nodes) names.gates.push_back(node.name);
  names.aisle_class = description.classes.front().name;
  names.cross_class = description.classes.back().name;
  for (const interpreter::FleetSpec& fleet : plan.fleets) names.fleets.push_back(fleet.name);
  names.floor = asked.area->X_WA.translation().z();
  names.height = sizes.height;
  names.with_tasks = plan.tasks.empty();
  const layout::PlanParts parts = layout::plan_parts(chosen, names);
  const std::size_t in_network = closing_brace(text, asked.network->span.end, false);
  const std::size_t in_plan = closing_brace(text, in_network + 1, true);
  std::string made = text.substr(0, in_network) + "\n" + parts.network;
  made += text.substr(in_network, in_plan - in_network) + "\n" + parts.plan;
  made += text.substr(in_plan);
  return interpreter::format_text(made, interpreter::TextKind::plan);
}

}  // namespace

int run_layout(const LayoutOptions& options) {
  layout::Sizes sizes;
  if (const auto wrong = take_module(options.module, sizes)) return fail(*wrong);
  interpreter::SourceMap sources;
  std::set<std::string> inputs;
  const auto plan = load_runnable_plan(options.plan, sources, {}, true, &inputs);
  if (!plan) return kWrongInput;
  if (const auto mistake = overwriting(inputs, {options.out})) return fail(*mistake);
  const interpreter::FileId file = 0;
  Asked asked;
  if (const auto wrong = find_asked(*plan, file, asked)) return fail(*wrong);
  const auto& classes = asked.network->description.classes;
  if (classes.empty()) {
    return fail(
        fmt::format("network '{}' has no class: write class aisle {{ speed 1.5 m/s; width "
                    "3 m; }}",
                    asked.network->name));
  }
  sizes.lane = classes.front().width;
  sizes.cross_lane = classes.back().width;
  sizes.aisle_speed = classes.front().speed;
  sizes.cross_speed = classes.back().speed;
  for (const interpreter::FleetSpec& fleet : plan->fleets) {
    sizes.vehicle_speed =
        sizes.vehicle_speed > 0 ? std::min(sizes.vehicle_speed, fleet.speed) : fleet.speed;
  }
  // A vehicle at a node beside a cross aisle stands clear of it.
  sizes.spacing = std::max(sizes.lane, sizes.cross_lane);
  if (const auto wrong =
          take_length("--spacing", options.spacing, kLeastPart, kMostPart, sizes.spacing)) {
    return fail(*wrong);
  }
  layout::BestLayouts found;
  try {
    found = layout::best_layouts(hall_of(asked), sizes);
  } catch (const std::invalid_argument& error) {
    return fail(error.what());
  }
  const int best = static_cast<int>(found.best.size());
  if (best > 0 && options.choose > best) {
    return fail(fmt::format("--choose is one of the {} layouts of the table, found {}", best,
                            options.choose));
  }
  if (best > 0 && !options.out.empty()) {
    building_io::BuildingPlan made;
    made.plan = with_layout(sources.file(file).text, *plan, asked,
                            found.best[at(options.choose - 1)], sizes);
    files::DiskFiles disk;
    if (refused({options.out, &made}, disk)) return kWrongInput;
    if (const auto failure = files::write_file(options.out, made.plan)) return fail(*failure);
  }
  const std::string text = options.format == "json" ? report::layout_json(plan->name, found)
                           : options.format == "csv"
                               ? report::layout_csv(found)
                               : report::layout_table(plan->name, found, options.choose);
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (best > 0) return kFine;
  std::fputs(
      "rubicon: no layout of these sizes fits: each gate needs a lane that comes within reach, and "
      "each row a lane beside it\n",
      stderr);
  return kInfeasible;
}

}  // namespace rubicon::cli
