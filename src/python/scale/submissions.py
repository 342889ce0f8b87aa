"""Submissions to every problem of the bank, right ones and others, and their marks by one process."""

import momentous
import pyarrow
from momentous.batch import mark_batch

#: The columns in which marks by any number of processes have to agree.
COLUMNS = ["student", "problem", "form", "seed", "points", "out_of", "report", "fault"]
SCHEMA = pyarrow.schema([(name, pyarrow.string()) for name in COLUMNS[:3]] + [
    ("seed", pyarrow.int64()), ("points", pyarrow.float64()), ("out_of", pyarrow.int64()), ("report", pyarrow.string()), ("fault", pyarrow.string()),
])
#: Variants of a form, each with the answers of several students.
SEEDS = range(1, 11)


def table(rows: int) -> pyarrow.Table:
    """So many submissions. Every tenth cannot be read, and one in a hundred is to a problem that is not there."""
    bank, sheets = momentous.Bank.built_in(), []
    for name in bank.ids():
        problem = bank[name]
        for form in problem.forms or [None]:
            for seed in SEEDS:
                sheets.append((name, form, seed, problem.variant(seed, form=form).answers()))
    columns = {name: [] for name in ("student", "problem", "form", "seed", "answers")}
    for number in range(rows):
        name, form, seed, answers = sheets[number % len(sheets)]
        typed = {part: text if (number // 7 + place) % 3 else text.replace("1", "7") for place, (part, text) in enumerate(answers.items())}
        if number % 10 == 3:
            typed = {part: "about " + text + "?" for part, text in typed.items()}
        columns["student"].append(f"s{number}")
        columns["problem"].append(name if number % 100 != 99 else "impact/no-such-problem")
        columns["form"].append(form)
        columns["seed"].append(seed)
        columns["answers"].append(list(typed.items()))
    kinds = {name: pyarrow.string() for name in ("student", "problem", "form")}
    kinds |= {"seed": pyarrow.int64(), "answers": pyarrow.map_(pyarrow.string(), pyarrow.string())}
    return pyarrow.table({name: pyarrow.array(values, kinds[name]) for name, values in columns.items()})


def marks(submissions: pyarrow.Table) -> pyarrow.Table:
    """The marks by this process, in the order of the students' names."""
    return in_order(mark_batch(submissions))


def in_order(marked: pyarrow.Table) -> pyarrow.Table:
    # Other engines have other kinds of columns for the same texts.
    return marked.select(COLUMNS).cast(SCHEMA).sort_by("student").combine_chunks()
