// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/event/taylor_motion.h"
#include "analysis/time/moreau_jean.h"
#include <frictionbeam/contact/local_problem.h>

namespace frictionbeam {

/**
 * From one change of a contact's state to the next: in between the motion is linear and known to
 * rounding (TaylorMotion), and so are the instants of slip, stick, closing and opening, roots of
 * polynomials. Contacts and friction may be rigid or on elastic elements, with static and dynamic
 * coefficients; rigid ones that close have Newton's impact, all that close at one instant together.
 * advance() returns at each change.
 *
 * Impacts of a contact that accumulate end when their intervals and speeds have followed a
 * geometric law and its sum says that what is left is shorter than a millionth of a step: the
 * contact then stays closed. Where states change at one instant without end, a hundredth of a step
 * is left to MoreauJean, and remark() says so.
 */
class EventIntegrator final : public TimeIntegrator {
public:
  /// @param observer called with every smooth piece of the motion before advance() returns; may be
  /// empty
  EventIntegrator(const Model &model, const PieceObserver &observer);

  std::string name() const override { return "event: exact from event to event"; }
  void start(LineState &state, const LoadCourse &loads) override;
  TimeStep advance(const LineState &from, const LoadCourse &loads, const double time,
                   LineState &to) override;
  void transfer(Archive &archive) override;
  bool is_exact() const override { return true; }
  std::string remark() const override;

private:
  static constexpr double at_rest = 1e-12; ///< what does not move, of the fastest velocity so far
  enum class Kind { closing, opening, slipping, dragged, sticking };
  struct Event {
    double x = 2.;
    unsigned int contact = 0;
    Kind kind = Kind::closing;
  };

  /// The states that a line state's contacts are in.
  void read_states(const LineState &state, const LoadCourse &loads);
  /// Contacts at rest whose friction statics has left at its limit.
  void find_limits();
  /// Write the line at the present into a state.
  void write(const LoadCourse &loads, LineState &to) const;
  /// The same at x of the motion at hand, with what the contacts' histories are at its beginning.
  void write_within(const LoadCourse &loads, const double x, const double length,
                    const ContactState &histories, LineState &to) const;
  /// Displacements, and contacts under these forces.
  void write_contacts(const Vector &imposed, const std::vector<Eigen::Vector3d> &forces,
                      LineState &to) const;

