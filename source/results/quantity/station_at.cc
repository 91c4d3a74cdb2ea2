// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/station_at.h"

#include "base/user_error.h"

#include <algorithm>

namespace frictionbeam {

const Station *find_station(const Model &model, const Quantity &quantity, const Frame &made) {
  using Side = Quantity::Side;
  const unsigned int vertex = model.mesh.points.at(quantity.where);
  for (unsigned int p = 0; p < model.mesh.pipes.size(); ++p) {
    if (!quantity.pipe.empty() && model.scene.pipes[p].name != quantity.pipe)
      continue;
    const MeshedPipe &pipe = model.mesh.pipes[p];
    for (unsigned int i = 0; i < pipe.vertices.size(); ++i) {
      const bool nothing_there = quantity.side != Side::any &&
                                 i == (quantity.side == Side::after ? pipe.vertices.size() - 1 : 0);
      if (pipe.vertices[i] != vertex || nothing_there)
        continue;
      const auto pass = std::count(pipe.vertices.begin(), pipe.vertices.begin() + i, vertex);
      const Station *last = nullptr;
      std::ptrdiff_t n_passed = 0; // a route may come to a point again
      bool was_there = false;
      for (const Station &station : made.line) {
        const bool is_there = station.pipe == p && station.vertex == vertex;
        n_passed += was_there && !is_there;
        was_there = is_there;
        if (is_there && n_passed == pass) {
          last = &station;
          if (quantity.side != Side::after)
            break;
        }
      }
      Assert(last != nullptr, dealii::ExcInternalError());
      return last;
    }
  }
  return nullptr;
}

const Station &station_at(const Model &model, const Quantity &quantity, const Frame &made) {
  if (const Station *const station = find_station(model, quantity, made))
    return *station;
  const std::string on = quantity.pipe.empty() ? "" : " called '" + quantity.pipe + "'",
                    name = "Quantity " + quantity.name;
  Quantity any = quantity;
  any.side = Quantity::Side::any;
  if (find_station(model, any, made) == nullptr)
    throw UserError(name + ": the point '" + quantity.where + "' is on no pipe" + on +
                    (quantity.is(QuantityKind::Of::motion)
                         ? ", and '" + quantity.step +
                               "' is no step: of spectra and combinations there are the motions of "
                               "pipes. Ask for fx, fy or fz of what holds the point."
                         : ", and so has no section forces."));
  const bool after = quantity.side == Quantity::Side::after;
  throw UserError(name + ": there is no pipe" + on + (after ? " after" : " before") +
                  " the point '" + quantity.where + "', where the route " +
                  (after ? "ends. Take 'before'" : "begins. Take 'after'") + " or 'at'.");
}

} // namespace frictionbeam
