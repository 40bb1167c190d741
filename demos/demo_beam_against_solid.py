# # A beam against a solid
#
# Yarns of a rope can be beams or solids, or beams in one place and solids in another. Here a single
# yarn is all three: we bend it, compare, and see what each costs. Start it with
#
#     ./braidx shell python3 demos/demo_beam_against_solid.py
#
# The computation takes about a quarter of a minute, compiling the forms some more the first time. It
# uses bodies and the solver without a scene, which is the way to build other models from them.
# Lengths are in mm, forces in N.

import time
from pathlib import Path

import numpy as np
from mpi4py import MPI

from braidx.bodies import BeamBody, BeamSection, SolidBody, YarnMaterial
from braidx.bodies.coupling import follow_section
from braidx.geometry.frames import rotation_minimising_frames
from braidx.meshing import round_section, sweep
from braidx.output.figures.style import AMBER, BLUE, GREY, figure, panels, save
from braidx.solver.newton import Newton, NewtonOptions
from braidx.system.constraints import Constraints
from braidx.system.global_system import GlobalSystem
from braidx.system.terms import BodyTerm, LoadTerm

# ## The yarn
#
# It undulates as yarns of a braid do at crossings: one wave of 12 mm, 1 mm to either side. Stiff along
# its filaments and soft in shear, it is clamped at one end. A force of 4 N acts on the other one, out
# of the plane of the wave, so that the yarn is bent and twisted; it is applied in two steps.

RADIUS, WAVE, HEIGHT, LENGTH = 1.0, 12.0, 1.0, 12.0
FORCE, STEPS = np.array([0.0, 4.0, 0.0]), 2
MATERIAL = YarnMaterial(20e3, 1000.0, 500.0, 0.3, 0.3)


def centre_line(start, end, num_layers):
    z = np.linspace(start, end, num_layers)
    return np.column_stack([HEIGHT * np.cos(2 * np.pi * z / WAVE), 0 * z, z])


# Sections need directors. Those of the beam and of the solid come from one frame along the whole
# yarn, taken at its finest, so that they agree where the two meet.

FINE = 960
(FRAMES,) = rotation_minimising_frames([centre_line(0.0, LENGTH, FINE + 1)])


def directors(line):
    return FRAMES[np.round(line[:, 2] / LENGTH * FINE).astype(int)]


# ## Three models
#
# A beam has nine unknowns per node, x, g1 and g2; a solid has three per node, and a mesh that is
# swept along the same line. Degree 1, unless said otherwise.


def beam(start, end, num_elements):
    line = centre_line(start, end, num_elements + 1)
    section = BeamSection.round(RADIUS)
    frames = [directors(line)]
    return BeamBody(MPI.COMM_SELF, [line], section=section, material=MATERIAL, directors=frames)


def solid(start, end, num_elements, degree=1):
    line = centre_line(start, end, degree * num_elements + 1)
    section = round_section(RADIUS, 12, degree=degree, equal_area=True)
    return SolidBody(MPI.COMM_SELF, sweep(line, section, directors(line)), material=MATERIAL)


# Bodies are numbered one after the other. The section at the start is held. Where a solid begins at a
# beam's last node its face follows that node's section, x + xi1 g1 + xi2 g2: forces and moments pass.


