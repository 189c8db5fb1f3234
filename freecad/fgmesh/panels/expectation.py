# SPDX-License-Identifier: GPL-3.0-or-later
"""How many tetrahedra a mesh will have, told before it is made; and what makes fewer, where they are too many."""
from PySide import QtCore, QtGui

from freecad.fgmesh import core, worker
from freecad.fgmesh.fem.background import Request
from freecad.fgmesh.model.remedies import remedies
from freecad.fgmesh.model.texts import TRANSLATE_LATER
from freecad.fgmesh.panels.message_label import MessageLabel
from freecad.fgmesh.view.texts import length_text, number_text, translate
from freecad.fgmesh.worker.remaining import SECONDS_PER_TET, rough_time

_WAIT_MILLISECONDS, _POLL_MILLISECONDS = 300, 50
_LONG_SECONDS = 180.0
"""Expected, from which on one is warned."""

_HELPS = 0.8
"""Of the expected tetrahedra: what leaves more is no remedy."""


_TITLES = {
    "MaterialThreshold": TRANSLATE_LATER("FGMesh", "Material threshold {}"),
    "Anisotropy": TRANSLATE_LATER("FGMesh", "Anisotropy {}"),
    "SurfaceDeviation": TRANSLATE_LATER("FGMesh", "Surface deviation {}"),
    "MaxSize": TRANSLATE_LATER("FGMesh", "Largest size {}"),
}


class Expectation(QtGui.QWidget):
    """The expected number and memory for `solid`, computed in a child process. `chosen` gives the {property: value} of a
    button that the user has pressed to have fewer."""

    chosen = QtCore.Signal(object)

    def __init__(self, solid, parent=None):
        super().__init__(parent)
        self._solid, self._run = solid, None
        self._tasks = []  # (values, what to do with their estimate), the one under way first
        self._label = MessageLabel()
        self._label.setObjectName("FGMeshExpectation")
        self._buttons = []
        self._layout = QtGui.QVBoxLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._layout.addWidget(self._label)
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
        self._tasks = [(values, self._tell)]
        self._label.say(translate("Expected: ..."))
        self._start.start()

    def stop(self):
        """Forgets what was asked."""
        self._start.stop()
        self._tasks = []
        self._end_run()
        self._label.say("")
        for button in self._buttons:
            self._layout.removeWidget(button)
            button.deleteLater()
        self._buttons = []

    def _end_run(self):
        self._poll.stop()
        if self._run is not None:
            self._run.close()
        self._run = None

    def _begin(self):
        values, _ = self._tasks[0]
        try:
            self._run = worker.start_estimate(*Request(self._solid, values).arguments)
        except Exception as error:  # a deleted solid is a ReferenceError, ours are core.Error
            self._label.complain(str(error))
            return
        self._poll.start()

    def _look(self):
        if not self._run.wait(0.0):
            return
        run, (values, tell) = self._run, self._tasks.pop(0)
        self._poll.stop()
        try:
            tell(values, run.result())
        except (core.Error, RuntimeError, ReferenceError) as error:  # the solid may be deleted meanwhile
            self._tasks = []
            if tell == self._tell:  # a remedy that fails is none
                self._label.complain(str(error))
        self._end_run()
        if self._tasks:
            self._begin()

    def _tell(self, values, estimate):
        text = translate("Expected: about {} tetrahedra, {} MB").format(
            number_text(round_to_two(estimate.tets), ","), number_text(round_to_two(estimate.memory_mb), ",")
        )
        seconds, available = SECONDS_PER_TET * estimate.tets, worker.available_memory_mb()
        warnings = []
        if estimate.memory_mb > available:
            free = number_text(available, ",.0f")
            warnings.append(translate("; only {} MB of memory are free").format(free))
        if seconds > _LONG_SECONDS:
            warnings.append(translate("; that takes about {}").format(rough_time(seconds)))
        if not warnings:
            self._label.say(text)
            return
        self._label.warn(text + "".join(warnings))
        self._tasks += [
            ({**values, **change}, lambda _, other, change=change: self._offer(change, other, estimate.tets))
            for change in remedies(values, self._solid.Shape.BoundBox.DiagonalLength)
        ]

    def _offer(self, change, estimate, tets):
        """A button for `change`, where it leaves clearly fewer than `tets`."""
        if estimate.tets > _HELPS * tets:
            return
        ((name, value),) = change.items()
        title = translate(_TITLES[name]).format(_shown(name, value))
        count = number_text(round_to_two(estimate.tets), ",")
        button = QtGui.QPushButton(translate("{}: about {}").format(title, count))
        button.setObjectName(f"FGMeshRemedy{name}")
        button.setToolTip(translate("Sets the field above so that the mesh gets fewer tetrahedra"))
        button.clicked.connect(lambda: self.chosen.emit(change))
        self._buttons.append(button)
        self._layout.addWidget(button)


def round_to_two(number):
    """Two digits: more would promise too much."""
    return int(float(f"{number:.2g}"))


def _shown(name, value):
    if name not in ("SurfaceDeviation", "MaxSize"):
        return number_text(value, ".3g")
    if not value:
        return translate("automatic")
    text = length_text(value)
    return text if " " in text else f"{text} mm"
