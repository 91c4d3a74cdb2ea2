#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random lines with friction, static and moving, with an Accuracy, against much finer answers.

  prm/benchmark/random_accuracy.py [--program build/bin/frictionbeam] [--seeds 1-100,200]
      [--demanded 1e-2,1e-3] [--jobs 2] [--keep FOLDER] [--cache FILE] [--most 0]

An odd seed is a static line: pipes of one to three legs on rests and guides, heated, pushed, moved
at a point, let go. An even seed moves: masses on springs and short pipes on friction supports, with
harmonic loads, tables with pulses, ground motions, initial displacements. Each is solved with every
Accuracy and, as the reference, with 256, 1024, 4096 and 16384 increments, or by the integrator
`event`, or in shorter and shorter time steps on finer and finer cells, until two of them differ by no
more than a tenth of the smallest Accuracy; that difference is printed as the reference's own error.
Where it stays larger there is no reference. The error of a quantity is relative to its reference, or
to a hundredth of the largest with the same unit, as in the program. Exit status 1 if any is off by
more than was demanded and the program said that it was not; --most N: only if more than N are.
"""
import argparse
import concurrent.futures
import json
import math
import os
import random
import shutil
import subprocess
import sys
import tempfile


def part(heading, **entries):
    lines = [f"subsection {heading}"]
    lines += [f"  set {name.replace('_', ' ')} = {value}" for name, value in entries.items()]
    return "\n".join(lines + ["end", ""])


class Case:
    """A parameter file and the two settings of its reference, the finer one last."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.seed = seed
        self.text = f"set Title = Random line {seed}\n"
        self.quantities = {}
        self.references = []
        if seed % 2:
            self.static_line()
        elif self.random.random() < 0.7:
            self.masses()
        else:
            self.shaken_pipe()
        self.text += part("Quantities", **self.quantities)
        self.text += part("Output", VTU="false", Report="false")

    def add(self, heading, **entries):
        self.text += part(heading, **entries)

    def pick(self, *choices):
        return self.random.choice(choices)

    def between(self, low, high):
        return float(f"{self.random.uniform(low, high):.4g}")

    def pipe(self, route):
        size = self.pick("NPS 4", "NPS 6", "NPS 8", "NPS 12")
        self.add("Material steel")
        self.add("Section s", Size=size, Contents=self.pick(0, 1000))
        self.add("Pipe p", Route=route)

    def static_line(self):
        point, names, route = [0., 0., 0.], ["A"], ["A 0 0 0"]
        axis = 0
        for leg in range(self.random.randint(1, 3)):
            point[axis] += self.between(8., 20.) * (1 if axis == 0 else self.pick(1, -1))
            names.append("BCD"[leg])
            route.append(f"{names[-1]} " + " ".join(f"{x:.6g}" for x in point))
            axis = 1 - axis
        self.pipe("; ".join(route))
        self.add("Support fix", Kind="anchor", At="A" if self.random.random() < 0.5 else
                 f"A, {names[-1]}")
        self.add("Support rest", Kind="rest", Pipe="p", Every=self.between(3., 6.),
                 Friction_coefficient=self.between(0.1, 0.5))
        if self.random.random() < 0.4:
            self.add("Support side", Kind="guide", Pipe="p", Every=self.between(7., 11.),
                     Gap=self.pick(0, 0.003), Friction_coefficient=self.between(0.1, 0.4))
        end = names[-1] if len(names) > 1 else "A"
        middle = names[len(names) // 2]
        self.add("Load weight")
        self.add("Load hot", Kind="temperature", Temperature=self.between(60., 300.))
        self.add("Load push", Kind="force", Forces=f"{middle} " + " ".join(
            str(self.between(-2000., 2000.)) for _ in range(2)) + " 0")
        self.add("Load turn", Kind="force", Forces=f"{end} " + " ".join(
            str(self.between(-3000., 3000.)) for _ in range(2)) + " 0")
        steps = [["weight"]]
        for _ in range(self.random.randint(2, 4)):
            step = ["weight"] + [f"{load} {self.between(-1., 1.) if load != 'hot' else 1}"
                                 for load in ("hot", "push", "turn") if self.random.random() < 0.6]
            steps.append(step)
        for i, step in enumerate(steps):
            self.add(f"Step s{i}", Loads=", ".join(step), Increments=1)
        self.quantities = {"ux": f"ux at {middle}", "uy": f"uy at {end}", "rz": f"rz at {middle}",
                           "fx": "fx at A", "fy": "fy at A", "mz": "mz at A",
                           "work": "work at rest.2", "slip": "slip1 at rest.1",
                           "ft": "ft1 at rest.2"}
        for n in (256, 1024, 4096, 16384):
            self.references.append([f"Step s{i}/Increments = {n}" for i in range(len(steps))])

    def history(self, duration):
        kind = self.random.random()
        if kind < 0.45:
            return f"{self.between(0.5, 1.5)}*sin({self.between(0.5, 3.)}*2*pi*t/{duration}*4)"
        if kind < 0.6:
            return (f"sin({self.between(20., 60.)}*t/{duration}) + "
                    f"{self.between(0.2, 0.8)}*sin({self.between(60., 120.)}*t/{duration} + 1)")
        if kind < 0.8:
            t0 = self.between(0.2, 0.6) * duration
            t1 = t0 + self.pick(1e-3, 1e-2, 0.1) * duration
            height = self.between(1., 3.) * (1. if t1 - t0 > 0.05 * duration else 20.)
            return f"table 0 0, {t0:.6g} 0, {t0:.6g} {height}, {t1:.6g} {height}, {t1:.6g} 0"
        times = sorted(self.between(0., 1.) * duration for _ in range(6))
        return "table 0 0, " + ", ".join(f"{t:.6g} {self.between(-1.5, 1.5)}" for t in times)

    def masses(self):
        self.text += "set Free motions = ux\nset Monitors = P1\n"
        n = self.random.randint(1, 3)
        duration = self.between(3., 8.)
        for i in range(1, n + 1):
            self.add(f"Point P{i}", Position=f"{i} 0 0")
            self.add(f"Mass m{i}", At=f"P{i}", Mass=self.between(0.5, 2.))
            other = {"Other": f"P{i - 1}"} if i > 1 else {}
            self.add(f"Spring k{i}", At=f"P{i}", Stiffness=f"{self.between(20., 200.)} 0 0",
                     **({"To": other["Other"]} if other else {}))
            if i == 1 or self.random.random() < 0.6:
                static = self.between(0.1, 0.5)
                extra = {"Dynamic_friction_coefficient": f"{static * self.between(0.5, 1.):.4g}"
                         } if self.random.random() < 0.3 else {}
                if self.random.random() < 0.2:
                    extra["Ground_motion"] = f"{self.between(0.05, 0.3)}*t; 0; 0"
                self.add(f"Support c{i}", Kind="friction", At=f"P{i}", Normal_force=10,
                         Friction_coefficient=static, **extra)
        if self.random.random() < 0.5:
            self.add("Initial i", At=f"P{n}", Displacement=f"{self.between(-.3, .3)} 0 0",
                     Velocity=f"{self.between(-2., 2.)} 0 0")
        self.add("Load f", Kind="force", Forces=f"P{n} {self.between(2., 12.)} 0 0",
                 History=self.history(duration))
        self.add("Step run", Loads="f", Analysis="transient", Duration=duration)
        integrator = self.pick("moreau_jean", "moreau_jean", "nonsmooth_alpha", "event")
        self.add("Time", Integrator=integrator)
        self.quantities = {"u": "ux at P1", "largest": f"max |ux| at P{n}", "work": "work at c1",
                           "wear": "wear at c1", "mean": f"mean |ux| at P{n}"}
        for step in (1000, 4000, 16000):
            self.references.append(["Time/Integrator = event",
                                    f"Time/Step = {duration / step:.10g}"])

    def shaken_pipe(self):
        length = self.between(4., 8.)
        self.text += "set Free motions = ux, uy, uz, rx, ry, rz\nset Monitors = M\n"
        self.pipe(f"A 0 0 0; M {length / 2:.5g} 0 0; B {length} 0 0")
        self.add("Support fix", Kind="anchor", At="A")
        self.add("Support rest", Kind="rest", At="M, B", Friction_coefficient=self.between(.1, .4),
                 Shear_rigidity=self.pick("1e7", "1e8"), Axial_rigidity="1e8")
        duration = 0.5
        self.add("Load weight")
        self.add("Load q", Kind="ground acceleration",
                 Acceleration=f"{self.between(2., 8.)} {self.between(2., 8.)} 0",
                 History=self.history(duration))
        self.add("Step w", Loads="weight")
        self.add("Step run", Loads="weight, q", Analysis="transient", Duration=duration)
        self.add("Time", Mass_damping=1, Stiffness_damping="1e-5")
        self.quantities = {"uy": "max |uy| at M", "end": "uy at B", "work": "work at rest.2",
                           "mz": "max |mz| at A"}
        for step, cells in ((2e-5, 16), (1e-5, 32), (5e-6, 64)):
            self.references.append([f"Time/Step = {step}", "Time/Output interval = 0.05",
                                    f"Mesh/Cell length = {length / cells:.8g}"])


def solve(program, file, settings, limit):
    folder = tempfile.mkdtemp(prefix="random_accuracy_")
    command = [program, file, "--output-directory", folder]
    for setting in settings:
        command += ["--set", setting]
    try:
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              timeout=limit, check=False,
                              env=dict(os.environ, OMPI_MCA_ess_singleton_isolated="1"))
        if done.returncode not in (0, 2):
            return {"status": "refused", "why": done.stderr.strip(), "values": {}, "units": {}}
        with open(os.path.join(folder, "summary.json")) as text:
            summary = json.load(text)
        return {"status": summary["status"],
                "values": {q["name"]: q["value"] for q in summary["quantities"]},
                "units": {q["name"]: q["unit"] for q in summary["quantities"]},
                "estimate": summary.get("accuracy", {}).get("estimate") if
                summary.get("accuracy") else None,
                "runs": len(summary["accuracy"]["runs"]) if summary.get("accuracy") else 1,
                "seconds": summary["cost"]["solve_seconds"]}
    except subprocess.TimeoutExpired:
        return {"status": "too long", "values": {}, "units": {}}
    finally:
        shutil.rmtree(folder, ignore_errors=True)


