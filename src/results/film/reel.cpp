#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "src/motion/math/pose.hpp"
#include "src/results/film/reel_simdjson.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::film {

namespace {

/// A rotation that was written exactly gives a quaternion of length 1; this far off it is none.
constexpr double kRotationSlack = 1e-3;

RecordKind kind_of(const Record& record) {
  const std::string_view type = record.text("type");
  if (const auto kind = trace::record_kind(type)) return *kind;
  throw std::invalid_argument(
      fmt::format("this is no line of a trace: there is no type '{}'", type));
}

/// The seven numbers of a pose: position (m) and quaternion x, y, z, w.
std::array<double, 7> pose_numbers(const Record& record) {
  std::array<double, 12> rows{};
  std::size_t count = 0;
  for (const auto each : record.array("pose")) {
    if (count < rows.size()) rows[count] = as_number(each);
    ++count;
  }
  Eigen::Matrix3d R;
  R << rows[0], rows[1], rows[2], rows[4], rows[5], rows[6], rows[8], rows[9], rows[10];
  const Eigen::Quaterniond turn(R);
  if (count != rows.size() || !(std::abs(turn.norm() - 1) < kRotationSlack)) {
    throw std::invalid_argument("this is no line of a trace: 'pose' is no pose");
  }
  std::array<double, 7> numbers = {rows[3],  rows[7],  rows[11], turn.x(),
                                   turn.y(), turn.z(), turn.w()};
  for (const double value : numbers) millionths(value, "a pose");
  return numbers;
}

}  // namespace

void FilmWriter::Reel::line(std::string_view text) {
  if (!scene_) {
    scene_ = read_scene(text);
    tracks_.emplace(scene_->robots);
    return;
  }
  record(parse(text));
}

Record FilmWriter::Reel::parse(std::string_view text) {
  // The parser reads a little past the end.
  padded_.assign(text);
  padded_.append(simdjson::SIMDJSON_PADDING, ' ');
  simdjson::dom::element root;
  const auto error = parser_.parse(padded_.data(), text.size(), false).get(root);
  if (error != simdjson::SUCCESS) {
    throw std::invalid_argument(
        fmt::format("this is no line of a trace: {}", simdjson::error_message(error)));
  }
  return Record(root);
}

/// When a record is over.
double FilmWriter::Reel::time_of(const Record& record, RecordKind kind, const FilmRun& run) const {
  const double t = record.number_if_any("t").value_or(run.last);
  // The end of a rejected task tells its start again.
  const bool undone = kind == RecordKind::task_end && record.text("result") != "done";
  if (t < run.last && !undone) {
    throw std::invalid_argument("the task's time runs backwards here");
  }
  return t;
}

void FilmWriter::Reel::record(const Record& record) {
  const RecordKind kind = kind_of(record);
  const int run = run_of(record, kind);
  const double t = time_of(record, kind, runs_[run]);
  columns_.kind.add(static_cast<int>(kind));
  columns_.run.add(run);
  columns_.t.add(millionths(t, "a time"));
  runs_[run].last = t;
  switch (kind) {
    case RecordKind::task_start:
      break;
    case RecordKind::goal:
      return write_goal(record);
    case RecordKind::set:
      return write_set(record);
    case RecordKind::enter:
      return write_enter(record);
    case RecordKind::exit:
      return write_exit(record);
    case RecordKind::which:
      return write_which(record);
    case RecordKind::attempt:
      return write_try(record, run);
    case RecordKind::wait:
      return tracks_->stand(run, t);
    case RecordKind::work:
      return write_work(record, run);
    case RecordKind::pause:
      return write_pause(record, run);
    case RecordKind::attach:
      return write_load(record, columns_.attach_component, &columns_.attach_pose);
    case RecordKind::detach:
      return write_load(record, columns_.detach_component, &columns_.detach_pose);
    case RecordKind::remove:
      return write_load(record, columns_.remove_component, nullptr);
    case RecordKind::end:
      return write_end(record, run);
    case RecordKind::task_end:
      return end_task(record, run);
  }
}

/// The run that a record belongs to; begins it where this is its first.
int FilmWriter::Reel::run_of(const Record& record, RecordKind kind) {
  const std::string_view task = record.text("task");
  const int open = runs_.open_run(task);
  const bool starts = kind == RecordKind::task_start;
  if (open >= 0) {
    if (starts) throw std::invalid_argument(fmt::format("task '{}' begins twice", task));
    return open;
  }
  if (!starts && kind != RecordKind::task_end && !scene_->short_form) {
    throw std::invalid_argument(fmt::format("task '{}' has not begun", task));
  }
  FilmRun run;
  run.task = task;
  const std::string_view robot = record.text("robot");
  if (!robot.empty()) {
    const auto found = scene_->robot_numbers.find(robot);
    if (found == scene_->robot_numbers.end()) {
      throw std::invalid_argument(fmt::format("the trace's header has no robot '{}'", robot));
    }
    run.robot = found->second;
  }
  // The one task of a short plan begins with it.
  run.start = scene_->short_form ? 0 : record.number("t");
  run.last = run.start;
  run.because = record.text_or_empty("because");
  run.after = record.text_or_empty("after");
  const int number = runs_.begin(std::move(run));
  if (kind != RecordKind::task_end)
    tracks_->begin(number, runs_[number].robot, runs_[number].start);
  return number;
}

