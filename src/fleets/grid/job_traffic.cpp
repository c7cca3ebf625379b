#include "src/fleets/grid/job_traffic.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "src/fleets/grid/keep_order.hpp"
#include "src/fleets/grid/lacam.hpp"
#include "src/fleets/grid/window_search.hpp"

namespace rubicon::grid {

namespace {

/// Vehicles that plan together at most.
constexpr std::size_t kTogether = 8;
/// Work that was not spent is carried on; of it so much is spent in a tick.
constexpr std::int64_t kSpread = 10;
/// A vehicle is late when it has taken so many times the steps that it had before it, and so many
/// ticks more.
constexpr int kLateTimes = 2;
constexpr int kLateTicks = 100;
/// The search that gets it there takes no more work than that. Where it finds nothing, the next one
/// comes after so many ticks.
constexpr std::int64_t kMostPressed = 200'000;
constexpr int kPressedTicks = 100;
/// What a tick of a vehicle with a job counts, where that of one without counts 1.
constexpr int kWeightOfJob = 16;
/// When nobody has picked up or delivered for so many times the longest way that is left, and so
/// many ticks more, nothing moves on.
constexpr int kStillTimes = 20;
constexpr int kStillTicks = 5'000;

/// Bits that depend on three numbers and nothing else.
std::uint64_t bits_of(std::uint64_t seed, std::uint64_t vehicle, std::uint64_t move) {
  RandomBits first(seed ^ 0x6A09E667F3BCC909U);
  RandomBits second(first.next() + vehicle);
  RandomBits third(second.next() + move);
  return third.next();
}

struct Vehicle {
  Legs legs;
  int since = 0;      ///< tick at which it got its next place
  int late_from = 0;  ///< tick from which it counts as late
  int stands = 0;     ///< ticks that it will stand; nobody knows but the site
  int stood = 0;      ///< ticks that it has stood
  std::uint64_t moves = 0;
  int cost = 0;   ///< of its way, weighted
  int least = 0;  ///< of the best one, if nobody else were there
  bool is_fresh = true;
};

}  // namespace

class JobTraffic::State {
 public:
  State(const GridProblem& problem, const std::vector<GridJob>& jobs, const JobQuery& query)
      : query_(query),
        graph_(problem.map),
        cells_(cells_of(problem, false)),
        homes_(cells_of(problem, true)),
        board_(graph_, jobs, cells_.size()),
        distances_(graph_, twice(homes_)),
        moves_(graph_, distances_, homes_),
        table_(graph_.size(), query.window),
        search_(graph_, distances_, table_, query.window),
        keep_order_(graph_.size()),
        random_(query.seed),
        vehicles_(cells_.size()),
        ways_(cells_.size(), WindowWay(at(query.window) + 1)),
        ready_(cells_.size(), 0),
        done_(cells_.size(), 0) {
    result_.ways.resize(cells_.size());
    const auto all = static_cast<std::int64_t>(std::max<std::size_t>(1, jobs.size()));
    per_job_ =
        query.expansions > 0 ? std::max<std::int64_t>(1, query.expansions / all) : kUsualPerJob;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      vehicles_[i].legs.row = 2 * static_cast<int>(i);
      std::fill(ways_[i].begin(), ways_[i].end(), cells_[i]);
      go_home(i);
    }
  }

  bool advance() {
    if (board_.is_done()) {
      result_.end = JobsResult::End::done;
      return false;
    }
    if (now_ - last_event_ > patience()) {
      result_.end = JobsResult::End::standstill;
      for (std::size_t i = 0; i < cells_.size(); ++i) {
        if (board_.job_of(static_cast<int>(i)) >= 0) result_.stuck.push_back(static_cast<int>(i));
      }
      return false;
    }
    if (board_.is_idle()) last_event_ = now_;
    take_jobs();
    plan();
    move();
    return true;
  }

  const JobBoard& board() const { return board_; }

