"""One list of words: the catalogs' schema, the registry and the modules name the same relations."""

from __future__ import annotations

from typing import get_args

import pytest

from catalogs.checks import BETWEEN, TO_SOMETHING
from catalogs.relation_keys import EVERY, KEYS
from catalogs.schema import RelationSpec, RelationWord
from solver.geometry import Rect
from solver.pieces import Opened
from solver.relations import RELATIONS, Relation
from solver.relations.relation import Fit
from solver.relations.subject import Footing, Scope

CLEAR = Rect(0, 0, 5000, 4000)
SCOPE = Scope(CLEAR, (Opened("door", "south", (1000, 1900), 4000), Opened("window", "north", (2000, 3400), 0)))


def test_the_vocabulary_is_whole() -> None:
    assert tuple(RELATIONS) == get_args(RelationWord)
    assert KEYS.keys() == {*RELATIONS}
    assert {key for keys in (EVERY, *KEYS.values()) for key in keys} == RelationSpec.model_fields.keys()


@pytest.mark.parametrize("word", RELATIONS)
def test_each_relation_has_a_file_of_its_own(word: str) -> None:
    assert type(RELATIONS[word]).__module__ == f"solver.relations.{word}"
    assert [other for other in RELATIONS if type(RELATIONS[other]) is type(RELATIONS[word])] == [word]


@pytest.mark.parametrize("word", RELATIONS)
def test_each_relation_says_where_it_holds_as_the_catalogs_let_it_be_used(word: str) -> None:
    """What takes an `of` has boxes, or, as `on`, slots; what does not, or may name an opening, has regions."""
    relation = RELATIONS[word]
    spec = RelationSpec.model_validate({"type": word, "of": ["door"]})
    footing = Footing(180, "south", (600, 400), Rect(0, 3570, 5000, 3970))
    regions = relation.regions(SCOPE, spec, footing)
    boxes = [box for turn in (0, 90, 180, 270) for box in relation.boxes(Fit(spec, (1600, 800), (600, 400), turn))]
    if word in BETWEEN + TO_SOMETHING:
        assert bool(boxes) == (word != "on")
    overridden = type(relation).regions is not Relation.regions
    assert overridden == (word not in BETWEEN)
    assert all(rect.x0 <= rect.x1 and rect.z0 <= rect.z1 for rect in regions)
