#include "src/results/debug/record_line.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rubicon::debug {

namespace {

using Json = nlohmann::json;

/// A `try` has so many, the longest of the frequent records.
constexpr std::size_t kUsualMembers = 16;

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument("this is no line of a trace: " + why);
}

}  // namespace

/// Keeps the members of the outermost object as the parser meets them.
class RecordHandler : public nlohmann::json_sax<Json> {
 public:
  explicit RecordHandler(RecordLine& record) : record_(record) {}

  bool null() override {
    return value([](Member&) {});
  }
  bool boolean(bool truth) override {
    return value([&](Member& member) {
      member.type = Member::Type::truth;
      member.number = truth ? 1 : 0;
    });
  }
  bool number_integer(number_integer_t number) override {
    return a_number(static_cast<double>(number));
  }
  bool number_unsigned(number_unsigned_t number) override {
    return a_number(static_cast<double>(number));
  }
  bool number_float(number_float_t number, const string_t&) override { return a_number(number); }
  bool string(string_t& text) override {
    if (depth_ == 2 && in_list_) {
      record_.members_.back().texts.push_back(std::move(text));
      return true;
    }
    return value([&](Member& member) {
      member.type = Member::Type::text;
      member.text = std::move(text);
    });
  }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override {
    if (depth_ == 1) in_configuration_ = record_.members_.back().key == "q";
    return open();
  }
  bool key(string_t& name) override {
    if (depth_ == 1) {
      record_.members_.emplace_back().key = std::move(name);
    } else if (depth_ == 2 && in_configuration_) {
      name_ = std::move(name);
    }
    return true;
  }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override {
    if (depth_ == 0) refuse("it is no object");
    if (depth_ == 1) {
      in_list_ = true;
      record_.members_.back().type = Member::Type::texts;
    }
    return open();
  }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t, const std::string&, const Json::exception& error) override {
    refuse(error.what());
  }

 private:
  using Member = RecordLine::Member;

  template <typename Set>
  bool value(const Set& set) {
    if (depth_ == 0) refuse("it is no object");
    if (depth_ == 1) set(record_.members_.back());
    return true;
  }
  bool a_number(double number) {
    if (depth_ == 2 && in_configuration_) {
      record_.q_.emplace_back(std::move(name_), number);
      return true;
    }
    return value([&](Member& member) {
      member.type = Member::Type::number;
      member.number = number;
    });
  }
  bool open() {
    ++depth_;
    return true;
  }
  bool close() {
    if (--depth_ == 1) in_configuration_ = in_list_ = false;
    return true;
  }

  RecordLine& record_;
  int depth_ = 0;
  bool in_configuration_ = false;
  bool in_list_ = false;
  std::string name_;  ///< of the parameter whose value comes
};

RecordLine::RecordLine(std::string_view text) {
  members_.reserve(kUsualMembers);
  RecordHandler handler(*this);
  Json::sax_parse(text.begin(), text.end(), &handler);
}

bool RecordLine::has(std::string_view key) const {
  for (const Member& each : members_) {
    if (each.key == key) return true;
  }
  return false;
}

const RecordLine::Member& RecordLine::member(std::string_view key, Member::Type type) const {
  for (const Member& each : members_) {
    if (each.key == key && each.type == type) return each;
  }
  refuse(fmt::format("it has no '{}', or not of its kind", key));
}

const std::string& RecordLine::text(std::string_view key) const {
  return member(key, Member::Type::text).text;
}

double RecordLine::number(std::string_view key) const {
  return member(key, Member::Type::number).number;
}

int RecordLine::integer(std::string_view key) const {
  const double number = member(key, Member::Type::number).number;
  if (number < 0 || number > std::numeric_limits<int>::max() || number != std::trunc(number)) {
    refuse(fmt::format("its '{}' is no count", key));
  }
  return static_cast<int>(number);
}

bool RecordLine::truth(std::string_view key) const {
  return member(key, Member::Type::truth).number != 0;
}

std::vector<std::string> RecordLine::texts(std::string_view key) const {
  for (const Member& each : members_) {
    if (each.key == key && each.type == Member::Type::text) return {each.text};
  }
  return member(key, Member::Type::texts).texts;
}

}  // namespace rubicon::debug
