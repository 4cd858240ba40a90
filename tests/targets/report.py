# SPDX-License-Identifier: MIT
"""What a conformance image reports, beside what the host finds."""
import re


def judge(text, status, wanted, skips):
    """How many checks have the host's hashes (wanted), and what is wrong with the report, if anything is. Every check must
    be passed, or skipped where the board may do so: `skips` times at most."""
    found = {int(number): value for number, value in re.findall(r"^ok (\d+) - .*: ([0-9a-f]{16})$", text, re.M)}
    skipped = {int(number) for number in re.findall(r"^ok (\d+) - .* # SKIP ", text, re.M)}
    wrong = [number for number, value in found.items() if not 0 < number <= len(wanted) or wanted[number - 1] != value]
    absent = set(range(1, len(wanted) + 1)) - found.keys() - skipped
    trouble = [f"check {number}: not the host's result" for number in wrong]
    trouble += [f"check {number}: neither passed nor skipped" for number in sorted(absent)]
    if len(skipped) > skips:
        trouble.append(f"{len(skipped)} checks are skipped, {skips} may be")
    if f"{len(found)} passed, 0 failed" not in text:
        trouble.append(f"the last line does not count {len(found)} passed, 0 failed")
    if status:
        trouble.append(f"exit status {status}")
    return len(found), trouble
