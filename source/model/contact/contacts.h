// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/contact/contact.h"
#include "model/unknowns/sparse_matrix.h"

#include <functional>

namespace frictionbeam {

/// Committed or trial state of all contacts: internal variables, strains, what was dissipated.
struct ContactState {
  std::vector<double> internal;
  std::vector<Contact::Strains> strain;
  std::vector<Contact::Strains> touch; ///< strain at which the contact began
  std::vector<double> dissipated;      ///< [J]
  std::vector<double> wear;            ///< integral of normal force times sliding velocity [J]
  std::vector<double> impulse;         ///< of the normal force, impacts included [N s]
};

/// The increment at whose end contacts are evaluated.
struct ContactIncrement {
  double time = 0., length = 0.;         ///< its end, and how long it is: 0 in statics [s]
  std::vector<double> temperatures = {}; ///< of contacts, at its end; empty: of installation [degC]
};

/// What one evaluation of all contacts gives.
struct ContactResponse {
  std::vector<Contact::Strains> stress;
  std::vector<Eigen::Matrix<double, n_support_strains, n_support_strains, Eigen::RowMajor>> tangent;
  std::vector<ContactStatus> status;
  ContactState state; ///< at the end of the increment, if it is committed
  bool failed = false;
};

/// All friction elements of a scene.
class Contacts {
public:
  Contacts(const Scene &scene, const LineMesh &mesh, const Discretization &discretization,
           const ReducedSpace &space, const LawLibrary &laws);

  /**
   * The same contacts on a model with other numbers: their states are interchangeable.
   * @param dof_places, unknown_places new number of each old one that contacts depend on
   */
  Contacts(const Contacts &contacts, const std::vector<int> &dof_places,
           const std::vector<int> &unknown_places, const unsigned int n_unknowns);

  unsigned int size() const { return list.size(); }
  const Contact &operator[](const unsigned int i) const { return list[i]; }

  /// Evaluate the laws at the displacements @p all_dofs from the committed state.
  void evaluate(const Vector &all_dofs, const ContactState &committed,
                const ContactIncrement &increment, const LawTangent tangent,
                ContactResponse &response) const;

  /// Of the pipes at the contacts, at these factors of the loads [degC]; empty where none is
  /// heated.
  std::vector<double> temperatures(const std::vector<double> &load_factors) const;

  /// Size a response for all contacts.
  void prepare(ContactResponse &response) const;
  /// Evaluate the law of contact @p i at response.state.strain[i].
  void evaluate_law(const unsigned int i, const ContactState &committed,
                    const ContactIncrement &increment, const LawTangent tangent,
                    ContactResponse &response) const;

  /// forces += weight B^T stress, on the unknowns.
  void add_forces(const ContactResponse &response, Vector &forces) const;
  /// matrix += weight B^T D B; the pattern has the entries (add_pattern()).
  void add_tangent(const ContactResponse &response, SparseMatrix &matrix) const;
  /// imposed += motion of the ground, on all degrees of freedom; @p value says that of a course.
  void add_ground_motion(const std::function<double(const TimeFunction &)> &value,
                         Vector &imposed) const;
  bool ground_moves() const { return !moving.empty(); }

  /// Forces of platens on the unknowns, present from the start.
  const Vector &platen_forces() const { return preload; }
  /// Add the positions at which platens are in equilibrium with a line at rest.
  void place_platens(Vector &unknowns) const;
  /// Take other parameters for the law of contact @p i from here on.
  void set_parameters(const unsigned int i, const std::vector<double> &parameters);
  /// The state at the start: no shear force at the displacements @p all_dofs.
  ContactState initial_state(const Vector &all_dofs) const;

private:
  /// The force of the platen on a support's contact, and the position where it is in equilibrium.
  void add_platen(const Contact &contact, const std::string &support,
                  const Discretization &discretization, const ReducedSpace &space);

  std::vector<Contact> list;
  unsigned int n_internal = 0;
  std::vector<std::pair<unsigned int, const TimeFunction *>> moving; ///< degrees of freedom
  Vector preload;
  std::vector<std::pair<int, double>> platen_positions; ///< unknown, its value in equilibrium
};

} // namespace frictionbeam
