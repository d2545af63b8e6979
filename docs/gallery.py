#!/usr/bin/env python3
"""Runs the hard cases (cases/hard) and writes docs/src/gallery.md, docs/src/gallery-fluid.md, docs/src/gallery-solid.md and their pictures
from what they left behind.

    cargo build -p welder && cargo build -p sph-fluid -p sph-solid --examples
    python3 docs/gallery.py

`--page welds`, `--page fluid` or `--page solid` runs and writes one of the three pages.

Every word of the page comes from the scenes (their first comment and title), every number from summary.json and the
messages of the program, every picture from the program. A case may end as done, or with a status of its own that the
program names: a failure with a dossier, an audit that failed. Exit code 1: a case ended in another way.
"""

import argparse
import csv
import json
import re
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SOURCES = ROOT / "docs/src"
PICTURES = ROOT / "docs/src/gallery"

# Exit codes of the program that are named ends of a run.
ENDS = {0: "done", 3: "failed", 4: "audit failed"}

# Scenes of the crates that run by themselves: package, example, arguments.
EXAMPLES = [
    ("sph-fluid", "drop", []),
    ("sph-fluid", "dam_break", []),
    ("sph-fluid", "marangoni_film", []),
    ("sph-solid", "rings", []),
    ("sph-solid", "heated_disc", []),
]


PAGES = ["welds", "fluid", "solid"]


def page_of(name):
    """The page that a case, or a picture, belongs to."""
    return next((page for page in PAGES if name.startswith(f"{page}-")), "welds")


class Run:
    """A case that was run: its words, how it ended, what it found."""

    def __init__(self, folder, program, scratch):
        self.name = folder.name
        self.page = page_of(self.name)
        scene = (folder / "scene.ron").read_text()
        lines = re.match(r"((?://[^\n]*\n)+)", scene).group(1).splitlines()
        self.words = " ".join(line.removeprefix("//").strip() for line in lines)
        self.title = re.search(r'title: "([^"]*)"', scene).group(1)
        self.out = scratch / self.name
        command = [program, "run", folder, "--quiet", "--threads", "1", "--out", self.out, "--set", "output.frames=false"]
        ended = subprocess.run(command, capture_output=True, text=True, env={"RUST_LOG": "warn"})
        self.code = ended.returncode
        # Without the time of day, which no page should have.
        said = re.findall(r"(?:WARN|ERROR) [\w:]+: (.*)", ended.stderr)
        self.said = [re.sub(re.escape(str(self.out)) + "/?", "", line) for line in said]
        self.has_dossier = (self.out / "dossier.json").is_file()
        summary = self.out / "summary.json"
        self.summary = json.loads(summary.read_text()) if summary.is_file() else None

    def is_named(self):
        """Whether the run ended as something that the program has a name for, with what belongs to it."""
        return self.summary is not None and self.code in ENDS and (
            self.code != 3 or self.has_dossier or self.summary["status"] == "deep-penetration"
        )

    def end(self):
        if self.summary is not None and self.summary["status"] == "deep-penetration":
            return "deep penetration"
        return ENDS.get(self.code, f"exit code {self.code}")

    def pictures(self):
        """The pictures that show the case: its stress, what moves from above, the speed of a fluid, else the section along x; of bodies
        their stress, and the plastic strain of those that yield."""
        seen_from_above = "seam" in self.name or self.name in ("two-spots", "edge")
        wanted = ["stress_x", "speed", "top" if seen_from_above else "section_x"]
        there = lambda names: [self.out / f"{name}.png" for name in names if (self.out / f"{name}.png").is_file()]
        return there(["stress", "plastic_strain"]) if self.page == "solid" else there(wanted)[:1]


