# SPDX-License-Identifier: BSD-3-Clause
"""A map file (map_server's MAP.yaml) as pictures show it: in grey, y up, in metres."""
import json
import pathlib

from matplotlib import pyplot, transforms


class DrawnMap:
    """Throws OSError, ValueError or KeyError if the file or its image cannot be read."""

    def __init__(self, file):
        file = pathlib.Path(file)
        keys = dict(line.split(": ", 1) for line in file.read_text().splitlines() if ": " in line)
        self.image = pyplot.imread(file.parent / keys["image"].strip().strip("\"'"))
        self.resolution = float(keys["resolution"])
        self.origin = json.loads(keys["origin"])  # x, y, yaw of the lower left corner

    def show(self, axis, image=None, **style):
        """Draws it, or another image of the same cells, and names the axes."""
        height, width = self.image.shape[:2]
        x, y, yaw = self.origin
        turned = transforms.Affine2D().rotate(yaw).translate(x, y) + axis.transData
        highest = 1.0 if self.image.dtype.kind == "f" else 255
        style = {"cmap": "gray", "vmin": 0, "vmax": highest, "interpolation": "antialiased", **style}
        shown = axis.imshow(self.image if image is None else image, transform=turned,
                            extent=(0, width * self.resolution, 0, height * self.resolution), **style)
        axis.set_aspect("equal")
        axis.set(xlabel="x, m", ylabel="y, m")
        return shown

    def corners(self):
        """Those of the map, x and y."""
        height, width = self.image.shape[:2]
        x, y, yaw = self.origin
        turned = transforms.Affine2D().rotate(yaw).translate(x, y)
        return turned.transform([(a * width * self.resolution, b * height * self.resolution)
                                 for a in (0, 1) for b in (0, 1)])
