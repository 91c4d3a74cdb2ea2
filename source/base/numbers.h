// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/// @file Tolerances that recur. Every other one has a name or a reason where it stands.
namespace frictionbeam {

/// Instants closer than this part of their step are one: what adding up time steps leaves.
constexpr double same_instant_of_step = 1e-9;
/// Arc lengths closer than this part of the pipe's length, and places closer than this part of
/// their distance from the origin, are one: what two ways to compute them leave.
constexpr double same_place = 1e-9;
/// Components of a unit vector below this are not meant: files give directions to six digits.
constexpr double no_direction = 1e-6;
/// Components below this part of a computed vector or matrix are rounding.
constexpr double no_component = 1e-12;
/// Numbers that differ by less than this part are equal but for the order of their sums.
constexpr double equal_numbers = 1e-9;
/// Keeps a quotient finite where its denominator may be zero.
constexpr double not_zero = 1e-300;

} // namespace frictionbeam
