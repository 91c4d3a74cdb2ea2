// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/cell/section_chain.h"
#include "model/line/linear_part.h"
#include "model/line/pipe_element.h"

#include <memory>

namespace frictionbeam {

/// Of a law that does not say where it begins to yield: the offset of a proof stress.
inline constexpr double proof_strain = 2e-3;

/**
 * The sections of pipes that have a law of their own, plastic or creeping, some along each cell in
 * a SectionChain. Each is given the strain that causes stress,
 *   e = total - e_free + p A_bore / EA,
 * e_free the free strains of temperature and pressure of a closed pipe, so that a hoop stress
 * strains an elastic wall as it does there; the last term is along the axis. The law answers with
 * the force in the wall, the beam's is less by p A_bore.
 *
 * States of all sections stand in one vector, zero at rest.
 */
class PipeSections {
public:
  using Vector12 = PipeElement::Vector12;
  using Matrix12 = PipeElement::Matrix12;
  using Vector6 = Eigen::Matrix<double, 6, 1>;

  PipeSections(const Scene &scene, const Discretization &discretization);

  bool any() const { return n_values > 0; }
  /// Whether a pipe cell has a law of its own.
  bool has(const unsigned int cell) const { return !cells.empty() && cells[cell] != nullptr; }
  /// States of all sections at rest.
  Vector at_rest() const { return Vector::Zero(n_values); }

  /// The end of an increment, and how long it is [s].
  struct Clock {
    double time = 0., length = 0.;
  };
  /// What a cell's sections stand in at the increment's end.
  struct Surroundings {
    double axial_strain = 0., curvature = 0.;             ///< free ones [-, 1/m]
    double pressure = 0.;                                 ///< [Pa]
    double temperature = 20.;                             ///< [degC]
    Eigen::Vector3d line_force = Eigen::Vector3d::Zero(); ///< in the axes at rest [N/m]
  };
  /// By which a cell's sections stretch more at a temperature than by Young's modulus [-].
  double softening(const unsigned int cell, const double temperature) const;
  /// Of a cell.
  struct Answer {
    /// Forces on its ends, in the axes at rest, and the derivative of the last by the motions.
    Vector12 before = Vector12::Zero(), after = Vector12::Zero();
    Matrix12 stiffness = Matrix12::Zero();
    /// Of the mean stress: less what the ends do, that on free strains [J].
    double free_work = 0.;
    double error = 0.; ///< what the increment's length leaves in the stress, a share
    bool failed = false;
    /// Where it failed: whether the states are those of strains that belong to the motions.
    bool compatible = false;
  };
  /**
   * Integrate a cell's sections to the end of an increment.
   * @param from, to motions of its ends before and after
   * @param old states before; @param now in: at rest, or what this has made of any; out: this
   * cell's sections after
   * @param is_near whether `now` comes in with the answer to other motions of this very increment,
   * which is near: to begin with
   */
  void integrate(const unsigned int cell, const Vector12 &from, const Vector12 &to,
                 const Surroundings &surroundings, const Clock &clock, const Vector &old,
                 Vector &now, Answer &answer, const bool is_near = false) const;
  /// Whether a cell whose ends move so would be strained, evenly, beyond what any wall is.
  bool is_far(const unsigned int cell, const Vector12 &motions) const;
  /// The same as if nothing yielded or crept on the way: forces and stiffness alone.
  void answer_elastically(const unsigned int cell, const Vector12 &from, const Vector12 &to,
                          const Surroundings &surroundings, const Vector &old,
                          Answer &answer) const;
  /// The same of a state that has been committed: from one to the other.
  void between(const unsigned int cell, const Vector12 &from, const Vector12 &to, const Vector &old,
               const Vector &now, Answer &answer) const;
  /// Forces of the committed stresses on a cell's ends, in the axes at rest.
  Vector12 forces(const unsigned int cell, const Vector &states) const;
  /// Of what a cell's sections were given by their mean stresses: what the law has not dissipated
  /// is stored [J].
  double stored_in(const unsigned int cell, const Vector &states) const;
  /// By all sections, as their laws say [J].
  double dissipated(const Vector &states) const;

  /**
   * What a cell dissipates at the utmost on a motion: work by unit of it, so far along that what is
   * stored does not count [J]. Infinite where it hardens without end, or does not say when it is
   * elastic.
   * @param at motions of the ends at present, @param motion their change
   */
  struct Flow {
    double power = 0.;
    /// Integral of the displacement that the ends' motions leave out [m2]: a load per length does
    /// work on it.
    Eigen::Vector3d interior = Eigen::Vector3d::Zero();
    double bore = 0.;  ///< by which the bore grows along the axis [m3]: pressure does work on it
    double part = 0.5; ///< of the way along the cell, where most is dissipated
  };
  Flow plastic_flow(const unsigned int cell, const Vector12 &at, const Vector12 &motion,
                    const Surroundings &surroundings, const Vector &states) const;

  /// How well states obey their laws, the worst of all sections.
  struct Check {
    /// Equivalent stress beyond the yield stress, of it, by the strain, the internal variables and
    /// nothing that the law's integration has left [-].
    double yield_violation = 0.;
    /// Of stresses with the forces on the ends of their cell and the load between, each component
    /// by the root of its stiffness, of the largest in the cell [-].
    double imbalance = 0.;
    /// Elastic bound less 1 of strains between the sections of cells in which none has flowed [-].
    double unseen_yield = 0.;

