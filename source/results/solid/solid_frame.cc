// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/solid/solid_frame.h"

#include "model/unknowns/restraint_forces.h"
#include "results/frame/frame_builder.h"
#include "results/support/support_states.h"

#include <algorithm>
#include <limits>

namespace frictionbeam {

using namespace dealii;

namespace {

/// The section forces of a cut in the local axes of a pipe there.
/// @param moved_thrust what the thrust has by the section's motion
void set_force(Motion cut, const Motion &moved_thrust, const double thrust, Station &station,
               const Vector3 &x) {
  for (unsigned int c = 0; c < 6; ++c)
    cut[c] -= moved_thrust[c];
  const Vector3 force({cut[0], cut[1], cut[2]}), moment({cut[3], cut[4], cut[5]});
  station.force = {{force * x - thrust, force * station.y, force * station.z, moment * x,
                    moment * station.y, moment * station.z}};
}

class FrameOfWall {
public:
  FrameOfWall(const Scene &scene, const PipeWall &wall, const std::vector<RingState> &rings,
              const double thrust)
      : scene(scene), wall(wall), rings(rings), thrust(thrust) {}

  /// @param jumps whether forces differ on either side of a ring
  std::vector<Station> stations(const std::vector<bool> &jumps) const;

private:
  Station station(const unsigned int ring, const unsigned int layer) const;

