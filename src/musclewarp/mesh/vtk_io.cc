// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/vtk_io.h"

#include <glog/logging.h>
#include <vtkCellArray.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPoints.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <mutex>
#include <new>
#include <stdexcept>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh/soup_builder.h"
#include "musclewarp/mesh/text_cursor.h"

namespace musclewarp {
namespace {

constexpr char kCopyAgain[] = "copy or export it again";

// Keeps the first error instead of printing it.
class ErrorCatcher : public vtkOutputWindow {
 public:
  static ErrorCatcher* New();
  vtkTypeMacro(ErrorCatcher, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override {
    // Notes on arrays, such as their range, which nobody reads.
    if (std::string_view(text).find("InformationKey") !=
        std::string_view::npos) {
      return;
    }
    if (first_error_.empty()) first_error_ = text;
  }

  // Without the source file, class and address before it.
  std::string FirstError() const {
    const std::size_t begin = first_error_.find("): ");
    const std::string text = begin == std::string::npos
                                 ? first_error_
                                 : first_error_.substr(begin + 3);
    return text.substr(0, text.find_first_of("\r\n"));
  }

 private:
  std::string first_error_;
};
vtkStandardNewMacro(ErrorCatcher);

// While it lives, errors of VTK go to the catcher. The window is global, so
// only one at a time.
class ErrorScope {
 public:
  ErrorScope()
      : lock_(Mutex()),
        previous_(vtkOutputWindow::GetInstance()),
        displayed_(vtkObject::GetGlobalWarningDisplay()),
        verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkOutputWindow::SetInstance(catcher_);
    vtkObject::GlobalWarningDisplayOn();
  }
  ~ErrorScope() {
    vtkOutputWindow::SetInstance(previous_);
    vtkObject::SetGlobalWarningDisplay(displayed_);
    vtkLogger::SetStderrVerbosity(verbosity_);
  }
  ErrorScope(const ErrorScope&) = delete;
  ErrorScope& operator=(const ErrorScope&) = delete;

  std::string FirstError() const { return catcher_->FirstError(); }

 private:
  static std::mutex& Mutex() {
    static std::mutex mutex;
    return mutex;
  }

  std::lock_guard<std::mutex> lock_;
  vtkSmartPointer<vtkOutputWindow> previous_;
  int displayed_;
  vtkLogger::Verbosity verbosity_;
  vtkNew<ErrorCatcher> catcher_;
};

void CheckIsWholeXml(const std::string& path, std::string_view bytes) {
  if (bytes.substr(0, 1024).find("<VTKFile") == std::string_view::npos) {
    throw InputError(
        path,
        "is no VTK XML file: it starts with " + Quoted(bytes.substr(0, 16)),
        "name the file by what it holds");
  }
  // VTK does not mind a missing end behind the data it needs.
  constexpr std::string_view kEnd = "</VTKFile>";
  const std::size_t last = bytes.find_last_not_of(std::string_view(" \t\r\n"));
  const std::string_view text = bytes.substr(0, last + 1);
  if (text.size() < kEnd.size() ||
      text.substr(text.size() - kEnd.size()) != kEnd) {
    throw InputError(
        path, "is truncated: it does not end with '</VTKFile>'", kCopyAgain);
  }
}

// VTK allocates what NumberOfPoints and the like promise before it looks at the
// data.
void CheckPromises(const std::string& path, std::string_view bytes) {
  constexpr std::string_view kAttribute = "NumberOf";
  // Far more than compression makes of real coordinates and indices.
  const std::size_t limit = 1024 + 64 * bytes.size();
  std::size_t at = bytes.find(kAttribute);
  for (; at != std::string_view::npos;
       at = bytes.find(kAttribute, at + kAttribute.size())) {
    const std::size_t end_of_name = bytes.find_first_of("= \t\r\n>", at);
    if (end_of_name == std::string_view::npos) return;
    const std::size_t digits =
        bytes.find_first_not_of("= \t\r\n\"'", end_of_name);
    if (digits == std::string_view::npos) return;
    std::size_t count = 0;
    for (std::size_t i = digits; i < bytes.size() && bytes[i] >= '0' &&
                                 bytes[i] <= '9' && count <= limit;
         ++i) {
      count = 10 * count + (bytes[i] - '0');
    }
    if (count > limit) {
      throw InputError(
          path,
          "promises more than it can hold: " +
              std::string(bytes.substr(at, end_of_name - at)) + " is " +
              std::string(bytes.substr(
                  digits,
                  bytes.find_first_not_of("0123456789", digits) - digits)) +
              ", the file has " + std::to_string(bytes.size()) + " bytes",
          kCopyAgain);
    }
  }
}

// VTK 9.1 numbers the corners of strips within their piece.
void CheckStrips(const std::string& path,
                 std::string_view bytes,
                 vtkPolyData* data) {
  constexpr std::string_view kPiece = "<Piece";
  const std::size_t first = bytes.find(kPiece);
  if (data->GetNumberOfStrips() == 0 || first == std::string_view::npos ||
      bytes.find(kPiece, first + 1) == std::string_view::npos) {
    return;
  }
  throw InputError(path,
                   "has triangle strips in several pieces",
                   "export it as polygons, or in one piece");
}

void CheckCells(const std::string& path, vtkCellArray* cells) {
  // Reading cells by broken offsets would leave the array.
  if (cells->IsValid()) return;
  throw InputError(
      path, "has cell offsets that do not fit its connectivity", kCopyAgain);
}

template <typename Add>
void ForEachCell(vtkCellArray* cells, const Add& add) {
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(i, size, corners);
    add(std::vector<std::int64_t>(corners, corners + size));
  }
}

}  // namespace

