"""IFC4: a building as BIM programmes take it: storeys, spaces, walls with openings that doors and windows fill, furniture.

Its frame: x east, y north, z up, m. Bodies hang in their spaces; what they are is in the property set `Compose_Body`.
Identities are hashes of the house and the ids, the header's date is fixed: the same scene makes the same bytes.
"""

from collections import defaultdict
from collections.abc import Sequence
from typing import Final

from solver.body_parts import BodyPart
from solver.exports.door_leaves import shut_parts
from solver.exports.ifc_pieces import IfcPieces, printable
from solver.exports.model import Cuboid, DoorLeaf, FloorPlate, HouseModel, ModelBody, Paint, PlacedOpening, WallPanel
from solver.exports.paints import PLAIN_WALL, SURFACES
from solver.exports.plan_rooms import clear_corners, name_of, said_of_room, words_of
from solver.exports.step_file import Entity, StepFile
from solver.exports.writers import ExportSettings, Files
from solver.geometry import doubled_area

DATE: Final = "1980-01-01T00:00:00"
SLAB: Final = 0.1
"""How thick floors are written, m; scenes do not say."""
_UNITS: Final = (("LENGTHUNIT", None, "METRE"), ("AREAUNIT", None, "SQUARE_METRE"), ("VOLUMEUNIT", None, "CUBIC_METRE"),
                 ("PLANEANGLEUNIT", None, "RADIAN"), ("MASSUNIT", "KILO", "GRAM"))  # fmt: skip


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes `<house>.ifc`."""
    file = StepFile("IFC4")
    _Building(file, model).make()
    name = f"{model.name}.ifc"
    return {name: file.text(name, "DesignTransferView", DATE).encode()}


class _Building:
    """Writes one house into a file."""

    def __init__(self, file: StepFile, model: HouseModel) -> None:
        self.model = model
        self.make_one = IfcPieces(file, model.name)
        self.storeys: dict[int, Entity] = {}
        self.spaces: dict[str, Entity] = {}
        self.rooms = {room.id: room for room in model.rooms}
        self.held: dict[Entity, list[Entity]] = defaultdict(list)
        self.shapes: dict[object, tuple[Entity, Entity]] = {}
        self.of_type: dict[Entity, list[Entity]] = defaultdict(list)

    def make(self) -> None:
        """Writes everything."""
        self._frame()
        for room in self.model.rooms:
            self._space(room)
        self._aggregated("spaces", [(self.storeys[room.level], self.spaces[room.id]) for room in self.model.rooms])
        openings = self._walls()
        leaves = self.model.leaves_by_opening
        for opening in self.model.openings:
            self._filling(opening, leaves.get(opening.id, []), openings.get(opening.id))
        self._railings()
        for body in self.model.bodies:
            self._furniture(body)
        one = self.make_one
        for number, (kind, bodies) in enumerate(self.of_type.items()):
            one.rooted("IfcRelDefinesByType", "type of", str(number), RelatedObjects=bodies, RelatingType=kind)
        for number, (place, held) in enumerate(self.held.items()):
            one.rooted("IfcRelContainedInSpatialStructure", "held", str(number), RelatedElements=held, RelatingStructure=place)

    def _frame(self) -> None:
        """Writes project, site, building and storeys."""
        one, name = self.make_one, printable(words_of(self.model.name))
        units = [one.new("IfcSIUnit", UnitType=kind, Prefix=prefix, Name=unit) for kind, prefix, unit in _UNITS]
        context = one.new("IfcUnitAssignment", Units=units)
        project = one.rooted("IfcProject", "project", "", Name=name, RepresentationContexts=[one.model], UnitsInContext=context)
        site = one.rooted("IfcSite", "site", "", Name="Site", ObjectPlacement=one.placed(None, (0.0, 0.0, 0.0)), CompositionType="ELEMENT")
        at = one.placed(site.ObjectPlacement, (0.0, 0.0, 0.0))
        building = one.rooted("IfcBuilding", "building", "", Name=name, ObjectPlacement=at, CompositionType="ELEMENT")
        heights = {room.level: room.elevation for room in self.model.rooms} or {0: 0.0}
        for level in sorted(heights):
            placed = one.placed(at, (0.0, 0.0, heights[level]))
            said = {"Name": f"Storey {level}", "ObjectPlacement": placed, "CompositionType": "ELEMENT", "Elevation": float(heights[level])}
            self.storeys[level] = one.rooted("IfcBuildingStorey", "storey", str(level), **said)
        self._aggregated("frame", [(project, site), (site, building), *((building, storey) for storey in self.storeys.values())])
        warnings = {f"Warning {number}": warning for number, warning in enumerate(self.model.warnings, 1)}
        if warnings:
            one.says(project, "project", "", "Compose_Warnings", warnings)

    def _aggregated(self, role: str, pairs: Sequence[tuple[Entity, Entity]]) -> None:
        whole: dict[Entity, list[Entity]] = defaultdict(list)
        for parent, child in pairs:
            whole[parent].append(child)
        for number, (parent, children) in enumerate(whole.items()):
            self.make_one.rooted("IfcRelAggregates", f"{role} in", str(number), RelatingObject=parent, RelatedObjects=children)

    def _space(self, room: FloorPlate) -> None:
        """Writes a room as its clear space, with its areas, and the floor under it."""
        one, storey = self.make_one, self.storeys[room.level]
        corners = clear_corners(room, self.model.panels, self.model.thickness / 2)
        height = room.ceiling - room.elevation
        clear = [(x, -z) for x, z in reversed(corners)]
        at = one.placed(storey.ObjectPlacement, (0.0, 0.0, 0.0))
        shape = one.shape([one.prism(clear, 0.0, height)])
        said = {"Name": printable(room.id), "LongName": printable(name_of(room)), "CompositionType": "ELEMENT"}
        kind = "EXTERNAL" if room.outdoor else "INTERNAL"
        space = one.rooted("IfcSpace", "space", room.id, **said, ObjectPlacement=at, Representation=shape, PredefinedType=kind)
        self.spaces[room.id] = space
        own = {key.capitalize(): value for key, value in said_of_room(room).items()}
        one.says(space, "space", room.id, "Compose_Room", own | {"Outdoor": room.outdoor})
        areas = {"NetFloorArea": doubled_area(corners) / 2, "GrossFloorArea": room.area}
        amounts = [one.new("IfcQuantityArea", Name=name, AreaValue=round(area, 6)) for name, area in areas.items()]
        amounts.append(one.new("IfcQuantityLength", Name="Height", LengthValue=round(height, 6)))
        known = one.rooted("IfcElementQuantity", "space sizes", room.id, Name="Qto_SpaceBaseQuantities", Quantities=amounts)
        one.rooted("IfcRelDefinesByProperties", "space sized", room.id, RelatedObjects=[space], RelatingPropertyDefinition=known)
        plate = one.painted(one.prism([(x, -z) for x, z in reversed(room.corners)], -SLAB, SLAB), room.paint)
        placed, shown = one.placed(storey.ObjectPlacement, (0.0, 0.0, 0.0)), one.shape([plate])
        slab = one.rooted("IfcSlab", "floor", room.id, Name="Floor", ObjectPlacement=placed, Representation=shown, PredefinedType="FLOOR")
        self.held[storey].append(slab)

    def _walls(self) -> dict[str, Entity]:
        """Writes walls and the openings in them; returns the openings by id."""
        one = self.make_one
        openings: dict[str, Entity] = {}
        for number, panel in enumerate(self.model.panels):
            storey, identity = self.storeys[panel.level], str(number)
            (x, z), turn = ((panel.start, panel.line), 0.0) if panel.axis == "x" else ((panel.line, panel.start), -90.0)
            at = one.placed(storey.ObjectPlacement, (x, -z, 0.0), turn)
            length = panel.end - panel.start
            block = one.painted(one.block((length, panel.thickness, panel.height), (length / 2, 0.0, 0.0)), self._wall_paint(panel))
            said = {"Name": f"Wall {number}", "ObjectPlacement": at, "Representation": one.shape([block]), "PredefinedType": "SOLIDWALL"}
            wall = one.rooted("IfcWall", "wall", identity, **said)
            self.held[storey].append(wall)
            for hole in panel.holes:
                wide, high, deep = hole.end - hole.start, hole.high - hole.low, panel.thickness * 1.5
                middle = ((hole.start + hole.end) / 2 - panel.start, 0.0, hole.low)
                shape = one.shape([one.block((wide, deep, high), (0.0, 0.0, 0.0))])
                key = f"{identity} {hole.opening}"
                where = {"ObjectPlacement": one.placed(at, middle), "Representation": shape, "PredefinedType": "OPENING"}
                opening = one.rooted("IfcOpeningElement", "opening", key, Name=printable(hole.opening), **where)
                one.rooted("IfcRelVoidsElement", "voids", key, RelatingBuildingElement=wall, RelatedOpeningElement=opening)
                openings.setdefault(hole.opening, opening)
        return openings

    def _wall_paint(self, panel: WallPanel) -> Paint:
        """Returns the paint of the longest piece of a wall."""
        across = 2 if panel.axis == "x" else 0
        mine = [
            one for one in self.model.walls
            if one.axis == panel.axis and abs(one.box.middle[across] - panel.line) < 1e-6 and one.box.y0 >= panel.elevation - 1e-6
        ]  # fmt: skip
        return max(mine, key=lambda one: max(one.box.size)).lesser if mine else PLAIN_WALL

    def _filling(self, opening: PlacedOpening, leaves: Sequence[DoorLeaf], hole: Entity | None) -> None:
        """Writes a door or window into its hole, hinged at its left where its frame's y axis is the way it swings; passages have none."""
        if opening.kind not in ("door", "garage_door", "window"):
            return
        one, storey = self.make_one, self.storeys[opening.level]
        frame = _OpeningFrame(opening)
        items = [one.painted(one.solid(part), paint) for part, paint in frame.filled(leaves)]
        at = one.placed(storey.ObjectPlacement, frame.origin, frame.turn)
        said = {
            "Name": printable(opening.id), "ObjectPlacement": at, "Representation": one.shape(items),
            "OverallHeight": round(opening.head - opening.sill, 6), "OverallWidth": round(frame.width, 6),
        }  # fmt: skip
        if opening.kind == "window":
            made = one.rooted("IfcWindow", "window", opening.id, **said, PredefinedType="WINDOW", PartitioningType="SINGLE_PANEL")
        else:
            one_leaf = "SINGLE_SWING_LEFT" if frame.hinge_is_first else "SINGLE_SWING_RIGHT"
            way = "ROLLINGUP" if opening.kind == "garage_door" else one_leaf if len(leaves) == 1 else "DOUBLE_DOOR_SINGLE_SWING"
            made = one.rooted("IfcDoor", "door", opening.id, **said, PredefinedType="DOOR", OperationType=way)
        self.held[storey].append(made)
        if hole:
            one.rooted("IfcRelFillsElement", "fills", opening.id, RelatingOpeningElement=hole, RelatedBuildingElement=made)

    def _railings(self) -> None:
        one = self.make_one
        for level, storey in self.storeys.items():
            room = next((room for room in self.model.rooms if room.level == level), None)
            if room and (boxes := self.model.railings(room)):
                items = [one.painted(one.block(*_block(box, room.elevation)), SURFACES["railing"]) for box in boxes]
                at = one.placed(storey.ObjectPlacement, (0.0, 0.0, 0.0))
                said = {"ObjectPlacement": at, "Representation": one.shape(items), "PredefinedType": "GUARDRAIL"}
                self.held[storey].append(one.rooted("IfcRailing", "railing", str(level), Name="Railing", **said))

    def _furniture(self, body: ModelBody) -> None:
        """Writes a body of a type that those of the same kind, size and colours share; people and pets as proxies."""
        one = self.make_one
        kind, shape_map = self._type(body)
        room = self.rooms.get(body.room or "")
        place: Entity = self.spaces[room.id] if room else next(iter(self.storeys.values()))
        at = one.placed(place.ObjectPlacement, (body.x, -body.z, body.y - (room.elevation if room else 0.0)), body.turn)
        target = one.new("IfcCartesianTransformationOperator3D", LocalOrigin=one.point(0.0, 0.0, 0.0))
        mapped = one.new("IfcMappedItem", MappingSource=shape_map, MappingTarget=target)
        said = {
            "Name": printable(body.id),
            "ObjectType": printable(body.name),
            "ObjectPlacement": at,
            "Representation": one.shape([mapped]),
        }
        if body.sort == "dynamic":
            made = one.rooted("IfcBuildingElementProxy", "body", body.id, **said, PredefinedType="USERDEFINED")
        else:
            made = one.rooted("IfcFurniture", "body", body.id, **said, PredefinedType="USERDEFINED")
        self.of_type[kind].append(made)
        self.held[place].append(made)
        lengths = {"Width": body.width, "Depth": body.depth, "Height": body.height}
        one.says(made, "body", body.id, "Compose_Body", {
            "Id": body.id, "Kind": body.kind, "Category": body.category, "Sort": body.sort, "Parent": body.parent,
            "Mass": ("IfcMassMeasure", float(body.mass)), "Fixed": body.fixed, "Hung": body.hung,
            **{name: ("IfcPositiveLengthMeasure", float(value)) for name, value in lengths.items()},
        })  # fmt: skip

    def _type(self, body: ModelBody) -> tuple[Entity, Entity]:
        one, key = self.make_one, (body.sort == "dynamic", body.shape, body.parts, body.paints)
        if key not in self.shapes:
            items = [one.painted(one.solid(part), paint) for part, paint in zip(body.parts, body.paints, strict=True)]
            drawn = one.new("IfcRepresentationMap", MappingOrigin=one.axes((0.0, 0.0, 0.0)), MappedRepresentation=one.representation(items))
            said = {"Name": printable(body.kind or body.name), "ElementType": printable(body.name), "RepresentationMaps": [drawn]}
            identity, living = str(len(self.shapes)), body.sort == "dynamic"
            kind = (
                one.rooted("IfcBuildingElementProxyType", "type", identity, **said, PredefinedType="USERDEFINED")
                if living
                else one.rooted("IfcFurnitureType", "type", identity, **said, AssemblyPlace="FACTORY", PredefinedType="USERDEFINED")
            )
            self.shapes[key] = kind, drawn
        return self.shapes[key]


