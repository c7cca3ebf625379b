#include "src/results/verify/charts/chart_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "src/results/verify/charts/least_ways.hpp"
#include "src/results/verify/charts/whereabouts.hpp"

namespace rubicon::verify {

namespace {

/// Of driving times, which are rounded once each.
constexpr double kRoundedBy = 4;
/// A share of a lane: a robot does not reach the end of one and is still in it.
constexpr double kEndOfLane = 2e-9;
/// m: gaps are differences of lengths.
constexpr double kSameGap = 1e-9;

std::size_t nth(int i) { return static_cast<std::size_t>(i); }

std::string told_seconds(Ticks time) {
  return fmt::format("{} s", static_cast<double>(time) / 1e9);
}

/// Where a robot waits so as to be later at a stop: at the last place before it from which it
/// drives along a lane.
std::size_t waits_for(const std::vector<ChartStop>& stops, std::size_t stop) {
  for (std::size_t i = stop + 1; i-- > 0;) {
    if (stops[i].leg == ChartLeg::along) return i;
  }
  return stop;
}

/// How many stops of a chart stay where its robot plans again.
std::size_t kept_stops(const std::vector<ChartStop>& stops) {
  const ChartStop& front = stops.front();
  const bool drives = front.node < 0 && (front.lane >= 0 || front.leg != ChartLeg::along);
  std::size_t kept = std::min<std::size_t>(drives ? 2 : 1, stops.size());
  while (kept < stops.size() && stops[kept].leg != ChartLeg::along) ++kept;
  return kept;
}

std::vector<int> lanes_after(const std::vector<ChartStop>& stops, std::size_t kept) {
  std::vector<int> lanes;
  for (std::size_t i = kept; i < stops.size(); ++i) lanes.push_back(stops[i].lane);
  return lanes;
}

class RecordsCheck {
 public:
  RecordsCheck(const ChartsResult& result, std::size_t step,
               const std::vector<std::vector<ChartStop>>& planned)
      : result_(result), step_(result.steps[step]), charts_(planned) {
    if (step > 0) before_ = &result.steps[step - 1];
  }

  std::vector<std::string> run() {
    if (before_ && step_.report) {
      look_at_reporter();
      check_report(*step_.report);
    }
    check_order();
    check_closing();
    for (std::size_t i = 0; i < step_.records.size(); ++i) {
      const ChartRecord& record = step_.records[i];
      check_told(record);
      if (record.kind == "yields") {
        check_yield(record);
      } else if (record.time != step_.time) {
        fault(fmt::format("'{}' is told of {}", record.told, told_seconds(record.time)));
      } else if (record.kind == "goes_back") {
        check_goes_back(record);
      } else if (is_way(record.kind)) {
        check_new_way(i);
      }
    }
    check_errands();
    return std::move(faults_);
  }

 private:
  const ChartRobot& robot(int i) const { return result_.robots[nth(i)]; }
  const ChartLane& lane(int i) const { return result_.lanes[nth(i)]; }
  std::string node_name(int i) const {
    return i < 0 ? std::string("Cur-Pos") : result_.nodes[nth(i)];
  }
  std::string lane_name(int i) const {
    return i < 0 ? std::string() : node_name(lane(i).from) + " to " + node_name(lane(i).to);
  }
  void fault(std::string text) { faults_.push_back(std::move(text)); }

  static bool is_way(const std::string& kind) {
    return kind == "planned_again" || kind == "returns" || kind == "stranded";
  }

  // ---- the report

  /// Where the reporting robot is, by the chart before.
  void look_at_reporter() {
    const RobotChart& chart = before_->charts[nth(step_.report->robot)];
    stops_ = &chart.stops;
    whereabouts_ = whereabouts(chart.stops, step_.time);
    const std::size_t next = whereabouts_.next;
    switch (whereabouts_.kind) {
      case Whereabouts::Kind::not_started:
        return;
      case Whereabouts::Kind::at_node:
        stands_at_ = whereabouts_.node;
        return;
      case Whereabouts::Kind::at_present_place:
        in_ = (*stops_)[next - 1].lane;
        leg_ = (*stops_)[next - 1].leg;
        if (in_ < 0 && leg_ == ChartLeg::along) stands_at_ = chart.passed;
        if (next < stops_->size()) remaining_ = (*stops_)[next].travel;
        return;
      case Whereabouts::Kind::in_motion:
        in_ = (*stops_)[next].lane;
        leg_ = (*stops_)[next].leg;
        remaining_ = whereabouts_.remaining;
        return;
    }
  }