    void include(const Check &other);
  };
  void check(const unsigned int cell, const Surroundings &surroundings, const Vector &states,
             Check &worst) const;

  /// What happened between two states, where it is most.
  struct Change {
    double dissipated = 0.; ///< by all sections [J]
    /// Of a section's strain, equivalent, in the wall: sqrt((|d eps| + r |d kappa|)^2 + (r d
    /// chi)^2/3), r = sqrt(2 I/A); of those that do not come back to it, if there are any [-].
    double growth = 0.;
    /// Most that plastic and creep strain of a point have gained [-]; NaN where a section flows
    /// whose law does not tell: such a one is judged by what it dissipates.
    double flow = 0.;
    bool flows = false;     ///< any section, by 1e-5 of the strain at which it yields, or of 1e-3
    bool comes_back = true; ///< each section that flows, to 1e-3 of its own flow
    unsigned int cell = 0;  ///< of `growth`, or of `flow` if all come back
    double part = 0.5;      ///< of the way along it, likewise
  };
  Change largest_change(const Vector &before, const Vector &after) const;

  /// A section's place on the line and what its law tells of its state.
  struct Report {
    double part = 0.; ///< of the way along the cell, from its deal.II vertex 0
    Vector6 strain, stress;
    SectionReport state;
    double length = 0.;     ///< of pipe that it stands for [m]
    double dissipated = 0.; ///< so far [J/m]
  };
  std::vector<Report> reports(const unsigned int cell, const Surroundings &surroundings,
                              const Vector &states) const;

private:
  struct Cell;
  /// Largest elastic bound between the sections of a cell that is elastic, along a parabola of its
  /// strains, as a line force bends it.
  double bound_between(const Cell &cell, const LawIncrement &increment, const Vector &states) const;

  /// Where the law has the flexibility of bends in itself, its sections' axes y, z are those of the
  /// bend: towards its centre, and about it.
  struct Cell {
    Cell(const Profile &profile, SectionChain chain) : profile(profile), chain(std::move(chain)) {}
    const BoundLaw &law(const unsigned int point) const {
      return laws.empty() ? profile.law : laws[point];
    }
    const Profile &profile;
    SectionChain chain;
    std::vector<BoundLaw> laws;              ///< of the sections, where they are not all one
    std::vector<SectionChain::Matrix6> turn; ///< to the bend's axes from the local ones; or none
    Eigen::Matrix<double, 12, 3> carried;    ///< forces on the ends by a load that beta leaves out
    std::vector<Eigen::Matrix<double, 6, 12>> B;
    std::vector<Vector6> curvature; ///< strains of a unit change of curvature
    std::vector<double> part;       ///< of the way along the cell
    /// In the states: what the whole cell has, then the sections.
    unsigned int first_value = 0;
  };
  /// Values of a cell: forces on its ends, free strains, load per length and rise of temperature.
  static constexpr unsigned int risen = 12 + 2 + 3, n_values_of_cell = risen + 1;
  /// Values of a section's state: strain and stress of the wall, p A_bore, energy that it has
  /// stored and dissipated [J/m], whether an internal variable of its law is not zero; then these
  /// variables.
  enum Value {
    strain = 0,
    stress = 6,
    thrust = 12,
    stored = 13,
    lost = 14,
    flowed = 15,
    internal = 16
  };
  unsigned int n_values_of(const Cell &cell) const {
    return internal + cell.profile.law.n_internal_variables();
  }
  unsigned int place_of(const Cell &cell, const unsigned int point) const {
    return cell.first_value + n_values_of_cell + point * n_values_of(cell);
  }
  /// Whether a section at rest, which stays elastic, is as stiff as the cell's elastic one: laws
  /// may soften with temperature, and with pressure. @param now scratch
  static bool is_as_stiff_as_cold(const Cell &cell, const unsigned int point,
                                  const LawIncrement &increment, const double *of_wall,
                                  const double *old, double *now);
  /// Strains of a cell's sections that the chain asks for: those of the wall less p A_bore / EA.
  std::vector<Vector6> strains_of(const Cell &cell, const Vector &states) const;
  /// The same to begin an increment with, by the elastic shapes of its ends' motion.
  std::vector<Vector6> first_guess(const Cell &cell, const Vector12 &motion,
                                   const Surroundings &surroundings, const Vector &old) const;
  /// Whether a cell that has only been elastic so far is so at the increment's end: its states
  /// then.
  bool stays_elastic(const Cell &cell, const Vector12 &motions, const std::vector<Vector6> &free,
                     const Surroundings &surroundings, const Vector &old, Vector &now,
                     SectionChain::Solution &solution) const;
  /// Where strain and stress are known.
  static void set_energies(const double thrust, const double dissipation, const double *old,
                           double *now);
  double sum(const Cell &cell, const Vector &states, const Value value) const;
  std::unique_ptr<const Cell> make_cell(const Discretization &discretization,
                                        const unsigned int index, PipeElement &exact,
                                        PipeElement &at_points) const;
  /// @param total strain less free ones @param rise of temperature at the increment's start [K]
  /// @param now in: its strain; out: all its values
  bool answer_of_law(const Cell &cell, const unsigned int point, const Surroundings &surroundings,
                     const Clock &clock, const Vector6 &total, const double rise, const double *old,
                     double *now, SectionChain::Matrix6 &tangent, double &error) const;

  std::vector<std::unique_ptr<const Cell>> cells; ///< as the pipe cells; empty if none has a law
  unsigned int n_values = 0;
  const double installation; ///< temperature at rest [degC]
};

} // namespace frictionbeam
