"""Statements of paper 1 that its studies found not to hold, by study and name; the pages in docs/ say why.

Each with the beginning of its row in the study's page, which tests compare with what is listed here.
"""

MISSED = {
    "pitch": {"in proportion": "because strain and force of a yarn each go with"},
    "friction": {"more scatter": "a much larger variability in loads with higher friction"},
    "bedding_in": {"first cycle": "most of the residual strain is removed during the first cycle"},
    "sensitivity": {
        "efficiency": "efficiency: 0.699 of the real rope",
        "diameter": "diameter: 19.0 mm of the real rope in tension",
    },
}
