"""Random calls: whatever is passed, the interpreter lives and says what is wrong by an exception of its own kinds."""

from __future__ import annotations

import inspect
import os
import warnings

import numpy as np
import pytest
import qtraj

CALLS = int(os.environ.get("QTRAJ_FUZZ_CALLS", "100000"))
WORDS = ["slerp", "nlerp", "squad", "log_spline", "rotation_spline", "hermite", "rotation_quintic", "quaternion_quintic",
         "quaternion_hermite", "step", "body", "world", "natural", "chord", "periodic", "given", "mean", "hold", "error",
         "nan", "constant_rate", "shortest", "as_given", "from_rates", "rest", "cubic", "linear", "wrong", ""]
TYPES = [np.float64, np.float32, np.float16, np.int64, np.int8, np.uint64, bool, complex, object, ">f8", "<M8[ns]", "S3"]
NUMBERS = [0.0, -0.0, 1.0, -1.0, 0.5, 2.0, np.nan, np.inf, -np.inf, 1e308, 5e-324, 1e-160, 3, -7, 2**63, True]
# what the package may say; MemoryError and OverflowError for sizes that are none
ANSWERS = (TypeError, ValueError, FloatingPointError, MemoryError, OverflowError, IndexError, AttributeError)


class Maker:
    """Random arguments, most of them nearly right."""

    def __init__(self, seed: int) -> None:
        self.r = np.random.default_rng(seed)

    def pick(self, values):
        return values[self.r.integers(len(values))]

    def array(self, width=None):
        r = self.r
        shape = [int(n) for n in r.integers(0, 5, r.integers(0, 3))]
        if width and r.random() < 0.9:
            shape.append(width)
        array = r.normal(size=shape)
        if r.random() < 0.2 and array.size:
            array.flat[r.integers(array.size)] = self.pick(NUMBERS[:12])
        if r.random() < 0.3:
            with np.errstate(all="ignore"):
                try:
                    array = array.astype(self.pick(TYPES))
                except (TypeError, ValueError):
                    pass
        kind = r.integers(12)
        if kind == 0:
            return array.tolist()
        if kind == 1:
            return np.asfortranarray(array)
        if kind == 2 and array.ndim:
            return array[::-1]
        if kind == 3 and array.ndim:
            return np.repeat(array, 2, axis=-1)[..., ::2]
        if kind == 4:
            array.flags.writeable = False
        if kind == 5:
            return np.ma.array(array)
        if kind == 6:
            return np.broadcast_to(array, (2, *array.shape))
        return array

    def times(self, n):
        t = np.cumsum(self.r.uniform(0.01, 1, n))
        if self.r.random() < 0.1 and n:
            t[self.r.integers(n)] = self.pick(NUMBERS[:12])
        return t

    def keys(self, n):
        q = self.r.normal(size=(n, 4))
        return q.astype(np.float32) if self.r.random() < 0.2 else q

    def anything(self):
        return self.pick([lambda: self.pick(NUMBERS), lambda: self.pick(WORDS), self.array, lambda: self.array(4),
                          lambda: self.array(3), lambda: None, lambda: (self.pick(WORDS), self.pick(WORDS)),
                          lambda: (self.array(3), self.pick(WORDS)), dict, object])()

    def settings(self, names):
        return {name: self.anything() for name in names if self.r.random() < 0.04}

    def frame(self, name):
        return {"frame": self.pick(["body", "world"])} if "frame" in KEYWORDS.get(name, []) and self.r.random() < 0.9 else {}

    def arguments(self, name):
        """Positional arguments that fit, most of the time: rows of one number, or one row for all."""
        n = int(self.r.integers(0, 6))
        arguments = []
        for parameter in POSITIONAL[name]:
            width = WIDTHS.get(parameter, ())
            if self.r.random() < 0.04:
                arguments.append(self.anything())
            elif parameter in ("count", "status"):
                arguments.append(int(self.r.integers(-1, 60)))
            elif parameter in ("times", "key_times", "x"):
                arguments.append(self.times(n))
            elif parameter in ("columns", "ns"):
                arguments.append(self.r.integers(-(2**62), 2**62, (3, n)))
            else:
                lead = () if self.r.random() < 0.2 and parameter not in ("y", "rows") else (n,)
                rows = self.r.normal(size=lead + width)
                if self.r.random() < 0.1 and rows.size:
                    rows.flat[self.r.integers(rows.size)] = self.pick(NUMBERS[:12])
                arguments.append(rows if self.r.random() < 0.9 else rows.astype(np.float32))
        return arguments


SETTINGS = ["scalar_first", "omega", "alpha", "frame", "ends", "tangents", "reference", "turns", "extrapolate",
            "longest_gap", "period", "closure", "dtype"]
