// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PatternWriters.h"

#include "Drawing/PatternStrokes.h"
#include "Formats/PageDrawing.h"
#include "Outlines/Pattern.h"

#include <algorithm>
#include <array>
#include <cairo-pdf.h>
#include <exception>
#include <fribidi.h>
#include <memory>
#include <new>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
#include <qpdf/QPDFWriter.hh>
#include <set>
#include <string>
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

/// What a layer of a PDF shows, as a PDF of its own.
struct PdfLayer
{
  std::string name; ///< UTF-8
  std::string pdf;
};

using Pages = std::vector<QPDFPageObjectHelper>;

/// Lays what a page of each layer shows on the page of the lowest one.
void joinPage(
  QPDF& base, std::size_t page, std::vector<Pages>& pagesOf, std::vector<QPDFObjectHandle>& groups)
{
  QPDFPageObjectHelper& lowest = pagesOf[0].at(page);
  QPDFObjectHandle resources = lowest.getAttribute("/Resources", true);
  QPDFObjectHandle forms = QPDFObjectHandle::newDictionary();
  QPDFObjectHandle named = QPDFObjectHandle::newDictionary();
  std::string others = "\nQ\nEMC\n";
  for (std::size_t k = 0; k < groups.size(); ++k)
  {
    const std::string name = "/Layer" + std::to_string(k);
    named.replaceKey(name, groups[k]);
    if (k > 0)
    {
      QPDFObjectHandle form = pagesOf[k].at(page).getFormXObjectForPage();
      form.getDict().removeKey("/Group"); // nothing in it is transparent
      forms.replaceKey(name, base.copyForeignObject(form));
      others.append("/OC ").append(name).append(" BDC\nq\n").append(name);
      others += " Do\nQ\nEMC\n";
    }
  }
  resources.replaceKey("/XObject", forms);
  resources.replaceKey("/Properties", named);
  lowest.addPageContents(QPDFObjectHandle::newStream(&base, "/OC /Layer0 BDC\nq\n"), true);
  lowest.addPageContents(QPDFObjectHandle::newStream(&base, others), false);
}

/// Optional content after ISO 32000-1, 8.11: a group a layer, whose marked content is hidden with
/// it.
std::string layered(const std::vector<PdfLayer>& layers, std::size_t pages)
{
  std::vector<std::unique_ptr<QPDF>> files; // stay open until the first one is written
  std::vector<Pages> pagesOf;
  std::vector<QPDFObjectHandle> groups;
  for (const PdfLayer& layer : layers)
  {
    QPDF& file = *files.emplace_back(std::make_unique<QPDF>());
    file.setSuppressWarnings(true);
    file.processMemoryFile(layer.name.c_str(), layer.pdf.data(), layer.pdf.size());
    pagesOf.push_back(QPDFPageDocumentHelper(file).getAllPages());
    QPDFObjectHandle group = QPDFObjectHandle::newDictionary();
    group.replaceKey("/Type", QPDFObjectHandle::newName("/OCG"));
    group.replaceKey("/Name", QPDFObjectHandle::newUnicodeString(layer.name));
    groups.push_back(files.front()->makeIndirectObject(group));
  }
  QPDF& base = *files.front();
  QPDFObjectHandle order = QPDFObjectHandle::newArray(groups);
  QPDFObjectHandle usual = QPDFObjectHandle::newDictionary();
  usual.replaceKey("/Order", order);
  usual.replaceKey("/ON", order);
  QPDFObjectHandle properties = QPDFObjectHandle::newDictionary();
  properties.replaceKey("/OCGs", order);
  properties.replaceKey("/D", usual);
  base.getRoot().replaceKey("/OCProperties", properties);
  for (std::size_t page = 0; page < pages; ++page)
  {
    joinPage(base, page, pagesOf, groups);
  }
  QPDFWriter writer(base);
  writer.setOutputMemory();
  writer.setMinimumPDFVersion("1.5");
  writer.setDeterministicID(true);
  writer.write();
  const std::shared_ptr<Buffer> buffer = writer.getBufferSharedPointer();
  return { reinterpret_cast<const char*>(buffer->getBuffer()), buffer->getSize() };
}

/// Lays drawings of the same pages on each other, each as a layer that can be hidden, the lowest
/// first.
Status joinLayers(const std::vector<PdfLayer>& layers, std::size_t pages, std::string& pdf)
{
  try
  {
    pdf = layered(layers, pages);
    return {};
  }
  catch (const std::bad_alloc&)
  {
    throw; // as where a container finds none
  }
  catch (const std::exception& error)
  {
    return { StatusCode::InvalidPattern,
      std::string("the layers of the PDF cannot be joined: ") + error.what(), {},
      { Remedy::WriteOtherFormat } };
  }
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
  std::vector<PdfLayer> layers;
  const auto add = [&](const std::string& name, const PageSelection& selection) {
    if (status.ok())
    {
      layers.push_back({ name, {} });
      status = drawPdf(pattern, options.paper, plan, selection, layers.back().pdf);
    }
  };
  add("page marks", { true, false, {} });
  for (const LineKind role : rolesOf(pattern))
  {
    add(nameOf(role), { false, false, { role } });
  }
  add("text", { false, true, {} });
  return status.ok() ? joinLayers(layers, plan.pages.size(), pdf) : status;
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
