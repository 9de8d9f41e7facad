"""Prints matrices that bring a copy of a mesh along z, and away again, a line for each frame.

usage: moving_copy.py FRAMES FROM TO

The copy is shifted by FROM in the first frame, by TO in the middle, and by FROM in the last. Its file
is for medial-proximity, with one mesh twice:

  moving_copy.py 30 1.2 0.3 > path.txt
  medial-proximity MESHES MESHES --sequence --transform 1=path.txt --animation pictures
"""

import math
import sys


def matrix(shift):
    return f"1,0,0,0,0,1,0,0,0,0,1,{shift:.6g}"


def main(frames, start, end):
    for frame in range(frames):
        nearness = 0.5 - 0.5 * math.cos(2 * math.pi * frame / max(frames - 1, 1))
        print(matrix(start + nearness * (end - start)))


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    try:
        main(int(sys.argv[1]), float(sys.argv[2]), float(sys.argv[3]))
    except ValueError as error:
        sys.exit(f"moving_copy.py: {error}")
