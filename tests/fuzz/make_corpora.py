#!/usr/bin/python3
"""Writes the seeds of the fuzzers: small files of every format, whole ones and damaged ones.

usage: make_corpora.py [FOLDER]     FOLDER: tests/fuzz/corpora if it is left out

The files are part of the project; this script is how they were made. Needs
VTK's Python package, for VTP files.
"""

import gzip
import struct
import sys
import zlib
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkFloatArray, vtkIntArray, vtkPoints, vtkShortArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter

POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]


def words(rows):
    return "".join(" ".join(str(value) for value in row) + "\n" for row in rows)


def stl_seeds():
    corners = [[POINTS[i] for i in face] for face in FACES]
    facets = "".join("facet normal 0 0 0\nouter loop\n" + words(("vertex", *p) for p in face) + "endloop\nendfacet\n"
                     for face in corners)
    text = f"solid s\n{facets}endsolid s\n"
    binary = bytes(80) + struct.pack("<I", 4)
    for face in corners:
        binary += struct.pack("<12f", 0, 0, 0, *(value for p in face for value in p)) + bytes(2)
    yield "text", text
    yield "two-solids", text.upper() + text.replace("\n", "\r\n")
    yield "odd-numbers", text.replace("vertex 1 0 0", "vertex +1e-40 nan -inf")
    yield "binary", binary
    yield "binary-short", binary[:-30]
    yield "binary-none", bytes(84)
    yield "text-cut", text[:150]
    yield "text-bad-number", text.replace("vertex 1 0 0", "vertex 1 x 0", 1)
    yield "text-bad-word", text.replace("endloop", "endlop", 1)
    yield "text-no-end", text.replace("endsolid s", "")
    yield "text-no-solid", "solid s\nendsolid\nfacet\n"
    yield "neither", "facet normal 0 0 0\n"


def obj_seeds():
    text = words(("v", *p) for p in POINTS) + words(("f", *(i + 1 for i in face)) for face in FACES)
    yield "plain", text
    yield "everything", ("# comment\no s\nvt 0 0\nvn 0 0 1\n" + text + "f -4/1/1 -3//1 -2/1 \\\n -1\n"
                         "l 1 2 3\np 1 4\nf 1 2\nusemtl m\nv +1e0 nan inf # end")
    yield "far-index", text + "f 1 2 99\n"
    yield "no-index", text + "f 1 2 x\nf 0 1 2\n"
    yield "back-too-far", text + "f -1 -2 -9\n"
    yield "no-corner", text + "f\n"
    yield "bad-number", "v 0 0 zero\n"
    yield "no-cells", "v 0 0 0\n"
    polygon = "".join(f"v {x} {y} 0\n" for x, y in [(0, 0), (2, 0), (2, 2), (1, 0.5), (0, 2), (0.2, 1)])
    yield "concave", polygon + "f 1 2 3 4 5 6\nf 1 2 3 4\nf 1 2 1 2 1\nf 1 1 1\nf 1 2 2\n"


def axis_obj_seeds():
    points = "".join("v %g %g %g\n# radius %g\n" % (*p, 0.5 + 0.25 * i) for i, p in enumerate(POINTS))
    yield "axis", points + "f 1 2 3\nf 1 2 3 4\nf 1 2 3 4 1\nl 1 4\np 2\n"
    yield "no-radius", points + "v 1 1 1\nf 1 2 3\n"
    yield "two-without", "v 1 1 1\nv 2 2 2\n# radius 1\n"
    yield "bad-radius", "v 1 1 1\n# radius -1\n"
    yield "nan-radius", "v 1 1 1\n# radius nan\np 1\n"
    yield "not-finite", "v 1 1 inf\n# radius 1\np 1\n"
    yield "other-comments", "# radius 3\n" + points + "# nothing\n#\np 1 2\n"
    yield "empty", "# nothing\n"


