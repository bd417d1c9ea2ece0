# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gallery: pictures of doc/gallery.md, each made by the commands that stand beside it."""

import dataclasses
import io
import subprocess
import sys

from caudal import read_progress

WIDTH, LARGEST_SIZE = 800, 120_000  # of a picture [pixels, bytes]


@dataclasses.dataclass
class Picture:
    """A picture of a run."""
    name: str
    title: str
    case: str  # a file, or the script that runs its own
    folder: str  # output/<folder>
    commands: tuple  # what draws it
    file: str  # what they have drawn, in the folder
    caption: str

    @property
    def run(self):
        return self.case if self.case.startswith("scripts/") else f"scripts/swim {self.case}"


def draw(name, title, case, folder, plot, caption, options=""):
    """A picture that scripts/plot draws."""
    command = f"scripts/plot output/{folder} --only {plot}{options and ' ' + options}"
    return Picture(name, title, case, folder, (command,), f"plots/{plot}.png", caption)


PICTURES = (
    draw("laminar_fish", "A free elastic fish", "prm/laminar_fish.prm", "laminar_fish", "vorticity",
         "Muscles bend it in a wave; course, recoil and speed are results. At a Reynolds number of 2,200 "
         "its layers and its wake are resolved; 6.5 % of the dissipation are numerical."),
    draw("body_wave", "How it bends", "prm/laminar_fish.prm", "laminar_fish", "body_wave",
         "Outlines through its last tail beat, about its centre of mass: an elastic body, bent by its "
         "muscles and the water."),
    draw("energy", "Where the muscles' work goes", "prm/laminar_fish.prm", "laminar_fish", "energy",
         "The ledger of the same run. The dashed line is the part of the dissipation that the grid "
         "takes and not viscosity: look at it before you quote a figure."),
    draw("school", "Two fish in line", "prm/school_tandem.prm", "school_tandem", "vorticity",
         "The second fish, half a length behind at the start, has come closer, beside the street of the "
         "first: what each gains is in prm/README.md."),
    draw("eel", "An eel of prescribed deformation", "prm/eel.prm", "eel", "vorticity",
         "Carling's eel from rest, six periods: its deformation is prescribed, its way is not."),
    draw("foil", "A foil from gmsh in a flume", "prm/cookbook/gmsh.prm", "foil", "vorticity",
         "Its head is turned to and fro, its soft tail bends as water and elasticity will "
         "([recipe](cookbook/gmsh.md))."),
    draw("flag", "A flag behind a cylinder", "prm/benchmarks/fsi3_fast.prm", "fsi3_fast", "vorticity",
         "Turek and Hron's benchmark FSI3 at its least cost: flutter of an elastic flag; amplitude, "
         "frequency and drag are compared in prm/benchmarks/README.md.", "--limit 150"),
    draw("sphere", "A sphere in a stream", "prm/sphere.prm", "sphere", "slices",
         "In three dimensions, at a Reynolds number of 100: the vorticity across the plane through its "
         "centre. Behind it a ring of fluid turns the other way.", "--limit 6"),
    draw("vortices", "Vortices in three dimensions", "prm/cookbook/ball.prm", "ball", "vortices",
         "A ball in a stream at a Reynolds number of 100, on a coarse grid: a surface of equal Q, coloured "
         "by the vorticity about z ([recipe](cookbook/three_dimensions.md)).", "--level 4"),
    draw("salmon_viscous", "A salmon in a viscous fluid", "prm/salmon/salmon_viscous.prm",
         "salmon_viscous", "vortices",
         "The same fish in three dimensions, at ten times water's viscosity, after its first beat: a surface "
         "of equal Q, coloured by the vorticity about z."),
    Picture("salmon", "A salmon in an ideal fluid", "scripts/salmon", "salmon_study", (),
            "swimming_shapes.png",
            "Six joints bend three shapes alike, boundary elements give the pressure on them and their "
            "way: a stroke of each, and its swim of 20 s."),
    draw("passage", "Which fish pass", "prm/passage/ramp_batch.prm", "ramp_batch", "matrix",
         "A ramp from a HEC-RAS profile, many fish at several discharges."),
)


def shell(command, root):
    subprocess.run(["bash", "-c", command], cwd=root, check=True, stdout=subprocess.DEVNULL)


def shrink(data, is_field):
    """A PNG of the gallery's width, with as many colours as its largest size allows. Those of a
    field are cut where they are many, those of a chart cover its few curves."""
    from PIL import Image

    method = Image.Quantize.MEDIANCUT if is_field else Image.Quantize.MAXCOVERAGE

    picture = Image.open(io.BytesIO(data)).convert("RGB")
    picture = picture.resize((WIDTH, round(picture.height * WIDTH / picture.width)), Image.LANCZOS)
    for n_colours in (256, 128, 64, 32):
        file = io.BytesIO()
        picture.quantize(n_colours, method, dither=Image.Dither.NONE).save(file, "PNG", optimize=True)
        if file.tell() < LARGEST_SIZE:
            break
    return file.getvalue()


def write_page(root):
    """doc/gallery.md: each picture beside its commands."""
    parts = ["# Gallery\n\nMade by `scripts/document gallery`; each picture by the commands below it. "
             "Runs that are finished are kept.\n"]
    for picture in PICTURES:
        commands = "\n".join((picture.run, *picture.commands))
        parts.append(f"## {picture.title}\n\n![{picture.title}](gallery/{picture.name}.png)\n\n"
                     f"{picture.caption}\n\n```sh\n{commands}\n```\n")
    (root / "doc" / "gallery.md").write_text("\n".join(parts), encoding="utf-8")


def make(root, names):
    """Runs the cases that are not finished and draws the pictures, or those with the names."""
    unknown = set(names) - {picture.name for picture in PICTURES}
    if unknown:
        print(f"scripts/document: there is no picture {', '.join(sorted(unknown))}", file=sys.stderr)
        return 1
    for picture in PICTURES:
        if names and picture.name not in names:
            continue
        folder = root / "output" / picture.folder
        if read_progress(folder) != "finished":
            shell(picture.run.replace("swim", "swim --resume-or-start", 1), root)
        for command in picture.commands:
            shell(command, root)
        target = root / "doc" / "gallery" / f"{picture.name}.png"
        target.parent.mkdir(exist_ok=True)
        is_field = picture.file in (f"plots/{name}.png" for name in ("vorticity", "vortices", "slices"))
        target.write_bytes(shrink((folder / picture.file).read_bytes(), is_field))
        print(f"{target} ({target.stat().st_size / 1000:.0f} kB)")
    write_page(root)
    return 0
