#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "src/results/advice/advice.hpp"
#include "src/simulation/schedule/time_text.hpp"

namespace rubicon::advice {

namespace {

using nlohmann::ordered_json;
using schedule::clock_text;
using schedule::Ticks;

/// "0:12:00 sooner"; "" where it is the same to the second.
std::string compared(Ticks before, Ticks after, const char* less, const char* more) {
  const Ticks by = std::abs(after - before);
  if (schedule::seconds_from_ticks(by) < 1) return "";
  return fmt::format("{} {}", clock_text(by), after < before ? less : more);
}

std::string trial_text(const Advice& advice, const Trial& trial) {
  std::string text = fmt::format("  {}: {} is {}", trial.change, advice.task, trial.run.result);
  if (trial.run.result != "done") return text + ", " + trial.run.reason + "\n";
  text += " after " + clock_text(trial.run.end);
  if (advice.before.result == "done") {
    const std::string by = compared(advice.before.end, trial.run.end, "sooner", "later");
    if (!by.empty()) text += ", " + by;
  }
  text += fmt::format("; {} of {} tasks done, {} before", trial.run.done, advice.tasks,
                      advice.before.done);
  const std::string longer =
      compared(advice.before.process_time, trial.run.process_time, "shorter", "longer");
  if (!longer.empty()) text += "; the whole " + longer;
  if (!trial.lost.empty())
    text += fmt::format("; not done any more: {}", fmt::join(trial.lost, ", "));
  return text + "\n";
}

ordered_json run_json(const RunSummary& run) {
  ordered_json result = {{"result", run.result}, {"reason", run.reason}};
  if (run.result == "done") result["end"] = schedule::seconds_from_ticks(run.end);
  result["done"] = run.done;
  result["process_time"] = schedule::seconds_from_ticks(run.process_time);
  return result;
}

}  // namespace

std::string advice_text(const Advice& advice) {
  if (!advice.waits_for.empty()) {
    return fmt::format(
        "\nno advice for {}, which waits for {}: what helps that one is told by why PLAN {} "
        "--advise\n",
        advice.task, advice.waits_for, advice.waits_for);
  }
  if (advice.trials.empty() && advice.left_out.empty()) {
    if (advice.before.result == "not reached") {
      return "\nno advice: ask for the task that it comes after\n";
    }
    return fmt::format(
        "\nno advice: no change was found to try. Looked for: what stood in the way of {}; who had "
        "the robots and crews that it, or those before it, waited for; other robots. Not looked "
        "for: two changes at once, other scripts, other positions of machines, more crews\n",
        advice.task);
  }
  std::string good, bad;
  for (const Trial& trial : advice.trials) {
    (trial.helps ? good : bad) += trial_text(advice, trial);
  }
  std::string text = fmt::format("\nadvice, from {} {} of the changed plan:\n",
                                 advice.trials.size(), advice.trials.size() == 1 ? "run" : "runs");
  text += good.empty() ? "nothing that was tried helps\n" : "this helps\n" + good;
  if (!bad.empty()) text += "this does not\n" + bad;
  if (!advice.left_out.empty()) text += "not tried\n";
  for (const LeftOut& each : advice.left_out)
    text += fmt::format("  {}: {}\n", each.text, each.why);
  return text;
}

std::string json_with_advice(const std::string& story_json, const Advice& advice) {
  ordered_json result = {{"before", run_json(advice.before)}};
  result["tried"] = ordered_json::array();
  for (const Trial& trial : advice.trials) {
    ordered_json one = {{"change", trial.change}, {"helps", trial.helps}};
    one.update(run_json(trial.run));
    one["lost"] = trial.lost;
    result["tried"].push_back(std::move(one));
  }
  if (!advice.waits_for.empty()) result["waits_for"] = advice.waits_for;
  result["not_tried"] = ordered_json::array();
  for (const LeftOut& each : advice.left_out) {
    result["not_tried"].push_back({{"change", each.text}, {"why", each.why}});
  }
  ordered_json story = ordered_json::parse(story_json);
  story["advice"] = std::move(result);
  return story.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace rubicon::advice
