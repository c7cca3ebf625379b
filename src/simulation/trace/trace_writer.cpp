#include "src/simulation/trace/trace_writer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <utility>

#include "src/simulation/trace/json_builder.hpp"
#include "src/simulation/trace/trace_header.hpp"

namespace rubicon::trace {

namespace {

/// Places of what is foreseen are told in whole millimetres.
constexpr double kForeseenPerMetre = 1000;

void append_truth(std::string& out, bool truth) { out += truth ? "true" : "false"; }

void append_integer(std::string& out, int number) {
  fmt::format_to(std::back_inserter(out), "{}", number);
}

}  // namespace

TraceWriter::TraceWriter(TraceSink& sink, const interpreter::PlanModel& plan,
                         const interpreter::SourceMap& sources, TraceDetail detail)
    : sink_(sink), plan_(plan), sources_(sources), detail_(detail) {
  set_task(plan.name, -1);
}

void TraceWriter::header() { sink_.line(header_line(plan_, sources_, detail_)); }

void TraceWriter::set_task(std::string_view task, int robot) {
  whose_ = ",\"task\":";
  append_string(whose_, task);
  whose_ += ",\"robot\":";
  keys_.clear();
  if (robot < 0) {
    whose_ += "\"\"";
    return;
  }
  const interpreter::RobotSpec& spec = plan_.robots[static_cast<std::size_t>(robot)];
  append_string(whose_, spec.name);
  for (const robot::Parameter& parameter : spec.robot->model.parameters) {
    append_string(keys_.emplace_back(), parameter.display_name);
    keys_.back() += ':';
  }
}

void TraceWriter::begin(const char* type) {
  line_ = "{\"type\":\"";
  line_ += type;
  line_ += '"';
  line_ += whose_;
}

void TraceWriter::finish() {
  line_ += '}';
  sink_.line(line_);
}

void TraceWriter::place(interpreter::Span span) {
  if (span.file == interpreter::kNoFile) return;
  const auto [slot, inserted] = places_.try_emplace({span.file, span.begin});
  std::string& text = slot->second;
  if (inserted) {
    const interpreter::Position position = sources_.position(span);
    text = ",\"file\":";
    append_string(text, sources_.file(span.file).path);
    fmt::format_to(std::back_inserter(text), ",\"line\":{},\"column\":{}", position.line,
                   position.column);
  }
  line_ += text;
}

void TraceWriter::configuration_key(int parameter) {
  line_ += keys_[static_cast<std::size_t>(parameter)];
}

void TraceWriter::configuration(std::span<const double> q) {
  line_ += ",\"q\":{";
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (i > 0) line_ += ',';
    line_ += keys_[i];
    append_number(line_, q[i]);
  }
  line_ += '}';
}

void TraceWriter::task_start(interpreter::Ticks time, std::string_view because,
                             std::string_view after, std::string_view chosen,
                             const std::vector<std::pair<int, double>>& to) {
  if (detail_ == TraceDetail::none) return;
  begin("task_start");
  line_ += ",\"t\":";
  append_seconds(line_, time);
  if (!because.empty()) {
    line_ += ",\"because\":";
    append_string(line_, because);
    line_ += ",\"after\":";
    append_string(line_, after);
  }
  if (!chosen.empty()) {
    line_ += ",\"chosen\":";
    append_string(line_, chosen);
  }
  if (!to.empty()) {
    line_ += ",\"to\":[";
    for (std::size_t i = 0; i < to.size(); ++i) {
      if (i > 0) line_ += ',';
      append_number(line_, to[i].second);
    }
    line_ += ']';
  }
  finish();
}

void TraceWriter::task_end(interpreter::Ticks time, std::string_view result,
                           std::string_view reason, const std::optional<TruckTimes>& rounds) {
  if (detail_ == TraceDetail::none) return;
  begin("task_end");
  line_ += ",\"t\":";
  append_seconds(line_, time);
  line_ += ",\"result\":";
  append_string(line_, result);
  line_ += ",\"reason\":";
  append_string(line_, reason);
  if (rounds) {
    line_ += ",\"driving\":";
    append_number(line_, rounds->driving);
    line_ += ",\"serving\":[";
    for (std::size_t i = 0; i < rounds->serving.size(); ++i) {
      if (i > 0) line_ += ',';
      append_number(line_, rounds->serving[i]);
    }
    line_ += ']';
  }
  finish();
}

