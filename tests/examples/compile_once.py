"""A compiler launcher: where BUILD has compiled the same source by the same command, copies its object.

usage: compile_once.py BUILD FOLDER COMMAND...
BUILD: where Medial was built; FOLDER: where it is built now, as a part of another project. Commands may
differ in these two folders only. Any other command is run.
"""

import json
import os
import shlex
import shutil
import subprocess
import sys

BUILD, FOLDER, COMMAND = sys.argv[1], sys.argv[2], sys.argv[3:]
# What a command writes; all of these have an argument.
FILES = ("-o", "-MF", "-MT", "-MQ")


def value_of(option, words):
    return words[words.index(option) + 1] if option in words else None


def meaning(words, folder):
    """The compiler and its options, without the files that it writes."""
    kept, skip = [], False
    for word in words:
        if not skip and word not in FILES and word != "-MD":
            kept.append(word.replace(folder + "/", "FOLDER/"))
        skip = not skip and word in FILES
    return kept


def same_text(source):
    """Whether a generated source is that of BUILD; others are the same file."""
    if not source.startswith(FOLDER + "/"):
        return True
    with open(source, "rb") as now, open(source.replace(FOLDER, BUILD, 1), "rb") as before:
        return now.read() == before.read()


def compiled_before(source):
    """The object that BUILD has of a source; None without one that is up to date."""
    launchers = sum(os.path.basename(word).endswith("ccache") for word in COMMAND[:1])
    wanted = meaning(COMMAND[launchers:], FOLDER)
    with open(os.path.join(BUILD, "compile_commands.json"), encoding="utf-8") as stream:
        commands = json.load(stream)
    for command in commands:
        if os.path.basename(command["file"]) != os.path.basename(source):
            continue
        words = shlex.split(command["command"])
        found = os.path.join(command["directory"], value_of("-o", words) or "")
        if (meaning(words, BUILD) == wanted and same_text(source) and os.path.isfile(found)
                and os.path.getmtime(found) >= os.path.getmtime(source)):
            return found
    return None


def main():
    source, target = value_of("-c", COMMAND), value_of("-o", COMMAND)
    found = None
    if source and target:
        try:
            found = compiled_before(source)
        except OSError:
            pass
    if not found:
        return subprocess.call(COMMAND)
    shutil.copyfile(found, target)
    dependencies = value_of("-MF", COMMAND)
    if dependencies:
        # A newer object is copied again.
        with open(dependencies, "w", encoding="utf-8") as stream:
            stream.write(f"{target}: {source} {found}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
