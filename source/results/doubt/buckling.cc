// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/doubt/buckling.h"

#include "analysis/contact/opposed_contacts.h"
#include "base/algebra/dense_algebra.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace frictionbeam {

namespace {

constexpr int n_parts = 8;   ///< of a straight cell
constexpr double held = 1e3; ///< stiffness of what is rigid, of the line's largest
/// What slides freely has no stiffness at all.
constexpr double rounding_of_diagonal = 1e-12;
constexpr double nothing = 1e-18;        ///< of the largest one, for unknowns without any
constexpr double resolved = 1e-5;        ///< of the factor
constexpr double takes_part = 0.02;      ///< of the cell that bends most
constexpr double few = 0.3;              ///< N l^2/EI below which a cell is one
constexpr double carries_nothing = 1e-9; ///< of the support's, or of the largest along a pipe

using Matrix4 = Eigen::Matrix4d;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

/// On (w, w') at both ends of a beam of length 1 and EI = 1.
Matrix4 bending() {
  Matrix4 K;
  K << 12., 6., -12., 6., 6., 4., -6., 2., -12., -6., 12., -6., 6., 2., -6., 4.;
  return K;
}
/// The same of a compression of 1: integral of w'^2.
Matrix4 of_compression() {
  Matrix4 G;
  G << 36., 3., -36., 3., 3., 4., -3., -1., -36., -3., 36., -3., 3., -1., -3., 4.;
  return G / 30.;
}

/// What a frame says of each friction element: an edge of a patch that carries nothing is open.
std::vector<SupportState> states_of_contacts(const Contacts &contacts, const Frame &frame) {
  std::vector<SupportState> states(frame.supports.empty() ? 0 : contacts.size());
  for (std::size_t i = 0; i < frame.supports.size(); ++i) {
    const std::vector<unsigned int> &of_place = contacts.places()[i];
    for (const unsigned int contact : of_place)
      states[contact] = frame.supports[i];
    if (of_place.size() == 1)
      continue;
    const double of_tilt = frame.supports[i].tilt / contacts[of_place.back()].arm.norm();
    for (const double way : {-1., 1.}) {
      SupportState &edge = states[way < 0. ? of_place.front() : of_place.back()];
      edge.fn = (edge.fn + way * of_tilt) / 2.;
      edge.ft1 /= 2.;
      edge.ft2 /= 2.;
      if (edge.fn <= carries_nothing * frame.supports[i].fn) {
        edge.status = ContactStatus::open;
        edge.gap = std::numeric_limits<double>::infinity();
      }
    }
  }
  return states;
}

/// A cell with axial force.
struct PressedCell {
  unsigned int index = 0;             ///< in Discretization::pipe_cells()
  std::size_t first = 0, last = 0;    ///< stations at its ends
  double begin = 0., end = 0.;        ///< compression at its deal.II vertices [N]
  bool may_be_cut = false;            ///< straight, without joints
  double length = 0., stiffness = 0.; ///< [m], EI [N m2]
};

/// What the compression of a cell does to its transverse stiffness, on (w, w') of its ends.
struct Softening {
  Matrix4 matrix = Matrix4::Zero();
  int n_negative = 0; ///< of the cell with clamped ends, in one plane
};

Softening softening_of(const PressedCell &cell, const double factor) {
  const double unit = cell.stiffness / std::pow(cell.length, 3);
  const double whole = std::pow(cell.length, 2) / cell.stiffness;
  Softening result;
  if (!cell.may_be_cut ||
      factor * std::max(std::abs(cell.begin), std::abs(cell.end)) * whole < few) {
    result.matrix = -factor * (cell.begin + cell.end) / 2. * whole * of_compression();
  } else {
    constexpr int n = 2 * (n_parts + 1);
    Eigen::Matrix<double, n, n> K = Eigen::Matrix<double, n, n>::Zero();
    const Eigen::DiagonalMatrix<double, 4> part(1., 1. / n_parts, 1., 1. / n_parts);
    for (int i = 0; i < n_parts; ++i) {
      const double place = (i + 0.5) / n_parts,
                   N = factor * whole * ((1. - place) * cell.begin + place * cell.end);
      K.block<4, 4>(2 * i, 2 * i) +=
          part * (std::pow(n_parts, 3) * bending() - n_parts * N * of_compression()).eval() * part;
    }
    constexpr int inner = n - 4;
    const Eigen::Matrix<double, inner, inner> K_ii = K.block<inner, inner>(2, 2);
    Eigen::Matrix<double, inner, 4> K_ie;
    K_ie << K.block<inner, 2>(2, 0), K.block<inner, 2>(2, n - 2);
    result.matrix << K.block<2, 2>(0, 0), K.block<2, 2>(0, n - 2), K.block<2, 2>(n - 2, 0),
        K.block<2, 2>(n - 2, n - 2);
    result.matrix -= K_ie.transpose() * K_ii.partialPivLu().solve(K_ie) + bending();
    result.n_negative = (symmetric_eigen(K_ii).values.array() < 0.).count();
  }
  const Eigen::DiagonalMatrix<double, 4> lengths(1., cell.length, 1., cell.length);
  result.matrix = unit * (lengths * result.matrix * lengths).eval();
  return result;
}

class BucklingProblem {
public:
  BucklingProblem(const Model &model, const Frame &frame, const double touching)
      : model(model), frame(frame) {
    find_cells();
    if (is_pressed())
      assemble(touching);
  }

