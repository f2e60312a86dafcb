// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The number of the fields of a struct, and the kinds of their types, at
// compile time: for the lists of base/described.h.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace musclewarp {

namespace described_internal {

// Stands for a field of any type while fields are counted.
struct AnyField {
  // Never called. Implicit, as it has to fit wherever a value does.
  template <class T>
  operator T() const;  // NOLINT(google-explicit-constructor)
};

template <class Struct, class Indices, class = void>
struct HasFields : std::false_type {};
template <class Struct, std::size_t... I>
struct HasFields<
    Struct,
    std::index_sequence<I...>,
    std::void_t<decltype(Struct{(static_cast<void>(I), AnyField())...})>>
    : std::true_type {};

template <class Struct, std::size_t N = 0>
constexpr std::size_t NumFields() {
  if constexpr (HasFields<Struct, std::make_index_sequence<N + 1>>::value) {
    return NumFields<Struct, N + 1>();
  } else {
    return N;
  }
}

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};

template <class T>
struct IsMap : std::false_type {};
template <class T>
struct IsMap<std::map<std::string, T>> : std::true_type {};

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

}  // namespace described_internal

template <class T>
inline constexpr bool kIsVector = described_internal::IsVector<T>::value;
template <class T>
inline constexpr bool kIsMap = described_internal::IsMap<T>::value;

// True for what may have no elements: lists, maps and texts.
template <class T>
inline constexpr bool kCanBeEmpty =
    kIsVector<T> || kIsMap<T> || std::is_same_v<T, std::string>;
template <class T>
inline constexpr bool kIsOptional = described_internal::IsOptional<T>::value;

}  // namespace musclewarp
