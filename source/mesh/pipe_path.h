// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam {

/// The axis of a pipe: straight runs and circular bends, as its route or the cells of a mesh file
/// give them, by arc length.
class PipePath {
public:
  struct Segment {
    double start = 0., length = 0.; ///< along the pipe [m]
    Point3 begin, end;
    double radius = 0.;    ///< of a bend; 0: straight
    Point3 centre;         ///< of a bend
    Vector3 first_tangent; ///< unit
    Vector3 inward;        ///< of a bend: unit, from its beginning to its centre

    Point3 point(const double s) const; ///< s from the segment's start [m]
    Vector3 tangent(const double s) const;
    /// Arc length along the pipe at @p position, if that is within @p tolerance [m].
    std::optional<double> place(const Point3 &position, const double tolerance) const;
  };

  /// What a bend takes of the legs that it joins.
  struct Corner {
    double cut = 0.;   ///< of either leg [m]
    double angle = 0.; ///< between them [rad]; 0: no bend
    Vector3 next;      ///< unit, along the second
  };

  /// @param units of messages
  /// @throws UserError if a bend does not fit between its neighbours or the route turns back.
  PipePath(const Pipe &pipe, const UnitSystem &units);

  double length() const { return total_length; }
  const std::vector<Segment> &segments() const { return parts; }

  Point3 point(const double s) const;

  /// Arc lengths of the path's points at @p position, within @p tolerance [m], rising; a place
  /// between two segments once.
  std::vector<double> all_places(const Point3 &position, const double tolerance) const;

  /// A point of the route that is on the path: its ends, a sharp corner, the middle of a bend whose
  /// corner has a name. Of a file: the nodes.
  struct RoutePlace {
    std::string name; ///< may be empty
    double s;
  };
  const std::vector<RoutePlace> &route_points() const { return places; }

  /// Of segments that follow each other and the places on them.
  PipePath(std::vector<Segment> segments, std::vector<RoutePlace> route_points);

private:
  const Segment &segment_at(const double s) const;
  void append(Segment segment);
  /// The straight part of a leg along unit vector @p tangent.
  void append_run(const Point3 &begin, const Vector3 &tangent, const double length);
  void append_bend(const Corner &corner, const RoutePoint &at, const Vector3 &tangent);

  std::vector<Segment> parts;
  std::vector<RoutePlace> places;
  double total_length = 0.;
};

/// Of all pipes of a scene, by their routes.
std::vector<PipePath> paths_of(const Scene &scene);

} // namespace frictionbeam