def png_rows(data):
    """Width and rows of a PNG of 8-bit red, green and blue, as the program writes it; filters of the PNG specification, 9.2."""
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", data[at + 8 : at + 18])
            assert (depth, colour) == (8, 2), "not 8-bit RGB"
        if kind == b"IDAT":
            packed += data[at + 8 : at + 8 + length]
        at += 12 + length
    raw, size = zlib.decompress(packed), 3 * width
    rows, above = [], bytes(size)
    for start in range(0, height * (size + 1), size + 1):
        method, row = raw[start], bytearray(raw[start + 1 : start + 1 + size])
        for x in range(size if method else 0):
            left, up, corner = (row[x - 3], above[x], above[x - 3]) if x >= 3 else (0, above[x], 0)
            near = min((left, up, corner), key=lambda value: abs(left + up - corner - value))
            row[x] = (row[x] + (0, left, up, (left + up) // 2, near)[method]) & 255
        rows.append(row)
        above = row
    return width, rows


def small_png(data):
    """The picture with 32 shades of each colour, or 16 where that leaves more than a palette holds: a tenth of its size."""
    width, rows = png_rows(data)
    for bits in (5, 4):
        shade = bytes(round((value >> (8 - bits)) * 255 / (2**bits - 1)) for value in range(256))
        shaded = [row.translate(shade) for row in rows]
        pixels = [[bytes(row[x : x + 3]) for x in range(0, 3 * width, 3)] for row in shaded]
        palette = {colour: index for index, colour in enumerate(sorted(set().union(*pixels)))}
        if len(palette) <= 256:
            break
    else:
        return data
    packed = zlib.compress(b"".join(b"\0" + bytes(map(palette.get, row)) for row in pixels), 9)
    head = struct.pack(">IIBBBBB", width, len(rows), 8, 3, 0, 0, 0)
    chunk = lambda kind, body: struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"PLTE", b"".join(palette)) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


def micrometres(length_m):
    return f"{1e6 * length_m:.1f}"


def row(run):
    if run.summary is None:
        return f"| [{run.name}](#{run.name}) | {run.end()} | | | | | | | | |"
    s = run.summary
    sizes = " | ".join(micrometres(s["pool"][f"max_{size}_m"]) for size in ("width", "length", "depth"))
    solid = s["weld"]["solidified_at_s"]
    solid = "-" if solid is None else f"{1e3 * solid:.2f}"
    return (
        f"| [{run.name}](#{run.name}) | {run.end()} | {sizes} | {s['peak_temperature_k']:.0f} | {solid} "
        f"| {s['energy']['residual_rel']:.0e} | {s['particles']} x {s['steps']} | {s['cpu_s']:.1f} |"
    )


def fluid_row(run):
    if run.summary is None:
        return f"| [{run.name}](#{run.name}) | {run.end()} | | | | | | | |"
    s = run.summary
    n = s["numbers"]
    box = " x ".join(f"{1e3 * (high - low):.3f}" for low, high in zip(s["low_m"], s["high_m"]))
    reynolds = f"{n['reynolds']:.3g}" if "reynolds" in n else "none: no viscosity"
    return (
        f"| [{run.name}](#{run.name}) | {run.end()} | {s['max_speed_m_s']:.3g} | {reynolds} | {n['mach']:.2g} "
        f"| {100 * s['max_density_change_rel']:.2f} | {box} | {s['energy']['residual_rel']:.0e} "
        f"| {s['particles']} x {s['steps']} | {s['cpu_s']:.1f} |"
    )


def solid_row(run):
    if run.summary is None:
        return f"| [{run.name}](#{run.name}) | {run.end()} | | | | | | | | |"
    s = run.summary
    stresses = [1e-6 * s[f"{which}_pa"] for which in ("max_von_mises", "max_principal_stress", "min_principal_stress")]
    return (
        f"| [{run.name}](#{run.name}) | {run.end()} | {s['max_speed_m_s']:.3g} | {' | '.join(f'{stress:.3g}' for stress in stresses)} "
        f"| {1e3 * s['max_displacement_m']:.3g} | {s['max_plastic_strain']:.1e} | {s['pieces']} "
        f"| {s['energy']['residual_rel']:.0e} | {s['particles']} x {s['steps']} | {s['cpu_s']:.1f} |"
    )


ROWS = {"welds": row, "fluid": fluid_row, "solid": solid_row}


def history(run):
    """Columns of history.csv."""
    with (run.out / "history.csv").open() as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows if row[name]] for name in rows[0] if name != "dt_limit"}