  Event next_event() const;
  Event next_event(const unsigned int i) const;
  /// When friction of a contact that sticks reaches its limit: f N -+ T = 0, in two directions
  /// (f N)^2 = |T|^2.
  Event next_slip(const unsigned int i) const;
  /// What rounding leaves of the rate of a contact's displacement @p d, by x [m].
  double noise_of_rate(const unsigned int i, const int d) const;
  /// Direction in which the ground takes a contact along that sticks and cannot follow; 0 if it
  /// does not. The line's motion there is imposed, or another contact holds it.
  Eigen::Vector2d drag(const unsigned int i) const;
  /// Find contacts that begin to slip along a curve. @return whether there are any
  bool find_curves();
  /// Whether slip is about to stop, so slow that its direction does not matter.
  bool stops(const unsigned int i) const;
  bool is_fast(const double rate) const;
  /// Rate of a contact's slip, elastic part left out.
  Polynomial slip_rate(const unsigned int i) const;
  double compute_motion(const LoadCourse &loads, const double longest);
  /// The same after what happens at the present: jumps of the ground, slip that turns.
  /// @return the length of the piece [s]
  double next_motion(const LoadCourse &loads, const double longest, LineState &to,
                     EnergyAccount &energy);
  /// Take over the motion up to x, and account for it.
  void go(const LoadCourse &loads, const double x, const double length, LineState &to,
          EnergyAccount &energy);
  /// By the contacts' forces at x alone: what rounding of accelerations is measured by.
  Vector acceleration_by_contacts(const double x) const;
  /// Whether the motion obeys Signorini's and Coulomb's laws at x; if not, that is the failure.
  bool obeys_laws(const double x, const double length, EquilibriumResult &result);
  struct LawCheck;
  /// The same before any contact is looked at.
  LawCheck what_laws_allow(const double x, const double length);
  void check_laws(const unsigned int i, const double x, const double length, LawCheck &worst,
                  contact::Check &certificate) const;
  /// Impulses, wear and friction work up to x. @return what friction dissipates [J]
  double add_histories(const double x, const double length, ContactState &contacts) const;
  /// Integral of N |u_T| up to x of a contact without friction, which may turn round and round.
  double frictionless_wear(const unsigned int i, const double x) const;
  /// Directions of slip along curves, at the present.
  void turn_slip(const double x, const double length);
  void change(const Event &event, const double x, const double length, LineState &to,
              EnergyAccount &energy);
  /// The same, and what begins to slip with a contact that does. Counts it.
  void meet(const Event &event, const LoadCourse &loads, const double x, const double length,
            LineState &to, TimeStep &step);
  /// A contact begins to slip.
  void begin_slip(const unsigned int i, const Eigen::Vector2d &direction, LineState &to,
                  EnergyAccount &energy);
  /// Which way it does that has reached its limit: along its friction or, where there is none, the
  /// way it moves.
  Eigen::Vector2d direction_of_slip(const unsigned int i, const Eigen::Vector2d &rate) const;
  /// Whether a contact is the half of a rigid stop or guide without gap that does not press, since
  /// the other one is closed: it counts as open, or both would carry what the other does not.
  bool is_idle_half(const unsigned int i) const {
    return !states[i].is_closed() && partner[i] >= 0 && states[partner[i]].is_closed();
  }
  /// Of two such halves that are closed, the one that presses less is idle from now on.
  void release_idle_halves();
  /// A contact on a rigid surface begins to slip: find which others do, which do not, and where
  /// to, from Coulomb's law for the accelerations of all that are at rest. @return whether their
  /// friction was found
  bool share_start(const unsigned int first, const LoadCourse &loads, const Vector &of_ground,
                   LineState &to);
  struct SharedStart;
  /// The same before friction is found, for those that @p rests says are at rest.
  SharedStart start_of(const std::vector<bool> &rests, const LoadCourse &loads);
  /// Have those slip, or not, as the start says.
  void take_start(const SharedStart &start, const unsigned int first,
                  const std::vector<bool> &rests, LineState &to);
  /// Contacts on rigid surfaces with friction that do not slip now, and @p first.
  std::vector<bool> resting_with(const unsigned int first, const Vector &of_ground) const;
  /// Velocity of a contact below which it is rounding [m/s].
  double least_rate(const unsigned int i) const;
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
  /// Rigid contacts that close now, or as good as now, @p i one of them.
  std::vector<unsigned int> closing_with(const unsigned int i, const double x,
                                         const Vector &of_ground) const;
  struct Impact;
  /// What contacts that strike have as one problem with all rigid ones that are closed, by Newton's
  /// and Coulomb's laws (doc/dynamics.md, "From event to event").
  Impact impact_of(const std::vector<unsigned int> &striking, const Vector &of_ground);
  /// Contacts strike, with all that are closed.
  void impact(const std::vector<unsigned int> &striking, const Vector &of_ground,
              EnergyAccount &energy, LineState &to);
  /// Whether a contact left at this instant, and comes back with a velocity that is rounding.
  bool returns_at_once(const unsigned int i, const double speed) const;
  /// Restitution of a contact that closes now with this speed: 0 where its impacts come to an end.
  double restitution(const unsigned int i, const double speed);
  /// At an instant at which a velocity that a load imposes may have jumped, the jump's impulse.
  /// @return whether there is any
  bool meet_imposed_jump(const double length, EnergyAccount &energy);
  /// Whether a rigid contact that is closed has a velocity along its normal, as an initial one
  /// gives it that a static step has closed.
  bool leaves_or_strikes() const;
  /// At an instant at which the ground or its velocity, or the line's may have jumped, rigid
  /// contacts that are closed strike, let go or slide. @return whether anything changes
  bool meet_ground(const LoadCourse &loads, const double length, EnergyAccount &energy,
                   LineState &to);
  /// A jump of what is imposed opens rigid contacts that it takes apart, and has the others slip.
  void meet_jump_of_ground(const LoadCourse &loads, EnergyAccount &energy, LineState &to);
  /// Take velocities relative to the ground away that contacts cannot have which are closed or
  /// stick.
  void settle(const Vector &of_ground, EnergyAccount &energy, LineState &to);
  /// A rigid friction contact slips, or sticks if it is at rest.
  void set_sliding(const unsigned int i, const Eigen::Vector2d &rate);
  /// Factors of loads that impose motions, and their rates, at x.
  void set_imposed(const double x, const double length);
  /// Work of the loads up to x, and of the reactions on the motions that they impose.
  double work_of_loads(const double x, const double length) const;
  /// Lost in dampers up to x.
  double work_of_dampers(const double x, const double length) const;
  double stored_energy() const;
  double kinetic_energy() const;
  /// Until where the loads are smooth, and whether something breaks there.
  struct Goal {
    double time; ///< [s]
    bool breaks;
  };
  Goal next_goal(const LoadCourse &loads, const double time) const;
  /// Whether states change without end, or slip along a curve is not resolved. Sets the reason.
  bool is_stuck(const Event &event);
  /// Have MoreauJean go on in small steps.
  TimeStep hand_over(const LineState &from, const LoadCourse &loads, const double time,
                     LineState &to);
  /// The same for a part of the output's step that begins now, after @p step.
  TimeStep hand_over_after(const TimeStep &step, const LoadCourse &loads, const double time,
                           LineState &to);
  /// Impulses of contacts that strike as one problem, which has their friction and q.
  void strike(const std::vector<unsigned int> &contacts, contact::LocalProblem problem,
              const Vector &of_ground, EnergyAccount &energy, LineState &to);

  const Model &model;
  EventModel line;
  TaylorMotion motion;
  /// Impacts of one contact, the last ones.
  struct Bounces {
    std::vector<double> time, speed; ///< [s], [m/s]
    double left = -1.;               ///< when the contact opened [s]
    void transfer(Archive &archive) { archive(time, speed, left); }
  };

  MoreauJean fallback;
  const PieceObserver piece_observer;
  const double output_step; ///< [s]
  std::vector<int> partner; ///< other half of a rigid stop or guide without gap, else -1
  std::vector<EventState> states;
  std::vector<Eigen::Vector3d> displacement, force; ///< of contacts, at present
  Vector unknowns, velocity;
  std::vector<double> imposed_factors, imposed_rates, imposed_accelerations; ///< by load, now
  double present = 0., fastest = 0.;
  double farthest = 0., strongest = 0.; ///< displacements and forces of contacts so far [m], [N]
  std::string failure;                  ///< why it has ended
  double motion_length = 0.;            ///< of the motion at hand, for x = 1 [s]
  bool ground_may_jump = true;          ///< at present
  bool begins = false;                  ///< at the first instant of a step
  bool at_rest_on_ground = false;       ///< what is closed, to the error of the steps before
  std::vector<Bounces> bounces;         ///< by contact
  bool goes_straight_on = false;        ///< slip along curves that is not resolved
  unsigned int n_at_once = 0;           ///< events since the motion got on
  unsigned int n_events = 0, n_handed_over = 0, n_unresolved = 0, n_unshared = 0;
  double first_handed_over = 0., time_handed_over = 0.;
  std::string reason;
};

} // namespace frictionbeam
