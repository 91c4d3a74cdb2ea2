// SPDX-License-Identifier: LGPL-2.1-or-later
// Factors of the directions alone in which contacts give way: the same solution as that of the
// whole matrix, with whatever contacts do, and none where there is none.
#include "../check.h"

#include "../../plugin/contact/reduced_tangent.h"

#include <frictionbeam/law_library.h>

#include <Eigen/QR>

#include <random>

using namespace frictionbeam;
using contact::Block;
using contact::ReducedTangent;
using contact::Site;
using Vector = contact::Vector;

namespace {

std::minstd_rand engine;
LawLibrary laws;

double number(const double from, const double to) {
  return std::uniform_real_distribution<double>(from, to)(engine);
}

Eigen::MatrixXd numbers(const int n_rows, const int n_columns) {
  Eigen::MatrixXd matrix(n_rows, n_columns);
  for (int i = 0; i < n_rows; ++i)
    for (int j = 0; j < n_columns; ++j)
      matrix(i, j) = number(-1., 1.);
  return matrix;
}

/// A contact that turns any way, on one node or, as a difference, on two.
Site contact_on(const std::vector<int> &nodes) {
  const LawDescription &law = laws.find("coulomb");
  std::vector<double> parameters;
  for (int i = 0; i < law.n_parameters; ++i)
    parameters.push_back(law.parameters[i].default_value);
  Site site;
  site.law = BoundLaw(law, parameters);
  const Eigen::Matrix3d any = numbers(3, 3),
                        frame = Eigen::HouseholderQR<Eigen::Matrix3d>(any).householderQ();
  site.weight = number(0.5, 2.);
  site.B.setZero(contact::n_strains, 3 * nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    for (int d = 0; d < 3; ++d)
      site.unknowns.push_back(3 * nodes[k] + d);
    site.B.block<3, 3>(0, 3 * k) = k == 0 ? frame : Eigen::Matrix3d(-frame);
  }
  return site;
}

enum class Does { stick, slip, open };

/// What a proximal contact of stiffness @p stiff does.
Block tangent(const Does what, const double stiff) {
  Block D = Block::Zero();
  if (what == Does::open)
    return D;
  D(0, 0) = stiff;
  if (what == Does::stick)
    D(1, 1) = D(2, 2) = stiff;
  else {
    D(1, 0) = 0.3 * stiff;
    D(2, 0) = -0.2 * stiff;
    D(1, 1) = number(0., 1.);
    D(2, 2) = number(0., 1.);
    D(1, 2) = D(2, 1) = number(-0.1, 0.1);
  }
  return D;
}

using Precise = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

struct Scene {
  Eigen::MatrixXd S;
  std::vector<Site> sites;
  std::vector<Block> stiffness;

  /// In so many digits that the stiff contacts leave those of the body.
  Precise whole() const {
    Precise matrix = S.cast<long double>();
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const Precise B = sites[i].B.cast<long double>(),
                    block = sites[i].weight * B.transpose() * stiffness[i].cast<long double>() * B;
      for (std::size_t a = 0; a < sites[i].unknowns.size(); ++a)
        for (std::size_t b = 0; b < sites[i].unknowns.size(); ++b)
          matrix(sites[i].unknowns[a], sites[i].unknowns[b]) += block(a, b);
    }
    return matrix;
  }
};

/// @param shared whether contacts share nodes, so that few of their unknowns are their own
Scene scene_of(const int n_nodes, const bool shared, const double stiff) {
  Scene scene;
  const Eigen::MatrixXd root = numbers(3 * n_nodes, 3 * n_nodes);
  scene.S = root * root.transpose() / (3 * n_nodes) +
            0.05 * Eigen::MatrixXd::Identity(3 * n_nodes, 3 * n_nodes);
  for (int node = 0; node + 1 < n_nodes; node += shared ? 1 : 2) {
    const bool on_two = number(0., 1.) < 0.5;
    scene.sites.push_back(
        contact_on(on_two ? std::vector<int>{node, node + 1} : std::vector<int>{node}));
    const Does what =
        std::array<Does, 3>{Does::stick, Does::slip, Does::open}[int(number(0., 2.999))];
    scene.stiffness.push_back(tangent(what, stiff));
  }
  return scene;
}

void same_solution(const Scene &scene, const std::string &name) {
  std::vector<std::vector<int>> unknowns;
  for (const Site &site : scene.sites)
    unknowns.push_back(site.unknowns);
  const contact::SiteList list(scene.sites);
  const contact::SparseMatrix S = scene.S.sparseView();
  ReducedTangent reduced(S, list, unknowns);
  check::truth(reduced.factorize(scene.stiffness), (name + " factors").c_str(), __FILE__, __LINE__);
  const Vector b = numbers(scene.S.rows(), 1);
  Vector x;
  check::truth(reduced.solve(b, x), (name + " solves").c_str(), __FILE__, __LINE__);
  const Precise forces = b.cast<long double>();
  const Vector expected = Precise(scene.whole().fullPivLu().solve(forces)).cast<double>();
  check::truth((x - expected).norm() < 1e-7 * expected.norm(),
               (name + " has the same solution").c_str(), __FILE__, __LINE__);
}

} // namespace

int main() {
  laws.load_builtin();
  for (int seed = 1; seed <= 40; ++seed) {
    engine.seed(seed);
    for (const double stiff : {1e4, 1e6, 1e9}) {
      const std::string name = "seed " + std::to_string(seed) + ", " + std::to_string(stiff);
      same_solution(scene_of(12, false, stiff), name);
      if (stiff < 1e9) // those keep their stiffness among the unknowns, and its rounding with it
        same_solution(scene_of(12, true, stiff), name + ", shared");
    }
  }

  // Contacts that stick are not factored, those that slip by two directions, those open by three.
  engine.seed(7);
  Scene scene = scene_of(6, false, 1e6);
  for (Site &site : scene.sites)
    site = contact_on({site.unknowns[0] / 3});
  std::vector<std::vector<int>> unknowns;
  for (const Site &site : scene.sites)
    unknowns.push_back(site.unknowns);
  const contact::SiteList list(scene.sites);
  const contact::SparseMatrix S = scene.S.sparseView();
  ReducedTangent reduced(S, list, unknowns);
  const int without_contact = 18 - 9;
  for (const auto &[what, n_free] : {std::pair{Does::stick, 0}, {Does::slip, 2}, {Does::open, 3}}) {
    for (Block &block : scene.stiffness)
      block = tangent(what, 1e6);
    CHECK(reduced.factorize(scene.stiffness));
    CHECK(reduced.n_free() == without_contact + 3 * n_free);
  }

  // A body that nothing holds has no solution.
  const contact::SparseMatrix nothing(18, 18);
  ReducedTangent floating(nothing, list, unknowns);
  for (Block &block : scene.stiffness)
    block = tangent(Does::open, 1e6);
  CHECK(!floating.factorize(scene.stiffness));
  return check::report();
}