def bend(bodies):
    """Displacement of the yarn's end (mean over its section), mm; unknowns solved for, seconds."""
    begin = time.perf_counter()
    first = np.cumsum([0] + [body.num_unknowns for body in bodies])
    rest = np.concatenate([body.rest.ravel() for body in bodies])
    constraints, values = Constraints(len(rest)), np.zeros(len(rest))
    held = end_section(bodies[0], 0)[0]
    constraints.hold(held)
    values[held] = rest[held]
    if len(bodies) == 2:
        sections = bodies[1].mesh.sweeps[0]
        face = first[1] + 3 * sections.layers[0][:, None] + np.arange(3)
        follow_section(constraints, values, face, sections.section, first[1] - 9)
    positions, share = end_section(bodies[-1], -1)[1:]
    positions = first[-2] + positions
    load = LoadTerm(len(rest))
    terms = [BodyTerm(body, int(start)) for body, start in zip(bodies, first)]
    system = GlobalSystem(MPI.COMM_SELF, [*terms, load], constraints.resolve(), values)
    system.update_pattern()
    newton = Newton(system, NewtonOptions(tolerance=1e-8), np.zeros(len(rest), dtype=bool))
    q = rest
    for step in range(1, STEPS + 1):
        load.loads[positions] = step / STEPS * share[:, None] * FORCE
        q, result = newton.solve(q)
        assert result.converged, result.reason
    moved = share @ (q - rest)[positions]
    return moved, system.num_free, time.perf_counter() - begin


def end_section(body, which):
    """All unknowns of a section, its positions (n, 3) in the body, and the share of each in its area."""
    if isinstance(body, BeamBody):
        node = 9 * (which % body.num_nodes)
        return node + np.arange(9), node + np.arange(3)[None], np.ones(1)
    swept = body.mesh.sweeps[0]
    positions = 3 * swept.layers[which][:, None] + np.arange(3)
    return positions.ravel(), positions, swept.weights / swept.weights.sum()


def yarn(model, num_elements):
    """The bodies of the yarn as "beam", "solid" or "half", beam in its first half and solid beyond."""
    if model == "beam":
        return [beam(0.0, LENGTH, num_elements)]
    if model == "solid":
        return [solid(0.0, LENGTH, num_elements)]
    middle, half = LENGTH / 2, num_elements // 2
    return [beam(0.0, middle, half), solid(middle, LENGTH, half)]


# ## Error and cost
#
# The reference is a solid of degree 2, which is within about 0.1 % of a finer one.

reference, unknowns, seconds = bend([solid(0.0, LENGTH, 24, degree=2)])
print(
    f"reference: {unknowns} unknowns, {seconds:.2f} s, end moves by", np.round(reference, 4), "mm"
)

COUNTS = (6, 12, 24, 48)
for model in ("beam", "half", "solid"):
    bend(yarn(model, 6))  # compiles the forms
table = {}
print("model  elements  unknowns  seconds  deflection (mm)  error (%)")
for model in ("beam", "half", "solid"):
    for count in COUNTS:
        moved, unknowns, seconds = bend(yarn(model, count))
        error = np.linalg.norm(moved - reference) / np.linalg.norm(reference)
        table[model, count] = error, seconds, unknowns
        print(
            f"{model:5} {count:9} {unknowns:9} {seconds:8.3f} {moved[1]:16.4f} {100 * error:10.2f}"
        )

# With 24 elements each model is within 1 %, and the joint of the half-and-half yarn adds nothing. The
# beam has a tenth of the unknowns and takes a small part of the time. With more elements errors level
# off at a few parts in a thousand: of solids that is the mesh of the section, of beams the beam itself,
# whose sections deform as one. What a beam cannot show are stresses where a yarn is pressed: take
# solids where they matter, beams beyond, as `yarn.model = "mixed"` does.

# ## A picture

page = figure(6.4, 4.4)
(ax,) = panels(page, 1, 1)
for model, colour in (("beam", BLUE), ("half", GREY), ("solid", AMBER)):
    errors, times = zip(*(table[model, count][:2] for count in COUNTS))
    ax.loglog(times, 100 * np.array(errors), "o-", color=colour, label=model)
ax.set_yticks([0.3, 1.0, 3.0], ["0.3", "1", "3"])
ax.set_xlabel("time (s)")
ax.set_ylabel("error of the end's displacement (%)")
ax.set_title("an undulating yarn, bent: 6, 12, 24 and 48 elements along it")
ax.grid(True)
ax.legend()
folder = Path("results/beam_against_solid")
folder.mkdir(parents=True, exist_ok=True)
print(save(page, folder / "error.png"))
