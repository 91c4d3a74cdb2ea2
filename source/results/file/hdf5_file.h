// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <hdf5.h>

#include <string>
#include <vector>

namespace frictionbeam {

/// An HDF5 identifier that is closed with its own function.
class Hdf5Handle {
public:
  Hdf5Handle(const hid_t id, herr_t (*close)(hid_t)) : id(id), close(close) {}
  ~Hdf5Handle() {
    if (id >= 0)
      close(id);
  }
  Hdf5Handle(const Hdf5Handle &) = delete;
  Hdf5Handle &operator=(const Hdf5Handle &) = delete;

  operator hid_t() const { return id; }

private:
  const hid_t id;
  herr_t (*const close)(hid_t);
};

/// While it lives, HDF5 keeps its own error messages to itself.
class Hdf5Silence {
public:
  Hdf5Silence() {
    H5Eget_auto2(H5E_DEFAULT, &function, &data);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, function, data); }
  Hdf5Silence(const Hdf5Silence &) = delete;
  Hdf5Silence &operator=(const Hdf5Silence &) = delete;

private:
  H5E_auto2_t function = nullptr;
  void *data = nullptr;
};

/// A file of groups and one-dimensional data sets. Names are full paths within it. Whatever fails
/// is a UserError that names the file and the data set.
class Hdf5File {
public:
  enum class Mode { read, change, create };

  Hdf5File(const std::string &path, const Mode mode);

  bool has(const std::string &name) const;
  std::vector<int> integers(const std::string &name) const;
  int integer(const std::string &name) const;
  std::vector<double> numbers(const std::string &name) const;

  void make_group(const std::string &name);
  void remove(const std::string &name);
  void write(const std::string &name, const std::vector<int> &values);
  void write(const std::string &name, const int value) { write(name, std::vector<int>{value}); }
  void write(const std::string &name, const Eigen::VectorXd &values);
  void write(const std::string &name, const std::string &text);
  /// An attribute of a group.
  void write_attribute(const std::string &group, const std::string &name, const double value);
  /// Hand everything to the system.
  void flush();

private:
  std::size_t size(const hid_t dataset, const std::string &name) const;
  void write(const std::string &name, const hid_t type, const hid_t space, const void *values);
  [[noreturn]] void fail_to_write(const std::string &name) const;

  const std::string path;
  const Hdf5Silence silence;
  const Hdf5Handle file;
};

} // namespace frictionbeam
