"""Runs a command on an X display of its own, without a screen.

usage: on_display.py COMMAND...
"""

import os
import subprocess
import sys


def main():
    read, write = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x1024x24", "-noreset", "-nolisten",
         "tcp"], pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write)
    try:
        number = os.fdopen(read).readline().strip()
        if not number:
            sys.exit("Xvfb does not start (Debian: xvfb)")
        sys.exit(subprocess.call(sys.argv[1:], env={**os.environ, "DISPLAY": f":{number}"}))
    finally:
        server.terminate()
        server.wait()


if __name__ == "__main__":
    main()
