// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// VTK reports by printing and logging; here it does neither.
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <string>

namespace crest::io {

/// While one lives, VTK prints nothing. Whoever has VTK work asks failed() or complaint() and says
/// so: no error of VTK's is swallowed.
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
  /// Whether there was an error.
  bool failed() const { return window_->failed; }
  /// The first error or warning, in one line without VTK's places and addresses; empty if there was
  /// none.
  const std::string& complaint() const { return window_->complaint; }

 private:
  class Window : public vtkOutputWindow {
   public:
    static Window* New() { VTK_STANDARD_NEW_BODY(Window); }
    vtkTypeMacro(Window, vtkOutputWindow);
    void DisplayText(const char*) override {}
    void DisplayErrorText(const char* text) override {
      failed = true;
      keep(text);
    }
    void DisplayWarningText(const char* text) override { keep(text); }
    void DisplayGenericWarningText(const char* text) override { keep(text); }
    void DisplayDebugText(const char*) override {}
    bool failed = false;
    std::string complaint;

   private:
    Window() = default;
    /// "ERROR: In FILE, line N\nCLASS (0xADDRESS): TEXT\n\n", the class not always.
    void keep(std::string text) {
      if (!complaint.empty()) return;
      const std::size_t first = text.find('\n');
      if (first != text.npos && text.substr(0, first).find(": In ") != text.npos)
        text.erase(0, first + 1);
      const std::size_t object = text.find(" (0x"), end = text.find("): ");
      if (object != text.npos && end != text.npos && object < end) text.erase(0, end + 3);
      for (const char c : text)
        if (c != '\n' || (!complaint.empty() && complaint.back() != ' '))
          complaint += c == '\n' ? ' ' : c;
      complaint.erase(complaint.find_last_not_of(' ') + 1);
      if (complaint.empty()) complaint = "no text";
    }
  };
  vtkSmartPointer<vtkOutputWindow> previous_;
  vtkLogger::Verbosity verbosity_;
  vtkNew<Window> window_;
};

}  // namespace crest::io
