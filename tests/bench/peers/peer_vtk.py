#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The scene with VTK: off-screen, multisampled, PNG by its own writer at the fastest level.

Debian's VTK draws through X alone, so a virtual screen runs beside it (Xvfb); the drawing is done in this process.
The glass needs no depth peeling: its far half is drawn after all that is opaque, its near half last. The renderer's own
order-independent pass is replaced by plain blending in that order, which is cheaper, exact here, and multisampled. With
--full the glass has a soft shadow, a picture on a square, and a faint mirror image, a second glass below the floor.
"""
import math
import os
import subprocess

import vtk
import numpy
from vtk.util import numpy_support

import peer

GLASS_OPACITY = 0.35
FLOOR_OPACITY = 0.75
FONT = "/usr/share/texmf/fonts/opentype/public/tex-gyre/texgyreheros-regular.otf"
TUBE_SIDES = 8
MSAA = 4
SPHERE_STEPS = (96, 48)  # round the silhouette to 0.3 px


def start_screen():
    """Starts Xvfb on a free display and returns its process."""
    ours, its = os.pipe()
    screen = subprocess.Popen(["Xvfb", "-displayfd", str(its), "-screen", "0", "64x64x24", "-nolisten", "tcp"],
                              pass_fds=[its], stderr=subprocess.DEVNULL)
    os.close(its)
    with os.fdopen(ours) as told:
        os.environ["DISPLAY"] = ":" + told.readline().strip()
    return screen


def cpu_of(process):
    with open(f"/proc/{process.pid}/stat", encoding="ascii") as stat:
        fields = stat.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def actor_of(algorithm, color=None):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(algorithm.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    if color:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(color[:3])
    actor.GetProperty().SetAmbient(0.4)
    actor.GetProperty().SetDiffuse(0.7)
    actor.GetProperty().SetSpecular(0.3)
    actor.GetProperty().SetSpecularPower(30)
    return actor


def polylines(curves):
    """One mesh of lines with a colour each."""
    points, cells, colors = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkUnsignedCharArray()
    colors.SetNumberOfComponents(3)
    for curve in curves:
        line = peer.closed_points(curve)
        cells.InsertNextCell(len(line))
        for point in line:
            cells.InsertCellPoint(points.InsertNextPoint(point))
        colors.InsertNextTuple3(*(round(255 * c) for c in curve["color"][:3]))
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetLines(cells)
    data.GetCellData().SetScalars(colors)
    return data


def tubes(curves):
    """All tubes as one mesh: one draw call."""
    joined = vtk.vtkAppendPolyData()
    for curve in curves:
        tube = vtk.vtkTubeFilter()
        tube.SetInputData(polylines([curve]))
        tube.SetRadius(curve["radius"])
        tube.SetNumberOfSides(TUBE_SIDES)
        joined.AddInputConnection(tube.GetOutputPort())
    joined.Update()
    return actor_of(joined)


def glass_half(ellipsoid, near):
    sphere = vtk.vtkSphereSource()
    sphere.SetRadius(1.0)
    sphere.SetThetaResolution(SPHERE_STEPS[0])
    sphere.SetPhiResolution(SPHERE_STEPS[1])
    stretch = vtk.vtkTransform()
    stretch.Scale(ellipsoid["semi_axes"])
    stretched = vtk.vtkTransformPolyDataFilter()
    stretched.SetInputConnection(sphere.GetOutputPort())
    stretched.SetTransform(stretch)
    actor = actor_of(stretched, ellipsoid["color"])
    look = actor.GetProperty()
    look.SetOpacity(GLASS_OPACITY)
    look.SetSpecular(0.8)
    look.SetSpecularPower(60)
    (look.BackfaceCullingOn if near else look.FrontfaceCullingOn)()
    return actor


def floor_actors(floor):
    half = peer.GRID_HALF
    plane = vtk.vtkPlaneSource()
    plane.SetOrigin(-half, -half, floor["z"] - 0.002)
    plane.SetPoint1(half, -half, floor["z"] - 0.002)
    plane.SetPoint2(-half, half, floor["z"] - 0.002)
    ground = actor_of(plane, (0.88, 0.90, 0.93))
    ground.GetProperty().LightingOff()
    ground.GetProperty().SetOpacity(FLOOR_OPACITY)  # L goes on below it
    lines = vtk.vtkTrivialProducer()
    lines.SetOutput(polylines([{"points": [a, b], "closed": False,
                                "color": (0.66, 0.71, 0.76) if heavy else (0.79, 0.83, 0.87)}
                               for a, b, heavy in peer.grid_lines(floor)]))
    grid = actor_of(lines)
    grid.GetProperty().LightingOff()
    return [ground, grid]


def arrow_actor(arrow):
    source = vtk.vtkArrowSource()
    length = math.dist(arrow["tail"], arrow["tip"])
    source.SetShaftRadius(arrow["radius"] / length)
    source.SetTipRadius(2.6 * arrow["radius"] / length)
    source.SetTipLength(0.14 / length)
    source.SetShaftResolution(24)
    source.SetTipResolution(32)
    return actor_of(source, arrow["color"])


def place_arrow(actor, arrow):
    """vtkArrowSource points from the origin along x, one unit long."""
    tail, tip = (numpy.array(arrow[end]) for end in ("tail", "tip"))
    length = numpy.linalg.norm(tip - tail)
    along = (tip - tail) / length
    side = numpy.cross(along, (1, 0, 0) if abs(along[0]) < 0.9 else (0, 1, 0))
    side /= numpy.linalg.norm(side)
    matrix = numpy.eye(4)
    matrix[:3, :3] = length * numpy.column_stack((along, side, numpy.cross(along, side)))
    matrix[:3, 3] = tail
    actor.SetUserMatrix(matrix_of(matrix))


def matrix_of(array):
    matrix = vtk.vtkMatrix4x4()
    matrix.DeepCopy(array.ravel())
    return matrix


def rotation(wxyz):
    rows = [[0.0] * 3 for _ in range(3)]
    vtk.vtkMath.QuaternionToMatrix3x3(wxyz, rows)
    full = numpy.eye(4)
    full[:3, :3] = rows
    return full


def text_actor(text, color, size=30):
    actor = vtk.vtkTextActor()
    actor.SetInput(text)
    look = actor.GetTextProperty()
    if os.path.exists(FONT):
        look.SetFontFamily(vtk.VTK_FONT_FILE)
        look.SetFontFile(FONT)
    look.SetFontSize(size)
    look.SetColor(color[:3])
    return actor


def plain_passes():
    """Opaque, then translucent in the order of adding, then text."""
    steps = vtk.vtkRenderPassCollection()
    for step in (vtk.vtkLightsPass(), vtk.vtkOpaquePass(), vtk.vtkTranslucentPass(), vtk.vtkOverlayPass()):
        steps.AddItem(step)
    sequence = vtk.vtkSequencePass()
    sequence.SetPasses(steps)
    camera = vtk.vtkCameraPass()
    camera.SetDelegatePass(sequence)
    return camera


def shadow_actor(floor, side=128):
    """A round soft shadow on the floor."""
    across = numpy.linspace(-1, 1, side)
    away = numpy.hypot(*numpy.meshgrid(across, across))
    picture = numpy.zeros((side * side, 4), numpy.uint8)
    picture[:, 3] = (110 * numpy.clip(1 - away, 0, 1) ** 1.5).ravel()
    image = vtk.vtkImageData()
    image.SetDimensions(side, side, 1)
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(picture, deep=True))
    texture = vtk.vtkTexture()
    texture.SetInputData(image)
    texture.InterpolateOn()
    square = vtk.vtkPlaneSource()
    square.SetOrigin(-1.7, -1.7, floor["z"] + 0.001)
    square.SetPoint1(1.3, -1.7, floor["z"] + 0.001)
    square.SetPoint2(-1.7, 1.3, floor["z"] + 0.001)
    actor = actor_of(square)
    actor.SetTexture(texture)
    actor.GetProperty().LightingOff()
    return actor


class Film:
    """The window and what is in it, made once; draw() moves it."""

    def __init__(self, scene, full):
        first = scene["frames"][0]
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(peer.PAPER_BOTTOM)
        self.renderer.SetBackground2(peer.PAPER_TOP)
        self.renderer.GradientBackgroundOn()
        self.renderer.SetPass(plain_passes())
        key = vtk.vtkLight()
        key.SetLightTypeToSceneLight()
        key.SetPosition(2.0, 1.0, 4.0)
        self.renderer.AddLight(key)
        self.renderer.LightFollowCameraOff()
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(MSAA)
        self.window.SetSize(*peer.SIZE)
        self.window.AddRenderer(self.renderer)

        self.on_body = [tubes(scene["body_curves"]), glass_half(scene["ellipsoid"], False),
                        glass_half(scene["ellipsoid"], True)]
        ball = vtk.vtkSphereSource()
        ball.SetRadius(scene["ball"]["radius"])
        ball.SetThetaResolution(24)
        ball.SetPhiResolution(24)
        self.mirrored, shadow = None, []
        if full:
            self.mirrored, shadow = glass_half(scene["ellipsoid"], True), [shadow_actor(scene["floor"])]
            self.mirrored.GetProperty().SetOpacity(0.5 * GLASS_OPACITY)
            self.mirror = numpy.diag((1.0, 1.0, -1.0, 1.0))
            self.mirror[2, 3] = 2.0 * scene["floor"]["z"]
            self.renderer.AddActor(self.mirrored)  # first of what is translucent: the floor lies over it
        for actor in [*floor_actors(scene["floor"]), *shadow, tubes(scene["space_curves"]),
                      actor_of(ball, scene["ball"]["color"]), *self.on_body]:
            self.renderer.AddActor(actor)
        self.arrows = [arrow_actor(arrow) for arrow in first["arrows"]]
        self.labels = [text_actor(peer.plain(label["text"]), label["color"]) for label in first["labels"]]
        self.readout = text_actor("\n".join(map(peer.plain, first["readout"])), (0.1, 0.12, 0.15), 26)
        self.readout.GetTextProperty().SetBackgroundColor(1, 1, 1)
        self.readout.GetTextProperty().SetBackgroundOpacity(0.8)
        self.readout.GetTextProperty().SetVerticalJustificationToTop()
        self.readout.SetPosition(40, peer.SIZE[1] - 40)
        for actor in self.arrows + self.labels + [self.readout]:
            self.renderer.AddActor(actor)

        self.grab = vtk.vtkWindowToImageFilter()
        self.grab.SetInput(self.window)
        self.grab.SetInputBufferTypeToRGB()
        self.grab.ReadFrontBufferOff()
        self.grab.ShouldRerenderOff()
        self.writer = vtk.vtkPNGWriter()
        self.writer.SetInputConnection(self.grab.GetOutputPort())
        self.writer.SetCompressionLevel(1)

    def draw(self, frame):
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(frame["eye"])
        camera.SetFocalPoint(frame["target"])
        camera.SetViewUp(frame["up"])
        camera.SetViewAngle(math.degrees(frame["fov_y_rad"]))
        camera.SetClippingRange(0.5, 15.0)
        turn = rotation(frame["rotation"])
        for actor in self.on_body:
            actor.SetUserMatrix(matrix_of(turn))
        if self.mirrored:
            self.mirrored.SetUserMatrix(matrix_of(self.mirror @ turn))
        for actor, arrow in zip(self.arrows, frame["arrows"]):
            place_arrow(actor, arrow)
        for actor, label in zip(self.labels, frame["labels"]):
            self.renderer.SetWorldPoint(*label["anchor"], 1.0)
            self.renderer.WorldToDisplay()
            x, y, _ = self.renderer.GetDisplayPoint()
            actor.SetPosition(x + 12, y - 12)
        self.readout.SetInput("\n".join(map(peer.plain, frame["readout"])))
        self.window.Render()
        self.grab.Modified()
        self.grab.Update()

    def write(self, path):
        self.writer.SetFileName(path)
        self.writer.Write()


def main():
    options = peer.arguments(__doc__)
    screen = start_screen()
    try:
        film = Film(options.scene, options.full)
        peer.measure("VTK", vtk.vtkVersion().GetVTKVersion() + f" MSAA {film.window.GetMultiSamples()}", options,
                     film.draw, film.write, lambda: cpu_of(screen))
        del film
    finally:
        screen.terminate()
        screen.wait()


if __name__ == "__main__":
    main()
