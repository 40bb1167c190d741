"""Sections: area and inertia of the polygon, topology, errors."""

import math

import numpy as np
import pytest

from braidx.meshing import rectangle, round_section

TEMPLATES = [
    {"template": "o-grid", "seeds": 12},
    {"template": "o-grid", "seeds": 8, "rings": 2},
    {"template": "wedge", "seeds": 12},
    {"template": "wedge", "seeds": 10, "rings": 2},
    {"inner_radius": 0.7, "seeds": 12, "rings": 2},
]


def polygon(radius, seeds):
    """Area and inertia of a regular polygon."""
    step = 2.0 * math.pi / seeds
    area = 0.5 * seeds * radius**2 * math.sin(step)
    return area, area * radius**2 * (2.0 + math.cos(step)) / 12.0


@pytest.mark.parametrize("options", TEMPLATES)
def test_degree_1_is_the_polygon(options):
    section = round_section(2.0, **options)
    area, inertia = polygon(2.0, options["seeds"])
    hole = polygon(options.get("inner_radius", 0.0), options["seeds"])
    measured = section.moments()
    assert measured == pytest.approx((area - hole[0], *2 * (inertia - hole[1],)), rel=1e-12)
    assert section.weights().sum() == pytest.approx(measured[0], rel=1e-12)
    assert section.weights() @ section.points == pytest.approx([0.0, 0.0], abs=1e-12)
    assert len(section.outer) == options["seeds"]
    assert len(section.inner) == (options["seeds"] if "inner_radius" in options else 0)


@pytest.mark.parametrize("options", TEMPLATES)
def test_degree_2_is_nearly_the_circle(options):
    section = round_section(2.0, degree=2, **options)
    inner = options.get("inner_radius", 0.0)
    area, first, second = section.moments()
    assert area == pytest.approx(math.pi * (2.0**2 - inner**2), rel=1e-3)
    assert first == pytest.approx(math.pi * (2.0**4 - inner**4) / 4.0, rel=2e-3)
    assert second == pytest.approx(first, rel=1e-9 if options["seeds"] % 4 == 0 else 1e-3)
    assert np.all(section.weights() > 0.0)


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("options", TEMPLATES)
def test_area_scaled_to_that_of_the_circle(options, degree):
    section = round_section(2.0, degree=degree, equal_area=True, **options)
    inner = options.get("inner_radius", 0.0)
    assert section.moments()[0] == pytest.approx(math.pi * (4.0 - inner**2), rel=1e-12)


def test_numbers_of_paper_2():
    """Twelve seeds round the circumference: 9 quadrilaterals in the core and 12 around it."""
    section = round_section(1.0, 12)
    assert section.quads.shape == (21, 4) and len(section.points) == 28
    wedge = round_section(1.0, 12, template="wedge")
    assert wedge.quads.shape == (6, 4) and len(wedge.points) == 13


def test_rectangle_as_a_section_of_a_beam():
    beam = rectangle(2.0, 3.0, (2, 3), degree=2).beam_section(torsion_constant=1.5)
    assert beam.area == pytest.approx(6.0) and beam.shear_area == pytest.approx(6.0)
    assert beam.inertia_1 == pytest.approx(3.0 * 2.0**3 / 12.0)
    assert beam.inertia_2 == pytest.approx(2.0 * 3.0**3 / 12.0)
    assert beam.torsion_constant == 1.5
    assert rectangle(2.0, 3.0).beam_section().torsion_constant == pytest.approx(6.5)


@pytest.mark.parametrize(
    "options, message",
    [
        ({"radius": 0.0}, "radius is 0.0 mm: it must be positive"),
        ({"seeds": 10}, "seeds is 10: an o-grid takes a multiple of 4"),
        (
            {"seeds": 4, "template": "wedge"},
            "seeds is 4: a wedge takes a multiple of 2, at least 6",
        ),
        ({"seeds": 2, "inner_radius": 0.5}, "seeds is 2: a ring"),
        ({"inner_radius": 1.5}, "inner_radius is 1.5 mm"),
        ({"rings": 0}, "rings is 0"),
        ({"template": "fan"}, 'template is "fan": give "o-grid" or "wedge"'),
        ({"degree": 3}, "degree is 3: give 1 or 2"),
    ],
)
def test_errors(options, message):
    with pytest.raises(ValueError, match=message):
        round_section(**{"radius": 1.0, **options})
