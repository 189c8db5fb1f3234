# SPDX-License-Identifier: GPL-3.0-or-later
"""The workbench's commands, one class each. They run the public functions, so that macros record them."""
