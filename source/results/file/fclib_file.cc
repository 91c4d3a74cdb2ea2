// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/fclib_file.h"

#include "results/file/hdf5_file.h"

#include "base/child_process.h"
#include "base/user_error.h"
#include "results/file/output_file.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace frictionbeam {

namespace {

/// Reads /fclib_local and checks what it reads.
class LocalReader {
public:
  explicit LocalReader(const std::string &path) : path(path), file(path, Hdf5File::Mode::read) {}

  contact::LocalProblem read() {
    if (!file.has("/fclib_local"))
      fail(file.has("/fclib_global")
               ? "It holds a global problem (/fclib_global). This program reads local ones, "
                 "/fclib_local: condense it to its contacts first, W = H^T M^-1 H."
               : "It has no group /fclib_local, in which FCLIB keeps a local friction-contact "
                 "problem. See with h5ls -r what it holds.");
    for (const char *name : {"V", "R"})
      if (file.has("/fclib_local/" + std::string(name)))
        fail("It has equality constraints (/fclib_local/" + std::string(name) +
             "), which this program does not solve. Eliminate them first: W - V R^-1 V^T in place "
             "of W where R can be inverted.");
    contact::LocalProblem problem;
    const int dimension = file.integer("/fclib_local/spacedim");
    if (dimension != 2 && dimension != 3)
      fail("/fclib_local/spacedim is " + std::to_string(dimension) +
           "; it must be 2 (normal, tangential) or 3 (normal, two tangential).");
    problem.dimension = dimension;
    const int n_rows = file.integer("/fclib_local/W/m"),
              n_columns = file.integer("/fclib_local/W/n");
    if (n_rows != n_columns || n_rows <= 0 || n_rows % dimension != 0)
      fail("W is " + std::to_string(n_rows) + " x " + std::to_string(n_columns) +
           "; it must be square, and its size a multiple of spacedim = " +
           std::to_string(dimension) + ", one block for each contact.");
    problem.q = read_vector("/fclib_local/vectors/q", n_rows); // before W: it proves the size
    read_matrix(n_rows, problem.W);
    problem.friction = read_vector("/fclib_local/vectors/mu", n_rows / dimension);
    for (int i = 0; i < n_rows / dimension; ++i)
      if (problem.friction[i] < 0.)
        fail("mu of contact " + std::to_string(i) + " (counted from 0) is " +
             std::to_string(problem.friction[i]) + "; it must be 0 or more.");
    for (int i = 0; i < n_rows; ++i)
      if (const double w = problem.W.coeff(i, i); w < 0.)
        fail("Entry " + std::to_string(i) + " (counted from 0) of the diagonal of W is " +
             std::to_string(w) + "; W must be positive semidefinite.");
    return problem;
  }

private:
  [[noreturn]] void fail(const std::string &text) const {
    throw UserError("The file '" + path + "' is not a problem that can be solved. " + text);
  }

  void check_size(const std::string &name, const std::size_t size, const std::size_t expected,
                  const std::string &why) const {
    if (size != expected)
      fail(name + " has " + std::to_string(size) + " entries; it must have " +
           std::to_string(expected) + ", " + why + ".");
  }

  Eigen::VectorXd read_vector(const std::string &name, const int size) const {
    const std::vector<double> values = file.numbers(name);
    check_size(name, values.size(), size,
               size * 1u == file.integer("/fclib_local/W/m") * 1u ? "one for each row of W"
                                                                  : "one for each contact");
    for (const double value : values)
      if (!std::isfinite(value))
        fail(name + " has an entry that is not finite.");
    return Eigen::Map<const Eigen::VectorXd>(values.data(), size);
  }

