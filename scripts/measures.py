# SPDX-License-Identifier: BSD-3-Clause
"""Statistics that several scripts use."""
import math


def wilson(count, of, z=1.96):
    """Interval of a share, 95 % by default (Wilson, 1927); from 0 to 1 without trials."""
    if of == 0:
        return 0.0, 1.0
    value = count / of
    middle = (value + z * z / (2 * of)) / (1 + z * z / of)
    half = z / (1 + z * z / of) * math.sqrt(value * (1 - value) / of + z * z / (4 * of * of))
    return (0.0 if count == 0 else middle - half), (1.0 if count == of else middle + half)


def share(holds):
    """How often something holds, of a series of truths, with its interval; None of nothing."""
    if len(holds) == 0:
        return None
    low, high = wilson(int(holds.sum()), len(holds))
    return {"count": int(holds.sum()), "of": len(holds), "share": float(holds.mean()), "low": low, "high": high}


def wilson_text(value):
    return f"{100 * value['low']:.1f}–{100 * value['high']:.1f} %"


def never_below(values, part):
    """The smallest value that at least this part of all reach, None if it is infinite. Without
    interpolation: between a number and never there is nothing."""
    ordered = sorted(values)
    value = ordered[max(math.ceil(part * len(ordered) - 1e-9), 1) - 1]
    return None if math.isinf(value) else float(value)
