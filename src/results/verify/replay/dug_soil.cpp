#include "src/results/verify/replay/dug_soil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "src/motion/math/index.hpp"
#include "src/results/verify/replay/holds.hpp"
#include "src/results/verify/replay/leg_motion.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// m: a bucket may be so far from where it is emptied, and cells lower or beside it.
constexpr double kPlaceSlack = 1e-4;
/// m: soil that no cut reaches comes away with a bucket that passes so near.
constexpr double kTrimmed = 0.5;
/// s: moments of the trace are rounded.
constexpr double kTruckSlack = 1e-3;
/// A leg in which soil is cut is looked at in so many parts.
constexpr int kParts = 24;

const SceneMotionDig* dig_of(const Trace& trace, const TaskRun& run) {
  if (!run.happened || run.task < 0) return nullptr;
  const auto& dig = trace.scene.tasks[at(run.task)].motion_dig;
  return dig ? &*dig : nullptr;
}

std::shared_ptr<const Solid> column(const SceneMotionDig& dig, int cell, std::int64_t bottom,
                                    std::int64_t top) {
  const double side = static_cast<double>(dig.cell) * 1e-3;
  const double x = cell % dig.columns * side;
  const double y = static_cast<double>(cell / dig.columns) * side;
  ShapeData box;
  box.a = {x, y, static_cast<double>(bottom) * 1e-3};
  box.b = {x + side, y + side, static_cast<double>(top) * 1e-3};
  return make_solid({box}, {});
}

/// The hours of all that a task has.
struct TaskHours {
  const TimeWorked& between;
  std::vector<int> calendars;
};

/// One task in which a robot dug.
class DigReplay {
 public:
  DigReplay(const Trace& trace, const TaskRun& run, int number, const RobotTrack& track,
            const RobotParts& machine, TaskHours hours, Faults& faults)
      : trace_(trace),
        run_(run),
        number_(number),
        dig_(*dig_of(trace, run)),
        track_(track),
        mechanism_(*machine.mechanism),
        hours_(std::move(hours)),
        faults_(faults),
        heights_(dig_.before) {
    const SceneRobot& robot = trace.scene.robots[at(run.robot)];
    for (std::size_t i = 0; i < machine.bodies.size(); ++i) {
      if (machine.body_index[i] == robot.tool_body) bucket_ = &machine.bodies[i];
    }
  }

  void check() {
    check_volume();
    for (const int index : run_.records) {
      const Record& record = trace_.records[at(index)];
      record_ = &record;
      if (const auto* taken = std::get_if<SoilTaken>(&record.what)) {
        take(*taken);
        full_ = true;
      } else if (const auto* end = std::get_if<MotionEnd>(&record.what)) {
        if (!end->reached || !is_at_place(*end)) continue;
        if (full_) {
          empty();
        } else {
          note_empty();
        }
      } else if (const auto* work = std::get_if<Work>(&record.what)) {
        if (work->what == "dump") note_empty();
      }
    }
    record_ = nullptr;
    if (full_) fault("its last bucket was not emptied");
    for (std::size_t i = 0; i < heights_.size(); ++i) {
      if (heights_[i] == dig_.after[i]) continue;
      fault(fmt::format("cell {} is left {} mm above the bottom of the pit", dig_.cells[i],
                        heights_[i] - dig_.after[i]));
      break;
    }
    if (dug_ != dig_.volume) {
      fault(fmt::format("{} mm3 were dug of {} mm3", dug_, dig_.volume));
    }
    if (loaded_ > 0) leave();
    check_tips();
    check_truck_work();
  }

 private:
  void fault(const std::string& text) {
    const int line = record_ != nullptr ? record_->line : run_.end_line;
    const Ticks time = record_ != nullptr ? record_->time : run_.end;
    faults_.push_back({FaultKind::load, ResultFile::trace, line, trace_.runs[at(run_.run)], time,
                       "soil: " + text});
  }

  std::int64_t area() const { return dig_.cell * dig_.cell; }

