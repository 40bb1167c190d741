"""The recipe of a rope: what is braided out of what."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from braidx.scene.errors import SceneError
from braidx.scene.fields import Table, option

Motif = tuple[tuple[int, ...], ...]


@dataclass(frozen=True)
class RopeRecipe(Table):
    """The whole rope; its axis is z and its sample is a whole number of pitches long."""

    table: ClassVar[str] = "rope"

    # left out only until the scene is made, which takes it from the angle of the braid
    pitch: float = option(
        None,
        unit="mm",
        above=0.0,
        doc="Length along the axis in which a strand turns once around it; left out: that of braid.angle or "
        "braid.angle_from_axis.",
    )
    pitches: int = option(2, minimum=1, doc="Length of the sample in pitches.")
    type: str = option(
        "braid",
        choices=("braid", "strand"),
        doc="A braid of strands, or one straight strand of twisted (or parallel) yarns.",
    )
    name: str = option(
        "",
        pattern=r"(?!\.{1,2}$)[^/\n\t]{0,200}",
        example='text of at most 200 characters, without "/"',
        doc="Name of the scene, and of the folder of its results; empty: the name of its file.",
    )


@dataclass(frozen=True)
class BraidRecipe(Table):
    """How strands are braided: the double helices of paper 1, 3.4.1, and the motif of 3.4.2."""

    table: ClassVar[str] = "braid"

    helix_radius: float = option(
        unit="mm", above=0.0, doc="Radius of the helices of the strands' centre lines at the start."
    )
    strands_per_direction: tuple[int, ...] = option(
        (6, 6),
        minimum=1,
        shortest=2,
        doc="Strands of layer 0 (right-handed helices) and of layer 1 (left-handed).",
    )
    motif: str | Motif = option(
        "2-over-2-under",
        choices=(-1, 1),
        pattern=r"[1-9][0-9]?-over-[1-9][0-9]?-under",
        example='"2-over-2-under" or a matrix of 1 and -1',
        shortest=1,
        doc="Stacking order: row i, column j is 1 where strand i of layer 0 passes outside strand "
        'j of layer 1, repeated in both directions; "k-over-l-under" has a shift of 1, so that '
        "its ribs run along the axis.",
    )
    angle: float | None = option(
        None,
        unit="degrees",
        above=0.0,
        below=90.0,
        doc="Braiding angle measured from the plane across the axis, as paper 2 does: the pitch is then 2 pi "
        "helix_radius tan(angle). Left out: rope.pitch or angle_from_axis is given.",
    )
    angle_from_axis: float | None = option(
        None,
        unit="degrees",
        above=0.0,
        below=90.0,
        doc="The same angle measured from the axis, 90 degrees less angle.",
    )
    undulation: float = option(
        0.0,
        unit="mm",
        minimum=0.0,
        doc="Amplitude of the strands' way out and in: at the start a strand lies so far outside helix_radius where "
        "it passes over another, and so far inside where it passes under; a sine for 1-over-1-under (paper 2).",
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.angle is not None and self.angle_from_axis is not None:
            cure = f"braid.angle = {self.angle:g} says it already; leave one of the two out."
            raise SceneError("braid.angle_from_axis", cure, self.angle_from_axis)
        if self.undulation >= self.helix_radius:
            cure = f"must be below braid.helix_radius = {self.helix_radius:g} mm."
            raise SceneError("braid.undulation", cure, self.undulation)
        if len(self.strands_per_direction) != 2:
            raise SceneError(
                "braid.strands_per_direction",
                "give two numbers, one per direction, such as [6, 6].",
                self.strands_per_direction,
            )


@dataclass(frozen=True)
class StrandRecipe(Table):
    """How yarns are twisted into a strand."""

    table: ClassVar[str] = "strand"

    rings: tuple[int, ...] = option(
        (1,),
        minimum=1,
        shortest=1,
        doc="Yarns per ring from the inside out: [1, 6] is one central yarn and six around it, "
        "[3] three around an empty centre.",
    )
    yarn_pitch: float | str = option(
        "untwisted",
        unit="mm",
        above=0.0,
        choices=("untwisted",),
        pattern=r"pitch/[1-9][0-9]{0,5}",
        example='a number, "pitch/4" (a fraction of rope.pitch) or "untwisted"',
        doc="Length along the axis in which a yarn turns once around its strand; it divides "
        "rope.pitch.",
        needs="several yarns",
    )
    helix_radius: float | str = option(
        "touching",
        unit="mm",
        above=0.0,
        choices=("touching",),
        doc='Radius of the first ring around the strand\'s centre line; "touching": the smallest '
        "without overlap. Each further ring lies one yarn diameter further out.",
        needs="several yarns",
    )
    lay: str = option(
        "opposite",
        choices=("opposite", "same", "S", "Z"),
        doc="Sense of the yarns' helices: opposite to or the same as the helix of their strand, or "
        "all left-handed (S) or all right-handed (Z).",
        needs="twist",
    )