void TraceWriter::load(const char* type, std::string_view component, const math::Pose& X,
                       interpreter::Ticks time, interpreter::Ticks overtime) {
  if (detail_ == TraceDetail::none) return;
  begin(type);
  line_ += ",\"component\":";
  append_string(line_, component);
  line_ += ",\"pose\":";
  line_ += JsonBuilder().pose(X).text();
  line_ += ",\"t\":";
  append_seconds(line_, time);
  if (overtime > 0) {
    line_ += ",\"overtime\":";
    append_seconds(line_, overtime);
  }
  finish();
}

void TraceWriter::attach(std::string_view component, const math::Pose& X_TO,
                         interpreter::Ticks time) {
  load("attach", component, X_TO, time, 0);
}

void TraceWriter::detach(std::string_view component, const math::Pose& X_WO,
                         interpreter::Ticks time, interpreter::Ticks overtime) {
  load("detach", component, X_WO, time, overtime);
}

void TraceWriter::hit(const interpreter::HitPair& pair) {
  line_ += ",\"hit\":[";
  append_string(line_, pair.moved);
  line_ += ',';
  append_string(line_, pair.met);
  line_ += ']';
}

void TraceWriter::span_of_time(interpreter::Ticks from, interpreter::Ticks to) {
  line_ += ",\"from\":";
  append_seconds(line_, from);
  line_ += ",\"t\":";
  append_seconds(line_, to);
}

void TraceWriter::remove(std::string_view component, interpreter::Ticks time) {
  if (detail_ == TraceDetail::none) return;
  begin("remove");
  line_ += ",\"component\":";
  append_string(line_, component);
  line_ += ",\"t\":";
  append_seconds(line_, time);
  finish();
}

void TraceWriter::work(std::string_view what, std::string_view crew, interpreter::Ticks from,
                       interpreter::Ticks to, interpreter::Ticks time) {
  if (detail_ == TraceDetail::none) return;
  begin("work");
  line_ += ",\"what\":";
  append_string(line_, what);
  line_ += ",\"crew\":";
  append_string(line_, crew);
  span_of_time(from, to);
  line_ += ",\"time\":";
  append_seconds(line_, time);
  finish();
}

void TraceWriter::turn(std::string_view component, double angle_deg, const math::Pose& X_TO,
                       interpreter::Ticks from, interpreter::Ticks to,
                       const std::optional<interpreter::HitPair>& refused) {
  if (detail_ == TraceDetail::none) return;
  begin("turn");
  line_ += ",\"component\":";
  append_string(line_, component);
  line_ += ",\"angle\":";
  append_number(line_, angle_deg);
  line_ += ",\"pose\":";
  line_ += JsonBuilder().pose(X_TO).text();
  span_of_time(from, to);
  if (refused) hit(*refused);
  finish();
}

void TraceWriter::pause(std::string_view why, std::string_view whom, interpreter::Ticks from,
                        interpreter::Ticks to) {
  if (detail_ == TraceDetail::none) return;
  begin("pause");
  line_ += ",\"why\":";
  append_string(line_, why);
  line_ += ",\"for\":";
  append_string(line_, whom);
  span_of_time(from, to);
  finish();
}

void TraceWriter::moving(std::string_view name, std::string_view by, interpreter::Ticks delay,
                         interpreter::Ticks time) {
  if (detail_ == TraceDetail::none) return;
  begin("moving");
  line_ += ",\"name\":";
  append_string(line_, name);
  line_ += ",\"by\":";
  append_string(line_, by);
  line_ += ",\"delay\":";
  append_seconds(line_, delay);
  line_ += ",\"t\":";
  append_seconds(line_, time);
  finish();
}

void TraceWriter::cold_joint(const coverage::ColdJoint& joint, interpreter::Ticks time) {
  if (detail_ == TraceDetail::none) return;
  begin("cold_joint");
  line_ += ",\"ends\":";
  const char* comma = "[";
  for (const double each : {joint.from.x, joint.from.y, joint.to.x, joint.to.y}) {
    line_ += comma;
    append_number(line_, each);
    comma = ",";
  }
  line_ += "],\"age\":";
  append_seconds(line_, joint.age);
  line_ += ",\"laid\":";
  append_seconds(line_, joint.laid);
  line_ += ",\"joined\":";
  append_seconds(line_, joint.joined);
  line_ += ",\"t\":";
  append_seconds(line_, time);
  finish();
}