  JobsResult take_result() {
    result_.ticks = now_;
    result_.records = board_.records();
    result_.expansions = spent();
    return std::move(result_);
  }

 private:
  Configuration cells_of(const GridProblem& problem, bool goals) const {
    Configuration cells;
    for (const GridAgent& agent : problem.agents) {
      cells.push_back(graph_.id(goals ? agent.to : agent.from));
    }
    return cells;
  }
  static std::vector<CellId> twice(const Configuration& cells) {
    std::vector<CellId> all;
    for (const CellId cell : cells) all.insert(all.end(), 2, cell);
    return all;
  }

  std::int64_t spent() const { return moves_.expansions() + search_.expansions() + pressed_work_; }

  int patience() {
    int longest = 0;
    for (std::size_t i = 0; i < vehicles_.size(); ++i) {
      const Legs& legs = vehicles_[i].legs;
      longest = std::max(longest, legs.left(distances_, legs.first, cells_[i]));
    }
    return kStillTimes * (longest + query_.late_ticks) + kStillTicks;
  }

  void set_place(std::size_t i, int leg, CellId cell) {
    vehicles_[i].legs.places[at(leg)] = cell;
    distances_.set_goal(vehicles_[i].legs.row + leg, cell);
  }

  void go_home(std::size_t i) {
    set_place(i, 0, homes_[i]);
    vehicles_[i].legs.first = 0;
    vehicles_[i].legs.last = 1;
    begin_leg(i);
  }

  void begin_leg(std::size_t i) {
    Vehicle& vehicle = vehicles_[i];
    vehicle.since = now_;
    vehicle.is_fresh = true;
    const int steps = distances_.to_goal(vehicle.legs.row + vehicle.legs.first, cells_[i]);
    const double stands = query_.late * query_.late_ticks / 2;
    vehicle.late_from = now_ + static_cast<int>(kLateTimes * (1 + stands) * steps) + kLateTicks;
  }

  /// Jobs to those who have none; a vehicle may be where its job begins.
  void take_jobs() {
    for (bool again = true; again;) {
      again = false;
      for (const int vehicle : board_.give(now_, cells_)) {
        const std::size_t i = at(vehicle);
        const int job = board_.job_of(vehicle);
        set_place(i, 0, board_.from(job));
        set_place(i, 1, board_.to(job));
        vehicles_[i].legs.first = 0;
        vehicles_[i].legs.last = 2;
        result_.least += vehicles_[i].legs.left(distances_, 0, cells_[i]);
        begin_leg(i);
        credit_ += per_job_;
        last_event_ = now_;
        again = arrive(i) || again;
      }
    }
  }

  /// Whether it has delivered.
  bool arrive(std::size_t i) {
    if (!board_.arrive(static_cast<int>(i), now_, cells_[i])) return false;
    last_event_ = now_;
    if (board_.job_of(static_cast<int>(i)) >= 0) {
      vehicles_[i].legs.first = 1;
      begin_leg(i);
      return false;
    }
    go_home(i);
    return true;
  }

  /// How long a vehicle is expected to stand. It has stood for some time, and stands for
  /// `late_ticks` at most, evenly: half of what is left.
  int expected(const Vehicle& vehicle) const {
    if (vehicle.stands == 0) return 0;
    return std::max(1, (query_.late_ticks - vehicle.stood + 1) / 2);
  }

  void plan() {
    const int window = query_.window;
    const std::size_t count = cells_.size();
    for (std::size_t i = 0; i < count; ++i) ready_[i] = expected(vehicles_[i]);
    if (is_pressed()) {
      follow_pressed();
      return;
    }
    if (query_.late > 0 && now_ > 0) {
      for (std::size_t i = 0; i < count; ++i) table_.remove(ways_[i]);
      keep_order_.retime(ways_, done_, ready_, window);
      extend(window);
      for (std::size_t i = 0; i < count; ++i) table_.add(static_cast<int>(i), ways_[i]);
    } else if (now_ > 0) {
      extend(window);
      for (std::size_t i = 0; i < count; ++i) {
        table_.set(window, ways_[i].back(), static_cast<int>(i));
      }
    } else {
      for (int tick = 1; tick <= window; ++tick) extend(tick);
      for (std::size_t i = 0; i < count; ++i) table_.add(static_cast<int>(i), ways_[i]);
    }
    improve();
  }

