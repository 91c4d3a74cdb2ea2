// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <vector>

/// @file Numbers as the model's script reads them. What is not finite becomes null.
namespace frictionbeam {

/// A number with some digits.
nlohmann::ordered_json rounded(const double value, const unsigned int digits);

/// Numbers one beside the other, as differences in whole steps of 1/20000 of the largest.
nlohmann::ordered_json packed(const std::vector<double> &values);

} // namespace frictionbeam
