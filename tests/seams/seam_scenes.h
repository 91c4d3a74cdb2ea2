// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

/// A line with every kind of place where something can stand, and every kind of support to stand
/// there, as sections of a parameter file.
namespace seams {

struct Place {
  std::string point, pipe;
  double x, y; ///< [m]; z = 0
};

/// See line(): K is the middle of a bend.
inline const std::vector<Place> places = {
    {"P", "main", 4., 0.},      {"K", "main", 0., 0.},      {"Q", "main", 5., 1.},
    {"S", "main", 2., 0.},      {"T", "main", 5., 3.},      {"R1", "reducer", 5., 4.},
    {"RM", "reducer", 5., 4.3}, {"R2", "reducer", 5., 4.6}, {"V1", "valve", 5., 6.},
    {"VM", "valve", 5., 6.25},  {"V2", "valve", 5., 6.5}};

/// A bend from P over K to Q, a tee at T, a reducer from R1 over RM to R2, a rigid part from V1
/// over VM to V2, a second bend, straight runs between them; anchored at A, C and D.
inline const std::string line = R"(
subsection Material steel
  set Allowable cold = 138e6
  set Allowable hot = 130e6
end
subsection Section pipe
  set Outer diameter = 0.2
  set Wall = 0.01
end
subsection Section thin
  set Outer diameter = 0.15
  set Wall = 0.008
end
subsection Point RM
  set Position = 5 4.3 0
end
subsection Point VM
  set Position = 5 6.25 0
end
subsection Pipe main
  set Section = pipe
  set Route = A 0 0 0; S 2 0 0; P 4 0 0; K 5 0 0 bend 1; Q 5 1 0; T 5 3 0; R1 5 4 0
end
subsection Pipe branch
  set Section = thin
  set Route = T; D 8 3 0
end
subsection Pipe reducer
  set Section = pipe
  set End section = thin
  set Route = R1; R2 5 4.6 0
end
subsection Pipe run
  set Section = thin
  set Route = R2; V1 5 6 0
end
subsection Pipe valve
  set Section = thin
  set Rigid = true
  set Route = V1; V2 5 6.5 0
end
subsection Pipe last
  set Section = thin
  set Route = V2; 5 9 0 bend 0.5; C 5 9 -2
end
subsection Support anchors
  set Kind = anchor
  set At = A, C, D
end
)";

inline const std::string loads = R"(
subsection Load weight
end
subsection Load hot
  set Kind = temperature
  set Temperature = 120
end
subsection Load push
  set Kind = force
  set Forces = S 3000 2000 0; V1 -2000 3000 -4000
end
subsection Step cold
  set Loads = weight
end
subsection Step warm
  set Loads = weight, hot
  set Increments = 2
end
)";

/// One way to hold the line: sections of the file, of which a friction element takes options.
struct Holder {
  std::string name;
  bool is_element;
  std::string text;        ///< POINT, PIPE, GROUND (a position below) and OPTIONS are replaced
  double tolerance = 1e-7; ///< of what idle supports may change; rounding at the rigid part
};

inline std::string support(const std::string &name, const std::string &entries) {
  return "subsection Support " + name + "\n  set At = POINT\n" + entries + "end\n";
}

inline std::string element(const std::string &entries) {
  return support("held", entries + "OPTIONS");
}

/// The same with the places, the bends or the rotations of its own: a pipe below the place.
inline const std::string beam_below = R"(
subsection Pipe beam
  set Section = thin
  set Route = U GROUND_1; G GROUND; W GROUND_2
end
subsection Support beam_ends
  set Kind = anchor
  set At = U, W
end
)";

inline const std::vector<Holder> holders = {
    {"nothing", false, ""},
    {"anchor", false, support("held", "  set Kind = anchor\n")},
    {"restraint", false, support("held", "  set Kind = restraint\n  set Fixed = ux, uz, ry\n")},
    {"guide", false, support("held", "  set Kind = guide\n")},
    {"line stop", false, support("held", "  set Kind = line stop\n")},
    {"stop", false, support("held", "  set Kind = stop\n  set Normal = 1 2 2\n")},
    {"spring", false,
     "subsection Spring held\n  set At = POINT\n  set Stiffness = 1e5 2e5 3e5 1e4 2e4 3e4\nend\n"},
    {"hanger", false,
     "subsection Hanger held\n  set At = POINT\n  set Stiffness = 2e5\n  set Cold load = "
     "3000\nend\n"},
    {"constant hanger", false,
     "subsection Hanger held\n  set Kind = constant\n  set At = POINT\n  set Cold load = "
     "3000\nend\n"},
    {"sized hanger", false, "subsection Hanger held\n  set At = POINT\nend\n"},
    {"joint", false,
     "subsection Joint held\n  set At = POINT\n  set Pipe = PIPE\n  set Axial = 1e6\n  set Lateral "
     "= "
     "2e6\n  set Bending = 1e5\n  set Torsion = 2e5\nend\n"},
    {"joint on a rest", false,
     "subsection Joint joint\n  set At = POINT\n  set Pipe = PIPE\n  set Bending = 1e5\nend\n" +
         support("held", "  set Kind = rest\n")},
    {"guide with friction", true,
     element("  set Kind = guide\n  set Friction coefficient = 0.2\n")},
    {"elastic guide with friction", true,
     element("  set Kind = guide\n  set Friction coefficient = 0.2\n  set Axial rigidity = 1e9\n"
             "  set Shear rigidity = 1e8\n")},
    {"guide with a gap", true, element("  set Kind = guide\n  set Gap = 2e-3\n")},
    {"stop with a stiffness", true,
     element("  set Kind = stop\n  set Normal = 0 0 1\n  set Axial rigidity = 1e6\n")},
    {"line stop with a gap", true, element("  set Kind = line stop\n  set Gap = 1e-3\n")},
    {"rest", true, element("  set Kind = rest\n")},
    {"rest with a gap", true, element("  set Kind = rest\n  set Gap = 1e-4\n")},
    {"elastic rest", true,
     element("  set Kind = rest\n  set Axial rigidity = 1e7\n  set Shear rigidity = 1e6\n"
             "  set Torsional rigidity = 1e4\n")},
    {"pad", true, element("  set Kind = rest\n  set Pad = ptfe\n")},
    {"rod", true, element("  set Kind = rod\n")},
    {"friction", true, element("  set Kind = friction\n  set Normal = 1 -1 3\n")},
    {"platen", true,
     element("  set Kind = friction\n  set Normal = 0 1 0\n  set Normal force = 5000\n  set Shear "
             "rigidity = 1e7\n")},
    {"ground of its own pipe", true, beam_below + element("  set Kind = rest\n  set Ground = G\n")},
    {"moving ground", true,
     element("  set Kind = rest\n  set Ground motion = 0.001*t; 0; 0.001*t\n"
             "  set Ground motion time = run\n")},
    {"snubber", false, support("held", "  set Kind = snubber\n  set Normal = 0 0 1\n")},
    {"bed", true,
     "subsection Support held\n  set Kind = rest\n  set Pipe = PIPE\n  set Continuous = true\n"
     "OPTIONSend\n"},
    {"rest and guide", true,
     element("  set Kind = rest\n") +
         support("second", "  set Kind = guide\n  set Friction coefficient = 0.1\n  set Axial "
                           "rigidity = 1e9\n  set Shear rigidity = 1e7\nOPTIONS")},
    {"rest and restraint", true,
     element("  set Kind = rest\n") +
         support("second", "  set Kind = restraint\n  set Fixed = uy, rz\n")},
};

