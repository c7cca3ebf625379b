#include "src/results/verify/schedule/check_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/input/mechanism.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// m: strips that are nearer than this touch.
constexpr double kTouching = 0.03;
/// m: a joint may be told so far from where it is found. Its ends lie where its age is the limit,
/// and that is found to half a second of the tool's way.
constexpr double kPlaceSlack = 0.06;
/// m between places that are looked at.
constexpr double kPitch = 0.02;
/// m: shorter joints are corners that touch and do not count; those little longer may count.
constexpr double kCorner = 0.04;
constexpr double kSurelyJoint = 0.08;
/// An age may be off by this, and by what the tool takes for kPlaceSlack.
constexpr Ticks kAgeSlack = 2 * kSecond;
/// Cosine of the angle between joints that are one.
constexpr double kSameWay = 0.99;
/// m: of a strip, left at its ends.
constexpr double kStripEnd = 1e-3;
/// m: longer or farther strips are none of a floor.
constexpr double kLongestStrip = 20'000;
/// m: the side of the squares in which strips are looked for.
constexpr double kSquare = 2;

struct FlatPoint {
  double x = 0;
  double y = 0;
  FlatPoint operator+(const FlatPoint& other) const { return {x + other.x, y + other.y}; }
  FlatPoint operator-(const FlatPoint& other) const { return {x - other.x, y - other.y}; }
  FlatPoint operator*(double k) const { return {x * k, y * k}; }
  double dot(const FlatPoint& other) const { return x * other.x + y * other.y; }
  double norm() const { return std::sqrt(x * x + y * y); }
};

double distance_to(const FlatPoint& p, const FlatPoint& a, const FlatPoint& b) {
  const FlatPoint along = b - a;
  const double square = along.dot(along);
  const double share = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0;
  return (p - (a + along * share)).norm();
}

/// One line of the way at work, and when its tool first passed each place of it.
struct WorkedStrip {
  struct Piece {
    double from, to;  ///< m from its beginning
    double begin, end;
  };
  FlatPoint from, along;  ///< along: of length 1
  FlatPoint across() const { return {-along.y, along.x}; }
  double length = 0;
  std::vector<Piece> pieces;

  double worked() const { return pieces.empty() ? 0 : pieces.back().to; }
  FlatPoint place(double d) const { return from + along * d; }
  double time(double d) const {
    auto piece = std::partition_point(pieces.begin(), pieces.end(),
                                      [&](const Piece& each) { return each.to < d; });
    if (piece == pieces.end()) --piece;
    const double share = std::clamp((d - piece->from) / (piece->to - piece->from), 0.0, 1.0);
    return piece->begin + share * (piece->end - piece->begin);
  }
  double place_along(const FlatPoint& p) const { return (p - from).dot(along); }
  /// How much later or sooner the tool was so far from a place; a stand is none.
  double spread(double d) const {
    const double end = worked();
    auto piece = std::partition_point(pieces.begin(), pieces.end(),
                                      [&](const Piece& each) { return each.to < d; });
    if (piece == pieces.end()) --piece;
    double slowest = (piece->end - piece->begin) / (piece->to - piece->from);
    for (const double other : {d - kPlaceSlack, d + kPlaceSlack}) {
      if (other < 0 || other > end) continue;
      const auto near = std::partition_point(pieces.begin(), pieces.end(),
                                             [&](const Piece& each) { return each.to < other; });
      if (near == pieces.end()) continue;
      slowest = std::max(slowest, (near->end - near->begin) / (near->to - near->from));
    }
    return slowest * kPlaceSlack;
  }
};

/// A place on a joint.
struct JointPlace {
  FlatPoint p;
  FlatPoint along;   ///< of length 1, as the joint runs there
  double age = 0;    ///< ticks
  double slack = 0;  ///< ticks
  double size = 0;   ///< m that it stands for
  bool sure = true;  ///< its joint is long enough to count
};

/// All that one run of a task laid, and the places of its joints.
class JointSearch {
 public:
  JointSearch(const Trace& trace, const TaskRun& run)
      : trace_(trace), task_(trace.scene.tasks[at(run.task)]), half_(task_.width / 2) {
    read_strips(run);
    for (std::size_t i = 0; i < strips_.size(); ++i) enter(i);
    for (std::size_t i = 0; i < strips_.size(); ++i) look_round(i);
  }

