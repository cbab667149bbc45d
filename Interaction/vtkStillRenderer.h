// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkStillRenderer
 * @brief a renderer that draws its scene once, and again when something in it has changed
 *
 * In between it puts back the picture it drew, with its depth. What moves is drawn by a renderer of
 * another layer of the window, over the same camera and with PreserveDepthBuffer on; what lies
 * behind the still scene stays hidden. So a curve can be dragged over a surface of any size at the
 * price of the curve.
 *
 * Changes are those of camera, lights, props and what they show, background, viewport and size. The
 * scene is drawn each time where a window has multisamples, or depth in a form that cannot be kept.
 *
 * @code
 * vtkNew<vtkStillRenderer> scene; // in layer 0 of a window with two layers
 * vtkNew<vtkRenderer> moving;
 * moving->SetLayer(1);
 * moving->PreserveDepthBufferOn();
 * moving->SetActiveCamera(scene->GetActiveCamera());
 * @endcode
 *
 * @warning What a prop shows by other means than its mapper's input and properties is not noticed:
 * call Modified() of the prop.
 *
 * @sa vtkFeatureCurveWidget
 */
#ifndef vtkStillRenderer_h
#define vtkStillRenderer_h

#include "vtkInteractionFlatteningModule.h" // for the export macro
#include "vtkNew.h"                         // for the picture
#include "vtkOpenGLRenderer.h"
#include "vtkTimeStamp.h" // for the picture

#include <array> // for the frame

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;

class VTKINTERACTIONFLATTENING_EXPORT vtkStillRenderer : public vtkOpenGLRenderer
{
public:
  static vtkStillRenderer* New();
  vtkTypeMacro(vtkStillRenderer, vtkOpenGLRenderer)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void DeviceRender() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * How often the scene was drawn, and not put back.
   */
  int GetNumberOfDrawings() const { return this->NumberOfDrawings; }

protected:
  vtkStillRenderer();
  ~vtkStillRenderer() override;

private:
  vtkStillRenderer(const vtkStillRenderer&) = delete;
  void operator=(const vtkStillRenderer&) = delete;

  struct Frame
  {
    std::array<int, 2> size{};
    std::array<double, 4> viewport{};
    std::array<double, 3> background{};
    bool operator==(const Frame& other) const
    {
      return this->size == other.size && this->viewport == other.viewport &&
        this->background == other.background;
    }
  };
  Frame FrameOf(vtkWindow* window);
  bool HasChanged();
  void Keep(vtkOpenGLRenderWindow* window, const Frame& frame);

  vtkNew<vtkOpenGLFramebufferObject> Picture;
  Frame PictureFrame;
  vtkTimeStamp PictureTime;
  bool HasPicture = false;
  int NumberOfDrawings = 0;
};

#endif
