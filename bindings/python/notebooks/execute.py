"""Executes a notebook and compares its printed outputs with the stored ones: `execute.py NOTEBOOK PICTURES [--keep]`.

The notebooks of the repository contain their outputs, so that a reader sees the pictures without running a cell.  With
`--keep` the script stores new outputs.  The script compares texts, and counts the pictures: the pixels depend on the
version of matplotlib.
"""

import re
import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient

#: Smaller pictures, because the repository contains them.
SETTINGS = "%config InlineBackend.print_figure_kwargs = {'dpi': 60, 'bbox_inches': 'tight'}"


def told(outputs) -> str:
    """Returns what a cell prints.  Addresses of objects differ from run to run, so they are left out."""
    texts = []
    for output in outputs:
        texts.append(output.get("text") or output.get("data", {}).get("text/plain", ""))
    return re.sub(r" at 0x[0-9a-f]+", "", "".join(texts))


def tidy(cell) -> None:
    """Removes from a cell everything that differs from run to run."""
    cell.metadata.pop("execution", None)
    for output in cell.outputs:
        output.get("data", {}).pop("text/html", None)


def main() -> None:
    source, expected, keep = Path(sys.argv[1]), int(sys.argv[2]), "--keep" in sys.argv[3:]
    notebook = nbformat.read(source, as_version=4)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    stored = [told(cell.outputs) for cell in code]
    setting = nbformat.v4.new_code_cell(SETTINGS)
    notebook.cells.insert(0, setting)
    NotebookClient(notebook, timeout=600, kernel_name="python3").execute()
    notebook.cells.remove(setting)
    for count, cell in enumerate(code, 1):
        cell.execution_count = count
        for output in cell.outputs:
            if "execution_count" in output:
                output["execution_count"] = count
        tidy(cell)
    pictures = sum("image/png" in output.get("data", {}) for cell in code for output in cell.outputs)
    if pictures != expected:
        raise SystemExit(f"{source}: {pictures} pictures were drawn, not {expected}")
    if keep:
        nbformat.write(notebook, source)
        print(f"{source}: {len(code)} cells and {pictures} pictures are stored")
        return
    for cell, before in zip(code, stored):
        if told(cell.outputs) != before:
            raise SystemExit(
                f"{source}: this cell prints something else than its stored output; `scripts/python --notebooks` stores"
                f" new outputs\n{cell.source}\n--- stored\n{before}\n--- printed\n{told(cell.outputs)}"
            )
    print(f"{source}: {len(code)} cells print what is stored, {pictures} pictures")


if __name__ == "__main__":
    main()
