"""A contact history in a checkpoint that does not fit: said in one line, with the cure."""

from dataclasses import replace

import numpy as np
import pytest

from braidx.processes.state import State, restore_contacts
from braidx.rods import Beam, Rods, YarnMaterial, straight
from braidx.scene import SceneError

MATERIAL = YarnMaterial.isotropic(1e3, 0.3)


def touching():
    lines = straight((0, 0, 0), (12, 0, 0), 4), straight((6, -5, 1.9), (6, 7, 1.9), 4)
    rods = Rods([Beam(line, 1.0, MATERIAL) for line in lines])
    rods.contact.update(rods.q)
    return rods.contact, rods.contact.arrays()


@pytest.mark.parametrize(
    ("broken", "why"),
    [
        (lambda arrays: arrays | {"tubes": arrays["tubes"] + 5}, "between surfaces 5 and 6"),
        (lambda arrays: arrays | {"xi": arrays["xi"][:, :2]}, "xi is an array of shape"),
        (lambda arrays: arrays | {"normal": arrays["normal"][1:]}, "boolean index did not match"),
        (lambda arrays: {k: v for k, v in arrays.items() if k != "slip"}, "slip is missing"),
        (lambda arrays: {k: v for k, v in arrays.items() if k != "tubes"}, "tubes"),
    ],
)
def test_a_contact_history_that_does_not_fit_is_refused(broken, why):
    contact, arrays = touching()
    assert len(arrays["weight"])
    with pytest.raises(SceneError, match=rf"--resume.*contact history .*{why}.*another --out"):
        restore_contacts(contact, state_of(broken(arrays)))
    restore_contacts(contact, state_of(arrays))
    assert len(contact.elements) == len(arrays["weight"])


def state_of(contacts):
    nothing = np.empty(0)
    return replace(
        State(model="beam", q=nothing, reference=nothing, rest_tension=nothing), contacts=contacts
    )