  bool is_pressed() const {
    return std::any_of(cells.begin(), cells.end(),
                       [](const PressedCell &cell) { return cell.begin > 0. || cell.end > 0.; });
  }

  /// Negative eigenvalues at a factor of the forces.
  int n_negative(const double factor) {
    int n = 0;
    MatrixEntries softening(MatrixEntries::Zeros::left_out);
    for (const PressedCell &cell : cells)
      n += 2 * soften(cell, factor, softening);
    factored.compute(base + softening.matrix(base.rows()));
    return factored.info() == Eigen::Success ? n + (factored.vectorD().array() < 0.).count() : n;
  }

  /// Where the line bends most as it buckles, at a factor just below that.
  Buckling shape(const double factor) {
    constexpr unsigned int n_iterations = 8;
    n_negative(factor);
    Vector motion(base.rows());
    for (int i = 0; i < motion.size(); ++i)
      motion[i] = std::sin(1. + static_cast<double>(i) * i); // of all shapes something
    for (unsigned int k = 0; k < n_iterations && factored.info() == Eigen::Success; ++k)
      motion = factored.solve(motion).normalized();
    Vector dofs;
    model.space.expand(motion, dofs);
    std::vector<double> work;
    for (const PressedCell &cell : cells) {
      const Softening soft = softening_of(cell, factor);
      const Eigen::Matrix<double, 12, 1> ends = ends_of(cell, dofs);
      work.push_back(-ends.dot(on_ends(cell, soft.matrix) * ends));
    }
    const std::size_t most = std::max_element(work.begin(), work.end()) - work.begin();
    std::size_t begin = most, end = most;
    const auto goes_on = [&](const std::size_t i, const std::size_t other) {
      return work[other] > takes_part * work[most] &&
             frame.line[cells[i].first].pipe == frame.line[cells[other].first].pipe;
    };
    while (begin > 0 && goes_on(begin, begin - 1))
      --begin;
    while (end + 1 < cells.size() && goes_on(end, end + 1))
      ++end;
    Buckling result;
    result.begin = frame.line[cells[begin].first];
    result.end = frame.line[cells[end].last];
    for (std::size_t i = begin; i <= end; ++i)
      result.compression = std::max({result.compression, cells[i].begin, cells[i].end});
    return result;
  }

private:
  void find_cells() {
    std::vector<std::vector<unsigned int>> in_pipe(model.scene.pipes.size());
    const auto &pipe_cells = model.discretization.pipe_cells();
    for (unsigned int i = 0; i < pipe_cells.size(); ++i) {
      auto &list = in_pipe[pipe_cells[i].pipe];
      list.resize(std::max<std::size_t>(list.size(), pipe_cells[i].position + 1));
      list[pipe_cells[i].position] = i;
    }
    std::vector<unsigned int> n_met(in_pipe.size(), 0);
    for (std::size_t first = 0; first + 1 < frame.line.size();) {
      const unsigned int pipe = frame.line[first].pipe;
      std::size_t last = first + 1;
      while (last < frame.line.size() && frame.line[last].pipe == pipe &&
             !frame.line[last].is_node())
        ++last;
      const bool is_cell = last < frame.line.size() && frame.line[last].pipe == pipe &&
                           frame.line[last].vertex != frame.line[first].vertex; // its other side
      if (is_cell && n_met[pipe] < in_pipe[pipe].size())
        add_cell(in_pipe[pipe][n_met[pipe]++], first, last);
      first = last;
    }
  }

