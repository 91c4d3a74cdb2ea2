// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/step_report.h"
#include "results/cost.h"
#include "results/extremes.h"
#include "results/known_error.h"
#include "results/section_results.h"
#include "scene/scene.h"

#include <limits>

/**
 * @file
 * What an analysis leaves behind, as plain data in SI units: everything that the writers of csv,
 * json, vtu and report need, and nothing of how it was computed.
 */
namespace frictionbeam {

/// A friction element in place.
struct SupportInfo {
  std::string name; ///< `rests` for a single one, `rests.1`, `rests.2`, ... for a repeated one
  std::string kind;
  Point3 position;
  Vector3 normal, t1, t2; ///< right-handed (t1, t2, n), n from the ground into the pipe
  double capacity = 0.;   ///< largest force that it is made for [N]; 0: not said
};

/// Rests by whatever name, and rods: what holds the line up, and from what it may lift off.
inline bool holds_up(const SupportInfo &support) {
  constexpr double upwards = 0.7; // of the normal
  return support.kind == "rest" || support.kind == "rod" ||
         (support.kind == "friction" && support.normal[2] > upwards);
}

/// State of a friction element. Forces are those of the support on the pipe, fn >= 0 in
/// compression.
struct SupportState {
  ContactStatus status = ContactStatus::open;
  double fn = 0., ft1 = 0., ft2 = 0.; ///< [N]
  double gap = 0.;                    ///< [m], >= 0 open
  double slip1 = 0., slip2 = 0.;      ///< of the pipe on the ground since contact began [m]
  double work_friction = 0.;          ///< dissipated so far [J]
  double wear = 0.;    ///< integral of fn times the sliding velocity so far, transient steps [J]
  double impulse = 0.; ///< of fn so far, transient steps, impacts included [N s]
  double mt = 0.;      ///< moment about the normal, of Torsion [N m]
  /// Moment that its two edges hold, about the way of the pipe x normal; of steps alone [N m].
  double tilt = 0.;
  /// Force and moment on the pipe about its place, global axes [N, N m]: what cases are combined
  /// of, whose other numbers are sizes along the support's own axes.
  Motion on_pipe{};
};

/// The numbers of such a state, in the order of the quantities of a support (scene/quantity.h); the
/// first of them are those that tables show and cases are combined of.
inline constexpr double SupportState::*support_numbers[] = {
    &SupportState::fn,    &SupportState::ft1,    &SupportState::ft2,           &SupportState::gap,
    &SupportState::slip1, &SupportState::slip2,  &SupportState::work_friction, &SupportState::mt,
    &SupportState::wear,  &SupportState::impulse};
constexpr unsigned int n_shown_support_numbers = 8;

/// Whether a support is open by more than rounding of a motion, or @p touching [m]: some methods
/// call a contact open that touches without a force.
inline bool stands_off(const SupportState &state, const double touching) {
  return state.status == ContactStatus::open && state.gap > touching;
}

/// A restraint or spring in place; its forces on the pipe in global axes are in Frame::reactions.
struct RestraintInfo {
  std::string name, kind;
  Point3 position;
  double capacity = 0.; ///< as of SupportInfo
};

/// A point with a name.
struct PointInfo {
  std::string name;
  unsigned int vertex = 0; ///< of the mesh; several names may have the same
  Point3 position{};
};

/// A point of a pipe: a mesh node or a station between two.
struct Station {
  static constexpr unsigned int between_nodes = std::numeric_limits<unsigned int>::max();

  unsigned int pipe = 0;
  unsigned int vertex = between_nodes; ///< of the mesh, if it is a node
  double s = 0.;                       ///< along the pipe [m]
  Point3 position;
  Motion displacement{};   ///< global axes [m, rad]
  Motion force{};          ///< N, Vy, Vz [N], Mx, My, Mz [N m] in the cell's local axes
  Vector3 y, z;            ///< local axes of the section forces, of the line as it was built
  Vector3 y_now, z_now;    ///< the same, as they have turned
  double pressure = 0.;    ///< inside [Pa]; of a case made of others not known
  double part = 0.;        ///< s over the pipe's length
  double bend_radius = 0.; ///< [m]; 0: not in a bend
  Vector3 bend_axis;       ///< of a bend: unit normal of its plane

