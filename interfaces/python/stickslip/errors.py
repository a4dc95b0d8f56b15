# SPDX-License-Identifier: GPL-3.0-or-later
"""The ways in which a call can fail."""

from __future__ import annotations


class InputError(ValueError):
    """Bad input.

    ``file`` is empty when the data did not come from a file ("<grasp>" or "<certificate>" when
    ``check`` was given text). ``place`` is an argument or an
    entry of it ("friction[2]"), a path in a grasp file ("contacts[2].normal") or "line:column".
    ``problem`` says what is wrong and ``remedy`` what would be right (empty where the problem
    says both).
    """

    def __init__(self, file: str, place: str, problem: str, remedy: str) -> None:
        super().__init__(file, place, problem, remedy)
        self.file = file
        self.place = place
        self.problem = problem
        self.remedy = remedy

    def __str__(self) -> str:
        text = "".join(part + ": " for part in (self.file, self.place) if part) + self.problem
        return f"{text}; {self.remedy}" if self.remedy else text


class ContractError(RuntimeError):
    """A check inside the library failed. This is a defect of stickslip; please report it."""


class LimitReached(RuntimeError):
    """The answer is not known; ``limit`` says why, such as "the limit of 300 nodes"."""

    def __init__(self, limit: str) -> None:
        super().__init__(limit)
        self.limit = limit

    def __str__(self) -> str:
        return f"the answer is not known: {self.limit}"
