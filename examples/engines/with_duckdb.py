"""Trajectories from Parquet to Parquet by DuckDB: python with_duckdb.py IN.parquet OUT.parquet

DuckDB reads and selects; batches go through Arrow one by one, so that memory holds one of them at a time.
"""

import sys

import duckdb
import pyarrow.parquet as pq
from batch import sample


def main(source, target):
    keys = duckdb.sql("select id, t, q from read_parquet($source)", params={"source": source})
    writer = None
    for batch in keys.fetch_arrow_reader(20_000):
        samples = sample(batch)
        writer = writer or pq.ParquetWriter(target, samples.schema)
        writer.write_batch(samples)
    if writer:
        writer.close()


if __name__ == "__main__":
    main(*sys.argv[1:])