def off_seeds():
    text = f"4 4 6\n{words(POINTS)}{words((3, *face) for face in FACES)}"
    yield "plain", "OFF\n" + text
    yield "coloured", "COFF # colours\n2 2 0\n0 0 0 255 0 0\n1 0 0 1 1 1\n2 0 1 9 9 9\n1 0\n"
    yield "four-dimensional", "4OFF\n" + text
    yield "binary", "OFF BINARY\n"
    yield "no-off", "FFO\n"
    yield "few-points", "OFF\n9 1 0\n0 0 0\n"
    yield "few-faces", "OFF\n1 5 0\n0 0 0\n1 0\n"
    yield "few-corners", "OFF\n1 1 0\n0 0 0\n9 0 0\n"
    yield "no-count", "OFF\nx y z\n"
    yield "negative-count", "OFF\n-1 0 0\n"
    yield "bad-number", "OFF\n1 1 0\n0 0 a\n1 0\n"
    yield "far-index", "OFF\n1 1 0\n0 0 0\n3 0 0 7\n"
    yield "no-corners", "OFF\n1 1 0\n0 0 0\n0\n"


PLY_HEADER = ("ply\nformat {} 1.0\ncomment c\nelement vertex 4\nproperty {} x\nproperty {} y\nproperty {} z\n{}"
              "element face 4\nproperty list {} {} vertex_indices\nend_header\n")
PLY_TYPES = {"b": "char", "B": "uchar", "h": "short", "H": "ushort", "i": "int", "I": "uint32", "q": "long",
             "f": "float", "d": "float64"}


def ply_binary(order, real, count, index):
    name = {"<": "binary_little_endian", ">": "binary_big_endian"}[order]
    types = [PLY_TYPES[letter] for letter in (real, real, real)]
    header = PLY_HEADER.format(name, *types, "", PLY_TYPES[count], PLY_TYPES[index])
    body = b"".join(struct.pack(order + 3 * real, *p) for p in POINTS)
    body += b"".join(struct.pack(order + count + 3 * index, 3, *face) for face in FACES)
    return header.encode() + body


def ply_seeds():
    header = PLY_HEADER.format("ascii", "float", "double", "float32", "", "uchar", "int")
    text = header + words(POINTS) + words((3, *face) for face in FACES)
    yield "text", text
    for number, types in enumerate([("<", "f", "B", "i"), (">", "d", "H", "I"), ("<", "b", "i", "h"), (">", "B", "h", "q"),
                                    ("<", "h", "b", "H")]):
        yield f"binary-{number}", ply_binary(*types)
    yield "binary-cut", ply_binary("<", "f", "B", "i")[:-9]
    yield "edges", ("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
                    "property list uchar int other\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
                    "element nothing 9999999999\nend_header\n0 0 0 2 5 6\n1 2 3 0\n0 1\n")
    yield "text-cut", text[:-9]
    yield "no-x", text.replace("float x", "float w")
    yield "no-encoding", text.replace("ascii", "asci")
    yield "no-type", text.replace("double y", "doubl y")
    yield "no-count", text.replace("vertex 4", "vertex -4")
    yield "no-element", "ply\nproperty float x\n"
    yield "no-end", "ply\nformat ascii 1.0\n"
    yield "no-ply", "plx\n"
    yield "far-index", text.replace("3 2 0 3", "3 2 0 9")
    yield "huge-count", text.replace("3 2 0 3", "2e9 2 0 3")
    yield "nan-index", text.replace("3 2 0 3", "3 2 nan 3")
    yield "none", PLY_HEADER.format("ascii", "float", "float", "float", "", "uchar", "int").replace(" 4\n", " 0\n")


def axis_ply_seeds():
    extra = "property float radius\nproperty float separation_angle\nproperty float lambda\n"
    header = PLY_HEADER.format("ascii", "float", "float", "float", extra, "uchar", "int")
    text = header + words((*p, 0.5, 90, 0.1) for p in POINTS) + words((3, *face) for face in FACES)
    yield "axis", text
    yield "no-radius", text.replace("radius", "size")
    yield "no-angle", text.replace("separation_angle", "angle")
    yield "bad-radius", text.replace("0.5 90", "-1 90", 1)
    yield "not-finite", text.replace("1 0 0 0.5", "inf 0 0 0.5")
    yield "far", text.replace("1 0 0 0.5", "1e150 0 0 0.5")
    yield "empty", text.split("element face")[0].replace("vertex 4", "vertex 0") + "end_header\n"


