// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/pcf/component_kinds.h"

namespace frictionbeam::import {

namespace {

constexpr const char *bores_differ = "taken as a bend of its first bore: it reduces as well";
constexpr const char *branch_on_bend = "a bend with a branch, which is taken as unreinforced";
constexpr const char *branch_on_reducer = "a reducer with a branch, which is taken as unreinforced";

constexpr ComponentKind kinds[] = {
    {"PIPE", Shape::pipe},
    {"PIPE-FIXED", Shape::pipe},
    {"PIPE-BLOCK-FIXED", Shape::pipe},
    {"PIPE-BLOCK-VARIABLE", Shape::pipe},
    {"TUBE", Shape::pipe},
    {"COUPLING", Shape::pipe, true},
    {"UNION", Shape::pipe, true},
    {"BEND", Shape::bend},
    {"ELBOW", Shape::bend},
    {"ELBOW-REDUCING", Shape::bend, false, bores_differ},
    {"BEND-TEED", Shape::bend, false, branch_on_bend, "unreinforced"},
    {"ELBOW-TEED", Shape::bend, false, branch_on_bend, "unreinforced"},
    {"TEE", Shape::tee, false, nullptr, "welding tee"},
    {"TEE-SET-ON", Shape::tee, false, "taken as unreinforced", "unreinforced"},
    {"TEE-STUB", Shape::tee, false, "taken as unreinforced", "unreinforced"},
    {"CROSS", Shape::tee, false, nullptr, "welding tee"},
    {"CROSS-SET-ON", Shape::tee, false, "taken as unreinforced", "unreinforced"},
    {"CROSS-STUB", Shape::tee, false, "taken as unreinforced", "unreinforced"},
    {"OLET", Shape::olet, false, nullptr, "integrally reinforced"},
    {"REDUCER-CONCENTRIC", Shape::reducer},
    {"REDUCER-ECCENTRIC", Shape::reducer},
    {"REDUCER", Shape::reducer},
    {"REDUCER-CONCENTRIC-TEED", Shape::reducer, false, branch_on_reducer, "unreinforced"},
    {"REDUCER-ECCENTRIC-TEED", Shape::reducer, false, branch_on_reducer, "unreinforced"},
    {"FLANGE", Shape::rigid, true},
    {"FLANGE-REDUCING-CONCENTRIC", Shape::rigid, true},
    {"FLANGE-REDUCING-ECCENTRIC", Shape::rigid, true},
    {"LAPJOINT-STUBEND", Shape::rigid, true},
    {"LAPJOINT-RING", Shape::rigid, true},
    {"GASKET", Shape::rigid, true},
    {"CLAMP", Shape::rigid, true},
    {"VALVE", Shape::rigid},
    {"VALVE-ANGLE", Shape::rigid},
    {"VALVE-3WAY", Shape::rigid},
    {"VALVE-4WAY", Shape::rigid},
    {"INSTRUMENT", Shape::rigid, true},
    {"INSTRUMENT-ANGLE", Shape::rigid},
    {"INSTRUMENT-TEE", Shape::rigid},
    {"INSTRUMENT-3WAY", Shape::rigid},
    {"INSTRUMENT-4WAY", Shape::rigid},
    {"INSTRUMENT-OFFSET", Shape::rigid},
    {"FILTER", Shape::rigid},
    {"FILTER-ANGLE", Shape::rigid},
    {"FILTER-OFFSET", Shape::rigid},
    {"TRAP", Shape::rigid},
    {"TRAP-ANGLE", Shape::rigid},
    {"SAFETY-DISC", Shape::rigid, true},
    {"MISC-COMPONENT", Shape::rigid, true},
    {"MISC-COMPONENT-ANGLE", Shape::rigid},
    {"CAP", Shape::end, true},
    {"FLANGE-BLIND", Shape::end, true},
    {"SUPPORT", Shape::support},
    {"END-CONNECTION-EQUIPMENT", Shape::joint},
    {"END-CONNECTION-PIPELINE", Shape::joint},
    {"END-POSITION-OPEN", Shape::joint},
    {"END-POSITION-CLOSED", Shape::joint},
    {"END-POSITION-NULL", Shape::joint},
    {"END-POSITION-VENT", Shape::joint},
    {"END-POSITION-DRAIN", Shape::joint},
    {"END-POSITION", Shape::joint},
    {"WELD", Shape::none},
    {"BOLT", Shape::none},
    {"FLOW-ARROW", Shape::none},
    {"INSULATION-SYMBOL", Shape::none},
    {"FLOOR-SYMBOL", Shape::none},
    {"LOCATION-POINT", Shape::none},
    {"ADDITIONAL-ITEM", Shape::none},
    {"MESSAGE", Shape::none},
    {"MESSAGE-ROUND", Shape::none},
    {"MESSAGE-SQUARE", Shape::none},
    {"MESSAGE-TRIANGLE", Shape::none},
    {"MESSAGE-POINTED", Shape::none},
};

} // namespace

const ComponentKind *find_component_kind(const std::string &word) {
  for (const ComponentKind &kind : kinds)
    if (word == kind.word)
      return &kind;
  return nullptr;
}

} // namespace frictionbeam::import
