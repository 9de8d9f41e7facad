"""Distances from points to shapes by brute force, which share nothing with the program's."""

import math


def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def to_segment(a, b):
    """The squared distance from the origin."""
    along = subtract(b, a)
    length = dot(along, along)
    share = min(1.0, max(0.0, -dot(a, along) / length)) if length > 0 else 0.0
    nearest = (a[0] + share * along[0], a[1] + share * along[1], a[2] + share * along[2])
    return dot(nearest, nearest)


def to_triangle(a, b, c):
    """The squared distance from the origin. A triangle too flat for a normal is its edges."""
    edges = min(to_segment(a, b), to_segment(b, c), to_segment(c, a))
    ab, bc, ca = subtract(b, a), subtract(c, b), subtract(a, c)
    normal = cross(ab, bc)
    area = dot(normal, normal)
    longest = max(dot(ab, ab), dot(bc, bc), dot(ca, ca))
    if area <= 1e-24 * longest * longest:
        return edges
    inside = all(dot(cross(along, corner), normal) <= 0 for along, corner in ((ab, a), (bc, b), (ca, c)))
    return min(edges, dot(normal, a)**2 / area) if inside else edges


def distance(shape, size, query):
    """From a point to the nearest cell; `size` is the unit that keeps squares in range."""
    best = math.inf
    for cell in shape.cells:
        corners = [tuple((shape.points[i][axis] - query[axis]) / size for axis in range(3)) for i in cell]
        if len(corners) == 3:
            best = min(best, to_triangle(*corners))
        elif len(corners) == 2:
            best = min(best, to_segment(*corners))
        else:
            best = min(best, dot(corners[0], corners[0]))
    return size * math.sqrt(best)
