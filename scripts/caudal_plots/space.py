# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of three dimensions: vortices, slices and the surfaces of the bodies."""

import matplotlib
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import (vtkContourFilter, vtkCutter, vtkPolyDataNormals,
                                       vtkTriangleFilter)
from vtkmodules.vtkFiltersGeneral import vtkGradientFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

from caudal import fields

from . import MissingData, flow, render, style

COLOURS = matplotlib.colormaps["RdBu_r"]
SHARE = 0.3  # of the rotation off the bodies that the surface of Q encloses
PIXELS = 1400
HIGHEST = 4.5  # of the picture in perspective [inch]
OPACITY = 0.7  # of vortices, through which the body is seen

# Direction in which the camera looks, what is up, and how the picture is called.
PERSPECTIVE = ((-0.35, 0.8, -0.45), (0, 0, 1))
VIEWS = (((0, 0, -1), (0, 1, 0), "from above", "x", "y"),
         ((0, 1, 0), (0, 0, 1), "from the side", "x", "z"),
         ((-1, 0, 0), (0, 0, 1), "from behind", "y", "z"))


def make_surface(volume):
    """The outside of a body, or the surface that it is, with smooth normals."""
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(volume.grid)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(surface.GetOutputPort())
    normals.SetFeatureAngle(50)
    normals.Update()
    return normals.GetOutput()


def get_q(fluid):
    """Q at the points [1/s^2], smoothed: as the run has written it, or from its velocities."""
    if "Q" in fluid.data:
        return fluid.smooth(fluid.data["Q"])
    gradient = vtkGradientFilter()
    gradient.SetInputData(fluid.grid)
    gradient.SetInputScalars(0, "velocity")  # point data
    gradient.ComputeGradientOff()
    gradient.ComputeQCriterionOn()
    gradient.SetQCriterionArrayName("Q")
    gradient.Update()
    q = gradient.GetOutput().GetPointData().GetArray("Q")
    return fluid.smooth(vtk_to_numpy(q).astype(float))


def get_box(points):
    return np.stack([points.min(axis=0), points.max(axis=0)], axis=1)


def get_wake_box(bodies, domain):
    """The bodies with three lengths of the first behind them, within the domain: (3, 2)."""
    if not bodies:
        return domain
    length = flow.get_length(next(iter(bodies.values())))
    box = get_box(np.concatenate([body.points for body in bodies.values()]))
    box += length * np.array([[-0.3, 3.], [-0.5, 0.5], [-0.5, 0.5]])
    return np.stack([np.maximum(box[:, 0], domain[:, 0]), np.minimum(box[:, 1], domain[:, 1])], axis=1)


def find_level(fluid, bodies):
    """The Q whose surface encloses SHARE of the rotation that is off the bodies: in their layers it is
    so large that a share of that would leave the wake empty."""
    q = np.maximum(get_q(fluid)[fluid.cells].mean(axis=1), 0)
    rotation = q * fluid.sizes
    is_far = flow.find_far(fluid.points[fluid.cells].mean(axis=1), bodies)
    if (rotation * is_far).sum() > 1e-4 * rotation.sum():  # there is a wake: Q is like vorticity squared
        rotation = rotation * is_far
    if not rotation.sum() > 0:
        raise MissingData("There is no vortex: Q is not positive anywhere.")
    order = np.argsort(q)[::-1]
    inside = np.cumsum(rotation[order])
    return style.get_round_limit(q[order[np.searchsorted(inside, SHARE * inside[-1])]])


def make_vortices(fluid, level):
    """The surface of equal Q, with the vorticity about z at its points."""
    data = {"Q": get_q(fluid), "vorticity z": fluid.smooth(
        flow.get_data(fluid, "vorticity")[:, 2])}
    grid = fields.Volume(fluid.points, fluid.cells, data).grid
    grid.GetPointData().SetActiveScalars("Q")
    contour = vtkContourFilter()
    contour.SetInputData(grid)
    contour.SetValue(0, level)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(contour.GetOutputPort())
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput()


