"""Cassini turns: the angular speed by three methods, from one key in ten, beside what the spacecraft measured."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from qtraj import Trajectory, conjugate

HERE = Path(__file__).resolve().parent
t, *columns = np.loadtxt(HERE.parent / "data" / "cassini_turn.csv", delimiter=",", skiprows=1, unpack=True)
q = conjugate(np.stack(columns[:4], axis=1))  # SPICE's take world to body
measured = np.linalg.norm(np.stack(columns[4:7], axis=1), axis=1)

part = (t > 1700) & (t < 2400)  # a turn begins
times = t[part]
figure, axes = plt.subplots(figsize=(8, 3.2), layout="constrained")
axes.plot(times, 1e3 * measured[part], color="0.8", lw=4, label="measured")
for method in ("slerp", "squad", "rotation_spline"):
    curve = Trajectory(t[::10], q[::10], method)
    speed = np.linalg.norm(curve(times, 1, frame="body"), axis=1)
    error = np.sqrt(np.mean((speed - measured[part]) ** 2))
    print(f"{method:16} off by {1e6 * error:5.1f} urad/s")
    axes.plot(times, 1e3 * speed, lw=1.2, label=method)
axes.set(xlabel="s", ylabel="mrad/s", title="|omega| from keys 40 s apart")
axes.legend()
figure.savefig("02_rates.png", dpi=90)
