"""Two hundred random ropes, the same in every run: scenes as dictionaries, as TOML files would hold them."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st
from hypothesis.strategies import DrawFn, SearchStrategy

Recipe = dict[str, Any]
NUMBER = 200
STRANDS = {  # per direction, with which motifs close
    "1-over-1-under": (2, 4, 6),
    "2-over-2-under": (4,),
    "2-over-1-under": (3, 6),
}
ELEMENTS = 3.0  # from crossing to crossing, at least


def between(low: float, high: float) -> SearchStrategy[float]:
    """Numbers spread evenly over the logarithm where their range is wide, in hundredths of it."""
    wide = low > 0.0 and high > 5.0 * low

    def at(hundredths: int) -> float:
        share = hundredths / 100.0
        number = low * (high / low) ** share if wide else low + share * (high - low)
        return float(f"{number:.4g}")

    return st.integers(0, 100).map(at)


@st.composite
def yarns(draw: DrawFn, models: tuple[str, ...]) -> Recipe:
    """One kind of yarn, thin or thick, soft or stiff."""
    radius, modulus = draw(between(0.2, 3.0)), draw(between(2e3, 150e3))
    yarn = {
        "radius": radius,
        "axial_stiffness": float(f"{modulus * math.pi * radius**2:.4g}"),
        "model": draw(st.sampled_from(models)),
    }
    if yarn["model"] == "beam":
        yarn["bundle_factor"] = draw(between(1e-3, 0.1))
    return yarn


@st.composite
def programmes(draw: DrawFn, reference: float) -> list[Recipe]:
    """What is done to a rope at rest.

    Args:
        reference: Force at which its yarns are strained by about a percent, kN.
    """
    kind = draw(st.sampled_from(["strain", "force", "cycle"]))
    step = draw(between(0.001, 0.002))
    if kind == "strain":
        return [
            {"kind": "pull", "to_strain": draw(between(0.001, 0.008)), "strain_increment": step}
        ]
    high = float(f"{reference * draw(between(0.1, 0.6)):.4g}")
    if kind == "force":
        return [{"kind": "pull", "to_force": high, "strain_increment": step}]
    low = float(f"{high * draw(between(0.1, 0.5)):.4g}")
    return [{"kind": "cycle", "force_max": high, "force_min": low, "strain_increment": step}]


@st.composite
def strands(draw: DrawFn) -> Recipe:
    """Twisted yarns without a braid, from nearly parallel to strongly twisted."""
    rings = draw(st.sampled_from([[2], [3], [4], [1, 5], [1, 6]]))
    yarn = draw(yarns(("cable", "beam")))
    around = (
        2.0 * yarn["radius"] if rings[0] == 1 else yarn["radius"] / math.sin(math.pi / rings[0])
    )
    angle = draw(between(3.0, 28.0))
    pitch = 2.0 * math.pi * around / math.tan(math.radians(angle))
    yarn["elements_per_pitch"] = draw(st.integers(16, 36))
    count, strength = sum(rings), 0.01 * yarn["axial_stiffness"] / 1e3
    ends = draw(st.sampled_from(["periodic", "fixed"]))
    pitches = draw(st.integers(1, 2)) if ends == "periodic" or yarn["model"] == "cable" else 1
    return {
        "rope": {"type": "strand", "pitch": float(f"{pitch:.5g}"), "pitches": pitches},
        "strand": {
            "rings": rings,
            "yarn_pitch": "pitch/1",
            "lay": draw(st.sampled_from(["S", "Z"])),
        },
        "yarn": yarn,
        "contact": {"friction": draw(between(0.0, 0.6))},
        "ends": {"transverse": ends},
        "steps": [
            {"kind": "settle", "force": float(f"{0.02 * count * strength:.3g}")},
            *draw(programmes(count * strength)),
        ],
    }


@st.composite
def braids(draw: DrawFn, cored: bool = False) -> Recipe:
    """Braids of single yarns or of small strands, from open to jammed, with a rigid core or none."""
    motif = draw(st.sampled_from(sorted(STRANDS)))
    per_direction = draw(st.sampled_from(STRANDS[motif]))
    rings = [draw(st.sampled_from([1, 1, 2, 3]))] if per_direction < 4 else [1]
    yarn = draw(yarns(("cable", "beam") if rings == [1] else ("cable",)))
    radius, angle = yarn["radius"], draw(between(10.0, 42.0))
    width = 2.0 * radius * (1.0 + (1.0 / math.sin(math.pi / rings[0]) if rings[0] > 1 else 0.0))
    filled = draw(between(0.4, 1.02))  # of the circumference; more is refused
    around = per_direction * width / (2.0 * math.pi * math.cos(math.radians(angle)) * filled)
    around = max(around, width)
    yarn["elements_per_pitch"] = max(
        16, math.ceil(draw(between(1.0, 1.3)) * ELEMENTS * 2 * per_direction)
    )
    count = 2 * per_direction * rings[0]
    strength = 0.01 * count * yarn["axial_stiffness"] / 1e3 * math.cos(math.radians(angle)) ** 3
    ends = draw(st.sampled_from(["periodic", "periodic", "fixed"]))
    recipe: Recipe = {
        "rope": {"pitches": draw(st.integers(1, 2)) if ends == "periodic" else 1},
        "braid": {
            "strands_per_direction": [per_direction, per_direction],
            "motif": motif,
            "helix_radius": float(f"{around:.4g}"),
            "angle_from_axis": angle,
        },
        "strand": {"rings": rings},
        "yarn": yarn,
        "contact": {"friction": draw(between(0.0, 0.6))},
        "ends": {"transverse": ends},
        "steps": [
            {"kind": "form", "tension": float(f"{yarn['axial_stiffness'] * 1e-4:.3g}")},
            {"kind": "settle", "force": float(f"{0.02 * strength:.3g}")},
            *draw(programmes(0.5 * strength)),
        ],
    }
    if rings[0] > 1 and draw(st.booleans()):
        recipe["strand"]["yarn_pitch"] = f"pitch/{draw(st.integers(1, 3))}"
    if cored:
        recipe["core"] = {
            "model": "rigid",
            "radius": float(f"{draw(between(0.5, 1.05)) * max(around - width, 0.3 * around):.4g}"),
        }
    return recipe


@st.composite
def bent(draw: DrawFn) -> Recipe:
    """Four yarns about a core, bent over a sheave, and some straightened again."""
    per_direction, radius = 2, draw(between(0.5, 0.9))
    angle = draw(between(50.0, 70.0))
    around = per_direction * 2.0 * radius * draw(between(1.2, 1.6)) / (2.0 * math.pi)
    around = max(around / math.sin(math.radians(angle)), 2.6 * radius)
    core = 0.8 * (around - 1.7 * radius)
    pitch = 2.0 * math.pi * around * math.tan(math.radians(angle))
    stiffness = float(f"{draw(between(5e3, 40e3)) * math.pi * radius**2:.4g}")
    model = draw(st.sampled_from(["beam", "cable"]))
    bend = {"kind": "bend", "travel": float(f"{0.1 * pitch:.4g}"), "increments": 4}
    if model == "cable":  # has no shape without
        bend["pretension"] = float(f"{4e-6 * per_direction * stiffness:.3g}")
    return {
        "rope": {"pitches": 2},
        "braid": {
            "strands_per_direction": [per_direction, per_direction],
            "motif": "1-over-1-under",
            "helix_radius": float(f"{around:.4g}"),
            "angle": angle,
            "undulation": float(f"{0.8 * radius:.4g}"),
        },
        "core": {"model": "beam", "radius": float(f"{core:.4g}"), "modulus": 200.0},
        "sheave": {"diameter": float(f"{draw(between(6.0, 20.0)) * around:.4g}")},
        "yarn": {
            "radius": radius,
            "model": model,
            "axial_stiffness": stiffness,
            "material": "filaments",
            "elements_per_pitch": 8 * per_direction,
        },
        "material": {
            "filaments": {
                "transverse_modulus": 1000.0,
                "shear_modulus": 500.0,
                "bundle_factor": draw(between(0.1, 1.0)),
            }
        },
        "contact": {"friction": draw(between(0.0, 0.5))},
        "steps": [
            {"kind": "form", "tension": 10.0},
            bend,
            *draw(st.sampled_from([[], [{"kind": "straighten", "increments": 3}]])),
        ],
    }


def small_braid(model: str, factor: float, *steps: Recipe, **form: float) -> Recipe:
    """The rope of demos/small_rope.toml with 24 elements, formed and brought to rest, and what is done to it then.

    Args:
        model, factor: Of yarns; the factor on their bending.
        steps: After they have come to rest.
        form: Options of forming.
    """
    return {
        "rope": {"pitch": 36.0, "pitches": 1},
        "braid": {
            "strands_per_direction": [4, 4],
            "motif": "1-over-1-under",
            "helix_radius": 2.0,
        },
        "yarn": {
            "radius": 0.86,
            "axial_stiffness": 162e3,
            "model": model,
            "material": "filaments",
            "elements_per_pitch": 24,
        },
        "material": {"filaments": {"bundle_factor": factor}},
        "contact": {"friction": 0.1},
        "solver": {"max_cuts": 4},
        "steps": [{"kind": "form", "tension": 20.0, **form}, {"kind": "settle"}, *steps],
    }


KINDS = {
    "strand": strands(),
    "braid": braids(),
    "braid about a core": braids(cored=True),
    "bent over a sheave": bent(),
}
SHARES = (
    *("strand", "braid") * 6,
    *("braid",) * 4,
    *("braid about a core",) * 3,
    "bent over a sheave",
)


def drawn(strategy: SearchStrategy[Recipe], number: int) -> Recipe:
    """The recipe of a number, always the same."""
    found: list[Recipe] = []

    @seed(number)
    @settings(
        max_examples=2,  # the first is the simplest one; of more, the later ones are like the earlier ones
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(strategy)
    def draw(recipe: Recipe) -> None:
        found.append(recipe)

    draw()
    return found[-1]


@cache
def recipes() -> tuple[tuple[str, Recipe], ...]:
    """All of them with their kinds, in shares that do not depend on chance."""
    kinds = [SHARES[number % len(SHARES)] for number in range(NUMBER)]
    # Of what fails, a sixteenth of an increment says as much as less of it.
    patience = {"solver": {"max_cuts": 4}}
    return tuple(
        (kind, {**drawn(KINDS[kind], number), **patience}) for number, kind in enumerate(kinds)
    )
