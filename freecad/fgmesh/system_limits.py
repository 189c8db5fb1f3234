# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits that the system sets for a process (ulimit): which of them an error tells of, and what helps."""
import contextlib
import errno
import resource

MEMORY = "memory"

_OPEN_FILES = "the limit on open files was reached (ulimit -n raises it)"
_FILE_SIZE = "the limit on the size of files was reached (ulimit -f raises it)"
_PROCESSES = "the limit on processes and threads was reached (ulimit -u raises it)"

_BY_NUMBER = {
    errno.EMFILE: _OPEN_FILES,
    errno.ENFILE: _OPEN_FILES,
    errno.EFBIG: _FILE_SIZE,
    errno.EAGAIN: _PROCESSES,
    errno.ENOMEM: MEMORY,
}
_BY_WORDS = {
    "Too many open files": _OPEN_FILES,
    "File too large": _FILE_SIZE,
    "failed to map segment": MEMORY,
    "Cannot allocate memory": MEMORY,
    "MemoryError": MEMORY,
    "can't start new thread": _PROCESSES,
}
"""What libraries say where they give no number of an error."""


def reached(error):
    """What to tell of the limit that `error`, an exception or the last words of a process, comes from; else None."""
    found = _BY_NUMBER.get(getattr(error, "errno", None)) if isinstance(error, OSError) else None
    found = found or next((limit for words, limit in _BY_WORDS.items() if words in str(error)), None)
    if found == _PROCESSES and _address_space() is not None:
        # Threads take address space for their stacks.
        found = MEMORY
    return memory_text() if found == MEMORY else found


def memory_text(limit_mb=None):
    """What to tell where memory ran out: of the limit that is `limit_mb`, or of that of the system, if lower."""
    space = _address_space()
    if space is not None and (limit_mb is None or space < limit_mb):
        return f"the limit of {space:.0f} MB on the memory of a process was reached (ulimit -v raises it)"
    if limit_mb is None:
        return "there is no memory left"
    return f"the memory limit of {limit_mb:.0f} MB was reached"


SHORT_OF = 0.2
"""Of a limit. Whoever has come so near to it has asked for more than was left: libraries ask for large pieces."""


def memory_was_short():
    """Whether this process has been near a limit on its memory. A library may tell of something else that failed then."""
    with contextlib.suppress(OSError, KeyError):
        with open("/proc/self/status", encoding="ascii", errors="replace") as file:
            lines = dict(line.split(":", 1) for line in file)
        size, peak, data = (int(lines[name].split()[0]) * 1024 for name in ("VmSize", "VmPeak", "VmData"))
        for kind, most in ((resource.RLIMIT_AS, peak), (resource.RLIMIT_DATA, peak - size + data)):
            limit, _ = resource.getrlimit(kind)
            if limit != resource.RLIM_INFINITY and most > (1 - SHORT_OF) * limit:
                return True
    return False


def _address_space():
    """The limit on the address space of a process, MB; None where there is none."""
    limit, _ = resource.getrlimit(resource.RLIMIT_AS)
    return None if limit == resource.RLIM_INFINITY else limit / 1e6
