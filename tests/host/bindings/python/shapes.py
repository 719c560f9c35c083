"""Meshes for the tests."""
import numpy as np

CUBE = np.array([(x, y, z) for z in (0, 10) for y in (0, 10) for x in (0, 10)])
# Counterclockwise as seen from outside.
CUBE_FACES = np.array([(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)])


def many_boxes(side):
    """side * side boxes on a grid: vertices and faces."""
    x, z = np.meshgrid(np.arange(side), np.arange(side), indexing="ij")
    x, z = x.reshape(-1), z.reshape(-1)
    low = np.stack([3 * x, 0 * x, 3 * z], axis=1)
    size = np.stack([2 + 0 * x, 1 + (x * 7 + z * 5) % 4, 2 + 0 * x], axis=1)
    vertices = low[:, None] + size[:, None] * (CUBE // 10)
    faces = 8 * np.arange(side * side)[:, None, None] + CUBE_FACES
    return vertices.reshape(-1, 3), faces.reshape(-1, 4)