  bool is_in(int its_lane) const {
    return in_ >= 0 && in_ == its_lane && leg_ == ChartLeg::along &&
           whereabouts_.next < stops_->size();
  }
  /// In the lane beside the one that it reports, against its direction.
  bool is_out_round() const {
    return step_.report && step_.report->kind == "obstacle" && in_ >= 0 &&
           in_ == lane(step_.report->lane).beside && leg_ == ChartLeg::against &&
           whereabouts_.next < stops_->size();
  }

  void check_report(const ChartReport& report) {
    const std::string& who = robot(report.robot).name;
    const ChartLane& of = lane(report.lane);
    const bool stands_before = stands_at_ >= 0 && stands_at_ == of.from;
    bool sees = true;
    std::string told = fmt::format("{} reports: {} is blocked", who, lane_name(report.lane));
    if (whereabouts_.kind == Whereabouts::Kind::not_started) {
      fault(fmt::format("{} reports, and has not started", who));
    }
    if (report.kind == "obstacle") {
      if (!is_in(report.lane) && !is_out_round()) {
        fault(fmt::format("{} reports an obstacle in {}, and is not there", who,
                          lane_name(report.lane)));
      } else {
        check_travelled(report);
      }
      check_gap(report);
      told = fmt::format(
          "{} reports: an obstacle lies in {}, {:.4g} m along, from {:g} m to {:g} m across", who,
          lane_name(report.lane), report.travelled, report.from, report.to);
    } else if (report.kind == "reopened") {
      if (!std::binary_search(before_->closed.begin(), before_->closed.end(), report.lane)) {
        fault(
            fmt::format("{} reports that {} is free, which was open", who, lane_name(report.lane)));
      }
      sees = is_in(report.lane) || stands_before || (stands_at_ >= 0 && stands_at_ == of.to);
      told = fmt::format("{} reports: {} is free again", who, lane_name(report.lane));
    } else {
      if (is_in(report.lane)) {
        fault(fmt::format("{} reports that {} is blocked, and is in it", who,
                          lane_name(report.lane)));
      }
      sees = stands_before;
    }
    if (report.is_doubted == sees) {
      fault(fmt::format("{} {} see {}, and that is {}", who, sees ? "can" : "can hardly",
                        lane_name(report.lane), sees ? "doubted" : "not doubted"));
    }
    if (report.told != told) fault(fmt::format("the report tells '{}'", report.told));
  }

  /// How far along its lane the robot is.
  void check_travelled(const ChartReport& report) {
    const ChartLane& of = lane(report.lane);
    const auto full = static_cast<double>(driving_time(of, of.length, robot(report.robot).speed));
    const double share = static_cast<double>(remaining_) / full;
    const ChartStop& next = (*stops_)[whereabouts_.next];
    const bool turns = next.leg == ChartLeg::against && next.lane == report.lane;
    const double expected = of.length * std::clamp(turns ? share : 1 - share, 0.0, 1.0);
    if (std::abs(report.travelled - expected) <= of.length * (kRoundedBy / full + kEndOfLane)) {
      return;
    }
    fault(fmt::format("{} reports an obstacle {:.9g} m along its lane, and is {:.9g} m along",
                      robot(report.robot).name, report.travelled, expected));
  }

  /// What is left of the lanes where it passes.
  void check_gap(const ChartReport& report) {
    const ChartLane& own = lane(report.lane);
    const double both = own.width + (own.beside < 0 ? 0 : lane(own.beside).width);
    const double to = std::max(0.0, report.to);
    double gap = 0;
    if (report.way == "right_in_lane") gap = std::min(std::max(0.0, report.from), own.width);
    if (report.way == "left_in_lane") gap = own.width - to;
    if (report.way == "left_lane") gap = both - to;
    if (report.from > report.to || std::abs(report.gap - gap) > kSameGap * std::max(1.0, both)) {
      fault(fmt::format("past the obstacle are {:.9g} m, and it is said to be {:.9g} m", gap,
                        report.gap));
    }
  }

  // ---- what the centre does

  bool tells(std::size_t i, const char* kind, int its_lane, int node) const {
    if (i >= step_.records.size()) return false;
    const ChartRecord& record = step_.records[i];
    return record.kind == kind && record.robot == step_.report->robot && record.lane == its_lane &&
           record.node == node;
  }

  bool closes(int its_lane) const {
    const auto has = [its_lane](const ChartStep& step) {
      return std::binary_search(step.closed.begin(), step.closed.end(), its_lane);
    };
    return has(step_) && !has(*before_);
  }

