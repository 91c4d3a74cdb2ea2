// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/line/routes.h"

#include "import/line/bend_geometry.h"

#include <algorithm>

namespace frictionbeam::import {

namespace {

constexpr double pi_of_routes = 3.14159265358979323846;
constexpr double density_of_steel = 7850.; ///< of rigid parts whose weight is not said [kg/m3]

/// A piece in the direction of its pipe.
struct Step {
  std::size_t piece;
  bool forward;
};

/// A point of a route before it is thinned.
struct Stop {
  PlannedPoint point;
  bool stays;
};

class RouteMaker {
public:
  RouteMaker(const PcfLine &line, const Network &network, const double tolerance, LinePlan &plan,
             Notes &notes)
      : line(line), network(network), tolerance(tolerance), plan(plan), notes(notes),
        pieces_at(network.pieces_at()), is_named(network.nodes.size(), false),
        pipe_of(network.pieces.size()) {
    names.nodes.resize(network.nodes.size());
    for (const Piece &piece : network.pieces)
      length_of_component[piece.component] += length_of(piece);
  }

  RouteNames make() {
    for (const std::vector<Placed> *const list :
         {&network.supports, &network.joints, &network.masses})
      for (const Placed &placed : *list)
        if (placed.node)
          is_named[*placed.node] = true;
        else if (placed.in_the_middle && names.bends[placed.piece].empty())
          names.bends[placed.piece] = next_name();
    for (const BranchFoot &branch : network.branches)
      is_named[branch.node] = true;
    std::vector<std::vector<Step>> chains;
    std::vector<bool> visited(network.pieces.size(), false);
    for (std::size_t i = 0; i < network.pieces.size(); ++i)
      if (!visited[i]) {
        chains.push_back(chain_of(i));
        for (const Step &step : chains.back()) {
          visited[step.piece] = true;
          pipe_of[step.piece] = chains.size() - 1;
        }
        is_named[begin(chains.back().front())] = is_named[end(chains.back().back())] = true;
      }
    for (const std::vector<Step> &chain : chains)
      add_pipe(chain);
    for (const BranchFoot &branch : network.branches)
      add_tee(branch);
    return std::move(names);
  }

private:
  unsigned int begin(const Step &step) const {
    const Piece &piece = network.pieces[step.piece];
    return step.forward ? piece.from : piece.to;
  }
  unsigned int end(const Step &step) const { return begin({step.piece, !step.forward}); }

  std::string next_name() { return "n" + std::to_string(n_names += 10); }

  const std::string &name_of(const unsigned int node) {
    if (names.nodes[node].empty())
      names.nodes[node] = next_name();
    return names.nodes[node];
  }

  bool is_like(const Piece &one, const Piece &other) const {
    const Properties &a = line.components[one.component].properties,
                     &b = line.components[other.component].properties;
    if (one.end_section || other.end_section) // a reducer that something stands on is one still
      return one.end_section && other.end_section && one.component == other.component;
    return one.section == other.section && one.material == other.material &&
           one.rigid == other.rigid &&
           a.number(Property::temperature) == b.number(Property::temperature) &&
           a.number(Property::pressure) == b.number(Property::pressure);
  }

  /// The step after @p step in the same pipe, if there is one.
  std::optional<Step> next(const Step &step) const {
    const unsigned int node = end(step);
    const Piece &here = network.pieces[step.piece];
    for (const std::size_t i : pieces_at[node]) {
      const Piece &there = network.pieces[i];
      if (i != step.piece && (pieces_at[node].size() == 2 || there.run == here.run) &&
          is_like(here, there))
        return Step{i, there.from == node};
    }
    return {};
  }

  std::vector<Step> chain_of(const std::size_t piece) const {
    Step first{piece, false};
    while (const auto before = next(first)) {
      first = *before;
      if (first.piece == piece)
        break; // a closed loop
    }
    first.forward = !first.forward;
    std::vector<Step> chain{first};
    while (const auto after = next(chain.back())) {
      if (after->piece == first.piece)
        break;
      chain.push_back(*after);
    }
    return chain;
  }

  std::vector<Stop> stops_of(const std::vector<Step> &chain) {
    const auto of_node = [&](const unsigned int node) {
      return Stop{{is_named[node] ? name_of(node) : "", network.nodes[node], 0.}, is_named[node]};
    };
    std::vector<Stop> stops{of_node(begin(chain.front()))};
    for (const Step &step : chain) {
      const Piece &piece = network.pieces[step.piece];
      if (piece.corner) {
        const auto name = names.bends.find(step.piece);
        stops.push_back(
            {{name == names.bends.end() ? "" : name->second, *piece.corner, piece.radius}, true});
      }
      stops.push_back(of_node(end(step)));
    }
    return stops;
  }

  /// Whether all stops between two of them lie on the line through both, and may go.
  bool passes(const std::vector<Stop> &stops, const std::size_t i, const std::size_t j) const {
    for (std::size_t k = i + 1; k < j; ++k)
      if (stops[k].stays || is_off_line(stops[k].point.position, stops[i].point.position,
                                        stops[j].point.position, tolerance))
        return false;
    return true;
  }

