#include "src/results/verify/grid/check_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>

#include "src/results/verify/input/json_fields.hpp"

namespace rubicon::verify {

namespace {

constexpr std::size_t kListedFaults = 20;
constexpr int kMostTicks = 1'000'000'000;

struct Driver {
  std::string name;
  std::size_t cell = 0;  ///< where it is, as row x columns + column
  std::string way;
  std::vector<std::pair<int, int>> stands;  ///< from a tick on, so many
  int job = -1;
  bool has_picked = false;
};

struct Errand {
  std::string name;
  std::size_t from = 0, to = 0;
  int arrives = 0;
  int driver = -1;
  int taken = -1, picked = -1, delivered = -1;
};

class JobsCheck {
 public:
  explicit JobsCheck(const Json& json) : fields_(json, "the result of jobs") {}

  JobsVerdict run() {
    read_map();
    read_drivers();
    read_errands();
    read_late_moves();
    verdict_.agents = static_cast<int>(drivers_.size());
    verdict_.jobs = static_cast<int>(errands_.size());
    verdict_.ticks = ticks_;
    const std::string outcome = fields_.text("outcome");
    if (outcome != "done" && outcome != "standstill") {
      throw UnreadableInput("the outcome is none that jobs have");
    }
    verdict_.done = outcome == "done";
    walk();
    compare("delivered", verdict_.delivered);
    compare("moves", moves_);
    compare("with_job", with_job_);
    compare("stood", stood_);
    compare("waited", waited_);
    compare("least", least_);
    if (verdict_.done != (verdict_.delivered == verdict_.jobs)) {
      fault(fmt::format("the outcome is said to be {}, and {} of {} jobs are delivered", outcome,
                        verdict_.delivered, verdict_.jobs));
    }
    const double hours = ticks_ * fields_.number("tick_s") / 3600;
    const double said = fields_.number("jobs_per_hour");
    const double found = ticks_ == 0 ? 0 : verdict_.delivered / hours;
    if (std::abs(said - found) > 1e-6 * std::max(1.0, found)) {
      fault(fmt::format("jobs_per_hour is said to be {:g}, and is {:g}", said, found));
    }
    return std::move(verdict_);
  }

 private:
  void fault(std::string text) {
    if (verdict_.faults.size() < kListedFaults) verdict_.faults.push_back(std::move(text));
  }

  void compare(const char* what, long long found) {
    const double said = fields_.number(what);
    if (said != static_cast<double>(found)) {
      fault(fmt::format("{} is said to be {:.0f}, and is {}", what, said, found));
    }
  }

  void read_map() {
    const JsonFields map = fields_.object("map");
    for (const Json& row : map.array("rows")) {
      const std::string& text = text_of(row, "a row of the map");
      if (!open_.empty() && text.size() != columns_) {
        throw UnreadableInput("the rows of the map are not alike in length");
      }
      columns_ = text.size();
      for (const char c : text) open_.push_back(c == '.');
    }
    ticks_ = integer_of(fields_.any("ticks"), "the ticks", 0, kMostTicks);
  }

  std::size_t cell_of(const Json& value) const {
    if (!value.is_array() || value.size() != 2) throw UnreadableInput("a cell is two numbers");
    const int most = static_cast<int>(open_.size());
    const auto x = static_cast<std::size_t>(integer_of(value[0], "a column", 0, most));
    const auto y = static_cast<std::size_t>(integer_of(value[1], "a row", 0, most));
    if (x >= columns_ || y * columns_ + x >= open_.size() || !open_[y * columns_ + x]) {
      throw UnreadableInput(fmt::format("({}, {}) is no open cell", x, y));
    }
    return y * columns_ + x;
  }
  std::string text(std::size_t cell) const {
    return fmt::format("({}, {})", cell % columns_, cell / columns_);
  }