  void read_matrix(const int n, Eigen::SparseMatrix<double> &matrix) const {
    const std::string group = "/fclib_local/W/";
    const int kind = file.integer(group + "nz");
    if (kind < -2)
      fail(group + "nz is " + std::to_string(kind) +
           "; it must be -2 (compressed rows), -1 (compressed columns) or the number of triplets.");
    const std::vector<int> p = file.integers(group + "p"), inner = file.integers(group + "i");
    const std::vector<double> x = file.numbers(group + "x");
    std::vector<Eigen::Triplet<double>> triplets;
    const auto add = [&](const int row, const int column, const double value) {
      if (row < 0 || row >= n || column < 0 || column >= n)
        fail("W has an entry at row " + std::to_string(row) + ", column " + std::to_string(column) +
             " (counted from 0), outside of its " + std::to_string(n) + " rows and columns.");
      if (!std::isfinite(value))
        fail("W has an entry that is not finite.");
      triplets.emplace_back(row, column, value);
    };
    if (kind >= 0) {
      const std::size_t size = kind;
      if (p.size() < size || inner.size() < size || x.size() < size)
        fail("W has " + std::to_string(kind) + " triplets by its nz, but p, i and x have " +
             std::to_string(p.size()) + ", " + std::to_string(inner.size()) + " and " +
             std::to_string(x.size()) + " entries.");
      for (int t = 0; t < kind; ++t)
        add(p[t], inner[t], x[t]);
    } else {
      check_size(group + "p", p.size(), n + 1u, "one more than W has rows");
      if (p[0] != 0 || !std::is_sorted(p.begin(), p.end()))
        fail(group + "p must begin with 0 and never decrease.");
      const std::size_t size = p[n];
      if (inner.size() < size || x.size() < size)
        fail(group + "p ends with " + std::to_string(size) + ", but i and x have " +
             std::to_string(inner.size()) + " and " + std::to_string(x.size()) + " entries.");
      for (int outer = 0; outer < n; ++outer)
        for (int t = p[outer]; t < p[outer + 1]; ++t)
          kind == -2 ? add(outer, inner[t], x[t]) : add(inner[t], outer, x[t]);
    }
    matrix.resize(n, n);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
  }

  const std::string path;
  const Hdf5File file;
};

void write_matrix(Hdf5File &file, const std::string &group,
                  const Eigen::SparseMatrix<double> &matrix) {
  Eigen::SparseMatrix<double> compressed = matrix;
  compressed.makeCompressed();
  const int n = compressed.nonZeros(), n_columns = compressed.cols();
  file.make_group(group);
  file.write(group + "/m", static_cast<int>(compressed.rows()));
  file.write(group + "/n", n_columns);
  file.write(group + "/nz", -1); // compressed columns
  file.write(group + "/nzmax", n);
  const int *const p = compressed.outerIndexPtr(), *const i = compressed.innerIndexPtr();
  file.write(group + "/p", std::vector<int>(p, p + n_columns + 1));
  file.write(group + "/i", std::vector<int>(i, i + n));
  file.write(group + "/x", Eigen::VectorXd(Eigen::Map<Eigen::VectorXd>(compressed.valuePtr(), n)));
}

void write_info(Hdf5File &file, const std::string &group, const std::string &title,
                const std::string &description) {
  file.make_group(group);
  file.write(group + "/title", title);
  file.write(group + "/description", description);
}

std::string damaged(const std::string &path, const std::string &trouble) {
  return "The file '" + path + "' is damaged.\n  read:    HDF5, at work on it, " + trouble +
         "\n  allowed: a file that HDF5 reads and changes to its end\n  try:     the file as it "
         "was "
         "before it was damaged; h5ls -r shows what it holds";
}

void put_solution(const std::string &path, const contact::LocalSolution &solution) {
  Hdf5File file(path, Hdf5File::Mode::change);
  if (file.has("/solution"))
    file.remove("/solution");
  file.make_group("/solution");
  file.write("/solution/u", solution.motions);
  file.write("/solution/r", solution.reactions);
  file.write_attribute("/solution", "natural map", solution.residual.natural_map);
  file.write_attribute("/solution", "converged", solution.converged ? 1. : 0.);
  file.flush();
}

} // namespace

