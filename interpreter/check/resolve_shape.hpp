#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>

#include "interpreter/check/resolve_formula.hpp"
#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/file_provider.hpp"
#include "interpreter/syntax/syntax.hpp"
#include "src/motion/geometry/shape.hpp"

namespace rubicon::interpreter {

/// Range of a mesh's `scale`: beyond it the unit is wrong, and doubles lose the contact tolerance.
inline constexpr double kMinScale = 1e-6;
inline constexpr double kMaxScale = 1e6;

/// Turns the shapes of one file into solids in metres. A mesh that is named several times is read
/// once.
class ShapeResolver {
 public:
  /// `naming_file` is the path of the robot or plan; its meshes stay inside its folder. `names`
  /// knows the constants that `at` frames may use.
  ShapeResolver(std::string naming_file, FileProvider& files, FormulaNames& names,
                Diagnostics& diagnostics);

  /// The shape in the frame of its body, component or site. Nothing after reporting F02-F12 at
  /// their places.
  std::optional<geometry::Shape> resolve(const syntax::Shape& shape);

 private:
  using MeshResult = std::variant<std::shared_ptr<const geometry::TriangleMesh>, FileFailure>;

  std::optional<geometry::Solid> resolve_solid(const syntax::Shape& shape);
  std::optional<geometry::Solid> resolve_box(const syntax::Shape& shape);
  std::optional<geometry::Solid> resolve_cylinder(const syntax::Shape& shape);
  std::optional<geometry::Solid> resolve_sphere(const syntax::Shape& shape);
  std::optional<geometry::Solid> resolve_capsule(const syntax::Shape& shape);
  std::optional<geometry::Solid> resolve_prism(const syntax::Shape& shape);
  std::optional<geometry::Solid> resolve_mesh(const syntax::Shape& shape);
  std::optional<MeshRequest> mesh_request(const syntax::Shape& shape);
  bool check_options(const syntax::Shape& shape, MeshRequest& request);
  const MeshResult& read(const MeshRequest& request);

  bool check_lengths(const syntax::Shape& shape);
  bool check_count(const syntax::Shape& shape, std::size_t wanted, const char* form);
  bool check_positive(const syntax::Number& number, const char* what);
  bool check_ascending(const syntax::Number& low, const syntax::Number& high, const char* what);

  std::string naming_file_;
  FileProvider& files_;
  FormulaNames& names_;
  Diagnostics& diagnostics_;
  std::map<std::string, MeshResult> meshes_;
  std::set<std::string> open_meshes_;  ///< paths of which it was said
};

}  // namespace rubicon::interpreter