class _OpeningFrame:
    """The frame of a door or window: its origin at the lower left of the opening, y the way a leaf swings, x along the wall, z up."""

    def __init__(self, opening: PlacedOpening) -> None:
        self.opening, self.width = opening, opening.end - opening.start
        along_x, forwards = opening.axis == "x", opening.towards == (-1 if opening.axis == "x" else 1)
        first = opening.start if forwards else opening.end
        self.turn = (0.0 if forwards else 180.0) if along_x else (-90.0 if forwards else 90.0)
        x, z = (first, opening.line) if along_x else (opening.line, first)
        self.origin = (x, -z, opening.sill)
        hinge = opening.start if opening.hinge == "start" else opening.end
        self.hinge_is_first = hinge == first

    def filled(self, leaves: Sequence[DoorLeaf]) -> list[tuple[BodyPart, Paint]]:
        """Returns the frame's boards, a window's pane and closed leaves, in this frame."""
        parts = shut_parts(self.opening, leaves, self.turn)
        return [(part._replace(at=(part.at[0] + self.width / 2, *part.at[1:])), paint) for part, paint in parts]


def _block(box: Cuboid, elevation: float) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    """Returns a box's extents along x, y, z here, and the middle of its underside above its storey's floor."""
    (width, height, depth), (x, _, z) = box.size, box.middle
    return (width, depth, height), (x, -z, box.y0 - elevation)
