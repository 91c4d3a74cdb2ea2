// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/hdf5_file.h"

#include "base/user_error.h"
#include "results/file/output_file.h"

#include <algorithm>
#include <filesystem>

namespace frictionbeam {

namespace {

/// Files to be written are in memory until flush(): HDF5 ends the process where a disk is full.
hid_t open(const std::string &path, const Hdf5File::Mode mode) {
  if (mode == Hdf5File::Mode::read)
    return H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  constexpr std::size_t growth = 1 << 16;
  const Hdf5Handle in_memory(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(in_memory, growth, false);
  return mode == Hdf5File::Mode::create
             ? H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, in_memory)
             : H5Fopen(path.c_str(), H5F_ACC_RDWR, in_memory);
}

} // namespace

Hdf5File::Hdf5File(const std::string &path, const Mode mode)
    : path(path), file(open(path, mode), H5Fclose) {
  if (file >= 0)
    return;
  if (mode == Mode::create)
    throw OutputError(
        "The file '" + path +
        "' cannot be written. See to it that its folder may be written to and that the "
        "disk is not full.");
  if (!std::filesystem::exists(path))
    throw UserError("There is no file '" + path + "'. Give the path of an FCLIB file (HDF5).");
  throw UserError("The file '" + path +
                  "' cannot be opened as HDF5, the format of FCLIB files. Look at it with h5ls, "
                  "and see whether it may be read and is complete.");
}

bool Hdf5File::has(const std::string &name) const {
  // Each part of the path must exist before the next may be asked for.
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    if (H5Lexists(file, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
      return false;
    if (end == std::string::npos)
      return true;
  }
}

std::size_t Hdf5File::size(const hid_t dataset, const std::string &name) const {
  if (dataset < 0)
    throw UserError("The file '" + path + "' has no data set '" + name +
                    "'. FCLIB's format needs it; see doc/fclib.md for what it needs, and h5ls -r "
                    "for what the file has.");
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  const hssize_t n = H5Sget_simple_extent_npoints(space);
  // Deflate, the densest filter, makes at most 1032 bytes of one.
  constexpr double most_of_a_byte = 1032.;
  std::error_code none;
  if (n < 0 || n > most_of_a_byte * std::filesystem::file_size(path, none))
    throw UserError("'" + name + "' of the file '" + path + "' has " + std::to_string(n) +
                    " entries by its heading, more than the file can hold. Look at it with h5ls "
                    "-r; write it again.");
  return n;
}

std::vector<int> Hdf5File::integers(const std::string &name) const {
  const Hdf5Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  std::vector<int> values(size(dataset, name));
  if (H5Dread(dataset, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    throw UserError("'" + name + "' of the file '" + path + "' does not hold integers.");
  return values;
}

int Hdf5File::integer(const std::string &name) const {
  const std::vector<int> values = integers(name);
  if (values.size() != 1)
    throw UserError("'" + name + "' of the file '" + path + "' holds " +
                    std::to_string(values.size()) + " integers; it must be one.");
  return values[0];
}

std::vector<double> Hdf5File::numbers(const std::string &name) const {
  const Hdf5Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  std::vector<double> values(size(dataset, name));
  if (H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    throw UserError("'" + name + "' of the file '" + path + "' does not hold numbers.");
  return values;
}

void Hdf5File::fail_to_write(const std::string &name) const {
  throw OutputError("'" + name + "' cannot be written to the file '" + path +
                    "'. See to it that it may be written to and that the disk is not full.");
}

void Hdf5File::make_group(const std::string &name) {
  const Hdf5Handle group(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Gclose);
  if (group < 0)
    fail_to_write(name);
}

void Hdf5File::remove(const std::string &name) {
  if (H5Ldelete(file, name.c_str(), H5P_DEFAULT) < 0)
    fail_to_write(name);
}

void Hdf5File::write(const std::string &name, const hid_t type, const hid_t space,
                     const void *values) {
  const Hdf5Handle dataset(
      H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  if (dataset < 0 || H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
    fail_to_write(name);
}

void Hdf5File::write(const std::string &name, const std::vector<int> &values) {
  const hsize_t n = values.size();
  const Hdf5Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
  write(name, H5T_NATIVE_INT, space, values.data());
}

void Hdf5File::write(const std::string &name, const Eigen::VectorXd &values) {
  const hsize_t n = values.size();
  const Hdf5Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
  write(name, H5T_NATIVE_DOUBLE, space, values.data());
}

void Hdf5File::write(const std::string &name, const std::string &text) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, text.size() + 1);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  write(name, type, space, text.c_str());
}

void Hdf5File::write_attribute(const std::string &group, const std::string &name,
                               const double value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(H5Acreate_by_name(file, group.c_str(), name.c_str(), H5T_NATIVE_DOUBLE,
                                               space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  if (attribute < 0 || H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
    fail_to_write(group);
}

void Hdf5File::flush() {
  if (H5Fflush(file, H5F_SCOPE_GLOBAL) < 0)
    fail_to_write("/");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  std::string bytes(std::max<ssize_t>(size, 0), '\0');
  if (size <= 0 || H5Fget_file_image(file, bytes.data(), bytes.size()) != size)
    fail_to_write("/");
  write_file(path, bytes);
}

} // namespace frictionbeam
