"""Rotation channels of glTF 2.0 animations, by pygltflib: every node of every animation is a track.

Rotations are ``x y z w``; LINEAR is SLERP along the shorter way, STEP is STEP, CUBICSPLINE has an in-tangent, a key and an
out-tangent each (glTF 2.0, 3.11 and appendix C). Whole numbers of a normalised accessor are fractions (3.11).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from .._optional import optional
from .recording import Recording, RecordingError, ordered

METHODS = {"LINEAR": "slerp", "STEP": "step", "CUBICSPLINE": "quaternion_hermite"}
TYPES = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5126: np.float32}
LARGEST = {5120: 127, 5121: 255, 5122: 32767, 5123: 65535}
WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}


def read_gltf(path: Path) -> list[Recording]:
    """Rotations of all nodes, named ``animation:node``; translations beside them where their times are the same."""
    library = optional("pygltflib", "gltf")
    document = library.GLTF2().load(str(path))
    if document is None:
        raise RecordingError(path, None, "this is no glTF file")
    recordings = []
    for number, animation in enumerate(document.animations):
        places = {c.target.node: animation.samplers[c.sampler] for c in animation.channels if c.target.path == "translation"}
        for channel in animation.channels:
            if channel.target.path != "rotation":
                continue
            sampler = animation.samplers[channel.sampler]
            node = channel.target.node
            name = f"{animation.name or number}:{document.nodes[node].name or node}"
            recordings.append(track(path, document, sampler, places.get(node), name))
    return recordings


def track(path: Path, document: Any, sampler: Any, place: Any, name: str) -> Recording:
    method = sampler.interpolation or "LINEAR"
    times = accessor(path, document, sampler.input)[:, 0]
    q = ordered(accessor(path, document, sampler.output), "xyzw")
    tangents = None
    if method == "CUBICSPLINE":
        parts = q.reshape(-1, 3, 4)
        q, tangents = parts[:, 1], (parts[:, 0], parts[:, 2])
    if len(q) != len(times):
        raise RecordingError(path, None, f"{name}: {len(times)} times for {len(q)} rotations")
    positions = None
    if place is not None and place.input == sampler.input and (place.interpolation or "LINEAR") != "CUBICSPLINE":
        positions = accessor(path, document, place.output)
    return Recording(times, q, positions=positions, tangents=tangents, method=METHODS[method], name=name)


def accessor(path: Path, document: Any, index: int) -> np.ndarray:
    """Rows of an accessor as float64."""
    found = document.accessors[index]
    if found.sparse is not None or found.bufferView is None:
        raise RecordingError(path, None, f"accessor {index} is sparse, which is not read here")
    view = document.bufferViews[found.bufferView]
    data = document.get_data_from_buffer_uri(document.buffers[view.buffer].uri)
    kind, width = np.dtype(TYPES[found.componentType]).newbyteorder("<"), WIDTHS[found.type]
    start = (view.byteOffset or 0) + (found.byteOffset or 0)
    stride = view.byteStride or kind.itemsize * width
    if found.count == 0:
        return np.zeros((0, width))
    end = start + stride * (found.count - 1) + kind.itemsize * width
    if data is None or end > len(data):
        raise RecordingError(path, None, f"accessor {index} reaches past the end of its buffer")
    rows = np.ndarray((found.count, width), kind, data, start, (stride, kind.itemsize)).astype(np.float64)
    if kind.kind in "iu":  # as fractions of the largest
        rows = np.maximum(rows / LARGEST[found.componentType], -1.0)
    return rows
