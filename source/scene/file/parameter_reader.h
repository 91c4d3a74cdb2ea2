// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/choice.h"
#include "scene/file/parameter_file.h"
#include "scene/units.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <limits>
#include <map>
#include <set>

namespace frictionbeam {

/// Lower bound of a number that must be greater than zero.
inline constexpr double positive = std::numeric_limits<double>::min();

/**
 * The second pass over a parameter file: entries are declared section by section to a deal.II
 * ParameterHandler, with unit, bounds and meaning, and then taken from the file, strictly. Every
 * error names the place in the file, the part, the entry, what was read, what is allowed and what
 * to try.
 *
 * In each section: enter(), declare_...(), take(), then the getters.
 */
class ParameterReader {
public:
  explicit ParameterReader(const ParameterFile &file);

  /// Go to the section with this heading; empty: the entries outside of any.
  void enter(const std::string &heading);

  void declare_number(const std::string &name, const double default_value, const std::string &unit,
                      const double minimum, const double maximum, const std::string &meaning);
  void declare_count(const std::string &name, const int default_value, const int minimum,
                     const std::string &meaning, const int maximum = 1000000);
  void declare_flag(const std::string &name, const bool default_value, const std::string &meaning);
  /// One of the words of a table (choice.h), whose meanings stand between @p meaning and @p note.
  template <typename Table, typename Value>
  void declare_choice(const std::string &name, const Value &default_value, const Table &table,
                      const std::string &meaning, const std::string &note = "") {
    const std::string words = meanings_of(table), blank = " ";
    declare_words(name, row_of(table, default_value).word, words_of(table),
                  meaning + (meaning.empty() || words.empty() ? "" : blank) + words +
                      (words.empty() ? "" : ".") + (note.empty() ? "" : blank) + note);
  }
  /// @p allowed says the form, with units in brackets, such as "x y z [m]".
  void declare_text(const std::string &name, const std::string &default_value,
                    const std::string &allowed, const std::string &meaning);

  bool is_declared(const std::string &name) const; ///< in the current section

  /// Take the values of the current section from the file.
  /// @throws UserError for an entry that is not declared or a value out of bounds.
  void take();

  /// What the file says before anything is declared; @p otherwise if it says nothing.
  std::string raw(const std::string &name, const std::string &otherwise) const;
  bool given(const std::string &name) const;      ///< by the file or by --set
  bool overridden(const std::string &name) const; ///< by --set

  /// In SI units; the file's numbers are in its own (set_units()).
  double number(const std::string &name) const;
  unsigned int count(const std::string &name) const;
  bool flag(const std::string &name) const;
  std::string text(const std::string &name) const;
  /// The value of the word that such an entry is.
  template <typename Table>
  auto choice(const std::string &name, const Table &table) const {
    const auto row = find_word(table, text(name));
    Assert(row != std::end(table), dealii::ExcInternalError());
    return row->value;
  }
  std::vector<std::string> list(const std::string &name) const; ///< between commas, no empty item
  std::vector<double> numbers(const std::string &name) const;   ///< between blanks, as written
  /// @p in_si, which the entry has in it. @throws UserError if no model has such a number.
  double in_bounds(const std::string &entry, const double in_si, const std::string &si_unit,
                   const bool is_positive = false) const;
  /// Three numbers, in SI units where the file has them in its own for @p si_unit.
  dealii::Tensor<1, 3> vector(const std::string &name, const std::string &si_unit = "-") const;
  /// Of a number that a text has in it: how many of @p si_unit the file's unit is. Defaults are SI.
  double si(const std::string &si_unit) const { return units.factor(si_unit); }
  /// Whether numbers in a unit are in the file's own.
  bool converts(const std::string &si_unit) const {
    return units.is_si() || units.converts(si_unit);
  }
  double si(const std::string &entry, const std::string &si_unit) const {
    return given(entry) ? units.factor(si_unit) : 1.;
  }
  void set_units(const UnitSystem &file_units) { units = file_units; }

  /// Place of @p name among @p names. @throws UserError that lists them.
  unsigned int find(const std::string &entry, const std::string &name,
                    const std::vector<std::string> &names, const std::string &kind) const;

  /// @throws UserError about the value of an entry of this section.
  [[noreturn]] void fail(const std::string &entry, const std::string &allowed,
                         const std::string &hint, const std::string &read = "") const;

  /// @throws UserError if a detail of an entry is among those that it has said before
  void say_once(const std::string &entry, const std::string &detail,
                std::set<std::string> &said) const;

  /// @throws UserError about this section as a whole.
  [[noreturn]] void fail_section(const std::string &read, const std::string &allowed,
                                 const std::string &hint) const;

  /// Whether --set has changed a value that the scene's references depend on.
  bool scene_changed() const { return has_changed; }

  const ParameterFile &file() const { return parameter_file; }

  /// All declared entries, annotated, in the order of their declaration.
  void print(std::ostream &out);

  /// Where an entry stands, as messages begin: file, line, section and name.
  std::string where(const std::string &entry) const;

private:
  /// A unit with the numbers of the exponents that are other entries, as in
  /// "N/m^(Plastic exponent)".
  std::string with_exponents(std::string unit) const;

  struct Declared {
    std::string name, allowed, unit;
    bool is_number = false, is_positive = false;
  };

  void declare_words(const std::string &name, const std::string &default_word,
                     const std::vector<std::string> &words, const std::string &meaning);
  void declare(const std::string &name, const std::string &default_value,
               const dealii::Patterns::PatternBase &pattern, const std::string &unit,
               const std::string &allowed, const std::string &meaning,
               const std::string &documented = "");

  ParameterFile parameter_file;
  const ParameterFile::Section *section = nullptr; ///< null if the file does not have it
  std::string heading;
  std::map<std::string, std::vector<Declared>> declared; ///< by heading
  dealii::ParameterHandler handler;
  bool has_changed = false;
  UnitSystem units;
};

/// The program's way to write a number for people: as short as it can be.
std::string to_text(const double value);

} // namespace frictionbeam
