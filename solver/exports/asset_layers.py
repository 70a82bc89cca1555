"""Own assets as USD layers of their own, z up, which bodies refer to: meshes, materials, pictures beside them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from catalogs.assets.asset_entry import Asset
from solver.exports.asset_files import fit_of
from solver.exports.asset_surfaces import AssetSurface, surfaces_of
from solver.exports.model import ModelBody
from solver.exports.paints import linear
from solver.exports.usd_text import prim, stretched, triangles, triple

FOLDER: Final = "assets"
_HEAD: Final = '#usda 1.0\n(\ndefaultPrim = "Asset"\nkilogramsPerUnit = 1\nmetersPerUnit = 1\nupAxis = "Z"\n)\n'


class AssetLayers:
    """The layers of one export; `files` are theirs by path."""

    def __init__(self, assets: Mapping[str, Asset]) -> None:
        self._assets = assets
        self.files: dict[str, bytes] = {}

    def shape(self, body: ModelBody) -> str:
        """Returns the prim of a body's shape: a reference to its asset, stretched into the body's box.

        Raises:
            RequestError: the asset's file cannot be used any more.
        """
        name = body.asset or ""
        path = f"{FOLDER}/{name}.usda"
        if path not in self.files:
            self.files[path] = self._layer(name).encode()
        x, y, z = fit_of(self._assets[name], (body.width, body.depth, body.height)).stretch
        return f'def Xform "shape" (\nreferences = @./{path}@\n)\n{{\n{stretched((0.0, 0.0, 0.0), (x, z, y))}}}\n'

    def _layer(self, name: str) -> str:
        surfaces = surfaces_of(name, self._assets[name])
        looks = "".join(self._look(name, number, surface) for number, surface in enumerate(surfaces))
        meshes = "".join(_mesh(number, surface) for number, surface in enumerate(surfaces))
        return f'{_HEAD}def Xform "Asset"\n{{\n{prim("Scope", "Looks", (), looks)}{meshes}}}\n'

    def _look(self, name: str, number: int, surface: AssetSurface) -> str:
        """Returns a material, and keeps its picture."""
        paint, at = surface.paint, f"/Asset/Looks/look_{number}"
        color = f"color3f inputs:diffuseColor = {triple(linear(paint.color))}\n"
        more = ""
        if surface.picture:
            file = f"{name}_{number}.{surface.picture.ending}"
            self.files[f"{FOLDER}/{file}"] = surface.picture.content
            color = f"color3f inputs:diffuseColor.connect = <{at}/Picture.outputs:rgb>\n"
            more = prim("Shader", "Places", (), _PLACES) + prim("Shader", "Picture", (), _PICTURE.format(
                file=file, factor=", ".join(f"{value:.4g}" for value in linear(paint.color)), reader=f"{at}/Places.outputs:result"
            ))  # fmt: skip
        shader = (
            f'uniform token info:id = "UsdPreviewSurface"\n{color}float inputs:metallic = {paint.metalness:.4g}\n'
            f"float inputs:opacity = {paint.opacity:.4g}\nfloat inputs:roughness = {paint.roughness:.4g}\ntoken outputs:surface\n"
        )
        inside = f"token outputs:surface.connect = <{at}/Surface.outputs:surface>\n{prim('Shader', 'Surface', (), shader)}{more}"
        return prim("Material", f"look_{number}", (), inside)


_PLACES: Final = 'uniform token info:id = "UsdPrimvarReader_float2"\nstring inputs:varname = "st"\nfloat2 outputs:result\n'
_PICTURE: Final = (
    'uniform token info:id = "UsdUVTexture"\nasset inputs:file = @./{file}@\nfloat4 inputs:scale = ({factor}, 1)\n'
    'token inputs:sourceColorSpace = "sRGB"\nfloat2 inputs:st.connect = <{reader}>\n'
    'token inputs:wrapS = "repeat"\ntoken inputs:wrapT = "repeat"\nfloat3 outputs:rgb\n'
)


def _mesh(number: int, surface: AssetSurface) -> str:
    places = ""
    if surface.places is not None:
        listed = ", ".join(f"({u:.6g}, {v:.6g})" for u, v in surface.places.tolist())
        places = f'texCoord2f[] primvars:st = [{listed}] (\ninterpolation = "vertex"\n)\n'
    inside = triangles(surface, f"rel material:binding = </Asset/Looks/look_{number}>\n", places)
    return prim("Mesh", f"mesh_{number}", ("MaterialBindingAPI",), inside)
