# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page: sections, tables, charts and pictures as HTML with everything embedded."""

import base64
import html
import json
import math
import pathlib

HERE = pathlib.Path(__file__).resolve().parent


class Html(str):
    """Text that is HTML already. Whatever else is put into a page, added to such text or filled
    into it by format() is escaped: what a run has written can't become markup."""

    def __add__(self, other):
        return Html(str(self) + str(escape(other)))

    def __radd__(self, other):
        return Html(str(escape(other)) + str(self))

    def format(self, *values, **named_values):
        return Html(str.format(self, *map(escape, values),
                               **{name: escape(value) for name, value in named_values.items()}))


def escape(text):
    return text if isinstance(text, Html) else Html(html.escape(str(text)))


def join(parts, separator=""):
    return Html(separator.join(map(escape, parts)))


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
    return Html(text.replace("-", "−"))


def make_element(tag, text, attributes=""):
    return Html(f"<{tag}{attributes and ' ' + attributes}>{escape(text)}</{tag}>")


def make_table(header, rows, caption="", left=(0,)):
    """A table; the columns with the numbers @p left are words, the others numbers."""
    def make_row(tag, cells):
        return make_element("tr", join(make_element(tag, cell, "" if i in left else "class=n")
                                       for i, cell in enumerate(cells)))

    table = (make_element("caption", caption) if caption else "") + \
        make_element("thead", make_row("th", header)) + \
        make_element("tbody", join((make_row("td", row) for row in rows), "\n"))
    return make_element("div", make_element("table", table), 'class="wide"')


def make_tiles(tiles):
    """(label, value, unit) as a row of key figures."""
    return make_element("div", join(
        Html("<div><span>{}</span><b>{}<i>{}</i></b></div>").format(*tile) for tile in tiles),
        'class="tiles"')


def make_note(text):
    return make_element("p", text, 'class="note"')


def make_details(summary, content, is_open=False):
    return make_element("details", make_element("summary", summary) + content,
                        "open" if is_open else "")


def make_data_uri(kind, data):
    return f"data:image/{kind};base64,{base64.b64encode(data).decode()}"


def make_picture(kind, data, caption):
    return Html('<figure class="picture"><img src="{0}" alt="{1}">'
                "<figcaption>{1}</figcaption></figure>").format(make_data_uri(kind, data), caption)


class Page:
    """Collects sections and charts; render() makes the page of them."""

    def __init__(self, title, subtitle):
        self.title, self.subtitle = title, subtitle
        self.sections = []
        self.charts = {}
        self.movies = []
        self.troubles = []  # sentences on damaged files

    def add(self, title, content):
        """A section."""
        self.sections.append((f"section-{len(self.sections) + 1}", title, content))

    def place_charts(self, charts):
        """Registers charts and returns the HTML that holds their place."""
        parts = []
        for chart in charts:
            name = f"chart-{len(self.charts) + 1}"
            self.charts[name] = chart
            note = make_element("p", chart["note"]) if chart.get("note") else ""
            parts.append(Html('<figure class="chart" data-chart="{}"><figcaption>{}</figcaption>{}'
                              '<div class="plot"></div></figure>').format(name, chart["title"], note))
        return make_element("div", join(parts), 'class="charts"')

    def place_movie(self, movie):
        """An animation over a slider; @p movie is a movie.Movie."""
        name = f"movie-{len(self.movies) + 1}"
        frames = [make_data_uri(movie.kind, data) for data in movie.frames]
        self.movies.append({"frames": frames, "captions": movie.captions})
        return Html('<figure class="movie" id="{name}"><img src="{frame}" alt="{title}">'
                    '<div class="controls"><button type="button">Play</button>'
                    '<input type="range" min="0" max="{last}" value="{last}" aria-label="time">'
                    "<output>{caption}</output></div>{scale}<figcaption>{title}</figcaption></figure>"
                    ).format(name=name, frame=frames[-1], title=movie.title, last=len(frames) - 1,
                             caption=movie.captions[-1], scale=movie.scale)


def embed(value):
    """JSON that may stand inside a script element."""
    return json.dumps(value, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")


def render(page):
    style = (HERE / "page.css").read_text(encoding="utf-8")
    chart_script = (HERE / "chart.js").read_text(encoding="utf-8")
    page_script = (HERE / "page.js").read_text(encoding="utf-8")
    contents = join((Html('<a href="#{}">{}</a>').format(name, title)
                     for name, title, _ in page.sections), " · ")
    sections = join((Html('<section id="{}"><h2>{}</h2>\n{}\n</section>').format(*section)
                     for section in page.sections), "\n")
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
<p class="subtitle">{escape(page.subtitle)}</p>
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
