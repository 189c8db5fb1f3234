# SPDX-License-Identifier: GPL-3.0-or-later
"""The one form that all estimates share which treat the constituents alike but for a comparison medium.

P = sum_i v_i A_i P_i with A_i = (1/(P_i + P*)) / sum_j v_j/(P_j + P*): P* = 0 gives Reuss's mean, P* without bound
Voigt's, and what lies between depends on the medium that the grains of the constituents are thought to lie in
(Walpole, J. Mech. Phys. Solids 14 (1966) 151 and 289; Milton, The Theory of Composites (2002), chapter 10).
"""
import numpy as np

_STEPS = 200
"""At most. Every third halves the bracket, which is enough to bring any two doubles together."""

_CLOSE = 1e-14
"""Relative error that the rounding of logarithms allows for."""


def weights(fractions, values, comparison):
    """The v_i A_i, (n, k), of which each row has the sum 1: what each constituent counts in the mean of `values`.

    fractions (n, k); values (k,) > 0; comparison: P*, >= 0 in the unit of the values, one number or (n,).
    """
    shares = fractions / (values + np.asarray(comparison, float).reshape(-1, 1))
    return shares / shares.sum(axis=1, keepdims=True)


def mean(fractions, values, comparison):
    """P, (n,), of the same arguments: `weights` @ values, but in a third of the time, without rows of few numbers."""
    comparison, top, whole = np.asarray(comparison, float), 0, 0
    for fraction, value in zip(fractions.T, values):
        share = fraction / (value + comparison)
        top, whole = top + share * value, whole + share
    return top / whole


def matching(answer, low, high):
    """The P (n,) with answer(P) = P between `low` and `high`, (n,), both > 0: the medium is the mixture itself.

    answer: a function of (n,) positive numbers that grows, but slower than they do, so that log(answer(P)/P) falls
    and has one root. It is found by Illinois' variant of the false position in log P, with bisections between
    (Dowell and Jarratt, BIT 11 (1971) 168). Repeating P = answer(P) takes for ever where a mixture with pores is
    about to lose its stiffness.
    """

    def excess(place):
        value = low * np.exp(place)
        return np.log(answer(value) / value)

    left, right = np.zeros_like(low), np.log(high / low)
    at_left, at_right = excess(left), excess(right)
    found, before = left, np.zeros_like(low)
    for step in range(_STEPS):
        falling = at_left > at_right
        secant = left + (right - left) * at_left / np.where(falling, at_left - at_right, 1)
        found = np.clip(secant, left, right) if step % 3 < 2 else (left + right) / 2
        at_found = excess(found)
        if np.all((np.abs(at_found) < _CLOSE) | (right - left < _CLOSE)):
            break
        to_left = at_found > 0
        # An end that stays twice loses half its weight, or it would stay for ever.
        side = np.where(to_left, 1, -1)
        weight, before = np.where(side == before, 0.5, 1), side
        at_left = np.where(to_left, at_found, at_left * weight)
        at_right = np.where(to_left, at_right * weight, at_found)
        left, right = np.where(to_left, found, left), np.where(to_left, right, found)
    return low * np.exp(found)
