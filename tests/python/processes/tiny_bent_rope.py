"""The smallest braid that bends: four yarns about a thin core, a pitch of 17 mm, over a sheave of 20 mm."""

TINY = """
[rope]
pitches = 2
[braid]
strands_per_direction = [2, 2]
motif = "1-over-1-under"
helix_radius = 1.6
angle = 60.0
undulation = 0.6
[core]
radius = 0.4
model = "beam"
[sheave]
diameter = 20.0
[yarn]
radius = 0.6
model = "beam"
axial_stiffness = 22.6e3
transverse_modulus = 1000.0
shear_modulus = 500.0
bundle_factor = 1.0
elements_per_pitch = 16
[contact]
friction = 0.2
[heat]
frequency = 0.5
cycles = 200
[[steps]]
kind = "form"
tension = 10.0
[[steps]]
kind = "bend"
travel = 1.0
increments = 2
[[steps]]
kind = "bend_cycles"
increments = 1
"""
