# SPDX-License-Identifier: GPL-3.0-or-later
"""Task panels and the widgets that they are made of."""
