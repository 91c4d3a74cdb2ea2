// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "import/line/line_plan.h"
#include "import/line/unique_names.h"
#include "import/pcf/pcf_component.h"

namespace frictionbeam::import {

/// How walls and metals are found that the file does not say.
struct SectionOptions {
  std::string wall;       ///< "7.11 mm", or by bore "150 7.11 mm, 80 5.49 mm"
  std::string schedule;   ///< of all whose wall is said nowhere
  std::string material;   ///< grade of what the file has no known name for; empty: carbon steel
  bool in_inches = false; ///< outer diameters of nominal sizes in inches, which differ by 1e-4
};

/// The grade of Material/Grade that the name or description of a metal means; empty if none is
/// known.
std::string grade_of(const std::string &name);

/**
 * Sections and materials of components. A bore that is a nominal size (DN or NPS of ASME B36.10M)
 * has its outer diameter; any other is the outer diameter itself. The wall is that of the
 * attribute, else of the item's description ("SCH 40", "WT=6 mm"), else of the options, else that
 * of the pipes of the same bore.
 */
class SectionPlanner {
public:
  /// @throws UserError for options that are not understood, and where pipes have no wall
  SectionPlanner(const PcfFile &file, const PcfLine &line, const SectionOptions &options,
                 LinePlan &plan, Notes &notes);

  /// Place in LinePlan::sections. @param bore in the file's unit @param second of a reducer's
  /// second end or a branch
  std::size_t section(const PcfComponent &component, const double bore, const bool second = false);
  double outer_diameter(const std::size_t section) const {
    return plan.sections[section].outer_diameter;
  }
  /// Place in LinePlan::materials.
  std::size_t material(const PcfComponent &component);

private:
  struct Wall {
    double value = 0.;
    std::string schedule;
    bool is_known() const { return value > 0. || !schedule.empty(); }
  };
  Wall own_wall(const PcfComponent &component, const double bore, const bool second);
  Wall option_wall(const double bore) const;
  std::string nominal(const double bore) const;
  void read_wall_option();
  void find_walls_of_bores();

  const PcfFile &file;
  const PcfLine &line;
  const SectionOptions &options;
  LinePlan &plan;
  Notes &notes;
  std::map<double, double> given_walls; ///< of the option, by bore; 0: all [m]
  std::map<double, Wall> pipe_walls;    ///< of pipes, by bore
  std::map<std::string, unsigned int> said;
  UniqueNames names;
};

} // namespace frictionbeam::import
