// The file rubicon-ompl.so, which alone knows OMPL: see ompl_plugin.hpp.
#include "src/motion/ompl_bridge/ompl_plugin.hpp"

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/samplers/informed/RejectionInfSampler.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/config.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/est/ProjEST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/rlrt/BiRLRT.h>
#include <ompl/geometric/planners/rlrt/RLRT.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/LBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTXstatic.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/SORRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/sst/SST.h>
#include <ompl/geometric/planners/stride/STRIDE.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

namespace rubicon::ompl_bridge {

namespace {

namespace ob = ::ompl::base;
namespace og = ::ompl::geometric;

/// A planner that was told to stop may ask so many times more, and for so many tests more, before
/// it is stopped by force.
constexpr std::size_t kPatience = 1'000'000;
constexpr std::size_t kLateTests = 20'000;
/// A planner that goes round so many times without a test and without another node is done: it has
/// come to no end of its own.
constexpr int kIdleRounds = 1000;
constexpr int kIdleDraws = 100'000;
/// Of an informed sampler that rejects: then it takes what it has.
constexpr unsigned kRejections = 1000;
/// Where a leg is refused, its free beginning is looked for in so many halves.
constexpr int kHalves = 6;

/// Thrown through a planner that does not stop.
struct Stopped {};

/// What is counted of one plan.
class Budget {
 public:
  Budget(Question& question, double nodes) : question_(question), nodes_(nodes) {}

  bool over() const { return question_.spent() || full() || idle(); }
  bool full() const { return static_cast<double>(most_) >= nodes_; }
  bool idle() const { return idle_rounds_ >= kIdleRounds || idle_draws_ >= kIdleDraws; }

  bool next_round() {
    if (!idle()) ++idle_rounds_;
    return over();
  }
  /// Each time that the planner asks for anything.
  void asks() {
    if (over() && !ended_ && ++late_ > kPatience) throw Stopped();
  }
  void tests() {
    asks();
    if (over() && !ended_ && ++late_tests_ > kLateTests) throw Stopped();
    works();
  }
  void draws() {
    asks();
    if (!idle()) ++idle_draws_;
  }
  void keeps(int more) {
    kept_ += more;
    if (kept_ <= most_) return;
    most_ = kept_;
    works();
  }
  /// The planner is done: what follows only reads.
  void end() { ended_ = true; }

 private:
  void works() {
    if (idle()) return;
    idle_rounds_ = 0;
    idle_draws_ = 0;
  }

  Question& question_;
  double nodes_;
  int idle_rounds_ = 0;
  int idle_draws_ = 0;
  long kept_ = 0;
  long most_ = 0;
  std::size_t late_ = 0;
  std::size_t late_tests_ = 0;
  bool ended_ = false;
};

/// One or two coordinates as they are: that of OMPL 1.5 stops the process where Eigen's assertions
/// are on.
class PlainProjection : public ob::ProjectionEvaluator {
 public:
  explicit PlainProjection(const ob::StateSpace* space) : ob::ProjectionEvaluator(space) {}
  unsigned getDimension() const override { return space_->getDimension(); }
  void project(const ob::State* state, Eigen::Ref<Eigen::VectorXd> projection) const override {
    for (unsigned i = 0; i < getDimension(); ++i) {
      projection[i] = state->as<ob::RealVectorStateSpace::StateType>()->values[i];
    }
  }
};

/// The configurations, each coordinate times its weight, so that distances are Euclidean; but those
/// of a vehicle that steers are lengths of its ways.
class WeightedSpace : public ob::RealVectorStateSpace {
 public:
  /// OMPL keeps spaces, and frees states of them when the program ends: so they share the budget.
  WeightedSpace(Question& question, std::shared_ptr<Budget> budget)
      : ob::RealVectorStateSpace(static_cast<unsigned>(question.size())),
        question_(question),
        budget_(std::move(budget)) {
    ob::RealVectorBounds bounds(dimension_);
    for (unsigned i = 0; i < dimension_; ++i) {
      bounds.setLow(i, question.lower(i) * question.weight(i));
      bounds.setHigh(i, question.upper(i) * question.weight(i));
      any_cyclic_ = any_cyclic_ || question.cyclic(i);
    }
    setBounds(bounds);
    setName("rubicon");
  }

  static double& value(ob::State* state, unsigned i) { return state->as<StateType>()->values[i]; }
  static double value(const ob::State* state, unsigned i) {
    return state->as<StateType>()->values[i];
  }

  /// Whether straight lines are the shortest ways, and all within the ranges may be taken.
  bool plain() const { return !any_cyclic_ && !question_.keeps() && !question_.steers(); }

