"""Many submissions at once, in columns: what pandas, polars, DuckDB, pyarrow and Spark hand on as Arrow. It needs ``pip install pyarrow``.

>>> from momentous.batch import mark_batch
>>> marked = mark_batch({
...     "student": ["ada", "bob"],
...     "problem": ["impact/two-carts", "impact/two-carts"],
...     "seed": [7, 8],
...     "answers": [{"v_A2": "1.39 m/s to the left"}, {"v_B2": "2 apples"}],
... })
>>> marked.column_names
['student', 'problem', 'seed', 'answers', 'points', 'out_of', 'report', 'fault']
>>> marked["out_of"].to_pylist()
[5, 5]
"""

from __future__ import annotations

import atexit
import hashlib
import io
import json
import shutil
import tempfile
import zipfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, Iterable, Iterator, List, Optional, Tuple, Union

from ._engine import Bank, mark_rows

if TYPE_CHECKING:
    import pyarrow

#: Rows that are marked at a time: enough for every core, few enough for the memory.
_AT_ONCE = 10_000

#: A row as the engine takes it, and what it gives back: points, those that can be reached and the report, or why there are none.
_Row = Tuple[str, Union[int, str], Optional[str], List[Tuple[str, str]], int, bool]
_Marked = Tuple[Optional[Tuple[float, int, str]], Optional[str]]

#: The folders of banks that came as bytes, by their digest. Each goes with the process.
_unpacked: Dict[str, Bank] = {}


def packed(folder: Union[str, Path]) -> bytes:
    """A course's ``problem_bank/`` with its ``course.yaml`` as bytes, for other machines."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted(Path(folder).rglob("*.yaml")):
            archive.write(path, path.relative_to(folder))
    return packed.getvalue()


def mark_batch(
    submissions: Any,
    *,
    bank: Optional[Union[Bank, bytes]] = None,
    secret: Optional[bytes] = None,
    decimal: str = "point",
) -> "pyarrow.Table":
    """Marks submissions, one in each row, as ``momentous grade`` does, on every core.

    The columns ``problem``, ``seed`` and ``answers`` are needed: answers by part, as a map, a struct, or a text of JSON. The columns
    ``form``, ``hints`` and ``closed`` are used where they are there; all others, such as ``student`` and ``attempt``, are carried along.
    The table that comes back has the same rows in the same order, and four columns more: ``points``, ``out_of``, ``report`` (the object
    that ``momentous grade --format json`` prints), and ``fault``, which says why a row could not be marked.

    ``bank`` is a :class:`Bank`, or what :func:`packed` made of a folder; without it the bank that is built in.
    """
    import pyarrow

    table = _table(pyarrow, submissions)
    bank = _bank(bank)
    marks: List[_Marked] = []
    for rows in _rows(table):
        usable = [row for row in rows if not isinstance(row, str)]
        marked = iter(mark_rows(usable, bank, decimal=decimal, secret=secret))
        marks.extend((None, row) if isinstance(row, str) else next(marked) for row in rows)
    columns: Iterable[Tuple[str, Any, Iterator[Any]]] = (
        ("points", pyarrow.float64(), (own and own[0] for own, _ in marks)),
        ("out_of", pyarrow.int64(), (own and own[1] for own, _ in marks)),
        ("report", pyarrow.string(), (own and own[2] for own, _ in marks)),
        ("fault", pyarrow.string(), (fault for _, fault in marks)),
    )
    for name, kind, values in columns:
        table = table.append_column(name, pyarrow.array(values, kind, size=len(marks)))
    return table


def _table(pyarrow: Any, submissions: Any) -> "pyarrow.Table":
    """Rows of whatever can be handed on as Arrow."""
    if isinstance(submissions, (pyarrow.Table, pyarrow.RecordBatch)):
        table = pyarrow.table(submissions)
    elif isinstance(submissions, dict):
        table = pyarrow.table({name: _column(pyarrow, name, values) for name, values in submissions.items()})
    else:
        table = pyarrow.table(submissions)
    for name in ("problem", "seed", "answers"):
        if name not in table.column_names:
            raise ValueError(f"the table has no column `{name}`; it has {', '.join(table.column_names)}")
    return table


def _column(pyarrow: Any, name: str, values: Any) -> Any:
    """A column; answers of which each row has other parts are a map."""
    if name == "answers" and isinstance(values, list) and any(isinstance(own, dict) for own in values):
        kind = pyarrow.map_(pyarrow.string(), pyarrow.string())
        return pyarrow.array([list(own.items()) for own in values], kind)
    return values


def _rows(table: "pyarrow.Table") -> Iterator[List[Union[_Row, str]]]:
    """The rows as the engine takes them, so many at a time; in place of one that cannot be read, the reason."""
    for start in range(0, table.num_rows, _AT_ONCE):
        part = table.slice(start, _AT_ONCE)
        missing = [None] * part.num_rows
        column = lambda name: part[name].to_pylist() if name in part.column_names else missing
        names = ("problem", "seed", "form", "answers", "hints", "closed")
        yield [_row(*values) for values in zip(*map(column, names))]


def _row(problem: Any, seed: Any, form: Any, answers: Any, hints: Any, closed: Any) -> Union[_Row, str]:
    try:
        pairs = _answers(answers)
    except ValueError as error:
        return f"the answers are no object of JSON: {error}"
    if not isinstance(hints or 0, int) or (hints or 0) < 0:
        return f"`{hints}` is no number of hints"
    return (str(problem or ""), _seed(seed), form or None, pairs, hints or 0, bool(closed))


def _seed(seed: Any) -> Union[int, str]:
    """A seed; a table whose seeds are numbers with gaps holds them as floating-point numbers."""
    if isinstance(seed, float) and seed.is_integer() and 0 <= seed < 2**53:
        return int(seed)
    return seed if isinstance(seed, int) and not isinstance(seed, bool) and 0 <= seed < 2**64 else str(seed)


def _answers(answers: Any) -> List[Tuple[str, str]]:
    """Answers by part. A part without one, as every row of a struct has, is left out."""
    if isinstance(answers, str):
        answers = json.loads(answers) if answers.strip() else {}
        if not isinstance(answers, dict):
            raise ValueError("it is something else")
    pairs = answers.items() if isinstance(answers, dict) else answers or ()
    # polars has no maps: a list of records with a key and a value stands for one.
    pairs = [(own["key"], own["value"]) if isinstance(own, dict) else own for own in pairs]
    return [(name, str(text)) for name, text in pairs if text is not None]


def _bank(bank: Optional[Union[Bank, bytes]]) -> Bank:
    if bank is None:
        return Bank.built_in()
    if isinstance(bank, Bank):
        return bank
    digest = hashlib.sha256(bank).hexdigest()
    if digest not in _unpacked:
        folder = tempfile.mkdtemp(prefix="momentous-")
        atexit.register(shutil.rmtree, folder, ignore_errors=True)
        # The settings of a course are looked for up to a folder of this name.
        home = Path(folder) / "problem_bank"
        with zipfile.ZipFile(io.BytesIO(bank)) as archive:
            archive.extractall(home)
        _unpacked[digest] = Bank(home)
    return _unpacked[digest]
