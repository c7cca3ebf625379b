#include "src/simulation/site/step_query.hpp"

#include <utility>

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
      q_from_(q_from),
      q_to_(q_to),
      load_part_(static_cast<int>(robot.bodies.size())),
      against_world_(against_world),
      motions_(part_motions(robot, load, q_from, q_to)),
      moves_(robot.bodies.size() + 1, false),
      item_of_(robot.bodies.size() + 1, -1) {
  query_.contact_tolerance = contact_tolerance;
  // A rope may be several items: room for that of most machines.
  const std::size_t items = robot.bodies.size() + robot.buffers.size() + robot.ropes.size() + 2;
  query_.items.reserve(items);
  query_.pairs.reserve(robot.own_pairs.size() + robot.load_pairs.size());
  part_of_.reserve(items);
  movers_.reserve(items);
  for (int part = 0; part <= load_part_; ++part) {
    const auto i = static_cast<std::size_t>(part);
    if (robot_.is_rope(part)) {
      const robot::Body& rope = robot_.model->bodies[i];
      moves_[i] = motions_[static_cast<std::size_t>(rope.rope->from)].moves() ||
                  motions_[static_cast<std::size_t>(rope.parent)].moves();
      if (moves_[i]) add_rope(part);
      continue;
    }
    if (!body(part)) continue;
    moves_[i] = motions_[i].moves();
    if (moves_[i]) item(part);
  }
  for (std::size_t i = 0; i < robot.buffers.size(); ++i) {
    const auto moving = static_cast<std::size_t>(robot.buffers[i].body);
    if (!moves_[moving]) continue;
    add_item(robot.buffers[i].grown.get(), motions_[moving], robot.buffer_part(i), against_world_,
             true);
  }
  add_pairs(robot.own_pairs, false);
  if (body(load_part_)) add_pairs(robot.load_pairs, true);
}

const collision::Body* StepQuery::body(int part) const {
  if (part < load_part_) return robot_.bodies[static_cast<std::size_t>(part)].get();
  return load_ ? load_->body.get() : nullptr;
}

int StepQuery::add_item(const collision::Body* body, geometry::Motion motion, int part,
                        bool against_world, bool moves) {
  const int index = static_cast<int>(query_.items.size());
  query_.items.push_back({{body, std::move(motion)}, against_world});
  part_of_.push_back(part);
  if (moves) movers_.push_back(index);
  return index;
}

int StepQuery::item(int part) {
  const auto i = static_cast<std::size_t>(part);
  if (item_of_[i] < 0) {
    item_of_[i] = add_item(body(part), motions_[i], part, moves_[i] && against_world_, moves_[i]);
  }
  return item_of_[i];
}

std::size_t StepQuery::add_rope(int part) {
  ropes_.push_back({static_cast<int>(query_.items.size()),
                    rope_volumes(robot_, part, q_from_, q_to_, motions_)});
  const bool moves = moves_[static_cast<std::size_t>(part)];
  for (const RopeVolume& volume : ropes_.back().volumes) {
    add_item(volume.body.get(), volume.motion, part, moves && against_world_, moves);
  }
  item_of_[static_cast<std::size_t>(part)] = static_cast<int>(ropes_.size()) - 1;
  return ropes_.size() - 1;
}

std::size_t StepQuery::rope_items(int part) {
  const int known = item_of_[static_cast<std::size_t>(part)];
  return known < 0 ? add_rope(part) : static_cast<std::size_t>(known);
}

/// A rope in several parts meets the other as it moves over each of them.
void StepQuery::add_pair(int first, int second) {
  const bool first_is_rope = robot_.is_rope(first);
  const bool second_is_rope = robot_.is_rope(second);
  if (!first_is_rope && !second_is_rope) {
    const int a = item(first);
    const int b = item(second);
    query_.pairs.emplace_back(a, b);
    return;
  }
  // Of two ropes the parts of the one with more of them hold for both.
  const std::size_t of_first = first_is_rope ? ropes_[rope_items(first)].volumes.size() : 0;
  const std::size_t of_second = second_is_rope ? ropes_[rope_items(second)].volumes.size() : 0;
  const bool first_leads = first_is_rope && of_first >= of_second;
  const int rope = first_leads ? first : second;
  const int other = first_leads ? second : first;
  const RopeItems& items = ropes_[rope_items(rope)];
  const auto add = [&](int rope_item, int other_item) {
    query_.pairs.emplace_back(first_leads ? rope_item : other_item,
                              first_leads ? other_item : rope_item);
  };
  if (items.volumes.size() == 1 && !robot_.is_rope(other)) {
    add(items.first, item(other));
    return;
  }
  for (std::size_t i = 0; i < items.volumes.size(); ++i) {
    const RopeVolume& volume = items.volumes[i];
    const int rope_item = items.first + static_cast<int>(i);
    const std::vector<double> q0 = robot::configuration_at(q_from_, q_to_, volume.s0);
    const std::vector<double> q1 = robot::configuration_at(q_from_, q_to_, volume.s1);
    const std::vector<geometry::Motion> motions = part_motions(robot_, load_, q0, q1);
    if (!robot_.is_rope(other)) {
      add(rope_item,
          add_item(body(other), motions[static_cast<std::size_t>(other)], other, false, false));
      continue;
    }
    RopeVolume met = rope_volumes(robot_, other, q0, q1, motions, 1).front();
    kept_.push_back(met.body);
    add(rope_item, add_item(met.body.get(), std::move(met.motion), other, false, false));
  }
}

void StepQuery::add_pairs(const std::vector<OwnPair>& pairs, bool of_load) {
  for (const OwnPair& pair : pairs) {
    if (!pair.moves(q_from_, q_to_)) continue;
    if (of_load) {
      add_pair(load_part_, pair.first);
    } else {
      add_pair(pair.first, pair.second);
    }
  }
}

collision::SweptQuery StepQuery::against_others() const {
  collision::SweptQuery others;
  others.contact_tolerance = query_.contact_tolerance;
  for (const int mover : movers_) {
    others.items.push_back(query_.items[static_cast<std::size_t>(mover)]);
    others.items.back().against_world = true;
  }
  return others;
}

collision::SweptQuery StepQuery::standing() const {
  collision::SweptQuery result;
  for (int part = 0; part <= load_part_; ++part) {
    if (robot_.is_rope(part) || !body(part) || moves(part)) continue;
    result.items.push_back({{body(part), motions_[static_cast<std::size_t>(part)]}, false});
  }
  return result;
}

std::vector<int> StepQuery::parts_of_movers() const {
  std::vector<int> parts;
  parts.reserve(movers_.size());
  for (const int mover : movers_) parts.push_back(part_of(mover));
  return parts;
}

}  // namespace rubicon::site