void try_contact_file(const std::string &path) {
  const std::string trouble = run_in_child([&]() -> std::string {
                                try {
                                  const unsigned int n = LocalReader(path).read().q.size();
                                  read_contact_reactions(path, n);
                                } catch (const UserError &) { // the caller will meet it again
                                }
                                return "";
                              }).trouble;
  if (!trouble.empty())
    throw UserError(damaged(path, trouble));
}

contact::LocalProblem read_local_contact_problem(const std::string &path) {
  return LocalReader(path).read();
}

std::optional<Eigen::VectorXd> read_contact_reactions(const std::string &path,
                                                      const unsigned int n) {
  const Hdf5File file(path, Hdf5File::Mode::read);
  if (!file.has("/solution/r"))
    return {};
  const std::vector<double> values = file.numbers("/solution/r");
  const Eigen::VectorXd result = Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
  if (values.size() != n || !result.allFinite())
    return {};
  return result;
}

void replace_contact_solution(const std::string &path, const contact::LocalSolution &solution) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path original = fs::canonical(path, error);
  const fs::path copy = original.string() + ".new-" + std::to_string(getpid());
  if (!error)
    fs::copy_file(original, copy, fs::copy_options::overwrite_existing, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(copy, error); // what there is of it
    throw OutputError("The solution cannot be written: no copy of '" + path +
                      "' can be made beside it: " + reason +
                      ". The file is as it was. Move it to a folder that may be written to, on a "
                      "disk that is not full.");
  }
  const ChildEnd end = run_in_child([&]() -> std::string {
    try {
      put_solution(copy.string(), solution);
    } catch (const OutputError &failure) {
      return failure.what();
    } catch (const UserError &failure) {
      return failure.what();
    }
    return "";
  });
  if (!end.trouble.empty() || !end.text.empty())
    fs::remove(copy, error);
  if (!end.trouble.empty())
    throw UserError(damaged(path, end.trouble));
  if (!end.text.empty())
    throw OutputError(end.text);
  fs::rename(copy, original, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(copy, error);
    throw OutputError("The solution cannot be written to '" + path + "': " + reason + ".");
  }
}

void write_local_contact_problem(const std::string &path, const contact::LocalProblem &problem,
                                 const Eigen::VectorXd &reactions, const std::string &title,
                                 const std::string &description) {
  Hdf5File file(path, Hdf5File::Mode::create);
  file.make_group("/fclib_local");
  file.write("/fclib_local/spacedim", static_cast<int>(problem.dimension));
  write_matrix(file, "/fclib_local/W", problem.W);
  file.make_group("/fclib_local/vectors");
  file.write("/fclib_local/vectors/q", problem.q);
  file.write("/fclib_local/vectors/mu", problem.friction);
  write_info(file, "/fclib_local/info", title, description);
  file.make_group("/solution");
  file.write("/solution/u", Eigen::VectorXd(problem.W * reactions + problem.q));
  file.write("/solution/r", reactions);
  file.flush();
}

void write_global_contact_problem(const std::string &path, const GlobalContactProblem &problem,
                                  const std::string &title, const std::string &description) {
  Hdf5File file(path, Hdf5File::Mode::create);
  file.make_group("/fclib_global");
  file.write("/fclib_global/spacedim", 3);
  write_matrix(file, "/fclib_global/M", problem.M);
  write_matrix(file, "/fclib_global/H", problem.H);
  file.make_group("/fclib_global/vectors");
  file.write("/fclib_global/vectors/f", problem.f);
  file.write("/fclib_global/vectors/w", problem.w);
  file.write("/fclib_global/vectors/mu", problem.friction);
  write_info(file, "/fclib_global/info", title, description);
  file.make_group("/solution");
  file.write("/solution/v", problem.solution);
  file.write("/solution/u", problem.motions(problem.solution));
  file.write("/solution/r", problem.reactions);
  file.flush();
}

} // namespace frictionbeam