def vtk_seeds():
    head = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\n"
    points = f"POINTS 4 float\n{words(POINTS)}"
    cells = f"POLYGONS 4 16\n{words((3, *face) for face in FACES)}"
    yield "plain", head + points + cells + "POINT_DATA 4\nSCALARS s float\n"
    yield "everything", (head + "FIELD f 2\na 1 1 double\n0.5\nb 2 2 int\n1 2 3 4\n" + points + "METADATA\nINFORMATION 0\n\n"
                         "LINES 1 4\n3 0 1 2\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\nVERTICES 1 2\n1 0\nPOLYGONS 1 1\n0\n")
    offsets = "POLYGONS 3 6\nOFFSETS vtktypeint64\n{}\nCONNECTIVITY vtktypeint64\n0 1 2 1 2 3\n"
    yield "offsets", head.replace("3.0", "5.1") + points + offsets.format("0 3 6")
    yield "offsets-back", head + points + offsets.format("0 6 3")
    yield "offsets-far", head + points + offsets.format("0 3 600000000")
    yield "no-connectivity", head + points + "POLYGONS 2 3\nOFFSETS long\n0 3\nCONECTIVITY\n"
    binary = (head.replace("ASCII", "BINARY") + "POINTS 4 double\n").encode()
    binary += b"".join(struct.pack(">3d", *p) for p in POINTS) + b"\nPOLYGONS 4 16\n"
    binary += b"".join(struct.pack(">4i", 3, *face) for face in FACES)
    yield "binary", binary
    yield "binary-cut", binary[:-6]
    yield "too-many", head + "POINTS 999999999 float\n0 0 0\n"
    yield "few-points", head + "POINTS 20 float\n0 0 0\n"
    yield "no-type", head + "POINTS 1 flt\n0 0 0\n"
    yield "size", head + points + "POLYGONS 1 4\n9 0 1 2\n"
    yield "nan-index", head + points + "POLYGONS 1 4\n3 0 nan 2\n"
    yield "far-index", head + points + "POLYGONS 1 4\n3 0 1e18 2\n"
    yield "keyword", head + "POINT 4 float\n"
    yield "no-encoding", head.replace("ASCII", "ASCI")
    yield "no-dataset", head.replace("DATASET", "DATA")
    yield "grid", head.replace("POLYDATA", "STRUCTURED_GRID")
    yield "no-vtk", "# vtk"


def ma_seeds():
    text = "4 6 1\n" + words(("v", *p, 0.5) for p in POINTS) + "e 0 1\ne 1 2\ne 2 0\ne 0 3\ne 1 3\ne 2 3\nf 0 1 2 additions\n"
    yield "plain", text
    yield "points", "1 0 0\nv 0 0 0 1\n"
    yield "negative-radius", text.replace("0.5", "-1", 1)
    yield "no-radius", text.replace(" 0.5", "", 1)
    yield "no-number", text.replace("v 1 0", "v 1 x")
    yield "no-index", text.replace("e 1 2", "e 1 x")
    yield "far-index", text.replace("f 0 1 2", "f 0 1 9")
    yield "no-count", "4 x\n"
    yield "more", text.replace("4 6 1", "9 6 1")
    yield "fewer", text.replace("4 6 1", "4 6 0")
    yield "keyword", text + "g 0 1\n"
    yield "far", text.replace("v 1 0", "v 1e150 0")
    yield "empty", "0 0 0\n"


