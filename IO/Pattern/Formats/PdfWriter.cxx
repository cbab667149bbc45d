// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PdfWriter.h"

#include "Drawing/PatternStrokes.h"
#include "Formats/PageDrawing.h"
#include "Formats/PdfLayers.h"
#include "Outlines/Pattern.h"

#include <algorithm>
#include <array>
#include <cairo-pdf.h>
#include <exception>
#include <fribidi.h>
#include <new>
#include <set>
#include <vector>

namespace flattening::pattern
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

class CairoCanvas final : public PageCanvas
{
public:
  /// \param pdf gets the file's bytes until it is closed
  CairoCanvas(const Pattern& pattern, const PagePlan& plan, std::string& pdf)
    : Surface(cairo_pdf_surface_create_for_stream(
        &append, &pdf, pointsPerMillimetre * plan.paper.x(), pointsPerMillimetre * plan.paper.y()))
    , Context(cairo_create(this->Surface))
  {
    cairo_pdf_surface_set_metadata(this->Surface, CAIRO_PDF_METADATA_TITLE, pattern.name.c_str());
    cairo_pdf_surface_set_metadata(this->Surface, CAIRO_PDF_METADATA_CREATOR, "SurfaceFlattening");
    if (!pattern.date.empty())
    {
      cairo_pdf_surface_set_metadata(this->Surface, CAIRO_PDF_METADATA_CREATE_DATE,
        (pattern.date + "T" + pattern.time + ":00Z").c_str());
    }
    cairo_select_font_face(
      this->Context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  }
  ~CairoCanvas() override
  {
    cairo_destroy(this->Context);
    cairo_surface_destroy(this->Surface);
  }
  CairoCanvas(const CairoCanvas&) = delete;
  CairoCanvas& operator=(const CairoCanvas&) = delete;

  /// Writes what is left. \return InvalidPattern where something went wrong
  Status close()
  {
    cairo_surface_finish(this->Surface);
    cairo_status_t status = cairo_status(this->Context);
    status = status == CAIRO_STATUS_SUCCESS ? cairo_surface_status(this->Surface) : status;
    if (status == CAIRO_STATUS_NO_MEMORY)
    {
      throw std::bad_alloc(); // as where a container finds none
    }
    return status == CAIRO_STATUS_SUCCESS
      ? Status()
      : Status{ StatusCode::InvalidPattern,
          std::string("the PDF cannot be drawn: ") + cairo_status_to_string(status), {},
          { Remedy::WriteOtherFormat } };
  }

  void beginPage(const Point2& paper) override
  {
    cairo_pdf_surface_set_size(
      this->Surface, pointsPerMillimetre * paper.x(), pointsPerMillimetre * paper.y());
    cairo_identity_matrix(this->Context);
    cairo_scale(this->Context, pointsPerMillimetre, pointsPerMillimetre);
  }
  void endPage() override { cairo_show_page(this->Context); }
  void save() override { cairo_save(this->Context); }
  void restore() override { cairo_restore(this->Context); }
  void translate(const Point2& by) override { cairo_translate(this->Context, by.x(), by.y()); }
  void scale(double factor) override { cairo_scale(this->Context, factor, factor); }
  void clip(const Point2& corner, const Point2& extent) override
  {
    this->rectangle(corner, extent);
    cairo_clip(this->Context);
  }
  void pen(const Color& color, double width, const std::array<double, 4>& dashes) override
  {
    const auto* const end =
      std::find_if(dashes.begin(), dashes.end(), [](double dash) { return !(dash > 0.0); });
    cairo_set_source_rgb(this->Context, color[0], color[1], color[2]);
    cairo_set_line_width(this->Context, width);
    cairo_set_dash(this->Context, dashes.data(), static_cast<int>(end - dashes.begin()), 0.0);
  }
  void moveTo(const Point2& to) override { cairo_move_to(this->Context, to.x(), to.y()); }
  void lineTo(const Point2& to) override { cairo_line_to(this->Context, to.x(), to.y()); }
  void curveTo(const Point2& one, const Point2& two, const Point2& to) override
  {
    cairo_curve_to(this->Context, one.x(), one.y(), two.x(), two.y(), to.x(), to.y());
  }
  void rectangle(const Point2& corner, const Point2& extent) override
  {
    cairo_rectangle(this->Context, corner.x(), corner.y(), extent.x(), extent.y());
  }
  void closePath() override { cairo_close_path(this->Context); }
  void stroke(bool filled) override
  {
    if (filled)
    {
      cairo_fill_preserve(this->Context);
    }
    cairo_stroke(this->Context);
  }
  void text(
    const std::string& words, const Point2& at, double height, Anchor anchor, double angle) override
  {
    // cairo draws nothing more after broken UTF-8, and one character after the other.
    const std::string content = visualOrder(words);
    cairo_set_font_size(this->Context, height);
    cairo_text_extents_t extents;
    cairo_text_extents(this->Context, content.c_str(), &extents);
    const double back = anchor == Anchor::Start ? 0.0
      : anchor == Anchor::Middle                ? extents.x_advance / 2.0
                                                : extents.x_advance;
    cairo_save(this->Context);
    cairo_translate(this->Context, at.x(), at.y());
    cairo_rotate(this->Context, -angle);
    cairo_move_to(this->Context, -back, 0.35 * height);
    cairo_show_text(this->Context, content.c_str());
    cairo_restore(this->Context);
  }

private:
  cairo_surface_t* Surface;
  cairo_t* Context;
};

/// Draws pages by cairo. \param pdf the file's bytes
Status drawPdf(const Pattern& pattern, PaperSize paper, const PagePlan& plan,
  const PageSelection& selection, std::string& pdf)
{
  CairoCanvas canvas(pattern, plan, pdf);
  drawPages(pattern, paper, plan, selection, canvas);
  return canvas.close();
}

/// The name of a role's layer, which is that of SVG.
std::string nameOf(LineKind role)
{
  std::string name = styleOf(role).name;
  std::replace(name.begin(), name.end(), '-', ' ');
  return name;
}
}

