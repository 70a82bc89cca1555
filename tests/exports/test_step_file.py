"""STEP files as ifcopenshell reads them, which has no part in their text beyond the names of fields."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import ifcopenshell
import numpy as np
import pytest

from solver.exports.step_file import StepFile, value_of

TEXTS = ["plain", "it's a back\\slash", "Küche, 12 m²", "東の部屋 😀\n\ttabbed", "", "\\X2\\00FC\\X0\\"]
REALS = [0.0, -0.0, 1.0, -2.5, 0.1 + 0.2, 1e-05, 7e-4, 1e16, 123456789.125, 5e-324, 1e22]


def test_what_is_written_is_read_back() -> None:
    file = StepFile("IFC4")
    for text in TEXTS:
        file.new("IfcPropertySingleValue", Name=text, NominalValue=value_of("IfcLabel", text))
    for real in REALS:
        file.new("IfcPropertySingleValue", Name="real", NominalValue=value_of("IfcReal", real))
    point = file.new("IfcCartesianPoint", Coordinates=(1.5, 2.0))
    file.new("IfcPolyline", Points=[point, file.new("IfcCartesianPoint", Coordinates=[3.0, 4.0])])
    file.new("IfcSIUnit", UnitType="MASSUNIT", Prefix="KILO", Name="GRAM")
    read = ifcopenshell.file.from_string(file.text("a 'file'.ifc", "DesignTransferView", "1980-01-01T00:00:00"))
    said = [one.NominalValue.wrappedValue for one in read.by_type("IfcPropertySingleValue")]
    assert said == [*TEXTS, *REALS]
    assert [one.Name for one in read.by_type("IfcPropertySingleValue")][: len(TEXTS)] == TEXTS
    (line,) = read.by_type("IfcPolyline")
    assert [one.Coordinates for one in line.Points] == [(1.5, 2.0), (3.0, 4.0)]
    (unit,) = read.by_type("IfcSIUnit")
    assert (unit.UnitType, unit.Prefix, unit.Name) == ("MASSUNIT", "KILO", "GRAM")
    assert read.header.file_name.name == "a 'file'.ifc"
    assert read.schema == "IFC4"


@pytest.mark.parametrize("number", [int, float, np.float32, np.int64], ids=lambda one: one.__name__)
def test_reals_are_written_as_reals_whatever_they_come_as(number: Callable[[int], Any]) -> None:
    file = StepFile("IFC4")
    file.new("IfcDoor", OverallHeight=number(2), OverallWidth=number(1))
    file.new("IfcCartesianPoint", Coordinates=(number(2) + 0.0, 0.5))
    assert "((2.,0.5))" in file.text("a.ifc", "DesignTransferView", "")
    assert ",2.,1.," in file.text("a.ifc", "DesignTransferView", "")


def test_a_field_that_an_entity_has_not_is_refused() -> None:
    with pytest.raises(ValueError, match="IfcDirection has no Coordinates"):
        StepFile("IFC4").new("IfcDirection", Coordinates=(1.0, 0.0))
