// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/body_results.h"
#include "results/file/csv_writer.h"
#include "results/file/output_file.h"
#include "results/page/html.h"
#include "results/page/plot.h"
#include "results/text.h"

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr unsigned int n_numbers = 17; ///< that a row travels as

using Numbers = std::array<double, n_numbers>;

Numbers pack(const ContactRow &row) {
  return {{static_cast<double>(row.surface), row.position[0], row.position[1], row.position[2],
           row.area, static_cast<double>(row.status), row.pressure, row.traction1, row.traction2,
           row.gap, row.slip1, row.slip2, row.displacement[0], row.displacement[1],
           row.displacement[2], static_cast<double>(row.step), row.time}};
}

ContactRow unpack(const Numbers &n, const unsigned int increment) {
  ContactRow row;
  row.surface = static_cast<unsigned int>(n[0]);
  row.position = Point3(n[1], n[2], n[3]);
  row.area = n[4];
  row.status = static_cast<ContactStatus>(static_cast<int>(n[5]));
  row.pressure = n[6];
  row.traction1 = n[7];
  row.traction2 = n[8];
  row.gap = n[9];
  row.slip1 = n[10];
  row.slip2 = n[11];
  for (unsigned int d = 0; d < 3; ++d)
    row.displacement[d] = n[12 + d];
  row.step = static_cast<unsigned int>(n[15]);
  row.time = n[16];
  row.increment = increment;
  return row;
}

} // namespace

template <int dim>
std::vector<ContactRow> contact_rows(const ContinuumBody<dim> &body,
                                     const FoundationContacts &contacts,
                                     const ContinuumState &state) {
  std::vector<Numbers> own;
  for (unsigned int i = 0; i < body.nodes.size(); ++i) {
    const auto &node = body.nodes[i];
    const LocalVector &stress = state.contacts.stress[i], &u = state.contact_displacement[i];
    const LocalVector slip = contacts.slip(i, u, state.contacts);
    ContactRow row;
    row.surface = node.surface;
    row.step = state.step;
    row.time = state.time;
    row.area = node.weight;
    row.status = state.contacts.status[i];
    row.pressure = -stress[0];
    row.traction1 = stress[1];
    row.traction2 = stress[2];
    row.gap = contacts.gap(i, u);
    row.slip1 = slip[1];
    row.slip2 = slip[2];
    for (unsigned int d = 0; d < dim; ++d) {
      row.position[d] = node.position[d];
      row.displacement[d] = state.displacement(node.dofs[d]);
    }
    own.push_back(pack(row));
  }
  std::vector<ContactRow> rows;
  for (const auto &part : Utilities::MPI::all_gather(body.communicator, own))
    for (const Numbers &numbers : part)
      rows.push_back(unpack(numbers, state.increment));
  std::sort(rows.begin(), rows.end(), [](const ContactRow &a, const ContactRow &b) {
    if (a.surface != b.surface)
      return a.surface < b.surface;
    for (unsigned int d = 0; d < 3; ++d)
      if (a.position[d] != b.position[d])
        return a.position[d] < b.position[d];
    return false;
  });
  return rows;
}

void write_contact_csv(const Scene &scene, const std::vector<ContactRow> &rows,
                       const std::string &folder) {
  OutputFile file(folder + "/contact.csv");
  file.stream() << "surface,step,increment,time,x,y,z,area,status,pressure,t1,t2,gap,slip1,slip2,"
                   "ux,uy,uz\n";
  for (const ContactRow &row : rows) {
    std::string line = csv_field(scene.continuum->contacts[row.surface].part) + ',' +
                       csv_field(scene.continuum->steps[row.step].name) + ',' +
                       std::to_string(row.increment) + ',' + exact_number(row.time);
    for (unsigned int d = 0; d < 3; ++d)
      (line += ',') += exact_number(row.position[d]);
    line += ',' + exact_number(row.area) + ',' + status_word(row.status);
    for (const double number :
         {row.pressure, row.traction1, row.traction2, row.gap, row.slip1, row.slip2,
          row.displacement[0], row.displacement[1], row.displacement[2]})
      (line += ',') += exact_number(number);
    file.stream() << line << '\n';
  }
  file.flush();
}

std::string contact_charts(const Scene &scene, const std::vector<ContactRow> &rows) {
  std::vector<Plot> plots;
  for (unsigned int s = 0; s < scene.continuum->contacts.size(); ++s) {
    Plot traction, motion;
    traction.x_label = motion.x_label = "x [m]";
    traction.y_label = "traction [Pa]";
    motion.y_label = "slip, gap [m]";
    traction.title = motion.title = scene.continuum->contacts[s].part;
    const unsigned int last = scene.continuum->steps.size() - 1;
    Plot::Series pressure, friction, slip, gap;
    pressure.label = "pressure";
    friction.label = "friction t1";
    slip.label = "slip t1";
    gap.label = "gap";
    for (const ContactRow &row : rows)
      if (row.surface == s && row.step == last) {
        for (Plot::Series *series : {&pressure, &friction, &slip, &gap})
          series->x.push_back(row.position[0]);
        pressure.y.push_back(row.pressure);
        friction.y.push_back(row.traction1);
        slip.y.push_back(row.slip1);
        gap.y.push_back(row.gap);
      }
    traction.series = {pressure, friction};
    motion.series = {slip};
    if (!scene.continuum->contacts[s].pressure)
      motion.series.push_back(gap);
    plots.push_back(traction);
    plots.push_back(motion);
  }
  const DrawnPlots drawn = draw_plots(plots, "contact");
  if (!drawn.problem.empty())
    return html_note(drawn.problem);
  std::string text;
  for (const std::string &svg : drawn.svg)
    text += "<div class=\"picture\">" + svg + "</div>\n";
  return text + html_note("At the end of the last step, along x; contact.csv has every node.");
}

template std::vector<ContactRow>
contact_rows<2>(const ContinuumBody<2> &, const FoundationContacts &, const ContinuumState &);
template std::vector<ContactRow>
contact_rows<3>(const ContinuumBody<3> &, const FoundationContacts &, const ContinuumState &);

} // namespace frictionbeam