  void read_drivers() {
    for (const Json& each : fields_.array("agents")) {
      const JsonFields agent(each, "an agent");
      Driver driver;
      driver.name = agent.text("name");
      driver.cell = cell_of(agent.any("from"));
      driver.way = agent.text("way");
      if (driver.way.size() != static_cast<std::size_t>(ticks_)) {
        throw UnreadableInput("the way of agent '" + driver.name + "' has not one letter a tick");
      }
      if (!numbers_.emplace(driver.name, static_cast<int>(drivers_.size())).second) {
        throw UnreadableInput("two agents are called '" + driver.name + "'");
      }
      drivers_.push_back(std::move(driver));
    }
  }

  int driver_of(const JsonFields& fields) const {
    const auto found = numbers_.find(fields.text("agent"));
    if (found == numbers_.end()) fields.fail("the name of an agent");
    return found->second;
  }

  void read_errands() {
    for (const Json& each : fields_.array("jobs")) {
      const JsonFields job(each, "a job");
      Errand errand;
      errand.name = job.text("name");
      errand.from = cell_of(job.any("from"));
      errand.to = cell_of(job.any("to"));
      const auto tick = [&](const char* what) {
        return job.has(what) ? integer_of(job.any(what), what, 0, kMostTicks) : -1;
      };
      errand.arrives = std::max(0, tick("arrives"));
      errand.taken = tick("taken");
      errand.picked = tick("picked");
      errand.delivered = tick("delivered");
      if (errand.taken >= 0) errand.driver = driver_of(job);
      errands_.push_back(std::move(errand));
    }
    order_.resize(errands_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return errands_[a].arrives < errands_[b].arrives;
    });
  }

  void read_late_moves() {
    const int most = integer_of(fields_.any("late_ticks"), "late_ticks", 0, kMostTicks);
    for (const Json& each : fields_.array("late_moves")) {
      const JsonFields late(each, "a late move");
      const int driver = driver_of(late);
      const int tick = integer_of(late.any("tick"), "a tick", 0, kMostTicks);
      const int ticks = integer_of(late.any("ticks"), "the ticks of a late move", 1, kMostTicks);
      Driver& who = drivers_[static_cast<std::size_t>(driver)];
      if (ticks > most) {
        fault(fmt::format("agent '{}' is late by {} ticks; {} is the most", who.name, ticks, most));
      }
      if (tick < 1 || tick > ticks_ || who.way[static_cast<std::size_t>(tick) - 1] == 'w') {
        fault(fmt::format("tick {}: agent '{}' is late and has not moved", tick, who.name));
      }
      who.stands.emplace_back(tick, ticks);
      ++verdict_.late_moves;
    }
    const double share = fields_.number("late");
    if (share <= 0 && verdict_.late_moves > 0) fault("moves are late, and none should be");
  }

  /// Steps between two cells, by a search of its own.
  int steps(std::size_t from, std::size_t to) {
    return nearest(from, [&](std::size_t cell) { return cell == to; }).first;
  }
  /// The steps to the nearest cells that `is_it`, and these cells.
  template <typename Test>
  std::pair<int, std::vector<std::size_t>> nearest(std::size_t from, const Test& is_it) {
    seen_.resize(open_.size(), 0);
    ++search_;
    std::vector<std::size_t> border = {from}, next, found;
    seen_[from] = search_;
    for (int distance = 0; !border.empty(); ++distance) {
      next.clear();
      for (const std::size_t cell : border) {
        if (is_it(cell)) found.push_back(cell);
        const auto add = [&](bool is_there, std::size_t beside) {
          if (!is_there || !open_[beside] || seen_[beside] == search_) return;
          seen_[beside] = search_;
          next.push_back(beside);
        };
        add(cell % columns_ > 0, cell - 1);
        add(cell % columns_ + 1 < columns_, cell + 1);
        add(cell >= columns_, cell - columns_);
        add(cell + columns_ < open_.size(), cell + columns_);
      }
      if (!found.empty()) return {distance, found};
      border.swap(next);
    }
    return {-1, {}};
  }

