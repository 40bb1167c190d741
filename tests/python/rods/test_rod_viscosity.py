"""Viscosity helps to find equilibria, and lets go of them."""

import numpy as np
import pytest

from braidx.rods import Beam, NotConverged, Rods, YarnMaterial, straight
from braidx.rods import equilibria

SOFT = YarnMaterial.isotropic(1000.0, 0.3)


def cantilever(viscosity):
    rods = Rods([Beam(straight((0, 0, 0), (20, 0, 0), 8), 1.0, SOFT)], viscosity=viscosity)
    rods.clamp(0, 0)
    rods.force(0, -1, (0.0, 0.0, 1.0))
    return rods


def test_an_equilibrium_is_the_one_without_viscosity():
    """Viscosity of ten times the stiffness of the tip would let it go a small part of its way."""
    free, held = cantilever(0.0), cantilever(5.0)
    free.solve(2)
    held.solve(2)
    tip = free.positions(0)[-1, 2]
    assert held.positions(0)[-1, 2] == pytest.approx(tip, rel=1e-5) and tip > 1.0
    assert np.abs(held.residual()).max() < 1e-4
    assert np.all(held.proximal.viscosity[:3] == 5.0)  # of the next one, too


def test_what_viscosity_does_not_let_go_of_is_no_equilibrium(monkeypatch):
    monkeypatch.setattr(equilibria, "LETTING_GO", 1.0)
    rods = cantilever(5.0)
    with pytest.raises(NotConverged, match="viscosity holds"):
        rods.solve(1, max_cuts=0)
    assert np.all(rods.proximal.viscosity[:3] == 5.0)
