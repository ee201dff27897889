# SPDX-License-Identifier: MIT
"""The table that the scripts of benchmarks print."""


class Table:
    """Prints a row as soon as it is known."""

    FORM = "{:<58} {:>14}  {:<40} {}"

    def __init__(self):
        self.missed = 0
        print(self.FORM.format("benchmark", "required", "measured", "holds"))
        print("-" * 122, flush=True)

    def row(self, benchmark, required, measured, holds=None):
        self.missed += holds is False
        print(self.FORM.format(benchmark, required, measured, {True: "yes", False: "NO", None: ""}[holds]), flush=True)
