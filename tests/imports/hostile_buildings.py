"""Hostile files of CAD and building programmes: DXF, IFC; see `hostile_plans`."""

from __future__ import annotations

from typing import Final

from tests.imports.hostile_plans import hostile


def dxf_of(entities: str, blocks: str = "", unit: int = 6) -> bytes:
    head = f"  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1009\n  9\n$INSUNITS\n 70\n{unit}\n  0\nENDSEC\n"
    return (
        head + f"  0\nSECTION\n  2\nBLOCKS\n{blocks}  0\nENDSEC\n  0\nSECTION\n  2\nENTITIES\n{entities}  0\nENDSEC\n  0\nEOF\n"
    ).encode()


def dxf_block(name: str, inside: str) -> str:
    return f"  0\nBLOCK\n  8\n0\n  2\n{name}\n 70\n0\n 10\n0\n 20\n0\n 30\n0\n{inside}  0\nENDBLK\n  8\n0\n"


def dxf_insert(name: str, columns: int | str = 1, rows: int = 1, layer: str = "door") -> str:
    return f"  0\nINSERT\n  8\n{layer}\n  2\n{name}\n 10\n0\n 20\n0\n 30\n0\n 70\n{columns}\n 71\n{rows}\n 44\n1.0\n 45\n1.0\n"


def dxf_line(x0: float, y0: float, x1: float, y1: float, layer: str = "0") -> str:
    return f"  0\nLINE\n  8\n{layer}\n 10\n{x0}\n 20\n{y0}\n 30\n0\n 11\n{x1}\n 21\n{y1}\n 31\n0\n"


def dxf_outline(spots: list[tuple[float, float]], layer: str = "room") -> str:
    vertices = "".join(f"  0\nVERTEX\n  8\n{layer}\n 10\n{x}\n 20\n{y}\n 30\n0\n" for x, y in spots)
    return f"  0\nPOLYLINE\n  8\n{layer}\n 66\n1\n 70\n1\n{vertices}  0\nSEQEND\n  8\n{layer}\n"


_DXF_ROOM: Final = dxf_outline([(0, 0), (4, 0), (4, 3), (0, 3)])


@hostile
def dxf_of_inserts_within_inserts() -> bytes:
    within = (dxf_block(f"door{at}", dxf_insert(f"door{at - 1}") * 30) for at in range(1, 12))
    return dxf_of(_DXF_ROOM + dxf_insert("door11"), dxf_block("door0", dxf_line(0, 0, 1, 0)) + "".join(within))


@hostile
def dxf_of_a_block_in_itself() -> bytes:
    return dxf_of(_DXF_ROOM + dxf_insert("door"), dxf_block("door", dxf_insert("door") * 40))


@hostile
def dxf_of_a_large_block_often() -> bytes:
    return dxf_of(_DXF_ROOM + dxf_insert("door") * 2_000, dxf_block("door", dxf_line(0, 0, 1, 0) * 12_000))


@hostile
def dxf_of_many_lines() -> bytes:
    """As many as are let through before they are read."""
    return dxf_of(_DXF_ROOM + "  0\nLINE\n  8\nwall\n 10\n1\n 20\n1\n 11\n2\n 21\n1\n" * 149_000)


@hostile
def dxf_of_an_outline_of_many_points() -> bytes:
    """A POLYLINE of a VERTEX each."""
    return dxf_of("  0\nPOLYLINE\n  8\nroom\n 66\n1\n 70\n1\n" + "  0\nVERTEX\n  8\nroom\n 10\n1\n 20\n1\n" * 149_000 + "  0\nSEQEND\n")


@hostile
def dxf_of_many_points_in_a_line() -> bytes:
    """An LWPOLYLINE: its points are no entities."""
    return dxf_of("  0\nLWPOLYLINE\n100\nAcDbEntity\n  8\nroom\n100\nAcDbPolyline\n 70\n1\n" + " 10\n1\n 20\n1\n" * 590_000)


@hostile
def dxf_of_tags() -> bytes:
    return dxf_of(_DXF_ROOM, "999\nx\n" * 1_300_000)


@hostile
def dxf_of_many_layers() -> bytes:
    return dxf_of(_DXF_ROOM + "".join(dxf_line(0, 0, 1, 1, f"layer {at} {'x' * 300}") for at in range(18_000)))


