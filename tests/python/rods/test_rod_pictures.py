"""Pictures of a scene of rods."""

import numpy as np
import pytest
from matplotlib.image import imread

from braidx.rods import Cable, Rods, straight
from braidx.rods.picture import draw_rods


def test_rods_are_seen_true_to_scale(tmp_path):
    """A rod of 20 by 2 mm seen from the side covers ten times as many columns as rows."""
    path = draw_rods(
        [straight((0, 0, 0), (0, 20, 0), 4)], [1.0], tmp_path / "a.png", towards=(1, 0, 0)
    )
    red, _, blue = np.moveaxis(imread(path)[..., :3], -1, 0)
    rows, columns = np.nonzero(blue - red > 0.1)
    assert np.ptp(columns) / np.ptp(rows) == pytest.approx(10.0, rel=0.05)


def test_colours_by_tension(tmp_path):
    rods = Rods([Cable(straight((0, y, 0), (9, y, 0), 6), 0.5, 1e3, tension=1 + y) for y in (0, 3)])
    path = rods.draw(tmp_path / "b.png", by_tension=True)
    assert path.stat().st_size > 5000


def test_a_rod_seen_from_its_end_is_a_disc(tmp_path):
    """The direction upwards may be that to the eye: then any other is upwards."""
    line = straight((0, 0, 0), (0, 0, 9), 2)
    path = draw_rods([line], [1.0], tmp_path / "c.png", towards=(0, 0, 1))
    red, _, blue = np.moveaxis(imread(path)[..., :3], -1, 0)
    rows, columns = np.nonzero(blue - red > 0.1)
    assert np.ptp(columns) == pytest.approx(np.ptp(rows), rel=0.02)
    assert len(rows) == pytest.approx(np.pi / 4 * np.ptp(rows) * np.ptp(columns), rel=0.03)
    with pytest.raises(ValueError, match="no direction"):
        draw_rods([line], [1.0], tmp_path / "d.png", towards=(0, 0, 0))
