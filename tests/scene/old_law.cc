// SPDX-License-Identifier: LGPL-2.1-or-later
// A law that was compiled with a header of another interface version.
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
} // namespace

const frictionbeam::LawDescription frictionbeam_law = {frictionbeam::law_interface_version + 1,
                                                       frictionbeam::LawKind::support,
                                                       frictionbeam::n_support_strains,
                                                       0,
                                                       true,
                                                       "old",
                                                       "none",
                                                       0,
                                                       nullptr,
                                                       &law,
                                                       nullptr};
