"""Writes docs/benchmarks/gpu.md: what medial-device-speed and the engines' tests have found.

usage: gpu_page.py SPEED.json TESTS.txt PAGE.md
"""

import json
import os
import re
import sys
from pathlib import Path

TARGETS = """\
| case | target on an H100 or H200 |
|---|---|
| gargoyle, 256, on the device | <= 2 ms |
| the same, distance and site on the host | <= 15 ms |
| gargoyle, 1024, on the device | <= 60 ms |
| armadillo 52K and dragon 202K, 256, on the device | <= 5 and <= 15 ms |
| gargoyle, 256, the host's own work (CPU time outside OpenGL's thread, nothing stored) | <= 2 ms |
| against the processor engine of the same machine | >= 10 times |
"""


def milliseconds(seconds):
    return f"{1000 * seconds:.2f}" if seconds < 0.1 else f"{1000 * seconds:.0f}"


def speed_table(cases):
    lines = ["| mesh | triangles | grid | processor, ms | device, ms | of it on the device, ms | times as fast | "
             "max difference, voxels |", "|---|--:|---|--:|--:|--:|--:|--:|"]
    for case in cases:
        processor, device = case["processor"]["seconds"], case["device"]["seconds"]
        lines.append(f"| {Path(case['mesh']).stem} | {case['triangles']:,} | "
                     f"{' x '.join(map(str, case['dimensions']))} | {milliseconds(processor)} | "
                     f"{milliseconds(device)} | {milliseconds(case['device']['device']['resident'])} | "
                     f"{processor / device:.2g} | {case['max_difference_voxels']:.1g} |")
    return "\n".join(lines)


def phase_table(cases):
    phases = ("sites", "cull", "evaluate", "resolve", "copy")
    lines = ["| mesh, longest side | " + " | ".join(phases) + " |", "|---|" + "--:|" * len(phases)]
    for case in cases:
        seconds = case["device"]["device"]
        lines.append(f"| {Path(case['mesh']).stem}, {max(case['dimensions'])} | "
                     + " | ".join(milliseconds(seconds[phase]) for phase in phases) + " |")
    return "\n".join(lines)


def work_table(cases):
    lines = ["| mesh, longest side | evaluations a point, device | processor | bytes up a vertex | "
             "bytes back a point | dispatches | CPU, ms | host's own, ms |",
             "|---|--:|--:|--:|--:|--:|--:|--:|"]
    for case in cases:
        device = case["device"]
        points = case["dimensions"][0] * case["dimensions"][1] * case["dimensions"][2]
        lines.append(f"| {Path(case['mesh']).stem}, {max(case['dimensions'])} | "
                     f"{device['evaluations_per_point']:.1f} | "
                     f"{case['processor']['evaluations_per_point']:.1f} | "
                     f"{device['bytes_uploaded'] / case['vertices']:.1f} | "
                     f"{device['bytes_read_back'] / points:.2f} | {device['dispatches']} | "
                     f"{milliseconds(device['processor_seconds'])} | "
                     f"{milliseconds(case['host_seconds']['resident'])} |")
    return "\n".join(lines)


def tests_line(text):
    passed = sum(map(int, re.findall(r"\[  PASSED  \] (\d+) test", text)))
    failed = sum(map(int, re.findall(r"^ *(\d+) FAILED TEST", text, re.MULTILINE)))
    return f"{passed} tests of the engines passed, {failed} failed."


def page(speed, tests):
    device = f"{speed['renderer']}, OpenGL {speed['version']}"
    software = ("\n**This is a software renderer**: the figures rehearse the benchmark and say nothing about a GPU.\n"
                if speed["software"] else "")
    cases = speed["cases"]
    return f"""# The engine `device` on a GPU

`scripts/benchmark gpu` wrote this page. Device: {device}; {os.cpu_count()} cores.
{software}
{tests_line(tests)}

Frames of a mesh that moves, unsigned distances and closest sites, medians after half a second of others. *Device* is
the wall-clock time of a frame with both arrays on the host, *on the device* what the device's own clock says without
the copy.

{speed_table(cases)}

Phases on the device by its clock, ms:

{phase_table(cases)}

{work_table(cases)}

## Targets

{TARGETS}"""


def main():
    speed, tests, output = map(Path, sys.argv[1:4])
    output.write_text(page(json.loads(speed.read_text()), tests.read_text()))


if __name__ == "__main__":
    main()
