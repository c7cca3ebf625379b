#pragma once

#include <cstdint>

namespace rubicon::mesh_io {

/// After how long the child that reads a file is held to hang, and is ended. What honest files need
/// is counted while they are read (steps of shapes, triangles, nodes, corners of polygons); this is
/// for faults of the libraries, which cannot be counted. It is far beyond what any file takes that
/// keeps to the counts (measured: 25 MB/s for IFC, 80 to 300 for STL, OBJ and PLY), so that no
/// answer depends on how fast or how busy a machine is.
struct Watchdog {
  std::uint64_t processor_seconds = 10;        ///< processor time for any file ...
  std::uint64_t bytes_per_second = 1'000'000;  ///< ... and a second more for so many of its bytes
  /// By the clock on the wall: for a child that sleeps. So many times the processor time, for
  /// machines on which others work, and so many seconds more.
  std::uint64_t wall_per_processor = 20;
  std::uint64_t wall_seconds = 60;
};

}  // namespace rubicon::mesh_io
