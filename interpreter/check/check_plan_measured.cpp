#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

using sampling::MeasuredTimes;

constexpr int kMostColumns = 10'000;

std::optional<double> seconds_of_unit(const std::string& unit) {
  if (unit == "s") return 1;
  if (unit == "min") return 60;
  if (unit == "h") return 3600;
  return std::nullopt;
}

class MeasuredCheck {
 public:
  MeasuredCheck(Subject& subject, const syntax::DurationLaw& written)
      : subject_(subject), written_(written) {}

  std::shared_ptr<const MeasuredTimes> run() {
    const int errors = subject_.diagnostics.errors();
    const auto seconds = unit();
    column();
    if (!seconds || subject_.diagnostics.errors() != errors) return nullptr;
    wanted_.seconds_per_unit = *seconds;
    const std::string path = resolve_path(subject_.model.path, written_.file->text);
    const std::string column =
        written_.columns.empty() ? "" : (written_.by_number ? "#" : "=") + written_.columns[0].text;
    const auto [place, is_new] =
        subject_.measured.try_emplace({path, written_.units[0].text, column}, nullptr);
    if (is_new) place->second = read(path);
    return place->second;
  }

 private:
  void wrong(Span span, std::string message, std::string hint = {}) {
    subject_.error("P52", span, std::move(message), std::move(hint));
  }

  std::optional<double> unit() {
    if (written_.units.empty()) {
      wrong(written_.span, "measured does not say the unit of the times in the file",
            fmt::format("measured(\"{}\", min)", written_.file->text));
      return std::nullopt;
    }
    const syntax::Name& name = written_.units.front();
    if (written_.units.size() > 1) {
      subject_.twice(written_.units[1].span, "the unit of the times is given twice", name.span);
    }
    const auto seconds = seconds_of_unit(name.text);
    if (!seconds) {
      wrong(name.span,
            fmt::format("unknown unit '{}' of measured times; expected s, min or h", name.text));
    }
    return seconds;
  }

  void column() {
    if (written_.columns.empty()) return;
    const syntax::String& first = written_.columns.front();
    if (written_.columns.size() > 1) {
      subject_.twice(written_.columns[1].span, "the column is given twice", first.span);
    }
    if (!written_.by_number) {
      wanted_.name = first.text;
      return;
    }
    int number = 0;
    const char* const end = first.text.data() + first.text.size();
    const auto [last, error] = std::from_chars(first.text.data(), end, number);
    if (error != std::errc() || last != end || number < 1 || number > kMostColumns) {
      wrong(first.span, fmt::format("expected the number of a column from 1 to {}, found {}",
                                    kMostColumns, first.text));
      return;
    }
    wanted_.number = number;
  }

  std::shared_ptr<const MeasuredTimes> read(const std::string& path) {
    std::variant<std::string, FileFailure> text = subject_.files.read_text(path);
    if (const auto* failure = std::get_if<FileFailure>(&text)) {
      subject_.error("F01", written_.file->span,
                     fmt::format("measured times '{}': {}", written_.file->text, failure->message));
      return nullptr;
    }
    const FileId file = subject_.sources.add(path, std::get<std::string>(std::move(text)));
    auto times = sampling::read_measured(subject_.sources.file(file).text, wanted_);
    if (auto* fault = std::get_if<sampling::MeasuredFault>(&times)) {
      if (wanted_.name && !fault->headings.empty()) {
        const std::string near = did_you_mean(*wanted_.name, fault->headings);
        if (!near.empty()) fault->message += "; did you mean " + near + "?";
      }
      Diagnostic diagnostic;
      diagnostic.code = "P58";
      diagnostic.span = {file, static_cast<std::uint32_t>(fault->begin),
                         static_cast<std::uint32_t>(fault->end)};
      diagnostic.message = std::move(fault->message);
      diagnostic.hint = std::move(fault->hint);
      diagnostic.notes.push_back({written_.file->span, "read for this duration"});
      subject_.diagnostics.add(std::move(diagnostic));
      return nullptr;
    }
    auto result = std::make_shared<MeasuredTimes>(std::get<MeasuredTimes>(std::move(times)));
    result->file = path;
    result->unit = written_.units.front().text;
    return result;
  }

  Subject& subject_;
  const syntax::DurationLaw& written_;
  sampling::MeasuredColumn wanted_;
};

}  // namespace

std::shared_ptr<const MeasuredTimes> resolve_measured(Subject& subject,
                                                      const syntax::DurationLaw& written) {
  return MeasuredCheck(subject, written).run();
}

namespace {

/// Work between two breakdowns on average, at least: less is no machine to plan with.
constexpr double kLeastBetween = 60;  // s

std::optional<sampling::DurationLaw> law_of(Subject& subject, const syntax::Number& number,
                                            const std::optional<syntax::DurationLaw>& law,
                                            const std::string& what) {
  if (law) return resolve_law(subject, *law);
  const auto seconds = resolve_duration(subject, number, what);
  if (!seconds) return std::nullopt;
  return sampling::DurationLaw{sampling::Law::sequence, {*seconds}};
}

}  // namespace

std::optional<BreakdownSpec> resolve_breakdown(Subject& subject,
                                               const std::vector<syntax::Breakdown>& written,
                                               const std::string& who) {
  const auto span_of = [](const syntax::Breakdown& each) { return each.span; };
  const syntax::Breakdown* item =
      only_one(subject, written, "when " + who + " breaks down", span_of);
  if (item == nullptr) return std::nullopt;
  const auto every =
      law_of(subject, item->every, item->every_law, "the time between two breakdowns of " + who);
  const auto takes = law_of(subject, item->takes, item->takes_law, "a repair of " + who);
  if (!every || !takes) return std::nullopt;
  const Span place = item->every_law ? item->every_law->span : item->every.span;
  if (every->mean() < kLeastBetween) {
    subject.error("P59", place,
                  fmt::format("{} breaks down every {:g} s of work on average; expected a minute "
                              "or more",
                              who, every->mean()));
    return std::nullopt;
  }
  return BreakdownSpec{*every, *takes};
}

}  // namespace rubicon::interpreter::plan_check
