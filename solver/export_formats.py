"""Every format that a house can be exported to, by name. Imports nothing: the command line names them before anything is loaded.

Not here: how they are written (exports).
"""

from typing import Final, Literal, NamedTuple, get_args

Freedom = Literal["none", "light", "standing"]
"""What is free to move in a simulator: nothing, light things that stand, or all that stands."""
FREEDOMS: Final = get_args(Freedom)
SCENE_FILE: Final = "compose_scene.json"
"""The scene beside an export of several files, by which it reads back. (ATISS splits names of its folder at their underscore.)"""


class Exporter(NamedTuple):
    """A format: what it is for, the module that writes it, its files' media type; which extra of compose-homes brings its library.

    `shows_assets`: it shows a user's own assets; other formats show the shapes of kinds. `body_work`: what writing a body counts
    (`demanded`), measured.
    """

    words: str
    module: str
    media_type: str
    needs: tuple[str, str] | None = None
    shows_assets: bool = False
    body_work: int = 100


EXPORTERS: Final[dict[str, Exporter]] = {
    "csv": Exporter("pieces, decorations and people as a table", "pieces_csv", "text/csv"),
    "nav2": Exporter("a map for Nav2 (ROS 2), with rooms, doors and places to stand at", "nav2", "application/zip"),
    "tasks": Exporter("tasks for robots that can surely be done, with shortest free paths", "robot_tasks", "application/json"),
    "png": Exporter("a picture from above, and maps of classes, things, rooms and free floor at 2 cm", "top_maps", "application/zip"),
    "boxes": Exporter("boxes a room as ATISS reads them, for training", "layout_boxes", "application/zip"),
    "procthor": Exporter("the house JSON of ProcTHOR and AI2-THOR", "procthor_house", "application/json"),
    "habitat": Exporter("a scene dataset for AI Habitat, with a GLB for each thing", "habitat_scene", "application/zip"),
    "svg": Exporter("floor plan to scale, as an architect draws it", "plan_svg", "image/svg+xml"),
    "glb": Exporter(
        "glTF: Blender, game engines, viewers, the web; the scene inside, so that it reads back", "glb", "model/gltf-binary", None, True
    ),
    "usd": Exporter(
        "USD as text: Isaac Sim, Omniverse, Blender; colliders, masses, doors on joints, labels", "usd_stage", "model/vnd.usda", None, True
    ),
    "arena": Exporter(
        "Isaac Lab-Arena: the usd, and an environment's YAML that names its bodies", "usd_stage", "application/zip", None, True
    ),
    "usdc": Exporter("the same as usd, binary", "usd_stage", "model/vnd.usd", ("pxr", "usd"), True, 300),
    "usdz": Exporter(
        "the same as usd, packed as one file: phones, tablets, previews", "usd_stage", "model/vnd.usdz+zip", ("pxr", "usd"), True, 300
    ),
    "mjcf": Exporter("MuJoCo: colliders, masses, doors on hinges, light things free to move", "mujoco_xml", "application/xml", None, True),
    "urdf": Exporter("ROS, Drake, PyBullet: one robot, fixed but for its doors", "urdf_robot", "application/xml"),
    "sdf": Exporter("Gazebo: a world with a model a body", "sdf_world", "application/xml", None, True),
    "dxf": Exporter("floor plan for CAD programmes", "plan_dxf", "image/vnd.dxf", ("ezdxf", "dxf"), body_work=1000),
    "ifc": Exporter("building for BIM programmes, IFC4", "building_ifc", "application/x-step", ("ifcopenshell", "ifc"), body_work=400),
    "sh3d": Exporter("home for Sweet Home 3D", "sweet_home", "application/x-sweethome3d"),
}
"""The formats by name; `needs` is (module, extra)."""
