"""Tables of Arrow, a row for each trajectory: lists of keys in, lists of samples out, one call a batch."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._optional import optional


def sample_table(keys: Any, times: str, q: str, arguments: dict[str, Any]) -> Any:
    """sample_batch() of a table, batch by batch."""
    pa = optional("pyarrow", "arrow")
    for name in ("omega", "alpha", "at"):
        if arguments[name] is not None:
            raise TypeError(f"{name}= goes with arrays, not with a table: pass (offsets, times, q)")
    if isinstance(keys, pa.RecordBatch):
        return sample_record_batch(keys, times, q, arguments)
    if not hasattr(keys, "__arrow_c_stream__"):
        return sample_record_batch(pa.record_batch(keys), times, q, arguments)
    reader = pa.RecordBatchReader.from_stream(keys)
    batches = [sample_record_batch(batch, times, q, arguments) for batch in reader]
    if not batches:
        empty = pa.RecordBatch.from_pylist([], schema=reader.schema)
        batches = [sample_record_batch(empty, times, q, arguments)]
    return pa.Table.from_batches(batches)


def sample_record_batch(batch: Any, times: str, q: str, arguments: dict[str, Any]) -> Any:
    """One call of the library, on the memory of the batch where it lies as the library takes it."""
    from ._batch import sample_series

    pa = optional("pyarrow", "arrow")
    key_offsets, key_times = flat(batch, times, 1)
    q_offsets, key_q = flat(batch, q, 4)
    if not np.array_equal(np.diff(key_offsets), np.diff(q_offsets)):
        row = int(np.flatnonzero(np.diff(key_offsets) != np.diff(q_offsets))[0])
        raise ValueError(
            f"row {row}: {np.diff(key_offsets)[row]} times in {times!r}, {np.diff(q_offsets)[row]} quaternions in {q!r}"
        )
    # both columns may be slices that begin anywhere
    key_times, key_q = key_times[key_offsets[0] :], key_q[q_offsets[0] :]
    n = min(len(key_times), len(key_q))
    result = sample_series(key_offsets - key_offsets[0], key_times[:n], key_q[:n], **arguments)

    missing = batch.column(times).is_null() if batch.column(times).null_count else None
    columns = {name: batch.column(name) for name in batch.schema.names}
    columns[times] = lists(pa, result.offsets, pa.array(result.times), missing)
    columns[q] = lists(pa, result.offsets, numbers(pa, result.q, batch.schema.field(q).type), missing)
    if result.omega is not None and result.alpha is not None:
        for name, rate in (("omega", result.omega), ("alpha", result.alpha)):
            columns[name] = lists(pa, result.offsets, numbers(pa, rate, batch.schema.field(q).type), missing)
    columns["status"] = pa.array(result.status)
    return pa.RecordBatch.from_arrays(list(columns.values()), names=list(columns))


def flat(batch: Any, name: str, width: int) -> tuple[np.ndarray, np.ndarray]:
    """Offsets in rows, int64, and rows of a column of lists: of numbers, of lists of four, or of four times as many."""
    pa = optional("pyarrow", "arrow")
    if name not in batch.schema.names:
        raise TypeError(f"no column {name!r}: there are {', '.join(map(repr, batch.schema.names))}")
    column = batch.column(name)
    if pa.types.is_fixed_size_list(column.type) and not pa.types.is_fixed_size_list(column.type.value_type):
        column = column.cast(pa.list_(column.type.value_type))
    if not (pa.types.is_list(column.type) or pa.types.is_large_list(column.type)):
        raise TypeError(f"column {name!r} is of type {column.type}: lists are needed, one for each trajectory")
    offsets = column.offsets.to_numpy(zero_copy_only=False).astype(np.int64)
    values = column.values
    per_row = width
    if width > 1 and pa.types.is_fixed_size_list(values.type):
        if values.type.list_size != width:
            raise TypeError(f"column {name!r} has lists of {values.type.list_size} numbers, not of {width}")
        values, per_row = values.flatten(), 1
    if not pa.types.is_floating(values.type) and not pa.types.is_integer(values.type):
        raise TypeError(f"column {name!r} holds {values.type}: numbers are needed")
    rows = values.to_numpy(zero_copy_only=False)
    if width == 1:
        return offsets, np.asarray(rows, np.float64)
    if np.any(offsets % per_row):
        raise ValueError(f"column {name!r} has a list whose length is no multiple of {width}")
    return offsets // per_row, rows[: len(rows) // width * width].reshape(-1, width)


def lists(pa: Any, offsets: np.ndarray, values: Any, missing: Any) -> Any:
    """A column of lists; of long ones where 32 bits do not number their elements."""
    per_row = len(values) // offsets[-1] if offsets[-1] else 1
    ends = offsets * per_row
    kind, integer = (pa.ListArray, np.int32) if ends[-1] < 2**31 else (pa.LargeListArray, np.int64)
    return kind.from_arrays(pa.array(ends.astype(integer)), values, mask=missing)


def numbers(pa: Any, rows: np.ndarray, like: Any) -> Any:
    """Rows as the keys had them: lists of a fixed size, or one flat list."""
    values = pa.array(rows.reshape(-1))
    if pa.types.is_fixed_size_list(getattr(like, "value_type", like)):
        return pa.FixedSizeListArray.from_arrays(values, rows.shape[1])
    return values