  /// Points of a straight run that need not be there left out: the next that stays, and where the
  /// run is not straight as far, the farthest that doubling and halving the way finds.
  std::vector<PlannedPoint> thinned(const std::vector<Stop> &stops) const {
    std::vector<PlannedPoint> route{stops.front().point};
    for (std::size_t i = 0; i + 1 < stops.size();) {
      const std::size_t last = stops.size() - 1;
      std::size_t good = i + 1, bad = last + 1;
      for (std::size_t reach = 2; good < last && bad > last; reach *= 2) {
        const std::size_t next = std::min(last, i + reach);
        (passes(stops, i, next) ? good : bad) = next;
      }
      while (good + 1 < bad) {
        const std::size_t middle = good + (bad - good) / 2;
        (passes(stops, i, middle) ? good : bad) = middle;
      }
      route.push_back(stops[good].point);
      i = good;
    }
    return route;
  }

  double length_of(const Piece &piece) const {
    const Point3 &a = network.nodes[piece.from], &b = network.nodes[piece.to];
    return piece.corner ? a.distance(*piece.corner) + piece.corner->distance(b) : a.distance(b);
  }

  /// The sum of what the pieces of a rigid part weigh, each its share of its component by length: a
  /// valve with three ways is in several parts. None if no weight is said.
  std::optional<double> mass_of(const std::vector<Step> &chain) {
    std::set<std::size_t> without;
    std::optional<double> mass;
    double of_pipe = 0.;
    for (const Step &step : chain) {
      const Piece &piece = network.pieces[step.piece];
      const double length = length_of(piece);
      if (const auto weight = line.components[piece.component].properties.number(Property::weight))
        mass = mass.value_or(0.) + *weight * length / length_of_component[piece.component];
      else {
        const PlannedSection &section = plan.sections[piece.section];
        of_pipe += density_of_steel * pi_of_routes * (section.outer_diameter - section.wall) *
                   section.wall * length;
        without.insert(piece.component);
      }
    }
    if (without.empty())
      return mass;
    notes.assumed.push_back({line.components[*without.begin()].line,
                             std::to_string(without.size()) + " rigid component" +
                                 (without.size() == 1 ? "" : "s") + " of " + words_of(chain) +
                                 " without a weight: taken as heavy as pipe"});
    return mass ? std::optional<double>(*mass + of_pipe) : std::nullopt;
  }

  std::string words_of(const std::vector<Step> &chain) const {
    std::string text, last;
    std::set<std::size_t> counted;
    unsigned int low = ~0u, high = 0, n = 0;
    for (const Step &step : chain) {
      const PcfComponent &component = line.components[network.pieces[step.piece].component];
      low = std::min(low, component.line);
      high = std::max(high, component.line);
      if (!counted.insert(network.pieces[step.piece].component).second || component.keyword == last)
        continue;
      last = component.keyword;
      constexpr unsigned int most_words = 6;
      if (++n <= most_words)
        text += (n == 1 ? "" : ", ") + last;
      else if (n == most_words + 1)
        text += ", ...";
    }
    return text + (low == high ? ", line " + std::to_string(low)
                               : ", lines " + std::to_string(low) + " to " + std::to_string(high));
  }

  /// What a rigid part is called by: a valve rather than its flanges.
  std::string rigid_word(const std::vector<Step> &chain) const {
    std::string word;
    for (const Step &step : chain) {
      const std::string &keyword = line.components[network.pieces[step.piece].component].keyword;
      if (word.empty() || word == "GASKET" ||
          (word.rfind("FLANGE", 0) == 0 && keyword != "GASKET" && keyword.rfind("FLANGE", 0) != 0))
        word = keyword;
    }
    return word;
  }

  void add_pipe(const std::vector<Step> &chain) {
    const Piece &first = network.pieces[chain.front().piece];
    const Properties &properties = line.components[first.component].properties;
    PlannedPipe pipe;
    pipe.comment = words_of(chain);
    pipe.section = first.section;
    pipe.end_section = first.end_section;
    if (first.end_section && !chain.front().forward)
      std::swap(pipe.section, *pipe.end_section);
    pipe.material = first.material;
    pipe.rigid = first.rigid;
    pipe.temperature = properties.number(Property::temperature);
    pipe.pressure = properties.number(Property::pressure);
    if (pipe.rigid)
      pipe.mass = mass_of(chain);
    pipe.name = pipe_names.take(pipe.rigid         ? rigid_word(chain)
                                : pipe.end_section ? "reducer"
                                                   : "pipe");
    pipe.route = thinned(stops_of(chain));
    plan.pipes.push_back(pipe);
  }

  void add_tee(const BranchFoot &branch) {
    const PcfComponent &component = line.components[branch.component];
    for (const std::size_t i : pieces_at[branch.node])
      if (network.pieces[i].run == branch.run) {
        plan.tees.push_back({tee_names.take(component.keyword), names.nodes[branch.node],
                             plan.pipes[pipe_of[i]].name, component.kind->tee_kind});
        return;
      }
  }

  const PcfLine &line;
  const Network &network;
  const double tolerance;
  LinePlan &plan;
  Notes &notes;
  const std::vector<std::vector<std::size_t>> pieces_at;
  std::vector<bool> is_named;
  std::vector<std::size_t> pipe_of;                  ///< by piece
  std::map<std::size_t, double> length_of_component; ///< all of its pieces [m]
  RouteNames names;
  UniqueNames pipe_names, tee_names;
  unsigned int n_names = 0;
};

} // namespace

RouteNames make_routes(const PcfLine &line, const Network &network, const double tolerance,
                       LinePlan &plan, Notes &notes) {
  return RouteMaker(line, network, tolerance, plan, notes).make();
}

} // namespace frictionbeam::import
