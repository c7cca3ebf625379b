#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

#include "src/exchange/mesh_io/guarded_file_io.hpp"
#include "src/exchange/mesh_io/helper_job.hpp"

namespace rubicon::mesh_io {

/// A job for the helper, and how long and how much to listen to it.
struct HelperQuery {
  HelperJob job;
  int input = -1;  ///< open file with what the job reads; stays the caller's
  std::chrono::milliseconds time_limit{5000};
  std::size_t output_limit = 0;  ///< bytes; a child that writes more is stopped
};

/// How the child of a job ended, and what it wrote until then.
struct HelperResult {
  enum class End {
    kExited,
    kSignalled,
    kTimedOut,
    kTooMuchOutput,
    kNotStarted,  ///< the helper program cannot be started
    kNoAnswer     ///< the helper program itself ended, or it is another program
  };
  End end = End::kNotStarted;
  int code = 0;  ///< exit code, signal number, or errno, by `end`; of the helper for kNoAnswer
  std::string output;
};

/// The helper program, started at the first job and kept: it forks a guarded child for each job,
/// which costs far less than a start. It has an environment of its own and none of our open files
/// but one end of a socket; it ends when the other end is closed, by us or by our own end, however
/// that comes. Any number of threads may run jobs at once.
class HelperProcess {
 public:
  explicit HelperProcess(std::string program);
  HelperProcess(const HelperProcess&) = delete;
  HelperProcess& operator=(const HelperProcess&) = delete;
  ~HelperProcess();

  const std::string& program() const { return program_; }

  /// Runs one job. Returns soon after the time limit whatever the child does, and nothing of the
  /// child is left behind then. A helper that has died meanwhile is started again.
  HelperResult run(const HelperQuery& query);

 private:
  struct JobFiles;

  int send(const HelperJob& job, const JobFiles& files, pid_t& process);
  int start();
  int stop(pid_t process, bool at_once);
  int stop_held(bool at_once);

  std::string program_;
  std::mutex mutex_;  // guards what follows
  FileDescriptor socket_;
  pid_t process_ = -1;
};

}  // namespace rubicon::mesh_io
