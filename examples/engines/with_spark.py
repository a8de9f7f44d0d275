"""Trajectories from Parquet to Parquet by Spark: python with_spark.py IN.parquet OUT_FOLDER (needs a JDK)

mapInArrow hands over Arrow batches of spark.sql.execution.arrow.maxRecordsPerBatch rows.
"""

import os
import sys
from pathlib import Path

from batch import SCHEMA
from pyspark.sql import SparkSession


def part(batches):
    from batch import sample  # on the worker

    for batch in batches:
        yield sample(batch)


def main(source, target):
    os.environ.setdefault("PYSPARK_PYTHON", sys.executable)  # workers are this Python, with what it has installed
    spark = (
        SparkSession.builder.master("local[2]")
        .config("spark.ui.enabled", "false")
        .config("spark.driver.bindAddress", "127.0.0.1")
        .config("spark.driver.host", "127.0.0.1")
        .config("spark.sql.execution.arrow.maxRecordsPerBatch", "20000")
        .getOrCreate()
    )
    spark.sparkContext.addPyFile(str(Path(__file__).with_name("batch.py")))
    spark.read.parquet(source).select("id", "t", "q").mapInArrow(part, SCHEMA).write.mode("overwrite").parquet(target)
    spark.stop()


if __name__ == "__main__":
    main(*sys.argv[1:])
