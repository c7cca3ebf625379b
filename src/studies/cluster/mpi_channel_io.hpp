#pragma once

#include <memory>
#include <string>
#include <variant>

#include "src/studies/cluster/channel.hpp"

namespace rubicon::cluster {

class MpiChannel : public Channel {
 public:
  /// The last that is done: rank 0 with `all_there` waits for the others, which do the same.
  virtual void end(bool all_there) = 0;
};

/// The job that this process is one of several ranks of; null: it is alone. A message where the
/// build has no MPI, or MPI cannot begin. MPI is loaded only where a launcher (mpirun, srun) has
/// started several.
std::variant<std::unique_ptr<MpiChannel>, std::string> open_mpi();

}  // namespace rubicon::cluster
