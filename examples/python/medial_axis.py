"""Writes the medial axis and the distance field of a surface, by a pipeline of VTK's filters.

usage: medial_axis.py INPUT.stl AXIS.vtp FIELD.vti

The folder of the package must be on PYTHONPATH unless Medial is installed where Python looks.
"""

import sys

import medial
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter


def main(surface_file, axis_file, field_file):
    reader = vtkSTLReader()
    reader.SetFileName(surface_file)

    axis = medial.vtkMedialAxis()
    axis.SetInputConnection(reader.GetOutputPort())
    axis.SetResolution(64)
    axis.SetAngle(60.0)
    axis.GenerateDistanceFieldOn()  # output port 1
    medial.update(axis)  # as axis.Update(), but raises an exception if it or the reader fails

    for port, writer, name in ((0, vtkXMLPolyDataWriter(), axis_file),
                               (1, vtkXMLImageDataWriter(), field_file)):
        writer.SetInputConnection(axis.GetOutputPort(port))
        writer.SetFileName(name)
        medial.update(writer)
    figures = axis.GetOutput().GetFieldData()  # how the output was made
    print(axis.GetOutput().GetNumberOfCells(), "cells, computed by the engine",
          figures.GetAbstractArray("Engine").GetValue(0))
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    try:
        sys.exit(main(*sys.argv[1:]))
    except medial.Error as error:
        sys.exit(f"medial_axis.py: {error}")
