#include "src/results/gltf/looks.hpp"

#include <fmt/format.h>

#include <array>
#include <map>

#include "src/results/palette/colour.hpp"
#include "src/results/palette/palette.hpp"

namespace rubicon::gltf {

namespace {

using palette::kDrawing;
using palette::linear_rgb;

/// How bodies of one machine differ: share of white (positive) or black, as on the page
/// (viewer/src/view/looks.ts).
constexpr std::array<double, 6> kShades = {0, 0.22, -0.14, 0.36, -0.24, 0.12};

/// Of what stands for room: what is inside is seen through it.
constexpr double kEnvelopeOpacity = 0.22;

std::size_t machine_colour(std::size_t robot) { return robot % kDrawing.machines.size(); }

}  // namespace

std::string kind_of(const std::string& name) {
  const std::size_t point = name.rfind('.');
  const std::string last = point == std::string::npos ? name : name.substr(point + 1);
  const std::size_t end = last.find_last_not_of("0123456789_");
  return end == std::string::npos ? name : last.substr(0, end + 1);
}

Looks::Looks(const std::vector<trace::HeaderComponent>& components) {
  std::map<std::string, std::size_t> numbers;
  for (const trace::HeaderComponent& component : components) {
    kinds_.push_back(numbers.try_emplace(kind_of(component.name), numbers.size()).first->second);
  }
}

Look Looks::ground() const { return {"ground", linear_rgb(kDrawing.ground)}; }

Look Looks::body(std::size_t robot, std::size_t body) const {
  const std::size_t colour = machine_colour(robot);
  const std::size_t shade = body % kShades.size();
  return {fmt::format("machine {}, shade {}", colour + 1, shade + 1),
          linear_rgb(kDrawing.machines[colour], kShades[shade])};
}

Look Looks::envelope(std::size_t robot) const {
  const std::size_t colour = machine_colour(robot);
  return {fmt::format("room of machine {}", colour + 1), linear_rgb(kDrawing.machines[colour]),
          kEnvelopeOpacity};
}

Look Looks::rope() const { return {"rope", linear_rgb(kDrawing.rope)}; }
Look Looks::waiting() const { return {"waiting", linear_rgb(kDrawing.waiting)}; }
Look Looks::carried() const { return {"carried", linear_rgb(kDrawing.carried)}; }

Look Looks::placed(std::size_t component) const {
  const std::size_t colour = kinds_[component] % kDrawing.components.size();
  return {fmt::format("placed, kind {}", colour + 1), linear_rgb(kDrawing.components[colour])};
}

Look Looks::moving(bool people) const {
  return people ? Look{"people", linear_rgb(kDrawing.zone)}
                : Look{"moving", linear_rgb(kDrawing.fixture, -0.35)};
}

Look Looks::zone() const { return {"zone", linear_rgb(kDrawing.zone), kEnvelopeOpacity}; }

}  // namespace rubicon::gltf
