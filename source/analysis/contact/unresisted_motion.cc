// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/unresisted_motion.h"

#include "base/algebra/dense_algebra.h"

#include <algorithm>
#include <limits>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr double most_of_loads = 1e6; ///< that contacts might press with
constexpr unsigned int most_iterations = 500;

/// A force that a contact may give, of normal force one, as the work it does on unit motions.
struct Ray {
  Eigen::VectorXd work;
  double on_motion = 0.; ///< its work on the motion that it was made for
};

/// Of all contacts' forces the one that takes most work from a motion.
Ray most_resisting(const std::vector<MovedContact> &contacts, const Eigen::VectorXd &motion) {
  Ray worst{Eigen::VectorXd::Zero(motion.size()), 0.};
  for (const MovedContact &contact : contacts) {
    const Eigen::Vector3d d = contact.motion * motion;
    const double sliding = d.tail<2>().norm();
    const double work = -d[0] - contact.friction * sliding;
    if (work >= worst.on_motion)
      continue;
    Eigen::Vector3d force(-1., 0., 0.);
    if (sliding > 0.)
      force.tail<2>() = -contact.friction / sliding * d.tail<2>();
    worst = {contact.motion.transpose() * force, work};
  }
  return worst;
}

/// The same of all processes.
Ray most_resisting_of_all(const std::vector<MovedContact> &contacts, const Eigen::VectorXd &motion,
                          const MPI_Comm communicator) {
  const Ray own = most_resisting(contacts, motion);
  std::vector<double> data(own.work.data(), own.work.data() + own.work.size());
  data.push_back(own.on_motion);
  const auto all = Utilities::MPI::all_gather(communicator, data);
  const auto &worst = *std::min_element(
      all.begin(), all.end(), [](const auto &a, const auto &b) { return a.back() < b.back(); });
  return {Eigen::Map<const Eigen::VectorXd>(worst.data(), motion.size()), worst.back()};
}

/// Loads and forces of some contacts, as large as leaves least.
class LeastLeft {
public:
  explicit LeastLeft(const Eigen::VectorXd &loads)
      : loads(loads), rays(loads.size(), 0), left(loads) {}

  void add(const Eigen::VectorXd &ray);
  const Eigen::VectorXd &motion() const { return left; }

private:
  const Eigen::VectorXd loads;
  Eigen::MatrixXd rays; ///< columns of positive size
  Eigen::VectorXd sizes, left;
};

void LeastLeft::add(const Eigen::VectorXd &ray) {
  rays.conservativeResize(Eigen::NoChange, rays.cols() + 1);
  rays.rightCols<1>() = ray.normalized();
  sizes.conservativeResize(rays.cols());
  sizes[rays.cols() - 1] = 0.;
  while (rays.cols() > 0) {
    const Eigen::VectorXd wanted = LeastSquares(rays).solve(-loads);
    double part = 1.; // of the way there on which all stay positive
    for (Eigen::Index k = 0; k < wanted.size(); ++k)
      if (wanted[k] <= 0.)
        part = std::min(part, sizes[k] / (sizes[k] - wanted[k]));
    sizes += part * (wanted - sizes);
    Eigen::Index kept = 0;
    for (Eigen::Index k = 0; k < wanted.size(); ++k)
      if (wanted[k] > 0. || sizes[k] > std::numeric_limits<double>::epsilon() * sizes.maxCoeff()) {
        sizes[kept] = sizes[k];
        rays.col(kept++) = rays.col(k);
      }
    const bool all_stay = kept == rays.cols();
    sizes.conservativeResize(kept);
    rays.conservativeResize(Eigen::NoChange, kept);
    if (all_stay)
      break;
  }
  left = loads + rays * sizes;
}

} // namespace

std::optional<Eigen::VectorXd> unresisted_motion(const Eigen::VectorXd &loads,
                                                 const std::vector<MovedContact> &contacts,
                                                 const MPI_Comm communicator) {
  constexpr double rounding = 1e-9;
  LeastLeft least(loads);
  for (unsigned int iteration = 0; iteration < most_iterations; ++iteration) {
    const Eigen::VectorXd &motion = least.motion();
    if (!(motion.norm() > rounding * loads.norm()))
      return {};
    const Ray worst = most_resisting_of_all(contacts, motion, communicator);
    if (-worst.on_motion * most_of_loads * loads.norm() <= motion.squaredNorm())
      return motion;
    least.add(worst.work);
  }
  return {};
}

} // namespace frictionbeam
