"""Markers for notebooks: a test of otter, or a cell of nbgrader with partial credit.

>>> import momentous
>>> from momentous import notebooks
>>> variant = momentous.Bank.built_in()["impact/two-carts"].variant(7)
>>> answers = {**variant.answers(), "v_A2": "99 m/s"}

The last line of an autograded cell of nbgrader is the number of points:

>>> 0 < notebooks.points(variant, answers, worth=10) < 10
True

A test of otter passes, or fails with what the student is told:

>>> notebooks.check(variant, answers, part="v_B2")
>>> notebooks.check(variant, answers, part="v_A2")
Traceback (most recent call last):
...
AssertionError: v_A2: ...
"""

from __future__ import annotations

from typing import Mapping, Optional

from ._engine import Variant


def points(variant: Variant, answers: Mapping[str, str], *, worth: float, decimal: str = "point") -> float:
    """What answers earn of the points that the cell is worth."""
    return worth * variant.mark(answers, decimal=decimal).score


def check(variant: Variant, answers: Mapping[str, str], *, part: Optional[str] = None, decimal: str = "point") -> None:
    """Fails where an answer is not right, of one part or of all; the message is what the student is told."""
    report = variant.mark(answers, decimal=decimal)
    if part is not None and all(own.id != part for own in report.parts):
        raise KeyError(f"{variant.problem} asks for {', '.join(own.id for own in report.parts)}, not for {part}")
    wrong = [own for own in report.parts if part in (None, own.id) and not own.is_right]
    if wrong:
        raise AssertionError("\n".join(f"{own.id}: {own.message}" for own in wrong))
