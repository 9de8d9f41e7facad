"""Builds of Medial for scripts/compare-outputs, and runs of their programs."""

import hashlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


class Build:
    """A folder with programs. `old_words` are the old names of programs and options by the new ones."""

    def __init__(self, programs, old_words):
        self.programs, self.old_words = programs.resolve(), old_words
        if not (self.programs / "medial-axis").exists():
            sys.exit(f"{programs} has no medial-axis")
        self.help = subprocess.run([self.programs / "medial-axis", "--help"], capture_output=True,
                                   text=True, check=True).stdout
        names = {"medial-axis", *old_words, *old_words.values()}
        files = [file for file in sorted(self.programs / name for name in names) if file.exists()]
        self.hash = digest(files + self.libraries())  # tells builds apart

    def libraries(self):
        """Those that were built with the programs."""
        loaded = subprocess.run(["ldd", self.programs / "medial-axis"], capture_output=True, text=True,
                                check=False).stdout
        paths = [Path(path) for path in re.findall(r"=> (/\S+)", loaded)]
        return [path for path in sorted(paths) if self.programs.parent in path.resolve().parents]

    def arguments(self, command, mesh, spacing):
        """The command with the names that this build knows."""
        values = {"MESH": mesh, "SPACING": spacing}
        values.update((new, old) for new, old in self.old_words.items()
                      if not (self.programs / new).exists() and new not in self.help)
        name, *words = (values.get(word, word) for word in command.split())
        return [self.programs / name, *words]

    def run(self, command, mesh, folder):
        """Runs in the folder, where MESH is "mesh" and its suffix; returns exit code and texts."""
        spacing, report = 1, folder / "report.json"
        if "SPACING" in command and report.exists():
            spacing = 1.25 * json.loads(report.read_text())["grid"]["spacing"][0]
        return subprocess.run(self.arguments(command, f"mesh{mesh.suffix}", str(spacing)), cwd=folder,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              errors="replace", check=False)


def digest(files):
    result = hashlib.sha256()
    for file in files:
        content = file.read_bytes()
        result.update(f"{file.name} {len(content)}\n".encode() + content)
    return result.hexdigest()[:24]


def run_set(build, commands, mesh, folder):
    """Leaves the outputs in folder/files, and exit codes and texts in folder/runs.json."""
    files = folder / "files"
    files.mkdir(parents=True)
    link = files / f"mesh{mesh.suffix}"
    link.symlink_to(mesh.resolve())
    runs = []
    for command in commands:
        done = build.run(command, mesh, files)
        runs.append({"command": command, "code": done.returncode, "text": done.stdout + done.stderr})
    link.unlink()
    (folder / "runs.json").write_text(json.dumps(runs))


def git(*arguments):
    return subprocess.run(["git", "-C", ROOT, *arguments], capture_output=True, text=True,
                          check=True).stdout.strip()


def build_commit(commit, old_words):
    """Returns the folder with the programs of a commit, or of the working tree for None."""
    source = ROOT
    if commit:
        commit = git("rev-parse", "--verify", "--short=12", f"{commit}^{{commit}}")
        source = ROOT / "build-compare" / commit
        if not source.exists():
            git("worktree", "prune")
            git("worktree", "add", "--detach", source, commit)
    targets = "\n".join(file.read_text() for file in (source / "apps").rglob("CMakeLists.txt"))
    measure = "medial-measure"
    if measure not in targets:
        measure = old_words[measure]
    environment = {name: value for name, value in os.environ.items() if name != "CCACHE_BASEDIR"}
    subprocess.run(["bash", "-euo", "pipefail", "-c", f"source '{ROOT}/scripts/common.sh'; "
                    f"build default build medial-axis {measure}"],
                   cwd=source, env=environment, check=True)
    return source / "build/bin"
