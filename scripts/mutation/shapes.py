"""Shapes that scripts/mutate-meshes changes: points and cells, read from the text formats and from binary STL."""

import struct

MAX_INDEX = 10**9


class Shape:
    """Points, and cells as lists of their ids: three for a triangle, two for a line, one for a vertex."""

    def __init__(self, points, cells):
        self.points, self.cells = points, cells

    def sound(self):
        """Whether every cell has its points, and they are finite."""
        count = len(self.points)
        limit = 1e300
        return all(0 <= i < count and all(abs(x) < limit for x in self.points[i])
                   for cell in self.cells for i in cell)


def read_obj(text):
    """The shape of an OBJ text; None for what this reader does not know, larger polygons among it."""
    if "\\" in text:
        return None
    points, cells = [], []
    for line in text.split("\n"):
        words = line.split("#")[0].split()
        if words[:1] == ["v"]:
            points.append(tuple(float(word) for word in words[1:4]))
        elif words[:1] and words[0] in "flp":
            ids = [int(word.split("/")[0]) for word in words[1:]]
            cell = [i - 1 if i > 0 else len(points) + i for i in ids]
            if words[0] == "p":
                cells += [[i] for i in cell]
            elif words[0] == "l":
                cells += [list(pair) for pair in zip(cell, cell[1:])]
            elif len(cell) <= 3:
                cells.append(cell)
            else:
                return None
    return Shape(points, cells)


def read_off(text):
    """The shape of an OFF text; None for larger polygons."""
    rows = [words for words in (line.split("#")[0].split() for line in text.split("\n")) if words]
    start = 1
    counts = rows[0][1:]
    if not counts:
        counts, start = rows[1], 2
    if not rows[0][0].endswith("OFF") or len(counts) < 2:
        return None
    point_count, face_count = int(counts[0]), int(counts[1])
    points = [tuple(float(word) for word in row[:3]) for row in rows[start:start + point_count]]
    faces = rows[start + point_count:start + point_count + face_count]
    if len(points) != point_count or len(faces) != face_count:
        return None
    cells = [[int(word) for word in row[1:1 + int(row[0])]] for row in faces]
    return Shape(points, cells) if all(0 < len(cell) <= 3 for cell in cells) else None


def read_stl(content):
    """The shape of a binary STL file; None for other files."""
    if len(content) < 84 or len(content) != 84 + 50 * struct.unpack_from("<I", content, 80)[0]:
        return None
    points = []
    for start in range(84, len(content), 50):
        values = struct.unpack_from("<9f", content, start + 12)
        points += [values[:3], values[3:6], values[6:]]
    return Shape(points, [[i, i + 1, i + 2] for i in range(0, len(points), 3)])


def read_shape(suffix, content):
    """The shape of a file; None if this module cannot be sure to read it as the program does."""
    try:
        if suffix == ".stl":
            shape = read_stl(content)
        else:
            reader = {".obj": read_obj, ".off": read_off}[suffix]
            shape = reader(content.decode("ascii"))
    except (KeyError, ValueError, IndexError):
        return None
    whole = shape is not None and all(len(point) == 3 for point in shape.points)
    return shape if whole and shape.cells and shape.sound() else None
