// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/law.h>

#include <string>
#include <vector>

namespace frictionbeam {

/// The increment at whose end a law is evaluated.
struct LawIncrement {
  double time = 0., length = 0.;  ///< its end, and how long it is: 0 in statics [s]
  double temperature = 20.;       ///< at its end, of what the law belongs to [degC]
  double pressure = 0.;           ///< at its end, in a pipe over that outside [Pa]
  double temperature_change = 0.; ///< in it [K]
};

/// How many internal variables these parameters need.
unsigned int n_internal_variables(const LawDescription &law, const std::vector<double> &parameters);

/**
 * A law with numbers for its parameters. Everything that calls a law calls it here; its closed form
 * is asked for once.
 */
class BoundLaw {
public:
  BoundLaw() = default;
  /// @param law must outlive this.
  /// @throws std::invalid_argument if the parameters are more or fewer than the law's, or out of
  /// bounds
  BoundLaw(const LawDescription &law, const std::vector<double> &parameters);

  bool is_set() const { return law != nullptr; } ///< false of a BoundLaw without a law
  const LawDescription &description() const { return *law; }
  std::string name() const { return law->name; }
  /// Those that these parameters need.
  unsigned int n_internal_variables() const { return n_variables; }
  const std::vector<double> &parameters() const { return values; }

  /// Whether it has one that depends on its parameters alone: one that varies is not taken.
  bool has_closed_form() const { return is_constant; }
  bool closed_form_varies() const {
    return law != nullptr && law->threshold != nullptr && !is_constant;
  }
  /// Zeros if it has none.
  const FrictionThreshold &closed_form() const { return form; }
  /// Distance to travel before contact [m]: that of a closed form, else of a parameter `Gap`, or 0.
  double gap() const { return travel; }
  /// Whether it does not give along its normal.
  bool is_rigid_along_normal() const;

  /**
   * Integrate the law to the end of an increment.
   * @param strain_rate its mean over the increment [1/s]
   * @param element_length [m]; times the strains it is the displacement of the second node
   */
  LawStatus integrate(const double *strain, const double *strain_rate, const double element_length,
                      const LawIncrement &increment, const double *old_state,
                      const LawTangent tangent, LawOutput &output) const;

  /**
   * Below 1, a section whose internal variables are all zero answers to this strain with its
   * elastic tangent times strain, and keeps them. Infinity if the law does not say.
   */
  double elastic_bound(const double *strain, const double element_length,
                       const LawIncrement &increment) const;
  /// What the state at the end of an increment is like; NaN if the law does not say. @param since
  /// internal variables from before: strains are those since then; null: all
  SectionReport report(const double *strain, const double element_length,
                       const LawIncrement &increment, const double *new_state,
                       const double *since = nullptr) const;

  /// What a law answers at rest, from internal variables of zero.
  struct Answer {
    std::vector<double> stress, tangent, state;
  };
  Answer answer_at_rest(const std::vector<double> &strain, const double element_length,
                        const LawTangent tangent, const double temperature) const;

private:
  /// All but displacement, rate, old state and the tangent that is wanted.
  LawInput input_of(const double *strain, const double element_length,
                    const LawIncrement &increment) const;

  const LawDescription *law = nullptr;
  std::vector<double> values;
  unsigned int n_variables = 0;
  bool is_constant = false; ///< whether it has a closed form, of the parameters alone
  FrictionThreshold form{};
  double travel = 0.;
};

} // namespace frictionbeam