void TraceWriter::breakdown(const MachineBreakdown& breakdown) {
  if (detail_ == TraceDetail::none) return;
  begin("breakdown");
  line_ += ",\"machine\":";
  append_string(line_, breakdown.machine);
  line_ += ",\"during\":";
  append_string(line_, breakdown.during);
  const auto time = [&](const char* name, interpreter::Ticks value) {
    line_ += name;
    append_seconds(line_, value);
  };
  time(",\"every\":", breakdown.every);
  time(",\"worked\":", breakdown.worked);
  time(",\"repair\":", breakdown.repair);
  time(",\"t\":", breakdown.from);
  time(",\"until\":", breakdown.until);
  finish();
}

void TraceWriter::lost_days(std::string_view calendar, int of, const std::vector<std::string>& days,
                            interpreter::Ticks end) {
  if (detail_ == TraceDetail::none) return;
  begin("lost_days");
  line_ += ",\"calendar\":";
  append_string(line_, calendar);
  line_ += ",\"of\":";
  append_integer(line_, of);
  line_ += ",\"days\":";
  line_ += JsonBuilder().strings(days).text();
  line_ += ",\"t\":";
  append_seconds(line_, end);
  finish();
}

void TraceWriter::soil(std::string_view component, soil::CubicMillimetres volume,
                       const std::map<int, soil::Millimetres>& heights, interpreter::Ticks from,
                       interpreter::Ticks to) {
  if (detail_ == TraceDetail::none) return;
  begin("soil");
  line_ += ",\"component\":";
  append_string(line_, component);
  fmt::format_to(std::back_inserter(line_), ",\"volume\":{},\"cells\":[", volume);
  const char* separator = "";
  for (const auto& each : heights) {
    fmt::format_to(std::back_inserter(line_), "{}{}", separator, each.first);
    separator = ",";
  }
  line_ += "],\"heights\":[";
  separator = "";
  for (const auto& each : heights) {
    fmt::format_to(std::back_inserter(line_), "{}{}", separator, each.second);
    separator = ",";
  }
  line_ += ']';
  span_of_time(from, to);
  finish();
}

void TraceWriter::foreseen(const interpreter::ForeseenWay& way, interpreter::Ticks time) {
  if (detail_ == TraceDetail::none) return;
  begin("foreseen");
  line_ += ",\"machine\":";
  append_string(line_, way.machine);
  line_ += ",\"seconds\":";
  append_number(line_, way.seconds);
  line_ += ",\"corners\":[";
  const char* separator = "";
  for (const std::vector<double>& outline : way.outlines) {
    fmt::format_to(std::back_inserter(line_), "{}{}", separator, outline.size() / 2);
    separator = ",";
  }
  line_ += "],\"points\":[";
  separator = "";
  for (const std::vector<double>& outline : way.outlines) {
    for (const double value : outline) {
      line_ += separator;
      append_number(line_, std::round(value * kForeseenPerMetre) / kForeseenPerMetre);
      separator = ",";
    }
  }
  line_ += "],\"t\":";
  append_seconds(line_, time);
  finish();
}

void TraceWriter::motion_end(const interpreter::MotionEnd& end) {
  if (detail_ == TraceDetail::none) return;
  begin("end");
  line_ += ",\"status\":";
  append_string(line_, name_of(end.status));
  line_ += ",\"reached\":";
  append_truth(line_, end.reached);
  line_ += ",\"period\":";
  if (end.period) {
    append_integer(line_, *end.period);
  } else {
    line_ += "null";
  }
  fmt::format_to(std::back_inserter(line_),
                 ",\"tries\":{},\"accepted\":{},\"rejected\":{{\"at goal\":{},\"no "
                 "direction\":{},\"limit\":{},\"hit\":{}}}",
                 end.tries, end.accepted, end.rejected.at_goal, end.rejected.no_direction,
                 end.rejected.limit, end.rejected.hit);
  line_ += ",\"residual\":{";
  const char* comma = "";
  for (const auto& [parameter, off] : end.residual) {
    line_ += comma;
    configuration_key(parameter);
    append_number(line_, off);
    comma = ",";
  }
  line_ += '}';
  if (end.position_error) {
    line_ += ",\"position_error\":";
    append_number(line_, *end.position_error);
  }
  if (end.orientation_error) {
    line_ += ",\"orientation_error\":";
    append_number(line_, *end.orientation_error);
  }
  configuration(end.q);
  line_ += ",\"vars\":{";
  comma = "";
  for (const auto& [name, value] : end.variables) {
    line_ += comma;
    append_string(line_, name);
    line_ += ':';
    append_number(line_, value);
    comma = ",";
  }
  line_ += "},\"t\":";
  append_seconds(line_, end.time);
  if (!end.missed.empty()) {
    line_ += ",\"missed\":[";
    comma = "";
    for (const interpreter::MissedWayPoint& each : end.missed) {
      line_ += comma;
      append_integer(line_, each.k);
      comma = ",";
    }
    line_ += "],\"missed_by\":[";
    comma = "";
    for (const interpreter::MissedWayPoint& each : end.missed) {
      line_ += comma;
      append_number(line_, each.off);
      comma = ",";
    }
    line_ += ']';
  }
  if (!end.reached) {
    place(end.span);
    line_ += ",\"message\":";
    append_string(line_, end.message);
  }
  finish();
}

