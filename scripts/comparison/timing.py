"""Times of two builds for scripts/compare-outputs."""

import json
import statistics
import sys
import time

TIMED = {
    "axis": "medial-axis MESH --engine processor --resolution 256 -o axis.vtp --report report.json",
    "field": "medial-axis MESH --engine processor --resolution 256 --field field.vti "
             "--report report.json"}


class Timing:
    """Times two builds by turns."""

    def __init__(self, old, new, runs, folder):
        self.builds, self.runs, self.folder = (old, new), runs, folder

    def timed(self, build, command, mesh):
        """Seconds of the whole run, and of computing alone."""
        started = time.monotonic()
        done = build.run(command, mesh, self.folder)
        seconds = time.monotonic() - started
        if done.returncode:
            sys.exit(f"{mesh}: {done.stderr}")
        phases = json.loads((self.folder / "report.json").read_text())["seconds"]
        return seconds, sum(phases[name] for name in phases if name not in ("read", "write", "total"))

    def compare(self, meshes):
        print("Seconds of the whole run and of computing alone: medians of old and new; ratio new / old: "
              "median of the pairs (min to max), and that of the two shortest times")
        for mesh in meshes:
            link = self.folder / f"mesh{mesh.suffix}"
            link.symlink_to(mesh.resolve())
            for output, command in TIMED.items():
                for build in self.builds:  # files into memory
                    self.timed(build, command, mesh)
                pairs = []
                for run in range(self.runs):
                    order = (0, 1) if run % 2 == 0 else (1, 0)
                    times = {i: self.timed(self.builds[i], command, mesh) for i in order}
                    pairs.append((times[0], times[1]))
                print(f"{mesh.name:30} {output:6}" + "".join(
                    f"  {title} {self.summary([(old[i], new[i]) for old, new in pairs])}"
                    for i, title in enumerate(("whole", "computing"))), flush=True)
            link.unlink()

    @staticmethod
    def summary(pairs):
        old, new = (statistics.median(times) for times in zip(*pairs))
        ratios = [after / before for before, after in pairs]
        return (f"{old:.3f} {new:.3f} {statistics.median(ratios):.3f} "
                f"({min(ratios):.2f} to {max(ratios):.2f}) "
                f"{min(new for _, new in pairs) / min(old for old, _ in pairs):.3f}")
