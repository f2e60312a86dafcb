// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/xml_text.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using std::string;

// "<ü€𝄞>" in the encodings that have them.
const char kUtf8[] = "<\xc3\xbc\xe2\x82\xac\xf0\x9d\x84\x9e>";

string Declared(const string& encoding) {
  return "<?xml version=\"1.0\" encoding=\"" + encoding + "\"?>";
}

string Decoded(const string& bytes, bool is_guessed = false) {
  const XmlText text = DecodeXml(bytes);
  EXPECT_EQ(text.is_guessed, is_guessed);
  return text.utf8;
}

TEST(DecodeXml, KeepsUtf8) {
  EXPECT_EQ(Decoded(kUtf8), kUtf8);
  EXPECT_EQ(Decoded(string("\xef\xbb\xbf") + kUtf8), kUtf8);
  // Whatever the file names.
  const string text = Declared("ISO-8859-1") + kUtf8;
  EXPECT_EQ(Decoded(text), text);
  EXPECT_EQ(Decoded(""), "");
}

TEST(DecodeXml, TakesUtf16WithAMarkAndWithout) {
  const string little("<\0\xfc\0\xac\x20\x34\xd8\x1e\xdd>\0", 12);
  string big;
  for (size_t i = 0; i < little.size(); i += 2) {
    big += {little[i + 1], little[i]};
  }
  EXPECT_EQ(Decoded(little), kUtf8);
  EXPECT_EQ(Decoded(big), kUtf8);
  EXPECT_EQ(Decoded("\xff\xfe" + little), kUtf8);
  EXPECT_EQ(Decoded("\xfe\xff" + big), kUtf8);
  // Half of a pair is no character.
  EXPECT_EQ(Decoded(string("<\0\x34\xd8>\0", 6)), "<\xef\xbf\xbd>");
}

TEST(DecodeXml, TakesOneByteACharacterAsItIsNamed) {
  for (const char* name : {"ISO-8859-1", "iso-8859-1", "latin1"}) {
    EXPECT_EQ(Decoded(Declared(name) + "\xfc"), Declared(name) + "\xc3\xbc");
  }
  const string windows = "<?xml version='1.0' encoding='Windows-1252'?>";
  EXPECT_EQ(Decoded(windows + "\xfc\x80"), windows + "\xc3\xbc\xe2\x82\xac");
}

TEST(DecodeXml, GuessesLatin1OfWhatIsNeitherUtf8NorNamed) {
  EXPECT_EQ(Decoded("<\xfc>", true), "<\xc3\xbc>");
  EXPECT_EQ(Decoded(Declared("UTF-8") + "\xfc", true),
            Declared("UTF-8") + "\xc3\xbc");
  EXPECT_EQ(Decoded(Declared("x") + "\xfc", true), Declared("x") + "\xc3\xbc");
  // A slash in two bytes, half of a pair, beyond Unicode, and a cut character:
  // readers of XML take none of them.
  for (const char* bytes : {"\xc0\xaf",
                            "\xe0\x80\xaf",
                            "\xed\xa0\x80",
                            "\xf4\x90\x80\x80",
                            "\xc3"}) {
    EXPECT_TRUE(DecodeXml(bytes).is_guessed);
  }
}

TEST(WithUtf8Declaration, NamesUtf8IfAnythingElseIsNamed) {
  for (const char* name : {"ISO-8859-1", "windows-1252", "UTF-16", "utf8"}) {
    EXPECT_EQ(WithUtf8Declaration(Declared(name) + "<a/>"),
              Declared("UTF-8") + "<a/>");
  }
  for (const string text : {"<a encoding=\"x\"/>",
                            "<?xml version=\"1.0\"?><a encoding=\"x\"/>",
                            "<?xml version='1.0' encoding='utf-8'?><a/>",
                            "<?xml encoding="}) {
    EXPECT_EQ(WithUtf8Declaration(text), text);
  }
}

TEST(XmlEscaped, NothingEndsTheTextOrTheAttribute) {
  EXPECT_EQ(XmlEscaped("a & \"b\" < c"), "a &amp; &quot;b&quot; &lt; c");
}

}  // namespace
}  // namespace musclewarp
