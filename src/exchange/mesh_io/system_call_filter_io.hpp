#pragma once

namespace rubicon::mesh_io {

/// What a filtered process may still do with files.
enum class FileAccess {
  kOpenFilesOnly,  ///< read and write what is open
  kReadPaths       ///< open others too
};

/// From here on the kernel answers "not permitted" to every system call of this process but those
/// that reading, writing, memory and ending need: a parser that a file has taken over can start no
/// program, reach no network, signal nobody. For good; needs PR_SET_NO_NEW_PRIVS. Where the kernel
/// has no such filter nothing happens: it is a second wall behind the others.
void filter_system_calls(FileAccess access);

}  // namespace rubicon::mesh_io
