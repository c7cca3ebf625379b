#include "src/results/film/film_runs.hpp"

#include <algorithm>
#include <utility>

#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::film {

int FilmRuns::open_run(std::string_view task) const {
  const auto found = open_.find(task);
  return found == open_.end() ? -1 : found->second;
}

int FilmRuns::begin(FilmRun run) {
  const int number = static_cast<int>(runs_.size());
  open_.emplace(run.task, number);
  runs_.push_back(std::move(run));
  return number;
}

void FilmRuns::close(int run) { open_.erase((*this)[run].task); }

double FilmRuns::end() const {
  double end = 0;
  for (const FilmRun& run : runs_) {
    if (run.happened) end = std::max(end, run.end.value_or(run.last));
  }
  return end;
}

std::string runs_json(const FilmRuns& runs) {
  trace::JsonBuilder json;
  json.begin_array();
  for (const FilmRun& run : runs.all()) {
    json.begin_object().field("task", run.task).field("robot", run.robot);
    json.field("start", run.start).key("end");
    if (run.end) {
      json.value(*run.end);
    } else {
      json.null();
    }
    json.field("result", run.result).field("reason", run.reason);
    json.field("because", run.because).field("after", run.after);
    json.field("happened", run.happened).end_object();
  }
  return json.end_array().take();
}

}  // namespace rubicon::film