def vtp_mesh(axis):
    mesh = vtkPolyData()
    points = vtkPoints()
    radius, cell, run = vtkFloatArray(), vtkDoubleArray(), vtkIntArray()
    radius.SetName("Radius")
    cell.SetName("Heat")
    cell.SetNumberOfComponents(3)
    run.SetName("Run")
    run.InsertNextValue(7)
    for i, point in enumerate(POINTS):
        points.InsertNextPoint(point)
        radius.InsertNextValue(0.5 + 0.25 * i)
    mesh.SetPoints(points)

    def cells(*lists):
        array = vtkCellArray()
        for ids in lists:
            array.InsertNextCell(len(ids), ids)
        return array

    mesh.SetPolys(cells(*FACES, (0, 1, 2, 3)))
    if axis:
        mesh.SetLines(cells((0, 3)))
        mesh.SetVerts(cells((1,)))
        mesh.GetPointData().SetScalars(radius)
    else:
        mesh.SetStrips(cells((0, 1, 2, 3)))
        for i in range(mesh.GetNumberOfCells()):
            cell.InsertNextTuple3(i, 0, 0.5)
        mesh.GetCellData().SetVectors(cell)
        mesh.GetFieldData().AddArray(run)
    return mesh


def vtp_text(mesh, mode, compressor, encode=True, big=False, wide=False):
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(mesh)
    writer.WriteToOutputStringOn()
    writer.SetDataMode(mode)
    writer.SetCompressorType(compressor)
    writer.SetEncodeAppendedData(encode)
    if big:
        writer.SetByteOrderToBigEndian()
    writer.SetHeaderType(64 if wide else 32)
    writer.Write()
    # Raw data may hold zeros, where Python's string would end.
    return writer.GetOutputString()


def vtp_seeds():
    mesh = vtp_mesh(axis=False)
    ascii_, binary, appended = 0, 1, 2
    text = vtp_text(mesh, ascii_, 0)
    yield "text", text
    for name, compressor in (("none", 0), ("zlib", 1), ("lz4", 2), ("lzma", 3)):
        yield f"inline-{name}", vtp_text(mesh, binary, compressor)
        yield f"appended-{name}", vtp_text(mesh, appended, compressor, wide=True)
    yield "big-endian", vtp_text(mesh, binary, 0, big=True)
    raw = raw_vtp()
    yield "raw", raw
    yield "raw-cut", raw[:-60]
    yield "more-points", text.replace('NumberOfPoints="4', 'NumberOfPoints="4000000000')
    yield "more-polys", text.replace('NumberOfPolys="5', 'NumberOfPolys="5000000000')
    yield "no-count", text.replace('NumberOfPolys="5', 'NumberOfPolys="x')
    yield "components", text.replace('NumberOfComponents="3"', 'NumberOfComponents="2"')
    yield "no-components", text.replace('NumberOfComponents="3"', 'NumberOfComponents="x"')
    yield "no-points", text.replace("<Points>", "<Point>").replace("</Points>", "</Point>")
    yield "no-offsets", text.replace('Name="offsets"', 'Name="offset"')
    yield "real-ids", text.replace('type="Int64" Name="connectivity"', 'type="Float32" Name="connectivity"')
    yield "format", text.replace('format="ascii"', 'format="asci"')
    yield "far-offset", text.replace("3 6 9 12 16", "3 6 9 12 1600000000")
    yield "offset-back", text.replace("3 6 9 12 16", "3 9 6 12 16")
    yield "two-pieces", text.replace("</Piece>", "</Piece>" + text[text.index("<Piece"):text.index("</Piece>")] + "</Piece>")
    yield "no-pieces", "<?xml?><VTKFile><!-- a --><!b><PolyData></PolyData></VTKFile>"
    yield "no-polydata", "<VTKFile type='ImageData'/>"
    for number, damage in enumerate(["", "<", "<a", "<a b", "<a b=", "<a b='", "<a b=c>", "<a></b>", "<a><b></a>", "</a>",
                                     "<a/><b/>", "<?x", "<!-- ", "<!a", "<VTKFile><AppendedData>_abc"]):
        yield f"xml-{number}", damage
    zlib = vtp_text(mesh, binary, 1)
    yield "compressor", zlib.replace("vtkZLib", "vtkNone")
    yield "damaged-block", zlib.replace("eJ", "eK")
    yield "damaged-header", zlib.replace("AQAAAA", "AQD/AA").replace("AQAAAACAAA", "AQAAAACA//")
    yield "strings", text.replace('type="Int32" Name="Run"', 'type="String" Name="Run"')
    yield "types", all_types()