  bool is_node() const { return vertex != between_nodes; }
};

/// The state at one instant. Neighbouring stations of one pipe are joined by the pipe; a pipe's
/// stations are stored one after the other.
struct Frame {
  std::string name;      ///< of its step, or of a case made after the steps
  unsigned int step = 0; ///< place in Scene::steps; of cases, on from there
  unsigned int increment = 0;
  int step_before = -1; ///< that the step starts from; -1: none, or of a case
  double time = 0.;
  bool end_of_step = true;
  bool is_amplitude = false; ///< of a case whose numbers are sizes, or each from another state: no
                             ///< shape to draw
  bool is_judged = true; ///< by what a state may be at most: all steps, and cases that are states
  std::vector<Station> line;
  std::vector<SupportState> supports;
  std::vector<Motion> reactions; ///< of RestraintInfo
  /// FrameBuilder::together(), first of all supports: what cases combine as one number.
  std::vector<SupportState> together;
  /// Of pipes that yield or creep, one after the other along each; at the ends of steps only.
  std::vector<SectionState> sections;
};

/// What a friction element has met in a transient step.
struct SupportEnvelope {
  std::array<Extremes, 6> values; ///< fn, ft1, ft2, gap, slip1, slip2
  Extremes force, friction;       ///< sizes
  SupportState at_largest;        ///< when the force was largest
  double impulse = 0.;            ///< of fn over the step, impacts included [N s]
  /// Of a rigid contact: the impulses of the time steps in which it closed [N s]. A force that
  /// belongs to such a time step is the impulse over its length, and left out above.
  Extremes impact;
  unsigned int n_impacts = 0;
};

/// What a restraint or spring has met in a transient step.
struct RestraintEnvelope {
  std::array<Extremes, 6> values;
  Extremes force;      ///< its size
  Motion at_largest{}; ///< when the force was largest
};

/// A stress at every station of a line, its largest in a transient step, by the formula of the
/// stress code at each instant.
struct StressEnvelope {
  std::string from; ///< of an expansion range: the step before; empty: sustained or occasional
  std::vector<double> stress, time; ///< [Pa, s]
  std::vector<double> force;        ///< N, Vy, Vz, Mx, My, Mz of each station then [N, N m]
};

/// The forces on a nozzle when it used most of what is allowed.
struct NozzleEnvelope {
  double utilization = -1., time = 0.;
  Motion force{};
};

/// A station of StepEnvelope, also within a step where the line's frames leave it out.
struct StationPlace {
  unsigned int pipe = 0;
  double s = 0.; ///< along the pipe [m]
};

/// Largest and smallest values over all time steps of a transient step, its start included.
struct StepEnvelope {
  unsigned int step = 0; ///< place in Scene::steps
  double start = 0., end = 0.;
  std::size_t n_instants = 0,
              n_line_instants = 0;             ///< of a reduced line, the line is known at fewer
  bool is_of_whole_motion = false;             ///< what lies between the instants included
  std::vector<SupportEnvelope> supports;       ///< beside Results::supports
  std::vector<RestraintEnvelope> restraints;   ///< beside Results::restraints
  std::vector<std::array<Extremes, 6>> points; ///< displacements, beside Results::points
  Extremes sum_normal, sum_friction;           ///< over the supports
  Extremes displacement;                       ///< size, of the line's nodes
  StationPlace displaced_most;
  /// N, Vy, Vz, Mx, My, Mz of each of Results::stations, six numbers each.
  std::vector<double> least, largest, least_at, largest_at;
  std::vector<StressEnvelope> stresses;
  std::vector<NozzleEnvelope> nozzles; ///< in the order of nozzles, and of restraints for each
  std::optional<Frame> least_frame, largest_frame; ///< by components, where combinations need them
};

/// The least and the largest that each component of a combination with a transient step can be.
struct CombinationRange {
  unsigned int step = 0; ///< of the combination's frame
  Frame least, largest;
};

/// One eigenfrequency, and its shape with a largest displacement of 1.
struct ModeResult {
  double frequency = 0.;                  ///< [Hz]
  std::array<double, 3> participation{};  ///< of x, y, z, for q^T M q = 1 [kg^1/2]
  std::array<double, 3> effective_mass{}; ///< [kg]
  double residual = 0.;                   ///< |K q - w^2 M q| / (w^2 |M q|)
  double by_cells = 0.;                   ///< of the frequency, frequency_error_of_cells()
  Frame shape;
};

/// What a spectrum does to a mode in one direction.
struct ModalExcitation {
  unsigned int mode = 0;      ///< from 1 on
  unsigned int direction = 0; ///< 0, 1, 2: x, y, z
  std::string spectrum;
  double participation = 0.; ///< phi^T M r [kg^1/2]
  double acceleration = 0.;  ///< with the direction's factor [m/s2]
  double rigid = 0.;         ///< share that follows the ground without delay
};

/// Which cases gave the numbers of a combination.
struct GoverningCases {
  std::string name;               ///< of the combination
  std::vector<std::string> cases; ///< steps, the spectrum and sums, not combinations that have some
  std::vector<unsigned int> of;   ///< place in cases, in the order of numbers_of()
  std::vector<unsigned int> least; ///< of a range, that of the smaller number; else empty
};

/// Stresses of one case by a stress code, at each station of its frame.
struct StressCase {
  std::string name, kind, code; ///< kind: sustained, expansion, occasional
  Frame frame;
  std::vector<double> stress, allowed; ///< [Pa]
  std::vector<StressFactors> factors;
  std::vector<StressForces> forces; ///< that make each stress, at its instant
  std::string step;                 ///< that it is of; of a range, the later one
  unsigned int worst = 0;           ///< the station of largest stress over allowed
  std::vector<double> time; ///< when each stress was met, of a transient step; empty: at the end
};

/// How much of the allowed loads of an anchor or nozzle one step uses.
struct NozzleUse {
  std::string name, support, step;
  Motion force{};
  std::array<double, 6> allowed{};
  double utilization = 0.;
  std::optional<double> time; ///< of the largest use in a transient step [s]; empty: at its end
};

/// What a spring hanger carries over the static steps that have weight.
struct HangerUse {
  std::string name, point, item;        ///< item of a catalogue; may be empty
  double stiffness = 0.;                ///< [N/m]; 0: constant
  double cold_load = 0., hot_load = 0.; ///< before anything has moved; in the hot step [N]
  double travel = 0.;                   ///< up, to the hot step [m]
  /// From the lowest to the highest over these steps and before anything has moved, and what a
  /// constant item of a catalogue has; 0: any [m].
  double largest_travel = 0., allowed_travel = 0.;
  /// Largest |F - F_hot|/F_hot over these steps and the cold load, and where; how much is allowed.
  double variability = 0., allowed_variability = 0.;
  std::string step;                       ///< "cold" or a step
  double least_load = 0., most_load = 0.; ///< of all these [N]
  std::string least_step, most_step;
  double least_allowed = 0., most_allowed = 0.; ///< of the item [N]; 0: none
};

/// What a study over multipliers of friction compares.
struct FrictionStudy {
  /// Use of a nozzle's allowable loads or of an allowable stress, the largest of the steps.
  struct Ratio {
    std::string kind, of;       ///< "nozzle" or "stress"; which
    std::vector<double> values; ///< by multiplier; nan where the run did not come to it
  };
  std::vector<double> multipliers; ///< rising
  std::vector<Ratio> ratios;
  std::vector<std::string> names;           ///< of supports and restraints
  std::vector<std::vector<double>> largest; ///< force over all steps, by multiplier, by name [N]
};

/// Motion of a monitored point at every increment.
struct History {
  std::string point;
  std::vector<double> time;
  std::vector<Motion> displacement;
};

void transfer(Archive &archive, Point3 &point);
void transfer(Archive &archive, Vector3 &vector);
void transfer(Archive &archive, Station &station);
void transfer(Archive &archive, Frame &frame);
void transfer(Archive &archive, History &history);
void transfer(Archive &archive, StressEnvelope &envelope);
void transfer(Archive &archive, StepEnvelope &envelope);

struct QuantityResult {
  std::string name, unit, source;
  double value = 0.;
  std::optional<double> reference,
      error;                   ///< error relative to the reference (absolute if that is 0)
  std::optional<double> limit; ///< of its size, in its unit
  double whole = 0.;           ///< of a change or rate: the largest of what changes; else 0
  double apart = 0.;           ///< of a time_of: the instants that it was found between
  double in_si = 1.;           ///< SI units in its unit; 0: that is a word of the file's own
  /// An extreme of a force that a rigid support has in an impact: there is no such number.
  bool of_impact = false;
};

/// A line of the certificate: the worst of all increments.
struct Check {
  std::string name, unit, meaning;
  double value = 0.;     ///< nan where there was nothing to judge
  bool is_judged = true; ///< whether there was something
};

/// Whether something that was checked is as it should be (verdicts.h).
struct Verdict {
  std::string check, of, step; ///< step: or case; may be empty
  double value = 0.;
  std::optional<double> allowed; ///< none: nothing but whether
  std::string unit;              ///< SI, of both; empty: that of the quantity
  bool passes = true;
  std::string section; ///< of the report, where there is more
};

/// A section of the report besides those that every report has.
struct ReportSection {
  std::string id, title, html;
};

enum class RunStatus { converged, failed, no_equilibrium };

/// How an answer came to the Accuracy that was demanded.
struct AccuracyAccount {
  struct Run {
    std::string settings;         ///< as of --set
    double seconds = 0.;          ///< mesh, set-up, solution
    std::optional<double> change; ///< of the quantities, relative to the run it is compared with
    bool converged = false;
  };
  double demanded = 0., estimate = 0.; ///< relative
  std::string model;                   ///< line or continuum, if it was left to the program
  std::optional<double> line_error;    ///< estimate of what a line leaves out, relative
  std::string model_reason;            ///< in plain words
  bool reached = false;
  std::vector<std::string> chosen;   ///< settings, as of --set
  std::vector<std::string> left_out; ///< quantities that do not count, and why
  std::vector<Run> runs;
};

struct Results {
  std::vector<SupportInfo> supports;
  std::vector<unsigned int> support_of; ///< each friction element: two where one is on edges
  std::vector<RestraintInfo> restraints;
  std::vector<PointInfo> points;       ///< by name
  std::vector<Frame> frames;           ///< ends of steps
  std::vector<Frame> instants;         ///< some of those in between, of transient steps
  std::vector<StationPlace> stations;  ///< of the envelopes
  std::vector<StepEnvelope> envelopes; ///< of transient steps
  std::vector<CombinationRange> combination_ranges;
  std::vector<History> histories;
  std::vector<SectionHistory> section_histories;
  std::vector<QuantityResult> quantities;
  std::vector<ModeResult> modes;
  std::vector<ModalExcitation> excitations; ///< by direction, spectrum and mode
  std::vector<GoverningCases> governing;    ///< of envelopes, maxima, minima and ranges
  std::vector<StressCase> stresses;
  std::vector<NozzleUse> nozzles;
  std::vector<HangerUse> hangers;
  FrictionStudy friction_study;
  std::array<double, 3> total_mass{}; ///< that modes could move [kg]
  std::string modal_method;           ///< in plain words
  UnitSystem units;                   ///< in which the writers show everything
  std::vector<StepReport> steps;
  std::vector<Check> certificate;
  std::vector<Verdict> verdicts;
  std::optional<EnergyAccount> energy; ///< of all steps together
  std::vector<std::string> remarks;    ///< warnings to the user
  std::vector<std::string> doubts;     ///< likewise, of what is hardly meant: errors of --strict
  HowWellKnown known;
  std::optional<AccuracyAccount> accuracy;
  std::string method;     ///< in plain words
  std::string integrator; ///< of transient steps, likewise; empty if there is none
  std::vector<ReportSection> sections;
  /// Cells that have yielded: pipe, and the way along it to their middle [m].
  std::vector<std::pair<unsigned int, double>> yielded;
  RunStatus status = RunStatus::failed;
  Cost cost;

  /**
   * Fill certificate and energy from the steps.
   * @param contacts_are_judged false: there are contacts, and no law of theirs has a closed form,
   * by which the exact method judges them
   */
  void certify(const Scene &scene, const bool contacts_are_judged);
  /// The envelope of a step; null of static ones.
  const StepEnvelope *envelope_of(const unsigned int step) const {
    for (const StepEnvelope &envelope : envelopes)
      if (envelope.step == step)
        return &envelope;
    return nullptr;
  }
};

} // namespace frictionbeam
