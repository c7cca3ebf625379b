#pragma once

#include <optional>
#include <string>

namespace rubicon::cluster {

/// Messages between the ranks of a job, numbered from 0. Between two ranks they arrive in the order
/// in which they were sent. One thread uses it.
class Channel {
 public:
  virtual ~Channel() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// Does not wait until it arrives.
  virtual void send(int to, std::string message) = 0;
  struct Received {
    int from = 0;
    std::string message;
  };
  /// Does not wait; nothing: nothing is there.
  virtual std::optional<Received> receive() = 0;
  /// What others need to know to see whether this rank is still there.
  virtual std::string identity() const = 0;
  /// Whether the rank with this identity is known to have ended; false where nobody can tell.
  virtual bool is_gone(const std::string& identity) const = 0;
  /// s, of a clock that only goes forward.
  virtual double now() const = 0;
  /// Lets some time pass, well below 1 ms.
  virtual void pause() = 0;
};

}  // namespace rubicon::cluster
