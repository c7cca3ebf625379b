#pragma once

namespace rubicon::cluster {

/// What the loaded file gives: MPI behind plain functions. Of version 2.
struct MpiPlugin {
  int (*rank)();
  int (*size)();
  /// Keeps a copy of the bytes until they are sent; does not wait.
  void (*send)(int to, const char* bytes, long size);
  /// The size of a message that is there, from `from`; -1: none is.
  long (*look)(int* from);
  /// Takes the one that `look` found; 0: it does not come, since its sender is lost.
  int (*take)(int from, char* bytes, long size);
  /// Waits a little until all is sent; `all_there`: until all ranks have ended, too.
  void (*end)(int all_there);
};
inline constexpr int kMpiPluginVersion = 2;
/// The name of the function that begins MPI: `const MpiPlugin* rubicon_mpi_begin(int version)`,
/// null where it cannot.
inline constexpr const char* kMpiBegin = "rubicon_mpi_begin";

}  // namespace rubicon::cluster
