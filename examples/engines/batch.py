"""What all engines call: a batch of trajectories in, their samples out.

A row is a trajectory: `t`, a list of times, and `q`, a flat list of w x y z. The rows of a batch are sampled in one call, so
that an engine's own cost stays small beside it.
"""

import qtraj

COUNT = 20
METHOD = "rotation_spline"
SCHEMA = "id long, t array<double>, q array<double>, status int"


def sample(batch):
    """A pyarrow RecordBatch, or anything with __arrow_c_stream__, with COUNT samples in the place of the keys."""
    return qtraj.sample_batch(batch, count=COUNT, method=METHOD)
