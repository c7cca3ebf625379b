#include "src/studies/cluster/hand_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rubicon::cluster {

HandOut::HandOut(Channel& channel, int threads, std::size_t questions, std::string digest,
                 std::function<void(const std::string&)> on_note)
    : channel_(channel),
      threads_(threads),
      questions_(questions),
      digest_(std::move(digest)),
      on_note_(std::move(on_note)),
      ranks_(static_cast<std::size_t>(channel.size())) {
  for (Rank& each : ranks_) each.heard = channel_.now();
}

int HandOut::places() const { return (channel_.size() - 1) * threads_ * kPiecesAThread; }

bool HandOut::all_there() const {
  return std::none_of(ranks_.begin(), ranks_.end(), [](const Rank& each) { return each.is_gone; });
}

bool HandOut::serve(study::Work& work) {
  // Nobody was listened to since the last time.
  for (Rank& each : ranks_) each.heard = channel_.now();
  while (!work.is_over()) {
    const bool heard = hear(work);
    const bool handed = hand_pieces(work);
    look_for_lost(work);
    if (!heard && !handed) channel_.pause();
  }
  for (Rank& each : ranks_) {
    each.others += static_cast<int>(each.pieces.size());
    each.pieces.clear();
  }
  return true;
}

bool HandOut::hear(study::Work& work) {
  bool heard = false;
  while (auto received = channel_.receive()) {
    heard = true;
    Rank& rank = ranks_[static_cast<std::size_t>(received->from)];
    if (rank.is_out) continue;
    rank.heard = channel_.now();
    const auto message = read_message(received->message, questions_);
    if (!message) {
      leave_out(received->from, "what it says is not understood", work);
    } else if (const auto* hello = std::get_if<Hello>(&*message)) {
      rank.identity = hello->identity;
      rank.is_ready = hello->failure.empty() && hello->digest == digest_;
      if (rank.is_ready) continue;
      leave_out(received->from,
                hello->failure.empty() ? "its study or its program is another" : hello->failure,
                work);
    } else if (const auto* answer = std::get_if<Answer>(&*message)) {
      take_answer(received->from, *answer, work);
    }
  }
  return heard;
}

void HandOut::take_answer(int number, const Answer& answer, study::Work& work) {
  Rank& rank = ranks_[static_cast<std::size_t>(number)];
  const auto found = rank.pieces.find(answer.number);
  if (found == rank.pieces.end()) {
    if (rank.others == 0) leave_out(number, "it answers what nobody asked", work);
    rank.others = std::max(rank.others - 1, 0);
    return;
  }
  if (const std::string wrong = work.complaint(found->second, answer.result); !wrong.empty()) {
    leave_out(number, wrong, work);
    return;
  }
  work.done(found->second, answer.result);
  rank.pieces.erase(found);
}

void HandOut::leave_out(int number, const std::string& why, study::Work& work) {
  Rank& rank = ranks_[static_cast<std::size_t>(number)];
  if (std::exchange(rank.is_out, true)) return;
  for (const auto& [order, piece] : rank.pieces) work.give_back(piece);
  const bool had_any = !rank.pieces.empty();
  rank.pieces.clear();
  on_note_(fmt::format("rank {} is left out: {}{}", number, why,
                       had_any ? "; what it had is done by others" : ""));
}

void HandOut::look_for_lost(study::Work& work) {
  const double now = channel_.now();
  if (now - looked_ < kReportEvery / 4) return;
  looked_ = now;
  for (int number = 1; number < channel_.size(); ++number) {
    Rank& rank = ranks_[static_cast<std::size_t>(number)];
    if (rank.is_gone) continue;
    if (!rank.identity.empty() && channel_.is_gone(rank.identity)) {
      rank.is_gone = true;
      leave_out(number, "it has ended", work);
    } else if (!rank.is_out && now - rank.heard > kLostAfter) {
      rank.is_gone = true;
      leave_out(number, fmt::format("nothing was heard of it for {} s", kLostAfter), work);
    } else {
      channel_.send(number, write_message(Alive{}));
    }
  }
}

bool HandOut::hand_pieces(study::Work& work) {
  bool handed = false;
  // A piece at a time to each, so that the first of them does not have all there is.
  for (int had = 0; had < threads_ * kPiecesAThread; ++had) {
    for (int number = 1; number < channel_.size(); ++number) {
      Rank& rank = ranks_[static_cast<std::size_t>(number)];
      const int has = static_cast<int>(rank.pieces.size()) + rank.others;
      if (!rank.is_ready || rank.is_out || has > had) continue;
      auto piece = work.take();
      if (!piece) return handed;
      handed = true;
      channel_.send(number, write_message(Order{next_, *piece}));
      rank.pieces.emplace(next_++, *std::move(piece));
    }
  }
  return handed;
}

void HandOut::end() {
  for (int number = 1; number < channel_.size(); ++number) {
    if (!ranks_[static_cast<std::size_t>(number)].is_gone) {
      channel_.send(number, write_message(End{all_there()}));
    }
  }
}

}  // namespace rubicon::cluster
