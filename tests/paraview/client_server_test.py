"""pvserver, of one and of two processes, and a client over the loopback interface."""

import json
import os
import socket
import subprocess
import tempfile
import unittest
from contextlib import contextmanager
from pathlib import Path

CLIENT = Path(__file__).with_name("remote_client.py")
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "HWLOC_COMPONENTS": "-gl"}


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


@contextmanager
def server(processes):
    """A server that waits for a client; ends with it, or when the block is left."""
    port = free_port()
    command = ["mpirun", "--oversubscribe", "-np", str(processes), "pvserver",
               f"--server-port={port}"]
    with subprocess.Popen(command, env=ENVIRONMENT, stdout=subprocess.PIPE, text=True) as process:
        try:
            for line in process.stdout:
                if "Accepting connection" in line:
                    break
            yield port
            process.communicate(timeout=60)
        finally:
            process.terminate()


class ClientServer(unittest.TestCase):
    def figures(self, processes):
        """What the client prints, with its messages and whether it made a picture."""
        with tempfile.TemporaryDirectory() as folder, server(processes) as port:
            picture = Path(folder, "picture.png")
            client = subprocess.run(["pvpython", CLIENT, str(port), picture], env=ENVIRONMENT,
                                    capture_output=True, text=True, timeout=240)
            self.assertEqual(client.returncode, 0, client.stderr)
            self.assertGreater(picture.stat().st_size, 5000)
        return json.loads(client.stdout), client.stderr

    def test_servers_of_one_and_of_two_processes(self):
        one, messages = self.figures(1)
        self.assertEqual([one["field"]] * 2, one["samples of a process"])
        self.assertGreater(one["axis"], 2000)
        self.assertEqual(one["axis after an error"], 0)
        self.assertIn("resolution 1 is outside [2, 8192]", messages)
        self.assertEqual(one["distance of pieces"], one["distance"])
        two, messages = self.figures(2)
        self.assertEqual(two["distance of pieces"], one["distance of pieces"])
        self.assertGreaterEqual(two["points of pieces"], one["points of pieces"])
        self.assertEqual(two["axis"], one["axis"])
        self.assertGreater(len(one["axis of pieces"]["cells"]), 500)
        for name, values in one["axis of pieces"].items():
            self.assertTrue(two["axis of pieces"][name] == values, name)  # assertEqual compares long lists for minutes
        for mine, other in zip(two["distance"], one["distance"]):
            self.assertAlmostEqual(mine, other, places=5)
        self.assertLess(max(two["samples of a process"]), 0.6 * two["field"])
        self.assertIn("resolution 1 is outside [2, 8192]", messages)


if __name__ == "__main__":
    unittest.main(verbosity=2)
