"""Trajectories from Parquet to a folder of Parquet by Dask, on two processes: python with_dask.py IN.parquet OUT_FOLDER

A row group is a task; with `Client("scheduler:8786")` the same program runs on many machines.
"""

import sys
from pathlib import Path

import pyarrow.parquet as pq
from batch import sample


def part(source, target, group):
    """One row group; returns how many trajectories it had."""
    keys = pq.ParquetFile(source).read_row_group(group)
    pq.write_table(sample(keys), Path(target) / f"part-{group:05}.parquet")
    return keys.num_rows


def main(source, target):
    from dask.distributed import Client, LocalCluster

    Path(target).mkdir(exist_ok=True)
    groups = range(pq.ParquetFile(source).num_row_groups)
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        client.upload_file(str(Path(__file__).with_name("batch.py")))
        return sum(client.gather(client.map(part, [source] * len(groups), [target] * len(groups), groups)))


if __name__ == "__main__":
    print(main(*sys.argv[1:]), "trajectories")
