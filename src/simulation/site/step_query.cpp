#include "src/simulation/site/step_query.hpp"

#include "src/motion/robot/body_motion.hpp"
#include "src/simulation/site/attached_motion.hpp"

namespace rubicon::site {

std::vector<geometry::Motion> part_motions(const SiteRobot& robot, const std::optional<Load>& load,
                                           std::span<const double> q_from,
                                           std::span<const double> q_to) {
  std::vector<geometry::Motion> motions =
      robot::step_motions(*robot.model, robot.mounting, q_from, q_to);
  if (load && load->body) motions.back() = attached_motion(motions.back(), load->X_TO);
  return motions;
}

StepQuery::StepQuery(const SiteRobot& robot, const std::optional<Load>& load,
                     std::span<const double> q_from, std::span<const double> q_to,
                     double contact_tolerance, bool against_world)
    : robot_(robot),
      load_(load),
      load_part_(static_cast<int>(robot.bodies.size())),
      against_world_(against_world),
      motions_(part_motions(robot, load, q_from, q_to)),
      moves_(robot.bodies.size() + 1, false),
      item_of_(robot.bodies.size() + 1, -1) {
  query_.contact_tolerance = contact_tolerance;
  for (int part = 0; part <= load_part_; ++part) {
    if (!body(part)) continue;
    const auto i = static_cast<std::size_t>(part);
    moves_[i] = motions_[i].moves();
    if (moves_[i]) item(part);
  }
  add_pairs(robot.own_pairs, false, q_from, q_to);
  if (body(load_part_)) add_pairs(robot.load_pairs, true, q_from, q_to);
}

const collision::Body* StepQuery::body(int part) const {
  if (part < load_part_) return robot_.bodies[static_cast<std::size_t>(part)].get();
  return load_ ? load_->body.get() : nullptr;
}

int StepQuery::item(int part) {
  const auto i = static_cast<std::size_t>(part);
  if (item_of_[i] < 0) {
    item_of_[i] = static_cast<int>(query_.items.size());
    query_.items.push_back({{body(part), motions_[i]}, moves_[i] && against_world_});
    part_of_.push_back(part);
  }
  return item_of_[i];
}

void StepQuery::add_pairs(const std::vector<OwnPair>& pairs, bool of_load,
                          std::span<const double> q_from, std::span<const double> q_to) {
  for (const OwnPair& pair : pairs) {
    if (!pair.moves(q_from, q_to)) continue;
    const int first = item(pair.first);
    const int second = item(of_load ? load_part_ : pair.second);
    query_.pairs.emplace_back(of_load ? second : first, of_load ? first : second);
  }
}

collision::SweptQuery StepQuery::against_others() const {
  collision::SweptQuery others;
  others.contact_tolerance = query_.contact_tolerance;
  for (std::size_t i = 0; i < query_.items.size(); ++i) {
    if (!moves(part_of_[i])) continue;
    others.items.push_back(query_.items[i]);
    others.items.back().against_world = true;
  }
  return others;
}

int StepQuery::part_of_mover(int item) const {
  for (const int part : part_of_) {
    if (moves(part) && item-- == 0) return part;
  }
  return load_part_;
}

}  // namespace rubicon::site
