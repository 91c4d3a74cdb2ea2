// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/contact/contact.h"
#include <frictionbeam/contact/site_list.h>

#include <functional>

namespace frictionbeam {

using ContactState = contact::State;
using ContactIncrement = contact::Increment;
using ContactResponse = contact::Response;

/// All friction elements of a scene.
class Contacts : public contact::SiteList {
public:
  Contacts(const Scene &scene, const LineMesh &mesh, const Discretization &discretization,
           const ReducedSpace &space, const LawLibrary &laws);

  /**
   * The same contacts on a model with other numbers: their states are interchangeable.
   * @param dof_places, unknown_places new number of each old one that contacts depend on
   */
  Contacts(const Contacts &contacts, const std::vector<int> &dof_places,
           const std::vector<int> &unknown_places, const unsigned int n_unknowns);

  Contacts(const Contacts &) = delete; // the list of sites refers to these
  Contacts &operator=(const Contacts &) = delete;

  const Contact &operator[](const unsigned int i) const { return list[i]; }

  /// The contacts of each place of a support, in their order: one, or two of one on edges.
  const std::vector<std::vector<unsigned int>> &places() const { return of_places; }

  /// Evaluate the laws at the displacements @p all_dofs from the committed state.
  void evaluate(const Vector &all_dofs, const ContactState &committed,
                const ContactIncrement &increment, const LawTangent tangent,
                ContactResponse &response) const;

  /// Of the pipes at the contacts, at these factors of the loads [degC]; empty where none is
  /// heated.
  std::vector<double> temperatures(const std::vector<double> &load_factors) const;

  /// imposed += motion of the ground, on all degrees of freedom; @p value says that of a course.
  void add_ground_motion(const std::function<double(const TimeFunction &)> &value,
                         Vector &imposed) const;
  bool ground_moves() const { return !moving.empty(); }

  /// Forces of platens on the unknowns, present from the start.
  const Vector &platen_forces() const { return preload; }
  /// Add the positions at which platens are in equilibrium with a line at rest, displaced or not.
  void place_platens(Vector &unknowns) const;
  /// Rigid contacts, whose law does not say it, carry the force of their platen.
  void press_platens(ContactResponse &response) const;
  /// Take other parameters for the law of contact @p i from here on.
  void set_parameters(const unsigned int i, const std::vector<double> &parameters);
  /// The state at the start: no shear force at the displacements @p all_dofs.
  ContactState initial_state(const Vector &all_dofs) const;

private:
  /// The force of the platen on a support's contact, and the position where it is in equilibrium.
  void add_platen(const Contact &contact, const std::string &support,
                  const Discretization &discretization, const ReducedSpace &space);

  std::vector<Contact> list;
  std::vector<std::vector<unsigned int>> of_places;
  std::vector<std::pair<unsigned int, const TimeFunction *>> moving; ///< degrees of freedom
  Vector preload;
  /// Where a platen is in equilibrium on a line at rest.
  struct Platen {
    unsigned int contact;
    int unknown;
    double towards_pipe; ///< change of the unknown where the platen moves there by one
    double position;     ///< towards the pipe [m]
  };
  std::vector<Platen> platens;
};

} // namespace frictionbeam
