// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/shape_reader.hpp"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <locale>
#include <mutex>
#include <sstream>

#include "brep/occt.hpp"
#include "brep/step_check.hpp"

namespace fgmesh::brep {
namespace {

constexpr const char* step_end = "END-ISO-10303-21";

bool starts_with(const std::string& text, std::size_t at, const char* prefix) {
  return text.compare(at, std::char_traits<char>::length(prefix), prefix) == 0;
}

/// Offset of the first character that is neither white space nor a byte order mark.
std::size_t content_start(const std::string& text) {
  const std::size_t mark = starts_with(text, 0, "\xEF\xBB\xBF") ? 3 : 0;
  return std::min(text.find_first_not_of(" \t\r\n", mark), text.size());
}

bool is_step(const std::string& text) {
  std::size_t at = content_start(text);
  while (starts_with(text, at, "/*")) {
    const std::size_t end = text.find("*/", at + 2);
    if (end == std::string::npos) return false;
    at = std::min(text.find_first_not_of(" \t\r\n", end + 2), text.size());
  }
  return starts_with(text, at, "ISO-10303-21");
}

bool is_brep(const std::string& text) {
  const std::size_t at = text.find("CASCADE Topology V");
  return at != std::string::npos && at < 200;
}

/// Refuses what is certainly no text of a shape, with the cure where the kind of file is known.
void refuse_other_data(const std::string& text) {
  if (content_start(text) == text.size()) throw InvalidInput("the shape file is empty");
  if (starts_with(text, 0, "PK")) {
    throw InvalidInput(
        "the shape file is a zip archive (a FreeCAD document?); export the solid as STEP or BREP and use "
        "that");
  }
  const bool is_binary_brep = text.substr(0, 200).find("Open CASCADE Topology V") != std::string::npos;
  if (is_binary_brep) {
    throw InvalidInput("the shape file is a binary BREP; save it as a text BREP (.brep) or as STEP");
  }
  if (text.find('\0') != std::string::npos) {
    throw InvalidInput("the shape file holds binary data; a text in BREP or STEP format is needed");
  }
  if (!is_step(text) && !is_brep(text)) {
    throw InvalidInput("the shape file is neither BREP nor STEP; export the solid in one of these formats");
  }
}

[[noreturn]] void refuse_truncated(const char* format, const std::string& missing) {
  throw InvalidInput(std::string("the ") + format + " file is cut short (" + missing +
                     "); copy or export it again");
}

/// OpenCASCADE computes for ever with what is no number, or no length. It writes 2e100 for infinity.
void require_finite_numbers(const std::string& text) {
  constexpr double largest = 1e101;
  constexpr const char* blank = " \t\r\n";
  // What comes before the places and the geometry is a header in words.
  std::size_t begin = std::min(text.find("\nLocations "), text.size());
  for (std::size_t end = begin; (begin = text.find_first_not_of(blank, end)) != std::string::npos;) {
    end = std::min(text.find_first_of(blank, begin), text.size());
    const char* token = text.c_str() + begin;
    char* stop = nullptr;
    const double value = std::strtod(token, &stop);
    if (stop != text.c_str() + end || std::abs(value) <= largest) continue;
    const auto line = 1 + std::count(text.begin(), text.begin() + begin, '\n');
    throw InvalidInput("the BREP file is damaged: '" +
                       text.substr(begin, std::min<std::size_t>(end - begin, 40)) + "' in line " +
                       std::to_string(line) + " is no coordinate; export it again");
  }
}

/// OpenCASCADE's reader loops or crashes on a BREP that ends early, so its end is looked at first: n
/// sub-shapes after "TShapes n", each ended by a star, then the root's number and location.
void require_complete_brep(const std::string& text) {
  const std::size_t shapes_at = text.rfind("\nTShapes ");
  if (shapes_at == std::string::npos) refuse_truncated("BREP", "it has no list of sub-shapes");
  std::istringstream tail(text.substr(shapes_at + 9));
  std::size_t announced = 0, ended = 0;
  tail >> announced;
  std::vector<std::string> root;
  for (std::string token; tail >> token;) {
    if (token == "*") {
      ++ended;
      root.clear();
    } else {
      root.push_back(token);
    }
  }
  const bool null_root = ended == announced + 1 && root.empty();
  if (null_root) throw GeometryError("the BREP file holds no shape; export the solid again");
  if (ended != announced || root.size() < 2) {
    refuse_truncated("BREP",
                     std::to_string(ended) + " of " + std::to_string(announced) + " sub-shapes are there");
  }
  require_finite_numbers(text);
}

/// True where `word` stands outside strings and comments.
bool uses_word(const std::string& text, const std::string& word) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\'') {
      i = text.find('\'', i + 1);
    } else if (text[i] == '/' && i + 1 < text.size() && text[i + 1] == '*') {
      i = text.find("*/", i + 2);
    } else if (text[i] == word[0] && text.compare(i, word.size(), word) == 0) {
      return true;
    }
    if (i == std::string::npos) return false;
  }
  return false;
}

void require_complete_step(const std::string& text) {
  if (text.rfind(step_end) == std::string::npos) {
    refuse_truncated("STEP", std::string(step_end) + " is missing");
  }
  // OpenCASCADE 7.6 corrupts its memory on this construct of the first edition of ISO 10303-21.
  if (uses_word(text, "&SCOPE")) {
    throw InvalidInput(
        "the STEP file uses the withdrawn construct &SCOPE; export it again as AP214 or AP242");
  }
}

TopoDS_Shape read_brep(const std::string& text, RunControl& control) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  // Where a line is missing, OpenCASCADE would ask a stream that has failed for ever.
  stream.exceptions(std::ios::failbit | std::ios::badbit);
  TopoDS_Shape shape;
  Handle(StopIndicator) indicator = new StopIndicator(control);
  try {
    BRepTools::Read(shape, stream, BRep_Builder(), indicator->Start());
  } catch (const std::ios::failure&) {
    shape.Nullify();
  }
  control.check();
  if (shape.IsNull()) {
    throw InvalidInput("the BREP file is damaged: something is missing or out of place; export it again");
  }
  return shape;
}

ReadShape read_step(const std::string& text, RunControl& control) {
  // OpenCASCADE keeps the settings and the parser of STEP in global variables.
  static std::mutex step_mutex;
  const std::lock_guard<std::mutex> lock(step_mutex);
  const QuietMessenger quiet;

  STEPControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  std::istringstream stream(text.substr(text.find("ISO-10303-21")));
  stream.imbue(std::locale::classic());
  if (reader.ReadStream("shape.step", stream) != IFSelect_RetDone) {
    throw InvalidInput("the STEP file breaks the syntax of ISO 10303-21; export it again");
  }
  ReadShape read{{}, harmless_faults(reader)};
  control.check();
  Handle(StopIndicator) indicator = new StopIndicator(control);
  reader.TransferRoots(indicator->Start());
  control.check();
  if (reader.NbShapes() == 0) {
    throw GeometryError("the STEP file describes no shape; export the solid again, as AP214 or AP242");
  }
  for (std::string& note : require_all_solids(reader)) read.notes.push_back(std::move(note));
  read.shape = reader.OneShape();
  return read;
}

}  // namespace

ReadShape read_shape(const std::string& text, RunControl& control) {
  refuse_other_data(text);
  const bool step = is_step(text);
  step ? require_complete_step(text) : require_complete_brep(text);
  control.check();
  return guarded("reading the shape", [&] {
    return step ? read_step(text, control) : ReadShape{read_brep(text, control), {}};
  });
}

}  // namespace fgmesh::brep
