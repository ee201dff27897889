// SPDX-License-Identifier: MIT
// A PDF and its objects, as qpdf keeps them: a thin layer, so that one file of ours includes qpdf's headers.
// Clang before version 16 reads those with GCC's library as C++17 alone (in C++20 it asks for the destructor
// of a vector of JSON inside of class JSON, which is not complete there): the file is compiled as that, and
// this header is C++17.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class QPDF;
class QPDFObjectHandle;

namespace polhode {

/// Where bytes go.
using PdfSink = std::function<void(const unsigned char* data, std::size_t count)>;

/// A name, a number, a string, an array, a dictionary, a stream, or one of these under a number of its own;
/// copies are the same object. What goes wrong in qpdf is thrown as its std::exception.
class PdfObject {
 public:
  PdfObject();  ///< null
  explicit PdfObject(const QPDFObjectHandle& handle);

  static PdfObject name(const std::string& slash_name);
  static PdfObject integer(int value);
  static PdfObject real(double value, int decimals);
  static PdfObject bytes(const std::string& value);
  static PdfObject text(const std::string& utf8);
  static PdfObject array(const std::vector<PdfObject>& items = {});
  /// "<< /Type /Page >>", without references to other objects.
  static PdfObject parse(const std::string& pdf_text);

  /// Of a dictionary.
  void set(const std::string& slash_key, const PdfObject& value);
  PdfObject get(const std::string& slash_key) const;
  /// Of an array.
  void append(const PdfObject& item);
  int size() const;
  /// Of a stream.
  PdfObject dictionary() const;

  const QPDFObjectHandle& handle() const { return *handle_; }

 private:
  std::shared_ptr<QPDFObjectHandle> handle_;
};

class PdfFile {
 public:
  PdfFile();
  ~PdfFile();
  PdfFile(const PdfFile&) = delete;
  PdfFile& operator=(const PdfFile&) = delete;

  PdfObject root() const;
  PdfObject trailer() const;
  /// The object under a number: dictionaries that hold it refer to it.
  PdfObject numbered(const PdfObject& object);
  PdfObject stream(const std::string& data);
  /// Its bytes are asked for when the file is written; `filter` and `parameters` say how they are packed.
  PdfObject stream(const std::function<void(const PdfSink&)>& write, const PdfObject& filter,
                   const PdfObject& parameters);
  /// After those that are there.
  void add_page(const PdfObject& page);

  /// The same bytes for the same objects.
  void write(const PdfSink& out);

 private:
  std::unique_ptr<QPDF> pdf_;
};

}  // namespace polhode
