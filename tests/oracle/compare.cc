// SPDX-License-Identifier: LGPL-2.1-or-later
#include "compare.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace oracle {

void Comparison::add(const std::string &name, const double program, const double right,
                     const double scale, const double rounded) {
  ++numbers;
  const double difference =
      std::isfinite(program)
          ? std::max(0., std::abs(program - right) - rounded) / std::max(scale, 1e-300)
          : 1e300;
  if (difference <= worst)
    return;
  worst = difference;
  std::ostringstream out;
  out.precision(12);
  out << name << ": program " << program << ", right " << right << ", of " << scale;
  what = out.str();
}

namespace {

const char *const motion_names[] = {"ux", "uy", "uz", "rx", "ry", "rz"};
const char *const force_names[] = {"Fx", "Fy", "Fz", "Mx", "My", "Mz"};

/// Section force of a station in global axes; its local x axis is y cross z.
Six global_force(const frictionbeam::Station &station) {
  Vec y, z;
  for (int d = 0; d < 3; ++d) {
    y[d] = station.y[d];
    z[d] = station.z[d];
  }
  const Vec x = y.cross(z);
  Six result;
  for (int d = 0; d < 3; ++d) {
    result[d] = station.force[0] * x[d] + station.force[1] * y[d] + station.force[2] * z[d];
    result[3 + d] = station.force[3] * x[d] + station.force[4] * y[d] + station.force[5] * z[d];
  }
  return result;
}

/// The four scales of one state: displacements, rotations, forces and moments.
struct Scales {
  double values[4] = {0., 0., 0., 0.};
  double rounded[2] = {0., 0.}; ///< what rounding may have moved: displacements, rotations