Status makePdf(const Pattern& drawing, const PageOptions& options, std::string& pdf)
{
  pdf.clear();
  PagePlan plan;
  Status status = planPages(drawing, options, plan);
  if (!status.ok())
  {
    return status;
  }
  Pattern pattern = drawing;
  keepTextsOnPages(plan, pattern);
  const std::set<LineKind> roles = rolesOf(pattern);
  if (!hasPdfLayers())
  {
    return drawPdf(pattern, options.paper, plan, { true, true, roles }, pdf);
  }
  std::vector<PdfLayer> layers;
  const auto add = [&](const std::string& name, const PageSelection& selection) {
    if (status.ok())
    {
      layers.push_back({ name, {} });
      status = drawPdf(pattern, options.paper, plan, selection, layers.back().pdf);
    }
  };
  add("page marks", { true, false, {} });
  for (const LineKind role : roles)
  {
    add(nameOf(role), { false, false, { role } });
  }
  add("text", { false, true, {} });
  return status.ok() ? joinPdfLayers(layers, plan.pages.size(), pdf) : status;
}

std::string visualOrder(const std::string& text)
{
  constexpr std::size_t bytesOfACharacter = 4;
  std::vector<FriBidiChar> line(text.size() + 1);
  line.resize(static_cast<std::size_t>(fribidi_charset_to_unicode(
    FRIBIDI_CHAR_SET_UTF8, text.c_str(), static_cast<FriBidiStrIndex>(text.size()), line.data())));
  const auto length = static_cast<FriBidiStrIndex>(line.size());
  std::vector<FriBidiCharType> types(line.size());
  fribidi_get_bidi_types(line.data(), length, types.data());
  if (std::none_of(types.begin(), types.end(),
        [](FriBidiCharType type) { return FRIBIDI_IS_LETTER(type) && FRIBIDI_IS_RTL(type); }))
  {
    return text;
  }
  const bool fromLeft = std::find(types.begin(), types.end(), FRIBIDI_TYPE_LTR) != types.end();
  FriBidiParType direction = fromLeft ? FRIBIDI_PAR_LTR : FRIBIDI_PAR_RTL;
  std::vector<FriBidiChar> drawn(line.size() + 1); // as it ends with a zero
  if (fribidi_log2vis(line.data(), length, &direction, drawn.data(), nullptr, nullptr, nullptr) ==
    0)
  {
    throw std::bad_alloc(); // its only error
  }
  const FriBidiStrIndex left =
    fribidi_remove_bidi_marks(drawn.data(), length, nullptr, nullptr, nullptr);
  std::string result(bytesOfACharacter * static_cast<std::size_t>(length) + 1, '\0');
  result.resize(static_cast<std::size_t>(
    fribidi_unicode_to_charset(FRIBIDI_CHAR_SET_UTF8, drawn.data(), left, result.data())));
  return result;
}
}
