# # A braid about a core, bent over a sheave
#
# Eight yarns are braided about a core. We look at the geometry of the braid, form it, bend it over
# a sheave, and see how far yarns slide over each other at their crossings. Start it with
#
#     ./braidx shell python3 demos/demo_core_filled_double_braid.py
#
# The computation takes about a quarter of a minute, compiling the forms some more the first time.
# It is the rope of `bending_over_sheave.toml` made small: eight yarns instead of twelve, two pitches
# instead of four, bent little, with a core that is a beam. Lengths are in mm, forces on yarns in N.

import math
from dataclasses import replace

import numpy as np

from braidx.cli.folder import agreed, choose_folder, create_folder
from braidx.geometry import build_rope, largest_overlap, outer_diameter
from braidx.geometry.bent_helix import bend_radius, frictionless_slip
from braidx.geometry.closed_forms import cover_factor, helix_angle
from braidx.output import history, snapshot
from braidx.output.bending_measures import crown_of, section_ratios, sheave_force
from braidx.output.contact_table import KINDS
from braidx.output.figures.bent import draw_bent
from braidx.output.figures.cross_section_bent import draw_crown_section
from braidx.output.interlacing import relative_displacement
from braidx.output.measures import layers
from braidx.processes import run
from braidx.scene import (
    Bend,
    BraidRecipe,
    ContactOptions,
    Core,
    Expected,
    Form,
    OutputOptions,
    RopeRecipe,
    Scene,
    SceneError,
    Sheave,
    YarnModel,
)

# ## The braid
#
# Four yarns turn to the right and four to the left; each passes alternately over and under those that
# it meets. Their mean path is a helix of radius 4 mm. The angle of 60 degrees is measured from the
# horizontal, the plane across the rope, and gives the pitch. `undulation` makes the start follow the
# motif: a yarn lies 1 mm, its radius, further out where it passes over, and as much further in where
# it passes under.

braid = BraidRecipe(
    strands_per_direction=(4, 4),
    motif="1-over-1-under",
    helix_radius=4.0,
    angle=60.0,
    undulation=1.0,
)

# ## Yarns and core
#
# A yarn is stiff along its filaments and soft across them. As a beam it has directors, two vectors
# per node that span its section and let it be squeezed. `bundle_factor = 1` says that it bends like
# a solid bar; a loose bundle of filaments has less. In a pitch a yarn meets others eight times: 24
# elements are three from crossing to crossing. With two the braid does not find its shape.

yarn = YarnModel(
    radius=1.0,
    model="beam",
    axial_stiffness=62.8e3,
    transverse_modulus=1000.0,
    shear_modulus=500.0,
    bundle_factor=1.0,
    elements_per_pitch=24,
)

# The core fills what the yarns leave: 4 less the undulation less the yarn's radius. It is a beam
# here; `model="solid"` makes it of hexahedra, and `model="rigid"` a cylinder.

core = Core(radius=2.0, model="beam", modulus=200.0, poisson=0.3)

# ## Sheave and programme
#
# The sheave is rigid. Its axis is x, and it lies below the middle of the rope. *Form* finds the
# equilibrium of the braid about its core under a small tension; *bend* clamps both ends and moves
# them towards the sheave by `travel`, in increments that are small at both ends.

scene = Scene(
    rope=RopeRecipe(name="core_filled_double_braid", pitches=2),
    braid=braid,
    core=core,
    sheave=Sheave(diameter=40.0),
    yarn=yarn,
    contact=ContactOptions(friction=0.2),
    steps=(Form(tension=10.0), Bend(travel=8.0, increments=6)),
    expected={"wrong_side_crossings": Expected(reference=0.0, tolerance=0.0)},
    output=OutputOptions(pictures=False, fields=False),
)

# A scene checks its tables against each other. What does not go together is refused, with a sentence
# that says what to do.

try:
    replace(scene, steps=(Bend(travel=50.0),))
except SceneError as refusal:
    print("refused:", refusal)

