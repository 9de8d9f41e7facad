"""Measures a part with numpy arrays: its volume, its deepest point, and where its sheets meet.

usage: measure_part.py INPUT.stl AXIS.npz

The folder of the package must be on PYTHONPATH unless Medial is installed where Python looks.
"""

import sys

import medial
import numpy as np
from vtkmodules.vtkIOGeometry import vtkSTLReader


def read(file):
    reader = vtkSTLReader()
    reader.SetFileName(file)
    medial.update(reader)
    return reader.GetOutput()


def show_progress(fraction, phase):
    print(f"\r{100 * fraction:3.0f} % {phase:20}", end="", file=sys.stderr, flush=True)


def main(surface_file, axis_file):
    mesh = read(surface_file)
    axis = medial.medial_axis(mesh, resolution=64, angle=60, field=True, progress=show_progress)
    print(file=sys.stderr)
    inside = axis.field.distance < 0
    print(f"volume {np.count_nonzero(inside) * axis.field.spacing.prod():.3f}")

    deepest = axis.radius.argmax()
    x, y, z = axis.points[deepest]
    print(f"largest ball inside: radius {axis.radius[deepest]:.3f} at {x:.3f} {y:.3f} {z:.3f}")

    seams = medial.curves(axis, rims=False, other=False)
    steps = [np.diff(axis.points[seam.indices], axis=0) for seam in seams]
    length = sum(np.linalg.norm(step, axis=1).sum() for step in steps)
    print(f"{len(seams)} seams, {length:.3f} long together")

    np.savez(axis_file, points=axis.points, radius=axis.radius, faces=axis.faces)
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    try:
        sys.exit(main(*sys.argv[1:]))
    except (medial.Error, OSError) as error:
        sys.exit(f"measure_part.py: {error}")
