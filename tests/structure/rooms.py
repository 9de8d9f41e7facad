"""The rooms of lib: what docs/ARCHITECTURE.md says of them, and what the tree has.

A room is a folder of lib with a row in the table of rooms; folders without a row belong to the room
above them. A public header belongs to the room whose row names it.
"""

import re
from dataclasses import dataclass
from pathlib import Path

PUBLIC = "medial/"
COLLECTION = "medial.h"  # includes all public headers, so it lies in no room
SOURCES = {".h", ".cpp"}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
QUOTED = re.compile(r"`([^`]+)`")


@dataclass
class Rooms:
    arrows: dict  # room: the rooms that it may include
    headers: dict  # public header: its room

    def of_path(self, path):
        """The room of a path relative to lib; None where it lies in none."""
        for folder in Path(path).parents:
            if str(folder) in self.arrows:
                return str(folder)
        return None

    def of_include(self, name):
        if name.startswith(PUBLIC):
            return self.headers.get(name.removeprefix(PUBLIC))
        return self.of_path(name)


def read_rooms(document):
    """The table | `room` | what it does | public headers | may include |."""
    arrows, headers = {}, {}
    text = document.read_text()
    table = re.search(r"^\| *room *\|[^\n]*\n\|[-| :]+\n((?:\|[^\n]*\n?)+)", text, re.MULTILINE)
    if not table:
        raise ValueError(f"{document.name} has no table of rooms")
    for row in table[1].splitlines():
        room, _, public, included = row.strip().strip("|").split("|")
        room = QUOTED.search(room)[1]
        if room in arrows:
            raise ValueError(f"the table has the room {room} twice")
        arrows[room] = QUOTED.findall(included)
        for header in QUOTED.findall(public):
            if header in headers:
                raise ValueError(f"the table has the header {header} twice")
            headers[header] = room
    return Rooms(arrows, headers)


def find_cycle(arrows):
    """The rooms of a cycle, or nothing."""
    done = set()

    def visit(room, way):
        if room in way:
            return [*way[way.index(room):], room]
        if room not in done:
            for target in arrows.get(room, ()):
                cycle = visit(target, [*way, room])
                if cycle:
                    return cycle
            done.add(room)
        return []

    for room in arrows:
        cycle = visit(room, [])
        if cycle:
            return cycle
    return []


def sources(folder):
    return sorted(path for path in folder.rglob("*") if path.suffix in SOURCES)


def subfolders(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_dir())


def includes(root, rooms):
    """All includes between files of lib: the file, its room, what it includes."""
    lib = root / "lib"
    for path in sources(lib):
        file = path.relative_to(lib)
        public = file.parts[0] == "include"
        if public and file.name == COLLECTION:
            continue
        room = rooms.headers.get(file.name) if public else rooms.of_path(file)
        for name in INCLUDE.findall(path.read_text()):
            yield file, room, name


def table_faults(root, rooms):
    """Differences between the table and the folders."""
    lib = root / "lib"
    public = {path.name for path in (lib / "include/medial").glob("*.h")} - {COLLECTION}
    faults = [f"the table lacks the header {name}" for name in sorted(public - set(rooms.headers))]
    faults += [f"there is no header {name}" for name in sorted(set(rooms.headers) - public)]
    faults += [f"there is no room lib/{room}" for room in rooms.arrows if not (lib / room).is_dir()]
    faults += [f"{room} may include {target}, which is not a room"
               for room, targets in rooms.arrows.items() for target in targets if target not in rooms.arrows]
    cycle = find_cycle(rooms.arrows)
    if cycle:
        faults.append("the arrows lead in a circle: " + " -> ".join(cycle))
    return faults


def include_faults(root, rooms, found):
    """Of the includes that were found, those that the table does not allow."""
    faults = []
    for file, room, name in found:
        target = rooms.of_include(name)
        if file.parts[0] != "include" and len(file.parts) > 1 and room is None:
            faults.append(f"{file} lies in no room")
        if room is None:
            continue
        if target is None:
            faults.append(f"{file} includes {name}, which is in no room")
        elif not name.startswith(PUBLIC) and not (root / "lib" / name).exists():
            faults.append(f"{file} includes {name}, which does not exist")
        elif target != room and target not in rooms.arrows[room]:
            faults.append(f"{file} includes {name}: no arrow leads from {room} to {target}")
    return sorted(set(faults))


def unused_arrows(rooms, found):
    """Arrows of the table that no include that was found needs."""
    used = {(room, rooms.of_include(name)) for _, room, name in found}
    return [f"no file needs the arrow from {room} to {target}"
            for room, targets in rooms.arrows.items() for target in targets if (room, target) not in used]


def mirror_faults(root):
    """Folders of shaders and tests that are not rooms of lib."""
    known = set(subfolders(root / "lib"))
    return [f"{mirror}/{folder} mirrors no folder of lib" for mirror in ("shaders", "tests/lib")
            for folder in subfolders(root / mirror) if folder not in known]


def all_faults(root):
    rooms = read_rooms(root / "docs/ARCHITECTURE.md")
    found = list(includes(root, rooms))
    return [*table_faults(root, rooms), *include_faults(root, rooms, found),
            *unused_arrows(rooms, found), *mirror_faults(root)]
