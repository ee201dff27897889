#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The scene with matplotlib's 3-D axes: Agg, one figure whose artists are made once and moved.

mplot3d sorts whole artists, so the order is set by hand: floor, far half of the glass, curves, near half. Lines are
antialiased by Agg; their widths are those of the tubes at the middle of the scene. With --full curves are lit, segment
by segment, and those on the near side lie over the glass; the backdrop has its gradient and the floor a soft shadow.
"""
import math

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy
import PIL.Image
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

import peer

SURFACE_STEPS = (48, 24)  # patches of the ellipsoid: round enough at half the cost of 96 x 48
GLASS_OPACITY = 0.18  # of each half
NEAR = 0.3  # scene units before the eye
BOX_LOW, BOX_HIGH = -0.095, 0.09  # the window that mplot3d's axes show of what it projects to
LOOK = {"linewidths": 0, "antialiased": False}


def rotation(wxyz):
    w, x, y, z = wxyz
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def ellipsoid_patches(semi_axes):
    """Four corners of each patch, and the outward normal at its middle."""
    u = numpy.linspace(0, 2 * math.pi, SURFACE_STEPS[0] + 1)
    v = numpy.linspace(0, math.pi, SURFACE_STEPS[1] + 1)
    unit = numpy.stack((numpy.outer(numpy.cos(u), numpy.sin(v)), numpy.outer(numpy.sin(u), numpy.sin(v)),
                        numpy.outer(numpy.ones_like(u), numpy.cos(v))), -1)
    corners = numpy.stack((unit[:-1, :-1], unit[1:, :-1], unit[1:, 1:], unit[:-1, 1:]), 2).reshape(-1, 4, 3)
    normals = corners.mean(1) / semi_axes
    return corners * semi_axes, normals / numpy.linalg.norm(normals, axis=1, keepdims=True)


class Film:
    """The figure and its artists, made once; draw() moves them."""

    def __init__(self, scene, full):
        self.full = full
        dpi = 100
        self.figure = plt.figure(figsize=(peer.SIZE[0] / dpi, peer.SIZE[1] / dpi), dpi=dpi)
        self.figure.patch.set_facecolor(peer.PAPER_TOP)
        wide = peer.SIZE[0] / peer.SIZE[1]  # mplot3d's axes are square: one as wide as the picture, cut above and below
        self.axes = self.figure.add_axes((0, 0.5 - 0.5 * wide, 1, wide), projection="3d", computed_zorder=False)
        self.axes.set_axis_off()
        self.axes.patch.set_visible(False)
        self.scene, first = scene, scene["frames"][0]
        self.points_per_unit = 72 / dpi * 0.5 * peer.SIZE[1] / math.tan(0.5 * first["fov_y_rad"]) / math.dist(
            first["eye"], first["target"])
        self.light = numpy.array((2.0, 1.0, 4.0)) / math.sqrt(21)
        self.corners, self.normals = ellipsoid_patches(numpy.array(scene["ellipsoid"]["semi_axes"]))

        self.add_floor(scene["floor"])
        glass = scene["ellipsoid"]["color"][:3]
        self.far, self.near = (Poly3DCollection(self.corners, zorder=order, **LOOK) for order in (3, 6))
        self.glass = numpy.array(glass)
        self.axes.add_collection3d(self.far)
        self.axes.add_collection3d(self.near)
        for curve in scene["space_curves"]:
            self.add_line(curve["points"], curve, 2)
        if full:
            self.add_segments(scene)
            self.add_scenery(scene["floor"])
        else:
            self.body = [(numpy.array(peer.closed_points(curve)), self.add_line([[0, 0, 0]], curve, 4))
                         for curve in scene["body_curves"]]
        self.arrows = [(self.add_line([[0, 0, 0]], arrow, 4),
                        self.axes.plot([0], [0], [0], marker="v", markersize=26, color=arrow["color"][:3],
                                       zorder=4)[0]) for arrow in first["arrows"]]
        self.ball = self.axes.plot([0], [0], [0], marker="o", markersize=9, color=scene["ball"]["color"][:3],
                                   zorder=5)[0]
        self.labels = [self.axes.text(0, 0, 0, "  " + peer.plain(label["text"]), color=label["color"][:3],
                                      fontsize=18, zorder=8) for label in first["labels"]]
        self.readout = self.figure.text(0.02, 0.97, "", va="top", fontsize=16,
                                        bbox={"boxstyle": "round", "facecolor": (1, 1, 1, 0.85)})

    def add_floor(self, floor):
        half, z = peer.GRID_HALF, floor["z"]
        self.square = numpy.array([(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)])
        self.floor_artist = Poly3DCollection([self.square], facecolors=[(0.88, 0.90, 0.93)], zorder=0, **LOOK)
        lines = list(peer.grid_lines(floor))
        self.grid = numpy.array([(a, b) for a, b, _ in lines])
        self.grid_artist = Line3DCollection(
            self.grid, zorder=1, linewidths=[1.2 if heavy else 0.8 for *_, heavy in lines],
            colors=[(0.66, 0.71, 0.76) if heavy else (0.79, 0.83, 0.87) for *_, heavy in lines])
        self.axes.add_collection3d(self.floor_artist)
        self.axes.add_collection3d(self.grid_artist)

    def add_line(self, points, look, order):
        return self.axes.plot(*numpy.transpose(points), color=look["color"][:3], zorder=order,
                              linewidth=2 * look["radius"] * self.points_per_unit)[0]

    def add_segments(self, scene):
        """All curves of the body in pieces, each with a colour of its own."""
        lines = [numpy.array(peer.closed_points(curve)) for curve in scene["body_curves"]]
        self.pieces = numpy.concatenate([numpy.stack((line[:-1], line[1:]), 1) for line in lines])
        counts = [len(line) - 1 for line in lines]
        self.paints = numpy.repeat([curve["color"][:3] for curve in scene["body_curves"]], counts, 0)
        self.widths = numpy.repeat([2 * curve["radius"] * self.points_per_unit for curve in scene["body_curves"]],
                                   counts)
        outward = self.pieces.mean(1) / numpy.array(scene["ellipsoid"]["semi_axes"]) ** 2
        self.outward = outward / numpy.linalg.norm(outward, axis=1, keepdims=True)
        self.halves = [Line3DCollection(self.pieces, zorder=order, capstyle="round") for order in (4, 7)]
        for half in self.halves:
            self.axes.add_collection3d(half)

    def add_scenery(self, floor):
        height = peer.SIZE[1]
        shade = numpy.linspace(0, 1, height)[:, None, None]
        column = (1 - shade) * peer.PAPER_TOP + shade * peer.PAPER_BOTTOM
        self.figure.figimage(numpy.broadcast_to(numpy.uint8(255 * column), (height, peer.SIZE[0], 3)), zorder=-1)
        around = numpy.linspace(0, 2 * math.pi, 60)
        rings = [[(-0.2 + r * math.cos(a), -0.2 + r * math.sin(a), floor["z"]) for a in around]
                 for r in numpy.linspace(0.3, 1.4, 16)]
        self.axes.add_collection3d(Poly3DCollection(rings, facecolors=[(0.2, 0.25, 0.3, 0.025)], zorder=1.5, **LOOK))

    def light_segments(self, turn, frame):
        pieces, outward = self.pieces @ turn.T, self.outward @ turn.T
        near = (outward * (numpy.array(frame["eye"]) - pieces.mean(1))).sum(1) > 0
        along = pieces[:, 1] - pieces[:, 0]
        along /= numpy.linalg.norm(along, axis=1, keepdims=True)
        lit = 0.45 + 0.55 * numpy.sqrt(1 - numpy.square(along @ self.light))  # of a cylinder: its brightest line
        colors = lit[:, None] * self.paints
        for half, chosen in zip(self.halves, (~near, near)):
            half.set_segments(pieces[chosen])
            half.set_color(colors[chosen])
            half.set_linewidth(self.widths[chosen])

    def aim(self, frame):
        """The camera of all others: mplot3d's own looks at the middle of its box."""
        eye, target = numpy.array(frame["eye"]), numpy.array(frame["target"])
        back = (eye - target) / numpy.linalg.norm(eye - target)
        right = numpy.cross(frame["up"], back)
        right /= numpy.linalg.norm(right)
        view = numpy.eye(4)
        view[:3, :3] = right, numpy.cross(back, right), back
        view[:3, 3] = -view[:3, :3] @ eye
        self.toward, self.nearest = -back, -back @ eye + NEAR
        middle = 0.5 * (BOX_LOW + BOX_HIGH)
        zoom = 0.5 * (BOX_HIGH - BOX_LOW) * peer.SIZE[1] / peer.SIZE[0] / math.tan(0.5 * frame["fov_y_rad"])
        lens = numpy.array([[zoom, 0, -middle, 0], [0, zoom, -middle, 0], [0, 0, -1, -2 * NEAR], [0, 0, -1, 0]])
        self.axes.get_proj = lambda: lens @ view

    def move_floor(self):
        """mplot3d does not clip what lies behind the eye, so that is done here."""
        a, b = self.grid[:, 0], self.grid[:, 1]
        before_a, before_b = a @ self.toward - self.nearest, b @ self.toward - self.nearest
        with numpy.errstate(divide="ignore", invalid="ignore"):
            cut = (a * before_b[:, None] - b * before_a[:, None]) / (before_b - before_a)[:, None]
        ends = numpy.stack((numpy.where(before_a[:, None] < 0, cut, a), numpy.where(before_b[:, None] < 0, cut, b)), 1)
        ends[(before_a < 0) & (before_b < 0)] = numpy.nan
        self.grid_artist.set_segments(ends)
        kept = []
        for here, there in zip(self.square, numpy.roll(self.square, -1, 0)):
            before, after = here @ self.toward - self.nearest, there @ self.toward - self.nearest
            if before >= 0:
                kept.append(here)
            if before * after < 0:
                kept.append(here + before / (before - after) * (there - here))
        self.floor_artist.set_verts([kept])

    def draw(self, frame):
        self.aim(frame)
        self.move_floor()
        turn = rotation(frame["rotation"])
        if self.full:
            self.light_segments(turn, frame)
        else:
            for points, line in self.body:
                line.set_data_3d(*(points @ turn.T).T)
        self.draw_glass(turn, frame)
        for (line, head), arrow in zip(self.arrows, frame["arrows"]):
            line.set_data_3d(*numpy.transpose((arrow["tail"], arrow["tip"])))
            head.set_data_3d(*([coordinate] for coordinate in arrow["tip"]))
        for text, label in zip(self.labels, frame["labels"]):
            text.set_position_3d(label["anchor"])
        self.readout.set_text("\n".join(map(peer.plain, frame["readout"])))
        self.figure.canvas.draw()

    def draw_glass(self, turn, frame):
        corners, normals = self.corners @ turn.T, self.normals @ turn.T
        to_eye = numpy.array(frame["eye"]) - corners.mean(1)
        facing = (normals * to_eye).sum(1) > 0
        shade = 0.55 + 0.45 * numpy.clip(normals @ self.light, 0, 1)
        colors = numpy.column_stack((numpy.minimum(shade[:, None] * self.glass * 1.15, 1),
                                     numpy.full(len(shade), GLASS_OPACITY)))
        for half, chosen in ((self.far, ~facing), (self.near, facing)):
            half.set_verts(corners[chosen])
            half.set_facecolor(colors[chosen])

    def write(self, path):
        pixels = PIL.Image.fromarray(numpy.asarray(self.figure.canvas.buffer_rgba())[..., :3])
        pixels.save(path, compress_level=1)


def main():
    options = peer.arguments(__doc__)
    film = Film(options.scene, options.full)
    peer.measure("matplotlib 3-D", matplotlib.__version__, options, film.draw, film.write)


if __name__ == "__main__":
    main()
