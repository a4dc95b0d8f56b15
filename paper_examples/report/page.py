# SPDX-License-Identifier: GPL-3.0-or-later
"""The report as it is written: paragraphs, pictures, commands, and claims that are checked."""

import os


class Claims:
    """How many comparisons were made, and how they came out."""

    def __init__(self):
        self.agree, self.failed, self.differ = 0, 0, []

    def outcome(self, computed, expected, because=None):
        """Compares. `because` says why the paper differs from what is expected of exact results."""
        if computed != expected:
            self.failed += 1
            return f"**FAILED**: {expected} was expected"
        if because:
            self.differ.append(because)
            return f"differs, because {because}"
        self.agree += 1
        return "agrees"


class Chapter:
    """A section of report.md. Commands of `programs` are listed below what they computed."""

    def __init__(self, title, programs):
        self.title, self.programs = title, programs
        self.claims = Claims()
        self._lines, self._rows = [], []

    def say(self, *paragraphs):
        for paragraph in paragraphs:
            self._lines += [" ".join(paragraph.split()), ""]

    def table(self, headings, rows):
        self._lines.append("| " + " | ".join(headings) + " |")
        self._lines.append("|" + "---|" * len(headings))
        self._lines += ["| " + " | ".join(row) + " |" for row in rows]
        self._lines.append("")

    def claim(self, question, paper, computed, expected, because=None, shown=None):
        """A row of the next claims(): what the paper says, what was computed, and whether they agree."""
        outcome = self.claims.outcome(computed, expected, because)
        self._rows.append((question, paper, shown if shown and computed == expected else computed, outcome))

    def check(self, question, paper, holds, shown, because=None):
        """A claim that is true or false: `shown` is what holds."""
        self.claim(question, paper, shown if holds else "not so", shown, because)

    def show_claims(self):
        self.table(("question", "the paper", "exact arithmetic", ""), self._rows)
        self._rows = []

    def picture(self, name, caption):
        self._lines += [f"![{caption}]({name})", "", f"*{caption}*", ""]

    def commands(self):
        """The commands run since the last call, for the reader to run in the report's folder."""
        self._lines += ["```", *dict.fromkeys(self.programs.take_commands()), "```", ""]

    def anchor(self):
        kept = "".join(c for c in self.title.lower() if c.isalnum() or c in " -")
        return "#" + kept.replace(" ", "-")

    def text(self):
        assert not self._rows, "claims that are not shown"
        return "\n".join([f"## {self.title}", "", *self._lines])


class Report:
    def __init__(self, programs):
        self.programs, self.chapters = programs, []

    def chapter(self, title):
        self.chapters.append(Chapter(title, self.programs))
        return self.chapters[-1]

    def failed(self):
        return sum(chapter.claims.failed for chapter in self.chapters)

    def result(self):
        claims = [chapter.claims for chapter in self.chapters]
        text = f"{sum(c.agree for c in claims)} comparisons agree with the paper"
        differ = sum(len(c.differ) for c in claims)
        return f"{text}, {differ} differ from it for a stated reason, {self.failed() or 'none'} failed"

    def write(self, preface):
        lines = [preface, f"**{self.result()}.**", "",
                 "| chapter | agree | differ | failed |", "|---|--:|--:|--:|"]
        for chapter in self.chapters:
            claims = chapter.claims
            lines.append(f"| [{chapter.title}]({chapter.anchor()}) | {claims.agree} "
                         f"| {len(claims.differ)} | {claims.failed} |")
        if any(chapter.claims.differ for chapter in self.chapters):
            lines += ["", "Where exact arithmetic differs:", ""]
            lines += [f"- [{chapter.title.split(':')[0]}]({chapter.anchor()}): {reason}."
                      for chapter in self.chapters for reason in dict.fromkeys(chapter.claims.differ)]
        text = "\n".join([*lines, "", *(chapter.text() for chapter in self.chapters)])
        with open(os.path.join(self.programs.folder, "report.md"), "w", encoding="utf-8") as file:
            file.write(text.rstrip() + "\n")
