# SPDX-License-Identifier: LGPL-2.1-or-later
"""A film of the vorticity, in three dimensions of the vortices, as mp4 and as gif, by ffmpeg."""

import shutil
import subprocess
import sys

from caudal_setup import SETUP

from . import MissingData, flow, space, style

FRAMES_PER_SECOND = 12
GIF_WIDTH = 900  # [pixels]
# The codec that all browsers and presentations know wants even numbers of pixels.
MP4 = ("-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "18",
       "-movflags", "+faststart")
GIF = ("-vf", f"scale={GIF_WIDTH}:-1:flags=lanczos,split[a][b];[a]palettegen=reserve_transparent=0[p];"
       "[b][p]paletteuse",
       "-loop", "0")


def find_ffmpeg():
    """The program; it is installed where scripts/setup can."""
    if not shutil.which("ffmpeg") and SETUP.exists() and shutil.which("dpkg-query"):
        subprocess.run([str(SETUP), "--no-build", "ffmpeg"], stdout=sys.stderr, check=False)
    return shutil.which("ffmpeg")


def get_drawing(run):
    """The function that draws the run at a time, with the scale of the last output."""
    if run.is_spatial:
        return space.Sequence(run).draw
    last = run.times[-1]
    limit = flow.get_vorticity_limit(run.read_fluid(last), run.read_bodies(last))
    return lambda time: flow.draw_vorticity(run, time, limit)


def draw_frames(run, folder):
    """One picture for each output, all with one colour scale; returns their number."""
    draw = get_drawing(run)
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("[0-9]" * 5 + ".png"):  # of an earlier call, when there were more outputs
        old.unlink()
    for number, time in enumerate(run.times):
        figure = draw(time)
        figure.savefig(folder / f"{number:05d}.png")
        style.close(figure)
    return len(run.times)


def encode(ffmpeg, frames, path, options):
    """Makes a film of numbered pictures."""
    command = [ffmpeg, "-y", "-loglevel", "error", "-framerate", str(FRAMES_PER_SECOND),
               "-i", str(frames / "%05d.png"), *options, str(path)]
    result = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        why = (result.stderr.strip().splitlines() or ["it said nothing"])[-1]
        raise MissingData(f"ffmpeg could not make {path}: {why}. The pictures are in {frames}.")
    print(path)


def make(run, folder):
    """Pictures in folder/movie, folder/movie.mp4 and folder/movie.gif."""
    frames = folder / "movie"
    print(f"{frames}: {draw_frames(run, frames)} pictures")
    ffmpeg = find_ffmpeg()
    if ffmpeg is None:
        raise MissingData(f"There is no ffmpeg to make a film of the pictures in {frames}. Debian's "
                          "package ffmpeg has it.")
    encode(ffmpeg, frames, folder / "movie.mp4", MP4)
    encode(ffmpeg, frames, folder / "movie.gif", GIF)