def ifc_of(*lines: str) -> bytes:
    head = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('a','',(''),(''),'','','');\n"
    head += "FILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n"
    return (head + "\n".join(lines) + "\nENDSEC;\nEND-ISO-10303-21;\n").encode()


@hostile
def ifc_of_many_points() -> bytes:
    return ifc_of(*(f"#{at}=IFCCARTESIANPOINT(({at}.,0.,0.));" for at in range(1, 190_000)))


@hostile
def ifc_of_many_on_a_line() -> bytes:
    """As many entities, in a single line."""
    return ifc_of("".join(f"#{at}=IFCCARTESIANPOINT(({at}.,0.,0.));" for at in range(1, 190_000)))


@hostile
def ifc_of_a_long_list() -> bytes:
    return ifc_of("#1=IFCCARTESIANPOINTLIST2D((" + ",".join(f"({at}.,0.)" for at in range(500_000)) + "));")


@hostile
def ifc_nested_deeply() -> bytes:
    return ifc_of("#1=IFCCARTESIANPOINTLIST2D(" + "(" * 200_000 + "1." + ")" * 200_000 + ");")


_IFC_ROOM: Final = (
    "#1=IFCCARTESIANPOINT((1.,1.,0.));", "#2=IFCAXIS2PLACEMENT3D(#1,$,$);", "#3=IFCDIRECTION((0.,0.,1.));",
    "#4=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,4.,3.);", "#5=IFCEXTRUDEDAREASOLID(#4,$,#3,2.5);",
    "#6=IFCSHAPEREPRESENTATION($,'Body','SweptSolid',(#5));", "#7=IFCPRODUCTDEFINITIONSHAPE($,$,(#6));", "#8=IFCLOCALPLACEMENT($,#2);",
)  # fmt: skip
"""A shape (#7) and a place (#8) of rooms, and what they are of."""


def ifc_space(number: int, place: str = "#8", shape: str = "#7") -> str:
    return f"#{number}=IFCSPACE('{number:022}',$,'a',$,$,{place},{shape},'Kitchen',.ELEMENT.,.INTERNAL.,$);"


@hostile
def ifc_of_placements_in_a_chain() -> bytes:
    """Where a space stands is told by 60,000 placements upon each other."""
    chain = [f"#{at}=IFCLOCALPLACEMENT({f'#{at - 1}' if at > 10 else '$'},#2);" for at in range(10, 60_010)]
    return ifc_of(*_IFC_ROOM, *chain, ifc_space(9, "#60009"))


@hostile
def ifc_of_many_placements_of_many() -> bytes:
    """4,900 spaces, each upon 900 placements that they share."""
    chain = [f"#{at}=IFCLOCALPLACEMENT({f'#{at - 1}' if at > 10 else '$'},#2);" for at in range(10, 910)]
    return ifc_of(*_IFC_ROOM, *chain, *(ifc_space(at, "#909") for at in range(1_000, 5_900)))


@hostile
def ifc_of_placements_in_a_ring() -> bytes:
    ring = ["#10=IFCLOCALPLACEMENT(#11,#2);", "#11=IFCLOCALPLACEMENT(#10,#2);"]
    return ifc_of(*_IFC_ROOM, *ring, ifc_space(9, "#10"))


@hostile
def ifc_of_a_room_within_itself() -> bytes:
    ring = ["#10=IFCRELAGGREGATES('a',$,$,$,#12,(#13));", "#11=IFCRELAGGREGATES('b',$,$,$,#13,(#12));"]
    return ifc_of(*_IFC_ROOM, *ring, ifc_space(12), ifc_space(13))


def ifc_of_rooms_within_rooms(deep: int) -> bytes:
    """Each space holds the next."""
    held = [f"#{at}=IFCRELAGGREGATES('{at}',$,$,$,#{at + 1000},(#{at + 1001}));" for at in range(1000, 999 + deep)]
    return ifc_of(*_IFC_ROOM, *held, *(ifc_space(at) for at in range(2000, 2000 + deep)))


