# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page: sections, tables, charts and pictures as HTML with everything embedded."""

import base64
import html
import json
import math
import pathlib

HERE = pathlib.Path(__file__).resolve().parent


def escape(text):
    return html.escape(str(text))


def format_number(value, digits=4):
    """For tables: significant digits, powers of ten where they are needed."""
    if value is None or not math.isfinite(value):
        return "–"
    if value == 0:
        return "0"
    if float(value).is_integer() and abs(value) < 1e6:
        text = f"{value:,.0f}"
    elif 1e-3 <= abs(value) < 10**digits:
        text = f"{value:#.{digits}g}".rstrip(".")
    elif 1e-3 <= abs(value) < 1e6:
        text = f"{value:,.0f}"
    else:
        mantissa, _, exponent = f"{value:.{digits - 1}e}".partition("e")
        text = f"{mantissa}·10<sup>{int(exponent)}</sup>"
    return text.replace("-", "−")


def make_table(header, rows, caption="", left=(0,)):
    """Rows of HTML cells; the columns with the numbers @p left are words, the others numbers."""
    def make_row(tag, cells):
        return "<tr>" + "".join(f'<{tag}{"" if i in left else " class=n"}>{cell}</{tag}>'
                                for i, cell in enumerate(cells)) + "</tr>"

    return ('<div class="wide"><table>' + (f"<caption>{caption}</caption>" if caption else "")
            + f"<thead>{make_row('th', header)}</thead>"
            + "<tbody>" + "\n".join(make_row("td", row) for row in rows) + "</tbody></table></div>")


def make_tiles(tiles):
    """(label, value, unit) as a row of key figures."""
    return '<div class="tiles">' + "".join(
        f'<div><span>{escape(label)}</span><b>{value}<i>{escape(unit)}</i></b></div>'
        for label, value, unit in tiles) + "</div>"


def make_note(text):
    return f'<p class="note">{text}</p>'


def make_data_uri(kind, data):
    return f"data:image/{kind};base64,{base64.b64encode(data).decode()}"


def make_picture(kind, data, caption):
    return (f'<figure class="picture"><img src="{make_data_uri(kind, data)}" alt="{escape(caption)}">'
            f"<figcaption>{escape(caption)}</figcaption></figure>")


class Page:
    """Collects sections and charts; render() makes the page of them."""

    def __init__(self, title, subtitle):
        self.title, self.subtitle = title, subtitle
        self.sections = []
        self.charts = {}
        self.movies = []
        self.troubles = []  # sentences on damaged files

    def add(self, title, content):
        """A section of HTML."""
        self.sections.append((f"section-{len(self.sections) + 1}", title, content))

    def place_charts(self, charts):
        """Registers charts and returns the HTML that holds their place."""
        parts = []
        for chart in charts:
            name = f"chart-{len(self.charts) + 1}"
            self.charts[name] = chart
            note = f'<p>{escape(chart["note"])}</p>' if chart.get("note") else ""
            parts.append(f'<figure class="chart" data-chart="{name}"><figcaption>'
                         f'{escape(chart["title"])}</figcaption>{note}'
                         '<div class="plot"></div></figure>')
        return '<div class="charts">' + "".join(parts) + "</div>"

    def place_movie(self, movie):
        """An animation over a slider; @p movie is a movie.Movie."""
        name = f"movie-{len(self.movies) + 1}"
        frames = [make_data_uri(movie.kind, data) for data in movie.frames]
        self.movies.append({"frames": frames, "captions": movie.captions})
        return (f'<figure class="movie" id="{name}"><img src="{frames[-1]}" alt="{escape(movie.title)}">'
                '<div class="controls"><button type="button">Play</button>'
                f'<input type="range" min="0" max="{len(frames) - 1}" value="{len(frames) - 1}" '
                f'aria-label="time"><output>{escape(movie.captions[-1])}</output></div>'
                f"{movie.scale}<figcaption>{escape(movie.title)}</figcaption></figure>")


def embed(value):
    """JSON that may stand inside a script element."""
    return json.dumps(value, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")


def render(page):
    style = (HERE / "page.css").read_text(encoding="utf-8")
    chart_script = (HERE / "chart.js").read_text(encoding="utf-8")
    page_script = (HERE / "page.js").read_text(encoding="utf-8")
    contents = " · ".join(f'<a href="#{name}">{escape(title)}</a>' for name, title, _ in page.sections)
    sections = "\n".join(f'<section id="{name}"><h2>{escape(title)}</h2>\n{content}\n</section>'
                         for name, title, content in page.sections)
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<title>{escape(page.title)}</title>
<style>
{style}
</style>
</head>
<body>
<header>
<h1>{escape(page.title)}</h1>
<p class="subtitle">{page.subtitle}</p>
<nav>{contents}</nav>
</header>
<main>
{sections}
</main>
<footer>Written by scripts/report of Caudal from the files of the run; nothing is loaded from elsewhere.</footer>
<script>
{chart_script}
</script>
<script>
const CHARTS = {embed(page.charts)};
const MOVIES = {embed(page.movies)};
{page_script}
</script>
</body>
</html>
"""
