// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/exceptions.h>

#include <Eigen/Core>

#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace frictionbeam {

/**
 * Puts values into a string of bytes, or gets them back, to the last bit: archive(a, b) goes
 * through a and b in this order, and one function says for both ways what a type consists of. A
 * type that is no number, plain struct of numbers, string, vector, pair, optional or Eigen matrix
 * has a member transfer(Archive &), or a function transfer(Archive &, Type &) beside it. The bytes
 * are those of this machine.
 */
class Archive {
public:
  Archive() = default;                                                           ///< to write
  explicit Archive(std::string bytes) : is_read(true), data(std::move(bytes)) {} ///< to read

  bool reads() const { return is_read; }
  const std::string &bytes() const { return data; }
  bool at_end() const { return place == data.size(); } ///< of what is read

  template <typename... Values>
  void operator()(Values &...values) {
    (go(values), ...);
  }

private:
  template <typename Type, typename = void>
  struct HasMember : std::false_type {};
  template <typename Type>
  struct HasMember<
      Type, std::void_t<decltype(std::declval<Type &>().transfer(std::declval<Archive &>()))>>
      : std::true_type {};
  template <typename Type, typename = void>
  struct HasFunction : std::false_type {};
  template <typename Type>
  struct HasFunction<
      Type, std::void_t<decltype(transfer(std::declval<Archive &>(), std::declval<Type &>()))>>
      : std::true_type {};

  void go_raw(void *const values, const std::size_t size) {
    if (!is_read)
      data.append(static_cast<const char *>(values), size);
    else {
      AssertThrow(size <= data.size() - place, dealii::ExcMessage("The archive is too short."));
      if (size > 0)
        std::memcpy(values, data.data() + place, size);
      place += size;
    }
  }

  std::size_t go_size(std::size_t size) {
    go_raw(&size, sizeof(size));
    AssertThrow(!is_read || size <= data.size(), dealii::ExcMessage("The archive is damaged."));
    return size;
  }

  template <typename Type>
  void go(Type &value) {
    if constexpr (HasMember<Type>::value)
      value.transfer(*this);
    else if constexpr (HasFunction<Type>::value)
      transfer(*this, value);
    else {
      static_assert(std::is_trivially_copyable_v<Type> && !std::is_pointer_v<Type>,
                    "this type needs a function transfer(Archive &, Type &)");
      go_raw(&value, sizeof(value));
    }
  }

  void go(std::string &text) {
    text.resize(go_size(text.size()));
    go_raw(text.data(), text.size());
  }

  template <typename Type>
  void go(std::vector<Type> &values) {
    values.resize(go_size(values.size()));
    if constexpr (std::is_arithmetic_v<Type>)
      go_raw(values.data(), values.size() * sizeof(Type));
    else
      for (Type &value : values)
        go(value);
  }

  template <typename First, typename Second>
  void go(std::pair<First, Second> &values) {
    go(values.first);
    go(values.second);
  }

  template <typename Type>
  void go(std::optional<Type> &value) {
    bool is_there = value.has_value();
    go(is_there);
    if (is_read)
      value = is_there ? std::optional<Type>(Type()) : std::nullopt;
    if (is_there)
      go(*value);
  }

  template <typename Number, int rows, int columns, int options, int most_rows, int most_columns>
  void go(Eigen::Matrix<Number, rows, columns, options, most_rows, most_columns> &matrix) {
    if constexpr (rows == Eigen::Dynamic || columns == Eigen::Dynamic) {
      const std::size_t n_rows = go_size(matrix.rows()), n_columns = go_size(matrix.cols());
      matrix.resize(n_rows, n_columns);
    }
    go_raw(matrix.data(), matrix.size() * sizeof(Number));
  }

  bool is_read = false;
  std::string data;
  std::size_t place = 0;
};

} // namespace frictionbeam