@hostile
def ifc_of_a_large_shape_often() -> bytes:
    """4,900 spaces of one outline of 100,000 points."""
    points = ",".join(f"({at}.,{at % 7}.)" for at in range(100_000))
    shape = (
        f"#10=IFCCARTESIANPOINTLIST2D(({points}));", "#11=IFCINDEXEDPOLYCURVE(#10,$,$);",
        "#12=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#11);", "#13=IFCEXTRUDEDAREASOLID(#12,$,#3,2.5);",
        "#14=IFCSHAPEREPRESENTATION($,'Body','SweptSolid',(#13));", "#15=IFCPRODUCTDEFINITIONSHAPE($,$,(#14));",
    )  # fmt: skip
    return ifc_of(*_IFC_ROOM, *shape, *(ifc_space(at, "#8", "#15") for at in range(1_000, 5_900)))


@hostile
def ifc_of_shapes_within_shapes() -> bytes:
    """Mapped shapes of thirty mapped shapes, eight deep, of nothing that is understood."""
    lines = ["#20=IFCSPHERE(#2,1.);", "#100=IFCSHAPEREPRESENTATION($,'Body','CSG',(#20));"]
    lines.append("#19=IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#1,1.,$);")
    for at in range(1, 9):
        lines += [f"#{100 + 10 * at}=IFCREPRESENTATIONMAP(#2,#{100 + 10 * at - 1 if at > 1 else 100});"]
        lines += [f"#{101 + 10 * at}=IFCMAPPEDITEM(#{100 + 10 * at},#19);"]
        lines += [f"#{109 + 10 * at}=IFCSHAPEREPRESENTATION($,'Body','MappedRepresentation',({','.join([f'#{101 + 10 * at}'] * 30)}));"]
    return ifc_of(*_IFC_ROOM, *lines, "#15=IFCPRODUCTDEFINITIONSHAPE($,$,(#189));", ifc_space(9, "#8", "#15"))


@hostile
def ifc_of_properties_of_all() -> bytes:
    """4,900 pieces that share 200 sets of properties."""
    pieces = [f"#{at}=IFCFURNISHINGELEMENT('{at:022}',$,'Chair',$,$,#8,$,$);" for at in range(1_000, 5_900)]
    each = ",".join(f"#{at}" for at in range(1_000, 5_900))
    sets = [f"#{at}=IFCRELDEFINESBYPROPERTIES('{at:022}',$,$,$,({each}),#10);" for at in range(20, 220)]
    return ifc_of(*_IFC_ROOM, ifc_space(9), "#10=IFCPROPERTYSET('a',$,'other',$,());", *pieces, *sets)


@hostile
def ifc_of_many_doors() -> bytes:
    return ifc_of(*_IFC_ROOM, ifc_space(9), *(f"#{at}=IFCDOOR($,$,'a',$,$,#8,$,$,2.,1.,$,$,$);" for at in range(1_000, 150_000)))


@hostile
def ifc_whose_axes_have_no_length() -> bytes:
    return ifc_of(*_IFC_ROOM, "#10=IFCDIRECTION((0.,0.,0.));", "#11=IFCAXIS2PLACEMENT3D(#1,#10,#10);", "#12=IFCLOCALPLACEMENT($,#11);",
                  ifc_space(9, "#12"))  # fmt: skip


@hostile
def ifc_far_away() -> bytes:
    return ifc_of(*_IFC_ROOM, "#10=IFCCARTESIANPOINT((1.E400,-1.E300,0.));", "#11=IFCAXIS2PLACEMENT3D(#10,$,$);",
                  "#12=IFCLOCALPLACEMENT($,#11);", ifc_space(9, "#12"))  # fmt: skip


@hostile
def ifc_of_axes_without_a_length() -> bytes:
    axes = ("#20=IFCDIRECTION((0.,0.,0.));", "#21=IFCAXIS2PLACEMENT3D(#1,#20,#20);", "#22=IFCLOCALPLACEMENT($,#21);")
    return ifc_of(*_IFC_ROOM, *axes, ifc_space(9, "#22"))


@hostile
def ifc_of_a_way_without_a_length() -> bytes:
    """What is extruded goes nowhere."""
    room = (line.replace("(0.,0.,1.)", "(0.,0.,0.)") if line.startswith("#3=") else line for line in _IFC_ROOM)
    return ifc_of(*room, ifc_space(9))
