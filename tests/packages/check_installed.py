"""Runs the installed programs and the installed Python package on a box whose axis is known.

Usage: check_installed.py VERSION
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import medial
import numpy as np

HALF_SIDES = (1.0, 0.75, 0.5)
QUADS = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))


def make_box() -> tuple[np.ndarray, np.ndarray]:
    """Corners in the order of their bits z, y, x from the lowest, and triangles, outwards."""
    corners = np.array([[(i >> 2) & 1, (i >> 1) & 1, i & 1] for i in range(8)])
    triangles = [(q[0], q[i], q[i + 1]) for q in QUADS for i in (1, 2)]
    return (2.0 * corners - 1.0) * HALF_SIDES, np.array(triangles)


def run(*command: str) -> str:
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def write_off(path: Path, vertices: np.ndarray, faces: np.ndarray) -> None:
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(map(str, vertex)) for vertex in vertices]
    lines += [" ".join(map(str, (3, *face))) for face in faces]
    path.write_text("\n".join(lines) + "\n")


def check_programs(folder: Path, version: str) -> None:
    axis, mesh, figures = (str(folder / name) for name in ("axis.ply", "box.off", "figures.json"))
    picture, page = folder / "picture.png", folder / "page.html"
    write_off(Path(mesh), *make_box())
    for program in ("medial-axis", "medial-distance", "medial-measure", "medial-proximity",
                    "medial-viewer"):
        assert run(program, "--version").strip() == f"{program} {version}"
    run("medial-axis", mesh, "--resolution", "64", "--output", axis, "--image", str(picture),
        "--html", str(page))
    run("medial-measure", axis, mesh, "--json", figures)
    with open(figures, encoding="utf-8") as file:
        found = json.load(file)
    # The axis of a convex solid is one contractible piece.
    assert found["axis"]["components"] == 1 and found["axis"]["euler_characteristic"] == 1, found
    assert found["radius_error"]["max"] < 1e-3 and found["centres_inside"] == 1.0, found
    assert found["two_sided"]["hausdorff"] < 1.5, found  # of the diagonal, in %
    assert picture.read_bytes().startswith(b"\x89PNG")
    pairs = str(folder / "pairs.json")
    run("medial-proximity", mesh, mesh, "--transform", "1=1,0,0,9,0,1,0,0,0,0,1,0", "--json", pairs)
    with open(pairs, encoding="utf-8") as file:
        pair = json.load(file)["frames"][0]["pairs"][0]
    assert abs(pair["separation"] - (9.0 - 2.0 * HALF_SIDES[0])) < 1e-12 and not pair["collide"], pair
    summary = json.loads(run("medial-distance", mesh, mesh, "--json", "-"))
    assert summary["hausdorff"]["distance"] < 1e-12, summary
    assert "vtk.js" in page.read_text(encoding="utf-8")
    viewer = subprocess.run(("medial-viewer", mesh), check=False, stderr=subprocess.PIPE, text=True)
    assert viewer.returncode == 4 and "no display" in viewer.stderr, viewer


def check_python() -> None:
    assert medial.__file__ == "/usr/lib/python3/dist-packages/medial/__init__.py", medial.__file__
    assert Path(medial.__file__).parent.joinpath("__pycache__").is_dir(), "nothing was compiled"
    vertices, faces = make_box()
    axis = medial.medial_axis(vertices, faces, resolution=64)
    # The balls touch the nearest side: the radius is the distance from it.
    distances = np.array(HALF_SIDES) - np.abs(axis.points)
    assert len(axis.points) > 1000 and len(axis.faces) > 1000
    assert np.allclose(axis.radius, distances.min(axis=1), atol=1e-4)
    assert abs(axis.radius.max() - HALF_SIDES[2]) < 1e-4
    field = medial.distance_field(vertices, faces, resolution=64)
    spacing = max(field.spacing)
    assert abs(field.distance.min() + HALF_SIDES[2]) < spacing
    assert issubclass(medial.vtkMedialAxis, medial.vtkMeshFieldAlgorithm)


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        check_programs(Path(folder), sys.argv[1])
    check_python()


if __name__ == "__main__":
    main()