def raw_vtp():
    arrays = [struct.pack(">I12f", 48, *(value for p in POINTS for value in p)),
              struct.pack(">I12q", 96, *(i for face in FACES for i in face)), struct.pack(">I4q", 32, 3, 6, 9, 12)]
    offsets = [0, len(arrays[0]), len(arrays[0]) + len(arrays[1])]
    head = ('<VTKFile type="PolyData" version="0.1" byte_order="BigEndian"><PolyData><Piece NumberOfPoints="4" NumberOfPolys="4">'
            '<Points><DataArray type="Float32" NumberOfComponents="3" format="appended" offset="%d"/></Points>'
            '<Polys><DataArray type="Int64" Name="connectivity" format="appended" offset="%d"/>'
            '<DataArray type="Int64" Name="offsets" format="appended" offset="%d"/></Polys></Piece></PolyData>'
            '<AppendedData encoding="raw">\n_') % tuple(offsets)
    return head.encode() + b"".join(arrays) + b"\n</AppendedData></VTKFile>\n"


def all_types():
    arrays = "".join(f'<DataArray type="{kind}" Name="{kind}&lt;&gt;&quot;&apos;&amp;" format="ascii"> 1 2 3 </DataArray>'
                     for kind in ("Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64", "Float32", "Float64"))
    lists = "".join(f'<{kind}><DataArray type="{number}" Name="connectivity" format="ascii">0 1 2</DataArray>'
                    f'<DataArray type="{number}" Name="offsets" format="ascii">3</DataArray></{kind}>'
                    for kind, number in (("Verts", "UInt8"), ("Lines", "Int16"), ("Polys", "UInt32"), ("Strips", "UInt64")))
    ids = '<DataArray type="Int64" IdType="1" Name="ids" NumberOfTuples="2" format="ascii">1 2</DataArray>'
    return (f'<VTKFile><PolyData><FieldData>{ids}</FieldData><Piece NumberOfPoints="3" NumberOfVerts="1" NumberOfLines="1" '
            f'NumberOfPolys="1" NumberOfStrips="1"><PointData Scalars="Int8">{arrays}</PointData><Points><DataArray '
            f'type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>{lists}</Piece>'
            "</PolyData></VTKFile>")


def axis_vtp_seeds():
    mesh = vtp_mesh(axis=True)
    text = vtp_text(mesh, 0, 0)
    yield "axis", text
    yield "inline", vtp_text(mesh, 1, 1)
    yield "no-radius", text.replace("Radius", "Size")
    yield "bad-radius", text.replace("0.5 0.75", "-1 0.75")
    yield "not-finite", text.replace("0 0 0 1 0 0", "0 0 inf 1 0 0")
    yield "empty", "<VTKFile><PolyData><Piece><PointData><DataArray type='Float32' Name='Radius'/></PointData></Piece></PolyData></VTKFile>"


def defects_seeds():
    for number in range(24):
        state = number + 1
        values = bytearray()
        for _ in range(96):
            state = (1103515245 * state + 12345) % 2**31
            values.append(state >> 16 & 255)
        yield f"mesh-{number:02}", bytes(values)


VOXELS = struct.pack("<27h", *(1 if i == 13 else 0 for i in range(27)))


def nrrd_seeds():
    head = ("NRRD0004\n# c\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 3 3 3\n"
            "space directions: (1,0,0) (0,2,0) (0,0,1)\nkinds: domain domain domain\nendian: little\n"
            "encoding: raw\nspace origin: (0,0,0)\nkey:=value\n\n")
    text = " ".join(str(1 if i == 13 else 0) for i in range(27)).encode()
    yield "raw", head.encode() + VOXELS
    yield "big", head.replace("little", "big").encode() + VOXELS
    yield "gzip", head.replace("raw", "gzip").encode() + gzip.compress(VOXELS, mtime=0)
    yield "text", head.replace("raw", "ascii").encode() + text
    yield "spacings", head.replace("space directions: (1,0,0) (0,2,0) (0,0,1)", "spacings: 1 2 nan").encode() + VOXELS
    yield "axis", head.replace("dimension: 3", "dimension: 4").replace("sizes: ", "sizes: 1 ").replace(
        "directions: ", "directions: none ").encode() + VOXELS
    yield "cut", head.encode() + VOXELS[:20]
    yield "beside", head.replace("kinds", "data file: other.raw\nbyte skip: -1\nkinds").encode()
    yield "huge", head.replace("3 3 3", "3000 3000 3000").encode() + VOXELS


