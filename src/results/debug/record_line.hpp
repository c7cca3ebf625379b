#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rubicon::debug {

/// The members of one record that a debugger asks for. Deeper values (poses, residuals) are passed
/// over.
class RecordLine {
 public:
  /// Throws std::invalid_argument, with a message for the user, for what is no JSON object.
  explicit RecordLine(std::string_view text);

  bool has(std::string_view key) const;
  /// These throw std::invalid_argument if there is no such member of this type.
  const std::string& text(std::string_view key) const;
  double number(std::string_view key) const;
  int integer(std::string_view key) const;
  bool truth(std::string_view key) const;
  /// A text, or a list of texts.
  std::vector<std::string> texts(std::string_view key) const;
  /// The members of the object `q`, in their order.
  const std::vector<std::pair<std::string, double>>& configuration() const { return q_; }

 private:
  friend class RecordHandler;
  struct Member {
    enum class Type { text, number, truth, texts, other } type = Type::other;
    std::string key;
    std::string text;
    double number = 0;
    std::vector<std::string> texts;
  };
  const Member& member(std::string_view key, Member::Type type) const;

  std::vector<Member> members_;
  std::vector<std::pair<std::string, double>> q_;
};

}  // namespace rubicon::debug
