#include "src/studies/cluster/messages.hpp"

#include <cstring>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace rubicon::cluster {

namespace {

/// Numbers as they are in memory: the ranks of a job run the same program.
class Packer {
 public:
  void number(std::int64_t value) { raw(&value, sizeof value); }
  void real(double value) { raw(&value, sizeof value); }
  void text(std::string_view value) {
    number(static_cast<std::int64_t>(value.size()));
    raw(value.data(), value.size());
  }
  void reals(const std::vector<double>& values) {
    number(static_cast<std::int64_t>(values.size()));
    for (const double each : values) real(each);
  }
  std::string take() { return std::move(bytes_); }

 private:
  void raw(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }
  std::string bytes_;
};

/// What is read after something was wrong is 0 or empty.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : rest_(bytes) {}

  std::int64_t number() {
    std::int64_t value = 0;
    raw(&value, sizeof value);
    return value;
  }
  double real() {
    double value = 0;
    raw(&value, sizeof value);
    return value;
  }
  std::string text() {
    const std::size_t size = count(1);
    std::string value(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return value;
  }
  std::vector<double> reals() {
    std::vector<double> values(count(sizeof(double)));
    for (double& each : values) each = real();
    return values;
  }
  /// How many follow, each of so many bytes at least.
  std::size_t count(std::size_t bytes_of_one) {
    const std::int64_t value = number();
    if (value >= 0 && static_cast<std::uint64_t>(value) <= rest_.size() / bytes_of_one) {
      return static_cast<std::size_t>(value);
    }
    good_ = false;
    return 0;
  }
  void fail() { good_ = false; }
  bool is_good() const { return good_; }
  bool is_done() const { return good_ && rest_.empty(); }

 private:
  void raw(void* data, std::size_t size) {
    if (!good_ || rest_.size() < size) {
      good_ = false;
      return;
    }
    std::memcpy(data, rest_.data(), size);
    rest_.remove_prefix(size);
  }
  std::string_view rest_;
  bool good_ = true;
};

/// The least that a text, or a number, takes.
constexpr std::size_t kLeast = sizeof(std::int64_t);

void pack(Packer& out, const study::VariantFacts& facts) {
  out.number(static_cast<std::int64_t>(facts.tasks.size()));
  for (const std::string& each : facts.tasks) out.text(each);
  // Many places may have the same file.
  std::map<const sampling::MeasuredTimes*, std::int64_t> tables;
  std::vector<const sampling::MeasuredTimes*> in_order;
  for (const study::UncertainPlace& each : facts.uncertain) {
    const auto* table = each.law.measured.get();
    if (table && tables.emplace(table, static_cast<std::int64_t>(in_order.size())).second) {
      in_order.push_back(table);
    }
  }
  out.number(static_cast<std::int64_t>(in_order.size()));
  for (const sampling::MeasuredTimes* each : in_order) {
    out.text(each->file);
    out.text(each->unit);
    out.number(each->column);
    out.reals(each->times);
    out.reals({each->mean, each->least, each->most});
  }
  out.number(static_cast<std::int64_t>(facts.uncertain.size()));
  for (const study::UncertainPlace& each : facts.uncertain) {
    out.text(each.place);
    out.number(static_cast<std::int64_t>(each.law.law));
    out.reals(each.law.values);
    out.number(each.law.measured ? tables.at(each.law.measured.get()) : -1);
  }
  out.number(facts.start_at ? 1 : 0);
  if (facts.start_at) {
    out.number(days_from_date(facts.start_at->date));
    out.number(facts.start_at->minute_of_day);
  }
  out.text(facts.currency);
  out.number(facts.costed ? 1 : 0);
}

study::VariantFacts unpack_facts(Unpacker& in) {
  study::VariantFacts facts;
  for (std::size_t left = in.count(kLeast); left > 0 && in.is_good(); --left) {
    facts.tasks.push_back(in.text());
  }
  std::vector<std::shared_ptr<const sampling::MeasuredTimes>> tables;
  for (std::size_t left = in.count(kLeast); left > 0 && in.is_good(); --left) {
    auto table = std::make_shared<sampling::MeasuredTimes>();
    table->file = in.text();
    table->unit = in.text();
    table->column = static_cast<int>(in.number());
    table->times = in.reals();
    const std::vector<double> sums = in.reals();
    if (sums.size() != 3 || table->times.empty()) {
      in.fail();
      break;
    }
    table->mean = sums[0];
    table->least = sums[1];
    table->most = sums[2];
    tables.push_back(std::move(table));
  }
  for (std::size_t left = in.count(kLeast); left > 0 && in.is_good(); --left) {
    study::UncertainPlace place;
    place.place = in.text();
    const std::int64_t law = in.number();
    place.law.values = in.reals();
    const std::int64_t table = in.number();
    if (law < 0 || law > static_cast<std::int64_t>(sampling::Law::measured) ||
        table >= static_cast<std::int64_t>(tables.size())) {
      in.fail();
      break;
    }
    place.law.law = static_cast<sampling::Law>(law);
    if (table >= 0) place.law.measured = tables[static_cast<std::size_t>(table)];
    const bool has_table = place.law.measured != nullptr;
    if (has_table != (place.law.law == sampling::Law::measured) || !place.law.fault().empty()) {
      in.fail();
    }
    facts.uncertain.push_back(std::move(place));
  }
  if (in.number() != 0) {
    const std::int64_t days = in.number();
    const std::int64_t minute = in.number();
    constexpr std::int64_t kMostDays = 4'000'000;
    if (days < -kMostDays || days > kMostDays || minute < 0 || minute >= 1'440) {
      in.fail();
    } else {
      facts.start_at = {schedule::date_from_days(days), static_cast<int>(minute)};
    }
  }
  facts.currency = in.text();
  facts.costed = in.number() != 0;
  return facts;
}

void pack(Packer& out, const Hello& hello) {
  out.text(hello.digest);
  out.text(hello.identity);
  out.text(hello.failure);
}

void pack(Packer& out, const Order& order) {
  out.number(static_cast<std::int64_t>(order.number));
  out.number(static_cast<std::int64_t>(order.piece.variant));
  out.number(static_cast<std::int64_t>(order.piece.set.size()));
  for (const auto& [name, value] : order.piece.set) {
    out.text(name);
    out.text(value);
  }
  out.number(static_cast<std::int64_t>(order.piece.runs.size()));
  for (const std::int64_t each : order.piece.runs) out.number(each);
}

void pack(Packer& out, const Answer& answer) {
  out.number(static_cast<std::int64_t>(answer.number));
  out.text(answer.result.fault);
  out.text(answer.result.digest);
  out.number(answer.result.facts ? 1 : 0);
  if (answer.result.facts) pack(out, *answer.result.facts);
  out.number(static_cast<std::int64_t>(answer.result.runs.size()));
  for (const study::LoggedRun& each : answer.result.runs) out.text(write_line(each));
}

void pack(Packer&, const Alive&) {}
void pack(Packer& out, const End& end) { out.number(end.all_there ? 1 : 0); }

Hello unpack_hello(Unpacker& in) {
  Hello hello;
  hello.digest = in.text();
  hello.identity = in.text();
  hello.failure = in.text();
  return hello;
}

Order unpack_order(Unpacker& in) {
  Order order;
  order.number = static_cast<std::uint64_t>(in.number());
  order.piece.variant = static_cast<std::size_t>(in.number());
  for (std::size_t left = in.count(2 * kLeast); left > 0 && in.is_good(); --left) {
    std::string name = in.text();
    order.piece.set.emplace_back(std::move(name), in.text());
  }
  for (std::size_t left = in.count(kLeast); left > 0 && in.is_good(); --left) {
    order.piece.runs.push_back(in.number());
  }
  return order;
}

Answer unpack_answer(Unpacker& in, std::size_t questions) {
  Answer answer;
  answer.number = static_cast<std::uint64_t>(in.number());
  answer.result.fault = in.text();
  answer.result.digest = in.text();
  if (in.number() != 0) answer.result.facts = unpack_facts(in);
  for (std::size_t left = in.count(kLeast); left > 0 && in.is_good(); --left) {
    auto run = study::read_line(in.text(), questions);
    if (!run) {
      in.fail();
      break;
    }
    answer.result.runs.push_back(*std::move(run));
  }
  return answer;
}

}  // namespace

std::string write_message(const Message& message) {
  Packer out;
  out.number(static_cast<std::int64_t>(message.index()));
  std::visit([&](const auto& each) { pack(out, each); }, message);
  return out.take();
}

std::optional<Message> read_message(std::string_view text, std::size_t questions) {
  Unpacker in(text);
  std::optional<Message> message;
  switch (in.number()) {
    case 0:
      message = unpack_hello(in);
      break;
    case 1:
      message = unpack_order(in);
      break;
    case 2:
      message = unpack_answer(in, questions);
      break;
    case 3:
      message = Alive{};
      break;
    case 4:
      message = End{in.number() != 0};
      break;
    default:
      return std::nullopt;
  }
  return in.is_done() ? std::move(message) : std::nullopt;
}

}  // namespace rubicon::cluster
