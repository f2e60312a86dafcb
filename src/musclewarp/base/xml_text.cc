// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/xml_text.h"

#include <cctype>
#include <cstdint>

#include "musclewarp/base/text_encoding.h"

namespace musclewarp {
namespace {

constexpr char kUtf8Mark[] = "\xef\xbb\xbf";

// What windows-1252 has at 0x80 to 0x9f, where Latin-1 has control characters.
// Five are not defined.
constexpr std::uint32_t kWindows1252[32] = {
    0x20ac, 0x81,   0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021,
    0x02c6, 0x2030, 0x0160, 0x2039, 0x0152, 0x8d,   0x017d, 0x8f,
    0x90,   0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014,
    0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0x9d,   0x017e, 0x0178};

// Returns the length of the UTF-8 character at the start of `text`, or 0 if
// there is none. Characters that are longer than they need be, and halves of
// pairs of UTF-16, are none.
size_t Utf8Length(const unsigned char* text, size_t size) {
  const unsigned char lead = text[0];
  const size_t length = lead < 0x80                   ? 1
                        : lead >= 0xc2 && lead < 0xe0 ? 2
                        : lead >= 0xe0 && lead < 0xf0 ? 3
                        : lead >= 0xf0 && lead < 0xf5 ? 4
                                                      : 0;
  if (length > size) return 0;
  for (size_t i = 1; i < length; ++i) {
    if ((text[i] & 0xc0) != 0x80) return 0;
  }
  const bool is_wrong =
      (lead == 0xe0 && text[1] < 0xa0) || (lead == 0xed && text[1] >= 0xa0) ||
      (lead == 0xf0 && text[1] < 0x90) || (lead == 0xf4 && text[1] >= 0x90);
  return is_wrong ? 0 : length;
}

bool IsUtf8(const std::string& text) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(text.data());
  for (size_t i = 0; i < text.size();) {
    const size_t length = Utf8Length(bytes + i, text.size() - i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

std::string Utf8FromBytes(const std::string& text, bool is_windows) {
  std::string utf8;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool differs = is_windows && byte >= 0x80 && byte < 0xa0;
    AppendUtf8(differs ? kWindows1252[byte - 0x80] : byte, &utf8);
  }
  return utf8;
}

// Where the name of the encoding is in the declaration of a text.
struct NamedEncoding {
  size_t begin = 0, length = 0;  // 0: there is none
  std::string name;              // in small letters
};

NamedEncoding EncodingOf(const std::string& text) {
  NamedEncoding encoding;
  if (text.compare(0, 5, "<?xml") != 0) return encoding;
  const std::string head = text.substr(0, text.find("?>"));
  const size_t key = head.find("encoding");
  const size_t quote = key == std::string::npos
                           ? std::string::npos
                           : head.find_first_of("\"'", key);
  if (quote == std::string::npos) return encoding;
  const size_t end = head.find(head[quote], quote + 1);
  if (end == std::string::npos) return encoding;
  encoding.begin = quote + 1;
  encoding.length = end - encoding.begin;
  for (const char c : head.substr(encoding.begin, encoding.length)) {
    encoding.name +=
        static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return encoding;
}

}  // namespace

XmlText DecodeXml(const std::string& bytes) {
  using std::string;
  const auto begins_with = [&](const string& start) {
    return bytes.compare(0, start.size(), start) == 0;
  };
  if (begins_with("\xff\xfe") || begins_with(string("<\0", 2))) {
    return {Utf8FromUtf16(bytes, false), false};
  }
  if (begins_with("\xfe\xff") || begins_with(string("\0<", 2))) {
    return {Utf8FromUtf16(bytes, true), false};
  }
  const string text = begins_with(kUtf8Mark) ? bytes.substr(3) : bytes;
  if (IsUtf8(text)) return {text, false};
  const string name = EncodingOf(text).name;
  const bool is_windows = name == "windows-1252" || name == "cp1252";
  const bool is_latin1 =
      name == "iso-8859-1" || name == "iso_8859-1" || name == "latin1";
  return {Utf8FromBytes(text, is_windows), !is_windows && !is_latin1};
}

std::string WithUtf8Declaration(std::string utf8) {
  const NamedEncoding encoding = EncodingOf(utf8);
  if (encoding.length > 0 && encoding.name != "utf-8") {
    utf8.replace(encoding.begin, encoding.length, "UTF-8");
  }
  return utf8;
}

std::string XmlEscaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace musclewarp
