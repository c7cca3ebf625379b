#pragma once

#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"

namespace rubicon::report {

/// A network with policy charts, and what came of its errands and reports.
struct ChartsResult {
  const interpreter::ChartsSpec& spec;
  const interpreter::NetworkSpec& description;
  const lanes::LaneNetwork& network;
  const charts::Course& course;
};

/// What became of all: every robot at its goal; not all; or conflicts that could not be resolved.
enum class ChartsOutcome { all_at_goals, not_all_at_goals, not_settled };
ChartsOutcome outcome_of(const charts::Course& course);

/// "ROB1 reports: an obstacle lies in B3 to B3B5, 2.25 m along, from 0 m to 4 m across".
std::string report_told(const ChartsResult& result, const charts::CourseStep& step);

/// How far robots have to see, for the speed of each class of lanes (of the quickest robot there,
/// where all are slower). Empty if the plan does not say how they stop.
std::vector<charts::SensingNeed> sensing_needs(const ChartsResult& result);
/// The same as a table; "" if it is empty.
std::string sensing_table(const ChartsResult& result);

/// For people: the charts one after the other with what led to each, then a line for each robot.
std::string charts_table(const ChartsResult& result);
/// Each place of the ways as they are gone, by robot; times in seconds.
std::string charts_csv(const ChartsResult& result);
/// All of it: the network, errands, reports, records, charts and ways; times in whole nanoseconds.
/// What rubicon verify reads.
std::string charts_json(const ChartsResult& result);

}  // namespace rubicon::report
