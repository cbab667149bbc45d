// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PdfSurface.h"

#include <cairo-pdf.h>

#include <exception>
#include <new>

namespace flattening
{
namespace pattern
{
namespace
{
/// Nothing is thrown through cairo, which is C.
cairo_status_t append(void* closure, const unsigned char* data, unsigned int length)
{
  try
  {
    static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  }
  catch (const std::exception&)
  {
    return CAIRO_STATUS_NO_MEMORY;
  }
  return CAIRO_STATUS_SUCCESS;
}
}

_cairo_surface* openPdf(const Pattern& pattern, const PagePlan& plan, std::string& pdf)
{
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(
    &append, &pdf, pointsPerMillimetre * plan.paper.x(), pointsPerMillimetre * plan.paper.y());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, pattern.name.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "SurfaceFlattening");
  if (!pattern.date.empty())
  {
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
      (pattern.date + "T" + pattern.time + ":00Z").c_str());
  }
  return surface;
}

Status closePdf(_cairo_surface* surface, _cairo* context)
{
  cairo_surface_finish(surface);
  cairo_status_t status = cairo_status(context);
  status = status == CAIRO_STATUS_SUCCESS ? cairo_surface_status(surface) : status;
  if (status == CAIRO_STATUS_NO_MEMORY)
  {
    throw std::bad_alloc(); // as where a container finds none
  }
  if (status != CAIRO_STATUS_SUCCESS)
  {
    return { StatusCode::InvalidPattern,
      std::string("the PDF cannot be drawn: ") + cairo_status_to_string(status), {},
      { Remedy::WriteOtherFormat } };
  }
  return {};
}
}
}
