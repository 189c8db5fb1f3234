# SPDX-License-Identifier: GPL-3.0-or-later
"""A field for a formula, which marks the place of an error."""
from PySide import QtCore, QtGui


class FormulaEdit(QtGui.QPlainTextEdit):
    """One formula, wrapped over as many lines as it needs. `textChanged` tells of edits, `focused` that one goes to it."""

    LINES = 2
    focused = QtCore.Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.FixedFont))
        self.setTabChangesFocus(True)
        self.setWordWrapMode(QtGui.QTextOption.WrapAnywhere)
        self._fit()

    def formula(self):
        return " ".join(self.toPlainText().split("\n")).strip()

    def set_formula(self, text):
        if text != self.formula():
            self.setPlainText(text)

    def mark(self, position):
        """Underlines the word at `position`, an offset in bytes of UTF-8 as FormulaError gives it; None: nothing."""
        selections = []
        if position is not None:
            start, length = self._word_at(position)
            selection = QtGui.QTextEdit.ExtraSelection()
            selection.cursor = self.textCursor()
            selection.cursor.setPosition(start)
            selection.cursor.setPosition(start + length, QtGui.QTextCursor.KeepAnchor)
            selection.format.setUnderlineStyle(QtGui.QTextCharFormat.WaveUnderline)
            selection.format.setUnderlineColor(QtGui.QColor("#e01b24"))
            selection.format.setBackground(QtGui.QColor(224, 27, 36, 60))
            selections.append(selection)
        self.setExtraSelections(selections)

    def marked(self):
        """The text that is underlined; "" where nothing is."""
        return "".join(selection.cursor.selectedText() for selection in self.extraSelections())

    def showEvent(self, event):
        super().showEvent(event)
        self._fit()  # style sheets have set fonts and margins by now

    def focusInEvent(self, event):
        super().focusInEvent(event)
        self.focused.emit()

    def keyPressEvent(self, event):
        if event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter):
            event.ignore()  # the panel's OK
            return
        super().keyPressEvent(event)

    def insertFromMimeData(self, source):
        self.insertPlainText(" ".join(source.text().split()))

    def _fit(self):
        around = self.height() - self.viewport().height() if self.isVisible() else 2 * self.frameWidth()
        margin = 2 * int(self.document().documentMargin())
        self.setFixedHeight(self.LINES * self.fontMetrics().lineSpacing() + around + margin + 2)

    def _word_at(self, position):
        """Start and length, in characters of the text shown, of what stands at an offset of the formula."""
        shown, formula = self.toPlainText(), self.formula()
        before = len(formula.encode()[:position].decode(errors="ignore"))
        start = min(before + len(shown) - len(shown.lstrip()), len(shown))
        end = start
        while end < len(shown) and (shown[end].isalnum() or shown[end] == "_"):
            end += 1
        if end == start and start == len(shown):
            start = max(0, start - 1)
        return start, max(1, end - start)