  const std::vector<JointPlace>& places() const { return places_; }

 private:
  /// In the frame of the area.
  FlatPoint flat(const Pose& X_W) const {
    const Vec3 p =
        task_.area ? Vec3(task_.area->inverse() * X_W.translation()) : Vec3(X_W.translation());
    return {p.x(), p.y()};
  }

  void read_strips(const TaskRun& run) {
    const SceneRobot& robot = trace_.scene.robots[at(run.robot)];
    const Mechanism mechanism(robot);
    std::map<std::size_t, std::size_t> strip_of;  // by waypoint
    std::size_t waypoint = 0;
    std::vector<double> q;
    Ticks now = run.start;
    for (const int index : run.records) {
      const Record& record = trace_.records[at(index)];
      if (const auto* goal = std::get_if<Goal>(&record.what)) {
        const std::size_t left = at(std::max(goal->n - goal->k, 0));
        waypoint = left < task_.working.size() ? task_.working.size() - 1 - left : 0;
        continue;
      }
      if (const auto* attempt = std::get_if<Try>(&record.what)) {
        if (attempt->ok && !q.empty() && works(waypoint)) {
          const auto [found, is_new] = strip_of.emplace(waypoint, strips_.size());
          if (is_new) strips_.push_back(strip_to(waypoint));
          pass(strips_[found->second], flat(mechanism.pose(mechanism.tool(), q)),
               flat(mechanism.pose(mechanism.tool(), attempt->q)), now, record.time);
        }
        q = attempt->q;
      } else if (const auto* end = std::get_if<MotionEnd>(&record.what)) {
        q = end->q;
      }
      now = record.time;
    }
    // A floor is smaller than that (docs/coverage.md).
    std::erase_if(strips_, [](const WorkedStrip& strip) {
      return strip.pieces.empty() || strip.length > kLongestStrip ||
             !(std::max(std::fabs(strip.from.x), std::fabs(strip.from.y)) < 2 * kLongestStrip);
    });
  }

  bool works(std::size_t waypoint) const {
    if (waypoint == 0 || waypoint > task_.via.size() || !task_.working[waypoint]) return false;
    const bool has_end = waypoint < task_.via.size() ? task_.via[waypoint].pose.has_value()
                                                     : task_.go_pose.has_value();
    return has_end && task_.via[waypoint - 1].pose.has_value();
  }

  WorkedStrip strip_to(std::size_t waypoint) const {
    WorkedStrip strip;
    strip.from = flat(*task_.via[waypoint - 1].pose);
    const FlatPoint to =
        flat(waypoint < task_.via.size() ? *task_.via[waypoint].pose : *task_.go_pose);
    strip.length = (to - strip.from).norm();
    if (strip.length > 0) strip.along = (to - strip.from) * (1 / strip.length);
    return strip;
  }

  /// What the tool had passed before counts no more.
  static void pass(WorkedStrip& strip, const FlatPoint& from, const FlatPoint& to, Ticks begin,
                   Ticks end) {
    const auto place = [&](const FlatPoint& p) {
      const double d = strip.place_along(p);
      return d > strip.length - kStripEnd ? strip.length : d < kStripEnd ? 0.0 : d;
    };
    const double first = place(from);
    const double last = place(to);
    const double worked = strip.worked();
    if (!(last > worked) || !(last > first)) return;
    const double share = std::max(0.0, (worked - first) / (last - first));
    const auto start = static_cast<double>(begin);
    strip.pieces.push_back(
        {worked, last, start + share * static_cast<double>(end - begin), static_cast<double>(end)});
  }

  static std::pair<int, int> square_of(const FlatPoint& p) {
    return {static_cast<int>(std::floor(p.x / kSquare)),
            static_cast<int>(std::floor(p.y / kSquare))};
  }

  /// Into all squares that it may touch.
  void enter(std::size_t index) {
    const WorkedStrip& strip = strips_[index];
    const double reach = half_ + kSquare;
    std::set<std::pair<int, int>> squares;
    for (double d = 0; d < strip.worked() + kSquare; d += kSquare) {
      const FlatPoint p = strip.place(d);
      const auto low = square_of(p - FlatPoint{reach, reach});
      const auto high = square_of(p + FlatPoint{reach, reach});
      for (int x = low.first; x <= high.first; ++x) {
        for (int y = low.second; y <= high.second; ++y) squares.emplace(x, y);
      }
    }
    for (const auto& square : squares) squares_[square].push_back(static_cast<int>(index));
  }