  /// Whether all follow ways that get a late vehicle to its place. Looks for them if somebody is.
  bool is_pressed() {
    if (pressed_ >= 0) {
      const bool is_there = vehicles_[at(pressed_)].since != pressed_since_;
      if (!is_there && retime_long_ways()) return true;
      pressed_ = -1;
    }
    if (now_ < next_press_) return false;
    // The latest first; where nothing was found for it, the next one, and so on.
    late_.clear();
    for (std::size_t i = 0; i < vehicles_.size(); ++i) {
      if (board_.job_of(static_cast<int>(i)) >= 0 && now_ > vehicles_[i].late_from) {
        late_.push_back(i);
      }
    }
    if (late_.empty()) return false;
    std::stable_sort(late_.begin(), late_.end(), [&](std::size_t a, std::size_t b) {
      return vehicles_[a].since < vehicles_[b].since;
    });
    const auto latest = static_cast<int>(late_[tries_in_vain_ % late_.size()]);
    const Configuration goals = goals_apart(at(latest));
    Distances distances(graph_, goals);
    const LacamResult found =
        lacam(graph_, distances, cells_, goals, query_.seed, kMostPressed, latest);
    pressed_work_ += found.expansions;
    next_press_ = now_ + kPressedTicks;
    if (found.end != LacamResult::End::solved) {
      ++tries_in_vain_;
      return false;
    }
    tries_in_vain_ = 0;
    pressed_ = latest;
    pressed_since_ = vehicles_[at(latest)].since;
    long_ways_.assign(vehicles_.size(), {});
    for (const Configuration& step : found.steps) {
      for (std::size_t i = 0; i < step.size(); ++i) long_ways_[i].push_back(step[i]);
    }
    std::fill(done_.begin(), done_.end(), 0);
    return retime_long_ways();
  }

  /// Goals of which no two are the same. One vehicle has its place, others theirs or their homes as
  /// far as nobody has these, and else any cell, those that are near to where the first now is.
  Configuration goals_apart(std::size_t first) {
    Configuration goals(vehicles_.size(), kNowhere);
    std::vector<char> is_wanted(at(graph_.size()), 0);
    const auto want = [&](std::size_t i, CellId cell) {
      if (goals[i] != kNowhere || is_wanted[at(cell)] != 0) return;
      is_wanted[at(cell)] = 1;
      goals[i] = cell;
    };
    const auto place = [&](std::size_t i) {
      return vehicles_[i].legs.goal(vehicles_[i].legs.first);
    };
    want(first, place(first));
    for (std::size_t i = 0; i < goals.size(); ++i) want(i, place(i));
    for (std::size_t i = 0; i < goals.size(); ++i) want(i, homes_[i]);
    std::vector<CellId> near = {cells_[first]};
    std::vector<char> seen(at(graph_.size()), 0);
    seen[at(near.front())] = 1;
    std::size_t next = 0;
    for (std::size_t i = 0; i < goals.size(); ++i) {
      for (; goals[i] == kNowhere; ++next) {
        const CellId cell = near[next];
        for (const CellId beside : graph_.beside(cell)) {
          if (std::exchange(seen[at(beside)], 1) == 0) near.push_back(beside);
        }
        want(i, cell);
      }
    }
    return goals;
  }

