"""Tests that page, CSV files and pictures are consistent."""

import re
import shutil

import pytest

from paper.contact.cases import PARTS
from paper.contact.problem import AREA, FX, FZ, PMAX
from paper.contact.section import SECTION
from paper.outputs import write_page, write_part
from paper.store import ResultStore


def invented(case):
    """Creates errors that decrease with L and with n, and change their sign, which suffices for every picture and
    every sentence."""
    ics = case.spec["ics"]
    block = 2.0 / case.L if case.L and "far_boundary" not in ics else 0.0
    error = block + 0.1 / case.n**2 - (2e-3 if ics.get("sampling") == "linear_nodes" else 0)
    return {
        "Fz": FZ * (1 + error), "Fx": FX * (1 + 0.9 * error), "Fy": 0.0, "pmax": PMAX * (1 + error / 3 - 1 / case.n**2),
        "area": AREA * (1 + error + 1 / case.n), "adhesion": case.n**2 // 7, "slip": case.n**2 // 3,
        "iterations_normal": 8, "iterations_tangential": 15, "dofs": 1000, "origin_zz": -2e-3,
    }  # fmt: skip


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """Everything, written once."""
    folder = tmp_path_factory.mktemp("docs")
    with ResultStore(folder / "store" / "contact.jsonl", "contactd 1") as store:
        for part in PARTS.values():
            for case in part():
                store.put(case.spec, invented(case))
        for name in PARTS:
            write_part(SECTION, name, store, folder, lambda line: None)
    write_page(SECTION, folder, "contactd 1", lambda line: None)
    shutil.rmtree(folder / "store")
    return folder


def test_every_part_has_a_file_and_every_figure_a_picture(written):
    pictures = {"bilinear.png", *(f"fig{number}.png" for number in range(9, 15))}
    assert {path.name for path in written.iterdir()} == {"contact.md", *(f"{name}.csv" for name in PARTS), *pictures}


def test_nothing_is_left_to_fill_in(written):
    text = (written / "contact.md").read_text()
    assert "{{" not in text and "[[" not in text


def test_the_page_links_to_files_and_headings_that_are_there(written):
    text = (written / "contact.md").read_text()
    links = re.findall(r"\]\(([^):]+)\)", text)
    titles = [line.lstrip("# ").lower() for line in text.splitlines() if line.startswith("#")]
    headings = {"#" + re.sub(r"[^a-z0-9 -]", "", title).replace(" ", "-") for title in titles}
    curved = "sections.md#errors-of-coefficients-and-of-contacts-flat-and-curved"
    others = {"fem.md", curved, "../../bench/paper/contact.md.in"}
    assert links
    assert [link for link in links if link not in others | headings and not (written / link).is_file()] == []


def test_numbers_and_verdicts_of_the_page_are_those_of_the_csv_files(written, tmp_path):
    folder = shutil.copytree(written, tmp_path / "docs")
    path = folder / "fig9.csv"
    lines = path.read_text().splitlines()
    columns = lines[0].split(",")
    cells = next(line for line in lines if line.startswith("analytic,n,10,")).split(",")
    place = lines.index(",".join(cells))
    cells[columns.index("error_Fz")] = "0.0777"
    lines[place] = ",".join(cells)
    path.write_text("\n".join(lines) + "\n")

    write_page(SECTION, folder, "contactd 1", lambda line: None)

    quotation = "> The errors in the normal force are already quite small.\n\n"
    assert quotation + "**Agrees.**" in (written / "contact.md").read_text()
    after = (folder / "contact.md").read_text()
    assert quotation + "**Differs.**" in after and "7.8 % on 10 × 10" in after


def test_the_page_is_not_written_without_a_point_it_speaks_of(written, tmp_path):
    folder = shutil.copytree(written, tmp_path / "docs")
    path = folder / "sources.csv"
    path.write_text("".join(line for line in path.read_text().splitlines(True) if "tangential alone" not in line))
    reported = []
    write_page(SECTION, folder, "contactd 1", reported.append)
    assert "tangential alone" in reported[-1]
