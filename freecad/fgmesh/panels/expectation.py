# SPDX-License-Identifier: GPL-3.0-or-later
"""How many tetrahedra a mesh will have, told before it is made."""
from PySide import QtCore

from freecad.fgmesh import core, worker
from freecad.fgmesh.fem.background import Request
from freecad.fgmesh.panels.message_label import MessageLabel
from freecad.fgmesh.view.texts import number_text, translate

_WAIT_MILLISECONDS, _POLL_MILLISECONDS = 300, 50


class Expectation(MessageLabel):
    """The expected number and memory for `solid`, computed in a child process."""

    def __init__(self, solid, parent=None):
        super().__init__(parent)
        self.setObjectName("FGMeshExpectation")
        self._solid, self._values, self._run = solid, None, None
        self._start = QtCore.QTimer(self)
        self._start.setSingleShot(True)
        self._start.setInterval(_WAIT_MILLISECONDS)
        self._start.timeout.connect(self._begin)
        self._poll = QtCore.QTimer(self)
        self._poll.setInterval(_POLL_MILLISECONDS)
        self._poll.timeout.connect(self._look)

    def expect(self, values):
        """Tells soon what comes of option values; of the latest where there are several."""
        self.stop()
        self._values = values
        self.say(translate("Expected: ..."))
        self._start.start()

    def stop(self):
        """Forgets what was asked."""
        self._start.stop()
        self._poll.stop()
        self.say("")
        if self._run is not None:
            self._run.close()
        self._run = None

    def _begin(self):
        try:
            self._run = worker.start_estimate(*Request(self._solid, self._values).arguments)
        except Exception as error:  # a deleted solid is a ReferenceError, ours are core.Error
            self.complain(str(error))
            return
        self._poll.start()

    def _look(self):
        if not self._run.wait(0.0):
            return
        run = self._run
        self._poll.stop()
        try:
            self._tell(run.result())
        except (core.Error, RuntimeError) as error:
            self.complain(str(error))
        run.close()
        self._run = None

    def _tell(self, estimate):
        text = translate("Expected: about {} tetrahedra, {} MB").format(
            number_text(round_to_two(estimate.tets), ","), number_text(round_to_two(estimate.memory_mb), ",")
        )
        available = worker.available_memory_mb()
        if estimate.memory_mb > available:
            self.warn(
                text + translate("; only {} MB of memory are free").format(number_text(available, ",.0f"))
            )
        else:
            self.say(text)


def round_to_two(number):
    """Two digits: more would promise too much."""
    return int(float(f"{number:.2g}"))