ROUNDING = 1e-12  # [N, m, J]: where nothing moves, 1e-25 N beside 1e-26 N is no error


def errors(answer, reference):
    """Of each quantity, relative as in the program."""
    largest = {}
    for name, value in reference["values"].items():
        unit = reference["units"][name]
        largest[unit] = max(largest.get(unit, 0.), abs(value))
    result = {}
    for name, value in reference["values"].items():
        scale = max(abs(value), 0.01 * largest[reference["units"][name]], ROUNDING)
        found = answer["values"].get(name, math.nan)
        result[name] = abs(found - value) / scale
    return result


def reference(arguments, file, levels):
    """The finest answer and its difference to the one before."""
    before, own = None, math.inf
    for settings in levels:
        answer = solve(arguments.program, file, settings, 600)
        if answer["status"] != "converged":
            return before or answer, math.inf
        if before:
            own = max(errors(before, answer).values(), default=math.inf)
            if own <= 0.1 * min(arguments.demanded):
                return answer, own
        before = answer
    return before, own


def judge(seed, arguments, cache):
    case = Case(seed)
    folder = arguments.keep or tempfile.gettempdir()
    file = os.path.join(folder, f"random_accuracy_{seed}_{os.getpid()}.prm")
    with open(file, "w") as text:
        text.write(case.text)
    key = f"{seed}:{hash_of(case)}"
    lines, wrong = [], 0
    try:
        if key not in cache:
            cache[key] = reference(arguments, file, case.references)
        fine, own = cache[key]
        if not own <= 0.3 * min(arguments.demanded):
            return [f"{seed:4d} no reference: {fine['status']}, known to {own:.1e} only "
                    f"{fine.get('why', '')}"], 0, 0, key
        for demanded in arguments.demanded:
            answer = solve(arguments.program, file, [f"Accuracy = {demanded:g}"], 300)
            off = errors(answer, fine)
            worst = max(off, key=lambda name: (math.isnan(off[name]), off[name]))
            claimed = answer["status"] == "converged"
            is_wrong = claimed and not off[worst] <= demanded + own
            wrong += is_wrong
            lines.append(f"{seed:4d} {demanded:g} {answer['status']:>10s} "
                         f"estimate {answer.get('estimate') or 0.:.1e} error {off[worst]:.1e} "
                         f"({worst}), reference's {own:.1e}, {answer.get('runs', 0)} runs, "
                         f"{answer.get('seconds', 0.):.2f} s" + (" WRONG" if is_wrong else ""))
        return lines, wrong, len(arguments.demanded), key
    finally:
        if not arguments.keep:
            os.remove(file)