  Point point(const ob::State* state) const {
    Point result(dimension_);
    for (unsigned i = 0; i < dimension_; ++i) {
      result[i] = value(state, i) / question_.weight(i);
      if (!question_.cyclic(i)) {
        result[i] = std::clamp(result[i], question_.lower(i), question_.upper(i));
      }
    }
    return result;
  }
  void set(ob::State* state, const Point& point) const {
    for (unsigned i = 0; i < dimension_; ++i) value(state, i) = point[i] * question_.weight(i);
  }
  void fit(ob::State* state) const {
    budget_->draws();
    enforceBounds(state);
    if (!question_.keeps()) return;
    Point moved = point(state);
    question_.fit(moved);
    set(state, moved);
  }

  double distance(const ob::State* a, const ob::State* b) const override {
    budget_->asks();
    if (question_.steers()) return question_.distance(point(a), point(b));
    double sum = 0;
    for (unsigned i = 0; i < dimension_; ++i) {
      const double off = offset(a, b, i);
      sum += off * off;
    }
    return std::sqrt(sum);
  }
  void interpolate(const ob::State* a, const ob::State* b, const double t,
                   ob::State* state) const override {
    if (question_.steers()) {
      set(state, question_.partway(point(a), point(b), t));
      wrap(state);
      return;
    }
    for (unsigned i = 0; i < dimension_; ++i) {
      const double off = offset(a, b, i);
      value(state, i) = value(a, i) + off * t;
    }
    wrap(state);
  }
  void enforceBounds(ob::State* state) const override {
    wrap(state);
    ob::RealVectorStateSpace::enforceBounds(state);
  }
  double getMaximumExtent() const override {
    double sum = 0;
    for (unsigned i = 0; i < dimension_; ++i) {
      const double range = getBounds().high[i] - getBounds().low[i];
      const double farthest = question_.cyclic(i) ? range / 2 : range;
      sum += farthest * farthest;
    }
    return std::sqrt(sum);
  }
  void registerProjections() override {
    if (dimension_ > 2) {
      ob::RealVectorStateSpace::registerProjections();
    } else {
      registerDefaultProjection(std::make_shared<PlainProjection>(this));
    }
  }
  ob::StateSamplerPtr allocDefaultStateSampler() const override;
  ob::State* allocState() const override {
    budget_->keeps(1);
    budget_->asks();
    return ob::RealVectorStateSpace::allocState();
  }
  void freeState(ob::State* state) const override {
    budget_->keeps(-1);
    ob::RealVectorStateSpace::freeState(state);
  }

 private:
  double offset(const ob::State* a, const ob::State* b, unsigned i) const {
    const double off = value(b, i) - value(a, i);
    if (!question_.cyclic(i)) return off;
    return std::remainder(off, 360 * question_.weight(i));
  }
  void wrap(ob::State* state) const {
    if (!any_cyclic_) return;
    for (unsigned i = 0; i < dimension_; ++i) {
      if (!question_.cyclic(i)) continue;
      value(state, i) = std::remainder(value(state, i), 360 * question_.weight(i));
    }
  }

  Question& question_;
  std::shared_ptr<Budget> budget_;
  bool any_cyclic_ = false;
};

class FittedSampler : public ob::RealVectorStateSampler {
 public:
  explicit FittedSampler(const WeightedSpace* space)
      : ob::RealVectorStateSampler(space), weighted_(*space) {}

  void sampleUniform(ob::State* state) override {
    ob::RealVectorStateSampler::sampleUniform(state);
    weighted_.fit(state);
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, const double distance) override {
    ob::RealVectorStateSampler::sampleUniformNear(state, near, distance);
    weighted_.fit(state);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, const double spread) override {
    ob::RealVectorStateSampler::sampleGaussian(state, mean, spread);
    weighted_.fit(state);
  }

 private:
  const WeightedSpace& weighted_;
};

ob::StateSamplerPtr WeightedSpace::allocDefaultStateSampler() const {
  return std::make_shared<FittedSampler>(this);
}

class Standing : public ob::StateValidityChecker {
 public:
  Standing(const ob::SpaceInformationPtr& si, const WeightedSpace& space, Question& question,
           Budget& budget)
      : ob::StateValidityChecker(si), space_(space), question_(question), budget_(budget) {}

  bool isValid(const ob::State* state) const override {
    budget_.tests();
    return !budget_.over() && question_.stands(space_.point(state));
  }