# ## Its geometry
#
# `build_rope` places the yarns. Angle, cover factor and overlap tell whether the recipe makes sense
# before anything is computed. The sines of crossing yarns lie in each other next to the crossings:
# forming parts them.

rope = build_rope(scene)
angle = helix_angle(braid.helix_radius, rope.pitch)  # from the axis, radians
cover = cover_factor(rope.num_yarns, 2 * yarn.radius, braid.helix_radius, angle)
overlap = largest_overlap(rope)
print(f"{rope.num_yarns} yarns, {len(rope.crossings)} crossings, {rope.length:.1f} mm long")
print(f"pitch {rope.pitch:.2f} mm, {math.degrees(angle):.1f} degrees from the axis")
print(f"outer diameter {outer_diameter(scene):.1f} mm, cover factor {cover:.2f}")
print(f"yarns lie in each other by up to {overlap:.2f} mm")

# ## The run


def new_folder():
    chosen = choose_folder(scene, out=None, resume=False)
    create_folder(chosen, scene)
    return chosen


folder = agreed(new_folder)
summary = run(scene, folder)

print("converged:", summary["converged"])
for name, result in summary["results"].items():
    if result["value"] is not None:  # what the run does not have is None
        print(f"{name:30} {result['value']:10.4g} {result['unit']}")

# The force that moves the ends, increment by increment, is in `history.csv`.

rows = history.read(folder / "history.csv")
for step, travel, force in zip(rows["step"], rows["travel (mm)"], rows["force (kN)"]):
    if str(step).endswith("bend"):
        print(f"travel {float(travel):5.2f} mm   force on each end {1e3 * float(force):6.2f} N")

# ## Sliding at the crossings
#
# Two states are kept as snapshots that have the same nodes: the formed rope clamped at its ends, and
# the bent one. A crossing is where two yarns lie on one radius of the rope. The two material points
# that faced each other there have parted in the bent rope; their distance across the radius is the
# relative displacement of paper 2. At the crown, where the rope is bent most, it is the mean of four.


def kept(name):
    (path,) = (folder / "snapshots").glob(f"*_{name}.npz")
    return snapshot.load(path)


straight, bent = kept("clamped"), kept("bent")
slid = relative_displacement(
    straight.centre_lines, bent.centre_lines, straight.radius, layers(straight)
)
crown = crown_of(bent)
print(f"{len(slid.reference)} crossings, {slid.mean_at_crown(crown):.3f} mm at the crown")
print(f"largest relative displacement {slid.maximum():.3f} mm")
for middle, mean, highest in zip(*slid.profile(width=rope.length / 8)):
    print(f"z = {middle:5.1f} mm   mean {mean:.3f} mm, at most {highest:.3f} mm")

# The same rope wrapped round the sheave, whose yarns slide without friction, would have at most:

wrapped = bend_radius(scene.sheave.diameter, outer_diameter(scene))
print(f"closed form {frictionless_slip(braid.helix_radius, angle, wrapped):.3f} mm")

# ## Contact forces
#
# A contact element is a pair of particles; it has a place, a normal, a gap and forces.

contacts = bent.contacts
for kind, name in enumerate(KINDS):
    force = contacts.of(kind).normal_force
    if len(force):
        print(
            f"{name:15} {len(force):4} elements, sum {force.sum():7.1f} N, max {force.max():.2f} N"
        )

# What the ends pull down the sheave holds up:

pressed, pulled = -sheave_force(bent)[1], 2e3 * rows["force (kN)"][-1]
print(f"the rope presses on the sheave with {pressed:.2f} N, its ends pull with {pulled:.2f} N")

# ## The section at the crown
#
# Where yarns are pressed they flatten: the ratio of a section's axes, 1 for a circle.

ratios = section_ratios(bent, crown)
print("ratio of the axes of the yarns' sections at the crown:", np.round(ratios, 4))

# `pictures=True` draws everything; two pictures by hand go like this.

figures = folder / "figures"
figures.mkdir()
print(draw_bent(bent, figures / "bent.png"))
print(draw_crown_section(bent, figures / "crown_section.png"))
