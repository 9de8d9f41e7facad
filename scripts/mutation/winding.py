"""Inside and outside by winding numbers and brute force, which share nothing with the program's."""

import collections
import math

from mutation.distance import cross, dot, subtract


def edges_of(triangle):
    return zip(triangle, triangle[1:] + triangle[:1])


def welded(shape):
    """Points, and triangles without copies; None if a cell is no triangle of three different points."""
    ids = {}
    for point in shape.points:
        ids.setdefault(point, len(ids))
    cells = [tuple(ids[shape.points[i]] for i in cell) for cell in shape.cells]
    if not all(len(set(cell)) == 3 == len(cell) for cell in cells):
        return None
    first = {}
    for cell in cells:
        first.setdefault(tuple(sorted(cell)), cell)
    return list(ids), list(first.values())


def neighbours_of(triangles):
    """For every triangle the others at its edges, each with -1 if it runs the other way round, and 1; and
    whether all edges have two triangles."""
    sharers = collections.defaultdict(list)
    for number, triangle in enumerate(triangles):
        for a, b in edges_of(triangle):
            sharers[min(a, b), max(a, b)].append((number, a < b))
    result = [[] for _ in triangles]
    for sharing in sharers.values():
        if len(sharing) == 2:
            (one, upwards), (other, also_upwards) = sharing
            sense = -1 if upwards == also_upwards else 1
            result[one].append((other, sense))
            result[other].append((one, sense))
    return result, all(len(sharing) == 2 for sharing in sharers.values())


def senses_of(neighbours):
    """For every triangle 1 or -1, so that neighbours agree; None if they cannot, or are not connected."""
    senses, waiting = {0: 1}, [0]
    while waiting:
        number = waiting.pop()
        for other, sense in neighbours[number]:
            if other not in senses:
                senses[other] = senses[number] * sense
                waiting.append(other)
            elif senses[other] != senses[number] * sense:
                return None
    return [senses[number] for number in range(len(neighbours))] if len(senses) == len(neighbours) else None


def oriented_surface(shape, size):
    """The triangles of a single patch as corners, which face the way the program's documents say; None for
    other shapes, and where this module cannot be sure. `size` is the unit that keeps products in range."""
    found = welded(shape)
    if found is None:
        return None
    points, triangles = found
    neighbours, closed = neighbours_of(triangles)
    senses = senses_of(neighbours)
    if senses is None:
        return None
    origin = points[triangles[0][0]]
    surface = [[tuple(x / size for x in subtract(points[i], origin)) for i in triangle] for triangle in triangles]
    areas = [math.sqrt(dot(normal, normal)) for normal in
             (cross(subtract(b, a), subtract(c, a)) for a, b, c in surface)]
    most = sum(area * sense for area, sense in zip(areas, senses))
    if abs(most) < 1e-3 * sum(areas):
        return None
    volume = sum(sense * dot(a, cross(b, c)) for sense, (a, b, c) in zip(senses, surface))
    if most < 0:
        senses, volume = [-sense for sense in senses], -volume
    if volume < 0:
        if not closed:
            return None  # it may enclose a solid up to small holes, or not
        senses = [-sense for sense in senses]
    return [([points[i] for i in triangle], sense) for triangle, sense in zip(triangles, senses)]


def winding_number(surface, query, size):
    """The sum of the solid angles of triangles over 4 pi (van Oosterom, Strackee 1983)."""
    total = 0.0
    for corners, sense in surface:
        a, b, c = (tuple(x / size for x in subtract(corner, query)) for corner in corners)
        la, lb, lc = (math.sqrt(dot(v, v)) for v in (a, b, c))
        cosines = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb
        total += sense * math.atan2(dot(a, cross(b, c)), cosines)
    return total / (2 * math.pi)
