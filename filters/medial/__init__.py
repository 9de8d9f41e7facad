"""Distance fields and medial axes of meshes, as VTK filters.

The filters are used as those of VTK's own Python package:

    import medial
    axis = medial.vtkMedialAxis()

help(medial.vtkMedialAxis) prints the manual of the class.
"""

from .vtkMedialFilters import (
    vtkMedialAxis,
    vtkMedialCurves,
    vtkMeshDistanceField,
    vtkMeshFieldAlgorithm,
)

__all__ = ["vtkMedialAxis", "vtkMedialCurves", "vtkMeshDistanceField", "vtkMeshFieldAlgorithm"]
