#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubicon::ifc {

enum class StepKind : std::uint8_t {
  unset,        ///< $
  derived,      ///< *
  number,       ///< 12, -1.5E-3
  text,         ///< 'Wall'
  enumeration,  ///< .MILLI.
  reference,    ///< #12
  binary,       ///< "0F"
  list,         ///< (a,b)
  typed         ///< IFCLENGTHMEASURE(0.3)
};

class StepItem;

/// The arguments of a record, read flat: a value, then what is inside it, then the next. Views into
/// the text they were read from.
class StepValues {
 public:
  /// `arguments` from `(` to `)`, as StepFile has them; nothing when they break the form.
  static std::optional<StepValues> read(std::string_view arguments);

  std::size_t size() const;
  /// The argument at `index`; an unset one when there are fewer.
  StepItem operator[](std::size_t index) const;
  /// All arguments, as a list.
  StepItem all() const;
  /// Every record that is named anywhere inside, in order.
  std::vector<std::uint64_t> references() const;

 private:
  friend class StepItem;
  friend class StepValueReader;
  struct Value {
    StepKind kind = StepKind::unset;
    std::uint32_t end = 0;  ///< index behind the last value inside
    std::string_view text;  ///< the token without its marks (' " . #); of typed the keyword
  };
  std::vector<Value> values_;  ///< the first is the list of all arguments
};

/// One value among StepValues, which must outlive it.
class StepItem {
 public:
  StepItem() = default;

  StepKind kind() const { return values_ == nullptr ? StepKind::unset : value().kind; }
  bool is_set() const { return kind() != StepKind::unset && kind() != StepKind::derived; }
  /// Without marks: ' " . #; of a typed value its keyword.
  std::string_view text() const { return values_ == nullptr ? std::string_view() : value().text; }

  /// Of a number or a typed number, finite; nothing for anything else.
  std::optional<double> number() const;
  /// The record's number, 0 if this is no reference.
  std::uint64_t reference() const;
  /// Of a text: UTF-8, the escapes of the standard (section 6.4.3) resolved; empty if it is none.
  std::string decoded() const;
  bool is_enumeration(std::string_view word) const {
    return kind() == StepKind::enumeration && text() == word;
  }

  /// What is inside a list or a typed value. `size` counts each time; go over many with for.
  std::size_t size() const;
  /// The value inside at `index`; an unset one when there are fewer.
  StepItem operator[](std::size_t index) const;

  class Iterator {
   public:
    Iterator(const StepValues* values, std::size_t at) : values_(values), at_(at) {}
    StepItem operator*() const { return {values_, at_}; }
    Iterator& operator++();
    bool operator!=(const Iterator& other) const { return at_ != other.at_; }

   private:
    const StepValues* values_;
    std::size_t at_;
  };
  Iterator begin() const;
  Iterator end() const;

 private:
  friend class StepValues;
  StepItem(const StepValues* values, std::size_t at) : values_(values), at_(at) {}
  const StepValues::Value& value() const { return values_->values_[at_]; }

  const StepValues* values_ = nullptr;
  std::size_t at_ = 0;
};

/// A whole number without sign; nothing if there is anything else, or it is too large.
std::optional<std::uint64_t> whole_number(std::string_view text);

/// A text of a STEP file between its quotation marks as UTF-8, with the escapes `''`, `\\`, `\X\`,
/// `\X2\`, `\X4\`, `\S\` and `\P.\` (ISO 10303-21, 6.4.3). What breaks their rules, and bytes that
/// are no UTF-8, stay as they are.
std::string decode_step_text(std::string_view raw);

}  // namespace rubicon::ifc