  /// The records begin with what the report says and what its robot does; who yields comes last.
  void check_order() {
    bool yields = false;
    for (const ChartRecord& record : step_.records) {
      if (yields && record.kind != "yields") fault(fmt::format("'{}' is told late", record.told));
      yields = yields || record.kind == "yields";
      if (!before_ && record.kind != "yields" && record.kind != "returns" &&
          record.kind != "stranded") {
        fault(fmt::format("'{}' is told of the first plan", record.told));
      }
    }
    if (!before_ || !step_.report) return;
    const ChartReport& report = *step_.report;
    const ChartLane& of = lane(report.lane);
    bool right = report.kind == "reopened" ? tells(0, "reopened", report.lane, -1)
                                           : tells(0, "seen", report.lane, -1);
    std::size_t next = 1;
    if (report.kind != "reopened" && closes(report.lane)) {
      right = right && tells(next++, "reported", report.lane, -1);
    }
    if (report.kind == "obstacle") {
      const bool goes_back = tells(next, "goes_back", report.lane, of.from);
      const bool has_beside = of.beside >= 0;
      right =
          right &&
          (goes_back ||
           (report.way == "left_lane" && has_beside &&
            tells(next, "bypasses", of.beside, lane(of.beside).from)) ||
           (report.way.ends_with("_in_lane") && tells(next, "passes_in_lane", report.lane, -1)));
    }
    if (!right) fault("its records do not begin with what the report says");
  }

  /// Each lane is seen, closed and opened once, by the robot that reports it, which passes an
  /// obstacle once.
  void check_closing() {
    std::set<std::pair<std::string, int>> told;
    int passes = 0;
    for (const ChartRecord& record : step_.records) {
      const std::string& kind = record.kind;
      if (kind == "goes_back" || kind == "yields" || is_way(kind)) continue;
      const bool passing = kind == "bypasses" || kind == "passes_in_lane";
      const bool closing = kind == "seen" || kind == "reported";
      if (!passing && !closing && kind != "reopened") {
        fault(fmt::format("a record is of the unknown kind '{}'", kind));
      } else if (before_ && step_.report) {
        const ChartReport& report = *step_.report;
        const bool beside = is_out_round() && record.lane == lane(report.lane).beside;
        bool right = record.robot == report.robot && told.insert({kind, record.lane}).second;
        if (closing) right = right && (record.lane == report.lane || beside);
        if (kind == "reported") right = right && closes(record.lane);
        if (kind == "reopened") right = right && report.kind == "reopened";
        if (passing) right = right && report.kind == "obstacle" && ++passes == 1;
        if (!right) fault(fmt::format("'{}' does not follow from the report", record.told));
      }
    }
    if (!before_) return;
    for (const int each : step_.closed) {
      if (closes(each) && !told.contains({"reported", each})) {
        fault(fmt::format("nobody tells that {} is closed", lane_name(each)));
      }
    }
  }

  // ---- what the robots do

  /// Its chart leads against the lane to the node where that begins.
  void check_goes_back(const ChartRecord& record) {
    const std::vector<ChartStop>& stops = charts_[nth(record.robot)];
    const bool right = record.lane >= 0 && record.node == lane(record.lane).from &&
                       stops.size() > 1 && stops[1].leg == ChartLeg::against &&
                       stops[1].lane == record.lane && stops[1].node == record.node;
    if (!right) {
      fault(fmt::format("'{}', and its chart does not", record.told));
    }
  }

  /// From the node to which it is committed, and because something has changed for it.
  void check_new_way(std::size_t index) {
    const ChartRecord& record = step_.records[index];
    const auto is_its = [&](const ChartRecord& other, const char* kind) {
      return other.robot == record.robot && other.kind == kind;
    };
    // Turned back later on, it plans from another node.
    for (std::size_t i = index + 1; i < step_.records.size(); ++i) {
      if (is_its(step_.records[i], "goes_back")) return;
    }
    const std::vector<ChartStop>& stops = charts_[nth(record.robot)];
    const std::size_t kept = kept_stops(stops);
    const int before = stops[kept - 1].node;
    const int from = before < 0 ? step_.charts[nth(record.robot)].passed : before;
    if (record.node != from || record.lane >= 0) {
      fault(fmt::format("'{}', and its chart goes on from {}", record.told, node_name(from)));
    }
    if (!before_ || !step_.report) return;
    for (std::size_t i = 0; i < index; ++i) {
      const ChartRecord& other = step_.records[i];
      if (is_its(other, "goes_back") || is_its(other, "bypasses") ||
          is_its(other, "passes_in_lane")) {
        return;
      }
    }
    const std::vector<int> old = old_way(record.robot);
    const ChartReport& report = *step_.report;
    bool has_cause = false;
    if (report.kind == "reopened") {
      has_cause =
          before_->charts[nth(record.robot)].errand != "to_goal" || old != lanes_after(stops, kept);
    } else {
      const int beside = is_out_round() ? lane(report.lane).beside : report.lane;
      has_cause = std::any_of(old.begin(), old.end(),
                              [&](int each) { return each == report.lane || each == beside; });
    }
    if (!has_cause) fault(fmt::format("'{}' without a cause", record.told));
  }