  void add_cell(const unsigned int index, const std::size_t first, const std::size_t last) {
    const auto at = model.discretization.pipe_cell(index);
    if (model.linear.solid_part(model.discretization.pipe_cells()[index]) != nullptr)
      return;
    PressedCell cell;
    cell.index = index;
    cell.first = first;
    cell.last = last;
    const Profile &profile = model.discretization.profiles()[at->material_id()];
    cell.length = at->vertex(0).distance(at->vertex(1));
    cell.stiffness = profile.EI;
    cell.may_be_cut = !profile.arc_centre && model.discretization.joints(at) == nullptr;
    // By stations between its ends, where there are two: those at nodes may be of the next cell.
    const std::size_t a = last - first > 2 ? first + 1 : first,
                      b = last - first > 2 ? last - 1 : last;
    const Station &near = frame.line[a], &far = frame.line[b];
    const double slope = (far.force[0] - near.force[0]) / (far.s - near.s);
    cell.begin = -(near.force[0] + slope * (frame.line[first].s - near.s));
    cell.end = -(near.force[0] + slope * (frame.line[last].s - near.s));
    if (model.discretization.pipe_cells()[index].reversed)
      std::swap(cell.begin, cell.end);
    if (cell.length > 0. && cell.stiffness > 0. && std::isfinite(cell.begin + cell.end))
      cells.push_back(cell);
  }

  /// Of cells, along them [N].
  double largest_force() const {
    double largest = 0.;
    for (const PressedCell &cell : cells)
      largest = std::max({largest, std::abs(cell.begin), std::abs(cell.end)});
    return largest;
  }

  void assemble(const double touching) {
    base = model.linear.stiffness();
    const Vector diagonal = base.diagonal();
    const double largest = diagonal.lpNorm<Eigen::Infinity>();
    std::vector<Eigen::Triplet<double>> entries;
    const std::vector<SupportState> states = states_of_contacts(model.contacts, frame);
    const auto touches = [&](const unsigned int i) {
      const Contact &contact = model.contacts[i];
      return i < states.size() && (!contact.law.has_closed_form() || contact.platen_force != 0. ||
                                   !stands_off(states[i], touching));
    };
    const auto force = [&](const unsigned int i) { return std::abs(states[i].fn); };
    const std::vector<bool> idle = contacts_that_do_not_hold(model.contacts, touches, force,
                                                             carries_nothing * largest_force());
    for (unsigned int i = 0; i < model.contacts.size(); ++i)
      if (touches(i) && !idle[i])
        add_contact(model.contacts[i], states[i], held * largest, entries);
    for (int i = 0; i < diagonal.size(); ++i)
      entries.emplace_back(i, i, rounding_of_diagonal * diagonal[i] + nothing * largest);
    SparseMatrix supports(base.rows(), base.cols());
    supports.setFromTriplets(entries.begin(), entries.end());
    base += supports;
  }