  /// What lies beside a place of the border of a strip that was worked at `time`: the first that
  /// came later. Nothing where something was there before, or never comes.
  struct Beside {
    int strip = -1;
    double age = 0;
    double slack = 0;
  };
  Beside beside(std::size_t index, const FlatPoint& p, const FlatPoint& out, double time,
                double own_slack) const {
    Beside found;
    const FlatPoint outer = p + out * kTouching;
    const auto square = squares_.find(square_of(outer));
    if (square == squares_.end()) return found;
    for (const int other : square->second) {
      const WorkedStrip& strip = strips_[at(other)];
      if (at(other) == index) continue;
      const double d = strip.place_along(outer);
      if (d < 0 || d > strip.worked()) continue;
      if (std::fabs((outer - strip.from).dot(strip.across())) > half_) continue;
      const double own = std::clamp(strip.place_along(p), 0.0, strip.worked());
      const double age = strip.time(own) - time;
      if (age < 0) return {};
      if (found.strip >= 0 && age >= found.age) continue;
      found = {other, age, own_slack + strip.spread(own)};
    }
    return found;
  }

  /// Places along a border from a to b; `time_of` the share of it.
  template <typename Time>
  void look_along(std::size_t index, const FlatPoint& a, const FlatPoint& b, const FlatPoint& out,
                  const Time& time_of) {
    const double length = (b - a).norm();
    const int count = std::max(1, static_cast<int>(std::ceil(length / kPitch)));
    std::vector<std::pair<int, JointPlace>> row;
    for (int i = 0; i < count; ++i) {
      const double share = (i + 0.5) / count;
      const FlatPoint p = a + (b - a) * share;
      const auto [time, slack] = time_of(share);
      const Beside found = beside(index, p, out, time, slack);
      row.emplace_back(found.strip, JointPlace{p, (b - a) * (1 / length), found.age, found.slack,
                                               length / count, true});
    }
    add_row(row);
  }

  void add_row(std::vector<std::pair<int, JointPlace>>& row) {
    for (std::size_t i = 0; i < row.size();) {
      std::size_t end = i;
      double length = 0;
      while (end < row.size() && row[end].first == row[i].first) length += row[end++].second.size;
      for (; i < end; ++i) {
        if (row[i].first < 0 || length < kCorner) continue;
        row[i].second.sure = length > kSurelyJoint;
        places_.push_back(row[i].second);
      }
    }
  }

  void look_round(std::size_t index) {
    const WorkedStrip& strip = strips_[index];
    const double end = strip.worked();
    const FlatPoint side = strip.across() * half_;
    const auto along = [&](double share) {
      return std::pair(strip.time(share * end), strip.spread(share * end));
    };
    look_along(index, strip.from - side, strip.place(end) - side, strip.across() * -1.0, along);
    look_along(index, strip.from + side, strip.place(end) + side, strip.across(), along);
    for (const double d : {0.0, end}) {
      const auto there = [&](double) { return std::pair(strip.time(d), strip.spread(d)); };
      look_along(index, strip.place(d) - side, strip.place(d) + side,
                 strip.along * (d > 0 ? 1.0 : -1.0), there);
    }
    for (std::size_t i = 1; i < strip.pieces.size(); ++i) {
      const double stood = strip.pieces[i].begin - strip.pieces[i - 1].end;
      if (stood > static_cast<double>(kTimeSlack)) look_across(index, i, stood);
    }
  }

