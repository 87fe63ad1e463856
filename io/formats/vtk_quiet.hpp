// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// VTK reports by printing and logging; here it does neither.
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace crest::io {

/// While one lives, VTK's messages go nowhere; failed() tells whether there was an error.
/// Not for use in two threads at a time: VTK's output window is global.
class VtkQuiet {
 public:
  VtkQuiet()
      : previous_(vtkOutputWindow::GetInstance()),
        verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkOutputWindow::SetInstance(window_);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~VtkQuiet() {
    vtkLogger::SetStderrVerbosity(verbosity_);
    vtkOutputWindow::SetInstance(previous_);
  }
  VtkQuiet(const VtkQuiet&) = delete;
  VtkQuiet& operator=(const VtkQuiet&) = delete;
  bool failed() const { return window_->failed; }

 private:
  class Window : public vtkOutputWindow {
   public:
    static Window* New() { VTK_STANDARD_NEW_BODY(Window); }
    vtkTypeMacro(Window, vtkOutputWindow);
    void DisplayText(const char*) override {}
    void DisplayErrorText(const char*) override { failed = true; }
    void DisplayWarningText(const char*) override {}
    void DisplayGenericWarningText(const char*) override {}
    void DisplayDebugText(const char*) override {}
    bool failed = false;

   private:
    Window() = default;
  };
  vtkSmartPointer<vtkOutputWindow> previous_;
  vtkLogger::Verbosity verbosity_;
  vtkNew<Window> window_;
};

}  // namespace crest::io
