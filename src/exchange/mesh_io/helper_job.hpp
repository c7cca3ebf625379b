#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rubicon::mesh_io {

/// One piece of work for the helper program: what its guarded child is to do, and its limits. The
/// input itself comes as an open file.
struct HelperJob {
  enum class Kind {
    kMesh,  ///< parse a mesh file
    kHull   ///< the convex hull of points, as encode_points() writes them
  };
  Kind kind = Kind::kMesh;
  std::string extension;            ///< of MeshFormat, for kMesh
  bool ignore_declared_up = false;  ///< the numbers as written, for kMesh
  std::string folder;               ///< files beside the mesh must lie inside it; resolved
  std::string path;                 ///< of the mesh, resolved: names of files beside it start here
  std::uint64_t seconds = 0;        ///< processor time
  std::uint64_t bytes = 0;          ///< address space
};

/// The job as one message, and back. Not trusted: nothing when it is no job.
std::string encode_job(const HelperJob& job);
std::optional<HelperJob> decode_job(std::string_view message);

/// Most bytes of a message: two paths and some words.
inline constexpr std::size_t kLongestJob = 16'384;

/// Files that go with a job, in this order.
enum class JobFile {
  kInput,   ///< to read from
  kOutput,  ///< where the child writes a SceneMessage
  kStatus  ///< how the child ended, as a ChildEnd; closed or written to from the other side: end it
};
inline constexpr std::size_t kJobFiles = 3;

/// How the child of a job ended.
struct ChildEnd {
  std::int32_t signalled = 0;  ///< 1: by a signal
  std::int32_t code = 0;       ///< the signal's number, or the exit code
};

/// Exit codes of the helper and its children, beside 0.
inline constexpr int kExitUsage = 2;
inline constexpr int kExitOutput = 3;

}  // namespace rubicon::mesh_io
