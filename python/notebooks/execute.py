"""Executes a notebook and writes it with its outputs: `execute.py NOTEBOOK OUT PICTURES`.

The notebook of the repository has none: their pictures depend on the version of matplotlib and weigh megabytes.  That every
cell runs and draws is what is checked here.
"""

import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient


def main() -> None:
    source, target = map(Path, sys.argv[1:3])
    expected = int(sys.argv[3])
    notebook = nbformat.read(source, as_version=4)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    if any(cell.outputs or cell.execution_count for cell in code):
        raise SystemExit(f"{source}: clear its outputs before it is committed")
    NotebookClient(notebook, timeout=600, kernel_name="python3").execute()
    nbformat.write(notebook, target)
    pictures = sum("image/png" in output.get("data", {}) for cell in code for output in cell.outputs)
    if pictures != expected:
        raise SystemExit(f"{source}: {pictures} pictures were drawn, not {expected}")
    print(f"{target}: {len(code)} cells, {pictures} pictures")


if __name__ == "__main__":
    main()