def mha_seeds():
    head = ("ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
            "CompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 0 0 0\n"
            "ElementSpacing = 1 2 1\nDimSize = 3 3 3\nElementType = MET_SHORT\nElementDataFile = LOCAL\n")
    yield "raw", head.encode() + VOXELS
    yield "zlib", head.replace("Data = False", "Data = True").encode() + zlib.compress(VOXELS)
    yield "text", head.replace("BinaryData = True", "BinaryData = False").encode() + b"0 " * 13 + b"1" + b" 0" * 13
    yield "four", head.replace("NDims = 3", "NDims = 4").replace("3 3 3", "3 3 3 1").encode() + VOXELS
    yield "channels", head.replace("ElementType", "ElementNumberOfChannels = 2\nElementType").encode() + VOXELS
    yield "list", head.replace("LOCAL", "LIST").encode()
    yield "beside", head.replace("LOCAL", "other.raw").replace("ElementType", "HeaderSize = -1\nElementType").encode()


def nii_seeds():
    head = bytearray(352)
    struct.pack_into("<i", head, 0, 348)
    struct.pack_into("<8h", head, 40, 3, 3, 3, 3, 1, 1, 1, 1)
    struct.pack_into("<2h", head, 70, 4, 16)
    struct.pack_into("<8f", head, 76, 1, 1, 2, 1, 1, 1, 1, 1)
    struct.pack_into("<3f", head, 108, 352, 1, 0)
    head[344:348] = b"n+1\0"
    yield "plain", bytes(head) + VOXELS
    struct.pack_into("<h", head, 252, 1)
    yield "qform", bytes(head) + VOXELS
    struct.pack_into("<h", head, 254, 1)
    struct.pack_into("<12f", head, 280, 1, 0, 0, 5, 0, 2, 0, 5, 0, 0, 1, 5)
    yield "sform", bytes(head) + VOXELS
    struct.pack_into("<2f", head, 112, 0.5, 1)
    yield "scaled", bytes(head) + VOXELS
    struct.pack_into("<8h", head, 40, 4, 3, 3, 3, 2, 1, 1, 1)
    yield "moments", bytes(head) + VOXELS


def vti_seeds():
    image = vtkImageData()
    image.SetDimensions(3, 3, 3)
    values = vtkShortArray()
    values.SetName("Labels")
    for i in range(27):
        values.InsertNextValue(1 if i == 13 else 0)
    image.GetPointData().SetScalars(values)
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    writer.WriteToOutputStringOn()
    for mode in range(3):
        writer.SetDataMode(mode)
        writer.Write()
        yield f"mode-{mode}", writer.GetOutputString()
    yield "extent", writer.GetOutputString().replace('WholeExtent="0 2', 'WholeExtent="0 2000000')


SEEDS = {"nrrd": nrrd_seeds, "mha": mha_seeds, "nii": nii_seeds, "vti": vti_seeds,
         "stl": stl_seeds, "obj": obj_seeds, "ply": ply_seeds, "off": off_seeds, "vtp": vtp_seeds, "vtk": vtk_seeds,
         "ma": ma_seeds, "axis-obj": axis_obj_seeds, "axis-ply": axis_ply_seeds, "axis-vtp": axis_vtp_seeds,
         "defects": defects_seeds}


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent / "corpora"
    for target, seeds in SEEDS.items():
        folder = root / target
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in seeds():
            (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())


if __name__ == "__main__":
    main()
