// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/page/html.h"
#include "results/report/report_tables.h"
#include "results/text.h"

namespace frictionbeam {

std::string accuracy_section(const AccuracyAccount &account) {
  std::string text = "<p>Demanded of the quantities: " + rounded_number(account.demanded, 2) +
                     " relative. Estimated error: " + rounded_number(account.estimate, 2) +
                     (account.reached ? "." : ": <b>not reached</b>.") + " Chosen: ";
  if (account.chosen.empty())
    text += "nothing; the answer does not depend on a mesh, a time step or increments.";
  for (const std::string &setting : account.chosen)
    text += "<code>" + escape_xml(setting) + "</code> ";
  text += "</p>\n";
  if (!account.model.empty())
    text += "<p>Solved as a " + account.model + ": " + escape_xml(account.model_reason) +
            (account.line_error ? ". Estimate of what the line leaves out: " +
                                      rounded_number(*account.line_error, 2) + "."
                                : ".") +
            "</p>\n";
  for (const std::string &quantity : account.left_out)
    text += html_note("Left out: " + escape_xml(quantity) + ".");
  std::vector<std::string> settings, seconds, changes;
  for (const AccuracyAccount::Run &run : account.runs) {
    settings.push_back(run.settings);
    seconds.push_back(rounded_number(run.seconds, 3));
    changes.push_back(!run.converged ? "not converged"
                      : run.change   ? rounded_number(*run.change, 3)
                                     : "\u2013");
  }
  return text + HtmlTable()
                    .text("Run", settings)
                    .right("Time [s]", seconds)
                    .right("Change of the quantities", changes)
                    .str();
}

} // namespace frictionbeam
