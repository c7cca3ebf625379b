#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "src/simulation/trace/trace_sink.hpp"

namespace rubicon::taskplan {

/// Holds back the lines of a trace as long as the run may go back to before them.
class TraceBuffer : public trace::TraceSink {
 public:
  using Mark = std::uint64_t;

  /// `out` must outlive it.
  explicit TraceBuffer(trace::TraceSink& out) : out_(out) {}

  /// The task that all later lines belong to.
  void set_owner(int task) { owner_ = task; }
  void line(std::string_view text) override {
    lines_.push_back({owner_, kept_, std::string(text)});
  }

  /// Only the sink behind it begins again.
  void restart() override {}

  Mark mark() const { return written_ + lines_.size(); }

  /// Takes out the lines since `mark`, but for those that are kept for good.
  void forget_since(Mark mark);

  /// Takes out the lines since `mark`, but puts those of `owner` back at the end, for good.
  void keep_only(Mark mark, int owner);
  /// Drops what is kept of an owner since the mark.
  void drop_kept(Mark mark, int owner);

  /// The lines of `owner` that are kept for good and not written yet.
  std::vector<std::string> kept_of(int owner) const;

  /// Whether the lines from now on are for good.
  void set_kept(bool kept) { kept_ = kept; }

  /// Writes the lines before `mark`: nobody will go back to before it.
  void release_before(Mark mark);

 private:
  struct Line {
    int owner = -1;
    bool kept = false;
    std::string text;
  };
  trace::TraceSink& out_;
  std::deque<Line> lines_;
  Mark written_ = 0;
  int owner_ = -1;
  bool kept_ = false;
};

}  // namespace rubicon::taskplan