  static void add_contact(const Contact &contact, const SupportState &state, const double rigid,
                          std::vector<Eigen::Triplet<double>> &entries) {
    const bool is_known = contact.law.has_closed_form();
    const FrictionThreshold &law = contact.law.closed_form();
    const auto stiffness = [&](const double rigidity) {
      return is_known && std::isfinite(rigidity)
                 ? std::min(rigid, rigidity * contact.weight / std::pow(contact.length, 2))
                 : rigid;
    };
    const auto hold = [&](const Vector &row, const double k) {
      for (int a = 0; a < row.size(); ++a)
        for (int b = 0; b < row.size(); ++b)
          if (row[a] * row[b] != 0.)
            entries.emplace_back(contact.unknowns[a], contact.unknowns[b], k * row[a] * row[b]);
    };
    const Eigen::MatrixXd motions = contact.length * contact.B.topRows<3>();
    hold(motions.row(0), stiffness(law.axial_rigidity));
    if (!is_known || state.status == ContactStatus::stick) {
      hold(motions.row(1), stiffness(law.shear_rigidity_y));
      hold(motions.row(2), stiffness(law.shear_rigidity_z));
    } else if (state.status == ContactStatus::slip) {
      const double friction = std::hypot(state.ft1, state.ft2),
                   slip = std::hypot(state.slip1, state.slip2);
      if (friction > 0.)
        hold((state.ft1 * motions.row(1) - state.ft2 * motions.row(2)) / friction,
             std::min(stiffness(law.shear_rigidity_y), slip > 0. ? friction / slip : rigid));
    }
  }

  /// The matrix on the 12 motions of the ends that this one is in either plane along the cell.
  Matrix12 on_ends(const PressedCell &cell, const Matrix4 &transverse) const {
    const auto at = model.discretization.pipe_cell(cell.index);
    const LocalAxes axes(at->vertex(1) - at->vertex(0));
    Matrix12 result = Matrix12::Zero();
    for (const Vector3 &across : {axes.y, axes.z}) {
      const Vector3 turn = cross_product_3d(axes.x, across); // slope: across . (rotation x axis)
      Eigen::Matrix<double, 4, 12> pick = Eigen::Matrix<double, 4, 12>::Zero();
      for (unsigned int d = 0; d < 3; ++d)
        for (int end = 0; end < 2; ++end) {
          pick(2 * end, 6 * end + d) = across[d];
          pick(2 * end + 1, 6 * end + 3 + d) = turn[d];
        }
      result += pick.transpose() * transverse * pick;
    }
    return result;
  }

  std::vector<dealii::types::global_dof_index> dofs_of(const PressedCell &cell) const {
    std::vector<dealii::types::global_dof_index> dofs(12);
    model.discretization.pipe_cell(cell.index)->get_dof_indices(dofs);
    return dofs;
  }

  Eigen::Matrix<double, 12, 1> ends_of(const PressedCell &cell, const Vector &dofs) const {
    const auto places = dofs_of(cell);
    Eigen::Matrix<double, 12, 1> ends;
    for (int i = 0; i < 12; ++i)
      ends[i] = dofs[places[i]];
    return ends;
  }

  /// @return negative eigenvalues of the cell with clamped ends, in one plane
  int soften(const PressedCell &cell, const double factor, MatrixEntries &entries) const {
    const Softening soft = softening_of(cell, factor);
    if (!soft.matrix.isZero(0.))
      model.space.add_local(on_ends(cell, soft.matrix), dofs_of(cell), entries);
    return soft.n_negative;
  }

  const Model &model;
  const Frame &frame;
  std::vector<PressedCell> cells; ///< those of a pipe one after the other
  SparseMatrix base;
  /// Unknowns are numbered along the line, which leaves little fill.
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
      factored;
};

} // namespace

std::optional<Buckling> buckling_of(const Model &model, const Frame &frame, const double least,
                                    const double touching) {
  BucklingProblem problem(model, frame, touching);
  if (!problem.is_pressed())
    return {};
  double above = 1. / least, below = 0.;
  const int n_above = problem.n_negative(above);
  if (n_above == 0)
    return {};
  const int at_rest = problem.n_negative(0.);
  if (n_above <= at_rest)
    return {};
  while (above - below > resolved * above) {
    const double middle = (above + below) / 2.;
    (problem.n_negative(middle) > at_rest ? above : below) = middle;
  }
  Buckling result = problem.shape(below);
  result.ratio = 1. / above;
  return result;
}

} // namespace frictionbeam