std::int64_t FilmWriter::Reel::place(const Record& record) {
  if (!record.has("file")) return places_.number({});
  return places_.number(
      {string(record.text("file")), record.whole("line"), record.whole("column")});
}

void FilmWriter::Reel::write_goal(const Record& record) {
  columns_.goal_k.add(record.whole("k"));
  columns_.goal_n.add(record.whole("n"));
}

void FilmWriter::Reel::write_set(const Record& record) {
  const auto value = record.element("value");
  columns_.set_var.add(string(record.text("var")));
  std::string text;
  if (value.is_null()) {
    text = "null";
  } else {
    trace::append_number(text, record.number("value"));
  }
  columns_.set_value.add(string(text));
}

void FilmWriter::Reel::write_enter(const Record& record) {
  columns_.enter_kind.add(string(record.text("kind")));
  columns_.enter_place.add(place(record));
}

void FilmWriter::Reel::write_exit(const Record& record) {
  columns_.exit_kind.add(string(record.text("kind")));
  columns_.exit_place.add(place(record));
  columns_.exit_reached.add(record.truth("reached") ? 1 : 0);
  columns_.exit_successes.add(record.whole("successes"));
}

void FilmWriter::Reel::write_which(const Record& record) {
  columns_.which_label.add(string(record.text("label")));
  columns_.which_place.add(place(record));
}

void FilmWriter::Reel::write_try(const Record& record, int run) {
  columns_.try_command.add(string(record.text("command")));
  const auto parameter = record.element("parameter");
  if (parameter.is_array()) {
    std::string names;
    for (const auto each : record.array("parameter")) {
      if (!names.empty()) names += ", ";
      names += as_text(each);
    }
    columns_.try_parameter.add(string(names));
  } else {
    columns_.try_parameter.add(string(as_text(parameter)));
  }
  columns_.try_place.add(place(record));
  const bool ok = record.truth("ok");
  columns_.try_ok.add(ok ? 1 : 0);
  columns_.try_reason.add(string(record.text("reason")));
  std::array<std::string_view, 2> hit;
  if (record.has("hit")) {
    std::size_t count = 0;
    for (const auto each : record.array("hit")) {
      if (count < hit.size()) hit[count++] = as_text(each);
    }
  }
  columns_.try_moved.add(string(hit[0]));
  columns_.try_met.add(string(hit[1]));
  if (ok) move(record, run);
}

/// To where a record says that the robot is.
void FilmWriter::Reel::move(const Record& record, int run) {
  const int robot = runs_[run].robot;
  if (robot < 0) return;
  const auto& parameters = scene_->robots[static_cast<std::size_t>(robot)].parameters;
  const Record q = record.object("q");
  q_.clear();
  // As it is written; any other order is as good.
  for (const auto member : q.members()) {
    if (q_.size() == parameters.size() || member.key != parameters[q_.size()].name) break;
    q_.push_back(as_number(member.value));
  }
  for (std::size_t i = q_.size(); i < parameters.size(); ++i) {
    q_.push_back(q.number(parameters[i].name));
  }
  tracks_->move(run, runs_[run].last, q_);
}

void FilmWriter::Reel::write_work(const Record& record, int run) {
  columns_.work_what.add(string(record.text("what")));
  columns_.work_crew.add(string(record.text("crew")));
  columns_.work_from.add(millionths(record.number("from"), "a time"));
  columns_.work_time.add(millionths(record.number("time"), "a time"));
  tracks_->stand(run, record.number("t"));
}

void FilmWriter::Reel::write_pause(const Record& record, int run) {
  columns_.pause_why.add(string(record.text("why")));
  columns_.pause_for.add(string(record.text("for")));
  columns_.pause_from.add(millionths(record.number("from"), "a time"));
  tracks_->stand(run, record.number("t"));
}

void FilmWriter::Reel::write_load(const Record& record, Column& component, PoseColumn* pose) {
  const std::string_view name = record.text("component");
  const auto found = scene_->component_numbers.find(name);
  if (found == scene_->component_numbers.end()) {
    throw std::invalid_argument(fmt::format("the trace's header has no component '{}'", name));
  }
  component.add(found->second);
  if (pose == nullptr) return;
  const auto numbers = pose_numbers(record);
  pose->values.insert(pose->values.end(), numbers.begin(), numbers.end());
}

void FilmWriter::Reel::write_end(const Record& record, int run) {
  columns_.end_status.add(string(record.text("status")));
  columns_.end_message.add(string(record.text_or_empty("message")));
  columns_.end_reached.add(record.truth("reached") ? 1 : 0);
  columns_.end_tries.add(record.whole("tries"));
  columns_.end_accepted.add(record.whole("accepted"));
  // Where single steps are not written, this is where they led.
  move(record, run);
}

void FilmWriter::Reel::end_task(const Record& record, int run) {
  FilmRun& ended = runs_[run];
  ended.result = record.text("result");
  ended.reason = record.text("reason");
  ended.happened = ended.result == "done";
  ended.end = ended.happened ? ended.last : tracks_->reached(run).value_or(ended.start);
  if (ended.happened) {
    tracks_->accept(run);
  } else {
    tracks_->reject(run);
  }
  runs_.close(run);
}

}  // namespace rubicon::film
