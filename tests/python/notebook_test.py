# SPDX-License-Identifier: Apache-2.0
"""The example that is a notebook runs, with its pictures kept in it, and Ctrl-C in a notebook ends a solve within a second. Skipped where
nbconvert is missing, unless CROSSGRAIN_ALL_PACKAGES is set."""

import json
import os
import shutil
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
try:
    import nbconvert.preprocessors
    import nbformat
    from jupyter_client.manager import start_new_kernel
except ImportError:
    if os.environ.get("CROSSGRAIN_ALL_PACKAGES"):
        raise
    nbconvert = None

EXAMPLES = Path(os.environ.get("CROSSGRAIN_EXAMPLES", Path(__file__).parents[2] / "examples" / "python"))
TESTS = Path(__file__).parent


def pictures_in(notebook):
    return [output["data"]["image/png"] for cell in notebook["cells"] for output in cell.get("outputs", []) if "image/png" in output.get("data", {})]


def texts_in(notebook):
    """The answers, without what goes to standard error: on a slow machine a bar of progress appears there."""
    return [output[key] if key == "text" else output["data"]["text/plain"] for cell in notebook["cells"] for output in cell.get("outputs", [])
            for key in ("text", "data") if key in output and "image/png" not in output.get("data", {}) and output.get("name") != "stderr"]


@unittest.skipUnless(nbconvert, "nbconvert is not installed")
class Notebook(unittest.TestCase):
    def test_keeps_the_pictures_and_answers_that_it_gives(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(EXAMPLES, folder, dirs_exist_ok=True)
            kept = json.loads((EXAMPLES / "looking_at_a_field.ipynb").read_text(encoding="utf-8"))
            notebook = nbformat.read(f"{folder}/looking_at_a_field.ipynb", as_version=4)
            nbconvert.preprocessors.ExecutePreprocessor(timeout=100, kernel_name="python3").preprocess(notebook, {"metadata": {"path": folder}})
        self.assertEqual(len(pictures_in(notebook)), 2)
        self.assertEqual(["".join(text) for text in texts_in(kept)], texts_in(notebook))
        # The same bits on every machine with the same libraries for pictures.
        self.assertEqual(len(pictures_in(kept)), 2)

    def test_is_interrupted_long_before_the_solve_ends(self):
        manager, client = start_new_kernel(kernel_name="python3")
        self.addCleanup(manager.shutdown_kernel, now=True)
        self.addCleanup(client.stop_channels)
        client.execute_interactive(f"import sys; sys.path.insert(0, {str(TESTS)!r}); import crossgrain as cg; from solids import ball", timeout=60)
        client.execute("cg.solve(*ball(40), resolution=300)")
        time.sleep(1.5)
        manager.interrupt_kernel()
        reply = client.get_shell_msg(timeout=20)  # the solve would take minutes
        self.assertEqual(reply["content"].get("ename"), "KeyboardInterrupt")


if __name__ == "__main__":
    unittest.main()