def hash_of(case):
    value = 14695981039346656037
    for byte in (case.text + str(case.references)).encode():
        value = (value ^ byte) * 1099511628211 % 2**64
    return f"{value:x}"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/bin/frictionbeam")
    parser.add_argument("--seeds", default="1-100")
    parser.add_argument("--demanded", default="1e-2,1e-3",
                        type=lambda text: [float(word) for word in text.split(",")])
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep", help="folder for the parameter files")
    parser.add_argument("--cache", help="file of references, so that they are solved once")
    parser.add_argument("--most", type=int, default=0)
    arguments = parser.parse_args()
    seeds = []
    for word in arguments.seeds.split(","):
        first, _, last = word.partition("-")
        seeds += range(int(first), int(last or first) + 1)
    cache = {}
    if arguments.cache and os.path.exists(arguments.cache):
        with open(arguments.cache) as text:
            cache = json.load(text)
    if arguments.keep:
        os.makedirs(arguments.keep, exist_ok=True)
    n_wrong = n_all = 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for lines, wrong, n, _ in pool.map(lambda seed: judge(seed, arguments, cache), seeds):
            print("\n".join(lines), flush=True)
            n_wrong += wrong
            n_all += n
    if arguments.cache:
        with open(arguments.cache, "w") as text:
            json.dump(cache, text)
    print(f"{n_wrong} of {n_all} answers are off by more than was demanded")
    return 1 if n_wrong > arguments.most or n_all == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
