#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "src/studies/study/work.hpp"

namespace rubicon::cluster {

/// A rank is ready to work.
struct Hello {
  std::string digest;    ///< of the study, and of the program
  std::string identity;  ///< see Channel
  std::string failure;   ///< why it cannot work; "" if it can
};
/// Something to do, or done.
struct Order {
  std::uint64_t number = 0;
  study::Piece piece;
};
struct Answer {
  std::uint64_t number = 0;
  study::PieceResult result;
};
/// The sender is still there.
struct Alive {};
/// The study is over.
struct End {
  bool all_there = true;  ///< no rank is lost
};

using Message = std::variant<Hello, Order, Answer, Alive, End>;

std::string write_message(const Message& message);
/// Nothing for what no write_message wrote. `questions`: of the study.
std::optional<Message> read_message(std::string_view text, std::size_t questions);

}  // namespace rubicon::cluster
