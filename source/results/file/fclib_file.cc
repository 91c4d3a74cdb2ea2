// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/fclib_file.h"

#include "results/file/hdf5_file.h"

#include "base/child_process.h"
#include "base/number_text.h"
#include "base/user_error.h"
#include "results/file/output_file.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace frictionbeam {

namespace {

constexpr const char *local_group = "/fclib_local", *global_group = "/fclib_global";

/// Reads one of the groups that FCLIB keeps problems in, and checks what it reads.
class ProblemReader {
public:
  ProblemReader(const std::string &path, const std::string &group)
      : path(path), group(group + "/"), file(path, Hdf5File::Mode::read) {}

  contact::LocalProblem read_local() const {
    refuse_equalities({"V", "R"}, "Eliminate them first: W - V R^-1 V^T in place of W where R can "
                                  "be inverted.");
    contact::LocalProblem problem;
    problem.dimension = read_dimension();
    const int n = n_columns_of("W", problem.dimension);
    if (const int n_rows = size("W", "m"); n_rows != n)
      fail("W is " + std::to_string(n_rows) + " x " + std::to_string(n) +
           "; it must be square, and its size a multiple of spacedim = " +
           std::to_string(problem.dimension) + ", one block for each contact.");
    problem.q = read_vector("q", n, "one for each row of W"); // before W: it proves the size
    problem.W = read_matrix("W", n, n);
    problem.friction = read_friction(n / problem.dimension);
    for (int i = 0; i < n; ++i)
      check_diagonal("W", i, problem.W.coeff(i, i));
    check_symmetric("W", problem.W);
    return problem;
  }

  GlobalContactProblem read_global() const {
    refuse_equalities({"G"}, "Eliminate them first, or give the held unknowns a stiffness in M.");
    GlobalContactProblem problem;
    problem.dimension = read_dimension();
    const int n = n_columns_of("H", problem.dimension), n_unknowns = size("M", "m");
    if (n_unknowns <= 0 || size("M", "n") != n_unknowns || size("H", "m") != n_unknowns)
      fail("M is " + std::to_string(n_unknowns) + " x " + std::to_string(size("M", "n")) +
           ", H has " + std::to_string(size("H", "m")) +
           " rows; M must be square, and H have a row for each of its rows.");
    problem.f = read_vector("f", n_unknowns, "one for each row of M");
    problem.w = read_vector("w", n, "one for each column of H");
    problem.M = read_matrix("M", n_unknowns, n_unknowns);
    problem.H = read_matrix("H", n_unknowns, n);
    problem.friction = read_friction(n / problem.dimension);
    for (int i = 0; i < n_unknowns; ++i)
      check_diagonal("M", i, problem.M.coeff(i, i));
    check_symmetric("M", problem.M);
    problem.M = SparseMatrix(problem.M + SparseMatrix(problem.M.transpose())) / 2.; // its pattern
    return problem;
  }

private:
  [[noreturn]] void fail(const std::string &text) const {
    throw UserError("The file '" + path + "' is not a problem that can be solved. " + text);
  }

  void refuse_equalities(const std::vector<std::string> &names, const std::string &remedy) const {
    for (const std::string &name : names)
      if (file.has(group + name))
        fail("It has equality constraints (" + group + name +
             "), which this program does not solve. " + remedy);
  }

  int size(const std::string &matrix, const std::string &which) const {
    return file.integer(group + matrix + "/" + which);
  }

  int read_dimension() const {
    const int dimension = file.integer(group + "spacedim");
    if (dimension != 2 && dimension != 3)
      fail(group + "spacedim is " + std::to_string(dimension) +
           "; it must be 2 (normal, tangential) or 3 (normal, two tangential).");
    return dimension;
  }

  int n_columns_of(const std::string &matrix, const int dimension) const {
    const int n = size(matrix, "n");
    if (n <= 0 || n % dimension != 0)
      fail(matrix + " has " + std::to_string(n) +
           " columns; there must be a multiple of spacedim = " + std::to_string(dimension) +
           ", as many for each contact.");
    return n;
  }

  void check_diagonal(const std::string &name, const int i, const double entry) const {
    if (entry < 0.)
      fail("Entry " + std::to_string(i) + " (counted from 0) of the diagonal of " + name + " is " +
           std::to_string(entry) + "; " + name + " must be positive semidefinite.");
  }

  /// To 1e-8 of the matrix, as the solver asks for.
  void check_symmetric(const std::string &name, const SparseMatrix &matrix) const {
    const SparseMatrix apart = matrix - SparseMatrix(matrix.transpose());
    if (!(apart.norm() > 1e-8 * matrix.norm()))
      return;
    int row = 0, column = 0;
    double most = 0.;
    for (int j = 0; j < apart.outerSize(); ++j)
      for (SparseMatrix::InnerIterator entry(apart, j); entry; ++entry)
        if (std::abs(entry.value()) > most) {
          most = std::abs(entry.value());
          row = std::min(entry.row(), entry.col());
          column = std::max(entry.row(), entry.col());
        }
    const auto place = [&](const int i, const int j) {
      return rounded_number(matrix.coeff(i, j), 6) + " in row " + std::to_string(i) + ", column " +
             std::to_string(j);
    };
    fail(name + " is not symmetric: it has " + place(row, column) + " and " + place(column, row) +
         " (counted from 0), where a symmetric " + name + " has the same. See that " +
         (name == "W" ? "W = H^T M^-1 H is taken with one H on both sides, and u = W r + q with "
                        "motions and forces along the same axes."
                      : "both of its triangles are written."));
  }

