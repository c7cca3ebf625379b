#include "src/taskplan/unsupported.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

namespace rubicon::taskplan {

namespace {

using interpreter::Diagnostic;
using interpreter::Severity;
using interpreter::Span;

struct Feature {
  std::string_view what;  ///< as PlanModel::uses calls it
  std::string_view name;  ///< in a sentence
  std::string_view hint;
};

constexpr std::array<Feature, 13> kFeatures = {{
    {"calendar", "calendars", "leave the calendar out; times are then counted without breaks"},
    {"cost", "cost", "leave the cost out"},
    {"currency", "cost", "leave the currency out"},
    {"start_at", "dates", "leave start_at out; times are counted in seconds from the beginning"},
    {"park", "parking", "use a task with go instead"},
    {"zone", "zones", "leave the zone out, or put an obstacle in its place"},
    {"guide", "guides", "give way points by hand with via"},
    {"import", "imports", "write the components and tasks in the plan"},
    {"priority", "priorities", "order the tasks with after"},
    {"SS", "links other than FS", "use after with a plain task name"},
    {"FF", "links other than FS", "use after with a plain task name"},
    {"SF", "links other than FS", "use after with a plain task name"},
    {"lag", "lags of links", "put a task that takes the time between the two"},
}};

class Refusals {
 public:
  void add(std::string_view what, Span span) {
    if (what == "size") {
      add(Severity::warning, "X02", span,
          "the size of a crew changes nothing: run computes no cost", "");
      return;
    }
    const auto feature = std::find_if(kFeatures.begin(), kFeatures.end(),
                                      [&](const Feature& known) { return known.what == what; });
    if (feature == kFeatures.end()) {
      add(Severity::error, "X01", span, fmt::format("run does not execute '{}' yet", what), "");
    } else {
      add(Severity::error, "X01", span, fmt::format("run does not execute {} yet", feature->name),
          std::string(feature->hint));
    }
  }

  std::vector<Diagnostic> take() { return std::move(all_); }

 private:
  void add(Severity severity, const char* code, Span span, std::string message, std::string hint) {
    const bool known = std::any_of(all_.begin(), all_.end(), [&](const Diagnostic& diagnostic) {
      return diagnostic.span.file == span.file && diagnostic.span.begin == span.begin;
    });
    if (!known) all_.push_back({severity, code, span, std::move(message), {}, std::move(hint)});
  }

  std::vector<Diagnostic> all_;
};

}  // namespace

std::vector<Diagnostic> unsupported(const interpreter::PlanModel& plan) {
  Refusals refusals;
  std::set<std::string_view> listed;
  for (const interpreter::PlanModel::Use& use : plan.uses) {
    refusals.add(use.what, use.span);
    listed.insert(use.what);
  }
  // The model itself is asked too: what is in it must not be passed over because it is not listed.
  const auto add_unlisted = [&](std::string_view what, Span span) {
    if (!listed.contains(what)) refusals.add(what, span);
  };
  for (const interpreter::CalendarSpec& calendar : plan.calendars) {
    add_unlisted("calendar", calendar.span);
  }
  for (const interpreter::TaskSpec& task : plan.tasks) {
    if (task.guide) add_unlisted("guide", task.guide_span);
    if (!task.zones.empty()) add_unlisted("zone", task.zone_span);
    if (task.priority != 0) add_unlisted("priority", task.priority_span);
    for (const interpreter::LinkSpec& link : task.after) {
      if (link.type == interpreter::LinkType::SS) add_unlisted("SS", link.span);
      if (link.type == interpreter::LinkType::FF) add_unlisted("FF", link.span);
      if (link.type == interpreter::LinkType::SF) add_unlisted("SF", link.span);
      if (link.lag != 0) add_unlisted("lag", link.span);
    }
  }
  return refusals.take();
}

}  // namespace rubicon::taskplan
