#include <array>
#include <type_traits>
#include <utility>
#include <variant>

#include "src/simulation/trace/record_fields.hpp"

namespace rubicon::trace {

namespace {

template <typename T>
constexpr FieldType type_of() {
  if constexpr (std::is_same_v<T, std::string_view>) return FieldType::text;
  if constexpr (std::is_same_v<T, int>) return FieldType::whole;
  if constexpr (std::is_same_v<T, double>) return FieldType::number;
  if constexpr (std::is_same_v<T, std::optional<int>>) return FieldType::whole_or_null;
  if constexpr (std::is_same_v<T, std::optional<double>>) return FieldType::number_or_null;
  if constexpr (std::is_same_v<T, bool>) return FieldType::truth;
  if constexpr (std::is_same_v<T, Ticks>) return FieldType::time;
  if constexpr (std::is_same_v<T, Names>) return FieldType::names;
  if constexpr (std::is_same_v<T, Numbers>) return FieldType::numbers;
  if constexpr (std::is_same_v<T, std::optional<Hit>>) return FieldType::pair;
  if constexpr (std::is_same_v<T, Configuration>) return FieldType::configuration;
  if constexpr (std::is_same_v<T, NamedValues>) return FieldType::values;
  if constexpr (std::is_same_v<T, RefusalCounts>) return FieldType::counts;
  if constexpr (std::is_same_v<T, math::Pose>) return FieldType::pose;
}

template <typename R, auto Member>
constexpr FieldSpec spec_of(const Field<Member>& field) {
  using Value = std::remove_cvref_t<decltype(std::declval<R&>().*Member)>;
  return {field.name, field.required, type_of<Value>()};
}

template <typename R>
constexpr auto kSpecs =
    std::apply([](const auto&... fields) { return std::array{spec_of<R>(fields)...}; },
               RecordFields<R>::kFields);

template <std::size_t... I>
constexpr auto make_table(std::index_sequence<I...>) {
  static_assert(((RecordFields<std::variant_alternative_t<I, Record::What>>::kKind ==
                  static_cast<RecordKind>(I)) &&
                 ...),
                "Record::What has the order of RecordKind");
  return std::array{RecordSpec{static_cast<RecordKind>(I), kRecordTypes[I],
                               kSpecs<std::variant_alternative_t<I, Record::What>>}...};
}

constexpr auto kTable = make_table(std::make_index_sequence<kRecordTypes.size()>());
static_assert(kRecordTypes.size() == std::variant_size_v<Record::What>);

}  // namespace

std::span<const RecordSpec> record_table() { return kTable; }

}  // namespace rubicon::trace
