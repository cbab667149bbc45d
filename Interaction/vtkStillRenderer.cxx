// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStillRenderer.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProp.h>
#include <vtkPropCollection.h>
#include <vtkTextureObject.h>

#include <algorithm>

vtkStandardNewMacro(vtkStillRenderer);

namespace
{
// As OpenGL has them: its headers come with VTK under a name that depends on the version.
constexpr unsigned int colorAndDepth = 0x4000 | 0x100;
constexpr unsigned int nearest = 0x2600;

/// What depth is kept as; 0 where it is not known.
unsigned int depthFormat(vtkOpenGLFramebufferObject* buffer)
{
  vtkTextureObject* const depth = buffer->GetDepthAttachmentAsTextureObject();
  return depth ? depth->GetInternalFormat(VTK_FLOAT, 1, false) : 0;
}

/// Gives a buffer the size, and the depth of a window's, without which nothing can be copied.
bool prepare(
  vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* buffer, const std::array<int, 2>& size)
{
  const unsigned int wanted = depthFormat(window->GetRenderFramebuffer());
  vtkOpenGLState* const state = window->GetState();
  state->PushFramebufferBindings();
  bool alike = false;
  for (const int bits : { 32, 24 })
  {
    buffer->ReleaseGraphicsResources(window);
    buffer->SetContext(window);
    alike =
      buffer->PopulateFramebuffer(size[0], size[1], true, 1, VTK_UNSIGNED_CHAR, true, bits, 0) &&
      wanted != 0 && depthFormat(buffer) == wanted;
    if (alike)
    {
      break;
    }
  }
  state->PopFramebufferBindings();
  return alike;
}

void copy(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* from,
  vtkOpenGLFramebufferObject* to, const std::array<int, 2>& size)
{
  vtkOpenGLState* const state = window->GetState();
  state->PushFramebufferBindings();
  from->Bind(vtkOpenGLFramebufferObject::GetReadMode());
  from->ActivateReadBuffer(0);
  to->Bind(vtkOpenGLFramebufferObject::GetDrawMode());
  to->ActivateDrawBuffer(0);
  const int all[4] = { 0, size[0], 0, size[1] };
  vtkOpenGLFramebufferObject::Blit(all, all, colorAndDepth, nearest);
  state->PopFramebufferBindings();
}
}

//------------------------------------------------------------------------------
vtkStillRenderer::vtkStillRenderer() = default;

//------------------------------------------------------------------------------
void vtkStillRenderer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfDrawings: " << this->NumberOfDrawings << "\n";
}

//------------------------------------------------------------------------------
vtkStillRenderer::~vtkStillRenderer() = default;

//------------------------------------------------------------------------------
vtkStillRenderer::Frame vtkStillRenderer::FrameOf(vtkWindow* window)
{
  Frame frame;
  std::copy_n(window->GetSize(), 2, frame.size.begin());
  std::copy_n(this->GetViewport(), 4, frame.viewport.begin());
  std::copy_n(this->GetBackground(), 3, frame.background.begin());
  return frame;
}

//------------------------------------------------------------------------------
bool vtkStillRenderer::HasChanged()
{
  vtkPropCollection* const props = this->GetViewProps();
  // Not the renderer's own time, which a pick of a place in the window changes.
  vtkMTimeType latest = std::max(props->GetMTime(), this->GetActiveCamera()->GetMTime());
  vtkCollectionSimpleIterator at;
  props->InitTraversal(at);
  while (vtkProp* const prop = props->GetNextProp(at))
  {
    latest = std::max({ latest, prop->GetMTime(), prop->GetRedrawMTime() });
  }
  vtkLightCollection* const lights = this->GetLights();
  latest = std::max(latest, lights->GetMTime());
  lights->InitTraversal(at);
  while (vtkLight* const light = lights->GetNextLight(at))
  {
    latest = std::max(latest, light->GetMTime());
  }
  return latest > this->PictureTime.GetMTime();
}

//------------------------------------------------------------------------------
void vtkStillRenderer::DeviceRender()
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(this->GetRenderWindow());
  if (this->Selector || !window || window->GetMultiSamples() > 1)
  {
    this->Superclass::DeviceRender();
    ++this->NumberOfDrawings;
    return;
  }
  const Frame frame = this->FrameOf(window);
  if (!this->HasPicture || !(frame == this->PictureFrame) || this->HasChanged())
  {
    this->Superclass::DeviceRender();
    ++this->NumberOfDrawings;
    this->Keep(window, frame);
  }
  else
  {
    copy(window, this->Picture, window->GetRenderFramebuffer(), frame.size);
  }
}

//------------------------------------------------------------------------------
void vtkStillRenderer::Keep(vtkOpenGLRenderWindow* window, const Frame& frame)
{
  const std::array<int, 2>& size = frame.size;
  if (size != this->PictureFrame.size)
  {
    this->HasPicture = prepare(window, this->Picture, size);
  }
  this->PictureFrame = frame;
  if (this->HasPicture)
  {
    copy(window, window->GetRenderFramebuffer(), this->Picture, size);
    this->PictureTime.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkStillRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Picture->ReleaseGraphicsResources(window);
  this->HasPicture = false;
  this->PictureFrame = {};
  this->Superclass::ReleaseGraphicsResources(window);
}
