#include "src/simulation/taskplan/trace_buffer.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace rubicon::taskplan {

void TraceBuffer::forget_since(Mark mark) { keep_only(mark, -1); }

void TraceBuffer::keep_only(Mark mark, int owner) {
  std::vector<Line> kept;
  std::vector<Line> owned;
  while (this->mark() > mark) {
    Line& line = lines_.back();
    if (line.kept) {
      kept.push_back(std::move(line));
    } else if (owner >= 0 && line.owner == owner) {
      owned.push_back(std::move(line));
    }
    lines_.pop_back();
  }
  for (auto line = kept.rbegin(); line != kept.rend(); ++line) lines_.push_back(std::move(*line));
  for (auto line = owned.rbegin(); line != owned.rend(); ++line) {
    line->kept = true;
    lines_.push_back(std::move(*line));
  }
}

void TraceBuffer::drop_kept(Mark mark, int owner) {
  const auto first = lines_.begin() + static_cast<std::ptrdiff_t>(mark - written_);
  lines_.erase(std::remove_if(first, lines_.end(),
                              [&](const Line& line) { return line.kept && line.owner == owner; }),
               lines_.end());
}

std::vector<std::string> TraceBuffer::kept_of(int owner) const {
  std::vector<std::string> lines;
  for (const Line& line : lines_) {
    if (line.kept && line.owner == owner) lines.push_back(line.text);
  }
  return lines;
}

void TraceBuffer::release_before(Mark mark) {
  while (written_ < mark && !lines_.empty()) {
    out_.line(lines_.front().text);
    lines_.pop_front();
    ++written_;
  }
}

}  // namespace rubicon::taskplan
