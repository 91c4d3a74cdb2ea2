// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene.h"

#include <cstdint>

namespace oracle {

/// Numbers that follow from a seed on every machine (splitmix64). Of two in one expression a
/// compiler draws either first: each is drawn in a statement of its own.
class Random {
public:
  explicit Random(const std::uint64_t seed) : state(seed) {}

  double number(const double low, const double high) {
    return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
  }
  int whole(const int low, const int high) { // both included
    return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(const double part) { return number(0., 1.) < part; }
  template <typename List>
  const auto &pick(const List &list) {
    return list[whole(0, static_cast<int>(list.size()) - 1)];
  }
  Vec direction() { // evenly over the sphere
    const double z = number(-1., 1.), turn = number(0., 2. * pi), r = std::sqrt(1. - z * z);
    return Vec(r * std::cos(turn), r * std::sin(turn), z);
  }
  Vec vector(const double shortest, const double longest) { // in any direction
    const Vec along = direction();
    return number(shortest, longest) * along;
  }

private:
  std::uint64_t next() {
    std::uint64_t z = state += 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }

  std::uint64_t state;
};

/// What a random scene may have.
struct Kinds {
  bool contacts = false;  ///< unilateral supports with and without friction
  bool transient = false; ///< a transient step at the end
  /// Further features. They are drawn after all others from a stream of their own, so that the
  /// scene of a seed without them stays what it is.
  bool more = false;     ///< of statics: grounds on pipes, beds, torsion, sized hangers, histories
  bool moving = false;   ///< of transient steps: dynamic friction, snubbers, damping, moving ground
  bool large = false;    ///< large displacements
  bool response = false; ///< modes, spectra, combinations, stresses, nozzles
  bool elastic = false;  ///< all contacts have a stiffness of their own
  bool yielding = false; ///< sections that yield and creep
};

/// The kinds of a family's name: more, moving, large, response, yielding; or none of these if it is
/// empty.
Kinds kinds_of(const std::string &family, Random &random);

/// The scene of a seed: an anchored line with branches, and everything on it that is drawn.
Scene random_scene(std::uint64_t seed, const Kinds &kinds);

/// Leave out what a line with laws of sections refuses.
void allow_laws(Scene &scene);
/// Laws for all sections that can have one; if they do not yield, the line is elastic.
void give_laws(Scene &scene, Random &random, bool yield);

} // namespace oracle