  /// The soil of the header is that of the component.
  void check_volume() {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < dig_.cells.size(); ++i) {
      if (dig_.before[i] <= dig_.after[i]) fault("a cell of the pit has no soil");
      sum += (dig_.before[i] - dig_.after[i]) * area();
    }
    double boxes = 0;
    for (const ShapeData& shape : trace_.scene.components[at(dig_.soil)].shapes) {
      boxes += shape.kind == ShapeData::Kind::box ? (shape.b - shape.a).prod() : 1e30;
    }
    const double volume = static_cast<double>(dig_.volume) * 1e-9;
    if (sum != dig_.volume || std::fabs(boxes - volume) > 1e-9 * volume) {
      fault(fmt::format("its {} mm3 are not the {} mm3 of its cells, or not those of its component",
                        dig_.volume, sum));
    }
  }

  void take(const SoilTaken& taken) {
    if (taken.from < last_ || taken.from > record_->time) {
      fault("a bucket is in the soil before the one before it is out of it");
    }
    last_ = record_->time;
    if (loaded_ == 0 && !full_) check_truck(taken.from);
    in_bucket_ += taken.volume;
    if (taken.volume < 0 || in_bucket_ > dig_.bucket) {
      fault(fmt::format("a bucket of {} mm3 takes {} mm3", dig_.bucket, in_bucket_));
    }
    const std::vector<Bounds> places = places_of(taken.from, record_->time);
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < taken.cells.size(); ++i) {
      const auto found = std::lower_bound(dig_.cells.begin(), dig_.cells.end(), taken.cells[i]);
      if (found == dig_.cells.end() || *found != taken.cells[i]) {
        fault(fmt::format("cell {} is not of the pit", taken.cells[i]));
        continue;
      }
      const auto cell = static_cast<std::size_t>(found - dig_.cells.begin());
      const std::int64_t height = taken.heights[i];
      if (height < dig_.after[cell] || height >= heights_[cell]) {
        fault(fmt::format("cell {} goes from {} to {} mm, and the bottom of the pit is at {} mm",
                          taken.cells[i], heights_[cell], height, dig_.after[cell]));
      } else if (!was_there(places, taken.cells[i], height, dig_.after[cell])) {
        fault(fmt::format("cell {} is dug to {} mm, where the tool never was", taken.cells[i],
                          height));
      }
      sum += (heights_[cell] - height) * area();
      heights_[cell] = height;
    }
    if (sum != taken.volume) {
      fault(fmt::format("a bucket takes {} mm3, and its cells lose {} mm3", taken.volume, sum));
    }
    dug_ += taken.volume;
  }

  /// Boxes around the bucket on its way, in the frame of the earth.
  std::vector<Bounds> places_of(Ticks from, Ticks to) const {
    std::vector<Bounds> places;
    if (bucket_ == nullptr) return places;
    const Pose X_EW = dig_.X_WE.inverse(Eigen::Isometry);
    for (const Leg& leg : track_.legs) {
      if (leg.run != number_ || !leg.moves() || leg.from < from || leg.to > to) continue;
      const LegFrames frames(mechanism_, leg);
      const LegPart part(frames, *bucket_);
      for (int i = 0; i < kParts; ++i) {
        const double u0 = static_cast<double>(i) / kParts;
        const PartState state = part.state(u0, u0 + 1.0 / kParts);
        places.push_back(
            bucket_->solid->bounds.placed(X_EW * state.X_WS).grown(state.reach.most()));
      }
    }
    return places;
  }

  /// Whether the bucket was over the cell and as deep as it was dug.
  bool was_there(const std::vector<Bounds>& places, int cell, std::int64_t height,
                 std::int64_t bottom) const {
    const double side = static_cast<double>(dig_.cell) * 1e-3;
    const double x = cell % dig_.columns * side;
    const double y = static_cast<double>(cell / dig_.columns) * side;
    // what is left within the tolerance of the bottom comes away, all or some of it
    const double low =
        static_cast<double>(std::max(height, bottom + dig_.tolerance)) * 1e-3 + kPlaceSlack;
    return std::any_of(places.begin(), places.end(), [&](const Bounds& place) {
      return place.lower.x() <= x + side + kTrimmed && place.upper.x() >= x - kTrimmed &&
             place.lower.y() <= y + side + kTrimmed && place.upper.y() >= y - kTrimmed &&
             place.lower.z() <= low;
    });
  }

  bool is_at_place(const MotionEnd& end) const {
    const Vec3 p = mechanism_.pose(mechanism_.tool(), end.q).translation();
    return (p - dig_.p_W).norm() <= kPlaceSlack;
  }

  void empty() {
    full_ = false;
    loaded_ += std::exchange(in_bucket_, 0);
    left_ = record_->time;
    if (dig_.trucks > 0 && loaded_ > dig_.load) fault("a truck takes more than its load");
    if (loaded_ + dig_.bucket > dig_.load) leave();
  }

  /// It goes on to be emptied.
  void note_empty() {
    left_ = record_->time;
    if (loaded_ == 0 && !departures_.empty()) departures_.back() = left_;
  }

  void leave() {
    if (dig_.trucks > 0) departures_.push_back(left_);
    loaded_ = 0;
  }

  static double least_of(const SceneStage& stage) {
    if (stage.law.empty()) return stage.seconds;
    if (stage.law == "uniform" || stage.law == "triangular" || stage.law == "pert") {
      return std::min(stage.seconds, stage.values.empty() ? 0 : stage.values.front());
    }
    if (stage.law == "sequence") return *std::min_element(stage.values.begin(), stage.values.end());
    return 0;
  }

  /// The least time of the stages up to and with this one.
  Ticks least_time(std::size_t last) const {
    double sum = 0;
    for (std::size_t i = 0; i <= last && i < dig_.stages.size(); ++i)
      sum += least_of(dig_.stages[i]);
    return static_cast<Ticks>(sum / dig_.efficiency * static_cast<double>(kSecond) * (1 - 1e-9));
  }

  /// Of all trucks that left, so many must be back that one can be loaded.
  void check_truck(Ticks from) {
    const int out = static_cast<int>(departures_.size());
    if (dig_.trucks == 0 || out < dig_.trucks) return;
    const Ticks back = departures_[at(out - dig_.trucks)] + least_time(dig_.stages.size());
    if (from + kTimeSlack < back) fault("it loads a truck that cannot be back");
  }

  void check_tips() {
    if (departures_.empty()) return;
    const Ticks tipped = departures_.back() + least_time(dig_.tip);
    if (run_.end + kTimeSlack < tipped) fault("it ends before its last truck can have tipped");
  }

  Ticks worked(Ticks time) const { return hours_.between(hours_.calendars, run_.start, time); }

  /// How long trucks drive and are served, by when they left: stage after stage.
  void check_truck_work() {
    const auto* end = std::get_if<TaskEnd>(&trace_.records[at(run_.records.back())].what);
    if (end == nullptr || !end->driving || dig_.trucks == 0) return;
    struct Spell {
      std::size_t stage = 0;
      Ticks from = 0, to = 0;
    };
    std::vector<Ticks> entries;
    for (const Ticks time : departures_) entries.push_back(worked(time));
    const std::size_t trucks_out = entries.size();
    Ticks over = entries.empty() ? 0 : entries.back();
    std::vector<Spell> spells;
    bool is_certain = true;
    double least = 0;
    for (std::size_t s = 0; s < dig_.stages.size(); ++s) {
      const SceneStage& stage = dig_.stages[s];
      const bool is_drawn = trace_.scene.sampled && !stage.law.empty() && stage.law != "sequence";
      is_certain = is_certain && !is_drawn;
      if (s <= dig_.tip) least += least_of(stage) / dig_.efficiency;
      std::stable_sort(entries.begin(), entries.end());
      std::vector<Ticks> free(at(stage.servers), 0);
      for (std::size_t i = 0; i < entries.size(); ++i) {
        const double seconds =
            stage.law == "sequence" ? stage.values[i % stage.values.size()] : stage.seconds;
        Ticks from = entries[i];
        const auto first = std::min_element(free.begin(), free.end());
        if (first != free.end()) from = std::max(from, *first);
        entries[i] = from + std::llround(seconds / dig_.efficiency * static_cast<double>(kSecond));
        if (first != free.end()) *first = entries[i];
        spells.push_back({s, from, entries[i]});
        if (s == dig_.tip) over = std::max(over, entries[i]);
      }
    }
    if (!is_certain) {
      const double most =
          static_cast<double>(worked(run_.end)) / static_cast<double>(kSecond) * dig_.trucks;
      const double serving = std::accumulate(end->serving.begin(), end->serving.end(), 0.0);
      const double lower = std::max(serving, least * static_cast<double>(trucks_out));
      if (*end->driving < lower * (1 - 1e-9) - 1e-6 || *end->driving > most * (1 + 1e-9) + 1e-6) {
        fault(fmt::format("its trucks drive for {:g} s, and that is from {:g} s to {:g} s",
                          *end->driving, lower, most));
      }
      return;
    }
    double driving = 0;
    std::vector<double> by_stage(dig_.stages.size(), 0);
    for (const Spell& spell : spells) {
      const Ticks time = std::clamp<Ticks>(over - spell.from, 0, spell.to - spell.from);
      const double seconds = static_cast<double>(time) / static_cast<double>(kSecond);
      driving += seconds;
      by_stage[spell.stage] += seconds;
    }
    std::vector<double> serving;
    for (std::size_t s = 0; s < dig_.stages.size(); ++s) {
      if (dig_.stages[s].servers > 0) serving.push_back(by_stage[s]);
    }
    const auto differ = [](double a, double b) {
      return std::fabs(a - b) > kTruckSlack + 1e-9 * std::fabs(b);
    };
    if (differ(*end->driving, driving)) {
      fault(fmt::format("its trucks drive for {:g} s, by when they left {:g} s", *end->driving,
                        driving));
    }
    if (!std::equal(serving.begin(), serving.end(), end->serving.begin(), end->serving.end(),
                    [&](double a, double b) { return !differ(b, a); })) {
      fault("its trucks are not served as long as that takes by when they left");
    }
  }

  const Trace& trace_;
  const TaskRun& run_;
  int number_;
  const SceneMotionDig& dig_;
  const RobotTrack& track_;
  const Mechanism& mechanism_;
  TaskHours hours_;
  Faults& faults_;
  const RobotPart* bucket_ = nullptr;
  const Record* record_ = nullptr;
  std::vector<std::int64_t> heights_;
  std::int64_t dug_ = 0, in_bucket_ = 0, loaded_ = 0;
  bool full_ = false;
  Ticks last_ = 0, left_ = 0;
  std::vector<Ticks> departures_;  ///< of trucks, or somewhat before
};

}  // namespace

