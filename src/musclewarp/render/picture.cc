// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/render/picture.h"

#include <glog/logging.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>

#include <array>

#include "musclewarp/render/camera_fit.h"
#include "musclewarp/render/depth_cues.h"
#include "musclewarp/render/offscreen_window.h"
#include "musclewarp/render/picture_texts.h"

namespace musclewarp {
namespace {

std::array<double, 3> Rgb(const Color& color) {
  return {color.r / 255.0, color.g / 255.0, color.b / 255.0};
}

vtkSmartPointer<vtkPolyData> PolyData(const TriangleSoup& soup) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(soup.points.rows());
  for (int i = 0; i < soup.points.rows(); ++i) {
    points->SetPoint(i, soup.points.row(i).data());
  }
  vtkNew<vtkCellArray> cells;
  for (int i = 0; i < soup.triangles.rows(); ++i) {
    cells->InsertNextCell(
        {soup.triangles(i, 0), soup.triangles(i, 1), soup.triangles(i, 2)});
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

vtkSmartPointer<vtkUnsignedCharArray> ColorArray(
    const std::vector<Color>& colors) {
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetNumberOfComponents(3);
  for (const Color& color : colors) {
    array->InsertNextTuple3(color.r, color.g, color.b);
  }
  return array;
}

vtkSmartPointer<vtkActor> MeshActor(const PictureMesh& mesh,
                                    double feature_angle) {
  CHECK(mesh.opacity >= 0 && mesh.opacity <= 1) << mesh.opacity;
  vtkNew<vtkPolyDataNormals> normals;
  const vtkSmartPointer<vtkPolyData> surface = PolyData(mesh.surface);
  if (!mesh.triangle_colors.empty()) {
    CHECK_EQ(mesh.triangle_colors.size(),
             static_cast<std::size_t>(mesh.surface.triangles.rows()));
    surface->GetCellData()->SetScalars(ColorArray(mesh.triangle_colors));
  }
  normals->SetInputData(surface);
  normals->SetFeatureAngle(feature_angle);
  // The order of the corners is left as it is.
  normals->ConsistencyOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->SetScalarModeToUseCellData();  // where there are colours
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(Rgb(mesh.color).data());
  property->SetOpacity(mesh.opacity);
  property->SetAmbient(0.16);
  property->SetDiffuse(0.84);
  property->SetSpecular(0.12);
  property->SetSpecularPower(18);
  return actor;
}

vtkSmartPointer<vtkCamera> MakeCamera(const CameraFit& fit, const View& view) {
  const Eigen::Vector3d position =
      fit.center + 2 * fit.depth * view.toward_viewer;
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(fit.center.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(view.up.data());
  camera->SetParallelScale(fit.half_height);
  camera->SetClippingRange(fit.depth, 3 * fit.depth);
  return camera;
}

void AddLights(vtkRenderer* renderer) {
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.9);
  lights->SetKeyLightAngle(44, -34);  // elevation, azimuth
  lights->SetKeyToFillRatio(3.0);
  lights->SetKeyToHeadRatio(3.6);
  lights->SetKeyToBackRatio(3.5);
  lights->SetKeyLightWarmth(0.54);
  lights->SetFillLightWarmth(0.46);
  lights->AddLightsToRenderer(renderer);
}

vtkSmartPointer<vtkRenderer> WhiteRenderer() {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1, 1, 1);
  return renderer;
}

// Draws the scenes above the texts, with one renderer for each panel.
void AddPanels(const std::vector<PicturePanel>& panels,
               const View& view,
               const CameraFit& fit,
               double text_fraction,
               double feature_angle,
               vtkRenderWindow* window) {
  const double width = 1.0 / panels.size();
  const vtkSmartPointer<vtkCamera> camera = MakeCamera(fit, view);
  // Clears the area that the panels leave free.
  window->AddRenderer(WhiteRenderer());
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const vtkSmartPointer<vtkRenderer> renderer = WhiteRenderer();
    renderer->SetViewport(i * width, text_fraction, (i + 1) * width, 1);
    renderer->SetActiveCamera(camera);
    AddLights(renderer);
    for (const PictureMesh& mesh : panels[i].meshes) {
      renderer->AddActor(MeshActor(mesh, feature_angle));
    }
    renderer->SetUseDepthPeeling(true);
    renderer->SetMaximumNumberOfPeels(8);
    renderer->SetOcclusionRatio(0);
    window->AddRenderer(renderer);
  }
}

Image RenderPixels(vtkRenderWindow* window) {
  window->Render();
  const int* size = window->GetSize();
  Image image{size[0], size[1], {}};
  image.pixels.resize(image.width * image.height);
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, image.width - 1, image.height - 1, false, pixels);
  for (int y = 0; y < image.height; ++y) {
    const unsigned char* row =
        pixels->GetPointer(3 * (image.height - 1 - y) * image.width);
    for (int x = 0; x < image.width; ++x) {
      image.At(x, y) = {row[3 * x], row[3 * x + 1], row[3 * x + 2]};
    }
  }
  return image;
}