def course(run):
    """How a fluid or bodies fared, at ten times of the run."""
    columns = history(run)
    times = columns["time_s"]
    picked = [min(range(len(times)), key=lambda k: abs(times[k] - times[-1] * tenth / 10)) for tenth in range(1, 11)]
    line = lambda title, texts: f"| {title} | " + " | ".join(texts) + " |"
    ends = lambda axis, k: [1e3 * columns[f"{axis}_{end}_m"][k] for end in ("min", "max")]
    if run.page == "solid":
        energies = [(name, columns[f"{key}_j"]) for name, key in (("energy of motion", "kinetic"), ("of strain", "elastic"), ("lost", "lost"))]
        spans = list(zip([-1, *picked], picked))
        peaks = lambda name, scale: [f"{scale * max(columns[name][before + 1 : k + 1]):.4g}" for before, k in spans]
        return [
            line("time ms", [f"{1e3 * times[k]:.4g}" for k in picked]),
            "|---" * 11 + "|",
            line("largest von Mises stress MPa", peaks("max_von_mises_pa", 1e-6)),
            line("largest principal stress MPa", peaks("max_principal_stress_pa", 1e-6)),
            line("largest displacement mm", peaks("max_displacement_m", 1e3)),
            *(line(f"{name} J/m", [f"{values[k]:.3g}" for k in picked]) for name, values in energies if any(values)),
            "",
        ]
    extent = lambda axis, k: f"{ends(axis, k)[1] - ends(axis, k)[0]:.3f}"
    centre = lambda axis, k: f"{sum(ends(axis, k)) / 2:.3f}"
    return [
        line("time ms", [f"{1e3 * times[k]:.4g}" for k in picked]),
        "|---" * 11 + "|",
        line("largest speed m/s", [f"{columns['max_speed_m_s'][k]:.3g}" for k in picked]),
        *(line(f"extent along {axis} mm", [extent(axis, k) for k in picked]) for axis in "xy"),
        *(line(f"middle along {axis} mm", [centre(axis, k) for k in picked]) for axis in "xy"),
        "",
    ]


def more(run):
    """Numbers of flow and stress, where they were computed."""
    s = run.summary or {}
    said = []
    if run.page != "welds":
        return said
    if "reynolds" in s.get("numbers", {}):
        n = s["numbers"]
        said.append(
            f"Reynolds {n['reynolds']:.3g}, cell Reynolds {n['cell_reynolds']:.2g}, Mach {n['mach']:.2g}, "
            f"friction by numerics over the melt's own {n['friction_by_numerics']:.2g}."
        )
    if s.get("stress"):
        t = s["stress"]
        said.append(
            f"At the end: largest von Mises stress {1e-6 * t['max_von_mises_pa']:.1f} MPa, displacement "
            f"{1e6 * t['max_displacement_m']:.2f} um, plastic strain {t['max_plastic_strain']:.2e}, unrest {t['unrest']:.1e}."
        )
    return said


def section(run):
    lines = [f"### {run.name}", "", f"**{run.title}.** {run.words}", ""]
    lines += more(run) + ([""] if more(run) else [])
    lines += [f"> {line}" for line in run.said] + ([""] if run.said else [])
    lines += course(run) if run.page != "welds" and run.summary else []
    for index, picture in enumerate(run.pictures() if run.summary else []):
        name = run.name if index == 0 else f"{run.name}-{picture.stem.replace('_', '-')}"
        (PICTURES / f"{name}.png").write_bytes(small_png(picture.read_bytes()))
        lines += [f"![{run.title}](gallery/{name}.png)", ""]
    return lines


def example(package, name, arguments):
    program = ROOT / "target/debug/examples" / name
    ended = subprocess.run([program, *arguments], capture_output=True, text=True)
    words = (ROOT / "crates" / package / "examples" / f"{name}.rs").read_text().splitlines()[0].removeprefix("//! ")
    text = ended.stdout if ended.returncode == 0 else f"exit code {ended.returncode}: {ended.stderr}"
    return [f"### {name}", "", f"`cargo run -p {package} --example {name}`: {words}", "", "```text", text.rstrip(), "```", ""]


def names(which):
    return ", ".join(f"[{run.name}](#{run.name})" for run in which) or "none"


def account(runs, machine):
    """What was run, what it cost, and what did not end as hoped."""
    seconds = sum(run.summary["cpu_s"] for run in runs if run.summary)
    failed = [run for run in runs if run.code != 0]
    spoken = [run for run in runs if run.code == 0 and run.said]
    return (
        f"{len(runs)} cases, {seconds:.0f} s of processor time on {machine}. Ended otherwise than done: {names(failed)}. "
        f"Done with a warning: {names(spoken)}."
    )


def fluid_page(runs, machine):
    lines = [
        "# Hard cases of fluid",
        "",
        "Scenes of [pure fluid](how-to/fluid.md) at the border of what the program can do: `cases/hard/fluid-*`, each run with `welder run`. This page",
        "and its pictures were written by `python3 docs/gallery.py --page fluid` from those runs; no number is typed.",
        "",
        account(runs, machine),
        "",
        "| case | ended | largest speed m/s | Reynolds | Mach | density change % | extent at the end mm | energy residual | particles x steps | cpu s |",
        "|---|---|---|---|---|---|---|---|---|---|",
        *map(fluid_row, runs),
        "",
        "The residual is the energy that the scheme itself took, over the largest of the others; below zero it gave.",
        "",
    ]
    for run in runs:
        lines += section(run)
    return "\n".join(lines).rstrip() + "\n"


