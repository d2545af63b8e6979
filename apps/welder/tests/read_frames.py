"""Reads the frames of a run with meshio and prints what it found as JSON, every number as its bytes.

Usage: read_frames.py frames.pvd
"""

import json
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import meshio


def described(array):
    """An array as type, shape and the bytes of its values as 64-bit floats."""
    return {
        "type": str(array.dtype),
        "shape": list(array.shape),
        "bytes": array.astype("<f8").tobytes().hex(),
    }


def read_frame(path):
    """What an independent reader sees in one frame."""
    mesh = meshio.read(path)
    return {
        "points": described(mesh.points),
        "cells": {block.type: block.data.ravel().tolist() for block in mesh.cells},
        "fields": {name: described(values) for name, values in mesh.point_data.items()},
    }


def main():
    series = Path(sys.argv[1])
    frames = []
    for entry in ElementTree.parse(series).getroot().iter("DataSet"):
        frame = read_frame(series.parent / entry.get("file"))
        frame["time_s"] = float(entry.get("timestep")).hex()
        frames.append(frame)
    json.dump(frames, sys.stdout)


main()
