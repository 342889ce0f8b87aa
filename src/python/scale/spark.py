"""Spark marks a table on two workers, one of which is killed in the midst of it: the same marks as one process, row for row."""

import os
import signal
import subprocess
import sys
import tempfile
import threading
import time

import pyarrow.parquet
from pyspark.sql import SparkSession

import submissions

ROWS = int(sys.argv[1])
SCHEMA = "student string, problem string, form string, seed long, points double, out_of long, report string, fault string"


def marked(batches):
    from momentous.batch import mark_batch

    for batch in batches:
        yield from mark_batch(batch).select(["student", "problem", "form", "seed", "points", "out_of", "report", "fault"]).to_batches()


def workers() -> list[int]:
    """The processes of the workers of this run."""
    listed = subprocess.run(["pgrep", "-f", f"{MARK}.*CoarseGrainedExecutorBackend"], capture_output=True, text=True)
    return [int(line) for line in listed.stdout.split()]


def kill_one() -> None:
    while len(workers()) < 2:
        time.sleep(0.2)
    time.sleep(float(os.environ.get("KILLED_AFTER", "10")))
    victim = workers()[0]
    os.kill(victim, signal.SIGKILL)
    print(f"worker {victim} is killed", flush=True)


MARK = f"momentous.run={os.getpid()}"
table = submissions.table(ROWS)
with tempfile.TemporaryDirectory() as folder:
    pyarrow.parquet.write_table(table, f"{folder}/submissions.parquet")
    spark = (
        SparkSession.builder.master("local-cluster[2,1,1024]")
        .config("spark.executor.extraJavaOptions", f"-D{MARK}")
        .config("spark.executorEnv.RAYON_NUM_THREADS", "1")
        .config("spark.ui.enabled", "false")
        .getOrCreate()
    )
    start = time.monotonic()
    killer = threading.Thread(target=kill_one, daemon=True)
    killer.start()
    there = spark.read.parquet(f"{folder}/submissions.parquet").repartition(16).mapInArrow(marked, SCHEMA)
    there.write.parquet(f"{folder}/marks")
    took = time.monotonic() - start
    killer.join(1)
    assert not killer.is_alive(), "all was marked before a worker was killed: take more rows"
    spark.stop()
    found = submissions.in_order(pyarrow.parquet.read_table(f"{folder}/marks"))
assert found.equals(submissions.marks(table)), "marks differ"
print(f"{ROWS} rows by Spark on two workers, one of them killed: the same marks, {took:.0f} s")
