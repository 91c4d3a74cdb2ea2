// SPDX-License-Identifier: LGPL-2.1-or-later
// The motion between events as a power series: a mass on a spring that a harmonic force drives has
// q'' + w^2 q = F/m sin(W t), with q = F/m / (w^2 - W^2) (sin W t - W/w sin w t) from rest.
#include "../check.h"
#include "line_from.h"

#include "analysis/event/taylor_motion.h"
#include "analysis/increment/load_course.h"

using namespace frictionbeam;

int taylor_motion(int, char **) {
  const LineFrom line(R"(
subsection Point P
end
subsection Spring k
  set At = P
  set Stiffness = 200 1e3 1e3
end
subsection Mass m
  set At = P
  set Mass = 2
end
subsection Load drive
  set Kind = force
  set Forces = P 6 0 0
  set History = sin(4*t)
end
subsection Time
  set Integrator = event
  set Step = 0.1
end
subsection Step move
  set Loads = drive
  set Analysis = transient
  set Duration = 1
end
)");
  const double w = 10., W = 4., amplitude = 6. / 2. / (w * w - W * W);
  LoadCourse course(line.model);
  course.begin_step(0, {0.}, {1.}, 0., 0.);
  const EventModel event_model(line.model);
  TaylorMotion motion(event_model, 1e-9);
  Vector q = Vector::Zero(3), v = q;
  int x = -1; // the unknown that is loaded
  double time = 0.;
  while (time < 1.) {
    const double length = motion.compute(course, time, 1. - time, q, v, {}, {});
    CHECK(length > 0. && length <= 1. - time + 1e-12);
    q = TaylorMotion::at(motion.q, 1.);
    v = TaylorMotion::at(motion.v, 1.);
    time += length;
    q.cwiseAbs().maxCoeff(&x);
    CHECK_NEAR(q[x], amplitude * (std::sin(W * time) - W / w * std::sin(w * time)), 1e-11);
    CHECK_NEAR(v[x], amplitude * W * (std::cos(W * time) - std::cos(w * time)), 1e-11);
    CHECK_NEAR(q.norm(), std::abs(q[x]), 1e-14);
  }
  return check::report();
}
