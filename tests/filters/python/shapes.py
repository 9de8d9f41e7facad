"""Meshes with known distance fields and axes."""

import numpy as np

# Half sides of the box; all different, and so are the numbers of samples along the axes.
HALF = np.array([1.0, 0.75, 0.5])

# Corners of a cube of half side 1, the last coordinate fastest; its sides face outwards.
_CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
_SIDES = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1],
                   [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])


def box(half=HALF):
    """Vertices and quads of a box around the origin."""
    return _CORNERS * half, _SIDES


def box_distance(points, half=HALF):
    """Exact signed distances to that box."""
    excess = np.abs(points) - half
    outside = np.linalg.norm(np.maximum(excess, 0.0), axis=-1)
    return outside + np.minimum(excess.max(axis=-1), 0.0)


def ball(subdivisions, radius=1.0):
    """Vertices, all at the radius, and triangles of a ball around the origin."""
    vertices = [[radius, 0, 0], [-radius, 0, 0], [0, radius, 0],
                [0, -radius, 0], [0, 0, radius], [0, 0, -radius]]
    faces = [[a, b, c] if (a + b + c) % 2 == 0 else [a, c, b]
             for a in (0, 1) for b in (2, 3) for c in (4, 5)]
    for _ in range(subdivisions):
        middles = {}

        def middle(i, j):
            if (min(i, j), max(i, j)) not in middles:
                point = np.add(vertices[i], vertices[j])
                middles[min(i, j), max(i, j)] = len(vertices)
                vertices.append(point * (radius / np.linalg.norm(point)))
            return middles[min(i, j), max(i, j)]

        finer = []
        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        faces = finer
    return np.array(vertices, dtype=float), np.array(faces)


def signed_volume(vertices, faces):
    """Positive where the triangles of a closed surface face outwards."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6.0


def area(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()) / 2.0
