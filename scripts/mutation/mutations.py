"""Random changes of mesh files. Each returns the content of a file, and its extension."""

import math
import struct

from comparison.meshes import TEXTS
from mutation.shapes import Shape

WORDS = [b"0", b"-1", b"1", b"4294967295", b"2147483648", b"9223372036854775807", b"99999999999999999999", b"nan",
         b"-inf", b"1e39", b"1e300", b"1e-300", b"1e400", b"0x10", b"+", b"\x00", b"\xff", b"-0", b"3 0 0 0", b"#", b"\\\n"]


def random_place(content, random):
    return random.randrange(len(content) + 1)


def change_bytes(content, random):
    result = bytearray(content)
    for _ in range(random.choice((1, 1, 2, 8, 64))):
        result[random.randrange(len(result))] = random.randrange(256)
    return bytes(result)


def change_header_bytes(content, random):
    result = bytearray(content)
    for _ in range(random.choice((1, 2, 4))):
        result[random.randrange(min(600, len(result)))] = random.randrange(256)
    return bytes(result)


def insert_word(content, random):
    place = random_place(content, random)
    return content[:place] + random.choice(WORDS) + content[place:]


def replace_number(content, random):
    """A number of a text becomes another; of a binary file, any byte that looks like a digit."""
    digits = [i for i, byte in enumerate(content[:4000]) if 48 <= byte <= 57]
    place = random.choice(digits) if digits and random.random() < 0.5 else random.randrange(len(content))
    end = place
    while end < len(content) and content[end] in b"0123456789.eE+-":
        end += 1
    while place > 0 and content[place - 1] in b"0123456789.eE+-":
        place -= 1
    return content[:place] + random.choice(WORDS) + content[max(end, place + 1):]


def cut_out(content, random):
    place = random_place(content, random)
    return content[:place] + content[place + random.choice((1, 2, 4, 100, len(content))):]


def repeat(content, random):
    place = random_place(content, random)
    end = min(len(content), place + random.choice((1, 4, 100, 10000)))
    return content[:end] + content[place:]


def set_words(content, random):
    """Four bytes, where a binary file may keep a count, an index or a number, get a value of effect."""
    place = random.randrange(max(1, len(content) - 3))
    value = random.choice((0, 1, 0xFFFFFFFF, 0x7FFFFFFF, 0x7FC00000, 0x7F800000, 0xFF7FFFFF, 1 << 20))
    return content[:place] + struct.pack(random.choice("<>") + "I", value) + content[place + 4:]


BYTE_MUTATIONS = [change_bytes, change_header_bytes, insert_word, replace_number, cut_out, repeat, set_words]


def any_point(shape, random):
    return random.randrange(len(shape.points))


def odd_coordinates(shape, random):
    value = random.choice((math.nan, math.inf, -math.inf, 1e300, 1e19, 1e17, 1e-300))
    for _ in range(random.choice((1, 3))):
        point = list(shape.points[any_point(shape, random)])
        point[random.randrange(3)] = value
        shape.points[any_point(shape, random)] = tuple(point)


def odd_indices(shape, random):
    cell = random.choice(shape.cells)
    cell[random.randrange(len(cell))] = random.choice((-1, len(shape.points), 2**31, 2**63 - 1, any_point(shape, random)))


def flip(shape, random):
    share = random.choice((0.01, 0.1, 0.5, 1.0))
    for cell in shape.cells:
        if random.random() < share:
            cell.reverse()


def duplicate(shape, random):
    copies = [list(random.choice(shape.cells)) for _ in range(random.choice((1, 10, len(shape.cells))))]
    shape.cells += copies


def collapse(shape, random):
    """Corners of some faces move to another corner, or between two others."""
    for cell in random.sample(shape.cells, min(len(shape.cells), random.choice((1, 5, 50)))):
        a, b, c = (shape.points[i] for i in (cell * 3)[:3])
        share = random.choice((0.0, 1.0, random.random()))
        shape.points[cell[0]] = tuple(b[axis] + share * (c[axis] - b[axis]) for axis in range(3)) if a else a


def scale(shape, random):
    factor = 10.0**random.uniform(-30, 30)
    stretch = [factor, factor, factor]
    if random.random() < 0.3:
        stretch[random.randrange(3)] *= 10.0**random.uniform(-8, 0)
    shape.points = [tuple(x * f for x, f in zip(point, stretch)) for point in shape.points]


def shift(shape, random):
    sizes = [max(point[axis] for point in shape.points) - min(point[axis] for point in shape.points) for axis in range(3)]
    unit = random.choice((1.0, max(sizes)))
    by = [random.choice((0.0, 1e7, -1e7)) * unit for _ in range(3)]
    shape.points = [tuple(x + d for x, d in zip(point, by)) for point in shape.points]


def remove_faces(shape, random):
    share = random.choice((0.001, 0.1, 0.9))
    kept = [cell for cell in shape.cells if random.random() >= share]
    shape.cells = kept or shape.cells


def add_faces(shape, random):
    for _ in range(random.choice((1, 10))):
        shape.cells.append([any_point(shape, random) for _ in range(3)])


SHAPE_MUTATIONS = [odd_coordinates, odd_indices, flip, duplicate, collapse, scale, shift, remove_faces, add_faces]


def single(value):
    """Rounded to single precision, as STL files are read."""
    return struct.unpack("f", struct.pack("f", value))[0] if abs(value) < 3.4e38 else value


def mutate_bytes(content, suffix, random):
    for _ in range(random.choice((1, 1, 1, 3))):
        content = random.choice(BYTE_MUTATIONS)(content, random) or b" "
    return content, suffix


def mutate_shape(shape, random):
    """One to three changes of the shape, then a text file of any format, and the shape that it has."""
    changed = Shape(list(shape.points), [list(cell) for cell in shape.cells if len(cell) == 3])
    for _ in range(random.choice((1, 1, 2, 3))):
        random.choice(SHAPE_MUTATIONS)(changed, random)
    suffix = random.choice(list(TEXTS))
    sound = all(0 <= i < len(changed.points) for cell in changed.cells for i in cell)
    if suffix == ".stl" and not sound:
        suffix = ".off"
    if suffix == ".stl":
        changed.points = [tuple(single(x) for x in point) for point in changed.points]
    return TEXTS[suffix](changed.points, changed.cells).encode(), suffix, changed