std::set<int> add_dug_soil(const Trace& trace, const std::vector<TaskRun>& runs,
                           const std::vector<Stay>& stays, std::vector<Obstacle>& obstacles) {
  std::set<int> dug;
  for (const TaskRun& run : runs) {
    const SceneMotionDig* const dig = dig_of(trace, run);
    if (dig == nullptr) continue;
    dug.insert(dig->soil);
    Ticks end = run.end;
    for (const Stay& stay : stays) {
      if (stay.component == dig->soil) end = stay.to;
    }
    struct Column {
      std::int64_t height = 0;
      Ticks since = 0;
    };
    std::vector<Column> columns;
    for (const std::int64_t height : dig->before) columns.push_back({height, 0});
    const auto add = [&](std::size_t cell, Ticks to) {
      const Column& one = columns[cell];
      if (one.height <= dig->after[cell] || one.since >= to) return;
      obstacles.push_back({trace.scene.components[at(dig->soil)].name,
                           column(*dig, dig->cells[cell], dig->after[cell], one.height), dig->X_WE,
                           one.since, to, dig->soil, -1});
    };
    for (const int index : run.records) {
      const Record& record = trace.records[at(index)];
      const auto* taken = std::get_if<SoilTaken>(&record.what);
      if (taken == nullptr) continue;
      for (std::size_t i = 0; i < taken->cells.size(); ++i) {
        const auto found = std::lower_bound(dig->cells.begin(), dig->cells.end(), taken->cells[i]);
        if (found == dig->cells.end() || *found != taken->cells[i]) continue;
        const auto cell = static_cast<std::size_t>(found - dig->cells.begin());
        add(cell, record.time);
        columns[cell] = {taken->heights[i], record.time};
      }
    }
    for (std::size_t cell = 0; cell < columns.size(); ++cell) add(cell, end);
  }
  return dug;
}

