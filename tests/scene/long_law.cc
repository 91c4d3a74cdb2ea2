// SPDX-License-Identifier: LGPL-2.1-or-later
// A law whose parameter is called as an entry is that every support has.
#include <frictionbeam/law.h>

namespace {
class Nothing final : public frictionbeam::LawBase {
public:
  frictionbeam::LawStatus integrate(const frictionbeam::LawInput &,
                                    frictionbeam::LawOutput &) const noexcept override {
    return frictionbeam::LawStatus::failed;
  }
};
constexpr Nothing law;
constexpr frictionbeam::LawParameter parameters[] = {
    {"Stiffness of its own", "N", 1., 0., 1e300, "in compression"},
    {"Length", "m", 1., 0., 1e300, "of something else"}};
} // namespace

const frictionbeam::LawDescription frictionbeam_law = {frictionbeam::law_interface_version,
                                                       frictionbeam::LawKind::support,
                                                       frictionbeam::n_support_strains,
                                                       0,
                                                       true,
                                                       "long_law",
                                                       "none",
                                                       2,
                                                       parameters,
                                                       &law,
                                                       nullptr};
