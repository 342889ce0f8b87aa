"""Dask marks a table on two processes: the same marks as one process, row for row."""

import json
import sys
import time

import pandas
import pyarrow

import submissions

ROWS = int(sys.argv[1])


def marked(part: pandas.DataFrame) -> pandas.DataFrame:
    from momentous.batch import mark_batch

    return mark_batch(part).select(submissions.COLUMNS).to_pandas(types_mapper=pandas.ArrowDtype)


if __name__ == "__main__":
    import dask.dataframe
    from dask.distributed import Client, LocalCluster

    table = submissions.table(ROWS)
    # Frames of pandas have no maps.
    answers = [json.dumps(dict(row)) for row in table["answers"].to_pylist()]
    frame = table.drop_columns("answers").to_pandas(types_mapper=pandas.ArrowDtype).assign(answers=answers)
    with LocalCluster(n_workers=2, threads_per_worker=1, env={"RAYON_NUM_THREADS": "1"}) as cluster, Client(cluster):
        start = time.monotonic()
        parts = dask.dataframe.from_pandas(frame, npartitions=16, sort=False)
        there = parts.map_partitions(marked, meta=marked(frame.head(1)).head(0)).compute()
        took = time.monotonic() - start
    found = submissions.in_order(pyarrow.Table.from_pandas(there, preserve_index=False))
    assert found.equals(submissions.marks(table)), "marks differ"
    print(f"{ROWS} rows by Dask on two processes: the same marks, {took:.0f} s")