  void walk() {
    here_.assign(open_.size(), -1);
    for (std::size_t i = 0; i < drivers_.size(); ++i) enter(i, 0);
    std::vector<std::size_t> late_of(drivers_.size(), 0);
    std::vector<std::size_t> before(drivers_.size());
    give(0);
    for (int tick = 1; tick <= ticks_; ++tick) {
      for (std::size_t i = 0; i < drivers_.size(); ++i) {
        Driver& driver = drivers_[i];
        before[i] = driver.cell;
        const char move = driver.way[static_cast<std::size_t>(tick) - 1];
        // Ticks in which it has to stand: those after the one in which the late move ended.
        std::size_t& late = late_of[i];
        while (late < driver.stands.size() &&
               driver.stands[late].first + driver.stands[late].second < tick) {
          ++late;
        }
        const bool stands = late < driver.stands.size() && driver.stands[late].first < tick;
        if (stands && move != 'w') {
          fault(fmt::format("tick {}: agent '{}' moves, and is late", tick, driver.name));
        }
        if (driver.job >= 0) {
          ++with_job_;
          if (move == 'w') ++(stands ? stood_ : waited_);
        }
        if (move != 'w') ++moves_;
        if (here_[driver.cell] == static_cast<int>(i)) here_[driver.cell] = -1;
        step(driver, move, tick);
      }
      for (std::size_t i = 0; i < drivers_.size(); ++i) enter(i, tick);
      for (std::size_t i = 0; i < drivers_.size(); ++i) {
        if (before[i] == drivers_[i].cell) continue;
        const int other = here_[before[i]];
        if (other >= 0 && static_cast<std::size_t>(other) != i &&
            before[static_cast<std::size_t>(other)] == drivers_[i].cell) {
          fault(fmt::format("tick {}: agents '{}' and '{}' pass through each other", tick,
                            drivers_[i].name, drivers_[static_cast<std::size_t>(other)].name));
        }
      }
      for (std::size_t i = 0; i < drivers_.size(); ++i) arrive(i, tick);
      if (verdict_.delivered < verdict_.jobs) give(tick);
    }
    for (const Errand& errand : errands_) {
      if (errand.driver < 0 && (errand.picked >= 0 || errand.delivered >= 0)) {
        fault("job '" + errand.name + "' has got on, and nobody took it");
      }
      if (errand.taken > ticks_ || errand.picked > ticks_ || errand.delivered > ticks_) {
        fault("job '" + errand.name + "' gets on after the end");
      }
    }
  }

  void step(Driver& driver, char move, int tick) {
    std::size_t next = driver.cell;
    bool is_on_map = true;
    if (move == 'r') {
      is_on_map = driver.cell % columns_ + 1 < columns_;
      next = driver.cell + 1;
    } else if (move == 'l') {
      is_on_map = driver.cell % columns_ > 0;
      next = driver.cell - 1;
    } else if (move == 'd') {
      next = driver.cell + columns_;
      is_on_map = next < open_.size();
    } else if (move == 'u') {
      is_on_map = driver.cell >= columns_;
      next = driver.cell - columns_;
    } else if (move != 'w') {
      fault(fmt::format("tick {}: agent '{}' has an unknown move", tick, driver.name));
    }
    if (!is_on_map || !open_[next]) {
      fault(fmt::format("tick {}: agent '{}' goes from {} into a wall", tick, driver.name,
                        text(driver.cell)));
      return;
    }
    driver.cell = next;
  }

  void enter(std::size_t i, int tick) {
    int& there = here_[drivers_[i].cell];
    if (there >= 0) {
      fault(fmt::format("tick {}: agents '{}' and '{}' are both in {}", tick,
                        drivers_[static_cast<std::size_t>(there)].name, drivers_[i].name,
                        text(drivers_[i].cell)));
    }
    there = static_cast<int>(i);
  }

