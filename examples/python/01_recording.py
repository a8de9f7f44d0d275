"""A hand-held camera, recorded at uneven times with gaps: resampled at 50 Hz, nothing invented where nothing was seen."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from qtraj import Trajectory, recordings

HERE = Path(__file__).resolve().parent
recording = recordings.read(HERE.parent / "data" / "tum_fr2_desk_head.tum")

# the curve goes through all keys; times inside intervals longer than half a second are NaN
curve = Trajectory(recording.times, recording.q, "squad", longest_gap=0.5)
with np.errstate(invalid="ignore"):
    times, q = curve.uniform(rate=50)

print(f"{len(recording)} keys, {len(times)} samples, {np.isnan(q[:, 0]).sum()} of them in gaps")
figure, axes = plt.subplots(figsize=(8, 3.2), layout="constrained")
start = recording.times[0]
for k, name in enumerate("wxyz"):
    (line,) = axes.plot(times - start, q[:, k], lw=1.2, label=name)
    axes.plot(recording.times[::25] - start, curve.keys[::25, k], ".", ms=3, color=line.get_color())
axes.set(xlabel="s", ylabel="quaternion", title="Every 25th key, and samples at 50 Hz that stop at gaps")
figure.legend(loc="outside right center")
figure.savefig("01_recording.png", dpi=90)
# prints: 8000 keys, 2809 samples, 1003 of them in gaps
