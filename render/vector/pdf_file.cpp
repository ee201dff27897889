// SPDX-License-Identifier: MIT
#include "render/vector/pdf_file.h"

#include <qpdf/Pipeline.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
#include <qpdf/QPDFWriter.hh>

namespace polhode {

namespace {

using Handle = QPDFObjectHandle;

/// Where qpdf writes.
class SinkPipeline final : public Pipeline {
 public:
  explicit SinkPipeline(const PdfSink& sink) : Pipeline("deck", nullptr), sink_(sink) {}
  void write(const unsigned char* data, std::size_t count) override { sink_(data, count); }
  void finish() override {}

 private:
  const PdfSink& sink_;
};

/// A handle is a pointer: what is changed through a copy is changed.
Handle copy_of(const PdfObject& object) { return object.handle(); }

}  // namespace

PdfObject::PdfObject() : PdfObject(Handle::newNull()) {}
PdfObject::PdfObject(const Handle& handle) : handle_(std::make_shared<Handle>(handle)) {}

PdfObject PdfObject::name(const std::string& slash_name) { return PdfObject(Handle::newName(slash_name)); }
PdfObject PdfObject::integer(int value) { return PdfObject(Handle::newInteger(value)); }
PdfObject PdfObject::real(double value, int decimals) { return PdfObject(Handle::newReal(value, decimals)); }
PdfObject PdfObject::bytes(const std::string& value) { return PdfObject(Handle::newString(value)); }
PdfObject PdfObject::text(const std::string& utf8) { return PdfObject(Handle::newUnicodeString(utf8)); }
PdfObject PdfObject::parse(const std::string& pdf_text) { return PdfObject(Handle::parse(pdf_text)); }

PdfObject PdfObject::array(const std::vector<PdfObject>& items) {
  PdfObject made(Handle::newArray());
  for (const PdfObject& item : items) made.append(item);
  return made;
}

void PdfObject::set(const std::string& slash_key, const PdfObject& value) {
  handle_->replaceKey(slash_key, value.handle());
}
PdfObject PdfObject::get(const std::string& slash_key) const {
  return PdfObject(copy_of(*this).getKey(slash_key));
}
void PdfObject::append(const PdfObject& item) { handle_->appendItem(item.handle()); }
int PdfObject::size() const { return copy_of(*this).getArrayNItems(); }
PdfObject PdfObject::dictionary() const { return PdfObject(copy_of(*this).getDict()); }

PdfFile::PdfFile() : pdf_(std::make_unique<QPDF>()) { pdf_->emptyPDF(); }
PdfFile::~PdfFile() = default;

PdfObject PdfFile::root() const { return PdfObject(pdf_->getRoot()); }
PdfObject PdfFile::trailer() const { return PdfObject(pdf_->getTrailer()); }
PdfObject PdfFile::numbered(const PdfObject& object) {
  return PdfObject(pdf_->makeIndirectObject(object.handle()));
}
PdfObject PdfFile::stream(const std::string& data) { return PdfObject(Handle::newStream(pdf_.get(), data)); }

PdfObject PdfFile::stream(const std::function<void(const PdfSink&)>& write, const PdfObject& filter,
                          const PdfObject& parameters) {
  Handle made = Handle::newStream(pdf_.get());
  made.replaceStreamData(
      [write](Pipeline* out) {
        write([out](const unsigned char* data, std::size_t count) { out->write(data, count); });
        out->finish();
      },
      filter.handle(), parameters.handle());
  return PdfObject(made);
}

void PdfFile::add_page(const PdfObject& page) {
  QPDFPageDocumentHelper(*pdf_).addPage(QPDFPageObjectHelper(copy_of(page)), false);
}

void PdfFile::write(const PdfSink& out) {
  SinkPipeline pipeline(out);
  QPDFWriter writer(*pdf_);
  writer.setOutputPipeline(&pipeline);
  writer.setDeterministicID(true);
  writer.setCompressStreams(true);
  writer.setDecodeLevel(qpdf_dl_none);
  writer.setObjectStreamMode(qpdf_o_generate);
  writer.write();
}

}  // namespace polhode