 private:
  const WeightedSpace& space_;
  Question& question_;
  Budget& budget_;
};

/// Legs are tested over their whole swept volume.
class FreeLegs : public ob::MotionValidator {
 public:
  FreeLegs(const ob::SpaceInformationPtr& si, const WeightedSpace& space, Question& question,
           Budget& budget)
      : ob::MotionValidator(si), space_(space), question_(question), budget_(budget) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    budget_.tests();
    if (budget_.over()) return false;
    const Point a = space_.point(from);
    const Point b = space_.point(to);
    return question_.leg_is_free(a, b) && (question_.symmetric() || question_.leg_is_free(b, a));
  }
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_free) const override {
    if (checkMotion(from, to)) return true;
    double free = 0;
    double refused = 1;
    ob::State* const middle = si_->allocState();
    for (int i = 0; i < kHalves; ++i) {
      const double t = (free + refused) / 2;
      space_.interpolate(from, to, t, middle);
      (checkMotion(from, middle) ? free : refused) = t;
    }
    si_->freeState(middle);
    last_free.second = free;
    if (last_free.first != nullptr) space_.interpolate(from, to, free, last_free.first);
    return false;
  }

 private:
  const WeightedSpace& space_;
  Question& question_;
  Budget& budget_;
};

/// The informed sampler of OMPL draws from an ellipsoid, which is right only in a plain space.
class Length : public ob::PathLengthOptimizationObjective {
 public:
  Length(const ob::SpaceInformationPtr& si, bool plain, bool any_length)
      : ob::PathLengthOptimizationObjective(si), plain_(plain) {
    if (any_length) setCostThreshold(infiniteCost());
  }
  ob::InformedSamplerPtr allocInformedStateSampler(const ob::ProblemDefinitionPtr& problem,
                                                   unsigned most_calls) const override {
    if (plain_) {
      return ob::PathLengthOptimizationObjective::allocInformedStateSampler(problem, most_calls);
    }
    return std::make_shared<ob::RejectionInfSampler>(problem, std::min(most_calls, kRejections));
  }

 private:
  bool plain_;
};

template <typename Planner>
ob::PlannerPtr make(const ob::SpaceInformationPtr& si) {
  return std::make_shared<Planner>(si);
}

struct Named {
  const char* name;
  ob::PlannerPtr (*make)(const ob::SpaceInformationPtr& si);
};
constexpr Named kMakers[] = {
    {"ABITstar", make<og::ABITstar>},
    {"AITstar", make<og::AITstar>},
    {"BFMT", make<og::BFMT>},
    {"BITstar", make<og::BITstar>},
    {"BKPIECE1", make<og::BKPIECE1>},
    {"BiEST", make<og::BiEST>},
    {"BiRLRT", make<og::BiRLRT>},
    {"BiTRRT", make<og::BiTRRT>},
    {"EST", make<og::EST>},
    {"FMT", make<og::FMT>},
    {"InformedRRTstar", make<og::InformedRRTstar>},
    {"KPIECE1", make<og::KPIECE1>},
    {"LBKPIECE1", make<og::LBKPIECE1>},
    {"LBTRRT", make<og::LBTRRT>},
    {"LazyPRM", make<og::LazyPRM>},
    {"LazyPRMstar", make<og::LazyPRMstar>},
    {"LazyRRT", make<og::LazyRRT>},
    {"PDST", make<og::PDST>},
    {"ProjEST", make<og::ProjEST>},
    {"RLRT", make<og::RLRT>},
    {"RRT", make<og::RRT>},
    {"RRTConnect", make<og::RRTConnect>},
    {"RRTXstatic", make<og::RRTXstatic>},
    {"RRTsharp", make<og::RRTsharp>},
    {"RRTstar", make<og::RRTstar>},
    {"SBL", make<og::SBL>},
    {"SORRTstar", make<og::SORRTstar>},
    {"SST", make<og::SST>},
    {"STRIDE", make<og::STRIDE>},
    {"TRRT", make<og::TRRT>},
};

ob::PlannerPtr make_planner(const std::string& name, const ob::SpaceInformationPtr& si) {
  for (const Named& each : kMakers) {
    if (each.name == name) return each.make(si);
  }
  return nullptr;
}

std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

/// All generators that are made from now on follow from the seed.
void seed_all(double seed) {
  constexpr double kSeeds = 4294967291.0;  // fewer than 2^32; 0 is none
  ::ompl::msg::setLogLevel(::ompl::msg::LOG_NONE);
  ::ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(std::fmod(seed, kSeeds)) + 1);
}