  /// Where the tool stood in the middle of a strip, what it laid after that meets what it laid
  /// before.
  void look_across(std::size_t index, std::size_t piece, double stood) {
    const WorkedStrip& strip = strips_[index];
    const FlatPoint p = strip.place(strip.pieces[piece].from);
    const FlatPoint side = strip.across() * half_;
    const int count = std::max(1, static_cast<int>(std::ceil(2 * half_ / kPitch)));
    std::vector<std::pair<int, JointPlace>> row;
    const double before = strip.pieces[piece - 1].end;
    for (int i = 0; i < count; ++i) {
      const FlatPoint place = p - side + side * (2 * (i + 0.5) / count);
      const bool taken = was_there(index, place + strip.along * kTouching, before);
      row.emplace_back(taken ? -1 : static_cast<int>(index),
                       JointPlace{place, strip.across(), stood, static_cast<double>(kAgeSlack),
                                  2 * half_ / count, true});
    }
    add_row(row);
  }
  bool was_there(std::size_t index, const FlatPoint& outer, double time) const {
    const auto square = squares_.find(square_of(outer));
    if (square == squares_.end()) return false;
    return std::any_of(square->second.begin(), square->second.end(), [&](int other) {
      const WorkedStrip& strip = strips_[at(other)];
      if (at(other) == index) return false;
      const double d = strip.place_along(outer);
      return d >= 0 && d <= strip.worked() &&
             std::fabs((outer - strip.from).dot(strip.across())) <= half_ && strip.time(d) < time;
    });
  }

  const Trace& trace_;
  const SceneTask& task_;
  const double half_;
  std::vector<WorkedStrip> strips_;
  std::map<std::pair<int, int>, std::vector<int>> squares_;
  std::vector<JointPlace> places_;
};

std::string minutes_text(double ticks) {
  return fmt::format("{:.1f} min", ticks / static_cast<double>(kMinute));
}

class JointCheck {
 public:
  JointCheck(const Trace& trace, const TaskRun& run, Faults& faults)
      : trace_(trace),
        run_(run),
        faults_(faults),
        limit_(static_cast<double>(trace.scene.tasks[at(run.task)].cold_after)),
        search_(trace, run) {}

  void check() {
    std::vector<bool> told(search_.places().size(), false);
    for (const int index : run_.records) {
      const Record& record = trace_.records[at(index)];
      if (const auto* joint = std::get_if<ColdJoint>(&record.what)) look_at(*joint, record, told);
    }
    for (std::size_t i = 0; i < told.size(); ++i) {
      const JointPlace& place = search_.places()[i];
      if (told[i] || !place.sure || place.age <= limit_ + slack(place)) continue;
      fault(run_.end_line, run_.end,
            fmt::format("a cold joint at ({:.2f}, {:.2f}), {} old, is not told", place.p.x,
                        place.p.y, minutes_text(place.age)));
      return;
    }
  }

  /// What a row of schedule.json tells.
  void check_row(const ScheduleRow& row) {
    const auto wrong = [&](std::string text) {
      faults_.push_back({FaultKind::joint, ResultFile::schedule_json, row.line,
                         trace_.runs[at(run_.run)], -1, std::move(text)});
    };
    if (!row.joints) return wrong("its cold joints are not told");
    std::vector<ColdJoint> told;
    for (const int index : run_.records) {
      if (const auto* joint = std::get_if<ColdJoint>(&trace_.records[at(index)].what)) {
        told.push_back(*joint);
      }
    }
    if (row.joints->count != static_cast<int>(told.size()) || row.joints->places != told) {
      wrong("its cold joints are not those of the trace");
    }
    if (std::llabs(row.joints->after - static_cast<Ticks>(limit_)) > kTimeSlack) {
      wrong("another limit of cold joints than in the plan");
    }
    double oldest = 0, slack_of_oldest = 0, least = 0, most = 0;
    for (const JointPlace& place : search_.places()) {
      if (place.sure && place.age > oldest) {
        oldest = place.age;
        slack_of_oldest = slack(place);
      }
      if (place.sure && place.age > limit_ + slack(place)) least += place.size;
      if (place.age > limit_ - slack(place)) most += place.size;
    }
    const double off = std::fabs(static_cast<double>(row.joints->oldest) - oldest);
    // What is hardly older than nothing, such as lines that go on at a corner, may not count.
    if (off > slack_of_oldest + static_cast<double>(kAgeSlack)) {
      wrong(fmt::format("its oldest joint is told as {} old; found {}",
                        minutes_text(static_cast<double>(row.joints->oldest)),
                        minutes_text(oldest)));
    }
    const double round = 0.02 * most + 2 * kPlaceSlack * (static_cast<double>(told.size()) + 1);
    if (row.joints->length < least - round || row.joints->length > most + round) {
      wrong(fmt::format("its cold joints are told as {:.2f} m long; found {:.2f} m",
                        row.joints->length, least));
    }
  }

