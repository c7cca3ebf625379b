#include "src/simulation/site/site_robot.hpp"

#include <algorithm>
#include <utility>

#include "src/motion/robot/frame_chain.hpp"
#include "src/simulation/site/rope_volume.hpp"

namespace rubicon::site {

namespace {

/// The parameters of the frames between two bodies in the chain; with `tool` also those of the tool
/// frame.
std::vector<int> parameters_between(const robot::RobotModel& model, int a, int b, bool tool) {
  robot::RelativeChain chain = robot::relative_chain(model, a, b);
  std::vector<const robot::FrameElement*>& elements = chain.up;
  elements.insert(elements.end(), chain.down.begin(), chain.down.end());
  if (tool) {
    for (const robot::FrameElement& each : model.tool_frame) elements.push_back(&each);
  }
  return robot::parameters_of(model, elements);
}

/// Where the frame of a body is that moves as the part does: of a rope there are two.
std::vector<int> carriers(const robot::RobotModel& model, int part) {
  const robot::Body& body = model.bodies[static_cast<std::size_t>(part)];
  if (!body.rope) return {part};
  return {body.rope->from, body.parent};
}

/// The parameters that move one part against the other.
std::vector<int> parameters_between_parts(const robot::RobotModel& model, int a, int b, bool tool) {
  std::vector<int> parameters;
  for (const int first : carriers(model, a)) {
    for (const int second : carriers(model, b)) {
      const std::vector<int> some = parameters_between(model, first, second, tool);
      parameters.insert(parameters.end(), some.begin(), some.end());
    }
  }
  std::sort(parameters.begin(), parameters.end());
  parameters.erase(std::unique(parameters.begin(), parameters.end()), parameters.end());
  return parameters;
}

/// Whether no parameter moves the body (of a rope: either end).
bool is_fixed_body(const robot::RobotModel& model, int body) {
  const std::vector<int> frames = carriers(model, body);
  return std::all_of(frames.begin(), frames.end(), [&](int frame) {
    return robot::parameters_of(model, robot::elements_to_body(model, frame)).empty();
  });
}

/// Whether the rope is fixed to the body.
bool is_end_of(const robot::RobotModel& model, int rope, int body) {
  const robot::Body& each = model.bodies[static_cast<std::size_t>(rope)];
  return each.rope && (each.rope->from == body || each.parent == body);
}

bool meant_to_touch(const robot::RobotModel& model, int a, int b) {
  const auto& bodies = model.bodies;
  if (bodies[static_cast<std::size_t>(a)].parent == b ||
      bodies[static_cast<std::size_t>(b)].parent == a) {
    return true;
  }
  if (is_end_of(model, a, b) || is_end_of(model, b, a)) return true;
  return std::any_of(model.touching.begin(), model.touching.end(), [&](const auto& pair) {
    return pair == std::pair(a, b) || pair == std::pair(b, a);
  });
}

}  // namespace

bool OwnPair::moves(std::span<const double> q0, std::span<const double> q1) const {
  return std::any_of(parameters.begin(), parameters.end(), [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    return q0[i] != q1[i];
  });
}

SiteRobot make_site_robot(std::string name, std::shared_ptr<const robot::RobotModel> model,
                          robot::Mounting mounting, PreparedBodies prepared) {
  SiteRobot site;
  site.name = std::move(name);
  site.model = std::move(model);
  site.mounting = std::move(mounting);
  site.bodies = std::move(prepared.bodies);
  const robot::RobotModel& m = *site.model;
  site.buffers = std::move(prepared.buffers);
  if (site.bodies.empty()) {
    for (const robot::Body& body : m.bodies) {
      site.bodies.push_back(body.shapes.empty() ? nullptr : collision::prepare(body.shapes));
    }
  }
  for (const robot::Body& body : m.bodies) site.body_names.push_back(site.name + "." + body.name);
  const int count = static_cast<int>(m.bodies.size());
  if (site.buffers.empty()) {
    for (int part = 0; part < count; ++part) {
      const robot::Body& body = m.bodies[static_cast<std::size_t>(part)];
      if (body.buffer <= 0 || body.shapes.empty()) continue;
      site.buffers.push_back({part, collision::prepare(body.shapes, body.buffer)});
    }
  }
  for (const Buffer& buffer : site.buffers) {
    site.buffer_names.push_back("the buffer of " +
                                site.body_names[static_cast<std::size_t>(buffer.body)]);
  }
  for (int part = 0; part < count; ++part) {
    const robot::Body& body = m.bodies[static_cast<std::size_t>(part)];
    if (!body.rope) continue;
    site.ropes.push_back(part);
    if (!site.rope_bodies) site.rope_bodies = std::make_shared<RopeBodies>();
    site.rope_bodies->add(part, robot::RopePath(m, site.mounting, part),
                          parameters_between(m, body.rope->from, body.parent, false));
  }
  for (int body = 0; body < count; ++body) site.fixed_bodies.push_back(is_fixed_body(m, body));
  const auto is_there = [&](int part) {
    return site.bodies[static_cast<std::size_t>(part)] != nullptr || site.is_rope(part);
  };
  for (int a = 0; a < count; ++a) {
    if (!is_there(a)) continue;
    for (int b = a + 1; b < count; ++b) {
      if (!is_there(b) || meant_to_touch(m, a, b)) continue;
      site.own_pairs.push_back({a, b, parameters_between_parts(m, a, b, false)});
    }
    if (a != m.tool_body && !is_end_of(m, a, m.tool_body)) {
      site.load_pairs.push_back({a, 0, parameters_between_parts(m, a, m.tool_body, true)});
    }
  }
  return site;
}

}  // namespace rubicon::site
