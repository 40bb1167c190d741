# # A first rope in Python
#
# The rope of `small_rope.toml`: eight strands of one yarn each, braided 1-over 1-under, one pitch
# long. It is built, checked, formed and pulled; then we look at the results. Start it with
#
#     ./braidx shell python3 demos/demo_first_rope.py
#
# The computation takes one to two seconds, compiling the forms some more the first time.

import numpy as np

from braidx.cli.folder import agreed, choose_folder, create_folder
from braidx.geometry import build_rope
from braidx.output import history, snapshot
from braidx.output.measures import contact_statistics, outer_diameter
from braidx.processes import run
from braidx.scene import (
    BraidRecipe,
    ContactOptions,
    Expected,
    Form,
    Material,
    OutputOptions,
    Pull,
    RopeRecipe,
    Scene,
    Settle,
    YarnModel,
)

# ## The scene
#
# Every table of a scene is a frozen dataclass with the same name and the same keys as in TOML.
# Lengths are in mm, forces on yarns in N, forces on the rope in kN. A value out of its range raises
# a `SceneError` that names it.

scene = Scene(
    rope=RopeRecipe(name="first_rope", pitch=36.0, pitches=1),
    braid=BraidRecipe(strands_per_direction=(4, 4), motif="1-over-1-under", helix_radius=2.0),
    yarn=YarnModel(
        radius=0.86,
        axial_stiffness=162e3,
        bundle_factor=1e-2,  # what the material says, for beams
        material="filaments",
        elements_per_pitch=36,
    ),
    material={"filaments": Material(bundle_factor=1e-2)},
    contact=ContactOptions(friction=0.1),
    steps=(Form(tension=20.0), Settle(), Pull(to_force=5.0)),
    expected={"wrong_side_crossings": Expected(reference=0.0, tolerance=0.0)},
    output=OutputOptions(pictures=False, fields=False),
)

# ## Its start configuration
#
# `build_rope` checks what one table cannot know about another and places the yarns on helices.
# Where two strands cross, their yarns lie in each other: only the stacking order, +1 where the
# strand of the first direction is outside, says which way they have to part.

rope = build_rope(scene)
print(f"{rope.num_yarns} yarns, {len(rope.crossings)} crossings, {rope.length:g} mm long")
print("stacking order of the first crossings:", rope.crossings.order[:8])

# ## The run
#
# A run needs a folder of its own: `results/first_rope`, or the next free number. `agreed` lets all
# MPI processes, if there are several, use the one that the first of them has chosen.


def new_folder():
    chosen = choose_folder(scene, out=None, resume=False)
    create_folder(chosen, scene)
    return chosen


folder = agreed(new_folder)
summary = run(scene, folder)

# ## The results
#
# `summary` is what `summary.json` holds.

print("converged:", summary["converged"])
for name, result in summary["results"].items():
    met = {True: ", as expected", False: ", NOT as expected", None: ""}[result["met"]]
    print(f"{name:30} {result['value']:12.6g} {result['unit']}{met}")

# States worth a look are kept as snapshots: plain arrays.

(path,) = (folder / "snapshots").glob("*_formed.npz")
formed = snapshot.load(path)
assert formed.contacts is not None
lengths = [np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for line in formed.centre_lines]
print(f"formed: outer diameter {outer_diameter(formed):.2f} mm")
print(f"yarns are {100 * (np.mean(lengths) / rope.length - 1):.1f} % longer than the rope")
print(contact_statistics(formed))

# The force over the strain, increment by increment, is in `history.csv`.

rows = history.read(folder / "history.csv")
for step, strain, force in zip(rows["step"], rows["rope strain (-)"], rows["force (kN)"]):
    if str(step).endswith("pull"):
        print(f"strain {100 * float(strain):.3f} %   force {float(force):.2f} kN")