  /// The lanes that a robot had before it, but for what it is committed to.
  std::vector<int> old_way(int index) const {
    const std::vector<ChartStop>& stops = before_->charts[nth(index)].stops;
    const Whereabouts where = whereabouts(stops, step_.time);
    if (where.kind == Whereabouts::Kind::not_started) return lanes_after(stops, 1);
    ChartStop present;
    if (where.kind == Whereabouts::Kind::in_motion) {
      present.lane = stops[where.next].lane;
      present.leg = stops[where.next].leg;
    } else if (where.kind == Whereabouts::Kind::at_present_place) {
      present.lane = stops[where.next - 1].lane;
      present.leg = stops[where.next - 1].leg;
    }
    std::vector<ChartStop> ahead = {present};
    for (std::size_t i = where.next; i < stops.size(); ++i) ahead.push_back(stops[i]);
    return lanes_after(ahead, kept_stops(ahead));
  }

  /// The last that is told of where a robot is bound for holds, and what is not told stays.
  void check_errands() {
    for (std::size_t i = 0; i < step_.charts.size(); ++i) {
      std::string errand = before_ ? before_->charts[i].errand : "to_goal";
      for (const ChartRecord& record : step_.records) {
        if (nth(record.robot) != i) continue;
        if (record.kind == "planned_again") errand = "to_goal";
        if (record.kind == "returns") errand = "back";
        if (record.kind == "stranded") errand = "stranded";
      }
      if (step_.charts[i].errand == errand) continue;
      fault(fmt::format("the errand of {} is not what its records tell", result_.robots[i].name));
    }
  }

  // ---- who yields

  void check_yield(const ChartRecord& yield) {
    std::vector<ChartStop>& stops = charts_[nth(yield.robot)];
    if (yield.stop < 0 || nth(yield.stop) >= stops.size()) return;  // said elsewhere
    const bool meets = yield.conflict == "node" ? meets_at_node(yield)
                                                : meets_head_on(yield, yield.robot, yield.to) ||
                                                      meets_head_on(yield, yield.to, yield.robot);
    if (!meets) {
      fault(fmt::format("'{}', and there and then they do not meet so", yield.told));
    }
    for (std::size_t i = nth(yield.stop); i < stops.size(); ++i) {
      stops[i].arrival += yield.after - yield.before;
    }
  }

  bool meets_at_node(const ChartRecord& yield) const {
    const std::vector<ChartStop>& stops = charts_[nth(yield.robot)];
    if (yield.robot == yield.to || yield.node < 0 || yield.lane >= 0) return false;
    for (std::size_t i = 0; i < stops.size(); ++i) {
      if (stops[i].node != yield.node || waits_for(stops, i) != nth(yield.stop)) continue;
      for (const ChartStop& other : charts_[nth(yield.to)]) {
        if (other.node == yield.node &&
            std::abs(other.arrival - stops[i].arrival) < result_.tolerance &&
            yield.time == std::min(other.arrival, stops[i].arrival)) {
          return true;
        }
      }
    }
    return false;
  }

  /// From when on a robot may be on its way to a stop: it waits at a node to which it came against
  /// the direction of a lane.
  static Ticks begin_of(const std::vector<ChartStop>& stops, std::size_t end) {
    return came_back(stops, end) ? stops[end].arrival - stops[end].travel : stops[end - 1].arrival;
  }
  static bool came_back(const std::vector<ChartStop>& stops, std::size_t end) {
    return stops[end - 1].leg == ChartLeg::against;
  }

