#include <array>
#include <charconv>

#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

constexpr std::uint32_t kReplacement = 0xFFFD;

void put_code_point(std::string& out, std::uint32_t code) {
  if (code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) code = kReplacement;
  const auto put = [&](std::uint32_t byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | code >> 6);
    put(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    put(0xE0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  } else {
    put(0xF0 | code >> 18);
    put(0x80 | (code >> 12 & 0x3F));
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  }
}

/// The hexadecimal number in the first `count` characters; false if it is none.
bool hexadecimal(std::string_view text, std::size_t count, std::uint32_t& value) {
  if (text.size() < count) return false;
  const auto [end, error] = std::from_chars(text.data(), text.data() + count, value, 16);
  return error == std::errc() && end == text.data() + count;
}

class TextDecoder {
 public:
  explicit TextDecoder(std::string_view raw) : rest_(raw) {}

  std::string decode() {
    while (!rest_.empty()) {
      const char c = rest_.front();
      if (c == '\r' || c == '\n') {
        rest_.remove_prefix(1);  // a long text may be broken; the break is no part of it
      } else if (c == '\'') {
        out_ += c;
        rest_.remove_prefix(rest_.substr(0, 2) == "''" ? 2 : 1);
      } else if (c != '\\' || !escape()) {
        out_ += c;
        rest_.remove_prefix(1);
      }
    }
    return std::move(out_);
  }

 private:
  /// Takes an escape off the front; false if there is none that can be understood.
  bool escape() {
    std::uint32_t code = 0;
    if (rest_.starts_with("\\\\")) {
      out_ += '\\';
      rest_.remove_prefix(2);
    } else if (rest_.starts_with("\\X\\") && hexadecimal(rest_.substr(3), 2, code)) {
      put_code_point(out_, code);  // ISO 8859-1
      rest_.remove_prefix(5);
    } else if (rest_.starts_with("\\S\\") && rest_.size() > 3 && (rest_[3] & 0x80) == 0) {
      // The upper half of the page that \PA\ names; pages other than ISO 8859-1 are not in use.
      put_code_point(out_, 0x80U + static_cast<unsigned char>(rest_[3]));
      rest_.remove_prefix(4);
    } else if (rest_.size() > 3 && rest_.starts_with("\\P") && rest_[3] == '\\') {
      rest_.remove_prefix(4);
    } else if (rest_.starts_with("\\X2\\")) {
      return wide(4);
    } else if (rest_.starts_with("\\X4\\")) {
      return wide(8);
    } else {
      return false;
    }
    return true;
  }

  /// \X2\ or \X4\, code units of `digits` digits each, \X0\.
  bool wide(std::size_t digits) {
    constexpr std::size_t kMark = 4;
    const std::size_t end = rest_.find("\\X0\\", kMark);
    if (end == std::string_view::npos) return false;
    std::string_view units = rest_.substr(kMark, end - kMark);
    if (units.size() % digits != 0) return false;
    std::string text;
    std::uint32_t high = 0;
    for (; !units.empty(); units.remove_prefix(digits)) {
      std::uint32_t code = 0;
      if (!hexadecimal(units, digits, code)) return false;
      if (code >= 0xD800 && code < 0xDC00) {
        high = code;
        continue;
      }
      if (high != 0 && code >= 0xDC00 && code < 0xE000) {
        code = 0x10000 + ((high - 0xD800) << 10) + (code - 0xDC00);
      }
      high = 0;
      put_code_point(text, code);
    }
    out_ += text;
    rest_.remove_prefix(end + kMark);
    return true;
  }

  std::string_view rest_;
  std::string out_;
};

}  // namespace

std::string decode_step_text(std::string_view raw) { return TextDecoder(raw).decode(); }

}  // namespace rubicon::ifc
