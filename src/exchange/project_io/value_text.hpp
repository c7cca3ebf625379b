#pragma once

#include <string>
#include <string_view>

#include "src/exchange/project_io/project.hpp"

/// Values of the model as text and back. `read` accepts what `text_of` and MSPDI write, leaves the
/// value alone and gives false for anything else, or for numbers beyond any sensible schedule.
namespace rubicon::project_io {

std::string text_of(const std::string& value);
std::string text_of(const Moment& value);      ///< "2015-02-18 08:00"
std::string text_of(const Duration& value);    ///< "PT16H0M0S" (ISO 8601)
std::string text_of(const TimeFormat& value);  ///< "d", "ed", "%", "h?"
std::string text_of(std::int64_t value);
std::string text_of(int value);
std::string text_of(double value);  ///< the shortest text that reads as the same number
std::string text_of(bool value);    ///< "1" or "0"
std::string text_of(Constraint value);
std::string text_of(ResourceType value);
std::string text_of(const DayTimes& value);  ///< "08:00-12:00,13:00-17:00"; "off"

bool read(std::string_view text, std::string& value);
bool read(std::string_view text, Moment& value);  ///< a blank or T between date and time
bool read(std::string_view text, Duration& value);
bool read(std::string_view text, TimeFormat& value);
bool read(std::string_view text, std::int64_t& value);
bool read(std::string_view text, int& value);
bool read(std::string_view text, double& value);
bool read(std::string_view text, bool& value);
bool read(std::string_view text, Constraint& value);
bool read(std::string_view text, ResourceType& value);
bool read(std::string_view text, DayTimes& value);

/// What a value of this type looks like, for "expected ...".
inline const char* expected(const Moment&) { return "a date and time such as 2026-03-02T07:00:00"; }
inline const char* expected(const Duration&) { return "a duration such as PT8H0M0S"; }
inline const char* expected(const TimeFormat&) { return "the number of a time unit"; }
inline const char* expected(bool) { return "0 or 1"; }
inline const char* expected(Constraint) { return "a constraint from 0 to 7"; }
inline const char* expected(ResourceType) { return "a type of resource from 0 to 2"; }
template <typename T>
const char* expected(const T&) {
  return "a number";
}
/// The same for a text that is none: a duration may be too long.
std::string expected_for(std::string_view text, const Duration& value);
template <typename T>
std::string expected_for(std::string_view, const T& value) {
  return expected(value);
}

/// The number by which MSPDI knows a format (DurationFormat, LagFormat): 7 for days, 8 for elapsed
/// days, 39 for estimated days, 19 for percent, ...
int mspdi_code(const TimeFormat& format);
/// Nothing for numbers that mean no unit (21, 53: none given) or are unknown.
std::optional<TimeFormat> format_of_code(std::int64_t code);

/// Sorts, joins what touches or overlaps, and drops what is empty.
DayTimes tidy(DayTimes times);

}  // namespace rubicon::project_io