def get_limit(vortices, bodies):
    """End of the colour scale on the vortices: most of what lies off the bodies is below it."""
    if not vortices.GetNumberOfPoints():
        return 1.
    strength = abs(vtk_to_numpy(vortices.GetPointData().GetArray("vorticity z")))
    is_far = flow.find_far(vtk_to_numpy(vortices.GetPoints().GetData()), bodies)
    return style.get_round_limit(np.quantile(strength[is_far] if is_far.any() else strength, 0.8))


class Scene:
    """Vortices and bodies at a time, ready to be drawn from any side."""

    def __init__(self, run, time, level=None, limit=None):
        self.bodies = run.read_volumes(time)
        fluid = run.read_volume(time, "fluid")
        self.level = level or find_level(fluid, self.bodies)
        vortices = make_vortices(fluid, self.level)
        self.limit = limit or get_limit(vortices, self.bodies)
        self.actors = [render.make_actor(make_surface(body)) for body in self.bodies.values()]
        seen = [body.points for body in self.bodies.values()]
        if vortices.GetNumberOfPoints():
            seen.append(vtk_to_numpy(vortices.GetPoints().GetData()))
            table = render.make_table(COLOURS, -self.limit, self.limit)
            self.actors.append(render.make_actor(vortices, opacity=OPACITY, name="vorticity z", table=table))
        # No more of the wake than there are vortices.
        self.box = get_wake_box(self.bodies, get_box(fluid.points))
        if seen:
            inner = get_box(np.concatenate(seen))
            inner += 0.05 * np.ptp(inner, axis=1).max() * np.array([-1, 1])
            self.box = np.stack([np.maximum(self.box[:, 0], inner[:, 0]),
                                 np.minimum(self.box[:, 1], inner[:, 1])], axis=1)

    @property
    def place(self):
        """Where the first body is, (3, 1)."""
        bodies = iter(self.bodies.values())
        return get_box(next(bodies).points).mean(axis=1, keepdims=True) if self.bodies else np.zeros((3, 1))

    def render(self, direction, up, width):
        return render.render(self.actors, self.box, direction, up, width)


class Sequence:
    """Pictures of the vortices in perspective that have one size and one scale, those of the last
    output, and move with the first body."""

    def __init__(self, run):
        self.run = run
        self.last = Scene(run, run.times[-1])
        self.box = self.last.box - self.last.place
        extent = render.get_extent(self.box, *PERSPECTIVE)
        self.shape = (extent[3] - extent[2]) / (extent[1] - extent[0])  # height over width

    def render(self, time, width):
        scene = Scene(self.run, time, self.last.level, self.last.limit)
        return render.render(scene.actors, self.box + scene.place, *PERSPECTIVE, width)

    def draw(self, time):
        """As a figure."""
        height = (style.WIDTH - 1) * self.shape
        figure, axes = style.make_figure(1, 1, height + 1.2)
        show(axes[0, 0], *self.render(time, PIXELS))
        axes[0, 0].set_axis_off()
        axes[0, 0].set_title(f"Vortices, Q = {self.last.level:g} s⁻², t = {time:.3f} s")
        add_scale(figure, axes, self.last.limit, COLOURS, "vorticity about z [1/s]")
        return figure


def show(axes, pixels, extent):
    """Pixels on axes in metres."""
    axes.imshow(pixels, extent=extent, aspect="equal", interpolation="antialiased")
    axes.grid(False)


def add_scale(figure, axes, limit, colours, label):
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(-limit, limit), colours)
    figure.colorbar(scale, ax=axes, location="bottom", extend="both", aspect=50, shrink=0.6, pad=0.01,
                    fraction=0.6 / figure.get_figheight(), label=label)


