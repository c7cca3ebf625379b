#pragma once

#include <string>

#include "src/exchange/building_io/element.hpp"

namespace rubicon::building_io {

/// Where a component stands in the plan, and what the plan says of it besides its shape.
struct ComponentTerms {
  Vec3 at = Vec3::Zero();  ///< of its frame {O}, m
  double turn_deg = 0;
  std::string grip;         ///< a frame behind the middle of its upper side; empty: that
  std::string mass;         ///< as the plan says it; empty: not known
  std::string mass_source;  ///< where it comes from, for a remark; empty: nothing to say
};

/// "trans(1, 2, 0.5) * rotz(90)"; empty for no transform at all.
std::string frame_text(const Vec3& p, double turn_deg);

/// The same, and "trans(0, 0, 0)" for no transform: where a plan must say one.
std::string frame_or_identity(const Vec3& p, double turn_deg);

/// A number of metres or degrees, at most 5 places behind the point.
std::string number_text(double value);

/// An element as a component of a plan, with what it is in the model as attributes.
std::string component_text(const Element& element, const ComponentTerms& terms);

/// What an element is in its model, in one line: storey, type, name, GlobalId.
std::string element_remark(const Element& element);

/// The element's own mesh as OBJ text, metres, in its frame.
std::string mesh_text(const Element& element);

/// Whether the digits of that text leave no triangle of any size.
bool is_nothing_when_written(const geometry::TriangleMesh& mesh);

}  // namespace rubicon::building_io
