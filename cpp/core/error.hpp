// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace fgmesh {

/// Root of everything FGMesh throws on purpose. What ended lawfully short (a threshold that
/// cannot be met) is a status in the result instead.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The caller asked for something that has no meaning: an option out of range, an unreadable
/// file, a material that leaves [0, 1]. Exit status 2 of the command line.
class InvalidInput : public Error {
 public:
  using Error::Error;
};

/// A formula that is not one; `position` is the offset of the offending character in its text.
class FormulaError : public InvalidInput {
 public:
  FormulaError(const std::string& message, std::size_t position, std::size_t formula = 0)
      : InvalidInput(message), position_(position), formula_(formula) {}
  std::size_t position() const { return position_; }
  /// Which of several, from 0.
  std::size_t formula() const { return formula_; }

 private:
  std::size_t position_;
  std::size_t formula_;
};

/// The shape cannot be meshed: what is wrong, and on which sub-shape. Exit status 3.
class GeometryError : public Error {
 public:
  using Error::Error;
};

/// A cancelled run, or one that reached its time or memory limit. Exit status 5.
class Cancelled : public Error {
 public:
  using Error::Error;
};

}  // namespace fgmesh
