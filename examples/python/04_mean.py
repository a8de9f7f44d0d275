"""Readings of one attitude, of which some are wrong: plain means, and one that weighs readings by how well they fit."""

import matplotlib.pyplot as plt
import numpy as np
from qtraj import angle, mean_eigen, mean_karcher, multiply, q_from_rotation_vector

random = np.random.default_rng(1)
truth = q_from_rotation_vector([0.3, -0.2, 1.0])
noise = q_from_rotation_vector(random.normal(0, 0.01, (40, 3)))


def robust(readings, scale=0.03):
    """Weights of Cauchy, from the residuals of the mean before: a few rounds."""
    mean = mean_eigen(readings)
    for _ in range(10):
        mean = mean_eigen(readings, 1 / (1 + (angle(readings, mean) / scale) ** 2))
    return mean


sizes = np.radians(np.linspace(0, 60, 31))
errors = {"mean_eigen": [], "mean_karcher": [], "mean_eigen, reweighted": []}
for size in sizes:
    readings = multiply(truth, noise)
    readings[:6] = multiply(readings[:6], q_from_rotation_vector([size, 0, 0]))  # six of forty are wrong
    for name, mean in zip(errors, (mean_eigen, mean_karcher, robust)):
        errors[name].append(np.degrees(angle(mean(readings), truth)))

print({name: round(float(error[-1]), 2) for name, error in errors.items()})
figure, axes = plt.subplots(figsize=(8, 3.2), layout="constrained")
for name, error in errors.items():
    axes.plot(np.degrees(sizes), error, label=name)
axes.set(xlabel="six of forty readings off by, degrees", ylabel="error of the mean, degrees")
axes.legend()
figure.savefig("04_mean.png", dpi=90)