  /// Picks up and delivers where the driver is, and looks whether that is what is said.
  void arrive(std::size_t i, int tick) {
    Driver& driver = drivers_[i];
    if (driver.job < 0) return;
    Errand& errand = errands_[static_cast<std::size_t>(driver.job)];
    const auto look = [&](const char* what, int said) {
      if (said == tick) return;
      fault(fmt::format("job '{}' is {} by agent '{}' at tick {}, and said to be so at tick {}",
                        errand.name, what, driver.name, tick, said));
    };
    if (!driver.has_picked && driver.cell == errand.from) {
      driver.has_picked = true;
      look("picked up", errand.picked);
    }
    if (driver.has_picked && driver.cell == errand.to) {
      look("delivered", errand.delivered);
      driver.job = -1;
      ++verdict_.delivered;
    }
  }

  /// Gives the jobs out that have arrived, as long as there are agents without one.
  void give(int tick) {
    if (tick == ticks_) return;
    for (; next_ < order_.size(); ++next_) {
      Errand& errand = errands_[order_[next_]];
      const bool is_anybody_free = std::any_of(drivers_.begin(), drivers_.end(),
                                               [](const Driver& each) { return each.job < 0; });
      if (errand.arrives > tick || !is_anybody_free) return;
      if (errand.taken != tick) {
        fault(fmt::format("tick {}: job '{}' can be taken, and is said to be taken at tick {}",
                          tick, errand.name, errand.taken));
        if (errand.driver < 0) return;
      }
      const auto is_free = [&](std::size_t cell) {
        return here_[cell] >= 0 && drivers_[static_cast<std::size_t>(here_[cell])].job < 0;
      };
      const auto [distance, cells] = nearest(errand.from, is_free);
      int best = -1;
      for (const std::size_t cell : cells) {
        if (best < 0 || here_[cell] < best) best = here_[cell];
      }
      Driver& driver = drivers_[static_cast<std::size_t>(errand.driver)];
      if (errand.driver != best) {
        fault(fmt::format(
            "tick {}: job '{}' goes to agent '{}', and {} is nearer to it", tick, errand.name,
            driver.name,
            best < 0 ? "nobody" : "'" + drivers_[static_cast<std::size_t>(best)].name + "'"));
        if (driver.job >= 0) return;
      }
      least_ += std::max(0, distance) + std::max(0, steps(errand.from, errand.to));
      driver.job = static_cast<int>(order_[next_]);
      driver.has_picked = false;
      arrive(static_cast<std::size_t>(errand.driver), tick);
    }
  }

  JsonFields fields_;
  std::vector<bool> open_;
  std::size_t columns_ = 0;
  int ticks_ = 0;
  std::vector<Driver> drivers_;
  std::map<std::string, int> numbers_;
  std::vector<Errand> errands_;
  std::vector<std::size_t> order_;
  std::size_t next_ = 0;
  std::vector<int> here_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t search_ = 0;
  long long moves_ = 0, with_job_ = 0, stood_ = 0, waited_ = 0, least_ = 0;
  JobsVerdict verdict_;
};

}  // namespace

bool is_jobs_result(const std::string& text) { return has_format(text, "rubicon-jobs"); }

JobsVerdict check_jobs(const std::string& text) {
  const Json json = parse_json(text);
  return JobsCheck(json).run();
}

std::string jobs_verdict_text(const JobsVerdict& verdict, const std::string& name) {
  std::string text;
  for (const std::string& fault : verdict.faults) text += name + ": " + fault + "\n";
  if (!verdict.faults.empty()) return text;
  return fmt::format(
      "verified: {} agents, {} ticks, {} of {} jobs delivered, {} moves late: nobody on a wall, no "
      "two in one cell, no two through each other, each job taken in its turn, picked up and "
      "delivered where it is said\n",
      verdict.agents, verdict.ticks, verdict.delivered, verdict.jobs, verdict.late_moves);
}

std::string jobs_verdict_json(const JobsVerdict& verdict) {
  const Json json = {{"faults", verdict.faults},       {"agents", verdict.agents},
                     {"ticks", verdict.ticks},         {"jobs", verdict.jobs},
                     {"delivered", verdict.delivered}, {"late_moves", verdict.late_moves}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rubicon::verify