  const Scene &scene;
  const PipeWall &wall;
  const std::vector<RingState> &rings;
  const double thrust;
};

Station FrameOfWall::station(const unsigned int ring, const unsigned int layer) const {
  const WallRing &at = wall.rings[ring];
  const WallSegment &segment = wall.segments[wall.layer_segment[layer]];
  Station station;
  station.pipe = segment.pipe;
  station.s = std::max(0., at.s - wall.pipe_start[station.pipe]);
  station.position = at.centre;
  if (at.vertex)
    station.vertex = *at.vertex;
  station.displacement = rings[ring].displacement;
  const LocalAxes axes(at.tangent);
  station.y = station.y_now = axes.y;
  station.z = station.z_now = axes.z;
  double length = 0.;
  for (const WallSegment &other : wall.segments)
    if (other.pipe == station.pipe)
      length += other.path.length;
  station.part = station.s / length;
  station.bend_radius = segment.path.radius;
  if (segment.path.radius > 0.)
    station.bend_axis = cross_product_3d(segment.path.first_tangent, segment.path.inward);
  return station;
}

std::vector<Station> FrameOfWall::stations(const std::vector<bool> &jumps) const {
  std::vector<std::vector<Station>> by_pipe(scene.pipes.size());
  for (unsigned int r = 0; r < rings.size(); ++r) {
    const bool first = r == 0, last = r + 1 == rings.size();
    Motion mean = rings[r].cut[first ? 1 : 0];
    if (!first && !last)
      for (unsigned int c = 0; c < 6; ++c)
        mean[c] = 0.5 * (mean[c] + rings[r].cut[1][c]);
    const bool two =
        !first && !last && (jumps[r] || wall.pipe_of_layer(r - 1) != wall.pipe_of_layer(r));
    for (const unsigned int side : {0u, 1u}) {
      if (side == 0 ? first : last || (!first && !two))
        continue;
      Station one = station(r, side == 0 ? r - 1 : r);
      set_force(jumps[r] ? rings[r].cut[side] : mean, rings[r].moved_thrust, thrust, one,
                wall.rings[r].tangent);
      by_pipe[one.pipe].push_back(one);
    }
  }
  std::vector<Station> all;
  for (const auto &stations : by_pipe)
    all.insert(all.end(), stations.begin(), stations.end());
  return all;
}

/// Of all processes. @param contact the beam's, by whose axes forces are told @param place on the
/// pipe's axis
SupportState patch_state(const ContinuumBody<3> &body, const FoundationContacts &contacts,
                         const ContinuumState &state, const unsigned int surface,
                         const Contact &contact, const Point3 &place) {
  // fn, ft1, ft2, slips, weight, work, sticking, slipping, closed, moment
  std::vector<double> sums(13, 0.);
  double gap = std::numeric_limits<double>::max();
  for (unsigned int i = 0; i < body.nodes.size(); ++i) {
    if (body.nodes[i].surface != surface)
      continue;
    const double w = body.nodes[i].weight;
    const LocalVector &stress = state.contacts.stress[i];
    const LocalVector slip = contacts.slip(i, state.contact_displacement[i], state.contacts);
    const ContactStatus status = state.contacts.status[i];
    SupportState of_node;
    of_node.fn = -w * stress[0];
    of_node.ft1 = w * stress[1];
    of_node.ft2 = w * stress[2];
    sums[0] += of_node.fn;
    sums[1] += of_node.ft1;
    sums[2] += of_node.ft2;
    const Vector3 moment =
        cross_product_3d(body.nodes[i].position - place, force_along_axes(contact, of_node));
    for (unsigned int d = 0; d < 3; ++d)
      sums[10 + d] += moment[d];
    if (status != ContactStatus::open) {
      sums[3] += w * slip[1];
      sums[4] += w * slip[2];
      sums[5] += w;
    }
    sums[6] += w * state.contacts.dissipated[i];
    sums[7] += status == ContactStatus::stick ? 1. : 0.;
    sums[8] += status == ContactStatus::slip ? 1. : 0.;
    sums[9] += status == ContactStatus::closed ? 1. : 0.;
    gap = std::min(gap, contacts.gap(i, state.contact_displacement[i]));
  }
  Utilities::MPI::sum(sums, body.communicator, sums);
  gap = Utilities::MPI::min(gap, body.communicator);
  SupportState result;
  result.fn = sums[0];
  result.ft1 = sums[1];
  result.ft2 = sums[2];
  result.gap = gap;
  if (sums[5] > 0.) {
    result.slip1 = sums[3] / sums[5];
    result.slip2 = sums[4] / sums[5];
  }
  result.work_friction = sums[6];
  result.status = sums[7] > 0.   ? ContactStatus::stick
                  : sums[8] > 0. ? ContactStatus::slip
                  : sums[9] > 0. ? ContactStatus::closed
                                 : ContactStatus::open;
  const Vector3 force = force_along_axes(contact, result);
  for (unsigned int d = 0; d < 3; ++d) {
    result.on_pipe[d] = force[d];
    result.on_pipe[3 + d] = sums[10 + d];
  }
  return result;
}

} // namespace

Frame solid_frame(const Scene &scene, const Model &line, const PipeWall &wall,
                  const WallLoads &loads, const ContinuumBody<3> &body,
                  const FoundationContacts &contacts, const ContinuumState &state,
                  const std::vector<RingState> &rings) {
  std::vector<bool> jumps(rings.size(), false);
  for (unsigned int r = 0; r < rings.size(); ++r)
    jumps[r] = loads.is_loaded(r) ||
               std::any_of(wall.patches.begin(), wall.patches.end(),
                           [&](const WallPatch &patch) { return patch.covers(wall.rings[r].s); });
  Frame frame;
  frame.reactions = restraint_forces(scene, line.mesh, [&](const unsigned int vertex) {
    const unsigned int ring = wall.ring_at(vertex);
    jumps[ring] = true;
    return rings[ring].held;
  });
  const double thrust = loads.pressure(state.factors) * wall.bore_area();
  frame.line = FrameOfWall(scene, wall, rings, thrust).stations(jumps);
  for (const auto &of_place : line.contacts.places()) {
    const Contact &contact = line.contacts[of_place.front()];
    const auto patch =
        std::find_if(wall.patches.begin(), wall.patches.end(), [&](const WallPatch &one) {
          return one.support == contact.support && one.site == contact.site;
        });
    Assert(patch != wall.patches.end(), ExcInternalError());
    frame.supports.push_back(patch_state(body, contacts, state, patch - wall.patches.begin(),
                                         contact, line.mesh.vertices[patch->vertex]));
  }
  frame.together = FrameBuilder(line).together(frame);
  frame.step = state.step;
  frame.name = scene.steps[state.step].name;
  frame.step_before = state.step > 0 ? static_cast<int>(state.step) - 1 : -1;
  frame.increment = state.increment;
  frame.time = state.time;
  return frame;
}

} // namespace frictionbeam
