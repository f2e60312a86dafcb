// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How a struct meets the outside: by one list of its fields, each with its key,
// unit, text and range. What is written to a file and read from it, what a
// message or a page of the documentation says of a field, and which values are
// allowed all follow from the list; the default is that of the struct.
//
//   struct SurfacePatch {
//     double area = 0;
//     Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
//   };
//   constexpr auto FieldsOf(Described<SurfacePatch>) {
//     using S = SurfacePatch;
//     return std::make_tuple(
//         Field(&S::area, "area_mm2", "mm2").Text("area at rest").AtLeast(0),
//         Field(&S::place, "place_mm", "mm").Text("its centre"));
//   }
//
// A struct with a field that is not in its list does not compile.
// base/described_checks.h compares described structs and checks their values,
// base/described_json.h reads and writes them.

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "musclewarp/base/field_types.h"
#include "musclewarp/base/value_range.h"

namespace musclewarp {

// Says for which struct a function FieldsOf() has the list.
template <class Struct>
struct Described {};

// When a field is in a file.
enum class Presence {
  kAlways,
  kUnlessEmpty,  // not where it has no elements
  kNullIfEmpty,  // null where it has none
  kLater,        // always, but files of earlier builds may lack it
};

// What depends on a setting.
enum class Effect {
  kResults,  // what is computed
  kFiles,    // which of the results are written, and how
  kNothing,  // how long it takes, or where files are
};

// A field of a struct. `Access` is a pointer to the member, a pointer to a
// const member function without parameters that computes the value from
// others, or Inner().
template <class Access>
struct Field {
  static constexpr bool kIsWritten = true;
  Access access;
  const char* key;
  const char* unit;       // "mm", "mm2", "mm/rad", "ms", ... or ""
  const char* text = "";  // what it is, without a full stop
  ValueRange range;
  const char* choices = "";  // of a text, the allowed ones: "auto, never"
  bool is_path = false;      // true for a text that names a file or folder
  Presence presence = Presence::kAlways;
  Effect effect = Effect::kResults;

  constexpr Field(Access access_, const char* key_, const char* unit_ = "")
      : access(access_), key(key_), unit(unit_) {}

  // Return the same field with a text, another range or another presence.
  constexpr Field Text(const char* what) const {
    Field field = *this;
    field.text = what;
    return field;
  }
  constexpr Field AtLeast(double limit) const {
    return Within(limit, kInfinity);
  }
  constexpr Field Within(double from, double to) const {
    return With({from, to, /*is_open=*/false, range.also_allowed});
  }
  constexpr Field Above(double limit, double highest = kInfinity) const {
    return With({limit, highest, /*is_open=*/true, range.also_allowed});
  }
  constexpr Field Or(double value) const {
    return With({range.lowest, range.highest, range.is_open, value});
  }
  constexpr Field With(ValueRange other) const {
    Field field = *this;
    field.range = other;
    return field;
  }
  constexpr Field OneOf(const char* names) const {
    Field field = *this;
    field.choices = names;
    return field;
  }
  constexpr Field Path() const {
    Field field = *this;
    field.is_path = true;
    return field;
  }
  constexpr Field Changes(Effect what) const {
    Field field = *this;
    field.effect = what;
    return field;
  }
  constexpr Field UnlessEmpty() const { return With(Presence::kUnlessEmpty); }
  constexpr Field NullIfEmpty() const { return With(Presence::kNullIfEmpty); }
  constexpr Field Later() const { return With(Presence::kLater); }
  constexpr Field With(Presence other) const {
    Field field = *this;
    field.presence = other;
    return field;
  }
};

// A field that stays inside: it is neither written nor read.
template <class Access>
struct NotWritten {
  static constexpr bool kIsWritten = false;
  Access access;
  const char* unit;
  constexpr explicit NotWritten(Access access_, const char* unit_ = "")
      : access(access_), unit(unit_) {}
};

// The fields of a base, in the list of a struct that adds to them.
template <class Struct>
struct Inherited {};

// Access to a field of a field, for a key that stands beside those of the outer
// struct in a file.
template <class First, class Second>
struct InnerAccess {
  First first;
  Second second;

