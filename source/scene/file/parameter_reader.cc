// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/file/parameter_reader.h"
#include "base/user_error.h"
#include "scene/physical_bounds.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace frictionbeam {

namespace {

constexpr double unbounded = 1e300;

std::string range(const double minimum, const double maximum) {
  const bool below = minimum <= -unbounded, above = maximum >= unbounded;
  if (below && above)
    return "a number";
  const std::string from = minimum == positive ? "> 0" : ">= " + to_text(minimum);
  if (above)
    return "a number " + from;
  if (below)
    return "a number <= " + to_text(maximum);
  return "a number " + from + " and <= " + to_text(maximum);
}

/// Where an entry has no bounds of its own, those of physics.
std::string range_with_physics(const double minimum, const double maximum,
                               const std::string &si_unit) {
  const double largest = physical_bounds(si_unit).largest;
  return range(minimum <= -unbounded ? -largest : minimum,
               maximum >= unbounded ? largest : maximum);
}

/// What to try where a value is none: what a number is often written with, if that is all.
std::string hint_for(const std::string &value, const bool is_number) {
  const std::string otherwise = "another value; frictionbeam --print-parameters says what it means";
  if (!is_number)
    return otherwise;
  double number = 0.;
  std::string with_point = value;
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  if (std::count(value.begin(), value.end(), ',') == 1 && to_number(with_point, number))
    return "'" + with_point + "', with a point";
  const std::size_t end = value.find_first_not_of("+-.0123456789eE");
  std::string begin = value.substr(0, end);
  begin.erase(begin.find_last_not_of(" \teE") + 1);
  if (end != std::string::npos && to_number(begin, number))
    return std::string("a number alone: units are those of the entry Units") +
           (value.find_first_of("/*+", end) == end ? ", and nothing is calculated" : "");
  return otherwise;
}

bool same_value(const std::string &a, const std::string &b) {
  double x, y;
  return a == b || (to_number(a, x) && to_number(b, y) && x == y);
}

/// Sections and entries that do not change what a reference value belongs to.
bool keeps_references(const std::string &heading, const std::string &name) {
  const std::vector<std::string> harmless = {"Mesh",   "Solid",      "Solver", "Time",
                                             "Output", "Quantities", "Study"};
  return std::count(harmless.begin(), harmless.end(), heading) > 0 ||
         (heading == "Continuum" && name != "Increments" && name != "Dimension") ||
         (heading == "Stress" && name == "Code libraries") ||
         (name == "Increments" &&
          heading != "Continuum") || // how the way is cut, not where it leads
         (heading == "Slab" &&       // of its line
          (name == "Elements" || name == "Poisson squeeze" || name == "Shear lag")) ||
         (heading.empty() && (name == "Title" || name == "Model" || name == "Accuracy" ||
                              name == "Monitors" || name == "Law libraries"));
}

} // namespace

