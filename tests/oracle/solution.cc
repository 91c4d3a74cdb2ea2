// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solution.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

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

/// The factors that a load sequence declares, at any time of its static steps.
class Course {
public:
  explicit Course(const Scene &scene) : scene(scene) {}

  void begin_step(const std::size_t which) {
    const std::size_t n = scene.loads.size();
    step = which;
    start = which == 0 ? 0. : start + scene.steps[which - 1].duration;
    starts.push_back(start);
    from = to.empty() ? std::vector<Real>(n, 0) : to;
    to.assign(n, 0);
    for (const auto &[load, factor] : scene.steps[which].loads)
      to[load] += factor;
    origin.assign(n, 0.);
    for (std::size_t l = 0; l < n; ++l)
      if (!scene.loads[l].run_time)
        origin[l] = origin_of(l);
  }

  /// Times of an increment: its own end, and corners of histories before it. Platens press before
  /// the first of all.
  std::vector<double> instants(const int k) const {
    const Step &now = scene.steps[step];
    const double before = start + now.duration * (k - 1) / now.increments,
                 end = start + now.duration * k / now.increments;
    std::vector<double> result;
    if (step == 0 && k == 1 &&
        std::any_of(scene.supports.begin(), scene.supports.end(),
                    [](const Support &support) { return support.normal_force > 0.; }))
      result.push_back(start);
    const auto add = [&](const double time) {
      if (time > before && time < end - 1e-9 * now.duration)
        result.push_back(time);
    };
    for (std::size_t l = 0; l < origin.size(); ++l)
      if (to[l] != 0)
        for (const auto &row : scene.loads[l].history)
          add(origin[l] + row[0]);
    for (const Support &support : scene.supports)
      for (const auto &row : support.ground_motion)
        add(row[0]);
    std::sort(result.begin(), result.end());
    result.push_back(end);
    return result;
  }

  /// Of the loads, and of the hangers, which come with the first step.
  std::vector<Real> factors(const double time) const {
    const Real part = (static_cast<Real>(time) - start) / scene.steps[step].duration;
    std::vector<Real> result(from.size());
    for (std::size_t l = 0; l < result.size(); ++l) // what goes to zero stands still in its history
      result[l] = (from[l] + part * (to[l] - from[l])) *
                  history(l, (to[l] == 0 ? start : time) - origin[l]);
    result.push_back(step == 0 ? part : 1);
    return result;
  }

private:
  bool acts(const std::size_t which, const std::size_t load) const {
    for (const auto &[l, factor] : scene.steps[which].loads)
      if (l == static_cast<int>(load) && factor != 0.)
        return true;
    return false;
  }
  /// A load that goes back to zero keeps the time that it had.
  double origin_of(const std::size_t load) const {
    std::size_t first = step;
    if (!acts(step, load) && step > 0 && acts(step - 1, load))
      --first;
    while (first > 0 && acts(first - 1, load))
      --first;
    return starts[first];
  }
  Real history(const std::size_t load, const double time) const {
    const auto &rows = scene.loads[load].history;
    if (rows.empty())
      return 1;
    if (time < rows.front()[0])
      return 0;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i)
      if (time <= rows[i + 1][0])
        return rows[i][1] + static_cast<Real>(time - rows[i][0]) / (rows[i + 1][0] - rows[i][0]) *
                                (rows[i + 1][1] - rows[i][1]);
    return rows.back()[1];
  }

  const Scene &scene;
  std::size_t step = 0;
  double start = 0.;
  std::vector<double> starts, origin;
  std::vector<Real> from, to;
};

/// What a rigid support in a hanger's place carries, then how far the point travels under that.
/// All hangers that are open are sized together.
bool size_hangers(Scene &scene) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < scene.hangers.size(); ++i)
    if (scene.hangers[i].cold_load == 0.)
      open.push_back(i);
  if (open.empty())
    return true;
  Scene held = scene, hot = scene;
  held.modes = hot.modes = 0;
  const auto up_to = [&](const std::string &name, const std::size_t otherwise) {
    std::size_t n = 1;
    while (n < scene.steps.size() &&
           (name.empty() ? n < otherwise : scene.steps[n - 1].name != name))
      ++n;
    return n;
  };
  // Displacements of later steps hold their points in these, too.
  const auto cut = [&](Scene &some, const std::size_t n) {
    std::set<int> later;
    for (std::size_t s = n; s < some.steps.size(); ++s)
      for (const auto &load : some.steps[s].loads)
        later.insert(load.first);
    some.steps.resize(n);
    auto &loads = some.steps.back().loads;
    for (const auto &load : loads)
      later.erase(load.first);
    for (const int load : later)
      loads.emplace_back(load, 0.);
  };
  cut(held, up_to(scene.hangers[open.front()].weight_step, 1));
  cut(hot, up_to(scene.hangers[open.front()].hot_step, 2));
  for (std::size_t k = open.size(); k-- > 0;) {
    Support support;
    support.name = scene.hangers[open[k]].name;
    support.kind = "restraint";
    support.fixed = {false, false, true, false, false, false};
    support.at = {scene.hangers[open[k]].at};
    held.supports.push_back(support);
    held.hangers.erase(held.hangers.begin() + open[k]);
    hot.hangers[open[k]].constant = true;
    hot.hangers[open[k]].stiffness = 0.;
  }
  const Solution weight = solve(held);
  const State &state = weight.steps.back();
  Vector left = weight.frame->residual(state.motion, state.factors);
  for (const Contact &contact : state.contacts)
    left -=
        contact.rows.transpose() * contact.force + contact.twist_row.transpose() * contact.moment;
  for (const std::size_t i : open) {
    hot.hangers[i].cold_load = left[6 * weight.frame->node_of(scene.hangers[i].at) + 2];
    if (hot.hangers[i].cold_load <= 0.)
      return false;
  }
  const Solution warm = solve(hot);
  for (const std::size_t i : open) {
    const double load = hot.hangers[i].cold_load,
                 travel =
                     warm.steps.back().motion[6 * warm.frame->node_of(scene.hangers[i].at) + 2];
    Hanger &hanger = scene.hangers[i];
    hanger.cold_load = load;
    if (hanger.constant)
      continue;
    hanger.stiffness =
        std::min(0.98 * hanger.variation * load / std::max(std::abs(travel), 1e-300), load / 0.025);
    hanger.cold_load = load + hanger.stiffness * travel;
  }
  return true;
}