  template <class Struct>
  auto& operator()(Struct& object) const {
    return std::invoke(second, std::invoke(first, object));
  }
};
template <class First, class Second>
constexpr InnerAccess<First, Second> Inner(First first, Second second) {
  return {first, second};
}

// Returns the name of a field in C++ and Python: its key without the unit of a
// length, "max_step" for "max_step_mm".
template <class Access>
std::string NameOf(const Field<Access>& field) {
  const std::string key = field.key;
  for (const std::string suffix : {"_mm", "_mm2", "_mm3"}) {
    if (key.size() > suffix.size() &&
        key.compare(key.size() - suffix.size(), suffix.size(), suffix) == 0) {
      return key.substr(0, key.size() - suffix.size());
    }
  }
  return key;
}

template <class Access>
inline constexpr bool kIsComputed = std::is_member_function_pointer_v<Access>;

namespace described_internal {

template <class Access>
constexpr std::size_t NumOwn(const Field<Access>&) {
  return std::is_member_object_pointer_v<Access>;
}
template <class Access>
constexpr std::size_t NumOwn(const NotWritten<Access>&) {
  return 1;
}

template <class Base>
constexpr std::size_t NumOwn(const Inherited<Base>&) {
  return 1;
}

template <class T, class = void>
struct IsDescribed : std::false_type {};
template <class T>
struct IsDescribed<T, std::void_t<decltype(FieldsOf(Described<T>()))>>
    : std::true_type {};

}  // namespace described_internal

template <class T>
inline constexpr bool kIsDescribed = described_internal::IsDescribed<T>::value;
template <class Struct, class Visit>
void VisitList(const Visit& visit);

namespace described_internal {

template <class Entry, class Visit>
void VisitEntry(const Entry& entry, const Visit& visit) {
  visit(entry);
}
template <class Base, class Visit>
void VisitEntry(const Inherited<Base>& /*entry*/, const Visit& visit) {
  VisitList<Base>(visit);
}

}  // namespace described_internal

// Calls `visit` with everything in the list of a struct, in its order: with
// each Field and each NotWritten, those of its bases included.
template <class Struct, class Visit>
void VisitList(const Visit& visit) {
  constexpr auto list = FieldsOf(Described<Struct>());
  constexpr std::size_t listed = std::apply(
      [](const auto&... field) {
        return (std::size_t{0} + ... + described_internal::NumOwn(field));
      },
      list);
  static_assert(listed == described_internal::NumFields<Struct>(),
                "a field of the struct is not in its list, or there twice");
  std::apply(
      [&](const auto&... entry) {
        (described_internal::VisitEntry(entry, visit), ...);
      },
      list);
}

// Calls visit(field, value) with each Field of a struct and its value.
template <class Struct, class Visit>
void VisitFields(Struct&& object, const Visit& visit) {
  VisitList<std::decay_t<Struct>>([&](const auto& field) {
    if constexpr (std::decay_t<decltype(field)>::kIsWritten) {
      visit(field, std::invoke(field.access, object));
    }
  });
}

namespace described_internal {

template <class From, class To>
void CopyValue(const From& from, To* to) {
  if constexpr (std::is_assignable_v<To&, const From&>) {
    *to = from;
  } else {
    to->assign(from.begin(), from.end());
  }
}

template <class A, class B, class From, class To>
void CopyField(const A& a, const B& b, const From& from, To* to) {
  if constexpr (std::is_member_object_pointer_v<decltype(A::access)>) {
    CopyValue(std::invoke(a.access, from), &std::invoke(b.access, *to));
  }
}

}  // namespace described_internal

// Copies all fields of a struct to another one that has a list of the same
// fields. Elements of lists may be converted.
template <class From, class To>
void CopyFields(const From& from, To* to) {
  std::apply(
      [&](const auto&... a) {
        std::apply(
            [&](const auto&... b) {
              (described_internal::CopyField(a, b, from, to), ...);
            },
            FieldsOf(Described<To>()));
      },
      FieldsOf(Described<From>()));
}

}  // namespace musclewarp