def solid_page(runs, machine):
    lines = [
        "# Hard cases of elastic bodies",
        "",
        "Scenes of [elastic bodies](how-to/solid.md) at the border of what the program can do: `cases/hard/solid-*`, each run with `welder run`.",
        "This page and its pictures were written by `python3 docs/gallery.py --page solid` from those runs; no number is typed.",
        "",
        account(runs, machine),
        "",
        "| case | ended | largest speed m/s | von Mises MPa | principal MPa, largest | smallest | displacement mm | plastic strain | pieces | energy residual | particles x steps | cpu s |",
        "|---" * 12 + "|",
        *map(solid_row, runs),
        "",
        "Stress, displacement and plastic strain are the largest of the run, pieces those at its end; the residual is what viscosity and the scheme",
        "itself took, over the largest energy; below zero they gave. In the tables below they are the largest since the time before, and energies those of",
        "the time. Pictures show the end.",
        "",
    ]
    for run in runs:
        lines += section(run)
    return "\n".join(lines).rstrip() + "\n"


def weld_page(runs, examples, machine):
    lines = [
        "# Hard cases",
        "",
        "Scenes at the border of what the program can do, and beyond it: `cases/hard/*`, each run with `welder run`. This page and its",
        "pictures were written by `python3 docs/gallery.py` from those runs; no number is typed. A case ends as done, or with a status",
        "that the program names.",
        "",
        account(runs, machine),
        "",
        "| case | ended | width um | length um | depth um | peak K | solid ms | energy residual | particles x steps | cpu s |",
        "|---|---|---|---|---|---|---|---|---|---|",
        *map(row, runs),
        "",
        "Width, length and depth are the largest of the pool at the liquidus; the residual is the energy that cannot be accounted for, over",
        "that turned over.",
        "",
    ]
    for title, prefix in (("Heat", ""), ("Heat and stress", "stress-"), ("Heat and flow", "flow-")):
        own = [run for run in runs if (run.name.startswith(prefix) if prefix else not run.name.startswith(("stress-", "flow-")))]
        if own:
            lines += [f"## {title}", ""]
        for run in own:
            lines += section(run)
    if examples:
        lines += ["## Fluid and solid by themselves", "", "Examples of the crates, as they print.", ""]
        for one in examples:
            lines += one
    return "\n".join(lines).rstrip() + "\n"


def write(page, runs, program):
    """Writes a page, and its pictures in place of those it had."""
    PICTURES.mkdir(exist_ok=True)
    for old in PICTURES.glob("*.png"):
        if page_of(old.stem) == page:
            old.unlink()
    if page == "fluid":
        (SOURCES / "gallery-fluid.md").write_text(fluid_page(runs, machine(program)))
    elif page == "solid":
        (SOURCES / "gallery-solid.md").write_text(solid_page(runs, machine(program)))
    else:
        examples = [example(*one) for one in EXAMPLES]
        (SOURCES / "gallery.md").write_text(weld_page(runs, examples, machine(program)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--welder", type=Path, default=ROOT / "target/debug/welder", help="the program")
    parser.add_argument("--page", choices=PAGES, help="run and write this page only")
    parser.add_argument("--only", metavar="NAME", nargs="+", help="run these cases and print their rows; write nothing")
    given = parser.parse_args()
    folders = sorted(path.parent for path in (ROOT / "cases/hard").glob("*/scene.ron"))
    if given.only:
        folders = [folder for folder in folders if folder.name in given.only]
    pages = {page: [] for page in PAGES}
    with tempfile.TemporaryDirectory() as scratch:
        for folder in folders:
            if given.page not in (None, page_of(folder.name)):
                continue
            run = Run(folder, given.welder, Path(scratch))
            print(ROWS[run.page](run), *run.said, sep="\n  ", flush=True)
            pages[run.page].append(run)
        for kind, runs in pages.items():
            if runs and not given.only:
                write(kind, runs, given.welder)
    wrong = [run.name for runs in pages.values() for run in runs if not run.is_named()]
    if wrong:
        sys.exit(f"ended without a name: {', '.join(wrong)}")


def machine(program):
    """The machine as the program names it."""
    said = subprocess.run([program, "check", ROOT / "cases/spot-aluminium"], capture_output=True, text=True).stdout
    return re.search(r"on one core of (.*)", said).group(1)


if __name__ == "__main__":
    main()