// Multiplies the image by `ink`, a drawing on white.
void Multiply(const Image& ink, Image* image) {
  for (std::size_t i = 0; i < image->pixels.size(); ++i) {
    Color& color = image->pixels[i];
    color.r = color.r * ink.pixels[i].r / 255;
    color.g = color.g * ink.pixels[i].g / 255;
    color.b = color.b * ink.pixels[i].b / 255;
  }
}

DepthMap ReadDepth(vtkRenderWindow* window, const CameraFit& fit) {
  const int* size = window->GetSize();
  DepthMap map{size[0], size[1], {}};
  // The clipping range is 2 fit.depth, the height of a panel 2 fit.half_height.
  const float scale = static_cast<float>(fit.depth / fit.half_height);
  vtkNew<vtkFloatArray> depth;
  window->GetZbufferData(0, 0, map.width - 1, map.height - 1, depth);
  map.depth.reserve(map.width * map.height);
  for (int y = map.height - 1; y >= 0; --y) {
    for (int x = 0; x < map.width; ++x) {
      const float share = depth->GetValue(y * map.width + x);
      map.depth.push_back(share < 1 ? scale * share : DepthMap::kBackground);
    }
  }
  return map;
}

}  // namespace

Image DrawPicture(const std::vector<PicturePanel>& panels,
                  const View& view,
                  const PictureOptions& options) {
  CHECK(!panels.empty());
  CHECK_GE(options.oversampling, 1);
  const TextLayout layout = LayOutTexts(panels, options);
  const int panel_height =
      options.height - layout.caption_height - layout.legend_height;
  const double panel_width = static_cast<double>(options.width) / panels.size();
  CHECK_GE(panel_height, kLeastPanelSize);
  CHECK_GE(panel_width, kLeastPanelSize);
  const double text_fraction =
      1 - static_cast<double>(panel_height) / options.height;
  const CameraFit fit = FitCamera(panels, view, panel_width / panel_height);
  OffscreenWindow offscreen;
  vtkRenderWindow* window = offscreen.get();
  window->SetSize(options.width * options.oversampling,
                  options.height * options.oversampling);
  // Smooth edges come from oversampling, which the depth cues share.
  window->SetMultiSamples(0);
  AddPanels(panels, view, fit, text_fraction, options.feature_angle, window);
  Image image = RenderPixels(window);
  const DepthMap depth = ReadDepth(window, fit);
  if (options.folds) DarkenFolds(depth, &image);
  if (options.outlines) DrawOutlines(depth, options.oversampling, &image);
  // The texts come last, so that the depth cues leave them alone.
  window->GetRenderers()->RemoveAllItems();
  const vtkSmartPointer<vtkRenderer> texts = WhiteRenderer();
  AddTexts(panels, options, texts);
  window->AddRenderer(texts);
  Multiply(RenderPixels(window), &image);
  return Downsample(image, options.oversampling);
}

}  // namespace musclewarp
