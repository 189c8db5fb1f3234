// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <algorithm>
#include <gp_Pnt.hxx>
#include <regex>

#include "brep_shapes.hpp"
#include "core/error.hpp"

// STEP files as other programs write them: what is wrong beside the shape is a note, what is lost of it is
// not.
namespace fgmesh {
namespace {

using test::step_text;

const double cylinder_volume = M_PI * 25.0 * 20.0;

TopoDS_Shape cylinder() { return BRepPrimAPI_MakeCylinder(5, 20).Shape(); }

TopoDS_Shape distant_box() { return BRepPrimAPI_MakeBox(gp_Pnt(50, 0, 0), gp_Pnt(60, 20, 30)).Shape(); }

BrepModel read_text(const std::string& text) {
  RunControl control;
  return BrepModel::from_text(text, control);
}

/// All of `text` before its data as it is, and `pattern` replaced in the data.
std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
  const std::size_t data = text.find("DATA;");
  return text.substr(0, data) + std::regex_replace(text.substr(data), std::regex(pattern), by);
}

template <class Kind>
std::string refusal(const std::string& text) {
  try {
    read_text(text);
  } catch (const Kind& error) {
    return error.what();
  } catch (const std::exception& error) {
    ADD_FAILURE() << "another kind of error: " << error.what();
    return {};
  }
  ADD_FAILURE() << "not refused";
  return {};
}

TEST(StepFile, NamesMayBeLeftOut) {
  const std::string whole = step_text({cylinder(), distant_box()});
  for (const char* pattern : {"'[^']*'", "BREP\\('[^']*'", "FACE\\('[^']*'", "REPRESENTATION\\('[^']*'"}) {
    const std::string kept = std::string(pattern).substr(0, std::string(pattern).find('\''));
    std::string by = kept + "$$";  // one dollar
    by.erase(std::remove(by.begin(), by.end(), '\\'), by.end());
    const BrepModel model = read_text(replaced(whole, pattern, by));
    EXPECT_EQ(model.solid_count(), 2);
    EXPECT_NEAR(model.volumes()[0], cylinder_volume, 1e-3) << pattern;
    EXPECT_NEAR(model.volumes()[1], 6000.0, 1e-3) << pattern;
    ASSERT_EQ(model.notes().size(), 1u);
    EXPECT_NE(model.notes()[0].find("not a quoted String"), std::string::npos) << model.notes()[0];
  }
}

TEST(StepFile, NamesMayBeInAnyScript) {
  const std::string text =
      replaced(step_text({cylinder()}), "FACE\\('[^']*'", "FACE('\xC3\x9C\xE9\\X2\\00DC\\X0\\ (;#1''s)'");
  EXPECT_NEAR(read_text(text).volume(), cylinder_volume, 1e-3);
}

TEST(StepFile, UnitsAreTurnedIntoMillimetres) {
  const std::string text = step_text({cylinder()});
  EXPECT_NEAR(read_text(replaced(text, "\\.MILLI\\.,\\.METRE\\.", "$$,.METRE.")).volume(),
              1e9 * cylinder_volume, 1e6);
  EXPECT_NEAR(read_text(replaced(text, "\\.MILLI\\.,\\.METRE\\.", ".CENTI.,.METRE.")).volume(),
              1e3 * cylinder_volume, 1.0);
}

TEST(StepFile, DamageOfUnitsAndPlacesIsRefused) {
  const std::string text = step_text({cylinder()});
  EXPECT_NE(
      refusal<InvalidInput>(replaced(text, "\\.MILLI\\.,\\.METRE\\.", ".MILLI.,'x'")).find("damaged at"),
      std::string::npos);
  EXPECT_NE(
      refusal<InvalidInput>(replaced(text, "CYLINDRICAL_SURFACE\\('',#[0-9]+", "CYLINDRICAL_SURFACE('',$$"))
          .find("damaged at"),
      std::string::npos);
}

/// A box beside a cylinder whose boundary OpenCASCADE cannot build.
TEST(StepFile, ASolidThatIsLostIsTold) {
  const std::string text = step_text({cylinder(), distant_box()});
  const std::string lost =
      replaced(text, "MANIFOLD_SOLID_BREP\\('',(#[0-9]+)\\)(;[^]*MANIFOLD_SOLID_BREP)", "CSG_SOLID('',$1)$2");
  ASSERT_NE(lost, text);
  const std::string message = refusal<Error>(lost);
  EXPECT_NE(message.find("#"), std::string::npos) << message;
  EXPECT_NE(message.find("export it again"), std::string::npos) << message;
}

TEST(StepFile, AnEntityOfTheShapeThatIsMissingIsTold) {
  const std::string text = step_text({cylinder(), distant_box()});
  for (const char* entity : {"CLOSED_SHELL", "ADVANCED_FACE", "EDGE_LOOP", "ORIENTED_EDGE", "EDGE_CURVE",
                             "VERTEX_POINT", "CYLINDRICAL_SURFACE", "AXIS2_PLACEMENT_3D"}) {
    // The last of its kind: the box, but for the cylinder's surface.
    const std::string without =
        replaced(text, std::string("#[0-9]+ = ") + entity + "\\([^;]*;(?![^]*= " + entity + "\\()", "");
    ASSERT_NE(without, text) << entity;
    EXPECT_NE(refusal<Error>(without).find("#"), std::string::npos) << entity;
  }
}

}  // namespace
}  // namespace fgmesh