WIDTHS = {
    **dict.fromkeys(["a", "b", "q", "q0", "q1", "q_a", "q_b", "q_xyzw", "dq", "ddq", "key_q"], (4,)),
    **dict.fromkeys(["v", "r", "p_a", "p_b", "omega", "alpha", "y", "rows"], (3,)),
    "matrix": (3, 3),
    "moments": (11,),
}
FUNCTIONS = [name for name in qtraj.__all__ if callable(getattr(qtraj, name)) and not isinstance(getattr(qtraj, name), type)]
SIGNATURES = {name: inspect.signature(getattr(qtraj, name)).parameters.values() for name in FUNCTIONS}
POSITIONAL = {name: [p.name for p in ps if p.default is p.empty and p.kind is p.POSITIONAL_OR_KEYWORD] for name, ps in SIGNATURES.items()}
KEYWORDS = {name: [p.name for p in ps if p.default is not p.empty or p.kind is p.KEYWORD_ONLY] for name, ps in SIGNATURES.items()}


def curve_of(make):
    n = int(make.r.integers(0, 9))
    method = make.pick(WORDS[:10])
    rates = {}
    if method in ("hermite", "rotation_quintic", "quaternion_quintic") or make.r.random() < 0.05:
        rates = {"omega": make.r.normal(size=(n, 3)), "frame": make.pick(["body", "world"])}
        if method != "hermite":
            rates["alpha"] = make.r.normal(size=(n, 3))
    if method == "quaternion_hermite":
        rates["tangents"] = make.r.normal(size=(n, 4))
    return qtraj.Trajectory(make.times(n), make.keys(n), method, **{**rates, **make.settings(SETTINGS)})


def use(curve, make):
    choice = make.r.integers(8)
    t = make.array() if make.r.random() < 0.7 else make.anything()
    frame = make.pick(["body", "world", "wrong", None])
    if choice == 0:
        curve(t, make.pick([0, 1, 2, 3]), frame=frame)
    elif choice == 1:
        curve.motion(t, frame=frame)
    elif choice == 2:
        curve(t, out=make.anything())
    elif choice == 3:
        name = make.pick(["rate", "step", "count"])
        value = make.pick([0, 1, 2.5, 7, -3, np.nan, 1e6, None, "a"])
        # no more samples than a test may take
        if not (name != "count" and isinstance(value, float) and value > 1e5):
            curve.uniform(**{name: value}, **make.settings(["start"]))
    elif choice == 4:
        curve.diagnostics, curve.jumps(frame=frame), curve.rate_mismatch(), repr(curve), curve == curve
    elif choice == 5:
        curve.segment_times(make.pick([2, 3, -1, 0, 10**30]))
    elif choice == 6:
        curve.unnormalized(t)
    else:
        qtraj.sample_many([curve] * int(make.r.integers(4)), t, rates=frame, layout=make.pick(["series_first", "time_first", 3]))


def call_of(make):
    choice = make.r.integers(10)
    if choice < 3:
        use(curve_of(make), make)
    elif choice == 3:
        n = int(make.r.integers(0, 7))
        values = make.r.normal(size=(n, make.r.integers(0, 4)))
        curve = qtraj.VectorCurve(make.times(n), values, make.pick(["cubic", "linear", "step", "hermite"]),
                                  **make.settings(["first", "second", "ends", "extrapolate", "longest_gap", "period", "dtype"]))
        curve(make.array(), make.pick([0, 1, 2]))
    elif choice == 4:
        n = int(make.r.integers(0, 20))
        offsets = np.sort(make.r.integers(-1 if make.r.random() < 0.1 else 0, n + 1, make.r.integers(1, 5)))
        if make.r.random() < 0.1:
            make.r.shuffle(offsets)
        if make.r.random() < 0.05:
            offsets = make.array()
        samples = np.sort(make.r.integers(0, 9, len(np.atleast_1d(offsets))))
        qtraj.sample_batch((offsets, make.times(n), make.keys(n)),
                           **make.pick([{"count": 3}, {"step": 0.3}, {"rate": 2.0}, {"at": (samples, make.r.uniform(0, 5, 8))}, {"count": -1}]),
                           method=make.pick(WORDS[:10]), **make.settings(["rates", "omega", "ends", "period", "turns"]))
    else:
        name = make.pick(FUNCTIONS)
        getattr(qtraj, name)(*make.arguments(name), **make.settings(KEYWORDS.get(name, [])), **make.frame(name))


@pytest.mark.long
def test_random_calls_never_crash_and_never_raise_anything_strange():
    answered = refused = 0
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for seed in range(CALLS):
            try:
                call_of(Maker(seed))
                answered += 1
            except ANSWERS:
                refused += 1
            except BaseException as strange:
                raise AssertionError(f"call {seed}: {type(strange).__name__}: {strange}") from strange
    # a fuzzer that is refused everywhere, or nowhere, tries nothing
    assert answered > 0.2 * CALLS and refused > 0.2 * CALLS, f"{answered} answered, {refused} refused"
