// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/solid/patch_layout.h"

#include "base/user_error.h"
#include "scene/in_units.h"
#include <frictionbeam/generalized_strain.h>

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

namespace {

class PatchLayout {
public:
  PatchLayout(const Scene &scene, const LineMesh &line, const PipeWall &wall)
      : scene(scene), line(line), wall(wall), rounding(1e-6 * wall.outer) {}

  WallPatch patch(const unsigned int support, const unsigned int site) const;

private:
  struct Run {
    double begin, end;
  };
  /// The straight run that a segment is a part of.
  Run run_of(const WallSegment &segment) const;
  void check_width(const WallPatch &patch) const;
  void check_on_run(const WallPatch &patch, const double s) const;
  void check_anchors(const WallPatch &patch) const;
  /// Where round the pipe the patch is; of a collar, where along it as well.
  void lay_across(const Vector3 &normal, const double s, WallPatch &patch) const;
  bool is_straight(const unsigned int segment) const {
    return wall.segments[segment].path.radius == 0.;
  }
  std::string text(const double length) const { return in_units(scene.units, length, "m"); }

  const Scene &scene;
  const LineMesh &line;
  const PipeWall &wall;
  const double rounding;
};

PatchLayout::Run PatchLayout::run_of(const WallSegment &segment) const {
  Run run{segment.start, segment.start + segment.path.length};
  const unsigned int number = &segment - wall.segments.data();
  for (unsigned int before = number; before > 0 && is_straight(before - 1); --before)
    run.begin = wall.segments[before - 1].start;
  for (unsigned int next = number + 1; next < wall.segments.size() && is_straight(next); ++next)
    run.end = wall.segments[next].start + wall.segments[next].path.length;
  return run;
}

void PatchLayout::check_width(const WallPatch &patch) const {
  const double least = 4. * one_place * wall.outer; // a ring in its middle, and one at each edge
  if (patch.to - patch.from < least)
    throw UserError("Support " + scene.supports[patch.support].name +
                    ": its patch is narrower than rings of cells can be.\n  read:    Width = " +
                    text(patch.to - patch.from) + "\n  allowed: Width = " + text(least) +
                    " or more\n  try:     the width of the shoe, or no Width: one diameter");
}

void PatchLayout::check_on_run(const WallPatch &patch, const double s) const {
  const bool leaves = patch.from < -rounding || patch.to > wall.length() + rounding;
  const WallSegment &segment = wall.segment_at(s);
  const Run run = run_of(segment);
  const bool on_bend = segment.path.radius > 0.;
  if (!leaves && !on_bend && patch.from >= run.begin - rounding && patch.to <= run.end + rounding)
    return;
  const double most = 2. * std::min(s - run.begin, run.end - s);
  throw UserError("Support " + scene.supports[patch.support].name + ": its patch " +
                  (leaves ? "leaves the pipe" : "overlaps a bend") +
                  ".\n  read:    a patch of width " + text(patch.to - patch.from) + " at " +
                  in_units(scene.units, line.vertices[patch.vertex]) +
                  (on_bend ? ", in a bend"
                           : ", on a run from " + text(s - run.begin) + " before to " +
                                 text(run.end - s) + " behind it") +
                  "\n  allowed: with Model = solid, a patch that lies on one straight run, over "
                  "Width along the "
                  "pipe\n  try:     " +
                  (on_bend || most < 0.1 * wall.outer
                       ? "the support further from there"
                       : "Width = " + text(most) + " or less, or the support further from there"));
}

void PatchLayout::check_anchors(const WallPatch &patch) const {
  for (unsigned int i = 0; i < scene.restraints.size(); ++i)
    for (const Site &site : line.restraints[i]) {
      const auto &fixed = scene.restraints[i].fixed;
      if (std::count(fixed.begin(), fixed.end(), true) < 6)
        continue; // the section moves in itself
      const double s = wall.s_of(line, site.vertex);
      if (s > patch.from - rounding && s < patch.to + rounding)
        throw UserError("Support " + scene.supports[patch.support].name +
                        ": its patch covers anchor " + scene.restraints[i].name +
                        ".\n  read:    a patch of width " + text(patch.to - patch.from) + " at " +
                        in_units(scene.units, line.vertices[patch.vertex]) +
                        "\n  allowed: with Model = solid, patches away from anchors, which hold "
                        "all of the section\n  try:     a smaller Width, or the support further "
                        "from the anchor");
    }
}

void PatchLayout::lay_across(const Vector3 &normal, const double s, WallPatch &patch) const {
  const WallSegment &segment = wall.segment_at(s);
  const Vector3 &tangent = segment.path.first_tangent;
  const double along = normal * tangent;
  patch.is_collar = std::abs(along) > 1. - square_enough;
  if (patch.is_collar) {
    // What pushes it forward stands before a collar, what pushes it back behind another one.
    const double third = (patch.to - patch.from) / 3.;
    (along > 0. ? patch.from : patch.to) = s + (along > 0. ? 0.5 : -0.5) * third;
    patch.outward = segment.a;
    return;
  }
  if (std::abs(along) > square_enough)
    throw UserError("Support " + scene.supports[patch.support].name +
                    ": it pushes askew on the pipe.\n  read:    a Normal that is neither along the "
                    "pipe nor square to it\n  allowed: normals along or across the pipe with Model "
                    "= solid; any of a guide or stop without gap and friction\n  try:     Normal = "
                    "along or across, or Model = line");
  const Vector3 across = normal - along * tangent;
  patch.outward = -across / across.norm();
}

WallPatch PatchLayout::patch(const unsigned int support, const unsigned int site) const {
  const FrictionSupport &of = scene.supports[support];
  const Site &at = line.supports[support][site];
  WallPatch patch;
  patch.support = support;
  patch.site = site;
  patch.vertex = at.at;
  patch.part = "support " + of.name +
               (n_places(line.supports[support]) > 1 ? "." + std::to_string(at.place + 1) : "");
  const double width = of.width > 0. ? of.width : 2. * wall.outer,
               s = wall.s_of(line, patch.vertex);
  patch.from = s - width / 2.;
  patch.to = s + width / 2.;
  check_width(patch);
  check_on_run(patch, s);
  check_anchors(patch);
  lay_across(push_of(of, at.tangent), s, patch);
  return patch;
}

} // namespace

Vector3 push_of(const FrictionSupport &support, const Vector3 &tangent) {
  const Direction &normal = support.normal;
  return normal.sign * (normal.kind == Direction::Kind::global  ? normal.vector
                        : normal.kind == Direction::Kind::along ? tangent
                                                                : LocalAxes(tangent).y);
}

std::vector<WallPatch> lay_patches(const Scene &scene, const LineMesh &line, const PipeWall &wall) {
  const PatchLayout layout(scene, line, wall);
  std::vector<WallPatch> patches;
  for (unsigned int i = 0; i < scene.supports.size(); ++i)
    for (unsigned int k = 0; k < line.supports[i].size(); ++k)
      if (k == 0 || line.supports[i][k].place != line.supports[i][k - 1].place) // edges have one
        patches.push_back(layout.patch(i, k));
  return patches;
}

} // namespace frictionbeam
