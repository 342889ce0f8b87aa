"""What is wrong with a file or an argument."""

from __future__ import annotations

from typing import Iterable, NamedTuple, Optional, Tuple


class Fault(NamedTuple):
    """One thing that is wrong: what, where, and the way out."""

    message: str
    file: str
    line: Optional[int]
    column: Optional[int]
    advice: Optional[str]

    @property
    def place(self) -> Optional[str]:
        """`my-carts.yaml:38:32`; none where it is in no file."""
        parts = [self.file, self.line, self.column]
        return ":".join(str(part) for part in parts if part is not None) if self.file else None


class Error(ValueError):
    """A file or an argument cannot be used. Its text shows every fault with its excerpt."""

    faults: Tuple[Fault, ...] = ()

    @property
    def place(self) -> Optional[str]:
        """Where the first fault is."""
        return self.faults[0].place if self.faults else None

    @property
    def advice(self) -> Optional[str]:
        """The way out of the first fault."""
        return self.faults[0].advice if self.faults else None

    @classmethod
    def _of(cls, text: str, faults: Iterable[tuple]) -> "Error":
        error = cls(text)
        error.faults = tuple(Fault(*fault) for fault in faults)
        return error