Cuts::Cuts(const Trace& trace, const std::vector<TaskRun>& runs) : digs_(runs.size()) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SceneMotionDig* const dig = dig_of(trace, runs[i]);
    if (dig == nullptr) continue;
    digs_[i].component = dig->soil;
    for (const int index : runs[i].records) {
      const Record& record = trace.records[at(index)];
      const auto* taken = std::get_if<SoilTaken>(&record.what);
      if (taken != nullptr) digs_[i].times.emplace_back(taken->from, record.time);
    }
  }
}

bool Cuts::allow(const Leg& leg, int component) const {
  const Dig& dig = digs_[at(leg.run)];
  if (dig.component != component) return false;
  // The last cut that begins no later than the leg.
  const auto next = std::upper_bound(
      dig.times.begin(), dig.times.end(), leg.from,
      [](Ticks from, const std::pair<Ticks, Ticks>& time) { return from < time.first; });
  return next != dig.times.begin() && leg.to <= std::prev(next)->second;
}

std::vector<EmptiedBucket> emptied_buckets(const Trace& trace, const TaskRun& run,
                                           const Mechanism& mechanism) {
  std::vector<EmptiedBucket> buckets;
  const SceneMotionDig& dig = *dig_of(trace, run);
  std::int64_t volume = 0;
  for (const int index : run.records) {
    const Record& record = trace.records[at(index)];
    if (const auto* taken = std::get_if<SoilTaken>(&record.what)) volume += taken->volume;
    const auto* end = std::get_if<MotionEnd>(&record.what);
    if (end == nullptr || volume == 0 || !end->reached) continue;
    const Vec3 p = mechanism.pose(mechanism.tool(), end->q).translation();
    if ((p - dig.p_W).norm() > kPlaceSlack) continue;
    buckets.push_back({record.time, std::exchange(volume, 0)});
  }
  return buckets;
}

void check_dug_soil(const Trace& trace, const std::vector<TaskRun>& runs,
                    const std::vector<RobotTrack>& tracks, const SiteParts& site,
                    const TimeWorked& time_worked, Faults& faults) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (dig_of(trace, runs[i]) == nullptr || runs[i].robot < 0) continue;
    DigReplay(trace, runs[i], static_cast<int>(i), tracks[at(runs[i].robot)],
              site.robots[at(runs[i].robot)],
              {time_worked, calendars_of(trace, runs, static_cast<int>(i))}, faults)
        .check();
  }
}

}  // namespace rubicon::verify