/// Ways of a friction element; the others take none of them.
inline const std::vector<std::string> ways = {
    "",
    "  set Rotations = averaged\n  set Length = 0.2\n",
    "  set Rotations = pipe\n  set Length = 0.1\n",
    "  set Torsion = true\n",
    "  set Rotations = averaged\n  set Length = 0.2\n  set Torsion = true\n",
    "  set Rotations = pipe\n  set Length = 0.1\n  set Torsion = true\n"};

inline void replace_all(std::string &text, const std::string &what, const std::string &by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

inline std::string held(const Place &place, const Holder &holder, const std::string &way) {
  std::string text = holder.text;
  const double x = place.point == "K" ? 5. - 1. + std::sqrt(0.5) : place.x,
               y = place.point == "K" ? 1. - std::sqrt(0.5) : place.y;
  const auto below = [&](const double shift) {
    std::ostringstream position;
    position << std::setprecision(17) << x - 2. * shift << ' ' << y + shift << " -0.4";
    return position.str();
  };
  replace_all(text, "GROUND_1", below(-1.));
  replace_all(text, "GROUND_2", below(1.));
  replace_all(text, "GROUND", below(0.));
  replace_all(text, "set Ground = " + below(0.), "set Ground = G");
  replace_all(text, "POINT", place.point);
  replace_all(text, "PIPE", place.pipe);
  replace_all(text, "OPTIONS", way);
  return text;
}

/// Never touches, at every place; the ground is far below and far above.
inline std::string idle_supports() {
  std::string text;
  unsigned int n = 0;
  for (const Place &place : places)
    for (const std::string &way : {ways[0], ways[2], ways[4]})
      text += "subsection Support idle" + std::to_string(++n) +
              "\n  set Kind = rest\n  set At = " + place.point + "\n  set Gap = 1\n" + way +
              "end\n";
  for (const Place &place : places)
    text +=
        "subsection Mass idle" + std::to_string(++n) + "\n  set At = " + place.point + "\nend\n";
  return text;
}

inline std::string quantities() {
  std::string text = "subsection Quantities\n";
  for (const Place &place : places)
    for (const char *motion : {"ux", "uy", "uz", "rx", "ry", "rz"})
      for (const char *step : {"cold", "warm", "kick"})
        text += std::string("  set ") + motion + "_" + place.point + "_" + step + " = " + motion +
                " at " + place.point + ", step " + step + "\n";
  for (const char *at : {"anchors.1", "anchors.2", "anchors.3"})
    for (const char *force : {"fx", "fy", "fz", "mx", "my", "mz"})
      for (const char *step : {"cold", "warm"})
        text += std::string("  set ") + force + "_" + at + "_" + step + " = " + force + " at " +
                at + ", step " + step + "\n";
  for (const char *point : {"P", "K", "Q", "T", "R1", "RM", "R2", "V1", "VM", "V2"}) {
    for (const char *side : {"before", "after"})
      for (const char *force : {"N", "Vy", "Vz", "Mx", "My", "Mz"})

        text += std::string("  set section_") + force + "_" + side + "_" + point +
                "_warm = " + force + ' ' + side + ' ' + point + ", step warm\n";
    text += std::string("  set section_SL_") + point + "_warm = SL at " + point + ", step warm\n";
  }
  for (const char *n : {"1", "2", "3", "4"})
    text += std::string("  set f_") + n + " = frequency " + n + "\n";
  return text + "end\n";
}

inline const std::string analyses = R"(
subsection Step kick
  set Loads = weight, hot, push
  set Analysis = transient
  set Duration = 0.002
end
subsection Time
  set Step = 0.002
end
subsection Modes
  set Number = 4
  set Step = warm
end
subsection Stress
  set Code = B31.3
  set Sustained = cold
end
subsection Solver
  set Contact tolerance = 1e-12
end
subsection Output
  set VTU = false
  set Report = false
end
)";

} // namespace seams
