"""The package beside the C header: no function and no constant is forgotten."""

from __future__ import annotations

import re

import pytest
import qtraj
from conftest import SOURCE
from qtraj import _words

HEADER = (SOURCE / "include" / "qtraj.h").read_text()
CODE = re.sub(r"/\*.*?\*/", "", HEADER, flags=re.S)
FUNCTIONS = sorted(set(re.findall(r"QTRAJ_API[^;]*?\b(qtraj_\w+)\(", CODE)))

# What does the work of each C function; twins of float32 go with their double.
COVERED = {
    "qtraj_version": "library_version",
    "qtraj_status_text": "status_text",
    "qtraj_target": "target",
    "qtraj_create_with_options": "Trajectory",
    "qtraj_create_with_rates": "Trajectory",
    "qtraj_create_with_turns": "Trajectory",
    "qtraj_create_with_tangents": "Trajectory",
    "qtraj_options_set_ends": "Trajectory",
    "qtraj_options_set_end_rates": "Trajectory",
    "qtraj_options_set_tangents": "Trajectory",
    "qtraj_options_set_reference": "Trajectory",
    "qtraj_options_set_extrapolation": "Trajectory",
    "qtraj_options_set_turns": "Trajectory",
    "qtraj_options_set_period": "Trajectory",
    "qtraj_options_set_closure": "Trajectory",
    "qtraj_options_set_longest_gap": "Trajectory",
    "qtraj_sample": "Trajectory.__call__",
    "qtraj_sample_at": "Trajectory.__call__",
    "qtraj_sample_rates": "Trajectory.motion",
    "qtraj_sample_uniform": "Trajectory.uniform",
    "qtraj_uniform_count": "Trajectory.uniform",
    "qtraj_sample_unnormalized": "Trajectory.unnormalized",
    "qtraj_segment_times": "Trajectory.segment_times",
    "qtraj_sample_many": "sample_many",
    "qtraj_even_times": "even_times",
    "qtraj_method": "Trajectory.method",
    "qtraj_key_count": "Trajectory.__len__",
    "qtraj_start_time": "Trajectory.span",
    "qtraj_end_time": "Trajectory.span",
    "qtraj_sign_flips": "Trajectory.diagnostics",
    "qtraj_worst_norm_error": "Trajectory.diagnostics",
    "qtraj_least_dot": "Trajectory.diagnostics",
    "qtraj_iterations": "Trajectory.diagnostics",
    "qtraj_residual": "Trajectory.diagnostics",
    "qtraj_curve_least_norm": "Trajectory.diagnostics",
    "qtraj_keys": "Trajectory.keys",
    "qtraj_curve_jumps": "Trajectory.jumps",
    "qtraj_curve_peak_rates": "Trajectory.peak_rates",
    "qtraj_rate_bounds": "Trajectory.rate_bounds",
    "qtraj_rate_mismatch": "Trajectory.rate_mismatch",
    "qtraj_curve_energy": "Trajectory.energy",
    "qtraj_curve_total_angle": "Trajectory.total_angle",
    "qtraj_vector_create": "VectorCurve",
    "qtraj_vector_sample": "VectorCurve.__call__",
    "qtraj_vector_sample_uniform": "VectorCurve.uniform",
    "qtraj_vector_uniform_count": "VectorCurve.uniform",
    "qtraj_vector_method": "VectorCurve.method",
    "qtraj_vector_key_count": "VectorCurve.__len__",
    "qtraj_vector_dim": "VectorCurve.keys",
    "qtraj_vector_start_time": "VectorCurve.span",
    "qtraj_vector_end_time": "VectorCurve.span",
    "qtraj_vector_keys": "VectorCurve.keys",
    "qtraj_sample_poses": "Poses.motion",
    "qtraj_batch_sample": "sample_batch",
    "qtraj_batch_sample_rates": "sample_batch",
    "qtraj_batch_step_offsets": "sample_batch",
    "qtraj_batch_times": "sample_batch",
    "qtraj_batch_mean_eigen": "batch_mean_eigen",
    "qtraj_slerp_pairs": "slerp",
    "qtraj_nlerp_pairs": "nlerp",
    "qtraj_slerp_pairs_between": "slerp_between",
    "qtraj_nlerp_pairs_between": "nlerp_between",
    "qtraj_screw_pairs": "screw",
    "qtraj_pow": "power",
    "qtraj_rotation_angle": "angle",
    "qtraj_make_continuous_strided": "make_continuous",
    "qtraj_moments_add": "moments",
}
# What is left out on purpose, and why.
LEFT_OUT = {
    "qtraj_version_number": "qtraj.__version__ compares by packaging.version",
    "qtraj_status_class": "the class of the exception or warning",
    "qtraj_options_create": "options are arguments; the package keeps them on the stack by qtraj_options_init",
    "qtraj_options_init": "options are arguments",
    "qtraj_options_destroy": "options are arguments",
    "qtraj_create": "Trajectory calls qtraj_create_with_options, which has every setting",
    "qtraj_destroy": "Python frees what is no longer used",
    "qtraj_vector_destroy": "Python frees what is no longer used",
    "qtraj_init_size": "no memory of the caller in Python",
    "qtraj_init": "no memory of the caller in Python",
    "qtraj_init_with_tangents": "no memory of the caller in Python",
    "qtraj_vector_init_size": "no memory of the caller in Python",
    "qtraj_vector_init": "no memory of the caller in Python",
    "qtraj_sample_rates_at": "a call costs more than the look-up that a cursor saves: Trajectory.motion",
    "qtraj_vector_sample_at": "a call costs more than the look-up that a cursor saves: VectorCurve.motion",
    "qtraj_sample_pose_at": "a call costs more than the look-up that a cursor saves: Poses.motion",
    "qtraj_slerp": "slerp of one pair broadcasts",
    "qtraj_nlerp": "nlerp of one pair broadcasts",
    "qtraj_slerp_between": "slerp_between of one pair broadcasts",
    "qtraj_make_continuous": "make_continuous along an axis is qtraj_make_continuous_strided",
}