  /// Ways become longer by what is late. Whether anybody still moves there.
  bool retime_long_ways() {
    const int late = *std::max_element(ready_.begin(), ready_.end());
    keep_order_.retime(long_ways_, done_, ready_,
                       static_cast<int>(long_ways_.front().size()) - 1 + late);
    const auto moves_at_end = [](const WindowWay& way) {
      return way[way.size() - 1] != way[way.size() - 2];
    };
    while (long_ways_.front().size() > 1 &&
           std::none_of(long_ways_.begin(), long_ways_.end(), moves_at_end)) {
      for (WindowWay& way : long_ways_) way.pop_back();
    }
    return long_ways_.front().size() > 1;
  }

  void follow_pressed() {
    const int window = query_.window;
    ++result_.pressed;
    const int known = std::min(window, static_cast<int>(long_ways_.front().size()) - 1);
    for (std::size_t i = 0; i < vehicles_.size(); ++i) {
      table_.remove(ways_[i]);
      for (int tick = 0; tick <= known; ++tick) ways_[i][at(tick)] = long_ways_[i][at(tick)];
      vehicles_[i].is_fresh = false;
    }
    for (int tick = known + 1; tick <= window; ++tick) extend(tick);
    for (std::size_t i = 0; i < vehicles_.size(); ++i) table_.add(static_cast<int>(i), ways_[i]);
  }

