// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Laws that the loader refuses, each with one fault, chosen when compiling; without any, a law that
// it takes.
#include <frictionbeam/law.h>

namespace {

using namespace frictionbeam;

constexpr LawParameter parameters[] = {
#ifdef UNIT_MISSING
    {"Stiffness", "", 1., 0., 2., "not used"}
#elif defined(DEFAULT_OUT_OF_BOUNDS)
    {"Stiffness", "N", 3., 0., 2., "not used"}
#else
    {"Stiffness", "N", 1., 0., 2., "not used"}
#endif
#ifdef PARAMETER_TWICE
    ,
    {"Stiffness", "N", 1., 0., 2., "not used"}
#endif
};

class Law final : public LawBase {
public:
  LawStatus integrate(const LawInput &, LawOutput &) const noexcept override {
#ifdef CRASHES
    __builtin_trap();
#endif
    return LawStatus::failed;
  }
};

constexpr Law law;

/// As laws of version 1 of the interface were compiled.
void old_threshold(const double *p, FrictionThreshold &t) {
  t.static_friction = t.dynamic_friction = p[0];
  t.slip_z = 1;
  t.twist = 2;
  t.was_slipping = 3;
}

void threshold(const LawInput &in, FrictionThreshold &t) {
  old_threshold(in.parameters, t);
#ifdef PLACE_OUTSIDE
  t.slip_z = 77;
#endif
}

using Threshold = decltype(LawDescription::threshold);

} // namespace

#ifdef SYMBOL_MISSING
extern "C" const LawDescription another_name;
#define frictionbeam_law another_name
#endif

#ifdef VERSION_WRONG
#define VERSION (law_interface_version + 1)
#elif defined(VERSION_ONE)
#define VERSION 1
#else
#define VERSION law_interface_version
#endif
#ifdef KIND_WRONG
#define KIND static_cast<LawKind>(5)
#elif defined(SECTION_THRESHOLD)
#define KIND LawKind::section
#else
#define KIND LawKind::support
#endif
#ifdef STRAINS_WRONG
#define STRAINS 3
#elif defined(SECTION_THRESHOLD)
#define STRAINS n_section_strains
#else
#define STRAINS n_support_strains
#endif
#ifdef STATES_WRONG
#define STATES -2
#elif defined(VERSION_ONE) || defined(PLACE_OUTSIDE) || defined(SECTION_THRESHOLD)
#define STATES 4
#else
#define STATES 0
#endif
#ifdef NAME_TAKEN
#define NAME "coulomb"
#elif defined(NAME_MISSING)
#define NAME nullptr
#else
#define NAME "taken"
#endif
#ifdef REFERENCE_MISSING
#define REFERENCE ""
#else
#define REFERENCE "a test"
#endif
#ifdef LAW_MISSING
#define LAW nullptr
#else
#define LAW &law
#endif
#ifdef LIST_MISSING
#define LIST nullptr
#else
#define LIST parameters
#endif
#ifdef LIST_TOO_LONG
#define N_PARAMETERS 2000000000
#else
#define N_PARAMETERS sizeof(parameters) / sizeof(parameters[0])
#endif

#ifdef VERSION_ONE
#define FORM reinterpret_cast<Threshold>(reinterpret_cast<void (*)()>(&old_threshold))
#elif defined(PLACE_OUTSIDE) || defined(SECTION_THRESHOLD)
#define FORM &threshold
#else
#define FORM nullptr
#endif

[[maybe_unused]] const Threshold unused = &threshold;

const LawDescription frictionbeam_law = {VERSION,   KIND,         STRAINS, STATES, true, NAME,
                                         REFERENCE, N_PARAMETERS, LIST,    LAW,    FORM};
