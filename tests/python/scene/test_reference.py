"""The generated reference: the committed page and the schema follow the dataclasses."""

import dataclasses
import json
from pathlib import Path

from braidx.scene.build import NAMED, TABLES
from braidx.scene.fields import spec_of
from braidx.scene.reference import json_schema, markdown
from braidx.scene.steps import STEPS

PAGE = Path(__file__).parents[3] / "docs" / "scene_reference.md"


def test_the_committed_page_is_the_generated_one():
    assert PAGE.read_text("utf-8") == markdown(), "run: ./braidx schema --markdown > " + str(PAGE)


def test_every_field_has_a_meaning_and_is_in_page_and_schema():
    page, schema = markdown(), json_schema()
    for name, cls in {**TABLES, **NAMED, **STEPS}.items():
        for field in dataclasses.fields(cls):
            assert spec_of(field).doc.endswith("."), (name, field.name)
            assert f"| `{field.name}` |" in page
    for name, cls in TABLES.items():
        properties = schema["properties"][name]["properties"]
        assert list(properties) == [field.name for field in dataclasses.fields(cls)]
    assert len(schema["properties"]["steps"]["items"]["oneOf"]) == len(STEPS)


def test_the_schema_is_json_and_carries_ranges():
    rope = json.loads(json.dumps(json_schema()))["properties"]["rope"]
    assert rope["properties"]["pitch"]["exclusiveMinimum"] == 0.0
    assert "required" not in rope  # the pitch may come from the angle of the braid
    assert rope["properties"]["type"]["enum"] == ["braid", "strand"]
