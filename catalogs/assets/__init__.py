"""Own assets: a folder of GLBs that bodies of homes are shown as, each measured and told of in its `assets.yaml`.

Comes in: a folder. Goes out: `Asset`s by name; of a file that is refused, why. May import: the catalogs' types. Not here: which body
shows which (solver), their triangles (exports).
"""

from typing import Final

ASSET_NAME: Final = r"^[A-Za-z0-9][A-Za-z0-9_.-]{0,99}$"
"""What an asset may be called: no path. It stands here, where it costs nothing to import."""