class Planning {
 public:
  Planning(Question& question, const Asked& asked)
      : asked_(asked),
        shared_budget_(std::make_shared<Budget>(question, asked.nodes)),
        budget_(*shared_budget_),
        space_(std::make_shared<WeightedSpace>(question, shared_budget_)),
        si_(std::make_shared<ob::SpaceInformation>(space_)),
        problem_(std::make_shared<ob::ProblemDefinition>(si_)) {
    si_->setStateValidityChecker(std::make_shared<Standing>(si_, *space_, question, budget_));
    si_->setMotionValidator(std::make_shared<FreeLegs>(si_, *space_, question, budget_));
    si_->setup();
    ob::ScopedState<> start(space_);
    ob::ScopedState<> goal(space_);
    space_->set(start.get(), asked.start);
    space_->set(goal.get(), asked.goal);
    problem_->setStartAndGoalStates(start, goal);
    // These would go on with a roadmap of thousands, at a search of it for each node.
    const bool first_way = asked.planner == "LazyPRM" || asked.planner == "LazyPRMstar";
    problem_->setOptimizationObjective(std::make_shared<Length>(si_, space_->plain(), first_way));
    planner_ = make_planner(asked.planner, si_);
  }

  Answer run() {
    Answer answer;
    if (!planner_) return answer;
    if (!set_parameters(answer)) return answer;
    planner_->setProblemDefinition(problem_);
    planner_->setup();
    bool came_to_end = true;
    try {
      planner_->solve(ob::PlannerTerminationCondition([this] { return budget_.next_round(); }));
    } catch (const Stopped&) {
      came_to_end = false;
    }
    answer.out_of_nodes = budget_.full();
    const bool over = budget_.over();
    budget_.end();
    if (problem_->hasExactSolution()) answer.way = way();
    if (came_to_end) read_graph(answer);
    if (answer.way.empty() && (!over || budget_.idle())) {
      answer.cause = asked_.planner + " of OMPL ended without a way";
    }
    return answer;
  }

 private:
  bool set_parameters(Answer& answer) {
    if (asked_.range > 0 && planner_->params().hasParam("range")) set("range", asked_.range);
    for (const auto& [name, value] : asked_.settings) {
      if (set(name, value)) continue;
      answer.cause = asked_.planner + " of OMPL does not take the value of " + name;
      return false;
    }
    return true;
  }
  bool set(const std::string& name, double value) {
    // In fixed notation: counts and truths are read as whole numbers.
    std::array<char, 400> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    return planner_->params().setParam(name, std::string(text.data(), end.ptr));
  }

  std::vector<Point> way() const {
    const auto path = std::dynamic_pointer_cast<og::PathGeometric>(problem_->getSolutionPath());
    if (!path || path->getStateCount() == 0) return {};
    std::vector<Point> points{asked_.start};
    for (const ob::State* state : path->getStates()) points.push_back(space_->point(state));
    // Its ends are start and goal but for the rounding of weights.
    points.erase(points.begin() + 1);
    if (points.size() > 1) points.pop_back();
    points.push_back(asked_.goal);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  }

  void read_graph(Answer& answer) const {
    ob::PlannerData data(si_);
    planner_->getPlannerData(data);
    answer.nodes = data.numVertices();
    if (!asked_.tells_tree) return;
    for (unsigned from = 0; from < data.numVertices(); ++from) {
      std::vector<unsigned> ends;
      data.getEdges(from, ends);
      std::sort(ends.begin(), ends.end());
      for (const unsigned to : ends) {
        answer.tree.emplace_back(space_->point(data.getVertex(from).getState()),
                                 space_->point(data.getVertex(to).getState()));
      }
    }
  }

  const Asked& asked_;
  std::shared_ptr<Budget> shared_budget_;
  Budget& budget_;
  std::shared_ptr<WeightedSpace> space_;
  ob::SpaceInformationPtr si_;
  ob::ProblemDefinitionPtr problem_;
  ob::PlannerPtr planner_;
};

Answer plan(Question& question, const Asked& asked) {
  const std::lock_guard<std::mutex> lock(one_at_a_time());
  try {
    seed_all(asked.seed);
    return Planning(question, asked).run();
  } catch (const std::exception& error) {
    Answer answer;
    answer.cause = asked.planner + " of OMPL: " + error.what();
    return answer;
  }
}

std::vector<std::string> parameters(const std::string& planner) {
  const std::lock_guard<std::mutex> lock(one_at_a_time());
  ::ompl::msg::setLogLevel(::ompl::msg::LOG_NONE);
  const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(0, 1);
  const auto si = std::make_shared<ob::SpaceInformation>(space);
  std::vector<std::string> names;
  const ob::PlannerPtr made = make_planner(planner, si);
  if (made) made->params().getParamNames(names);
  return names;
}

}  // namespace

extern "C" const OmplPlugin* rubicon_ompl(int version) {
  static const OmplPlugin plugin = {plan, parameters, OMPL_VERSION};
  return version == kOmplPluginVersion ? &plugin : nullptr;
}

}  // namespace rubicon::ompl_bridge
