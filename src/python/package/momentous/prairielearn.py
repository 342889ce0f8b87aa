"""The marker for `server.py` of a question of PrairieLearn.

`question.html` shows the sheet by `{{{params.sheet}}}` and has a field, such as `pl-string-input`, for each part.

>>> import momentous
>>> from momentous import prairielearn
>>> data = {"variant_seed": 7, "params": {}, "correct_answers": {}, "partial_scores": {}, "feedback": {}}
>>> prairielearn.generate(data, "impact/two-carts")
>>> data["submitted_answers"] = {**data["correct_answers"], "v_A2": "99 m/s"}
>>> prairielearn.grade(data)
>>> data["partial_scores"]["v_A2"]["score"], data["partial_scores"]["v_B2"]["score"]
(0.0, 1.0)
"""

from __future__ import annotations

from typing import Any, Dict, Optional

from ._engine import Bank, Variant

#: Under which name `generate` notes what was asked, for `grade`.
_ASKED = "momentous"


def generate(data: Dict[str, Any], problem: str, *, form: Optional[str] = None, secret: Optional[bytes] = None) -> None:
    """Draws the numbers of PrairieLearn's own seed: the sheet into `params`, the right answers into `correct_answers`."""
    variant = _variant(data, problem, form, secret)
    data["params"]["sheet"] = variant._repr_html_()
    data["params"][_ASKED] = {"problem": problem, "form": form}
    data["correct_answers"].update(variant.answers())


def grade(data: Dict[str, Any], *, decimal: str = "point", secret: Optional[bytes] = None) -> None:
    """Marks what was submitted: partial credit and a reason for each part, and the score of the whole."""
    asked = data["params"][_ASKED]
    variant = _variant(data, asked["problem"], asked["form"], secret)
    parts = variant.answers()
    answers = {name: str(text) for name, text in data["submitted_answers"].items() if name in parts and text is not None}
    report = variant.mark(answers, decimal=decimal)
    for part in report.parts:
        score = part.points / part.out_of if part.out_of else 0.0
        partial = data["partial_scores"].setdefault(part.id, {})
        partial.update(score=score, weight=part.out_of, feedback=part.message)
        data["feedback"][part.id] = part.message
    data["score"] = report.score


def _variant(data: Dict[str, Any], problem: str, form: Optional[str], secret: Optional[bytes]) -> Variant:
    return Bank().problem(problem, secret=secret).variant(int(data["variant_seed"]), form=form)
