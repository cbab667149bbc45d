// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PdfLayers.h"

#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include <exception>
#include <memory>
#include <new>

namespace flattening::pattern
{
namespace
{
using Pages = std::vector<QPDFPageObjectHelper>;

/// Optional content after ISO 32000-1, 8.11: a group a layer, whose marked content is hidden with
/// it.
class LayeredPdf
{
public:
  explicit LayeredPdf(const std::vector<PdfLayer>& layers)
  {
    for (const PdfLayer& layer : layers)
    {
      this->Files.push_back(std::make_unique<QPDF>());
      this->Files.back()->setSuppressWarnings(true);
      this->Files.back()->processMemoryFile(layer.name.c_str(), layer.pdf.data(), layer.pdf.size());
      this->PagesOf.push_back(QPDFPageDocumentHelper(*this->Files.back()).getAllPages());
      QPDFObjectHandle group = QPDFObjectHandle::newDictionary();
      group.replaceKey("/Type", QPDFObjectHandle::newName("/OCG"));
      group.replaceKey("/Name", QPDFObjectHandle::newUnicodeString(layer.name));
      this->Groups.push_back(this->base().makeIndirectObject(group));
    }
    QPDFObjectHandle order = QPDFObjectHandle::newArray(this->Groups);
    QPDFObjectHandle usual = QPDFObjectHandle::newDictionary();
    usual.replaceKey("/Order", order);
    usual.replaceKey("/ON", order);
    QPDFObjectHandle properties = QPDFObjectHandle::newDictionary();
    properties.replaceKey("/OCGs", order);
    properties.replaceKey("/D", usual);
    this->base().getRoot().replaceKey("/OCProperties", properties);
  }

  void join(std::size_t page)
  {
    QPDFPageObjectHelper& lowest = this->PagesOf[0].at(page);
    QPDFObjectHandle resources = lowest.getAttribute("/Resources", true);
    QPDFObjectHandle forms = QPDFObjectHandle::newDictionary();
    QPDFObjectHandle groups = QPDFObjectHandle::newDictionary();
    std::string others = "\nQ\nEMC\n";
    for (std::size_t k = 0; k < this->Files.size(); ++k)
    {
      const std::string name = "/Layer" + std::to_string(k);
      groups.replaceKey(name, this->Groups[k]);
      if (k > 0)
      {
        QPDFObjectHandle form = this->PagesOf[k].at(page).getFormXObjectForPage();
        form.getDict().removeKey("/Group"); // nothing in it is transparent
        forms.replaceKey(name, this->base().copyForeignObject(form));
        others.append("/OC ").append(name).append(" BDC\nq\n").append(name);
        others += " Do\nQ\nEMC\n";
      }
    }
    resources.replaceKey("/XObject", forms);
    resources.replaceKey("/Properties", groups);
    this->addContents(lowest, "/OC /Layer0 BDC\nq\n", true);
    this->addContents(lowest, others, false);
  }

  std::string write()
  {
    QPDFWriter writer(this->base());
    writer.setOutputMemory();
    writer.setMinimumPDFVersion("1.5");
    writer.setDeterministicID(true);
    writer.write();
    const std::shared_ptr<Buffer> buffer = writer.getBufferSharedPointer();
    return { reinterpret_cast<const char*>(buffer->getBuffer()), buffer->getSize() };
  }

private:
  QPDF& base() { return *this->Files.front(); }

  void addContents(QPDFPageObjectHelper& page, const std::string& contents, bool first)
  {
    page.addPageContents(QPDFObjectHandle::newStream(&this->base(), contents), first);
  }

  std::vector<std::unique_ptr<QPDF>> Files; ///< stay open until the first one is written
  std::vector<Pages> PagesOf;
  std::vector<QPDFObjectHandle> Groups;
};
}

bool hasPdfLayers()
{
  return true;
}

Status joinPdfLayers(const std::vector<PdfLayer>& layers, std::size_t pages, std::string& pdf)
{
  try
  {
    LayeredPdf file(layers);
    for (std::size_t page = 0; page < pages; ++page)
    {
      file.join(page);
    }
    pdf = file.write();
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
