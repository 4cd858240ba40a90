# SPDX-License-Identifier: MIT
"""A function of the library, as clang compiled it, run for all arguments at once, whose words are polynomials (words.py). A call is run
the same way, or taken for its contract, which is then proved of it or checked by enumeration.

Where the compiled code says that a sum or product does not overflow (nsw, nuw), that is proved; and that shifts are by less than the width."""
from run import Broken, Infeasible, Run
from words import Words


class Path(Run, Words):
    """One path: what its calls and loops leave for the theorem."""

    def __init__(self, functions, contracts, decisions):
        Words.__init__(self, decisions)
        self.begin(functions, contracts)
        self.calls, self.squares, self.exact = {}, [], []


def paths(functions, contracts, theorem):
    """Calls theorem(path) for every path; returns how many can be taken. Broken where it does not hold, or none can: from facts that
    contradict each other anything follows."""
    decisions, count = [], 0
    while True:
        path = Path(functions, contracts, decisions)
        try:
            theorem(path)
            count += path.facts.possible([])
        except Infeasible:
            pass
        while decisions and decisions[-1][0] + 1 == decisions[-1][1]:
            decisions.pop()
        if not decisions and not count:
            raise Broken("no path can be taken")
        if not decisions:
            return count
        decisions[-1][0] += 1