def draw_vortices(run, time=None, limit=None, level=None):
    """The surface of Q coloured by vorticity, in perspective and from three sides."""
    time = run.times[-1] if time is None else time
    scene = Scene(run, time, level, limit)
    lengths = np.ptp(scene.box, axis=1)
    first, extent = render.crop(*scene.render(*PERSPECTIVE, PIXELS))
    top = min((style.WIDTH - 1) * (extent[3] - extent[2]) / (extent[1] - extent[0]), HIGHEST)
    below = (style.WIDTH - 2) / (lengths[0] * 2 + lengths[1]) * max(lengths[1], lengths[2])
    figure = style.plt.figure(figsize=(style.WIDTH, top + below + 1.7), constrained_layout=True)
    grid = figure.add_gridspec(2, 3, height_ratios=(top, below),
                               width_ratios=(lengths[0], lengths[0], lengths[1]))
    panels = [figure.add_subplot(grid[0, :])]
    show(panels[0], first, extent)
    panels[0].set_axis_off()
    figure.suptitle(f"Vortices, Q = {scene.level:g} s⁻², t = {time:.3f} s")
    for number, (direction, up, title, right, above) in enumerate(VIEWS):
        panel = figure.add_subplot(grid[1, number])
        show(panel, *scene.render(direction, up, PIXELS))
        panel.set_title(title)
        panel.set_xlabel(f"{right} [m]")
        panel.set_ylabel(f"{above} [m]")
        panels.append(panel)
    add_scale(figure, panels, scene.limit, COLOURS, "vorticity about z [1/s]")
    return figure


def cut(volume, point, normal, axes):
    """The section of a volume by a plane as a plane field; its axes are the directions @p axes of
    space. None if the plane does not meet it."""
    plane = vtkPlane()
    plane.SetOrigin(*point)
    plane.SetNormal(*normal)
    cutter = vtkCutter()
    cutter.SetInputData(volume.grid)
    cutter.SetCutFunction(plane)
    triangulation = vtkTriangleFilter()
    triangulation.SetInputConnection(cutter.GetOutputPort())
    triangulation.Update()
    mesh = triangulation.GetOutput()
    if mesh.GetNumberOfPolys() == 0:
        return None
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float) @ np.transpose(axes)
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    first, merged = fields.merge_points(points)
    return fields.Field(points[first], merged[triangles], fields.get_arrays(mesh.GetPointData(), merged),
                        mesh)


def get_planes(bodies, domain):
    """(point, normal) of the planes through the middle of the first body: that in which it bends, the
    upright one along it, and one across the wake, half a length behind it."""
    if not bodies:
        return tuple((domain.mean(axis=1), normal) for normal in ((0, 0, 1), (0, 1, 0), (1, 0, 0)))
    body = next(iter(bodies.values()))
    box = get_box(body.points)
    middle, behind = box.mean(axis=1), box.mean(axis=1)
    behind[0] = min(box[0, 1] + 0.5 * flow.get_length(body), (box[0, 1] + domain[0, 1]) / 2)
    return ((middle, (0, 0, 1)), (middle, (0, 1, 0)), (behind, (1, 0, 0)))


def describe_plane(point, normal):
    """The plane as words, and the directions of the picture with their labels."""
    axis = int(np.argmax(np.abs(normal)))
    if np.abs(normal)[axis] > 1 - 1e-6:
        axes = [np.eye(3)[k] for k in range(3) if k != axis]
        return f"{'xyz'[axis]} = {point[axis]:.3g} m", axes, [name for name in "xyz" if name != "xyz"[axis]]
    up = (0, 0, 1) if abs(normal[2]) < 0.9 else (0, 1, 0)
    axes = render.get_axes(normal, up)
    place = ", ".join(f"{x:.3g}" for x in point)
    words = ", ".join(f"{x:.2g}" for x in normal)
    return f"plane through ({place}) m across ({words})", list(axes), ["along", "up"]


