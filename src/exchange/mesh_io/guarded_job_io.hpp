#pragma once

#include <sys/types.h>

#include "src/exchange/mesh_io/helper_job.hpp"

namespace rubicon::mesh_io {

/// What a child has open.
struct JobDescriptors {
  int input = -1;
  int output = -1;
};

/// Closes everything but these two files and /dev/null as standard input, output and error. For a
/// process that is about to run one job.
JobDescriptors keep_only(int input, int output);

/// Sets the limits of the job for this process, for good, then does it and writes a SceneMessage.
/// Ends with `helper`, the process that forked this one. Returns the exit code. The process may die
/// at any moment: nothing may depend on how.
int run_guarded_job(const HelperJob& job, const JobDescriptors& files, pid_t helper);

}  // namespace rubicon::mesh_io