  /// Where all are at a tick of the window follows from where they are one tick before.
  void extend(int tick) {
    const std::size_t count = cells_.size();
    from_.resize(count);
    to_.assign(count, kNowhere);
    keys_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Legs& legs = vehicles_[i].legs;
      from_[i] = ways_[i][at(tick) - 1];
      int leg = legs.first;
      for (int k = 0; k < tick; ++k) leg = legs.after(leg, ways_[i][at(k)]);
      const int goal = std::min(leg, legs.last - 1);
      distances_.look_at(static_cast<int>(i), legs.row + goal);
      moves_.set_goal(static_cast<int>(i), legs.goal(goal));
      const bool rests = leg == legs.last || board_.job_of(static_cast<int>(i)) < 0;
      keys_[i] = {rests ? 1 : 0, vehicles_[i].since, static_cast<int>(i)};
      if (ready_[i] >= tick) to_[i] = from_[i];
    }
    std::sort(keys_.begin(), keys_.end());
    order_.clear();
    for (const auto& key : keys_) order_.push_back(key[2]);
    if (!moves_.find(from_, to_, order_, random_)) to_ = from_;
    for (std::size_t i = 0; i < count; ++i) ways_[i][at(tick)] = to_[i];
  }

  void measure(std::size_t i) {
    Vehicle& vehicle = vehicles_[i];
    const int weight = board_.job_of(static_cast<int>(i)) >= 0 ? kWeightOfJob : 1;
    vehicle.cost = weight * cost_of(ways_[i], vehicle.legs, distances_);
    vehicle.least =
        weight * (ready_[i] + vehicle.legs.left(distances_, vehicle.legs.first, cells_[i]));
  }

  bool find(std::size_t i, WindowWay& way) {
    return search_.find(cells_[i], ready_[i], vehicles_[i].legs, random_, way);
  }

  void improve() {
    const std::int64_t before = search_.expansions();
    for (std::size_t i = 0; i < vehicles_.size(); ++i) {
      measure(i);
      if (!vehicles_[i].is_fresh) continue;
      vehicles_[i].is_fresh = false;
      replan({i});
    }
    const std::int64_t until = before + std::max<std::int64_t>(0, credit_ / kSpread);
    collect_late();
    std::size_t in_vain = 0;
    while (search_.expansions() < until && !late_.empty() && in_vain < 4 * late_.size()) {
      const std::size_t first = late_[random_.below(late_.size())];
      const std::size_t most = 1 + random_.below(kTogether);
      if (vehicles_[first].cost <= vehicles_[first].least) {
        ++in_vain;
        continue;
      }
      in_vain = replan(group_of(first, most)) ? 0 : in_vain + 1;
    }
    credit_ -= search_.expansions() - before;
  }

  void collect_late() {
    late_.clear();
    for (std::size_t i = 0; i < vehicles_.size(); ++i) {
      if (vehicles_[i].cost > vehicles_[i].least) late_.push_back(i);
    }
  }

  /// A vehicle and those that it meets on its best way, or on one of its best ways.
  std::vector<std::size_t> group_of(std::size_t first, std::size_t most) {
    std::vector<std::size_t> group = {first};
    const auto add = [&](int other) {
      if (other < 0 || group.size() >= most) return;
      const std::size_t i = at(other);
      if (std::find(group.begin(), group.end(), i) == group.end()) group.push_back(i);
    };
    const Legs& legs = vehicles_[first].legs;
    CellId here = cells_[first];
    int leg = legs.after(legs.first, here);
    for (int tick = ready_[first] + 1; tick <= query_.window && leg < legs.last; ++tick) {
      CellId best = here;
      std::size_t ties = 0;
      const int steps = distances_.to_goal(legs.row + leg, here);
      for (const CellId beside : graph_.beside(here)) {
        if (distances_.to_goal(legs.row + leg, beside) >= steps) continue;
        if (random_.below(++ties) == 0) best = beside;
      }
      const int other = table_.at_tick(tick, best);
      if (other != static_cast<int>(first)) add(other);
      const int coming = table_.at_tick(tick - 1, best);
      if (coming >= 0 && coming != static_cast<int>(first) &&
          table_.at_tick(tick, here) == coming) {
        add(coming);
      }
      here = best;
      leg = legs.after(leg, here);
    }
    return group;
  }

  /// Vehicles plan anew, one after the other; whether their ways are better now.
  bool replan(std::vector<std::size_t> group) {
    for (std::size_t k = group.size(); k > 1; --k) std::swap(group[k - 1], group[random_.below(k)]);
    old_.resize(std::max(old_.size(), group.size()));
    int before = 0, after = 0;
    for (std::size_t k = 0; k < group.size(); ++k) {
      old_[k] = ways_[group[k]];
      before += vehicles_[group[k]].cost;
      table_.remove(ways_[group[k]]);
      // Who stands is there whatever the others plan.
      for (int tick = 0; tick <= std::min(ready_[group[k]], query_.window); ++tick) {
        table_.set(tick, cells_[group[k]], static_cast<int>(group[k]));
      }
    }
    std::size_t found = 0;
    while (found < group.size() && after <= before) {
      const std::size_t i = group[found];
      if (!find(i, ways_[i])) break;
      table_.add(static_cast<int>(i), ways_[i]);
      measure(i);
      after += vehicles_[i].cost;
      ++found;
    }
    if (found == group.size() && after <= before) return after < before;
    for (std::size_t k = 0; k < found; ++k) table_.remove(ways_[group[k]]);
    for (std::size_t k = 0; k < group.size(); ++k) {
      ways_[group[k]] = old_[k];
      table_.add(static_cast<int>(group[k]), old_[k]);
      measure(group[k]);
    }
    return false;
  }

  /// Whether a vehicle makes the next step of its way: nobody in front of it may stand.
  bool steps(std::size_t i) {
    const CellId next = ways_[i][1];
    if (next == cells_[i]) return false;
    char& known = steps_[i];
    if (known != kUnknownStep) return known != kStays;
    if (vehicles_[i].stands > 0) {
      known = kStays;
      return false;
    }
    known = kGoes;  // for who asks around a ring
    const int other = table_.at_tick(0, next);
    if (other >= 0 && !steps(at(other))) steps_[i] = kStays;
    return steps_[i] != kStays;
  }

  void move() {
    const std::size_t count = cells_.size();
    steps_.assign(count, kUnknownStep);
    for (std::size_t i = 0; i < count; ++i) steps(i);
    for (std::size_t i = 0; i < count; ++i) {
      const bool has_job = board_.job_of(static_cast<int>(i)) >= 0;
      const CellId next = ways_[i][1];
      const bool goes = steps_[i] == kGoes;
      done_[i] = next == cells_[i] || goes ? 1 : 0;
      result_.with_job += has_job ? 1 : 0;
      result_.ways[i] += goes ? letter(graph_.cell(cells_[i]), graph_.cell(next)) : 'w';
      if (!goes && has_job) ++(vehicles_[i].stands > 0 ? result_.stood : result_.waited);
    }
    if (query_.late <= 0) {
      for (std::size_t i = 0; i < count; ++i) {
        table_.set(0, cells_[i], -1);
        ways_[i].erase(ways_[i].begin());
        ways_[i].push_back(kNowhere);
      }
      table_.move_on();
    }
    ++now_;
    for (std::size_t i = 0; i < count; ++i) {
      Vehicle& vehicle = vehicles_[i];
      if (vehicle.stands > 0) {
        --vehicle.stands;
        ++vehicle.stood;
      }
      if (steps_[i] != kGoes) continue;
      cells_[i] = query_.late > 0 ? ways_[i][1] : ways_[i][0];
      ++result_.moves;
      ++vehicle.moves;
      if (query_.late > 0) end_late(i);
      arrive(i);
    }
  }

  void end_late(std::size_t i) {
    Vehicle& vehicle = vehicles_[i];
    RandomBits random(bits_of(query_.seed, i, vehicle.moves));
    const double share = static_cast<double>(random.next() >> 11U) * 0x1p-53;
    const auto ticks = static_cast<int>(random.below(at(query_.late_ticks) + 1));
    if (share >= query_.late || ticks == 0) return;
    vehicle.stands = ticks;
    vehicle.stood = 0;
    result_.stands.push_back({static_cast<int>(i), now_, ticks});
  }

  static char letter(Cell from, Cell to) {
    if (to.x != from.x) return to.x > from.x ? 'r' : 'l';
    return to.y > from.y ? 'd' : 'u';
  }

  static constexpr char kUnknownStep = 0, kGoes = 1, kStays = 2;

  JobQuery query_;
  CellGraph graph_;
  Configuration cells_, homes_;
  JobBoard board_;
  Distances distances_;
  NextMoves moves_;
  WindowTable table_;
  WindowSearch search_;
  KeepOrder keep_order_;
  RandomBits random_;
  std::vector<Vehicle> vehicles_;
  std::vector<WindowWay> ways_;
  std::vector<int> ready_;  ///< by vehicle: ticks for which it is expected to stand
  std::vector<int> done_;   ///< by vehicle: how far it is on its way of the tick before
  JobsResult result_;
  int now_ = 0;
  int last_event_ = 0;
  int pressed_ = -1;  ///< the late vehicle that is being got to its place
  int pressed_since_ = 0;
  int next_press_ = 0;
  std::size_t tries_in_vain_ = 0;
  std::int64_t pressed_work_ = 0;
  std::vector<WindowWay> long_ways_;  ///< by vehicle: until it is there
  std::int64_t per_job_ = 0;
  std::int64_t credit_ = 0;
  Configuration from_, to_;
  std::vector<std::array<int, 3>> keys_;
  std::vector<int> order_;
  std::vector<std::size_t> late_;
  std::vector<WindowWay> old_;
  std::vector<char> steps_;
};

JobTraffic::JobTraffic(const GridProblem& problem, const std::vector<GridJob>& jobs,
                       const JobQuery& query)
    : state_(std::make_unique<State>(problem, jobs, query)) {}
JobTraffic::~JobTraffic() = default;
bool JobTraffic::advance() { return state_->advance(); }
const JobBoard& JobTraffic::board() const { return state_->board(); }
JobsResult JobTraffic::take_result() { return state_->take_result(); }

JobsResult do_jobs(const GridProblem& problem, const std::vector<GridJob>& jobs,
                   const JobQuery& query) {
  JobTraffic traffic(problem, jobs, query);
  while (traffic.advance()) {
  }
  return traffic.take_result();
}

}  // namespace rubicon::grid
