// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/line_mesh.h"
#include "results/results.h"
#include "results/stress/stress_code.h"

namespace frictionbeam {

/// The stress code applied to the stations of a line: what it is there, which forces count.
class StressEvaluation {
public:
  StressEvaluation(const Scene &scene, const LineMesh &mesh, const Results &results);

  /// The end of a step, or a combination; null if it was not reached.
  const Frame *frame_of(const std::string &step) const;

  StressPoint point(const Station &station) const;

  /// @throws UserError naming the first place that the code has nothing for, or where it does what
  /// no code may.
  void check(const std::vector<Station> &line) const;

  /// What a station makes of its section forces N, Vy, Vz, Mx, My, Mz.
  struct Axes {
    double y = 0., z = 0.; ///< local axes' part in the normal of the bend's or tee's plane
    double pressure = 0.;
    StressForces forces(const double *const section) const {
      StressForces result;
      result.axial = section[0];
      result.torsion = section[3];
      result.pressure = pressure;
      result.in_plane = section[4] * y + section[5] * z;
      const double rest =
          section[4] * section[4] + section[5] * section[5] - result.in_plane * result.in_plane;
      result.out_of_plane = rest > 0. ? std::sqrt(rest) : 0.;
      return result;
    }
  };
  Axes axes(const Station &station, const double pressure) const;

  /// Unit normal of the plane of the tee there; zero elsewhere.
  static Vector3 normal_of_tee(const Scene &scene, const LineMesh &mesh, const Station &station);

  const Scene &scene;
  const Results &results;
  const StressCode code;

private:
  /// Where a tee stands: its vertex, the normal of its plane, its branch and one pipe of its run.
  struct TeeSite {
    const Tee *tee;
    unsigned int vertex;
    Vector3 normal;
    unsigned int branch, run;
  };
  static std::vector<TeeSite> find_tees(const Scene &scene, const LineMesh &mesh);
  /// What the station's pipe is there, without a tee.
  StressPoint point_of_pipe(const Station &station) const;
  StressPoint point_at(const TeeSite &site, const Station &station) const;
  /// The tee that counts for a station: of a branch its own, of a run that with the largest
  /// factors; null where there is none.
  const TeeSite *tee_at(const Station &station) const;

  const std::vector<TeeSite> tees;
};

} // namespace frictionbeam
