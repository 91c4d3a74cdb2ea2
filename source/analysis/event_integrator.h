// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "moreau_jean.h"
#include "taylor_motion.h"

namespace frictionbeam {

/**
 * From one change of a contact's state to the next: in between the motion is linear and known to
 * rounding (TaylorMotion), and so are the instants of slip, stick, closing and opening, roots of
 * polynomials. Contacts and friction may be rigid or on elastic elements, with static and dynamic
 * coefficients; rigid ones that close have Newton's impact. advance() returns at each change.
 *
 * Slip along a curve is not linear, and changes may accumulate (a ball that comes to rest): the
 * time up to the next instant of output is then left to MoreauJean, and remark() says so.
 */
class EventIntegrator final : public TimeIntegrator {
public:
  explicit EventIntegrator(const Model &model);

  std::string name() const override { return "event: exact from event to event"; }
  void start(LineState &state, const LoadCourse &loads) override;
  TimeStep advance(const LineState &from, const LoadCourse &loads, const double time,
                   LineState &to) override;
  void transfer(Archive &archive) override;
  bool is_exact() const override { return true; }
  std::string remark() const override;

private:
  enum class Kind { closing, opening, slipping, sticking };
  struct Event {
    double x = 2.;
    unsigned int contact = 0;
    Kind kind = Kind::closing;
  };

  /// The states that a line state's contacts are in.
  void read_states(const LineState &state, const LoadCourse &loads);
  /// Write the line at the present into a state.
  void write(const LoadCourse &loads, LineState &to) const;

  Event next_event() const;
  Event next_event(const unsigned int i) const;
  bool slips_along_a_curve() const;
  /// Take over the motion up to x, and account for it.
  void go(const double x, const double length, LineState &to, EnergyAccount &energy);
  void change(const Event &event, const double x, const double length, LineState &to,
              EnergyAccount &energy);
  /// Velocities of all contacts' ground at x, as relative motions.
  Vector ground_velocity(const double x, const double length) const;
  /// Of contacts, line and ground together.
  Vector velocities(const std::vector<unsigned int> &contacts, const Vector &of_ground) const;
  /// Changes of the line's velocity by unit impulses, by columns.
  Eigen::MatrixXd response_to_impulses(const std::vector<unsigned int> &contacts) const;
  /// Have impulses act on the line.
  void act(const std::vector<unsigned int> &contacts, const Vector &impulses,
           const Eigen::MatrixXd &responses, const Vector &of_ground, EnergyAccount &energy,
           LineState &to);
  /// Contact @p i strikes, with all that are closed.
  void impact(const unsigned int i, const Vector &of_ground, EnergyAccount &energy, LineState &to);
  /// At an instant at which the ground's velocity may have jumped, rigid contacts that are closed
  /// strike, let go or slide. @return whether anything changes
  bool meet_ground(const double length, EnergyAccount &energy, LineState &to);
  /// Take velocities relative to the ground away that contacts cannot have which are closed or
  /// stick.
  void settle(const Vector &of_ground, EnergyAccount &energy, LineState &to);
  /// A rigid friction contact slips, or sticks if it is at rest.
  void set_sliding(const unsigned int i, const Eigen::Vector2d &rate);
  bool events_accumulate(const double time, const double step);
  /// Factors of loads that impose motions, and their rates, at x.
  void set_imposed(const double x, const double length);
  /// Work of the loads up to x, and of the reactions on the motions that they impose.
  double work_of_loads(const double x, const double length) const;
  /// Lost in dampers up to x.
  double work_of_dampers(const double x, const double length) const;
  double stored_energy() const;
  double kinetic_energy() const;
  TimeStep hand_over(const LineState &from, const LoadCourse &loads, const double time,
                     LineState &to);

  const Model &model;
  EventModel line;
  TaylorMotion motion;
  MoreauJean fallback;
  const double output_step; ///< [s]
  std::vector<EventState> states;
  std::vector<Eigen::Vector3d> displacement, force; ///< of contacts, at present
  Vector unknowns, velocity;
  std::vector<double> imposed_factors, imposed_rates; ///< by load; of one instant
  double present = 0., fastest = 0.;
  bool ground_may_jump = true;    ///< at present
  bool at_rest_on_ground = false; ///< what is closed, to the error of the steps before
  std::vector<double> recent;     ///< instants of the last changes
  unsigned int n_events = 0, n_handed_over = 0;
  double first_handed_over = 0., time_handed_over = 0.;
  std::string reason;
};

} // namespace frictionbeam
