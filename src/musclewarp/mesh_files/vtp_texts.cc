// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/vtp_texts.h"

#include "musclewarp/base/base64.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/text_cursor.h"
#include "musclewarp/mesh_files/vtp_packing.h"
#include "musclewarp/mesh_files/xml_tags.h"

namespace musclewarp {
namespace {

// The letters of texts written as numbers, up to the first 0, which ends a
// text.
std::string LettersOf(std::string_view content) {
  TextCursor cursor("", content);
  std::string letters;
  for (std::string_view word; cursor.NextWord(&word);) {
    const std::int64_t letter = cursor.Integer(word, "a letter");
    if (letter == 0) break;
    letters += static_cast<char>(letter);
  }
  return letters;
}

// What stands behind <AppendedData>: the data start behind an underscore.
std::string_view AppendedIn(std::string_view bytes, XmlTag tag) {
  while (NextXmlTag(bytes, tag.end, &tag)) {
    if (tag.name() != "AppendedData") continue;
    const std::size_t begin = bytes.find('_', tag.end);
    return begin == std::string_view::npos ? "" : bytes.substr(begin + 1);
  }
  return "";
}

std::string Unpacked(std::string_view bytes,
                     const XmlTag& root,
                     const XmlTag& array) {
  const VtpPacking packing = VtpPackingFromTag("", root);
  const std::string_view format = array.Attribute("format");
  if (format == "binary") {
    const std::string_view content =
        bytes.substr(array.end, bytes.find('<', array.end) - array.end);
    return UnpackVtpArray("", DecodeBase64(content), packing);
  }
  const std::int64_t offset =
      TextCursor("", "").Integer(array.Attribute("offset"), "the offset");
  std::string_view data = AppendedIn(bytes, array);
  if (offset < 0 || static_cast<std::size_t>(offset) >= data.size()) return "";
  data = data.substr(offset);
  const bool is_base64 = bytes.find("encoding=\"base64\"", array.end) <
                         static_cast<std::size_t>(data.data() - bytes.data());
  return is_base64 ? UnpackVtpArray("", DecodeBase64(data), packing)
                   : UnpackVtpArray("", data, packing);
}

}  // namespace

std::string VtpFieldText(std::string_view bytes, std::string_view name) {
  XmlTag tag, root;
  while (NextXmlTag(bytes, tag.end, &tag)) {
    if (tag.name() == "VTKFile") root = tag;
    if (tag.name() == "Piece" || tag.name() == "AppendedData") break;
    if (tag.is_closing() || tag.name() != "Array") continue;
    if (tag.Attribute("type") != "String" || tag.Attribute("Name") != name) {
      continue;
    }
    try {
      if (tag.Attribute("format") == "ascii") {
        return LettersOf(
            bytes.substr(tag.end, bytes.find('<', tag.end) - tag.end));
      }
      const std::string text = Unpacked(bytes, root, tag);
      return text.substr(0, text.find('\0'));
    } catch (const InputError&) {
      return "";
    }
  }
  return "";
}

}  // namespace musclewarp
