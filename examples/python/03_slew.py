"""A slew of 120 degrees from rest to rest, as quick as a limit of the rate and one of the acceleration allow."""

import matplotlib.pyplot as plt
import numpy as np
from qtraj import Trajectory, q_from_rotation_vector

RATE, ACCELERATION = 0.05, 0.002  # rad/s, rad/s^2
ends = q_from_rotation_vector([[0, 0, 0], [0, np.radians(72), np.radians(96)]])
rest = np.zeros((2, 3))


def slew(duration):
    """From rest to rest, rates and accelerations 0 at both ends."""
    return Trajectory([0, duration], ends, "rotation_quintic", omega=rest, alpha=rest, frame="body")


# a slew of one second tells by how much longer it must be: rates go with 1/T, accelerations with 1/T^2
bounds = slew(1.0).rate_bounds()
duration = max(bounds.omega / RATE, np.sqrt(bounds.alpha / ACCELERATION))
curve = slew(duration)
bounds = curve.rate_bounds()
print(f"{duration:.1f} s, at most {bounds.omega:.4f} rad/s and {bounds.alpha:.5f} rad/s^2")

t = np.linspace(0, duration, 400)
motion = curve.motion(t, frame="body")
figure, axes = plt.subplots(1, 2, figsize=(8, 3.2), layout="constrained")
for axis, values, limit, unit in ((axes[0], motion.omega, RATE, "rad/s"), (axes[1], motion.alpha, ACCELERATION, "rad/s²")):
    axis.plot(t, np.linalg.norm(values, axis=1), lw=2)
    axis.axhline(limit, color="0.6", ls="--")
    axis.set(xlabel="s", ylabel=unit, ylim=(0, 1.1 * limit))
axes[0].set_title("angular speed and its limit")
axes[1].set_title("angular acceleration and its limit")
figure.savefig("03_slew.png", dpi=90)
