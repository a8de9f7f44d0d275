"""Bags of ROS 1 and ROS 2, and MCAP, by rosbags: every topic of poses, and every frame of transforms, is a track."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from .._optional import optional
from .recording import Recording, RecordingError, from_stamps


def pose_of(message: Any, kind: str) -> list[tuple[str, Any, Any, Any]]:
    """Frame, stamp, orientation and position (or None) of what a message holds."""
    name = kind.rpartition("/")[2]
    if name == "TFMessage":
        return [part for transform in message.transforms for part in pose_of(transform, "TransformStamped")]
    stamp = message.header.stamp
    if name == "PoseStamped":
        return [("", stamp, message.pose.orientation, message.pose.position)]
    if name in ("PoseWithCovarianceStamped", "Odometry"):
        return [("", stamp, message.pose.pose.orientation, message.pose.pose.position)]
    if name == "TransformStamped":
        return [(message.child_frame_id, stamp, message.transform.rotation, message.transform.translation)]
    return [("", stamp, message.orientation, None)]  # Imu


KINDS = ("PoseStamped", "PoseWithCovarianceStamped", "Odometry", "TransformStamped", "TFMessage", "Imu")


def read_bag(path: Path) -> list[Recording]:
    """All tracks of a bag: named by topic, of transforms by topic and child frame, ``/tf:base``."""
    highlevel = optional("rosbags.highlevel", "ros")
    typesys = optional("rosbags.typesys", "ros")
    tracks: dict[str, list[tuple[int, list[float], list[float] | None]]] = {}
    try:
        with highlevel.AnyReader([path], default_typestore=typesys.get_typestore(typesys.Stores.LATEST)) as reader:
            wanted = [c for c in reader.connections if c.msgtype.rpartition("/")[2] in KINDS]
            for connection, _, raw in reader.messages(connections=wanted):
                message = reader.deserialize(raw, connection.msgtype)
                for frame, stamp, q, p in pose_of(message, connection.msgtype):
                    seconds = getattr(stamp, "sec", getattr(stamp, "secs", 0))
                    name = f"{connection.topic}:{frame}" if frame else connection.topic
                    position = None if p is None else [p.x, p.y, p.z]
                    nanoseconds = seconds * 10**9 + getattr(stamp, "nanosec", getattr(stamp, "nsecs", 0))
                    tracks.setdefault(name, []).append((nanoseconds, [q.w, q.x, q.y, q.z], position))
    except highlevel.AnyReaderError as wrong:
        raise RecordingError(path, None, str(wrong)) from wrong
    return [made(name, rows) for name, rows in tracks.items()]


def made(name: str, rows: list[tuple[int, list[float], list[float] | None]]) -> Recording:
    stamps, q, positions = zip(*rows, strict=True)
    has_positions = all(position is not None for position in positions)
    return from_stamps(stamps, np.array(q), positions=np.array(positions) if has_positions else None, name=name)
