# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C and SIGTERM as one exception in the main thread."""
import signal

SIGNALS = (signal.SIGINT, signal.SIGTERM)


class Interrupted(BaseException):
    """Someone asked to stop. No Exception, so that nothing on the way takes it for an error."""


def install():
    """From now on a signal raises Interrupted in the main thread."""
    for number in SIGNALS:
        # A shell's background job has SIGINT ignored on purpose.
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, _raise)


def ignore():
    """From now on signals do nothing: for the last steps, which take no time and must not be torn apart."""
    for number in SIGNALS:
        signal.signal(number, signal.SIG_IGN)


def _raise(number, frame):
    raise Interrupted(signal.Signals(number).name)
