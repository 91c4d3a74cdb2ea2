// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solution.h"

#include <cmath>

namespace oracle {

namespace {

/// Frequencies of free vibration, in rising order: L^-1 M L^-T with K = L L^T has the eigenvalues
/// 1/w^2.
std::vector<double> frequencies(const Scene &scene, const Frame &frame) {
  const Matrix &Z = frame.free_basis();
  const Matrix K = Z.transpose() * frame.stiffness() * Z,
               M = Z.transpose() * frame.mass(scene.lumped) * Z;
  const Eigen::LLT<Matrix> factor(K);
  Matrix A = factor.matrixL().solve(M);
  A = factor.matrixL().solve(Matrix(A.transpose()));
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(A, Eigen::EigenvaluesOnly);
  std::vector<double> result;
  for (int i = 0; i < scene.modes && i < A.rows(); ++i) {
    if (eigen.eigenvalues()[A.rows() - 1 - i] < 1e-15L * eigen.eigenvalues()[A.rows() - 1])
      break; // motions without mass
    result.push_back(1. / std::sqrt(eigen.eigenvalues()[A.rows() - 1 - i]) / (2. * pi));
  }
  return result;
}

} // namespace

Solution solve(const Scene &scene) {
  Solution solution;
  const auto frame = std::make_shared<Frame>(scene);
  solution.frame = frame;
  const Matrix &Z = frame->free_basis();
  const Eigen::LDLT<Matrix> factor(Z.transpose() * frame->stiffness() * Z);
  const auto displaced = [&](const Vector &forces, const Vector &imposed) {
    const Vector right = Z.transpose() * (forces - frame->stiffness() * imposed);
    return Vector(imposed + Z * factor.solve(right));
  };

  State state;
  state.factors.assign(scene.loads.size(), 0);
  state.contacts = contacts_of(scene, *frame);
  const int n = 3 * static_cast<int>(state.contacts.size());
  Matrix C(n, frame->n());
  for (int i = 0; i < n / 3; ++i)
    C.middleRows<3>(3 * i) = state.contacts[i].rows;
  const Matrix CZ = C * Z, W = CZ * factor.solve(Matrix(CZ.transpose()));

  for (const Step &step : scene.steps) {
    const std::vector<Real> before = state.factors;
    std::vector<Real> target(scene.loads.size(), 0);
    for (const auto &[load, factor_of_load] : step.loads)
      target[load] += factor_of_load;
    for (int k = 1; k <= step.increments; ++k) {
      for (std::size_t l = 0; l < target.size(); ++l)
        state.factors[l] = before[l] + (target[l] - before[l]) * k / step.increments;
      const Vector loads = frame->load_vector(state.factors);
      const Vector imposed = frame->imposed(state.factors);
      state.motion = displaced(loads, imposed);
      if (n > 0) {
        state.sure = solve_contacts(W, C * state.motion, state.contacts) && state.sure;
        Vector forces(n);
        for (int i = 0; i < n / 3; ++i)
          forces.segment<3>(3 * i) = state.contacts[i].force;
        state.motion += Z * factor.solve(CZ.transpose() * forces);
      }
    }
    solution.steps.push_back(state);
  }
  if (scene.modes > 0)
    solution.frequencies = frequencies(scene, *frame);
  return solution;
}

} // namespace oracle
