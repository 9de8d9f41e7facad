"""Distance fields, medial axes, wall thickness and proximity of meshes, and distances from them.

Functions take and return numpy arrays:

    axis = medial.medial_axis(vertices, faces, resolution=128, angle=60)
    axis.points, axis.radius, axis.faces

distance_field(), medial_axis(), skeleton(), thickness(), local_thickness(), reconstruction(), curves(),
distance(), proximity(), read_mesh(), read_scan() and scan_surface() are each documented by help(), as in
help(medial.medial_axis).
All lengths are in world units, those of the vertices, and all angles in degrees. They raise
medial.Error, or a subclass of it, with the cause.

The same is available as VTK filters, for pipelines:

    axis = medial.vtkMedialAxis()
    axis.SetInputConnection(reader.GetOutputPort())
    medial.update(axis)

help(medial.vtkMedialAxis) prints the manual of the class. medial.update() raises exceptions where
Update() prints messages, reacts to Ctrl-C, and lets other threads run.
"""

from ._axis import MedialAxis, medial_axis
from ._distance import PointDistances, distance
from ._errors import Error, InvalidInputError, NoGpuError, OutOfMemoryError
from ._field import DistanceField, distance_field
from ._files import VERSION as __version__
from ._local_thickness import Distribution, LocalThickness, local_thickness
from ._mesh import Surface, read_mesh
from ._proximity import Contacts, Proximity, proximity
from ._scan import read_scan, scan_surface
from ._shape import (
    Curve,
    DividedThickness,
    ThicknessRegion,
    curves,
    reconstruction,
    thickness,
    thickness_regions,
)
from ._skeleton import Branch, Skeleton, skeleton
from ._update import update
from .vtkMedialFilters import (
    vtkDistributedFieldAlgorithm,
    vtkMedialAxis,
    vtkMedialCurves,
    vtkMedialLocalThickness,
    vtkMedialPolyDataAlgorithm,
    vtkMedialReconstruction,
    vtkMedialSkeleton,
    vtkMedialThickness,
    vtkMeshDistanceField,
    vtkMeshFieldAlgorithm,
    vtkMeshPointDistance,
    vtkMeshProximity,
)

__all__ = [
    "Branch",
    "Contacts",
    "Curve",
    "DistanceField",
    "Distribution",
    "DividedThickness",
    "Error",
    "InvalidInputError",
    "LocalThickness",
    "MedialAxis",
    "NoGpuError",
    "OutOfMemoryError",
    "PointDistances",
    "Proximity",
    "Skeleton",
    "Surface",
    "ThicknessRegion",
    "curves",
    "distance",
    "distance_field",
    "local_thickness",
    "medial_axis",
    "proximity",
    "read_mesh",
    "read_scan",
    "reconstruction",
    "scan_surface",
    "skeleton",
    "thickness",
    "thickness_regions",
    "update",
    "vtkDistributedFieldAlgorithm",
    "vtkMedialAxis",
    "vtkMedialCurves",
    "vtkMedialLocalThickness",
    "vtkMedialPolyDataAlgorithm",
    "vtkMedialReconstruction",
    "vtkMedialSkeleton",
    "vtkMedialThickness",
    "vtkMeshDistanceField",
    "vtkMeshFieldAlgorithm",
    "vtkMeshPointDistance",
    "vtkMeshProximity",
]