  Scales(const Scene &scene, const State &state, const Frame &frame) {
    for (const Vec12 &ends : frame.end_forces(state.motion, state.factors))
      for (int i = 0; i < 12; ++i)
        include(i % 6 < 3 ? 2 : 3, ends[i]);
    for (const Spring &spring : scene.springs)
      for (int c = 0; c < 6; ++c)
        include(c < 3 ? 2 : 3, frame.spring_force(spring, state.motion)[c]);
    for (int i = 0; i < state.motion.size(); ++i)
      include(i % 6 < 3 ? 0 : 1, state.motion[i]);
    // Residuals of forces are judged by the largest force, to 1e-10: that is 1e-8 of a hundredth
    // of the loads at clamped nodes, also where a line expands freely and has no forces.
    const Vector loads = frame.load_vector(state.factors);
    for (int i = 0; i < loads.size(); ++i)
      include(i % 6 < 3 ? 2 : 3, 1e-2L * loads[i]);
    values[0] = std::max(values[0], 1e-6); // below 1e-14 m and 1e-11 N nothing is asked
    values[2] = std::max(values[2], 1e-3);
    values[1] = std::max(values[1], values[0] / 10.); // as over 10 m
    values[0] = std::max(values[0], values[1] / 10.);
    values[3] = std::max(values[3], values[2]); // at an arm of 1 m
    values[2] = std::max(values[2], values[3] / 10.);
  }
  double operator()(const bool force, const int component) const {
    return values[(force ? 2 : 0) + (component < 3 ? 0 : 1)];
  }
  /// A line that has been loaded more before: what is below 1e-4 of that is judged as if it were
  /// that much, for the state was reached by increments from there, which keep its rounding.
  void follow(Scales &largest_so_far) {
    for (int i = 0; i < 4; ++i) {
      largest_so_far.values[i] = std::max(largest_so_far.values[i], values[i]);
      values[i] = std::max(values[i], 1e-4 * largest_so_far.values[i]);
    }
  }

private:
  void include(const int kind, const Real value) {
    values[kind] = std::max(values[kind], static_cast<double>(std::abs(value)));
  }
};

void compare_lines(const Scene &scene, const frictionbeam::Frame &program, const Frame &frame,
                   const State &state, const Scales &scales, const std::string &step,
                   Comparison &result) {
  for (const frictionbeam::Station &station : program.line) {
    const std::vector<Member::At> sides =
        frame.at(station.pipe, station.s, state.motion, state.factors);
    if (sides.empty()) {
      result.add("place on pipe", 1., 0., 1.);
      continue;
    }
    const Six force = global_force(station);
    // At a node either side may be meant: the one that is nearer.
    double least = 1e300;
    const Member::At *nearest = &sides.front();
    for (const Member::At &side : sides) {
      double sum = 0.;
      for (int c = 0; c < 6; ++c)
        sum += std::abs(force[c] - static_cast<double>(side.force[c])) / scales(true, c) +
               std::abs(station.displacement[c] - static_cast<double>(side.motion[c])) /
                   scales(false, c);
      if (sum < least) {
        least = sum;
        nearest = &side;
      }
    }
    const std::string where =
        step + ", " + scene.pipes[station.pipe].name + " at " + std::to_string(station.s) + " m, ";
    for (int c = 0; c < 6; ++c) {
      result.add(where + motion_names[c], station.displacement[c], nearest->motion[c],
                 scales(false, c), scales.rounded[c < 3 ? 0 : 1]);
      result.add(where + force_names[c], force[c], nearest->force[c], scales(true, c));
    }
  }
}

void compare_supports(const frictionbeam::Results &program, const frictionbeam::Frame &shown,
                      const State &state, const Scales &scales, const std::string &step,
                      Comparison &result) {
  constexpr double least = 1e-8;
  for (const Contact &contact : state.contacts)
    for (std::size_t i = 0; i < program.supports.size(); ++i) {
      if (program.supports[i].name != contact.name)
        continue;
      const frictionbeam::SupportInfo &info = program.supports[i];
      const frictionbeam::SupportState &is = shown.supports[i];
      const Vec right = static_cast<double>(contact.force[0]) * contact.normal +
                        static_cast<double>(contact.force[1]) * contact.t1 +
                        static_cast<double>(contact.force[2]) * contact.t2;
      for (int d = 0; d < 3; ++d)
        result.add(step + ", " + contact.name + " f" + "xyz"[d],
                   is.fn * info.normal[d] + is.ft1 * info.t1[d] + is.ft2 * info.t2[d], right[d],
                   scales(true, 0));
      if (contact.twist_stiffness > 0)
        result.add(step + ", " + contact.name + " |mt|", std::abs(is.mt), std::abs(contact.moment),
                   scales(true, 3));
      result.add(step + ", " + contact.name + " fn", is.fn, contact.force[0], scales(true, 0));
      if (contact.platen == 0)
        result.add(step + ", " + contact.name + " gap", is.gap, contact.gap + contact.motion[0],
                   scales(false, 0));
      using Theirs = frictionbeam::ContactStatus;
      using Ours = Contact::Status;
      // A state means something where what decides it, gap or force, is more than rounding.
      const bool felt = contact.status == Ours::open
                            ? contact.gap + contact.motion[0] > least * scales(false, 0)
                            : contact.force[0] > least * scales(true, 0);
      if (contact.sure && felt) {
        const Theirs status = contact.status == Ours::open    ? Theirs::open
                              : contact.status == Ours::stick ? Theirs::stick
                              : contact.status == Ours::slip  ? Theirs::slip
                                                              : Theirs::closed;
        result.add(step + ", " + contact.name + " status", static_cast<int>(is.status),
                   static_cast<int>(status), 1.);
      }
      if (contact.status != Ours::open && contact.sure_of_touch) {
        const Vec3 slip = contact.plastic - contact.touch;
        // It may have touched in a step that moved the line farther than this one.
        const double size =
            std::max<double>(scales(false, 0), std::max(contact.plastic.tail<2>().norm(),
                                                        contact.touch.tail<2>().norm()));
        result.add(step + ", " + contact.name + " slip1", is.slip1, slip[1], size);
        result.add(step + ", " + contact.name + " slip2", is.slip2, slip[2], size);
      }
    }
}

Vec6 nodal_force(const Frame &frame, const State &state, const int node) {
  Vector held = frame.residual(state.motion, state.factors);
  for (const Contact &contact : state.contacts)
    held -=
        contact.rows.transpose() * contact.force + contact.twist_row.transpose() * contact.moment;
  return held.segment<6>(6 * node);
}

void compare_reactions(const Scene &scene, const frictionbeam::Results &program,
                       const frictionbeam::Frame &shown, const Frame &frame, const State &state,
                       const Scales &scales, const std::string &step, Comparison &result) {
  const auto add = [&](const std::string &name, const Six &right) {
    for (std::size_t i = 0; i < program.restraints.size(); ++i)
      if (program.restraints[i].name == name)
        for (int c = 0; c < 6; ++c)
          result.add(step + ", " + name + " " + force_names[c], shown.reactions[i][c], right[c],
                     scales(true, c));
  };
  for (const Support &support : scene.supports) {
    if (!support.holds_exactly())
      continue;
    const std::vector<Place> places = frame.places(support);
    for (std::size_t p = 0; p < places.size(); ++p) {
      const Vec6 force = nodal_force(frame, state, places[p].node);
      Vec6 own = Vec6::Zero();
      for (const Vec6 &direction : Frame::held(support, places[p]))
        own += direction.dot(force) * direction;
      Six right;
      for (int c = 0; c < 6; ++c)
        right[c] = own[c];
      add(support.name + (places.size() > 1 ? "." + std::to_string(p + 1) : ""), right);
    }
  }
  for (const Spring &spring : scene.springs)
    add(spring.name, frame.spring_force(spring, state.motion));
  for (const Hanger &hanger : scene.hangers) {
    Six force{};
    force[2] = state.factors.back() * hanger.cold_load -
               hanger.stiffness * state.motion[6 * frame.node_of(hanger.at) + 2];
    add(hanger.name, force);
  }
}

/// How far rounding may move each motion, at most: every product in K u and every clamped force is
/// off by its last bit in double precision, and what is left so moves the line by its flexibility,
/// where contacts that are closed hold it, and those that stick hold it sideways.
Vector moved_by_rounding(const Frame &frame, const State &state) {
  constexpr Real bit = 2.2e-16L;
  Vector left = bit * (frame.stiffness().cwiseAbs() * state.motion.cwiseAbs());
  Real clamped[2] = {0, 0};
  for (const Vec12 &ends : frame.end_forces(Vector::Zero(frame.n()), state.factors))
    for (int i = 0; i < 12; ++i)
      clamped[i % 6 < 3 ? 0 : 1] = std::max(clamped[i % 6 < 3 ? 0 : 1], std::abs(ends[i]));
  for (int i = 0; i < left.size(); ++i)
    left[i] += bit * clamped[i % 6 < 3 ? 0 : 1];
  const Matrix &Z = frame.free_basis();
  const Eigen::LDLT<Matrix> factor(Z.transpose() * frame.stiffness() * Z);
  Matrix G = Z * factor.solve(Matrix(Z.transpose()));
  std::vector<std::pair<int, int>> holds; // contact and direction
  for (std::size_t i = 0; i < state.contacts.size(); ++i)
    for (int c = 0; c < 3; ++c)
      if (c == 0 ? state.contacts[i].platen == 0 && state.contacts[i].force[0] > 0
                 : state.contacts[i].status == Contact::Status::stick)
        holds.emplace_back(i, c);
  Matrix B(holds.size(), frame.n());
  Vector soft(holds.size());
  for (std::size_t k = 0; k < holds.size(); ++k) {
    B.row(k) = state.contacts[holds[k].first].rows.row(holds[k].second);
    soft[k] = state.contacts[holds[k].first].soft[holds[k].second];
  }
  if (!holds.empty()) {
    const Matrix BG = B * G;
    Matrix W = BG * B.transpose();
    W.diagonal() += soft;
    G -= BG.transpose() * Eigen::LDLT<Matrix>(W).solve(BG);
  }
  return G.cwiseAbs() * left;
}

} // namespace

