"""How large a rope may be: one that no machine holds is refused before any of it is made."""

from __future__ import annotations


from braidx.scene.errors import SceneError
from braidx.scene.tables import SceneTables

# A node has 3 unknowns at least, and a row of the tangent some 80 numbers: 10^7 nodes take 20 GB, not yet factored.
MOST_NODES = 10_000_000
MOST_CROSSINGS = 10_000_000  # of yarns; what lies near them takes the memory of several nodes each


def num_nodes(scene: SceneTables) -> int:
    """Nodes of all yarns as curves."""
    strands = 1 if scene.braid is None else sum(scene.braid.strands_per_direction)
    per_yarn = scene.rope.pitches * scene.yarn.elements_per_pitch * scene.yarn.degree + 1
    return strands * sum(scene.strand.rings) * per_yarn


def num_crossings(scene: SceneTables) -> int:
    """Crossings of a yarn with a yarn: two strands of either direction meet twice in a pitch."""
    if scene.braid is None:
        return 0
    first, second = scene.braid.strands_per_direction
    return 2 * scene.rope.pitches * first * second * sum(scene.strand.rings) ** 2


def _core_layers(scene: SceneTables) -> float:
    """Layers of nodes of a core that says how long its elements are."""
    own = scene.core.element_length if scene.core is not None else None
    return 0.0 if own is None else scene.length / own


def check_size(scene: SceneTables) -> None:
    """Raises SceneError for a rope that is too large for any machine."""
    nodes, crossings = max(num_nodes(scene), _core_layers(scene)), num_crossings(scene)
    if nodes > MOST_NODES:
        what, cure = f"{nodes:.3g} nodes", "rope.pitches, elements or yarns"
    elif crossings > MOST_CROSSINGS:
        what, cure = f"{crossings:.3g} crossings of yarns", "rope.pitches or yarns"
    else:
        return
    raise SceneError("rope", f"too large to be computed: {what}; use fewer {cure}.")
