"""Writes one home in every format, and a page of pictures of them: `make gallery`.

python -m scripts.gallery [FOLDER] [--seed N] [--program PRESET] [--style NAME]
"""

from __future__ import annotations

import argparse
import html
import io
import time
from pathlib import Path
from typing import Final

from PIL import Image

from compose_homes import EXPORT_FORMATS, Request, Scene, dump, export, generate

FOLDER: Final = Path("gallery")
SHOWN: Final = (".png", ".svg", ".pgm")
"""Files that a page can show, a map of grey cells once it is a PNG."""
STYLE: Final = """
body { margin: 0 auto; max-width: 1200px; padding: 24px; font: 16px/1.5 system-ui, sans-serif; color: #1c2430; background: #f7f6f3; }
figure { margin: 0; } img { max-width: 100%; border: 1px solid #d5d2ca; background: #fff; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(420px, 1fr)); gap: 20px; }
table { border-collapse: collapse; margin: 24px 0; } td, th { padding: 4px 14px 4px 0; text-align: left; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
"""


def written(scene: Scene, folder: Path) -> dict[str, tuple[list[Path], float]]:
    """Writes a scene in every format, a folder each; returns the files and the processor's time, s, by format."""
    found: dict[str, tuple[list[Path], float]] = {}
    for name in EXPORT_FORMATS:
        begun = time.process_time()
        files = export(scene, name)
        taken = time.process_time() - begun
        for path, content in files.items():
            target = folder / name / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)
        found[name] = ([folder / name / path for path in files], taken)
    return found


def pictures(paths: list[Path]) -> list[Path]:
    """Returns the files that a page can show, maps of cells as PNG beside them."""
    for path in paths:
        if path.suffix == ".pgm":
            path.with_suffix(".png").write_bytes(_png(path))
    return [path.with_suffix(".png") if path.suffix == ".pgm" else path for path in paths if path.suffix in SHOWN]


def _png(path: Path) -> bytes:
    held = io.BytesIO()
    picture = Image.open(path)
    picture.resize((picture.width * 4, picture.height * 4), Image.Resampling.NEAREST).save(held, "PNG")
    return held.getvalue()


def page(scene: Scene, found: dict[str, tuple[list[Path], float]], folder: Path) -> str:
    """Returns the gallery's page: the pictures, and a table of formats."""
    shown = [path for paths, _ in found.values() for path in pictures(paths)]
    figures = "".join(
        f'<figure><img src="{path.relative_to(folder)}" alt="{path.stem}"><figcaption>{path.relative_to(folder)}</figcaption></figure>'
        for path in shown
    )
    rows = "".join(_row(name, paths, taken, folder) for name, (paths, taken) in found.items())
    title = html.escape(f"One home in {len(found)} formats: seed {scene.seed}")
    return (
        f'<!doctype html><html lang="en"><meta charset="utf-8"><title>{title}</title><style>{STYLE}</style><h1>{title}</h1>'
        f"<table><tr><th>format</th><th>for</th><th>files</th><th>KB</th><th>CPU ms</th></tr>{rows}</table>"
        f'<div class="pictures">{figures}</div></html>'
    )


def _row(name: str, paths: list[Path], taken: float, folder: Path) -> str:
    links = ", ".join(f'<a href="{path.relative_to(folder)}">{html.escape(path.name)}</a>' for path in paths[:8])
    more = f" and {len(paths) - 8} more" if len(paths) > 8 else ""
    size = sum(path.stat().st_size for path in paths) / 1000
    cells = f'<td class="number">{size:,.0f}</td><td class="number">{1000 * taken:.0f}</td>'
    return f"<tr><td>{name}</td><td>{html.escape(EXPORT_FORMATS[name])}</td><td>{links}{more}</td>{cells}</tr>"


def main() -> None:
    """Writes the gallery."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("folder", nargs="?", type=Path, default=FOLDER)
    parser.add_argument("--seed", type=int, default=2024)
    parser.add_argument("--program", default="family")
    parser.add_argument("--style")
    options = parser.parse_args()
    scene = generate(Request(seed=options.seed, program=options.program, style=options.style, decorate=True)).scene
    options.folder.mkdir(parents=True, exist_ok=True)
    dump(scene, options.folder / "home.yaml")
    found = written(scene, options.folder)
    (options.folder / "index.html").write_text(page(scene, found, options.folder), encoding="utf-8")
    print(f"wrote {options.folder / 'index.html'} and {sum(len(paths) for paths, _ in found.values())} files")


if __name__ == "__main__":
    main()
