# SPDX-License-Identifier: GPL-3.0-or-later
"""Whole files or none: what is written appears under its name only once all of it is on the disk."""
import contextlib
import os
import secrets
import stat


class OutputError(OSError):
    """An output file cannot be written; the message names it and the cure."""


def check_writable(path):
    """Raise OutputError where `path` cannot become an output file, before any work is spent on it."""
    path = os.fspath(path)
    if "\0" in path:
        raise OutputError(f"the file name {path!r} holds a NUL character")
    target = os.path.realpath(path)
    folder = os.path.dirname(target)
    if not os.path.isdir(folder):
        raise OutputError(f"the folder of {path!r} does not exist: make it first")
    existing = _status(target, path)
    if existing is not None:
        _check_replaceable(existing, os.stat(folder), path)
        if not os.access(target, os.W_OK):
            raise OutputError(f"{path!r} is write-protected: name another file, or allow writing to it")
    if not os.access(folder, os.W_OK | os.X_OK):
        raise OutputError(f"the folder of {path!r} is not writable: choose another one")


def _status(target, path):
    """What os.stat gives, None where there is no such file."""
    try:
        return os.stat(target)
    except (FileNotFoundError, NotADirectoryError):
        return None
    except OSError as error:  # a name that is too long, say, or links in a circle
        raise OutputError(f"cannot write {path!r}: {error.strerror}") from None


def _check_replaceable(existing, folder, path):
    if stat.S_ISDIR(existing.st_mode):
        raise OutputError(f"{path!r} is a folder: name a file in it")
    if not stat.S_ISREG(existing.st_mode):
        raise OutputError(f"{path!r} is no regular file and cannot be replaced: name another file")
    # In a folder like /tmp only the owner of a file may replace it.
    if folder.st_mode & stat.S_ISVTX and os.geteuid() not in (0, existing.st_uid, folder.st_uid):
        raise OutputError(f"{path!r} belongs to another user and cannot be replaced: name another file")


@contextlib.contextmanager
def replaced_together(*paths, before_replacing=None):
    """Give one temporary path for each of `paths`; on leaving without an error they replace `paths`.

    Each temporary file lies in the folder of its target, reaches the disk (fsync) before the first
    replacement, and is removed where anything fails: `paths` are then as they were. A symbolic link is
    followed, an existing file's permissions are kept. `before_replacing()` is called when all is written.
    Raises OutputError for any failure of the file system.
    """
    for path in paths:
        check_writable(path)
    targets = [os.path.realpath(path) for path in paths]
    # Names come before files, so that an interrupt at any moment finds all there is to remove.
    temporary = [_name_beside(target) for target in targets]
    _unfinished.update(temporary)
    try:
        for name in temporary:
            _create(name)
        yield list(temporary)
        for name, target in zip(temporary, targets):
            _flush(name)
            # Not before: they may forbid even their owner to read and write.
            os.chmod(name, _permissions(target))
        if before_replacing:
            before_replacing()
        for name, target in zip(temporary, targets):
            os.replace(name, target)
        for folder in {os.path.dirname(target) for target in targets}:
            _flush(folder)
    except OutputError:
        raise
    except OSError as error:
        names = " and ".join(repr(os.fspath(path)) for path in paths)
        raise OutputError(f"cannot write {names}: {error.strerror or error}") from error
    finally:
        _remove(temporary)
        _unfinished.difference_update(temporary)


def remove_unfinished():
    """Remove the temporary files of all replacements under way: for a process that ends without unwinding."""
    _remove(_unfinished)


_unfinished = set()


def _remove(names):
    for name in names:
        with contextlib.suppress(OSError):
            os.unlink(name)


def _name_beside(target):
    # Not made from the target's name, which may have all the 255 bytes that a name may have.
    return os.path.join(
        os.path.dirname(target), f".fgmesh-{secrets.token_hex(8)}{os.path.splitext(target)[1]}"
    )


def _create(name):
    handle = os.open(name, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    try:
        os.fchmod(handle, 0o600)  # whatever the umask
    finally:
        os.close(handle)


def _permissions(target):
    try:
        return stat.S_IMODE(os.stat(target).st_mode)
    except FileNotFoundError:
        umask = os.umask(0)
        os.umask(umask)
        return 0o666 & ~umask


def _flush(path):
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
