#include "src/exchange/urdf/import_machine.hpp"

#include <utility>

#include "src/exchange/urdf/fault.hpp"
#include "src/exchange/urdf/machine.hpp"
#include "src/exchange/urdf/read_xml.hpp"
#include "src/exchange/urdf/robot_file.hpp"
#include "src/exchange/urdf/xacro.hpp"

namespace rubicon::urdf {

std::optional<MachineImport> import_machine(const MachineTerms& terms,
                                            interpreter::SourceMap& sources,
                                            interpreter::FileId file, PackageFiles& files,
                                            interpreter::Diagnostics& diagnostics) {
  Findings findings;
  std::optional<MachineImport> result;
  try {
    Element root = read_xml(sources, file);
    if (is_xacro(root, terms.path)) {
      root = expand_xacro(root, {terms.arguments, terms.path, &sources, &files, &findings});
    }
    const Machine machine = read_machine(root, findings);
    MeshShapes meshes(files, terms.path, terms.meshes, findings);
    const std::string name = terms.path.substr(terms.path.rfind('/') + 1);
    MachineImport import;
    import.robot = robot_file(machine, {name, terms.tool}, meshes, findings);
    import.meshes = meshes.take();
    result = std::move(import);
  } catch (Fault& fault) {
    diagnostics.add(std::move(fault.diagnostic));
  }
  findings.report(diagnostics);
  return result;
}

}  // namespace rubicon::urdf