std::string to_text(const double value) {
  for (int digits = 6; digits < 17; ++digits) {
    std::ostringstream text;
    text.precision(digits);
    text << value;
    double read;
    if (to_number(text.str(), read) && read == value)
      return text.str();
  }
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

ParameterReader::ParameterReader(const ParameterFile &file) : parameter_file(file) { enter(""); }

void ParameterReader::enter(const std::string &new_heading) {
  heading = new_heading;
  section = parameter_file.find(heading);
}

void ParameterReader::declare(const std::string &name, const std::string &default_value,
                              const dealii::Patterns::PatternBase &pattern, const std::string &unit,
                              const std::string &allowed, const std::string &meaning,
                              const std::string &documented) {
  declared[heading].push_back(
      {name, allowed + (unit.empty() || unit == "-" ? "" : " [" + unit + "]"), unit});
  if (!heading.empty())
    handler.enter_subsection(heading);
  handler.declare_entry(name, default_value, pattern,
                        (unit.empty() ? "" : "[" + unit + "] ") + meaning +
                            " Allowed: " + (documented.empty() ? allowed : documented) + ".");
  if (!heading.empty())
    handler.leave_subsection();
}

bool ParameterReader::is_declared(const std::string &name) const {
  const auto here = declared.find(heading);
  return here != declared.end() &&
         std::any_of(here->second.begin(), here->second.end(),
                     [&](const Declared &entry) { return entry.name == name; });
}

void ParameterReader::declare_number(const std::string &name, const double default_value,
                                     const std::string &unit, const double minimum,
                                     const double maximum, const std::string &meaning) {
  declare(name, to_text(default_value), dealii::Patterns::Double(minimum, maximum), unit,
          range(minimum, maximum), meaning, range_with_physics(minimum, maximum, unit));
  declared[heading].back().is_number = true;
  declared[heading].back().is_positive = minimum == positive;
}

void ParameterReader::declare_count(const std::string &name, const int default_value,
                                    const int minimum, const std::string &meaning,
                                    const int maximum) {
  declare(name, std::to_string(default_value), dealii::Patterns::Integer(minimum, maximum), "-",
          "a whole number >= " + std::to_string(minimum) + " and <= " + std::to_string(maximum),
          meaning);
}

void ParameterReader::declare_flag(const std::string &name, const bool default_value,
                                   const std::string &meaning) {
  declare(name, default_value ? "true" : "false", dealii::Patterns::Bool(), "-", "true or false",
          meaning);
}

void ParameterReader::declare_words(const std::string &name, const std::string &default_word,
                                    const std::vector<std::string> &words,
                                    const std::string &meaning) {
  std::string pattern;
  for (const std::string &word : words)
    pattern += (pattern.empty() ? "" : "|") + word;
  declare(name, default_word, dealii::Patterns::Selection(pattern), "-", join(words), meaning);
}

void ParameterReader::declare_text(const std::string &name, const std::string &default_value,
                                   const std::string &allowed, const std::string &meaning) {
  declare(name, default_value, dealii::Patterns::Anything(),
          allowed.find('[') == std::string::npos ? "-" : "", allowed, meaning);
}

void ParameterReader::take() {
  if (section == nullptr)
    return;
  std::vector<std::string> names;
  for (const Declared &entry : declared[heading])
    names.push_back(entry.name);
  for (const ParameterFile::Entry &entry : section->entries) {
    const auto known = std::find(names.begin(), names.end(), entry.name);
    if (known == names.end()) {
      const std::string like = nearest(entry.name, names);
      throw UserError(where(entry.name) + "\n  read:    " + entry.name + " = " + entry.value +
                      "\n  allowed: " + join(names) + "\n  try:     " +
                      (like.empty() ? "frictionbeam --print-parameters, which explains every entry"
                                    : "'" + like + "'"));
    }
    const Declared &declaration = declared[heading][known - names.begin()];
    if (!heading.empty())
      handler.enter_subsection(heading);
    const std::string before =
        entry.in_file && entry.is_override ? entry.file_value : handler.get(entry.name);
    bool fits = true;
    try {
      handler.set(entry.name, entry.value);
    } catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &) {
      fits = false;
    }
    if (!heading.empty())
      handler.leave_subsection();
    if (!fits)
      fail(entry.name, declaration.allowed, hint_for(entry.value, declaration.is_number));
    if (declaration.is_number)
      in_bounds(entry.name, number(entry.name), with_exponents(declaration.unit),
                declaration.is_positive);
    if (entry.is_override && !keeps_references(heading, entry.name) &&
        !same_value(before, entry.value))
      has_changed = true;
  }
}

std::string ParameterReader::raw(const std::string &name, const std::string &otherwise) const {
  const ParameterFile::Entry *entry = section == nullptr ? nullptr : section->find(name);
  return entry == nullptr ? otherwise : entry->value;
}

bool ParameterReader::given(const std::string &name) const {
  return section != nullptr && section->find(name) != nullptr;
}

bool ParameterReader::overridden(const std::string &name) const {
  return given(name) && section->find(name)->is_override;
}

std::string ParameterReader::text(const std::string &name) const {
  return heading.empty() ? handler.get(name) : handler.get(std::vector<std::string>{heading}, name);
}

double ParameterReader::number(const std::string &name) const {
  double value = 0.;
  const bool is_number = to_number(text(name), value);
  (void)is_number;
  Assert(is_number, dealii::ExcInternalError());
  if (units.is_si() || !given(name))
    return value;
  for (const Declared &entry : declared.at(heading))
    if (entry.name == name)
      return entry.unit == "degC" ? units.celsius(value)
                                  : value * units.factor(with_exponents(entry.unit));
  return value;
}

std::string ParameterReader::with_exponents(std::string unit) const {
  for (std::string::size_type begin; (begin = unit.find("^(")) != std::string::npos;) {
    const auto end = unit.find(')', begin);
    Assert(end != std::string::npos, dealii::ExcInternalError());
    const std::string entry = unit.substr(begin + 2, end - begin - 2);
    unit.replace(begin + 1, end - begin, to_text(number(entry)));
  }
  return unit;
}

unsigned int ParameterReader::count(const std::string &name) const {
  return static_cast<unsigned int>(number(name));
}

bool ParameterReader::flag(const std::string &name) const {
  const std::string value = text(name);
  return value == "true" || value == "yes" || value == "on";
}

