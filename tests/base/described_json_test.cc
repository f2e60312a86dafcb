// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/described_json.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

enum class Colour { kRed, kBlue };
std::string ToString(Colour colour) {
  switch (colour) {
    case Colour::kRed:
      return "red";
    case Colour::kBlue:
      return "blue";
  }
  return "unknown";
}

struct Odd {
  double number = 1;
  int count = 0;
  bool is_so = false;
  std::string text;
  Colour colour = Colour::kRed;
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
  std::vector<double> list;
  std::vector<std::string> optional_list;
  std::map<std::string, std::vector<double>> by_name;
  std::string reason;
  double later = 7;
};
constexpr auto FieldsOf(Described<Odd>) {
  using S = Odd;
  return std::make_tuple(
      Field(&S::number, "number"),
      Field(&S::count, "count"),
      Field(&S::is_so, "is_so"),
      Field(&S::text, "text"),
      Field(&S::colour, "colour"),
      Field(&S::place, "place_mm", "mm"),
      Field(&S::list, "list"),
      Field(&S::optional_list, "optional_list").UnlessEmpty(),
      Field(&S::by_name, "by_name"),
      Field(&S::reason, "reason").NullIfEmpty(),
      Field(&S::later, "later").Later());
}

Odd SomeOdd() {
  Odd odd;
  odd.number = 1.0 / 3;
  odd.count = std::numeric_limits<int>::min();
  odd.is_so = true;
  odd.text = "a \"quoted\"\nline, \t\\ and \xc3\xa9";
  odd.colour = Colour::kBlue;
  odd.place << -0.0, 5e-324, 1e300;
  odd.list = {kInfinity, -kInfinity, 0};
  odd.optional_list = {""};
  odd.by_name = {{"", {}}, {"with \"quotes\"\n", {1}}};
  odd.reason = "x";
  odd.later = -1;
  return odd;
}

Odd ReadText(const std::string& text) {
  Odd odd;
  ReadJson(OrderedJson::parse(text), {nullptr, "file.json"}, &odd);
  return odd;
}

TEST(DescribedJson, WritesWhatItReads) {
  for (const Odd& odd : {Odd(), SomeOdd()}) {
    const std::string text = JsonOf(odd).dump();
    EXPECT_TRUE(AreEqual(ReadText(text), odd)) << text;
    EXPECT_EQ(JsonOf(ReadText(text)).dump(), text);
  }
}

TEST(DescribedJson, LeavesOutWhatIsEmpty) {
  const OrderedJson json = JsonOf(Odd());
  EXPECT_FALSE(json.contains("optional_list"));
  EXPECT_TRUE(json.at("reason").is_null());
  EXPECT_EQ(json.begin().key(), "number");
}

TEST(DescribedJson, TakesTheDefaultOfAFieldThatCameLater) {
  OrderedJson json = JsonOf(SomeOdd());
  json.erase("later");
  EXPECT_EQ(ReadText(json.dump()).later, 7);
}

TEST(DescribedJson, RefusesWhatIsNoNumber) {
  Odd odd;
  odd.list = {0, std::nan("")};
  ExpectInputError([&] { ReadText(JsonOf(odd).dump()); },
                   {"file.json.list[1]", "is null", "give a number"});
}

TEST(DescribedJson, NamesThePlaceOfWhatIsWrong) {
  const auto refused = [](const char* key, const OrderedJson& value) {
    OrderedJson json = JsonOf(Odd());
    json[key] = value;
    ExpectInputError([&] { ReadText(json.dump()); }, {"file.json", key, "is "});
  };
  refused("number", "1");
  refused("count", 1.5);
  refused("count", 3e9);
  refused("is_so", 1);
  refused("text", 1);
  refused("colour", "green");
  refused("place_mm", {1, 2});
  refused("list", OrderedJson::object());
  refused("by_name", {1});
  OrderedJson json = JsonOf(Odd());
  json.erase("text");
  ExpectInputError([&] { ReadText(json.dump()); },
                   {"file.json.text", "is missing"});
}

}  // namespace
}  // namespace musclewarp
