// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Standard_Failure.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/run_control.hpp"
#include "core/vec3.hpp"

// What every file of this folder needs to talk to OpenCASCADE. For this folder alone: no other may include
// OCCT.
namespace fgmesh::brep {

inline gp_Pnt to_gp(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
inline Vec3 to_vec3(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }
inline Vec3 to_vec3(const gp_Vec& v) { return {v.X(), v.Y(), v.Z()}; }

/// Runs `action` and turns OpenCASCADE's failures into a GeometryError that says what was being done.
template <class Action>
auto guarded(const std::string& doing, Action&& action) {
  try {
    return std::forward<Action>(action)();
  } catch (const Standard_Failure& failure) {
    const char* reason = failure.GetMessageString();
    throw GeometryError("OpenCASCADE failed while " + doing + " (" + failure.DynamicType()->Name() +
                        (reason && *reason ? std::string(": ") + reason : "") +
                        "); Part -> Check geometry may show the cause");
  }
}

/// Lets a RunControl interrupt OpenCASCADE's long algorithms.
class StopIndicator : public Message_ProgressIndicator {
 public:
  explicit StopIndicator(RunControl& control) : control_(control) {}

 protected:
  Standard_Boolean UserBreak() override { return control_.should_stop(); }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {}

 private:
  RunControl& control_;
};

/// Keeps OpenCASCADE's chatter off standard output, which belongs to results, while it lives.
class QuietMessenger {
 public:
  QuietMessenger() : printers_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  ~QuietMessenger() { Message::DefaultMessenger()->ChangePrinters() = printers_; }
  QuietMessenger(const QuietMessenger&) = delete;
  QuietMessenger& operator=(const QuietMessenger&) = delete;

 private:
  Message_SequenceOfPrinters printers_;
};

}  // namespace fgmesh::brep