def read_slices(run):
    """(time, (point, normal, volume) of each slice) of those that the run has written last."""
    time, blocks = max(run.read_list("slices").items())
    slices = []
    for _, path in sorted(blocks.items()):
        volume = fields.read_volume(path)
        point = volume.points.mean(axis=0)
        normal = np.linalg.svd(volume.points[:: max(len(volume.points) // 1000, 1)] - point)[2][2]
        slices.append((point, normal * np.sign(normal[np.argmax(np.abs(normal))]), volume))
    return time, slices


def make_sections(run):
    """(time, (title, axes, labels, normal, fluid, bodies) of each section): of the slices that the run
    has written or, without them, through the first body and behind it at the last output."""
    sections = []
    if (run.folder / "slices.pvd").is_file():
        time, slices = read_slices(run)
        bodies = run.read_volumes(time) if time in run.files else {}
        planes = [(point, normal) for point, normal, _ in slices]
    else:
        time = run.times[-1]
        bodies, fluid = run.read_volumes(time), run.read_volume(time, "fluid")
        planes = get_planes(bodies, get_box(fluid.points))
        slices = None
    for number, (point, normal) in enumerate(planes):
        title, axes, labels = describe_plane(point, normal)
        # A plane on sides of cells would cut those on both of them.
        moved = np.asarray(point) + 1e-7 * np.abs(point).max() * np.asarray(normal)
        if slices:
            volume = slices[number][2]
            plane = fields.Field(volume.points @ np.transpose(axes), split(volume.cells), volume.data, None)
        else:
            plane = cut(fluid, moved, normal, axes)
        cuts = {name: cut(body, moved, normal, axes) for name, body in bodies.items()}
        sections.append((title, axes, labels, np.asarray(normal), plane,
                         {name: section for name, section in cuts.items() if section}))
    return time, sections


def split(quadrilaterals):
    """Two triangles of each quadrilateral; one of which two corners are one has a single one."""
    triangles = np.concatenate([quadrilaterals[:, [0, 1, 2]], quadrilaterals[:, [0, 2, 3]]])
    a, b, c = triangles.T
    return triangles[(a != b) & (b != c) & (c != a)]


def get_section_limit(sections):
    """End of the colour scale of all sections together: most of the vorticity off the bodies."""
    strengths, weights = [], []
    for _, _, _, normal, plane, cuts in sections:
        strength = abs((flow.get_data(plane, "vorticity") @ normal)[plane.triangles].mean(axis=1))
        is_far = flow.find_far_triangles(plane, cuts) if cuts else np.ones(len(strength), dtype=bool)
        strengths.append(strength[is_far])
        weights.append((strength * plane.areas)[is_far])
    return flow.find_middle(np.concatenate(strengths), np.concatenate(weights))


def get_windows(run, time, sections):
    """What is shown of each section: of one that meets them the bodies and their wake, which are those
    of the last output before the time, else all of it."""
    windows = [flow.get_limits(section[4].points) for section in sections]
    times = [t for t in run.times if t <= time * (1 + 1e-9)]
    bodies = run.read_volumes(times[-1]) if times else {}
    if not bodies:
        return windows
    box = get_wake_box(bodies, get_box(run.read_volume(times[-1], "fluid").points))
    corners = np.stack(np.meshgrid(*box, indexing="ij"), axis=-1).reshape(-1, 3)
    for number, section in enumerate(sections):
        inner = flow.get_limits(corners @ np.transpose(section[1]))
        x0, x1, y0, y1 = (choose(a, b) for choose, a, b in
                          zip((max, min, max, min), windows[number], inner))
        if x1 > x0 and y1 > y0:
            windows[number] = x0, x1, y0, y1
    return windows


def draw_slices(run, limit=None):
    """The vorticity across planes, with the sections of the bodies."""
    time, sections = make_sections(run)
    limit = limit or get_section_limit(sections)
    windows = get_windows(run, time, sections)
    widest = max(w[1] - w[0] for w in windows)
    heights = [(style.WIDTH - 1) * (w[3] - w[2]) / widest for w in windows]
    figure, axes = style.make_figure(len(sections), 1, sum(heights) + 1.1 + 0.6 * len(sections),
                                     gridspec_kw={"height_ratios": heights})
    for panel, (title, _, labels, normal, plane, cuts), window in zip(axes[:, 0], sections, windows):
        style.draw_field(panel, plane, plane.data["vorticity"] @ normal, window, limit, "RdBu_r")
        style.draw_bodies(panel, cuts, with_names=False)
        panel.set_title(f"Vorticity across the plane {title}, t = {time:.3f} s")
        panel.set_xlabel(f"{labels[0]} [m]")
        panel.set_ylabel(f"{labels[1]} [m]")
    add_scale(figure, axes, limit, COLOURS, "vorticity about the plane's normal [1/s]")
    return figure


def make_surface_rows(surfaces):
    """(label, name of point data, colours, low, high) of what is drawn; magnitudes become data."""
    pressures = np.concatenate([surface.data["pressure"] for surface in surfaces.values()])
    middle = np.median(pressures)
    for surface in surfaces.values():
        surface.data["pressure difference"] = surface.data["pressure"] - middle
        for name in ("traction", "velocity"):
            surface.data[f"{name} magnitude"] = np.linalg.norm(surface.data[name], axis=1)

    def get_largest(name):
        values = np.concatenate([abs(surface.data[name]) for surface in surfaces.values()])
        return style.get_round_limit(np.quantile(values, 0.98))

    pressure, traction, speed = (get_largest(name) for name in
                                 ("pressure difference", "traction magnitude", "velocity magnitude"))
    return (("pressure − its median [Pa]", "pressure difference", style.PRESSURE, -pressure, pressure),
            ("traction [Pa]", "traction magnitude", matplotlib.colormaps["viridis"], 0, traction),
            ("speed [m/s]", "velocity magnitude", matplotlib.colormaps["viridis"], 0, speed))


def draw_surface(run):
    """Pressure, traction and speed on the bodies' surfaces, from three sides."""
    time, surfaces = run.read_surfaces()
    rows = make_surface_rows(surfaces)
    box = get_box(np.concatenate([surface.points for surface in surfaces.values()]))
    box += 0.03 * np.ptp(box, axis=1).max() * np.array([-1, 1])
    views = (PERSPECTIVE, *[(direction, up) for direction, up, *_ in VIEWS[:2]])
    meshes = [make_surface(surface) for surface in surfaces.values()]
    pictures = []
    for _, name, colours, low, high in rows:
        table = render.make_table(colours, low, high)
        actors = [render.make_actor(mesh, name=name, table=table) for mesh in meshes]
        pictures.append([render.crop(*render.render(actors, box, *view, PIXELS // 2)) for view in views])
    extents = [extent for _, extent in pictures[0]]
    widths = [extent[1] - extent[0] for extent in extents]
    height = (style.WIDTH - 1.2) * max(extent[3] - extent[2] for extent in extents) / sum(widths)
    figure, axes = style.make_figure(len(rows), len(views), len(rows) * max(height, 1.2) + 0.7,
                                     gridspec_kw={"width_ratios": widths})
    for panels, images, (label, _, colours, low, high) in zip(axes, pictures, rows):
        for panel, image in zip(panels, images):
            show(panel, *image)
            panel.set_axis_off()
        scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(low, high), colours)
        figure.colorbar(scale, ax=list(panels), label=label, extend="both" if low < 0 else "max",
                        aspect=12)
    for panel, title in zip(axes[0], ("in perspective", "from above", "from the side")):
        panel.set_title(title)
    figure.suptitle(f"Surface of {', '.join(surfaces)}, t = {time:.3f} s")
    return figure
