"""Tables of pandas, polars and DuckDB are marked as those of Arrow are."""

import sys

import duckdb
import pandas
import polars

import submissions
from momentous.batch import mark_batch

table = submissions.table(int(sys.argv[1]))
expected = submissions.marks(table)
given = {
    "pandas": table.to_pandas(types_mapper=pandas.ArrowDtype),
    "polars": polars.from_arrow(table),
    "DuckDB": duckdb.from_arrow(table),
}
for name, frame in given.items():
    assert submissions.in_order(mark_batch(frame)).equals(expected), name
    print(f"{table.num_rows} rows of {name}: the same marks")