 private:
  static double slack(const JointPlace& place) {
    return place.slack + static_cast<double>(kAgeSlack);
  }

  void fault(int line, Ticks time, std::string text) {
    faults_.push_back({FaultKind::joint, ResultFile::trace, line, trace_.runs[at(run_.run)], time,
                       std::move(text)});
  }

  void look_at(const ColdJoint& joint, const Record& record, std::vector<bool>& told) {
    const FlatPoint a{joint.from_x, joint.from_y};
    const FlatPoint b{joint.to_x, joint.to_y};
    const auto wrong = [&](std::string text) { fault(record.line, record.time, std::move(text)); };
    if (std::llabs(joint.joined - joint.laid - joint.age) > 2 * kTimeSlack) {
      return wrong("a cold joint whose age is not the time between its sides");
    }
    const double length = (b - a).norm();
    // Along it everything is cold.
    const int count = std::max(1, static_cast<int>(length / kPlaceSlack));
    std::vector<bool> seen(at(count), false);
    double oldest = -1, slack_of_oldest = 0;
    for (std::size_t i = 0; i < told.size(); ++i) {
      const JointPlace& place = search_.places()[i];
      if (place.age <= limit_ - slack(place)) continue;
      if (distance_to(place.p, a, b) > kPlaceSlack) continue;
      // Another joint may begin there, across it or farther on.
      if (std::fabs(place.along.dot(b - a)) < kSameWay * length) continue;
      told[i] = true;
      const double share = length > 0 ? (place.p - a).dot(b - a) / (length * length) : 0;
      if (place.age > oldest && share >= 0 && share <= 1) {
        oldest = place.age;
        slack_of_oldest = slack(place);
      }
      const int at_part = static_cast<int>(std::floor(share * count));
      for (const int part : {at_part - 1, at_part, at_part + 1}) {
        if (part >= 0 && part < count) seen[at(part)] = true;
      }
    }
    const auto gap = std::find(seen.begin(), seen.end(), false);
    if (oldest < 0 || gap != seen.end()) {
      const double share = (static_cast<double>(gap - seen.begin()) + 0.5) / count;
      const FlatPoint p = oldest < 0 ? a : a + (b - a) * share;
      return wrong(fmt::format("no cold joint at ({:.2f}, {:.2f})", p.x, p.y));
    }
    if (std::fabs(static_cast<double>(joint.age) - oldest) <=
        slack_of_oldest + static_cast<double>(kAgeSlack)) {
      return;
    }
    wrong(fmt::format("a cold joint is told as {} old; found {}",
                      minutes_text(static_cast<double>(joint.age)), minutes_text(oldest)));
  }

  const Trace& trace_;
  const TaskRun& run_;
  Faults& faults_;
  const double limit_;
  const JointSearch search_;
};

bool asks_for_joints(const Trace& trace, const TaskRun& run) {
  if (!run.happened || run.task < 0 || run.robot < 0) return false;
  const SceneTask& task = trace.scene.tasks[at(run.task)];
  return task.cold_after > 0 && task.width > 0 && task.working.size() == task.via.size() + 1;
}

}  // namespace

void check_joints(const Trace& trace, const TaskRun& run, Faults& faults) {
  if (asks_for_joints(trace, run)) {
    JointCheck(trace, run, faults).check();
    return;
  }
  for (const int index : run.records) {
    const Record& record = trace.records[at(index)];
    if (!run.happened || !std::holds_alternative<ColdJoint>(record.what)) continue;
    faults.push_back({FaultKind::joint, ResultFile::trace, record.line, trace.runs[at(run.run)],
                      record.time, "a cold joint of a task that has no limit for joints"});
  }
}

void check_joint_rows(const Trace& trace, const std::vector<TaskRun>& runs,
                      const std::vector<ScheduleRow>& rows, Faults& faults) {
  for (const TaskRun& run : runs) {
    if (!asks_for_joints(trace, run)) continue;
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const ScheduleRow& each) {
      return each.task == trace.runs[at(run.run)];
    });
    if (row != rows.end()) JointCheck(trace, run, faults).check_row(*row);
  }
}

}  // namespace rubicon::verify
