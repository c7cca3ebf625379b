#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rubicon::mesh_io {

/// What a reader takes from the begin of a PLY file to see that its header ends, in bytes.
inline constexpr std::uint64_t kPlyHead = 1'000'000;

/// What is wrong with the header of a PLY file of `size` bytes that begins with `head`; empty when
/// nothing is. The library looks for the end of a header without end, and for as many elements as
/// are announced: both are seen here at once.
std::string ply_fault(std::string_view head, std::uint64_t size);

}  // namespace rubicon::mesh_io