def found(name: str) -> bool:
    value: object = qtraj
    for part in name.split("."):
        value = getattr(value, part, None)
    return value is not None


@pytest.mark.parametrize("function", [name for name in FUNCTIONS if not name.endswith("_f32")])
def test_every_c_function_is_there_or_left_out_for_a_reason(function):
    plain = function.removeprefix("qtraj_")
    if function in LEFT_OUT:
        assert function not in COVERED and LEFT_OUT[function]
    else:
        assert found(COVERED.get(function, plain)), f"{function}: neither covered nor left out"


def test_the_lists_name_no_function_that_is_not_there():
    assert set(COVERED) | set(LEFT_OUT) <= set(FUNCTIONS)


@pytest.mark.parametrize(
    ("family", "prefix"),
    [
        (_words.METHODS, "QTRAJ_(SLERP|NLERP|SQUAD|LOG_SPLINE|ROTATION_SPLINE|HERMITE|ROTATION_QUINTIC|QUATERNION_QUINTIC|STEP|QUATERNION_HERMITE)"),
        (_words.VECTOR_METHODS, r"QTRAJ_VECTOR_(\w+)"),
        (_words.FRAMES, r"QTRAJ_FRAME_(\w+)"),
        (_words.ENDS, r"QTRAJ_END_(\w+)"),
        (_words.TANGENTS, r"QTRAJ_TANGENT_(\w+)"),
        (_words.REFERENCES, r"QTRAJ_REFERENCE_(\w+)"),
        (_words.PATHS, r"QTRAJ_PATH_(\w+)"),
        (_words.TURNS, r"QTRAJ_TURNS_(\w+)"),
        (_words.LAYOUTS, r"QTRAJ_LAYOUT_(\w+)"),
    ],
)
def test_words_are_the_constants_of_the_header(family, prefix):
    constants = {name.lower(): int(value) for name, value in re.findall(rf"\b{prefix} = (\d+)", CODE)}
    assert family == constants


def test_extrapolations_are_those_of_the_header():
    constants = {name.lower(): int(value) for name, value in re.findall(r"QTRAJ_EXTRAPOLATE_(\w+) = (\d+)", CODE)}
    assert _words.EXTRAPOLATIONS == {**{k: v for k, v in constants.items() if k != "default"}, "nan": constants["error"]}


def test_statuses_are_those_of_the_header_and_have_a_remedy():
    from qtraj._errors import REMEDIES

    statuses = {int(value): name for name, value in re.findall(r"\bQTRAJ_(?:E_)?(\w+) = (\d+),?", re.search(
        r"typedef enum QTRAJ_NODISCARD qtraj_status \{(.*?)\} qtraj_status", CODE, re.S).group(1))}
    assert _words.STATUSES == statuses
    assert set(REMEDIES) == set(statuses.values()) - {"OK"}
    for number, name in statuses.items():
        assert qtraj.status_name(number) == name and qtraj.status_text(number)


def test_the_version_is_that_of_the_header():
    assert qtraj.__version__ == re.search(r'QTRAJ_VERSION_STRING "([^"]+)"', HEADER).group(1)
