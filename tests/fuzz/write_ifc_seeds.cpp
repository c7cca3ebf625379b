#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/unit/mesh_io/ifc_shape_cases.hpp"

/// write_ifc_seeds FOLDER: the shapes that unit tests know by hand, a file each, for the fuzzer.
int main(int argc, char** argv) {
  using namespace rubicon::mesh_io::testing;
  if (argc != 2) {
    std::cerr << "usage: write_ifc_seeds FOLDER\n";
    return 2;
  }
  int number = 0;
  for (const ShapeCase& shape : shape_cases()) {
    std::ofstream file(std::filesystem::path(argv[1]) / ("shape_" + std::to_string(number++)));
    file << ifc_of(shape.records, shape.openings);
    if (!file.flush()) {
      std::cerr << "cannot write into " << argv[1] << '\n';
      return 1;
    }
  }
}
