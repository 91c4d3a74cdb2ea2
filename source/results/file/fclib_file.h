// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/contact_problem/global_contact_problem.h"

#include <optional>
#include <string>
#include <variant>

/**
 * @file
 * Friction-contact problems in the HDF5 format of FCLIB
 * (https://frictionalcontactlibrary.github.io), read and written with HDF5 itself. Everything that
 * is wrong with a file is a UserError.
 */
namespace frictionbeam {

/// Have a child process read a file that may be damaged: HDF5 may not survive it.
/// @throws UserError then
void try_contact_file(const std::string &path);

using ContactProblem = std::variant<contact::LocalProblem, GlobalContactProblem>;

/// Read and check the group /fclib_local of a file, or /fclib_global where there is no other.
ContactProblem read_contact_problem(const std::string &path);

/// Components of all contacts.
unsigned int n_components(const ContactProblem &problem);

/// The reactions in the group /solution of a file, if there are @p n of them.
std::optional<Eigen::VectorXd> read_contact_reactions(const std::string &path,
                                                      const unsigned int n);

/// Put r, u and perhaps v into the group /solution of a file, in place of what that group held; all
/// else stays as it is. The file is replaced at once, by a copy, so that nothing can be half
/// written.
void replace_contact_solution(const std::string &path, const contact::LocalSolution &solution,
                              const std::optional<Eigen::VectorXd> &v = {});

/// Write a new file with the group /fclib_local, and r, u in /solution.
void write_local_contact_problem(const std::string &path, const contact::LocalProblem &problem,
                                 const Eigen::VectorXd &reactions, const std::string &title,
                                 const std::string &description);

/// Write a new file with the group /fclib_global, and r, u, v in /solution.
void write_global_contact_problem(const std::string &path, const GlobalContactProblem &problem,
                                  const std::string &title, const std::string &description);

} // namespace frictionbeam
