# SPDX-License-Identifier: MIT
"""A mesh file as three.js draws it and as the full tracer draws it: same camera, same light."""
import base64
import dataclasses
import http.server
import pathlib
import subprocess
import sys
import tempfile
import threading
import urllib.parse

import numpy
import OpenImageIO

sys.path.append(str(pathlib.Path(__file__).parent.parent))

from browser import start_browser  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
THREE = HERE.parent.parent / "docs/node_modules/three"
WIDTH, HEIGHT = 200, 160
FOV = 40  # degrees, horizontal
EYE = (1.5, 1.1, 2.7)  # where the light is too: then no shadow can be seen
KEY = (3, 0, 3)  # the background: no surface is as bright
LEAST_IOU = 0.99
LARGEST_DIFFERENCE = 0.02  # linear, the mean over all pixels and channels


def find_three():
    """Whether three.js is installed, and Chromium."""
    return THREE.is_dir() and pathlib.Path("/usr/bin/chromium").exists()


class _Files(http.server.SimpleHTTPRequestHandler):
    """/three/ is the npm package, /page/ this folder, and all else the disk."""

    def translate_path(self, path):
        path = urllib.parse.unquote(urllib.parse.urlsplit(path).path)
        for prefix, folder in (("/three/", THREE), ("/page/", HERE)):
            if path.startswith(prefix):
                return str(folder / path.removeprefix(prefix))
        return path

    def log_message(self, *arguments):
        pass


class Three:
    """three.js in headless Chromium, on a server of this machine; nothing beyond it is reached."""

    def __enter__(self):
        self._profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self._server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), _Files)
        threading.Thread(target=self._server.serve_forever, daemon=True).start()
        self._browser = start_browser(self._profile.name, "--enable-unsafe-swiftshader",
                                      "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1")
        self._browser.set_script_timeout(60)
        return self

    def __exit__(self, *_):
        self._browser.quit()
        self._server.shutdown()
        self._profile.cleanup()

    def draw(self, file):
        """Its picture, linear RGB, and the scale and then the position that let it fill the picture. A RuntimeError has
        what three.js says where it can't read the file."""
        # A page of its own each, so that none inherits what another left on the device.
        self._browser.get(f"http://127.0.0.1:{self._server.server_port}/page/three.html")
        view = {"width": WIDTH, "height": HEIGHT, "fov": FOV, "eye": EYE, "key": KEY}
        result = self._browser.execute_async_script("""
            const [url, kind, view, done] = arguments
            const start = () => window.draw
                ? window.draw(url, kind, view).then(done, (error) => done({ error: String(error?.message ?? error) }))
                : setTimeout(start, 5)
            start()""", urllib.parse.quote(str(file.resolve())), file.suffix[1:].lower(), view)
        if "error" in result:
            raise RuntimeError(result["error"])
        pixels = numpy.frombuffer(base64.b64decode(result["pixels"]), "<f4").reshape(HEIGHT, WIDTH, 4)[..., :3]
        return pixels, result["scale"], result["position"]


def quoted(path):
    """As a TOML string."""
    return '"' + str(path).replace("\\", "\\\\").replace('"', '\\"') + '"'


SCENE = """
[image]
size = [{width}, {height}]
[camera]
position = {eye}
look_at = [0, 0, 0]
fov = {fov}
[background]
color = {key}
[[meshes]]
file = {file}
scale = {scale!r}
position = {position}
[[lights]]
type = "point"
position = {eye}
intensity = {intensity!r}
"""


@dataclasses.dataclass
class Drawn:
    code: int
    said: str  # on standard error
    pixels: numpy.ndarray | None  # linear RGB


def run_tracer(program, scene, out):
    """Draws the scene's file."""
    done = subprocess.run([program, scene, "--display", "none", "--method", "terminator=none", "--out", out], text=True,
                          capture_output=True, check=False, timeout=120)
    pixels = None
    if done.returncode == 0:
        # Not an ImageBuf: its cache may have another picture of that name.
        picture = OpenImageIO.ImageInput.open(str(out))
        pixels = picture.read_image(OpenImageIO.FLOAT)[..., :3]
        picture.close()
    return Drawn(done.returncode, done.stderr.strip(), pixels)


def draw_mesh(program, file, scale, position, folder):
    scene = folder / "scene.toml"
    text = SCENE.format(width=WIDTH, height=HEIGHT, eye=list(EYE), fov=FOV, key=list(KEY), file=quoted(file.resolve()),
                        scale=scale, position=position, intensity=float(numpy.dot(EYE, EYE)))
    scene.write_text(text, encoding="utf-8")
    return run_tracer(program, scene, folder / "ours.exr")


@dataclasses.dataclass
class Comparison:
    iou: float  # of the silhouettes: intersection over union
    difference: float  # the mean of |ours - theirs| over what both cover

    @property
    def agrees(self):
        return self.iou >= LEAST_IOU and self.difference <= LARGEST_DIFFERENCE


def compare(ours, theirs):
    ours_covers, theirs_covers = (numpy.any(numpy.abs(picture - KEY) > 0.01, axis=-1) for picture in (ours, theirs))
    both = ours_covers & theirs_covers
    union = numpy.count_nonzero(ours_covers | theirs_covers)
    return Comparison(iou=numpy.count_nonzero(both) / union if union else 0.0,
                      difference=float(numpy.abs(ours - theirs)[both].mean()) if both.any() else 1.0)


def save_pair(file, ours, theirs):
    """Side by side, ours left, sRGB, the background grey."""
    pair = numpy.concatenate([picture if picture is not None else numpy.full((HEIGHT, WIDTH, 3), KEY)
                              for picture in (ours, theirs)], axis=1)
    background = numpy.all(numpy.abs(pair - KEY) <= 0.01, axis=-1)
    light = numpy.clip(pair, 0, 1)
    codes = numpy.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    codes[background] = 0.5
    picture = OpenImageIO.ImageBuf(OpenImageIO.ImageSpec(pair.shape[1], pair.shape[0], 3, OpenImageIO.UINT8))
    picture.set_pixels(OpenImageIO.ROI(), codes.astype("float32"))
    picture.write(str(file))
