"""Checks versions, dependencies and files of Debian packages.

Usage: check_contents.py PACKAGES STAGING VERSION
PACKAGES: folder of the .deb files; STAGING: where the whole build was installed; VERSION: with the
Debian revision, as in 0.1.0-1.
"""

import re
import subprocess
import sys
from pathlib import Path

SERIES = "0.1"  # versions whose binary interface is the same
LIBRARY = f"libmedial{SERIES}"
PROGRAMS = ("medial-axis", "medial-distance", "medial-measure", "medial-proximity", "medial-viewer")
DOCUMENTS = ("copyright", "changelog.gz", "changelog.Debian.gz")

# What each package must depend on, without versions. Those of libraries are found by dpkg-shlibdeps.
NEEDED = {
    LIBRARY: {"libc6", "libepoxy0", "libstdc++6", "libtbb12", "libvtk9.1"},
    "libmedial-dev": set(),
    "medial-tools": {"libc6", "libstdc++6", "libvtk9.1", "libx11-6"},
    "python3-medial": {"libc6", "libstdc++6", "libvtk9.1", "python3", "python3-numpy", "python3-vtk9"},
}

# All headers of the library, and no others.
PUBLIC_HEADERS = tuple(
    f"usr/include/medial/{path.name}"
    for path in sorted(Path(__file__).parents[2].glob("lib/include/medial/*.h")))

# Where each package may have files, and files that it must have; LIB is the folder of libraries.
FOLDERS = {
    LIBRARY: rf"LIB/lib[^/]+\.so\.{re.escape(SERIES)}(\.\d+)?",
    "libmedial-dev": "|".join(map(re.escape, PUBLIC_HEADERS)) +
                     r"|usr/include/medial/filters/[^/]+\.h|LIB/cmake/Medial/[^/]+\.cmake|LIB/lib[^/]+\.so"
                     r"|LIB/vtk/hierarchy/Medial/[^/]+\.txt",
    "medial-tools": r"usr/bin/[^/]+|usr/share/man/man1/[^/]+\.1\.gz"
                    r"|usr/share/bash-completion/completions/[^/]+",
    "python3-medial": r"usr/lib/python3/dist-packages/medial/[^/]+",
}
FILES = {
    LIBRARY: (f"LIB/libmedial.so.{SERIES}", f"LIB/libvtkMedialFilters.so.{SERIES}"),
    "libmedial-dev": (
        "LIB/libmedial.so", "LIB/libvtkMedialFilters.so", "LIB/cmake/Medial/MedialConfig.cmake",
        "usr/include/medial/filters/vtkMedialAxis.h", *PUBLIC_HEADERS),
    "medial-tools": tuple(
        form.format(program) for program in PROGRAMS
        for form in ("usr/bin/{}", "usr/share/man/man1/{}.1.gz", "usr/share/bash-completion/completions/{}")),
    "python3-medial": tuple(
        f"usr/lib/python3/dist-packages/medial/{name}"
        for name in ("__init__.py", "py.typed", "_execution.so", "_files.so",
                     "vtkMedialFilters.so")),
}

failures = []


def expect(condition: bool, message: str) -> None:
    if not condition:
        failures.append(message)


def output(*command: str) -> str:
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def list_files(deb: Path) -> set[str]:
    """Files and links of a package, relative to the root. Those of others than root are failures."""
    files = set()
    for line in output("dpkg-deb", "--contents", str(deb)).splitlines():
        mode, owner, _, _, _, name = line.split(maxsplit=5)
        expect(owner == "root/root", f"{deb.name}: {name} belongs to {owner}")
        if not mode.startswith("d"):
            files.add(name.split(" -> ")[0].removeprefix("./"))
    return files


def check_control(name: str, deb: Path, version: str) -> None:
    def field(key: str) -> str:
        return output("dpkg-deb", "--field", str(deb), key).strip()

    architecture = output("dpkg", "--print-architecture").strip()
    expect(field("Version") == version, f"{name} has version {field('Version')}, not {version}")
    expect(field("Architecture") == architecture, f"{name} is for {field('Architecture')}")
    depends = [item.strip() for item in field("Depends").split(",")]
    needed = {item.split()[0] for item in depends}
    expect(NEEDED[name] <= needed, f"{name} does not need {sorted(NEEDED[name] - needed)}")
    development = sorted(item for item in needed if item.endswith("-dev"))
    expect(not development, f"{name} needs {development}")
    if name != LIBRARY:
        expect(f"{LIBRARY} (= {version})" in depends, f"{name} does not need this version of {LIBRARY}")


def check_shlibs(deb: Path, version: str) -> None:
    """Packages built with the libraries must be told the package that they are in."""
    command = ("dpkg-deb", "--info", str(deb), "shlibs")  # fails where there is no such file
    found = subprocess.run(command, check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    libraries = ("libmedial", "libvtkMedialFilters")
    expected = [f"{name} {SERIES} {LIBRARY} (>= {version})" for name in libraries]
    lines = sorted(found.stdout.splitlines())
    expect(lines == expected, f"{LIBRARY} has the shlibs {lines}, not {expected}")


def check_files(name: str, files: set[str]) -> None:
    architecture = output("dpkg-architecture", "--query", "DEB_HOST_MULTIARCH").strip()
    folder = f"usr/lib/{architecture}"
    documents = {f"usr/share/doc/{name}/{document}" for document in DOCUMENTS}
    expect(documents <= files, f"{name} lacks {sorted(documents - files)}")
    required = {file.replace("LIB", folder) for file in FILES[name]}
    expect(required <= files, f"{name} lacks {sorted(required - files)}")
    pattern = FOLDERS[name].replace("LIB", re.escape(folder))
    misplaced = sorted(file for file in files - documents if not re.fullmatch(pattern, file))
    expect(not misplaced, f"{name} has {misplaced}")


def check_union(packaged: dict[str, set[str]], staging: Path) -> None:
    """Every file that is installed must be in one package."""
    installed = {
        str(path.relative_to(staging)) for path in staging.rglob("*")
        if path.is_symlink() or not path.is_dir()}
    expect(bool(installed), f"nothing is installed in {staging}")
    union = set().union(*packaged.values())
    expect(union == installed, f"in packages or installed, but not both: {sorted(union ^ installed)}")
    expect(len(union) == sum(map(len, packaged.values())), "a file is in several packages")


def main() -> int:
    folder, staging, version = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]
    debs = {deb.name.split("_")[0]: deb for deb in folder.glob("*.deb")}
    if set(debs) != set(NEEDED):
        print(f"the packages are {sorted(debs)}, not {sorted(NEEDED)}", file=sys.stderr)
        return 1
    packaged = {name: list_files(deb) for name, deb in debs.items()}
    for name, deb in debs.items():
        check_control(name, deb, version)
        check_files(name, packaged[name])
    check_shlibs(debs[LIBRARY], version)
    check_union(packaged, staging)
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
