#pragma once

#include <algorithm>
#include <thread>

namespace rubicon::cli {

/// What `--jobs` asked for; of 0 as many as there are processors.
inline int thread_count(int jobs) {
  return jobs > 0 ? jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace rubicon::cli