  void check_size(const std::string &name, const std::size_t size, const std::size_t expected,
                  const std::string &why) const {
    if (size != expected)
      fail(name + " has " + std::to_string(size) + " entries; it must have " +
           std::to_string(expected) + ", " + why + ".");
  }

  Eigen::VectorXd read_vector(const std::string &name, const int size,
                              const std::string &why) const {
    const std::string full_name = group + "vectors/" + name;
    const std::vector<double> values = file.numbers(full_name);
    check_size(full_name, values.size(), size, why);
    for (const double value : values)
      if (!std::isfinite(value))
        fail(full_name + " has an entry that is not finite.");
    return Eigen::Map<const Eigen::VectorXd>(values.data(), size);
  }

  Eigen::VectorXd read_friction(const int n_contacts) const {
    const Eigen::VectorXd friction = read_vector("mu", n_contacts, "one for each contact");
    for (int i = 0; i < n_contacts; ++i)
      if (friction[i] < 0.)
        fail("mu of contact " + std::to_string(i) + " (counted from 0) is " +
             std::to_string(friction[i]) + "; it must be 0 or more.");
    return friction;
  }

  Eigen::SparseMatrix<double> read_matrix(const std::string &name, const int n_rows,
                                          const int n_columns) const {
    const std::string of_matrix = group + name + "/";
    const int kind = file.integer(of_matrix + "nz");
    if (kind < -2)
      fail(of_matrix + "nz is " + std::to_string(kind) +
           "; it must be -2 (compressed rows), -1 (compressed columns) or the number of triplets.");
    const std::vector<int> p = file.integers(of_matrix + "p"),
                           inner = file.integers(of_matrix + "i");
    const std::vector<double> x = file.numbers(of_matrix + "x");
    std::vector<Eigen::Triplet<double>> triplets;
    const auto add = [&](const int row, const int column, const double value) {
      if (row < 0 || row >= n_rows || column < 0 || column >= n_columns)
        fail(name + " has an entry at row " + std::to_string(row) + ", column " +
             std::to_string(column) + " (counted from 0), outside of its " +
             std::to_string(n_rows) + " rows and " + std::to_string(n_columns) + " columns.");
      if (!std::isfinite(value))
        fail(name + " has an entry that is not finite.");
      triplets.emplace_back(row, column, value);
    };
    if (kind >= 0) {
      const std::size_t size = kind;
      if (p.size() < size || inner.size() < size || x.size() < size)
        fail(name + " has " + std::to_string(kind) + " triplets by its nz, but p, i and x have " +
             std::to_string(p.size()) + ", " + std::to_string(inner.size()) + " and " +
             std::to_string(x.size()) + " entries.");
      for (int t = 0; t < kind; ++t)
        add(p[t], inner[t], x[t]);
    } else {
      const int n_outer = kind == -2 ? n_rows : n_columns;
      check_size(of_matrix + "p", p.size(), n_outer + 1u,
                 "one more than " + name + " has " + (kind == -2 ? "rows" : "columns"));
      if (p[0] != 0 || !std::is_sorted(p.begin(), p.end()))
        fail(of_matrix + "p must begin with 0 and never decrease.");
      const std::size_t size = p[n_outer];
      if (inner.size() < size || x.size() < size)
        fail(of_matrix + "p ends with " + std::to_string(size) + ", but i and x have " +
             std::to_string(inner.size()) + " and " + std::to_string(x.size()) + " entries.");
      for (int outer = 0; outer < n_outer; ++outer)
        for (int t = p[outer]; t < p[outer + 1]; ++t)
          kind == -2 ? add(outer, inner[t], x[t]) : add(inner[t], outer, x[t]);
    }
    Eigen::SparseMatrix<double> matrix(n_rows, n_columns);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
  }

  const std::string path, group;
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

void put_solution(const std::string &path, const contact::LocalSolution &solution,
                  const std::optional<Eigen::VectorXd> &v) {
  Hdf5File file(path, Hdf5File::Mode::change);
  if (file.has("/solution"))
    file.remove("/solution");
  file.make_group("/solution");
  file.write("/solution/u", solution.motions);
  file.write("/solution/r", solution.reactions);
  if (v)
    file.write("/solution/v", *v);
  file.write_attribute("/solution", "natural map", solution.residual.natural_map);
  file.write_attribute("/solution", "converged", solution.converged ? 1. : 0.);
  file.flush();
}

} // namespace

void try_contact_file(const std::string &path) {
  const std::string trouble =
      run_in_child([&]() -> std::string {
        try {
          read_contact_reactions(path, n_components(read_contact_problem(path)));
        } catch (const UserError &) { // the caller will meet it again
        }
        return "";
      }).trouble;
  if (!trouble.empty())
    throw UserError(damaged(path, trouble));
}

ContactProblem read_contact_problem(const std::string &path) {
  if (const Hdf5File file(path, Hdf5File::Mode::read); file.has(local_group))
    return ProblemReader(path, local_group).read_local();
  else if (file.has(global_group))
    return ProblemReader(path, global_group).read_global();
  throw UserError(
      "The file '" + path +
      "' is not a problem that can be solved. It has neither the group /fclib_local nor "
      "/fclib_global, in which FCLIB keeps friction-contact problems. See with h5ls -r "
      "what it holds.");
}

unsigned int n_components(const ContactProblem &problem) {
  const auto *const local = std::get_if<contact::LocalProblem>(&problem);
  return local ? local->q.size() : std::get<GlobalContactProblem>(problem).w.size();
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

void replace_contact_solution(const std::string &path, const contact::LocalSolution &solution,
                              const std::optional<Eigen::VectorXd> &v) {
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
      put_solution(copy.string(), solution, v);
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
  file.write("/fclib_global/spacedim", static_cast<int>(problem.dimension));
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
