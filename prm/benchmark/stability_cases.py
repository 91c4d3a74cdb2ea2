# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cases of the stability suite, group by group."""
import glob
import os
import re
from dataclasses import dataclass, field

HERE = os.path.dirname(os.path.abspath(__file__))
METHODS = ("exact", "newton", "elastic")
RIGID_SLAB_HOLDS = 24.0  # N, friction of the whole slab


@dataclass
class Case:
    """One parameter file with some entries set, and where its result stands in the page's table."""

    name: str
    file: str
    settings: list
    row: str = ""
    column: str = ""
    methods: tuple = METHODS
    no_equilibrium: bool = False  # whether the true answer is that there is none
    # Cases that differ in length only: a method that fails on two of a series is spared the rest.
    series: str = ""
    runs: int = 1
    tags: dict = field(default_factory=dict)


def prm(name):
    return os.path.join(HERE, name + ".prm")


def number(value):
    return f"{value:.0e}".replace("e+0", "e").replace("e+", "e") if value >= 1e3 else f"{value:g}"


def slab(quick):
    """The slab cycled, against the exact solution of its discrete model; and pushed too hard."""
    cases = []
    for elements in (16,) if quick else (16, 800):
        for GS in [10.0**k for k in range(0, 16, 5 if quick else 1)] + [0.0]:
            settings = [f"Slab/GS = {GS:g}", f"Slab/Elements = {elements}"]
            GS_text = "rigid" if GS == 0 else number(GS)
            label = f"GS = {GS_text}, {elements} elements"
            cases.append(Case(label, prm("slab_cycle"), settings, f"{elements} elements", GS_text))
            if GS in (0.0, 1e6):
                force = RIGID_SLAB_HOLDS * 1.25
                cases.append(Case(label + f", F = {force:g}", prm("slab_cycle"),
                                  settings + [f"Slab/Force = {force:g}"],
                                  f"{elements} elements, F = {force:g}", GS_text,
                                  no_equilibrium=True))
    return cases


def rack(quick):
    """Two families of racks, by length, guides, friction and load sequence."""
    lengths = (20, 50) if quick else (20, 50, 100, 200, 400, 1000, 4000)
    cases = []
    for kind in ("plant", "planar"):
        for guide in (0, 3):
            for sequence in ("one step", "weight heat cool"):
                row = f"{kind}, {'guides' if guide else 'no guides'}, {sequence}"
                for friction in (0.3, 2) if quick else (0.1, 0.3, 0.6, 1, 2):
                    for n in lengths:
                        entries = (f"Kind = {kind}", f"Spans = {n}", f"Guide every = {guide}",
                                   f"Friction = {friction}", f"Sequence = {sequence}")
                        cases.append(Case(f"{row}, f = {friction}, n = {n}", prm("rack_family"),
                                          ["Rack/" + entry for entry in entries], row, f"n = {n}",
                                          series=f"{row}, f = {friction}"))
    return cases


def friction_entries(file):
    """The friction coefficients of a parameter file, but for rollers, which have none."""
    with open(file) as text:
        found = re.findall(r"subsection (Support \w+)\n(.*?)\nend", text.read(), re.S)
    entries = []
    for support, entry in found:
        value = re.search(r"set Friction coefficient = (\S+)", entry)
        if value and float(value.group(1)) > 0:
            entries.append(support + "/Friction coefficient")
    return entries


def chatter(quick):
    """Contacts that open and close, all of them with several friction coefficients."""
    cases = []
    for file in sorted(glob.glob(prm("chatter_*"))):
        name = os.path.basename(file)[len("chatter_"):-len(".prm")].replace("_", " ")
        cases.append(Case(f"{name}, as it stands", file, [], name, "as it stands"))
        for f in (1,) if quick else (0.1, 0.3, 1, 3, 10):
            settings = [f"{entry} = {f}" for entry in friction_entries(file)]
            cases.append(Case(f"{name}, f = {f}", file, settings, name, f"f = {f}"))
    return cases


def random(quick, n_seeds=2000, n_others=200):
    """Random lines; the methods that need a stiffness get the first of them only."""
    if quick:
        n_seeds, n_others = 20, 5
    return [Case(f"seed {seed}", prm("random_line"), [f"Random/Seed = {seed}"], methods=METHODS
                 if seed <= n_others else ("exact",)) for seed in range(1, n_seeds + 1)]


def speed(quick):
    """Racks in one step, one after the other with nothing beside them."""
    cases = []
    lengths = (400, 1000) if quick else (400, 1000, 4000, 10000, 40000)
    for kind, frictions, ns in (("plant", (0.3, 1), lengths), ("planar", (0.3, 2), (400,))):
        for f in frictions:
            for n in ns:
                settings = [f"Rack/Kind = {kind}", f"Rack/Spans = {n}", f"Rack/Friction = {f}"]
                cases.append(Case(f"{kind}, f = {f}, n = {n}", prm("rack_family"), settings,
                                  methods=("exact",), runs=3 if quick or n > 10000 else 5,
                                  tags={"kind": kind, "friction": f, "n": n}))
    return cases


GROUPS = {"slab": slab, "rack": rack, "chatter": chatter, "random": random, "speed": speed}
