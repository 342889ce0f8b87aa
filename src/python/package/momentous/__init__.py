"""Writes, solves, explains and marks problems on impulse, momentum and restitution.

>>> import momentous
>>> bank = momentous.Bank.built_in()
>>> carts = bank["impact/two-carts"]
>>> carts.forms
['forward', 'find-e']
>>> variant = carts.variant(7)
>>> print(variant.sheet().splitlines()[0])
# Two carts on a straight track
>>> report = variant.mark(variant.answers())
>>> report.is_right, report.score
(True, 1.0)

What is wrong is an exception that says where it is, and the way out.

>>> try:
...     bank["impact/two-cart"]
... except momentous.Error as error:
...     print(error.advice)
did you mean `impact/two-carts`?
"""

from ._engine import Bank, Part, Problem, Report, Variant, __version__, mark
from ._error import Error, Fault

__all__ = ["Bank", "Error", "Fault", "Part", "Problem", "Report", "Variant", "__version__", "mark"]
