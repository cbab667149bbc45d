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
}

bool hasPdfLayers()
{
  return true;
}

Status joinPdfLayers(const std::vector<PdfLayer>& layers, std::size_t pages, std::string& pdf)
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
