#include "src/simulation/taskplan/run_plan.hpp"

#include <optional>
#include <utility>

#include "src/simulation/taskplan/short_run.hpp"
#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

Schedule run_plan(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                  trace::TraceSink* sink, const RunOptions& options) {
  if (plan.short_form) return run_short(plan, sources, sink, options);
  std::optional<site::PreparedSite> own;
  if (!options.prepared) own = site::prepare_site(plan);
  const site::PreparedSite& prepared = own ? *own : *options.prepared;
  const interpreter::Draws own_draws{plan.sample};
  const interpreter::Draws& draws = options.draws ? *options.draws : own_draws;
  Verdicts known;
  while (true) {
    Simulation simulation(plan, sources, draws, sink, options, prepared, std::move(known));
    if (auto schedule = simulation.run()) {
      add_attributes(plan, *schedule);
      schedule->uncertain = interpreter::count_uncertain(plan);
      schedule->sample = draws.sample;
      return *std::move(schedule);
    }
    known = simulation.verdicts();
    if (sink) sink->restart();
  }
}

}  // namespace rubicon::taskplan