vtkSmartPointer<vtkPolyData> PolyDataFromSoup(const TriangleSoup& soup) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(soup.points.rows());
  for (Eigen::Index i = 0; i < soup.points.rows(); ++i) {
    points->SetPoint(i, soup.points.row(i).data());
  }
  vtkNew<vtkCellArray> polygons;
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    polygons->InsertNextCell(
        {soup.triangles(f, 0), soup.triangles(f, 1), soup.triangles(f, 2)});
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

TriangleSoup SoupFromPolyData(const std::string& path, vtkPolyData* data) {
  SoupBuilder builder(path);
  Eigen::Vector3d point;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    data->GetPoint(i, point.data());
    builder.AddPoint(point);
  }
  CheckCells(path, data->GetPolys());
  CheckCells(path, data->GetStrips());
  ForEachCell(data->GetPolys(), [&](const std::vector<std::int64_t>& corners) {
    builder.AddPolygon(corners);
  });
  ForEachCell(data->GetStrips(), [&](const std::vector<std::int64_t>& corners) {
    builder.AddStrip(corners);
  });
  return builder.Build();
}

TriangleSoup ReadVtp(const std::string& path, std::string_view bytes) {
  CheckIsWholeXml(path, bytes);
  CheckPromises(path, bytes);
  vtkNew<vtkXMLPolyDataReader> reader;
  std::string error;
  {
    const ErrorScope scope;
    reader->ReadFromInputStringOn();
    reader->SetInputString(std::string(bytes));
    try {
      reader->Update();
      error = scope.FirstError();
    } catch (const std::bad_alloc&) {
      error = "a size in it is beyond the memory";
    } catch (const std::length_error&) {
      error = "a size in it is beyond the memory";
    }
  }
  if (!error.empty()) {
    throw InputError(
        path, "cannot be read as VTK XML polydata: " + error, kCopyAgain);
  }
  CheckStrips(path, bytes, reader->GetOutput());
  return SoupFromPolyData(path, reader->GetOutput());
}

std::string VtpBytes(vtkPolyData* data) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  const ErrorScope scope;
  writer->WriteToOutputStringOn();
  writer->SetDataModeToBinary();
  writer->SetInputData(data);
  CHECK_EQ(writer->Write(), 1) << scope.FirstError();
  return writer->GetOutputString();
}

}  // namespace musclewarp
