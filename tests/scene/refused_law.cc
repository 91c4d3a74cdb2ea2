// SPDX-License-Identifier: LGPL-2.1-or-later
// A law that was compiled with a header of another interface version, or one whose parameter is
// called as an entry of every support is.
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
    {"Length", "m", 1., 0., 1e300, "of something else"}};
} // namespace

const frictionbeam::LawDescription frictionbeam_law = {frictionbeam::law_interface_version +
                                                           VERSIONS_AHEAD,
                                                       frictionbeam::LawKind::support,
                                                       frictionbeam::n_support_strains,
                                                       0,
                                                       true,
                                                       "long_law",
                                                       "none",
                                                       1,
                                                       parameters,
                                                       &law,
                                                       nullptr};
