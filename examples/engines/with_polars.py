"""Trajectories from Parquet to Parquet by Polars, streaming: python with_polars.py IN.parquet OUT.parquet"""

import sys

import polars as pl
from batch import sample

SCHEMA = {"id": pl.Int64, "t": pl.List(pl.Float64), "q": pl.List(pl.Float64), "status": pl.Int32}


def main(source, target):
    frame = pl.scan_parquet(source)
    samples = frame.map_batches(lambda part: pl.from_arrow(sample(part)), schema=SCHEMA, streamable=True)
    samples.collect(engine="streaming").write_parquet(target)


if __name__ == "__main__":
    main(*sys.argv[1:])
