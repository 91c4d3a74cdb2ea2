// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/contact/system.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace frictionbeam::contact {

namespace {

void check_numbers(const SparseMatrix &matrix) {
  for (int i = 0; i < matrix.outerSize(); ++i)
    for (SparseMatrix::InnerIterator entry(matrix, i); entry; ++entry)
      if (!std::isfinite(entry.value()))
        throw std::invalid_argument("The matrix has an entry that is no number, " +
                                    std::to_string(entry.value()) + " at (" + std::to_string(i) +
                                    ", " + std::to_string(entry.col()) +
                                    "), counted in unknowns\n  allowed: numbers\n  try:     the "
                                    "matrix as it was assembled");
}

/// Where the matrix is not that of a symmetric bilinear form.
void check_symmetry(const SparseMatrix &matrix) {
  constexpr double rounding = 1e-9;
  const Vector diagonal = matrix.diagonal().cwiseAbs();
  const SparseMatrix transposed = matrix.transpose();
  const SparseMatrix difference = matrix - transposed;
  for (int i = 0; i < difference.outerSize(); ++i)
    for (SparseMatrix::InnerIterator entry(difference, i); entry; ++entry)
      if (!(std::abs(entry.value()) <=
            rounding * std::max({diagonal[i], diagonal[entry.col()],
                                 std::abs(matrix.coeff(i, entry.col()))}))) {
        std::ostringstream text;
        text.precision(10);
        text << "The matrix is not symmetric: its entries (" << i << ", " << entry.col()
             << ") and (" << entry.col() << ", " << i << "), counted in unknowns, are "
             << matrix.coeff(i, entry.col()) << " and " << matrix.coeff(entry.col(), i)
             << "\n  allowed: a symmetric matrix, friction being the contacts'\n  try:     the "
                "symmetric part, and the rest as a load";
        throw std::invalid_argument(text.str());
      }
}

class CondensedByInverse final : public Condensation {
public:
  CondensedByInverse(const int n_unknowns, const std::vector<int> &keep,
                     const std::function<Vector(const Vector &)> &solve)
      : Condensation(n_unknowns, keep), solve(solve) {
    const Eigen::Index n = kept.size();
    Eigen::MatrixXd inverse(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
      Vector unit = Vector::Zero(n_unknowns);
      unit[kept[k]] = 1.;
      inverse.col(k) = at_kept(solve(unit));
    }
    const Eigen::LLT<Eigen::MatrixXd> factors((inverse + inverse.transpose()) / 2.);
    if (factors.info() != Eigen::Success)
      throw std::invalid_argument(
          "The inverse is not positive definite on what contacts touch\n  allowed: the inverse of "
          "a "
          "body that is held without its contacts, to many digits\n  try:     a smaller tolerance, "
          "or the matrix itself, whose body may be free");
    const Eigen::MatrixXd stiffness = factors.solve(Eigen::MatrixXd::Identity(n, n));
    S = ((stiffness + stiffness.transpose()) / 2.).sparseView(0., 0.);
  }

  Vector condense(const Vector &forces) const override { return S * at_kept(solve(forces)); }

  Vector expand(const Vector &kept_unknowns, const Vector &forces) const override {
    const Vector without = solve(forces);
    Vector at_contacts = Vector::Zero(n_unknowns());
    const Vector reactions = S * (kept_unknowns - at_kept(without));
    for (std::size_t k = 0; k < kept.size(); ++k)
      at_contacts[kept[k]] = reactions[k];
    return without + solve(at_contacts);
  }

private:
  Vector at_kept(const Vector &all) const {
    Vector result(kept.size());
    for (std::size_t k = 0; k < kept.size(); ++k)
      result[k] = all[kept[k]];
    return result;
  }

  const std::function<Vector(const Vector &)> solve;
};

System free_system(const SparseMatrix &matrix) {
  System system;
  system.matrix = matrix;
  for (int u = 0; u < matrix.rows(); ++u) {
    system.dof_of.push_back(u);
    system.dofs.push_back({{{u, 1.}}, 0.});
  }
  complete(system);
  return system;
}

} // namespace

System system_of(const SparseMatrix &matrix) { return free_system(matrix); }

System system_of(const Eigen::SparseMatrix<double> &matrix) {
  return free_system(SparseMatrix(matrix));
}

System join(const System &first, const System &second) {
  System all = first;
  std::vector<Eigen::Triplet<double>> entries;
  int begin = 0;
  for (const System *system : {&first, &second}) {
    if (system->matrix.rows() != system->n_unknowns())
      throw std::invalid_argument(
          "A system of " + std::to_string(system->n_unknowns()) + " unknowns has a matrix of " +
          std::to_string(system->matrix.rows()) +
          " rows\n  allowed: two systems with their matrices\n  try:     a System by hand, whose "
          "`condense` knows both bodies");
    for (int i = 0; i < system->matrix.outerSize(); ++i)
      for (SparseMatrix::InnerIterator entry(system->matrix, i); entry; ++entry)
        entries.emplace_back(begin + i, begin + entry.col(), entry.value());
    begin += system->n_unknowns();
  }
  for (const int dof : second.dof_of)
    all.dof_of.push_back(first.dofs.size() + dof);
  for (System::Resolved dof : second.dofs) {
    for (System::Term &term : dof.terms)
      term.unknown += first.n_unknowns();
    all.dofs.push_back(dof);
  }
  all.matrix.resize(begin, begin);
  all.matrix.setFromTriplets(entries.begin(), entries.end());
  complete(all);
  return all;
}

void complete(System &system) {
  if (system.matrix.rows() != system.matrix.cols() || system.matrix.rows() != system.n_unknowns())
    throw std::invalid_argument("The matrix has " + std::to_string(system.matrix.rows()) +
                                " rows and " + std::to_string(system.matrix.cols()) +
                                " columns\n  allowed: a square matrix of " +
                                std::to_string(system.n_unknowns()) +
                                " unknowns\n  try:     the matrix of all bodies at once");
  check_numbers(system.matrix);
  check_symmetry(system.matrix);
  // The method wants both entries of each pair, and a diagonal.
  SparseMatrix identity(system.n_unknowns(), system.n_unknowns());
  identity.setIdentity();
  const SparseMatrix transposed = system.matrix.transpose();
  system.matrix = (0.5 * system.matrix + 0.5 * transposed + 0. * identity).eval();
  system.matrix.makeCompressed();
  system.diagonal = system.matrix.diagonal();
  const SparseMatrix &matrix = system.matrix;
  system.condense = [matrix](const std::vector<int> &keep) {
    return condense_bodies(matrix, keep);
  };
}

std::unique_ptr<Condensation>
condense_by_inverse(const int n_unknowns, const std::vector<int> &keep,
                    const std::function<Vector(const Vector &)> &solve) {
  return std::make_unique<CondensedByInverse>(n_unknowns, keep, solve);
}

} // namespace frictionbeam::contact
