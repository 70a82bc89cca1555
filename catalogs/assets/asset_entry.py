"""The types of own assets: what `assets.yaml` says of one, and what is known of it once its file is measured."""

import re
from typing import Annotated, Final, Literal

from pydantic import AfterValidator, Field

from catalogs.assets import ASSET_NAME
from catalogs.entries import Entry, Metres, Words

Front = Literal["+z", "-z", "+x", "-x"]
"""Where an asset's front looks in its file; glTF says +z."""
FRONT_TURNS: Final[dict[Front, int]] = {"+z": 0, "-x": 90, "-z": 180, "+x": 270}
"""How far an asset is turned about +y for its front to look to +z, degrees."""
UNSAID: Final = "unsaid"
"""The licence of an asset of which nobody says one."""
NON_COMMERCIAL: Final = re.compile(r"(?:^|[^a-z])nc(?:[^a-z]|$)|non[- ]?commercial|research only|academic", re.IGNORECASE)
"""What licences that forbid commercial use say of themselves."""
AssetName = Annotated[str, Field(pattern=ASSET_NAME)]
AssetSize = tuple[Metres, Metres, Metres]


def _inside(file: str) -> str:
    parts = file.split("/")
    if not file.lower().endswith(".glb") or "\\" in file or ":" in file or any(part in ("", ".", "..") for part in parts):
        raise ValueError("must be the path of a .glb within the folder, such as chairs/oak.glb")
    return file


class AssetEntry(Entry):
    """What `assets.yaml` says of an asset.

    `kinds` are the catalogs' kinds, or names of scenes, that it may stand for. `size` is its width (across its front), depth and height, m;
    it is measured where it is not said. `surfaces` are heights above its underside on which things may lie, m. `mass` in kg. `license`
    is an SPDX identifier or words, `source` where it is from, `author` whose it is. `guessed` are keys that nobody has said.
    """

    file: Annotated[str, AfterValidator(_inside)]
    kinds: Words = Field(min_length=1)
    front: Front = "+z"
    size: AssetSize | None = None
    surfaces: tuple[Metres, ...] = ()
    mass: Annotated[float, Field(gt=0, le=5000, allow_inf_nan=False)] | None = None
    license: Annotated[str, Field(min_length=1, max_length=200)] = UNSAID
    source: Annotated[str, Field(max_length=500)] = ""
    author: Annotated[str, Field(max_length=200)] = ""
    guessed: Words = ()


class Asset(Entry):
    """An asset that was measured.

    `low` and `high` are the ends of the box around its shapes, in its file's own units and frame (y up); `size` is that box in metres, its
    front turned to +z. `surfaces` are heights above its underside, m. `path` is its file, which nobody is told.
    """

    kinds: tuple[str, ...]
    front: Front
    size: AssetSize
    low: tuple[float, float, float]
    high: tuple[float, float, float]
    surfaces: tuple[float, ...]
    mass: float | None
    license: str
    source: str
    author: str
    guessed: tuple[str, ...]
    bytes: int
    triangles: int
    path: Annotated[str, Field(exclude=True)] = ""

    @property
    def is_commercial(self) -> bool:
        """Tells whether its licence is said and does not forbid commercial use."""
        return self.license != UNSAID and not NON_COMMERCIAL.search(self.license)