void TraceWriter::goal(int k, int n) {
  if (!steps()) return;
  begin("goal");
  fmt::format_to(std::back_inserter(line_), ",\"k\":{},\"n\":{}", k, n);
  finish();
}

/// The first legs of very many.
void TraceWriter::append_graph(const guides::PlanReport& report) {
  constexpr std::size_t kMostLegs = 5000;
  if (report.tree.empty()) return;
  line_ += ",\"graph\":[";
  bool first = true;
  for (std::size_t i = 0; i < std::min(report.tree.size(), kMostLegs); ++i) {
    for (const std::vector<double>* const q : {&report.tree[i].first, &report.tree[i].second}) {
      for (const double value : *q) {
        if (!std::exchange(first, false)) line_ += ',';
        append_number(line_, value);
      }
    }
  }
  fmt::format_to(std::back_inserter(line_), "],\"legs\":{}", report.tree.size());
}

void TraceWriter::guide(const interpreter::GuidePlan& plan) {
  const guides::PlanReport& report = *plan.report;
  begin("guide");
  line_ += ",\"name\":";
  append_string(line_, plan.name);
  line_ += ",\"kind\":";
  append_string(line_, plan.kind);
  line_ += ",\"seed\":";
  append_number(line_, plan.seed);
  line_ += ",\"found\":";
  append_truth(line_, report.found());
  if (!report.found()) {
    line_ += ",\"cause\":";
    append_string(line_, plan.cause);
  }
  fmt::format_to(std::back_inserter(line_), ",\"nodes\":{},\"checks\":{},\"refused\":{}",
                 report.nodes, report.checks, report.refused);
  line_ += ",\"way\":[";
  bool first = true;
  for (const std::vector<double>& q : report.way) {
    for (const double value : q) {
      if (!std::exchange(first, false)) line_ += ',';
      append_number(line_, value);
    }
  }
  line_ += ']';
  if (!report.events.empty()) {
    line_ += ",\"events\":[";
    first = true;
    for (const std::string& event : report.events) {
      if (!std::exchange(first, false)) line_ += ',';
      append_string(line_, event);
    }
    line_ += ']';
  }
  append_graph(report);
  line_ += ",\"roughness\":";
  append_number(line_, report.metrics.roughness);
  line_ += ",\"length\":";
  append_number(line_, report.metrics.length);
  line_ += ",\"motion_time\":";
  append_number(line_, report.metrics.motion_time);
  line_ += ",\"t\":";
  append_seconds(line_, plan.time);
  finish();
  if (!plan.forbidden || grids_left_ == 0) return;
  --grids_left_;
  if (const auto grid = plan.forbidden()) forbidden(*grid, plan.time);
}

void TraceWriter::append_list(const char* name, std::span<const double> values) {
  fmt::format_to(std::back_inserter(line_), ",\"{}\":[", name);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) line_ += ',';
    append_number(line_, values[i]);
  }
  line_ += ']';
}