/// Whether a motion has a stiffness that is rounding, once each motion is measured by its own
/// stiffness: 1e-16 in long double leaves three digits.
bool is_singular(const Matrix &K) {
  if (K.rows() == 0)
    return false;
  const Vector scale = K.diagonal().cwiseMax(1e-300L).cwiseSqrt().cwiseInverse();
  const Eigen::LDLT<Matrix> scaled(Matrix(scale.asDiagonal() * K * scale.asDiagonal()));
  return scaled.vectorD().minCoeff() < 1e-16L;
}

} // namespace

Solution solve(const Scene &given, const Starts &starts) {
  Solution solution;
  const auto sized = std::make_shared<Scene>(given);
  solution.hanger_pushes = !size_hangers(*sized);
  solution.scene = sized;
  const Scene &scene = *sized;
  const auto frame = std::make_shared<Frame>(scene);
  solution.frame = frame;
  if (solution.hanger_pushes)
    return solution;
  const Matrix &Z = frame->free_basis();
  const Matrix free_stiffness = Z.transpose() * frame->stiffness() * Z;
  const Eigen::LDLT<Matrix> factor(free_stiffness);
  solution.hangs_on_contacts = is_singular(free_stiffness);
  const auto displaced = [&](const Vector &forces, const Vector &imposed) {
    const Vector right = Z.transpose() * (forces - frame->stiffness() * imposed);
    return Vector(imposed + Z * factor.solve(right));
  };

  State state;
  state.factors.assign(scene.loads.size() + 1, 0);
  state.contacts = contacts_of(scene, *frame);
  const int n = static_cast<int>(state.contacts.size());
  const Matrix C = contact_rows(state.contacts, frame->n());
  const Matrix CZ = C * Z;
  const Matrix W = n == 0 ? Matrix() : Matrix(CZ * factor.solve(Matrix(CZ.transpose())));

  Real largest_force = 0; // of contacts and clamped loads, so far
  Course course(scene);
  for (std::size_t s = 0; s < scene.steps.size(); ++s) {
    course.begin_step(s);
    for (int k = 1; k <= scene.steps[s].increments; ++k)
      for (const double time : course.instants(k)) {
        state.factors = course.factors(time);
        const Vector loads = frame->load_vector(state.factors);
        const Vector imposed = frame->imposed(state.factors);
        // Rounding of these decides where a contact touches without a force.
        for (int i = 0; i < loads.size(); ++i)
          if (i % 6 < 3)
            largest_force = std::max(largest_force, std::abs(loads[i]));
        for (const Vec12 &ends : frame->end_forces(Vector::Zero(frame->n()), state.factors))
          for (int i = 0; i < 12; ++i)
            if (i % 6 < 3)
              largest_force = std::max(largest_force, std::abs(ends[i]));
        state.motion = displaced(loads, imposed);
        if (n == 0)
          continue;
        Vector free = C * state.motion, forces(4 * n);
        for (int i = 0; i < n; ++i)
          free.segment<3>(3 * i) -= ground_at(state.contacts[i], time);
        const auto start = starts.lower_bound(time - 1e-9 * scene.steps[s].duration);
        for (int i = 0; i < n && start != starts.end(); ++i)
          state.contacts[i].force = start->second[i];
        state.sure = solve_contacts(W, free, state.contacts, largest_force) && state.sure;
        for (int i = 0; i < n; ++i) {
          forces.segment<3>(3 * i) = state.contacts[i].force;
          forces[3 * n + i] = state.contacts[i].moment;
        }
        state.motion += Z * factor.solve(CZ.transpose() * forces);
      }
    solution.steps.push_back(state);
  }
  if (scene.modes > 0)
    solution.frequencies = frequencies(scene, *frame);
  return solution;
}

} // namespace oracle
