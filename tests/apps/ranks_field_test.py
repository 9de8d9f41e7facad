"""medial-axis as several processes: fields with the bits of one process.

usage: ranks_field_test.py MPIRUN MEDIAL-AXIS FAILING-ALLOCATIONS
"""

import re
import struct
import sys
import unittest

from rank_runs import SINGLE, RankTest, torn_torus, torus

BYTES = {"Distance": 4, "ClosestPoint": 12, "ClosestCell": 8, "ClosestFeature": 1, "ClosestSite": 4}


class Image:
    """A .vti file of a field."""

    def __init__(self, path):
        data = path.read_bytes()
        start = data.index(b'encoding="raw">\n   _') + len(b'encoding="raw">\n   _')
        header = data[:start].decode()
        self.extent = [int(x) for x in re.search(r'<Piece Extent="([^"]*)"', header).group(1).split()]
        self.arrays = {}
        for name, offset in re.findall(r'Name="(\w+)"[^>]*offset="(\d+)"', header):
            first = start + int(offset)
            size = struct.unpack_from("<Q", data, first)[0]
            self.arrays[name] = data[first + 8:first + 8 + size]

    def rows(self):
        """Points of rows along x, by where they begin, and their values of all arrays."""
        x0, x1, y0, y1, z0, z1 = self.extent
        count, at = x1 - x0 + 1, 0
        for z in range(z0, z1 + 1):
            for y in range(y0, y1 + 1):
                yield (x0, y, z), count, {name: values[at * BYTES[name]:(at + count) * BYTES[name]]
                                          for name, values in self.arrays.items()}
                at += count


class RanksField(RankTest):
    def expect_values_of_one(self, sources):
        """Pieces with the values of one.vti, and together all of them."""
        whole = {begin: values for begin, _, values in Image(self.folder / "one.vti").rows()}
        seen = set()
        for source in sources:
            for (x, y, z), count, values in Image(self.folder / source).rows():
                for name, part in values.items():
                    size = BYTES[name]
                    self.assertEqual(part, whole[0, y, z][name][x * size:(x + count) * size], (source, name))
                seen.update((i, y, z) for i in range(x, x + count))
        self.assertEqual(len(seen), sum(len(values["ClosestFeature"]) for values in whole.values()))

    def expect_same_bits(self, ranks, *options):
        self.run_well(1, "torus.off", "--field", "one.vti", "-q", *SINGLE, *options)
        several = self.run_well(ranks, "torus.off", "--field", "many.pvti", *SINGLE, *options)
        self.assertIn(f"on {ranks} processes", several.stdout)
        index = (self.folder / "many.pvti").read_text()
        pieces = re.findall(r'<Piece Extent="([^"]*)" Source="([^"]*)"', index)
        for extent, source in pieces:
            self.assertEqual(" ".join(map(str, Image(self.folder / source).extent)), extent)
        self.expect_values_of_one(source for _, source in pieces)
        return len(pieces)

    def test_two_ranks_write_the_field_of_one(self):
        self.assertEqual(self.expect_same_bits(2, "--resolution", "45", "--sign", "pseudonormal"), 2)

    def test_seven_ranks_write_the_field_of_one(self):
        self.assertEqual(self.expect_same_bits(7, "--resolution", "60", "--sign", "none"), 7)

    def test_more_ranks_than_parts_of_the_grid(self):
        self.assertLess(self.expect_same_bits(7, "--resolution", "14", "--sign", "pseudonormal"), 7)

    def test_a_surface_inside_out(self):
        points, faces = torus()
        self.write(points, [face[::-1] for face in faces])
        self.expect_same_bits(3, "--resolution", "33", "--sign", "pseudonormal")

    def test_a_mesh_with_holes_by_winding_numbers(self):
        self.write(*torn_torus())
        self.expect_same_bits(2, "--resolution", "33")  # auto finds them

    def test_field_and_axis_at_once(self):
        options = ("--resolution", "40", "--sign", "pseudonormal", "-q", *SINGLE)
        self.run_well(1, "torus.off", "--field", "one.vti", "-o", "one.ply", *options)
        self.run_well(3, "torus.off", "--field", "many.pvti", "-o", "many.ply", *options)
        self.expect_same_file("many.ply", "one.ply")
        self.expect_values_of_one(path.name for path in self.folder.glob("many_*.vti"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
