"""Elastic energy of yarns of degree 1 in NumPy, from the formulas of docs/theory.md and no code of the library."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from braidx.scene import Scene

Floats = npt.NDArray[np.float64]
TILT = 0.1  # share of the shear of a beam that is taken at its nodes


@dataclass(frozen=True)
class Yarns:
    """All yarns of a sample, equal in number of nodes.

    Attributes:
        scene: Gives stiffnesses and radius.
        rest: Unknowns where strains are measured from, shape (num_yarns, num_nodes, 3 or 9), mm.
        tension: In that state, shape (num_yarns, num_nodes - 1), N.
    """

    scene: Scene
    rest: Floats
    tension: Floats

    def energy(self, now: Floats) -> float:
        """Elastic energy, mJ; `now` as `rest`. That of the tension at rest is counted."""
        cables = now.shape[-1] == 3
        return self._energy_of_cables(now) if cables else self._energy_of_beams(now)

    def stretching_work(self, now: Floats, axis: int) -> float:
        """Derivative of the energy with an even stretch along x, y or z of all positions, directors kept, mJ."""
        stretch = np.zeros_like(now)
        stretch[..., axis] = now[..., axis]
        return self.work(now, stretch, 1e-6)

    def work(self, now: Floats, moved: Floats, step: float = 1e-4) -> float:
        """Derivative of the energy along a motion, shape as `now`: what yarns take if their forces stay, mJ.

        Args:
            now, moved: Unknowns and their motion.
            step: Of the central difference, over the motion.
        """
        ends = [self.energy(now + sign * step * moved) for sign in (1.0, -1.0)]
        return (ends[0] - ends[1]) / (2.0 * step)

    def tensions(self, now: Floats) -> Floats:
        """Tension of cables, shape (num_yarns, num_nodes - 1), N."""
        stretch = np.linalg.norm(np.diff(now[..., :3], axis=1), axis=2) / self._lengths
        force = self.tension + self.scene.yarn.axial_stiffness * (stretch - 1.0)
        return np.asarray(np.maximum(force, 0.0))

    @property
    def _lengths(self) -> Floats:
        return np.asarray(np.linalg.norm(np.diff(self.rest[..., :3], axis=1), axis=2))

    def _energy_of_cables(self, now: Floats) -> float:
        work = (self.tensions(now) ** 2 * self._lengths).sum()
        return 0.5 * float(work) / self.scene.yarn.axial_stiffness

    def _energy_of_beams(self, now: Floats) -> float:
        density = self._axial_and_turning(now) + self._of_sections(now)
        stiffness = self.scene.yarn.axial_stiffness
        preload = self.tension**2 / (2.0 * stiffness)
        return float(((density + preload) * self._lengths).sum()) + self._tilting(now)

    def _axial_and_turning(self, now: Floats) -> Floats:
        """Energy per length at the middle of elements."""
        yarn = self.scene.yarn
        inertia, shear = np.pi * yarn.radius**4 / 4.0, yarn.shear_modulus
        modulus, area = yarn.axial_stiffness / yarn.section_area, yarn.section_area
        slope, g, rate = _frames(now, self._lengths)
        slope0, g0, rate0 = _frames(self.rest, self._lengths)
        rate = rate - rate0 @ _moved(slope, g, slope0, g0)
        factor = yarn.bundle_factor
        e33 = self._fibres(slope, slope0, rate)
        shears = np.einsum("yeai,yei->yea", g, slope) - np.einsum("yeai,yei->yea", g0, slope0)
        bends = np.einsum("yeai,yei->yea", rate, slope)
        twists = np.einsum("yeai,yebi->yeab", g, rate)
        density = 0.5 * modulus * area * e33**2 + self.tension * e33
        density += (1.0 - TILT) * 0.5 * area * shear * (shears**2).sum(-1)
        density += 0.5 * factor * modulus * inertia * (bends**2).sum(-1)
        density += 0.5 * factor * shear * inertia * (twists**2).sum((-1, -2))
        return np.asarray(density)

    def _of_sections(self, now: Floats) -> Floats:
        """Energy per length of sections that are strained across, the mean of both ends of elements."""
        yarn = self.scene.yarn
        modulus = yarn.axial_stiffness / yarn.section_area
        nu, transverse = yarn.poisson_transverse, yarn.transverse_modulus
        m = transverse / modulus * yarn.poisson_axial**2
        plane = transverse / ((1.0 + nu) * (1.0 - nu - 2.0 * m))
        c11, c12 = plane * (1.0 - m), plane * (nu + m)
        slope, _, rate = _frames(now, self._lengths)
        slope0, _, rate0 = _frames(self.rest, self._lengths)
        total = np.zeros(slope.shape[:2])
        for end in (slice(None, -1), slice(1, None)):
            g, g0 = (q[:, end, 3:].reshape(*slope.shape[:2], 2, 3) for q in (now, self.rest))
            metric = 0.5 * (g @ g.swapaxes(-1, -2) - g0 @ g0.swapaxes(-1, -2))
            turning = rate - rate0 @ _moved(slope, g, slope0, g0)
            contraction = yarn.poisson_axial * self._fibres(slope, slope0, turning)
            e11, e22 = metric[..., 0, 0] + contraction, metric[..., 1, 1] + contraction
            density = 0.5 * c11 * (e11**2 + e22**2) + c12 * e11 * e22
            total += 0.5 * (density + (c11 - c12) * metric[..., 0, 1] ** 2)
        return np.asarray(yarn.section_area * total)

    def _fibres(self, slope: Floats, slope0: Floats, rate: Floats) -> Floats:
        """Mean strain of fibres, of filaments that slide each by a turn of its own."""
        yarn = self.scene.yarn
        share = 0.5 * yarn.bundle_factor * np.pi * yarn.radius**4 / 4.0 / yarn.section_area
        axis = 0.5 * ((slope**2).sum(-1) - (slope0**2).sum(-1))
        return np.asarray(axis + share * (rate**2).sum((-1, -2)))

    def _tilting(self, now: Floats) -> float:
        """Energy of the shear between sections and the central difference of positions, mJ."""
        yarn, span = self.scene.yarn, self._lengths[:, :-1] + self._lengths[:, 1:]
        tilts = []
        for q in (now, self.rest):
            tangent = (q[:, 2:, :3] - q[:, :-2, :3]) / span[..., None]
            g = q[:, 1:-1, 3:].reshape(*span.shape, 2, 3)
            tilts.append(np.einsum("yeai,yei->yea", g, tangent))
        stiffness = TILT * yarn.shear_modulus * yarn.section_area * span / 2.0
        return 0.5 * float((stiffness * ((tilts[0] - tilts[1]) ** 2).sum(-1)).sum())


def _moved(slope: Floats, g: Floats, slope0: Floats, g0: Floats) -> Floats:
    """Deformation of sections and axis, transposed."""
    now, rest = (
        np.concatenate([directors, axis[..., None, :]], axis=-2)
        for directors, axis in ((g, slope), (g0, slope0))
    )
    return np.asarray(np.linalg.inv(rest) @ now)


def _frames(q: Floats, lengths: Floats) -> tuple[Floats, Floats, Floats]:
    """Slope, directors and their rates at the middle of elements."""
    rate = np.diff(q, axis=1) / lengths[..., None]
    middle = (q[:, 1:, 3:] + q[:, :-1, 3:]) / 2.0
    shape = (*lengths.shape, 2, 3)
    return rate[..., :3], middle.reshape(shape), rate[..., 3:].reshape(shape)
