// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How a struct is written to an archive of cereal, and read from it: field by
// field, each by its name.
//
//   struct Sphere { Eigen::RowVector3d centre; double radius; };
//   MUSCLEWARP_ARCHIVE(Sphere, centre, radius)
//
// The order in an archive is that of the list, whatever the order in the
// struct, and ArchivedFields() gives the list with the types, which a file
// states: one whose fields differ in name, type or order is not read. A struct
// with a field that is not in the list does not compile.

#include <boost/preprocessor/seq/for_each.hpp>
#include <boost/preprocessor/stringize.hpp>
#include <boost/preprocessor/variadic/to_seq.hpp>
#include <string>
#include <typeinfo>
#include <utility>

namespace musclewarp {

// Returns the names and types of the fields of all structs that are archived,
// in the order of their lists.
inline std::string& ArchivedFields() {
  static std::string fields;
  return fields;
}

// Adds a struct to ArchivedFields().
struct ArchivedStruct {
  explicit ArchivedStruct(const std::string& name) {
    ArchivedFields() += name + "\n";
  }
  ArchivedStruct& Field(const char* name, const std::type_info& type) {
    ArchivedFields() += std::string("  ") + name + " " + type.name() + "\n";
    return *this;
  }
};

}  // namespace musclewarp

#define MUSCLEWARP_ARCHIVE_ONE(r, object, field) archive(object.field);
#define MUSCLEWARP_ARCHIVE_NAME(r, type, field) \
  .Field(BOOST_PP_STRINGIZE(field), typeid(decltype(type::field)))

// The structured binding counts the fields of the struct.
#define MUSCLEWARP_ARCHIVE_FIELDS(type, all, seq)                             \
  template <class Archive>                                                    \
  void serialize(Archive& archive, type& object) {                            \
    { [[maybe_unused]] const auto& all = object; }                            \
    BOOST_PP_SEQ_FOR_EACH(MUSCLEWARP_ARCHIVE_ONE, object, seq)                \
  }                                                                           \
  inline const ArchivedStruct kArchivedFieldsOf##type = ArchivedStruct(#type) \
      BOOST_PP_SEQ_FOR_EACH(MUSCLEWARP_ARCHIVE_NAME, type, seq);

#define MUSCLEWARP_BRACKETS(...) [__VA_ARGS__]
#define MUSCLEWARP_ARCHIVE(type, ...)                         \
  MUSCLEWARP_ARCHIVE_FIELDS(type,                             \
                            MUSCLEWARP_BRACKETS(__VA_ARGS__), \
                            BOOST_PP_VARIADIC_TO_SEQ(__VA_ARGS__))

// The same for a struct of which the fields `without`, a list in parentheses,
// are not archived.
#define MUSCLEWARP_UNPACKED(...) __VA_ARGS__
#define MUSCLEWARP_ARCHIVE_WITHOUT(type, without, ...)               \
  MUSCLEWARP_ARCHIVE_FIELDS(                                         \
      type,                                                          \
      MUSCLEWARP_BRACKETS(MUSCLEWARP_UNPACKED without, __VA_ARGS__), \
      BOOST_PP_VARIADIC_TO_SEQ(__VA_ARGS__))
