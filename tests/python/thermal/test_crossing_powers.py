"""From the work of friction at crossings to the temperature of the rope, and its picture."""

from __future__ import annotations

import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread
from mpi4py import MPI

sys.path.append(str(Path(__file__).resolve().parents[1] / "output"))

from bent_example import LAYER, bent_rope, straight_lines  # noqa: E402

from braidx.output.figures import style  # noqa: E402
from braidx.output.figures.temperature import draw_temperature, write_temperature  # noqa: E402
from braidx.output.interlacing import relative_displacement, work_per_crossing  # noqa: E402
from braidx.thermal import RopeHeat, ThermalMaterial, crossing_powers, spread  # noqa: E402


def test_the_rope_is_warmest_at_the_crown(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(style, "DPI", 40)
    lines, bent = straight_lines(), bent_rope()
    length = float(lines[0][-1, 2])
    result = relative_displacement(lines, bent.centre_lines, bent.radius, LAYER)
    assert bent.contacts is not None
    powers = crossing_powers(work_per_crossing(result, bent.contacts), frequency=0.5)
    radial, axial = np.linspace(0.0, 6.0, 7), np.linspace(0.0, length, 41)
    density = spread(radial, axial, result.reference.position, powers, reach=1.0)
    material = ThermalMaterial(10.0, 0.3, 700.0, 1800.0, 25.0)
    model = RopeHeat(MPI.COMM_WORLD, radial, axial, material)
    model.set_source(density)
    assert model.power.sum() == pytest.approx(powers.sum(), rel=1e-12)
    history = model.run(1200.0, 40)
    r, z = model.nodes
    hottest = np.unravel_index(np.argmax(history.field), history.field.shape)
    assert abs(z[hottest[1]] - 0.5 * length) < 2.5
    path = draw_temperature(
        r, z, history.field, tmp_path / "t.png", history.time, history.maximum, 0.5 * length
    )
    assert imread(path)[..., :3].std() > 0.02
    write_temperature(r, z, history.field, tmp_path / "t.vtp")
    piece = xml.parse(tmp_path / "t.vtp").getroot()[0][0]
    assert piece.get("NumberOfPoints") == str(13 * 81) and piece.get("NumberOfPolys") == "960"
