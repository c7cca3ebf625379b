#include "src/results/why/story_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "src/results/report/schedule_text.hpp"
#include "src/results/why/wait_chain.hpp"

namespace rubicon::why {

namespace {

using nlohmann::json;

/// Of the attempts at one place so many are kept, and up to twice as many.
constexpr std::size_t kKeptAttempts = 200;

Configuration configuration(const json& q) {
  Configuration result;
  for (const auto& [name, value] : q.items()) result.emplace_back(name, value.get<double>());
  return result;
}

std::vector<std::string> names(const json& one_or_more) {
  if (one_or_more.is_string()) return {one_or_more.get<std::string>()};
  return one_or_more.get<std::vector<std::string>>();
}

}  // namespace

StoryReader::StoryReader(std::string task) : task_(std::move(task)) { story_.task = task_; }

void StoryReader::restart() { *this = StoryReader(task_); }

void StoryReader::line(std::string_view text) {
  try {
    const json record = json::parse(text);
    const std::string type = record.at("type");
    if (type == "header") {
      read_header(record);
      return;
    }
    const std::string task = record.at("task");
    if (type == "task_start") {
      TaskRun& run = runs_[task];
      run.started = true;
      run.start = record.at("t");
      run.because = record.value("because", "");
      run.after = record.value("after", "");
    } else if (type == "task_end") {
      TaskRun& run = runs_[task];
      run.end = record.at("t");
      run.result = record.at("result");
      run.reason = record.at("reason");
      if (!run.started) run.start = run.end;
    }
    if (task == task_) read_own(type, record);
  } catch (const json::exception& error) {
    throw std::invalid_argument(fmt::format("this is no line of a trace: {}", error.what()));
  }
}

void StoryReader::read_header(const json& record) {
  if (record.value("format", "") != "rubicon-trace") {
    throw std::invalid_argument("this is no trace: its first line does not say so");
  }
  has_header_ = true;
  story_.detail = record.at("detail");
  if (!record.at("start_at").is_null()) {
    story_.start_at = report::start_from_text(record.at("start_at").get<std::string>());
  }
  if (record.at("form") == "short") order_.push_back(record.at("plan"));
  for (const json& task : record.at("tasks")) {
    order_.push_back(task.at("name"));
    if (order_.back() == task_ && task.contains("move")) move_ = task.at("move");
  }
}

/// What the motion that begins now is for.
std::string StoryReader::purpose() const {
  if (move_.empty()) return "going";
  if (!carries_) return "on the way to " + move_;
  return (carried_motions_ == 0 ? "carrying " : "placing ") + move_;
}

Motion& StoryReader::motion(double from) {
  if (!in_motion_) {
    in_motion_ = true;
    Motion& begun = story_.motions.emplace_back();
    begun.what = purpose();
    blocked_.clear();
    begun.from = from;
  }
  return story_.motions.back();
}

void StoryReader::read_own(const std::string& type, const json& record) {
  story_.robot = record.at("robot");
  if (type == "task_start") {
    // A robot may be parked several times: the last is told.
    TaskStory fresh;
    fresh.task = story_.task;
    fresh.robot = story_.robot;
    fresh.start_at = story_.start_at;
    fresh.detail = story_.detail;
    story_ = std::move(fresh);
    carries_ = in_motion_ = false;
    carried_motions_ = 0;
  } else if (type == "try") {
    read_try(record);
  } else if (type == "wait") {
    motion(time_);
  } else if (type == "end") {
    Motion& ended = motion(time_);
    ended.to = record.at("t");
    ended.tries = record.at("tries");
    ended.accepted = record.at("accepted");
    ended.reached = record.at("reached");
    ended.status = record.at("status");
    ended.message = record.value("message", "");
    ended.at_end = configuration(record.at("q"));
    in_motion_ = false;
    if (carries_) ++carried_motions_;
  } else if (type == "attach") {
    carries_ = true;
  } else if (type == "detach") {
    carries_ = false;
  } else if (type == "work") {
    story_.works.push_back({record.at("what"), record.at("crew"), record.at("from"), record.at("t"),
                            record.at("time")});
  } else if (type == "pause") {
    const Span span{record.at("why"), record.at("for"), record.at("from"), record.at("t"), 0};
    story_.pauses.push_back(span);
    // A motion that is tried again after a pause is still the same one.
    if (span.what == "machine" && carries_ && carried_motions_ > 0) --carried_motions_;
  }
  if (record.contains("t")) time_ = record.at("t");
}

void StoryReader::read_try(const json& record) {
  Attempt attempt;
  attempt.n = record.at("n");
  attempt.command = record.at("command");
  attempt.parameters = names(record.at("parameter"));
  attempt.file = record.value("file", "");
  attempt.line = record.value("line", 0);
  attempt.ok = record.at("ok");
  attempt.reason = record.at("reason");
  attempt.t = record.at("t");
  if (record.contains("hit")) {
    attempt.moved = record.at("hit").at(0);
    attempt.met = record.at("hit").at(1);
  }
  Motion& in = motion(time_);
  if (!attempt.met.empty()) {
    ++in.hits;
    if (!in.first_hit) {
      in.first_hit = attempt;
      in.first_hit_at = configuration(record.at("q"));
    }
  }
  keep(in, std::move(attempt));
}

/// Whatever is tried where something is blocked belongs together until that moves again.
void StoryReader::keep(Motion& in, Attempt attempt) {
  const bool blocks = !attempt.met.empty();
  if (attempt.ok && attempt.parameters == blocked_) {
    blocked_.clear();
    in.last.clear();
    return;
  }
  if (blocks && blocked_.empty()) in.last.clear();
  if (blocks) blocked_ = attempt.parameters;
  if (blocked_.empty() && attempt.ok) {
    in.last.clear();
    return;
  }
  if (in.last.size() >= 2 * kKeptAttempts) {
    in.last.erase(in.last.begin(), in.last.begin() + static_cast<std::ptrdiff_t>(kKeptAttempts));
  }
  in.last.push_back(std::move(attempt));
}

std::vector<std::string> StoryReader::tasks() const { return order_; }

bool StoryReader::has_task() const {
  return runs_.contains(task_) || std::find(order_.begin(), order_.end(), task_) != order_.end();
}

TaskStory StoryReader::story() const {
  TaskStory story = story_;
  const auto run = runs_.find(task_);
  if (run != runs_.end()) story.run = run->second;
  if (story.run.started && story.run.result == "done") {
    story.waits = wait_chain(task_, runs_);
  }
  return story;
}

}  // namespace rubicon::why