Comparison compare(const Outcome &program, const Solution &oracle, const bool ask_rounding) {
  const Scene &scene = *oracle.scene;
  Comparison result;
  const frictionbeam::Results &results = program.results;
  unsigned int compared = 0;
  std::optional<Scales> largest_so_far;
  for (const frictionbeam::Frame &shown : results.frames) {
    if (!shown.end_of_step || shown.increment == 0 || shown.step >= oracle.steps.size())
      continue;
    ++compared;
    const State &state = oracle.steps[shown.step];
    result.unsure = result.unsure || !state.sure;
    Scales scales(scene, state, *oracle.frame);
    if (!largest_so_far)
      largest_so_far = scales;
    scales.follow(*largest_so_far);
    if (ask_rounding) {
      const Vector moved = moved_by_rounding(*oracle.frame, state);
      for (int i = 0; i < moved.size(); ++i) {
        double &largest = scales.rounded[i % 6 < 3 ? 0 : 1];
        largest = std::max(largest, static_cast<double>(moved[i]));
      }
    }
    const double terms =
        (oracle.frame->stiffness().cwiseAbs() * state.motion.cwiseAbs()).maxCoeff();
    // Solver/Tolerance leaves 1e-10 of the largest force, clamped free strains included.
    const double loads = oracle.frame->load_vector(state.factors).cwiseAbs().maxCoeff();
    result.rounding = std::max(result.rounding, (1e-16 * terms + 1e-11 * loads) / scales(true, 0));
    const std::string step = scene.steps[shown.step].name;
    compare_lines(scene, shown, *oracle.frame, state, scales, step, result);
    compare_supports(results, shown, state, scales, step, result);
    compare_reactions(scene, results, shown, *oracle.frame, state, scales, step, result);
  }
  result.add("number of steps", compared, oracle.steps.size(), 1.);
  for (std::size_t i = 0; i < oracle.frequencies.size(); ++i)
    result.add("frequency of mode " + std::to_string(i + 1),
               i < results.modes.size() ? results.modes[i].frequency : 0., oracle.frequencies[i],
               100. * oracle.frequencies[i]); // eigenvalues to 1e-6
  return result;
}

std::string describe(const Scene &scene, const Solution &solution) {
  std::ostringstream out;
  out.precision(12);
  for (std::size_t s = 0; s < solution.steps.size(); ++s) {
    const State &state = solution.steps[s];
    out << "step " << scene.steps[s].name << '\n';
    for (const Pipe &pipe : scene.pipes)
      for (const Corner &corner : pipe.route)
        if (!corner.name.empty()) {
          out << "  " << corner.name << ':';
          for (int c = 0; c < 6; ++c)
            out << ' ' << motion_names[c] << ' '
                << state.motion[6 * solution.frame->node_of(corner.name) + c];
          out << '\n';
        }
    for (const Contact &contact : state.contacts)
      out << "  " << contact.name << ": fn " << contact.force[0] << ", ft1 " << contact.force[1]
          << ", ft2 " << contact.force[2] << ", gap " << contact.gap + contact.motion[0] << '\n';
  }
  for (const double frequency : solution.frequencies)
    out << "  " << frequency << " Hz\n";
  return out.str();
}

} // namespace oracle
