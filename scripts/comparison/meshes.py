"""Meshes for scripts/compare-outputs: those of MEDIAL_MODELS, or made-up ones."""

import math
import os
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
MESHES = [
    "cad/joint_446.off", "cad/anchor_1k.off", "cad/conrod_misoriented_6.4k.stl",
    "cad/fandisk_13k.obj", "paper/bunny_vtk_1k_unwelded.vtp", "organic/elephant_5.6k.off",
    "organic/cow_viewpoint_5.8k.obj", "vessel/aorta_open_ends_11.9k.stl", "thin/rear_case_15k.ply",
    "soup/beetle_vw_2k.obj", "soup/many_small_holes_3.5k.ply", "selfint/footbones_26comp_4.2k.off",
    "multi/two_spheres_2.1k.obj", "odd/wedge40.off", "odd/bunny_one_hole.off"]
AS_VTK = "cad/anchor_1k.off"  # becomes a legacy VTK file, of which there is none
TIMED_MESHES = ["paper/triceratops.off", "paper/derived/gargoyle_11000.off", "cad/fandisk_13k.obj",
                "organic/hand_24.9k.obj"]
INSTALLED = Path("/usr/share/glmark2/models/bunny.obj")


def lines(form, rows):
    return "".join(form.format(*row) + "\n" for row in rows)


def off_text(points, triangles):
    return (f"OFF\n{len(points)} {len(triangles)} 0\n" + lines("{!r} {!r} {!r}", points) +
            lines("3 {} {} {}", triangles))


def obj_text(points, triangles):
    return lines("v {!r} {!r} {!r}", points) + "".join(
        f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in triangles)


def ply_text(points, triangles):
    return (f"ply\nformat ascii 1.0\nelement vertex {len(points)}\nproperty double x\n"
            f"property double y\nproperty double z\nelement face {len(triangles)}\n"
            "property list uchar int vertex_indices\nend_header\n" +
            lines("{!r} {!r} {!r}", points) + lines("3 {} {} {}", triangles))


def stl_text(points, triangles):
    return "solid mesh\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" +
        lines("vertex {!r} {!r} {!r}", (points[i] for i in triangle)) + "endloop\nendfacet\n"
        for triangle in triangles) + "endsolid mesh\n"


def vtk_text(points, triangles):
    return ("# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET POLYDATA\n"
            f"POINTS {len(points)} double\n" + lines("{!r} {!r} {!r}", points) +
            f"POLYGONS {len(triangles)} {4 * len(triangles)}\n" + lines("3 {} {} {}", triangles))


def vtp_text(points, triangles):
    def array(attributes, values):
        return f'<DataArray {attributes} format="ascii">\n{values}</DataArray>\n'

    ends = lines("{}", ((3 * i,) for i in range(1, len(triangles) + 1)))
    return (f'<VTKFile type="PolyData"><PolyData><Piece NumberOfPoints="{len(points)}" '
            f'NumberOfPolys="{len(triangles)}"><Points>\n' +
            array('type="Float64" NumberOfComponents="3"', lines("{!r} {!r} {!r}", points)) +
            "</Points><Polys>\n" +
            array('type="Int64" Name="connectivity"', lines("{} {} {}", triangles)) +
            array('type="Int64" Name="offsets"', ends) + "</Polys></Piece></PolyData></VTKFile>\n")


TEXTS = {".off": off_text, ".obj": obj_text, ".ply": ply_text, ".stl": stl_text, ".vtk": vtk_text,
         ".vtp": vtp_text}


def read_off(file):
    """Points and triangles of a file without comments."""
    words = file.read_text().split()
    points, triangles = int(words[1]), int(words[2])
    numbers = [float(word) for word in words[4:4 + 3 * points]]
    ids = [int(word) for word in words[4 + 3 * points:4 + 3 * points + 4 * triangles]]
    return (list(zip(numbers[::3], numbers[1::3], numbers[2::3])),
            list(zip(ids[1::4], ids[2::4], ids[3::4])))


def box(low, high):
    points = [tuple((low, high)[i >> axis & 1][axis] for axis in range(3)) for i in range(8)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return points, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def lattice(columns, rows, closed_columns, closed_rows, place):
    """A grid of quads, cut into triangles, whose ends may be joined; place(u, v) are its points."""
    def index(i, j):
        return i % columns + columns * (j % rows)

    points = [place(2 * math.pi * i / columns, 2 * math.pi * j / rows)
              for j in range(rows) for i in range(columns)]
    cells = [(index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1))
             for j in range(rows if closed_rows else rows - 1)
             for i in range(columns if closed_columns else columns - 1)]
    return points, [t for a, b, c, d in cells for t in ((a, b, c), (a, c, d))]


def made_up_shapes():
    """Solid, thin, overlapping, with a tunnel, flat, open, and a sheet."""
    def torus(height):
        return lambda u, v: ((3 + math.cos(v)) * math.cos(u), (3 + math.cos(v)) * math.sin(u),
                             height * math.sin(v))

    first, second = box((0, 0, 0), (2, 2, 2)), box((1.5, 0.5, 0.25), (4, 1.5, 1.75))
    return {
        "box": box((0, 0, 0), (1, 2, 3)),
        "plate": box((0, 0, 0), (5, 4, 0.1)),
        "boxes": (first[0] + second[0],
                  first[1] + [tuple(i + 8 for i in triangle) for triangle in second[1]]),
        "torus": lattice(32, 16, True, True, torus(1)),
        "ring": lattice(24, 12, True, True, torus(0.3)),
        "tube": lattice(20, 10, True, False, lambda u, v: (math.cos(u), math.sin(u), v)),
        "sheet": lattice(12, 9, False, False, lambda u, v: (u, v, math.sin(u) * math.cos(v)))}


def made_up_meshes(folder):
    """Each shape in two formats, and a mesh that is installed."""
    files = [INSTALLED] if INSTALLED.exists() else []
    suffixes = list(TEXTS)
    for i, (name, shape) in enumerate(made_up_shapes().items()):
        for suffix in (suffixes[i % 6], suffixes[(i + 3) % 6]):
            files.append(folder / (name + suffix))
            files[-1].write_text(TEXTS[suffix](*shape))
    return files


def default_meshes(names, folder):
    """The named ones of MEDIAL_MODELS, one of them as .vtk."""
    models = Path(os.environ.get("MEDIAL_MODELS") or ROOT.parent / "shared/models")
    if not models.is_dir():
        print("MEDIAL_MODELS names no folder: made-up meshes instead")
        return made_up_meshes(folder)[:len(names)]
    files = []
    for name in names:
        file = models / name
        if name == AS_VTK:
            file = folder / f"{file.stem}.vtk"
            file.write_text(vtk_text(*read_off(models / name)))
        files.append(file)
    return files