std::vector<std::string> ParameterReader::list(const std::string &name) const {
  const std::vector<std::string> items = split(text(name), ',');
  if (std::count(items.begin(), items.end(), "") > 0)
    fail(name, "names separated by single commas", "one comma less");
  return items;
}

std::vector<double> ParameterReader::numbers(const std::string &name) const {
  std::string value = text(name);
  std::replace(value.begin(), value.end(), ',', ' ');
  std::vector<double> result;
  for (const std::string &word : split(tidy(value), ' ')) {
    double x;
    if (!to_number(word, x))
      fail(name, "numbers separated by blanks", "a number in place of '" + word + "'");
    result.push_back(x);
  }
  return result;
}

double ParameterReader::in_bounds(const std::string &entry, const double in_si,
                                  const std::string &si_unit, const bool is_positive) const {
  const PhysicalBounds bounds = physical_bounds(si_unit);
  // Rounding may leave numbers that are as good as 0, but none that small.
  const double least = is_positive ? bounds.smallest : std::min(bounds.smallest, 1e-60);
  const double size = std::abs(in_si);
  if ((size == 0. && !is_positive) || (size >= least && size <= bounds.largest))
    return in_si;
  const double factor = units.factor(si_unit);
  fail(entry,
       std::string("numbers of a size that physics knows, ") + (is_positive ? "" : "0 or ") +
           to_text(least / factor) + " to " + to_text(bounds.largest / factor) + " [" +
           units.name(si_unit) + "]",
       "another number, or other Units");
}

dealii::Tensor<1, 3> ParameterReader::vector(const std::string &name,
                                             const std::string &si_unit) const {
  const std::vector<double> values = numbers(name);
  if (values.size() != 3)
    fail(name, "three numbers x y z", "a vector such as '0 0 1'");
  dealii::Tensor<1, 3> result;
  for (unsigned int d = 0; d < 3; ++d)
    result[d] = in_bounds(name, values[d] * si(name, si_unit), si_unit);
  return result;
}

unsigned int ParameterReader::find(const std::string &entry, const std::string &name,
                                   const std::vector<std::string> &names,
                                   const std::string &kind) const {
  const auto place = std::find(names.begin(), names.end(), name);
  if (place == names.end()) {
    std::string like = nearest(name, names);
    const std::vector<std::string> words = split(name, ' ');
    if (words.size() > 1 && std::all_of(words.begin(), words.end(), [&](const std::string &word) {
          return std::count(names.begin(), names.end(), word) > 0;
        }))
      like = join(words);
    fail(entry,
         names.empty() ? "a " + kind + ", but the file has none"
                       : "the name of a " + kind + ": " + join(names),
         !like.empty()  ? "'" + like + "'"
         : name.empty() ? "a " + kind + " added to the file"
                        : "a " + kind + " called '" + name + "' added to the file",
         name.empty() ? "no name" : "'" + name + "'");
  }
  return place - names.begin();
}

std::string ParameterReader::where(const std::string &entry) const {
  const ParameterFile::Entry *present = section == nullptr ? nullptr : section->find(entry);
  const std::string origin = present != nullptr   ? present->origin
                             : section != nullptr ? section->origin
                                                  : parameter_file.name();
  return origin + ": " + (heading.empty() ? "" : "section '" + heading + "', ") + "entry '" +
         entry + "'";
}

void ParameterReader::fail(const std::string &entry, const std::string &allowed,
                           const std::string &hint, const std::string &read) const {
  std::string value = read;
  if (value.empty()) {
    value = raw(entry, "");
    value = value.empty() ? "nothing" : value;
  }
  throw UserError(where(entry) + "\n  read:    " + value + "\n  allowed: " + allowed +
                  "\n  try:     " + hint);
}

void ParameterReader::say_once(const std::string &entry, const std::string &detail,
                               std::set<std::string> &said) const {
  if (!said.insert(detail).second)
    fail(entry, "each detail once", "one of them", "'" + detail + "' twice");
}

void ParameterReader::fail_section(const std::string &read, const std::string &allowed,
                                   const std::string &hint) const {
  throw UserError((section != nullptr ? section->origin : parameter_file.name()) +
                  (heading.empty() ? ":" : ": section '" + heading + "'") + "\n  read:    " + read +
                  "\n  allowed: " + allowed + "\n  try:     " + hint);
}

void ParameterReader::print(std::ostream &out) {
  handler.print_parameters(out, dealii::ParameterHandler::Text |
                                    dealii::ParameterHandler::KeepDeclarationOrder);
}

} // namespace frictionbeam