void TraceWriter::forbidden(const guides::ForbiddenGrid& grid, interpreter::Ticks time) {
  begin("forbidden");
  line_ += ",\"parameters\":[";
  for (std::size_t i = 0; i < grid.parameters.size(); ++i) {
    if (i > 0) line_ += ',';
    configuration_key(grid.parameters[i]);
    line_.pop_back();  // its colon
  }
  line_ += ']';
  append_list("low", grid.low);
  append_list("high", grid.high);
  fmt::format_to(std::back_inserter(line_), ",\"cells\":[{},{}]", grid.cells[0], grid.cells[1]);
  if (!grid.layers.empty()) append_list("layers", grid.layers);
  append_list("at", grid.q);
  line_ += ",\"runs\":[";
  std::size_t length = 0;
  bool blocked = false;
  for (const bool each : grid.blocked) {
    if (each != blocked) {
      fmt::format_to(std::back_inserter(line_), "{},", length);
      length = 0;
      blocked = each;
    }
    ++length;
  }
  fmt::format_to(std::back_inserter(line_), "{}],\"t\":", length);
  append_seconds(line_, time);
  finish();
}

void TraceWriter::way_point(int k, int n) {
  if (!steps()) return;
  begin("way_point");
  fmt::format_to(std::back_inserter(line_), ",\"k\":{},\"n\":{}", k, n);
  finish();
}

void TraceWriter::set(const std::string& variable, double value, interpreter::Span) {
  if (!steps()) return;
  begin("set");
  line_ += ",\"var\":";
  append_string(line_, variable);
  line_ += ",\"value\":";
  append_number(line_, value);
  finish();
}

void TraceWriter::enter(interpreter::LoopKind kind, interpreter::Span span) {
  if (!steps()) return;
  begin("enter");
  line_ += ",\"kind\":";
  append_string(line_, name_of(kind));
  place(span);
  finish();
}

void TraceWriter::exit(interpreter::LoopKind kind, interpreter::Span span, bool reached,
                       int successes) {
  if (!steps()) return;
  begin("exit");
  line_ += ",\"kind\":";
  append_string(line_, name_of(kind));
  place(span);
  line_ += ",\"reached\":";
  append_truth(line_, reached);
  line_ += ",\"successes\":";
  append_integer(line_, successes);
  finish();
}

void TraceWriter::which(const std::string& label, interpreter::Span span) {
  if (!steps()) return;
  begin("which");
  line_ += ",\"label\":";
  append_string(line_, label);
  place(span);
  finish();
}

void TraceWriter::attempt(const interpreter::Attempt& attempt) {
  if (!steps()) return;
  begin("try");
  line_ += ",\"n\":";
  append_integer(line_, attempt.n);
  line_ += ",\"command\":\"";
  line_ += attempt.command;
  line_ += "\",\"parameter\":";
  const std::string_view command = attempt.command;
  if (command == "together" || command == "follow" || command == "line") {
    line_ += '[';
    for (std::size_t i = 0; i < attempt.parameters.size(); ++i) {
      if (i > 0) line_ += ',';
      append_string(line_, attempt.parameters[i]);
    }
    line_ += ']';
  } else {
    append_string(line_, attempt.parameters.empty() ? "" : attempt.parameters.front());
  }
  place(attempt.span);
  line_ += ",\"ok\":";
  append_truth(line_, attempt.accepted);
  line_ += ",\"reason\":";
  append_string(line_, reason_text(attempt));
  if (attempt.hit != nullptr) {
    hit(*attempt.hit);
    line_ += ",\"step\":[";
    for (std::size_t i = 0; i < attempt.steps.size(); ++i) {
      if (i > 0) line_ += ',';
      append_number(line_, attempt.steps[i]);
    }
    line_ += ']';
  }
  line_ += ",\"t\":";
  append_seconds(line_, attempt.time);
  configuration(attempt.q);
  finish();
}

void TraceWriter::think(const interpreter::Thinking& thinking) {
  begin("think");
  fmt::format_to(std::back_inserter(line_), ",\"checks\":{}", thinking.checks);
  line_ += ",\"t\":";
  append_seconds(line_, thinking.time);
  finish();
}

void TraceWriter::wait(int n, interpreter::Ticks time, interpreter::Span) {
  if (!steps()) return;
  begin("wait");
  line_ += ",\"n\":";
  append_integer(line_, n);
  line_ += ",\"t\":";
  append_seconds(line_, time);
  finish();
}

void TraceWriter::stop(interpreter::Ticks time) {
  if (!steps()) return;
  begin("stop");
  line_ += ",\"t\":";
  append_seconds(line_, time);
  finish();
}

}  // namespace rubicon::trace