  /// Whether one drives against the direction of the lane where the other drives along it, and the
  /// yield is by as much as that takes.
  bool meets_head_on(const ChartRecord& yield, int against, int along) const {
    if (yield.lane < 0 || against == along) return false;
    const std::vector<ChartStop>& out = charts_[nth(against)];
    const std::vector<ChartStop>& with = charts_[nth(along)];
    for (std::size_t leg = 1; leg < out.size(); ++leg) {
      if (out[leg].leg != ChartLeg::against || out[leg].lane != yield.lane) continue;
      const bool in_lane = leg == 1 || out[leg - 1].leg == ChartLeg::along;
      if (yield.conflict != (in_lane ? "lane" : "across") ||
          yield.node != (in_lane ? out[leg] : out[leg - 1]).node) {
        continue;
      }
      for (std::size_t end = 1; end < with.size(); ++end) {
        if (with[end].leg == ChartLeg::against || with[end].lane != yield.lane) continue;
        const bool overlap =
            begin_of(with, end) <= out[leg].arrival && out[leg - 1].arrival <= with[end].arrival;
        if (!overlap || yield.time != std::max(with[end - 1].arrival, out[leg - 1].arrival)) {
          continue;
        }
        const Ticks by = yield.after - yield.before;
        std::size_t stop = 0;
        Ticks expected = 0;
        if (yield.robot == against) {
          stop = waits_for(out, leg);
          expected = with[end].arrival + result_.clearance - out[leg - 1].arrival;
        } else if (came_back(with, end)) {
          stop = end;
          expected = out[leg].arrival + result_.clearance - begin_of(with, end);
        } else {
          // Of a lane one node earlier, so that the node is free.
          const bool earlier = in_lane && end >= 2 && !came_back(with, end - 1);
          const std::size_t waits = earlier ? end - 2 : end - 1;
          stop = waits_for(with, waits);
          expected = out[leg].arrival + result_.clearance - with[waits].arrival;
        }
        if (stop == nth(yield.stop) && by == expected) return true;
      }
    }
    return false;
  }

  // ---- the texts

  void check_told(const ChartRecord& record) {
    if (record.told != text_of(record)) {
      fault(fmt::format("a record tells '{}', and says '{}'", record.told, text_of(record)));
    }
  }

  std::string text_of(const ChartRecord& record) const {
    const std::string& who = robot(record.robot).name;
    const std::string its_lane = lane_name(record.lane);
    const std::string node = node_name(record.node);
    const std::string& kind = record.kind;
    if (kind == "seen") {
      return fmt::format("{} sees at {} that {} is blocked", who, told_seconds(record.time),
                         its_lane);
    }
    if (kind == "reported") return its_lane + " is closed to all";
    if (kind == "reopened") return its_lane + " is open again";
    if (kind == "passes_in_lane") {
      return fmt::format("{} passes inside its lane, {}", who, its_lane);
    }
    if (kind == "bypasses") {
      return fmt::format("{} takes the lane beside, {}, against its direction", who, its_lane);
    }
    if (kind == "goes_back") return fmt::format("{} goes back to {}", who, node);
    if (kind == "planned_again") return fmt::format("{} has a new way from {}", who, node);
    if (kind == "returns") {
      return fmt::format("{} finds no way from {} to its goal and returns to its start", who, node);
    }
    if (kind == "stranded") {
      return fmt::format("{} finds no way from {} to its goal or back", who, node);
    }
    if (kind != "yields") return record.told;  // unknown, which is said
    const std::vector<ChartStop>& stops = charts_[nth(record.robot)];
    if (record.stop < 0 || nth(record.stop) >= stops.size()) return record.told;
    return fmt::format("{} yields to {} at {}: {} at {}, not {} ({})", who, robot(record.to).name,
                       node, node_name(stops[nth(record.stop)].node), told_seconds(record.after),
                       told_seconds(record.before), record.conflict);
  }

  const ChartsResult& result_;
  const ChartStep& step_;
  const ChartStep* before_ = nullptr;  ///< of all but the first
  std::vector<std::vector<ChartStop>> charts_;
  std::vector<std::string> faults_;
  // Of the reporting robot, by the chart before:
  const std::vector<ChartStop>* stops_ = nullptr;
  Whereabouts whereabouts_;
  int stands_at_ = -1;  ///< node
  int in_ = -1;         ///< lane
  ChartLeg leg_ = ChartLeg::along;
  Ticks remaining_ = 0;  ///< of the driving time to its next stop
};

}  // namespace

std::vector<std::string> chart_record_faults(const ChartsResult& result, std::size_t step,
                                             const std::vector<std::vector<ChartStop>>& planned) {
  return RecordsCheck(result, step, planned).run();
}

}  // namespace rubicon::verify
